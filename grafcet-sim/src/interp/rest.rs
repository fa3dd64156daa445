//! Whether the cycle that has run left something to the next one: what `next_deadline` calls "at once". It is not worked out by the
//! rules of that page but tried: one more cycle runs with the same inputs at the same reading of the clock.

use std::collections::BTreeMap;

use super::{Cycle, Error, Interpreter, Machine, Memory, Value};

/// What may be said of the next cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Rest {
    /// It has something to do without an input and without time.
    Goes,
    /// It would do nothing; but the one that has run did something.
    Looks,
    /// It would do nothing, as the one that has run.
    Sleeps,
}

impl Interpreter<'_> {
    /// What is left behind the cycle that has just run with these inputs, `before` being the memory in front of it.
    ///
    /// # Errors
    /// Those of [`Interpreter::cycle`].
    pub fn rest(&self, before: &Memory, cycle: &Cycle, inputs: &[Value], now: u32) -> Result<Rest, Error> {
        let mut next = self.clone();
        let again = next.cycle(inputs, now)?;
        let here = self.memory.without_times();
        if next.memory.without_times() != here || !again.calls.is_empty() || !again.stable {
            return Ok(Rest::Goes);
        }
        let cleared = cycle.done().iter().any(|evolution| !evolution.cleared.is_empty());
        let did = cleared || !cycle.calls.is_empty() || cycle.stirred || before.without_times() != here;
        Ok(if did { Rest::Looks } else { Rest::Sleeps })
    }
}

impl Memory {
    /// All but how much time has passed.
    fn without_times(&self) -> Self {
        self.settled(0)
    }

    /// The same where times are no longer than this and the clock reads zero: who compares no time with anything that is longer, and counts how much
    /// passes from there, finds no difference. So a chart comes to a few states only, however long it runs.
    #[must_use]
    pub fn settled(&self, longest: u32) -> Self {
        let mut memory = self.clone();
        memory.state.settle(longest);
        match &mut memory.machine {
            Machine::Sfc(sfc) => sfc.settle(longest),
            Machine::Grafcet(_) => {}
        }
        memory
    }
}

/// No longer than this.
pub(super) fn cap<K: Ord>(times: &mut BTreeMap<K, u64>, longest: u32) {
    for time in times.values_mut() {
        *time = (*time).min(u64::from(longest));
    }
}
