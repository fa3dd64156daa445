//! A chart on the host that follows the one on the controller.

use super::decode::{Decoder, Frame};
use super::hash;
use crate::Ticks;
use crate::record::chart::Recordable;
use crate::record::decode::{Damage, Happened, Key};
use crate::record::replay::{Moment, Replay, ReplayError};

/// Runs a chart as the controller does whose frames come over a wire, and shows each cycle that is sent.
///
/// After all that is [`Trouble`] nothing is shown until the next state that the controller tells.
pub struct Follow<C: Recordable, B> {
    decoder: Decoder<B>,
    /// The chart, as long as it is known to be what it is on the controller.
    replay: Option<Replay<C>>,
}

/// What is seen of a controller.
pub enum Seen<'m, C: Recordable> {
    /// A cycle, or several in which the same happened.
    Cycle(Moment<'m, C>),
    /// The controller has started.
    Begins,
    /// What is seen has a gap here.
    Trouble(Trouble),
}

/// Why something is not seen.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trouble {
    /// A frame was damaged.
    Damaged,
    /// Frames are missing.
    Lost {
        /// How many, up to 65,535.
        frames: u16,
    },
    /// The controller runs another chart, or another version of it; or a frame is whole, but means nothing.
    Damage(Damage),
    /// The chart on the controller is in another state than this one after so many cycles: a function that a condition calls is not pure, or
    /// something changed the chart past the recorder.
    Diverged {
        /// How many cycles there were.
        cycle: u32,
    },
}

impl<C: Recordable, B: AsRef<[u8]> + AsMut<[u8]>> Follow<C, B> {
    /// With a buffer of [`frame_len`](super::frame_len) bytes.
    pub const fn new(buffer: B) -> Self {
        Self { decoder: Decoder::new(buffer), replay: None }
    }

    /// Takes what came over the wire, as much as has come, and shows what it tells. Code actions go to `actions`, which should do nothing.
    pub fn bytes(&mut self, bytes: &[u8], actions: &mut C::Actions<'_>, mut each: impl FnMut(Seen<'_, C>)) {
        for byte in bytes {
            self.byte(*byte, actions, &mut each);
        }
    }

    fn byte(&mut self, byte: u8, actions: &mut C::Actions<'_>, each: &mut impl FnMut(Seen<'_, C>)) {
        let Some(received) = self.decoder.byte(byte) else { return };
        let Ok(received) = received else {
            self.replay = None;
            return each(Seen::Trouble(Trouble::Damaged));
        };
        if received.begins {
            self.replay = None;
            each(Seen::Begins);
        }
        if received.lost > 0 {
            self.replay = None;
            each(Seen::Trouble(Trouble::Lost { frames: received.lost }));
        }
        let expected = match received.frame {
            Some(Frame::State { fingerprint, layout, key, .. }) => {
                let before = self.replay.take();
                match state(before, &key, (fingerprint, layout), actions, each) {
                    Ok(replay) => self.replay = Some(replay),
                    Err(trouble) => {
                        each(Seen::Trouble(trouble));
                        // The state that the controller tells is what it is, whatever was shown before.
                        self.replay = if matches!(trouble, Trouble::Diverged { .. }) { Replay::at(&key) } else { None };
                    }
                }
                return;
            }
            Some(Frame::Cycle(entry)) => {
                let Some(replay) = &mut self.replay else { return };
                let Happened::Cycle { elapsed, change } = entry.what else { return };
                if replay
                    .step(entry.skipped, Ticks::new(elapsed), change, actions, &mut |moment| each(Seen::Cycle(moment)))
                    .is_none()
                {
                    self.replay = None;
                    each(Seen::Trouble(Trouble::Damage(Damage::Nonsense)));
                }
                return;
            }
            Some(Frame::Hash(expected)) => expected,
            // Who steers reads the answers by a `Decoder`.
            Some(Frame::Answer(_)) | None => return,
        };
        let Some(replay) = &self.replay else { return };
        let (cycle, chart) = replay.shown();
        if hash(chart, self.decoder.scratch()) != Some(expected) {
            self.replay = None;
            each(Seen::Trouble(Trouble::Diverged { cycle }));
        }
    }
}

fn state<C: Recordable>(
    before: Option<Replay<C>>,
    key: &Key<'_>,
    (fingerprint, layout): (u32, u32),
    actions: &mut C::Actions<'_>,
    each: &mut impl FnMut(Seen<'_, C>),
) -> Result<Replay<C>, Trouble> {
    if fingerprint != C::FINGERPRINT {
        return Err(Trouble::Damage(Damage::OtherChart { fingerprint }));
    }
    if layout != C::LAYOUT {
        return Err(Trouble::Damage(Damage::OtherLayout));
    }
    Replay::go_on(before, key, actions, &mut |moment| each(Seen::Cycle(moment))).map_err(|error| match error {
        ReplayError::Damage(damage) => Trouble::Damage(damage),
        ReplayError::Diverged { cycle } => Trouble::Diverged { cycle },
    })
}
