//! The recorder on the controller.

use super::chart::Recordable;
use super::decode::REPLACED;
use super::encode::{Cycle, State};
use super::keep::Keep;
use super::memory::{self, Memory};
use super::value::Record;
use crate::Ticks;

/// The longest time and the most cycles without an entry, so that neither wraps around.
const LONGEST: u32 = 1 << 30;

/// A chart whose inputs are recorded: in memory ([`Recorder::new`]), over a wire, or both.
///
/// In front of each cycle that changes anything the recorder writes its inputs: where the program ends in that cycle, they are the last
/// in the record. A cycle with the inputs of the cycle before, in which the chart has nothing to do, is only counted.
#[derive(Debug)]
pub struct Recorder<C: Recordable, K> {
    chart: C,
    keep: K,
    inputs: C::Inputs,
    /// The same as a word, where they are one.
    word: u32,
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
    /// So many bytes would do. Of a record in memory, twenty times as many are useful.
    pub needed: usize,
}

impl core::fmt::Display for TooSmall {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "a record of this chart takes at least {} bytes", self.needed)
    }
}

impl core::error::Error for TooSmall {}

impl<C: Recordable, M: AsRef<[u8]> + AsMut<[u8]>> Recorder<C, Memory<M>> {
    /// The least bytes that `memory` has to have.
    pub const LEAST: usize = memory::least::<C>();

    /// Begins a recording of `chart` in memory; what is there is cleared.
    ///
    /// `memory` is an array, or a slice of one that outlives a reset. Its oldest part is overwritten when it is full.
    ///
    /// # Errors
    /// If the memory is too small.
    pub fn new(chart: C, memory: M) -> Result<Self, TooSmall> {
        Ok(Self::begun(chart, Memory::of::<C>(memory)?))
    }

    /// Ends the recording: the chart as it is, and the memory with the record.
    ///
    /// Cycles that were only counted are not in the record unless [`flush`](Self::flush) has written them down.
    pub fn into_parts(self) -> (C, M) {
        (self.chart, self.keep.into_bytes())
    }

    /// The record, for [`Records`](super::Records), on this machine or elsewhere.
    pub fn record(&self) -> &[u8] {
        self.keep.bytes()
    }
}

impl<C: Recordable, K: Keep> Recorder<C, K> {
    /// Begins a recording.
    pub(crate) fn begun(chart: C, keep: K) -> Self {
        let (inputs, at) = (C::Inputs::default(), chart.reading());
        let mut recorder = Self { chart, keep, inputs, word: inputs.word(), at, quiet: 0, skipped: 0, cycles: 0 };
        recorder.write_state(REPLACED);
        recorder
    }

    /// One cycle of the chart, as [`Chart::scan`](crate::Chart::scan).
    #[inline]
    pub fn cycle(&mut self, inputs: &C::Inputs, now: impl Into<Ticks>, actions: &mut C::Actions<'_>) -> C::Outputs {
        let now = now.into();
        let is_same = if C::Inputs::IS_WORD { inputs.word() == self.word } else { inputs.is_same(&self.inputs) };
        let is_quiet = now.since(self.at).get() < self.quiet && is_same && self.skipped < LONGEST;
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

    /// Where the record goes.
    pub const fn keep(&self) -> &K {
        &self.keep
    }

    /// Changes the chart from outside: `init`, `set_params`. The record holds the state that it has afterwards.
    pub fn change<R>(&mut self, change: impl FnOnce(&mut C) -> R) -> R {
        self.flush();
        let result = change(&mut self.chart);
        self.quiet = 0;
        self.write_state(REPLACED);
        result
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
        if self.keep.is_due::<C>() {
            self.write_state(0);
        }
        let (skipped, elapsed) = (self.skipped, now.since(self.at).get());
        self.keep.cycle::<C>(&Cycle { skipped, elapsed, before: &self.inputs, inputs });
        self.cycles = self.cycles.wrapping_add(skipped).wrapping_add(1);
        self.skipped = 0;
        self.at = now;
        self.inputs = *inputs;
        self.word = inputs.word();
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
        self.keep.after(&self.chart);
    }

    /// How many cycles there were, those that are only counted among them. After 2^32 it begins again at zero: at a cycle a millisecond
    /// that is after 49 days.
    #[cfg(feature = "steer")]
    pub const fn cycles(&self) -> u32 {
        self.cycles.wrapping_add(self.skipped)
    }

    /// Tells the host what became of a command, in the stream of frames.
    #[cfg(feature = "steer")]
    pub fn answer(&mut self, answer: super::steer::Answer) {
        self.keep.answer::<C>(&answer);
    }

    /// The state as it is. The cycles that were only counted have been, as far as an entry is concerned.
    pub(crate) fn write_state(&mut self, flags: u8) {
        let skipped = core::mem::take(&mut self.skipped);
        self.cycles = self.cycles.wrapping_add(skipped);
        if C::TIMED {
            // The chart is due when it was due before.
            let reading = self.chart.reading();
            self.quiet = self.quiet.saturating_sub(reading.since(self.at).get());
            self.at = reading;
        }
        let (chart, inputs, cycles, at) = (&self.chart, &self.inputs, self.cycles, self.at);
        self.keep.state(&State { chart, inputs, flags, skipped, cycles, at });
    }
}
