//! Commands as the host sends them.

use super::{COMMAND, FORCE, HEAD, INIT, MODE, Mode, PUSH, TAIL, Wanted, raw_len};
use crate::record::bits::bytes_for;
use crate::record::snapshot::CHECK;

/// How many bytes [`Request::write`] needs for a command to a chart with so many steps.
#[must_use]
pub const fn request_len(steps: usize) -> usize {
    raw_len(steps) + cobs::max_encoding_length(raw_len(steps)) + 2
}

/// A command as the host sends it, without the chart compiled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Request<'s> {
    /// Its number, above that of the last command that the controller has taken from anybody. The milliseconds since 1970 are such a number; the controller tells its last one in
    /// [`Refused::Old`](super::Refused::Old).
    pub number: u64,
    /// Which chart it is for: [`Recordable::FINGERPRINT`](crate::record::Recordable::FINGERPRINT).
    pub fingerprint: u32,
    /// How many steps this chart has.
    pub steps: usize,
    /// How many cycles the chart had made, as far as the host has seen: the controller refuses what comes late.
    pub seen: u32,
    /// What it wants; steps by their places in [`Chart::STEPS`](crate::Chart::STEPS).
    pub wanted: Wanted<'s, usize>,
}

impl Request<'_> {
    /// The frame, with a zero on both sides, somewhere in `buffer` of [`request_len`] bytes; `None` where that has fewer, or the chart has no such step.
    pub fn write<'b>(&self, buffer: &'b mut [u8]) -> Option<&'b [u8]> {
        let (raw, encoded) = buffer.split_at_mut_checked(raw_len(self.steps))?;
        let (head, rest) = raw.split_first_chunk_mut::<HEAD>()?;
        let (what, len) = match self.wanted {
            Wanted::Init => (INIT, 0),
            Wanted::Push => (PUSH, 0),
            Wanted::Mode(mode) => {
                *rest.first_mut()? = u8::try_from(Mode::ALL.iter().position(|other| *other == mode)?).ok()?;
                (MODE, 1)
            }
            Wanted::Force(steps) => {
                let len = bytes_for(self.steps);
                let situation = rest.get_mut(..len)?;
                situation.fill(0);
                for step in steps {
                    let byte = situation.get_mut(step / 8).filter(|_| *step < self.steps)?;
                    *byte |= 1 << (step % 8);
                }
                (FORCE, len)
            }
        };
        let (kind, rest) = head.split_first_mut()?;
        *kind = COMMAND;
        let (number, rest) = rest.split_first_chunk_mut()?;
        *number = self.number.to_le_bytes();
        let (fingerprint, rest) = rest.split_first_chunk_mut()?;
        *fingerprint = self.fingerprint.to_le_bytes();
        let (seen, rest) = rest.split_first_chunk_mut()?;
        *seen = self.seen.to_le_bytes();
        *rest.first_mut()? = what;
        let end = HEAD + len;
        let check = CHECK.checksum(raw.get(..end)?).to_le_bytes();
        raw.get_mut(end..end + TAIL)?.copy_from_slice(&check);
        *encoded.first_mut()? = 0;
        let len = cobs::try_encode(raw.get(..end + TAIL)?, encoded.get_mut(1..)?).ok()?;
        *encoded.get_mut(1 + len)? = 0;
        encoded.get(..len + 2)
    }
}
