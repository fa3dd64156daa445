//! The recorder on the controller.

use super::bits::{Writer, bytes_for};
use super::chart::Recordable;
use super::decode::{CHANGED, FEW, FRESH, KEY, MASKED, REPLACED, SAME, SOON, mask_len};
use super::ring::{self, Owner, Ring};
use super::value::Record;
use super::varint;
use crate::Ticks;

/// The longest time and the most cycles without an entry, so that neither wraps around.
const LONGEST: u32 = 1 << 30;

/// A chart whose inputs are recorded.
///
/// `memory` is an array, or a slice of one that outlives a reset. Its oldest part is overwritten when it is full.
///
/// In front of each cycle that changes anything the recorder writes its inputs: where the program ends in that cycle, they are the last
/// in the record. A cycle with the inputs of the cycle before, in which the chart has nothing to do, is only counted.
#[derive(Debug)]
pub struct Recorder<C: Recordable, M> {
    chart: C,
    memory: M,
    ring: Ring,
    inputs: C::Inputs,
    /// The time of the last entry.
    at: Ticks,
    /// For how long the chart does nothing as long as no input changes.
    quiet: u32,
    /// The cycles since the last entry.
    skipped: u32,
    /// The cycles up to it.
    cycles: u32,
}

/// The memory of a recorder holds not even two states of the chart with an entry each.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TooSmall {
    /// So many bytes would do. Twenty times as many are useful.
    pub needed: usize,
}

impl core::fmt::Display for TooSmall {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "a record of this chart takes at least {} bytes", self.needed)
    }
}

impl core::error::Error for TooSmall {}

impl<C: Recordable, M: AsRef<[u8]> + AsMut<[u8]>> Recorder<C, M> {
    const INPUTS: usize = bytes_for(<C::Inputs as Record>::BITS);
    const PARAMS: usize = bytes_for(C::PARAM_BITS);
    const STATE: usize = bytes_for(C::STATE_BITS);
    /// Flags, cycle, reading, and three parts with their lengths.
    const KEY: usize = 9 + Self::INPUTS + Self::PARAMS + Self::STATE + 3 * 3;
    /// The longest cycle: control, two numbers and inputs.
    const ENTRY: usize = 1 + 2 * varint::MOST + mask_len(Self::INPUTS) + Self::INPUTS;
    /// The least bytes that `memory` has to have.
    pub const LEAST: usize = ring::least(Self::KEY, Self::ENTRY);

    /// Begins a recording of `chart`; what is in `memory` is cleared.
    ///
    /// # Errors
    /// If the memory is too small.
    pub fn new(chart: C, mut memory: M) -> Result<Self, TooSmall> {
        let bytes = memory.as_mut();
        let divided = ring::divided(bytes.len(), Self::KEY, Self::ENTRY);
        let (block, blocks) = divided.ok_or(TooSmall { needed: Self::LEAST })?;
        bytes.fill(0);
        let owner = Owner { fingerprint: C::FINGERPRINT, layout: C::LAYOUT };
        let (ring, at) = (Ring::new(owner, block, blocks), chart.reading());
        let inputs = C::Inputs::default();
        let mut recorder = Self { chart, memory, ring, inputs, at, quiet: 0, skipped: 0, cycles: 0 };
        recorder.begin_block(REPLACED);
        Ok(recorder)
    }

    /// One cycle of the chart, as [`Chart::scan`](crate::Chart::scan).
    #[inline]
    pub fn cycle(&mut self, inputs: &C::Inputs, now: impl Into<Ticks>, actions: &mut C::Actions<'_>) -> C::Outputs {
        let now = now.into();
        let is_quiet = now.since(self.at).get() < self.quiet && inputs.is_same(&self.inputs) && self.skipped < LONGEST;
        if is_quiet {
            self.skipped += 1;
        } else {
            self.note(inputs, now);
        }
        let before = (!is_quiet && !C::TIMED).then(|| self.chart.clone());
        let outputs = self.chart.scan(inputs, now, actions);
        if !is_quiet {
            self.settle(before.as_ref(), now);
        }
        outputs
    }

    /// The chart.
    pub const fn chart(&self) -> &C {
        &self.chart
    }

    /// Changes the chart from outside: `init`, `set_params`. The record holds the state that it has afterwards.
    pub fn change<R>(&mut self, change: impl FnOnce(&mut C) -> R) -> R {
        self.flush();
        let result = change(&mut self.chart);
        self.quiet = 0;
        self.write_state(REPLACED);
        result
    }

    /// Ends the recording.
    pub fn into_parts(self) -> (C, M) {
        (self.chart, self.memory)
    }

    /// The record, for [`Records`](super::Records), on this machine or elsewhere.
    pub fn record(&self) -> &[u8] {
        self.memory.as_ref()
    }

    /// Writes down the cycles that were only counted, so that the record reaches up to the last cycle, and the state, so that a
    /// replay can be compared with it. It takes as many bytes as a block's begin.
    pub fn flush(&mut self) {
        if self.skipped > 0 {
            self.write_state(0);
        }
    }

