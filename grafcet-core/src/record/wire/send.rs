//! What the controller sends.

use embedded_io::Write;

use super::answer::Answer;
use super::{ANSWER, CYCLE, HASH, HEAD, STATE, TAIL, frame_len, hash, raw_len};
use crate::record::chart::Recordable;
use crate::record::encode::{Cycle, State};
use crate::record::keep::Keep;
use crate::record::memory::Memory;
use crate::record::recorder::{Recorder, TooSmall};
use crate::record::snapshot::CHECK;

/// How many bytes of memory a [`Wire`] needs for the frames of a chart.
#[must_use]
pub const fn wire_len<C: Recordable>() -> usize {
    // A frame, what it is encoded to, and a zero on both sides of that.
    raw_len::<C>() + frame_len::<C>() + 2
}

/// Sends a record through a writer, such as a serial line: frames with numbers, check sums and, now and then, a state or its hash.
///
/// A frame is written at once. Give a writer that takes it into a queue, where the cycle must not wait for the line. A frame that it does
/// not take is lost: the host sees the number missing, and the next frame is a state, from which it goes on.
#[derive(Debug)]
pub struct Wire<W, B> {
    writer: W,
    buffer: B,
    hashes: u16,
    states: u16,
    /// How many cycles were sent since the last hash or state, and since the last state.
    since_hash: u16,
    since_state: u16,
    number: u16,
    /// Whether something may stand on the line in front of the next frame that is none.
    is_torn: bool,
    /// Whether the host has to be told the state, as it misses a frame.
    is_lost: bool,
}

impl<W: Write, B: AsMut<[u8]>> Wire<W, B> {
    /// Through `writer`, with a buffer of [`wire_len`] bytes.
    pub const fn new(writer: W, buffer: B) -> Self {
        Self {
            writer,
            buffer,
            hashes: 16,
            states: 256,
            since_hash: 0,
            since_state: 0,
            number: 0,
            is_torn: true,
            is_lost: false,
        }
    }

    /// After how many cycles that are sent the hash of the state follows (16), and after how many the state itself (256): so soon the host sees that
    /// it shows what was not, and goes on after a frame was lost.
    #[must_use]
    pub const fn every(mut self, hashes: u16, states: u16) -> Self {
        (self.hashes, self.states) = (hashes, states);
        self
    }

    /// The writer.
    pub const fn writer(&self) -> &W {
        &self.writer
    }

    /// A frame, of which `fill` writes what it says.
    fn send<C: Recordable>(&mut self, kind: u8, fill: impl FnOnce(&mut [u8]) -> Option<usize>) {
        let number = self.number;
        // Zero is the number of the first frame alone.
        self.number = number.checked_add(1).unwrap_or(1);
        let sent = frame::<C>(self.buffer.as_mut(), kind, number, fill).is_some_and(|frame| {
            let frame = if self.is_torn { frame } else { frame.get(1..).unwrap_or_default() };
            is_written(&mut self.writer, frame)
        });
        self.is_torn = !sent;
        self.is_lost |= !sent;
    }
}

/// Whether the writer has taken all. One that takes nothing has failed: `write_all` would panic.
fn is_written(writer: &mut impl Write, mut bytes: &[u8]) -> bool {
    while !bytes.is_empty() {
        match writer.write(bytes) {
            Ok(taken @ 1..) => bytes = bytes.get(taken..).unwrap_or_default(),
            Ok(0) | Err(_) => return false,
        }
    }
    true
}

/// A frame with a zero on both sides.
fn frame<C: Recordable>(
    buffer: &mut [u8],
    kind: u8,
    number: u16,
    fill: impl FnOnce(&mut [u8]) -> Option<usize>,
) -> Option<&[u8]> {
    let (raw, encoded) = buffer.split_at_mut_checked(raw_len::<C>())?;
    let [low, high] = number.to_le_bytes();
    raw.get_mut(..HEAD)?.copy_from_slice(&[kind, low, high]);
    let end = HEAD + fill(raw.get_mut(HEAD..)?)?;
    let check = CHECK.checksum(raw.get(..end)?).to_le_bytes();
    raw.get_mut(end..end + TAIL)?.copy_from_slice(&check);
    *encoded.first_mut()? = 0;
    let len = cobs::try_encode(raw.get(..end + TAIL)?, encoded.get_mut(1..)?).ok()?;
    *encoded.get_mut(1 + len)? = 0;
    encoded.get(..len + 2)
}

impl<W: Write, B: AsMut<[u8]>> Keep for Wire<W, B> {
    fn is_due<C: Recordable>(&self) -> bool {
        self.is_lost || self.since_state >= self.states
    }

    fn state<C: Recordable>(&mut self, state: &State<'_, C>) {
        self.is_lost = false;
        (self.since_hash, self.since_state) = (0, 0);
        self.send::<C>(STATE, |to| {
            to.get_mut(..4)?.copy_from_slice(&C::FINGERPRINT.to_le_bytes());
            to.get_mut(4..8)?.copy_from_slice(&C::LAYOUT.to_le_bytes());
            Some(8 + state.write_entry(to.get_mut(8..)?))
        });
    }

    fn cycle<C: Recordable>(&mut self, cycle: &Cycle<'_, C>) {
        self.since_hash = self.since_hash.saturating_add(1);
        self.since_state = self.since_state.saturating_add(1);
        self.send::<C>(CYCLE, |to| Some(cycle.write(to)));
    }

    fn after<C: Recordable>(&mut self, chart: &C) {
        if self.since_hash < self.hashes {
            return;
        }
        self.since_hash = 0;
        self.send::<C>(HASH, |to| {
            let hash = hash(chart, to)?.to_le_bytes();
            to.get_mut(..hash.len())?.copy_from_slice(&hash);
            Some(hash.len())
        });
    }

    fn answer<C: Recordable>(&mut self, answer: &Answer) {
        self.send::<C>(ANSWER, |to| answer.write(to));
    }
}

impl<C: Recordable, W: Write, B: AsMut<[u8]>> Recorder<C, Wire<W, B>> {
    /// Begins a recording of `chart` over a wire.
    ///
    /// # Errors
    /// If the buffer of the wire has fewer than [`wire_len`] bytes.
    pub fn over(chart: C, wire: Wire<W, B>) -> Result<Self, TooSmall> {
        Ok(Self::begun(chart, checked::<C, W, B>(wire)?))
    }
}

impl<C: Recordable, M: AsRef<[u8]> + AsMut<[u8]>, W: Write, B: AsMut<[u8]>> Recorder<C, (Memory<M>, Wire<W, B>)> {
    /// Begins a recording of `chart` in memory, as [`Recorder::new`], and over a wire.
    ///
    /// # Errors
    /// If the memory is too small, or the buffer of the wire has fewer than [`wire_len`] bytes.
    pub fn both(chart: C, memory: M, wire: Wire<W, B>) -> Result<Self, TooSmall> {
        Ok(Self::begun(chart, (Memory::of::<C>(memory)?, checked::<C, W, B>(wire)?)))
    }
}

fn checked<C: Recordable, W, B: AsMut<[u8]>>(mut wire: Wire<W, B>) -> Result<Wire<W, B>, TooSmall> {
    let needed = wire_len::<C>();
    if wire.buffer.as_mut().len() < needed { Err(TooSmall { needed }) } else { Ok(wire) }
}

impl<C: Recordable, K: Keep> Recorder<C, K> {
    /// Writes the state as it is, whether or not anything has happened. Over a wire, once in a second or so, it tells the host that the controller runs, and
    /// from where to go on.
    pub fn tell_state(&mut self) {
        self.write_state(0);
    }
}
