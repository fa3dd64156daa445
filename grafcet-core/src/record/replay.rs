//! A chart is run again on what was recorded.

use super::bits::{Reader, Writer, bytes_for};
use super::chart::Recordable;
use super::decode::{Change, Damage, Happened, Key, MASKED, Records};
use super::value::Record;
use crate::Ticks;

/// A cycle of a replay, or of several in which the same happened.
#[derive(Debug)]
pub struct Moment<'m, C: Recordable> {
    /// The number of the cycle, from zero on; after 2^32 cycles it begins again at zero.
    pub cycle: u32,
    /// The reading of its clock, which wraps around.
    pub now: Ticks,
    /// The inputs.
    pub inputs: &'m C::Inputs,
    /// What the chart has made of them.
    pub outputs: C::Outputs,
    /// The chart after the cycle.
    pub chart: &'m C,
}

/// Why a replay ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ReplayError {
    /// Nothing more can be read.
    Damage(Damage),
    /// The chart is not in the state in which the record has it after so many cycles: a function that a condition calls is not pure, or
    /// something changed the chart past the recorder.
    Diverged {
        /// How many cycles there were.
        cycle: u32,
    },
}

impl From<Damage> for ReplayError {
    fn from(damage: Damage) -> Self {
        Self::Damage(damage)
    }
}

/// A chart that is run again.
#[derive(Debug)]
pub(crate) struct Replay<C: Recordable> {
    chart: C,
    inputs: C::Inputs,
    now: Ticks,
    cycle: u32,
}

/// Runs the chart again, from the oldest state that is left on, and shows each cycle that was written down. Where blocks are missing it goes on with
/// the next one. Code actions go to `actions`, which should do nothing.
///
/// # Errors
/// If the record is of another chart, is damaged, or the chart does not do the same again.
pub fn replay<C: Recordable>(
    records: &Records<'_>,
    actions: &mut C::Actions<'_>,
    mut each: impl FnMut(Moment<'_, C>),
) -> Result<(), ReplayError> {
    records.check::<C>()?;
    let mut replay: Option<Replay<C>> = None;
    for block in records.blocks() {
        let block = block?;
        let before = replay.take().filter(|_| block.missing == 0);
        let mut current = Replay::go_on(before, &block.key, actions, &mut each)?;
        for entry in block.entries() {
            let entry = entry?;
            match entry.what {
                Happened::Cycle { elapsed, change } => {
                    let ran = current.step(entry.skipped, Ticks::new(elapsed), change, actions, &mut each);
                    ran.ok_or(Damage::Nonsense)?;
                }
                Happened::State(key) => current = Replay::go_on(Some(current), &key, actions, &mut each)?,
            }
        }
        // What was torn off is missing.
        replay = (!block.torn).then_some(current);
    }
    Ok(())
}

impl<C: Recordable> Replay<C> {
    /// The chart in a state that was recorded.
    pub(crate) fn at(key: &Key<'_>) -> Option<Self> {
        let now = Ticks::new(key.reading);
        let chart = C::read(&mut Reader::new(key.params), &mut Reader::new(key.state), now)?;
        let inputs = <C::Inputs as Record>::read(&mut Reader::new(key.inputs))?;
        Some(Self { chart, inputs, now, cycle: key.cycle })
    }

    /// How many cycles there were, and the chart after them.
    #[cfg(feature = "wire")]
    pub(crate) const fn shown(&self) -> (u32, &C) {
        (self.cycle, &self.chart)
    }

    /// A cycle after some that did nothing; `None` where its inputs are none.
    pub(crate) fn step(
        &mut self,
        skipped: u32,
        elapsed: Ticks,
        change: Option<Change<'_>>,
        actions: &mut C::Actions<'_>,
        each: &mut impl FnMut(Moment<'_, C>),
    ) -> Option<()> {
        self.cycle = self.cycle.wrapping_add(skipped);
        self.now = self.now.after(elapsed);
        if let Some(change) = change {
            self.change(&change)?;
        }
        self.run(actions, each);
        Some(())
    }

    /// What was recorded at this point, which has to be what the chart does.
    pub(crate) fn go_on(
        before: Option<Self>,
        key: &Key<'_>,
        actions: &mut C::Actions<'_>,
        each: &mut impl FnMut(Moment<'_, C>),
    ) -> Result<Self, ReplayError> {
        let recorded = Self::at(key).ok_or(Damage::Nonsense)?;
        if let Some(mut before) = before {
            if before.cycle != recorded.cycle {
                // One cycle in place of all that did nothing.
                before.now = recorded.now;
                before.cycle = recorded.cycle.wrapping_sub(1);
                before.run(actions, each);
            }
            if !key.replaced && !before.chart.is_same_state(&recorded.chart) {
                return Err(ReplayError::Diverged { cycle: key.cycle });
            }
        }
        Ok(recorded)
    }

    fn change(&mut self, change: &Change<'_>) -> Option<()> {
        if let Some(all) = change.all() {
            self.inputs = Record::read(&mut Reader::new(all))?;
            return Some(());
        }
        let mut bytes = [0; MASKED];
        let inputs = bytes.get_mut(..bytes_for(<C::Inputs as Record>::BITS))?;
        self.inputs.write(&mut Writer::new(inputs));
        change.apply(inputs);
        self.inputs = Record::read(&mut Reader::new(inputs))?;
        Some(())
    }

    fn run(&mut self, actions: &mut C::Actions<'_>, each: &mut impl FnMut(Moment<'_, C>)) {
        let outputs = self.chart.scan(&self.inputs, self.now, actions);
        each(Moment { cycle: self.cycle, now: self.now, inputs: &self.inputs, outputs, chart: &self.chart });
        self.cycle = self.cycle.wrapping_add(1);
    }
}
