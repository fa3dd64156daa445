//! What came over a wire.

use grafcet_core::record::wire::{Decoder, Frame, Received};
use grafcet_core::record::{Damage, Happened};

use super::{ReplayError, Run, said};

/// The longest frames that are taken: of a chart with some hundred kilobytes of state.
const LONGEST: usize = 1 << 18;

fn decoder() -> Decoder<Vec<u8>> {
    Decoder::new(vec![0; LONGEST])
}

/// Of which chart the first state is, and how the compiler stored it.
pub(super) fn owner(bytes: &[u8]) -> Option<(u32, u32)> {
    let mut decoder = decoder();
    bytes.iter().find_map(|byte| match decoder.byte(*byte)?.ok()?.frame? {
        Frame::State { fingerprint, layout, .. } => Some((fingerprint, layout)),
        _ => None,
    })
}

impl Run<'_> {
    /// All that came over a wire; what is of another chart than `recorded` is a gap.
    pub(super) fn frames(&mut self, bytes: &[u8], recorded: (u32, u32)) -> Result<(), ReplayError> {
        let mut decoder = decoder();
        for byte in bytes {
            let Some(received) = decoder.byte(*byte) else { continue };
            let Ok(received) = received else {
                self.lose("a frame was damaged");
                continue;
            };
            self.received(&received, recorded)?;
        }
        Ok(())
    }

    /// A frame; what is of another chart than `recorded`, or stored otherwise, is a gap.
    pub(super) fn received(&mut self, received: &Received<'_>, recorded: (u32, u32)) -> Result<(), ReplayError> {
        if received.lost > 0 {
            let frames = if received.lost == 1 { "a frame was" } else { &format!("{} frames were", received.lost) };
            self.lose(&format!("{frames} lost"));
        }
        // What was known is not what goes on.
        if received.begins {
            self.cover();
        }
        match received.frame {
            Some(Frame::State { fingerprint, .. }) if fingerprint != recorded.0 => {
                self.lose(&said(Damage::OtherChart { fingerprint }));
            }
            Some(Frame::State { layout, .. }) if layout != recorded.1 => self.lose(&said(Damage::OtherLayout)),
            Some(Frame::State { key, .. }) => {
                if received.begins && !key.fresh && self.trace.is_some() {
                    self.note("the controller has started anew");
                }
                self.key(&key)?;
            }
            Some(Frame::Cycle(entry)) => {
                // Before the first state nothing is known of the inputs.
                if let (Happened::Cycle { elapsed, change }, true) = (entry.what, self.simulation.is_some()) {
                    self.cycle(entry.skipped, elapsed, change)?;
                }
            }
            Some(Frame::Hash(_) | Frame::Answer(_)) | None => {}
        }
        Ok(())
    }
}
