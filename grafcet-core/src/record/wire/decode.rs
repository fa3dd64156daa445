//! Frames out of bytes, without the chart.

use super::answer::Answer;
use super::{ANSWER, CYCLE, HASH, HEAD, STATE, TAIL};
use crate::record::decode::{Entry, Happened, Key, entry};
use crate::record::snapshot::CHECK;

/// Finds frames in what comes over a wire.
#[derive(Clone, Debug)]
pub struct Decoder<B> {
    buffer: B,
    /// How much of the buffer is filled; more than it has where a frame is too long.
    filled: usize,
    /// The number of the next frame, where one has come before.
    next: Option<u16>,
    /// How many bytes the inputs have, where the last state is known.
    inputs: Option<usize>,
}

/// A frame that is whole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Received<'b> {
    /// How many frames are missing in front of it. Of a gap of more than 65,535 frames the number is a smaller one, but the next frame is a state in any case.
    pub lost: u16,
    /// Whether the recording begins here: the controller has started.
    pub begins: bool,
    /// What it says; `None` where that cannot be known before the next state.
    pub frame: Option<Frame<'b>>,
}

/// What a frame says.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Frame<'b> {
    /// The chart is in this state.
    State {
        /// Which chart it is: [`Recordable::FINGERPRINT`](crate::record::Recordable::FINGERPRINT).
        fingerprint: u32,
        /// How its state is stored: [`Recordable::LAYOUT`](crate::record::Recordable::LAYOUT).
        layout: u32,
        /// How many cycles in front of it did nothing of their own.
        skipped: u32,
        /// The state.
        key: Key<'b>,
    },
    /// A cycle.
    Cycle(Entry<'b>),
    /// After the last cycle, recipe and state have this CRC-32C.
    Hash(u32),
    /// What became of a command.
    Answer(Answer),
}

/// A frame was damaged: something else came than was sent.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Damaged;

impl<B: AsRef<[u8]> + AsMut<[u8]>> Decoder<B> {
    /// With a buffer of [`frame_len`](super::frame_len) bytes; a longer frame counts as damaged.
    pub const fn new(buffer: B) -> Self {
        Self { buffer, filled: 0, next: None, inputs: None }
    }

    /// Takes a byte; a frame where it is the last one of it.
    pub fn byte(&mut self, byte: u8) -> Option<Result<Received<'_>, Damaged>> {
        if byte != 0 {
            if let Some(to) = self.buffer.as_mut().get_mut(self.filled) {
                *to = byte;
            }
            self.filled = self.filled.saturating_add(1);
            return None;
        }
        let filled = core::mem::take(&mut self.filled);
        if filled == 0 {
            return None;
        }
        let whole = self.buffer.as_mut().get_mut(..filled).and_then(unpacked);
        let (next, inputs) = (&mut self.next, &mut self.inputs);
        // Of what is damaged nobody knows the number: that it is missing shows in the next one.
        Some(whole.and_then(|frame| received(frame, next, inputs)).ok_or(Damaged))
    }

    /// The buffer, between two frames.
    pub(super) fn scratch(&mut self) -> &mut [u8] {
        self.buffer.as_mut()
    }
}

/// What was encoded, without its check sum; `None` if that is wrong.
fn unpacked(bytes: &mut [u8]) -> Option<&[u8]> {
    let len = cobs::decode_in_place(bytes).ok()?;
    checked(bytes.get(..len)?)
}

/// The same of what is decoded.
pub(in crate::record) fn checked(bytes: &[u8]) -> Option<&[u8]> {
    let (content, check) = bytes.split_last_chunk::<TAIL>()?;
    (CHECK.checksum(content).to_le_bytes() == *check).then_some(content)
}

fn received<'b>(bytes: &'b [u8], next: &mut Option<u16>, inputs: &mut Option<usize>) -> Option<Received<'b>> {
    let (&[kind, low, high], rest) = bytes.split_first_chunk::<HEAD>()?;
    let number = u16::from_le_bytes([low, high]);
    let frame = match kind {
        STATE => Some(state(rest)?),
        HASH => Some(Frame::Hash(u32::from_le_bytes(rest.try_into().ok()?))),
        ANSWER => Some(Frame::Answer(Answer::read(rest)?)),
        CYCLE => None,
        _ => return None,
    };
    let begins = number == 0;
    let lost = if begins { 0 } else { next.map_or(0, |next| steps(next, number)) };
    *next = Some(number.checked_add(1).unwrap_or(1));
    if lost > 0 {
        *inputs = None;
    }
    let frame = match frame {
        Some(Frame::State { key, .. }) => {
            *inputs = Some(key.inputs.len());
            frame
        }
        None => match *inputs {
            Some(inputs) => Some(cycle(rest, inputs)?),
            None => None,
        },
        // It says nothing of the chart's state.
        Some(Frame::Answer(_)) => frame,
        hash => hash.filter(|_| inputs.is_some()),
    };
    Some(Received { lost, begins, frame })
}

/// From one number to another, of which none is zero.
fn steps(from: u16, to: u16) -> u16 {
    if to >= from { to - from } else { (u16::MAX - from).wrapping_add(to) }
}

fn state(bytes: &[u8]) -> Option<Frame<'_>> {
    let (fingerprint, rest) = bytes.split_first_chunk()?;
    let (layout, rest) = rest.split_first_chunk()?;
    let [fingerprint, layout] = [fingerprint, layout].map(|word| u32::from_le_bytes(*word));
    match entry(rest, 0)? {
        (Entry { skipped, what: Happened::State(key) }, []) => Some(Frame::State { fingerprint, layout, skipped, key }),
        _ => None,
    }
}

fn cycle(bytes: &[u8], inputs: usize) -> Option<Frame<'_>> {
    let (entry, rest) = entry(bytes, inputs)?;
    (rest.is_empty() && matches!(entry.what, Happened::Cycle { .. })).then_some(Frame::Cycle(entry))
}

#[cfg(test)]
mod tests {
    use super::steps;

    #[test]
    fn numbers_go_round_without_zero() {
        assert_eq!([(1, 1), (1, 4), (u16::MAX, 1), (u16::MAX - 1, 2)].map(|(from, to)| steps(from, to)), [0, 3, 1, 3]);
    }
}