    /// The inputs of a cycle, in front of it.
    #[inline(never)]
    fn note(&mut self, inputs: &C::Inputs, now: Ticks) {
        if self.ring.room() < Self::ENTRY {
            self.begin_block(0);
        }
        let (skipped, elapsed) = (self.skipped, now.since(self.at).get());
        let change = (!inputs.is_same(&self.inputs)).then_some((&self.inputs, inputs));
        self.ring.append(self.memory.as_mut(), |to| {
            let mut to = Bytes { to, at: 1 };
            let control = to.number(skipped, FEW) << 2 | to.number(elapsed, SOON) << 4;
            to.set(0, control | if change.is_some() { CHANGED } else { SAME });
            if let Some((before, inputs)) = change {
                to.change::<C>(before, inputs);
            }
            to.at
        });
        self.cycles = self.cycles.wrapping_add(skipped).wrapping_add(1);
        self.skipped = 0;
        self.at = now;
        self.inputs = *inputs;
    }

    /// For how long nothing has to be written, after a cycle.
    #[inline(never)]
    fn settle(&mut self, before: Option<&C>, now: Ticks) {
        self.quiet = match before {
            // What a chart without time does in a cycle that leaves it as it is, it does in all that follow.
            Some(before) if self.chart.is_same_state(before) => u32::MAX,
            Some(_) => 0,
            None => self.chart.wakes_at().map_or(LONGEST, |deadline| deadline.since(now).get().min(LONGEST)),
        };
    }

    /// The state, in this block or at the begin of the next one.
    fn write_state(&mut self, flags: u8) {
        if self.ring.room() < 1 + varint::MOST + Self::KEY {
            return self.begin_block(flags);
        }
        let skipped = self.pass();
        let (chart, inputs, cycles, at) = (&self.chart, &self.inputs, self.cycles, self.at);
        self.ring.append(self.memory.as_mut(), |to| {
            let mut to = Bytes { to, at: 1 };
            let control = to.number(skipped, FEW) << 2;
            to.set(0, control | KEY);
            to.key(chart, inputs, flags, cycles, at);
            to.at
        });
    }

    fn begin_block(&mut self, flags: u8) {
        self.pass();
        let (chart, inputs, cycles, at) = (&self.chart, &self.inputs, self.cycles, self.at);
        self.ring.begin(self.memory.as_mut(), |to| {
            let mut to = Bytes { to, at: 0 };
            to.key(chart, inputs, flags, cycles, at);
            to.at
        });
    }

    /// The cycles that were only counted have been, as far as an entry is concerned.
    fn pass(&mut self) -> u32 {
        let skipped = core::mem::take(&mut self.skipped);
        self.cycles = self.cycles.wrapping_add(skipped);
        if C::TIMED {
            // The chart is due when it was due before.
            let reading = self.chart.reading();
            self.quiet = self.quiet.saturating_sub(reading.since(self.at).get());
            self.at = reading;
        }
        skipped
    }
}

/// Bytes that are filled from the front. There is always enough room, which is asked for before.
struct Bytes<'b> {
    to: &'b mut [u8],
    at: usize,
}

impl Bytes<'_> {
    fn set(&mut self, at: usize, value: u8) {
        if let Some(byte) = self.to.get_mut(at) {
            *byte = value;
        }
    }

    fn push(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.set(self.at, *byte);
            self.at += 1;
        }
    }

    /// A number as bits of the control byte; what does not fit there follows.
    fn number(&mut self, number: u32, limit: u32) -> u8 {
        match number.checked_sub(limit) {
            Some(more) => {
                self.varint(more);
                limit.to_le_bytes()[0]
            }
            None => number.to_le_bytes()[0],
        }
    }

    fn varint(&mut self, number: u32) {
        self.at += varint::write(number, self.to.get_mut(self.at..).unwrap_or_default());
    }

    /// So many bytes, which `write` fills.
    fn packed(&mut self, len: usize, write: impl FnOnce(&mut Writer<'_>)) {
        if let Some(to) = self.to.get_mut(self.at..self.at + len) {
            write(&mut Writer::new(to));
            self.at += len;
        }
    }

    fn part(&mut self, bits: usize, write: impl FnOnce(&mut Writer<'_>)) {
        let len = bytes_for(bits);
        self.varint(u32::try_from(len).unwrap_or(u32::MAX));
        self.packed(len, write);
    }

    fn key<C: Recordable>(&mut self, chart: &C, inputs: &C::Inputs, flags: u8, cycles: u32, at: Ticks) {
        let fresh = if chart.is_same_state(&chart.begun_anew()) { FRESH } else { 0 };
        self.push(&[fresh | flags]);
        self.push(&cycles.to_le_bytes());
        self.push(&at.get().to_le_bytes());
        self.part(<C::Inputs as Record>::BITS, |to| inputs.write(to));
        self.part(C::PARAM_BITS, |to| chart.write_params(to));
        self.part(C::STATE_BITS, |to| chart.write_state(to));
    }

    /// What has changed of the inputs, byte by byte.
    fn change<C: Recordable>(&mut self, before: &C::Inputs, inputs: &C::Inputs) {
        let len = bytes_for(<C::Inputs as Record>::BITS);
        let mask_len = mask_len(len);
        if mask_len == 0 {
            return self.packed(len, |to| inputs.write(to));
        }
        let (mut old, mut new) = ([0; MASKED], [0; MASKED]);
        before.write(&mut Writer::new(&mut old));
        inputs.write(&mut Writer::new(&mut new));
        let mask = self.at;
        self.push(&[0; MASKED / 8][..mask_len]);
        for (index, (old, new)) in old.iter().zip(&new).enumerate() {
            if old != new {
                if let Some(mask) = self.to.get_mut(mask + index / 8) {
                    *mask |= 1 << (index % 8);
                }
                self.push(&[*new]);
            }
        }
    }
}
