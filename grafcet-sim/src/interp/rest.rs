//! Whether the cycle that has run left something to the next one: what `next_deadline` calls "at once". It is not worked out by the
//! rules of that page but tried: one more cycle runs with the same inputs at the same reading of the clock.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::model::{Association, EdgeId, Effect, Expr, Model, Read};

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
    /// What is left after the cycle that has just run with these inputs, `before` being the memory in front of it.
    ///
    /// # Errors
    /// Those of [`Interpreter::cycle`].
    pub fn rest(&self, before: &Memory, cycle: &Cycle, inputs: &[Value], now: u32) -> Result<Rest, Error> {
        let mut next = self.clone();
        let again = next.cycle(inputs, now)?;
        let looked_at = |memory: &Memory| memory.without_times().looked_at(self.model);
        let here = looked_at(&self.memory);
        if looked_at(&next.memory) != here || !again.calls.is_empty() || !again.stable {
            return Ok(Rest::Goes);
        }
        let cleared = cycle.done().iter().any(|evolution| !evolution.cleared.is_empty());
        let did = cleared || !cycle.calls.is_empty() || cycle.stirred || looked_at(before) != here;
        Ok(if did { Rest::Looks } else { Rest::Sleeps })
    }
}

impl Memory {
    /// All but how much time has passed.
    fn without_times(&self) -> Self {
        self.settled(0)
    }

    /// Without the edges that nothing asks for: of each the values are kept before the evolution and, in an `sfc`, before the actions, though conditions may
    /// look at it alone, or actions.
    fn looked_at(mut self, model: &Model) -> Self {
        let transitions = model.transitions.values();
        let clearing = transitions.clone().flat_map(|transition| &transition.clearing).flat_map(Effect::reads);
        let conditions =
            transitions.map(|transition| &transition.condition).chain(model.delays.values().map(|delay| &delay.of));
        let early = conditions.flat_map(|of: &Expr| &of.reads).chain(clearing.flatten());
        let acting = model.associations.values().flat_map(Association::reads).flatten();
        if model.is_grafcet() {
            let asked = edges(model, early.chain(acting));
            self.state.edges.retain(|id, _| asked.contains(id));
        } else {
            let (early, late) = (edges(model, early), edges(model, acting));
            self.state.edges.retain(|id, _| early.contains(id));
            self.state.action_edges.retain(|id, _| late.contains(id));
        }
        self
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

/// The edges among what is read, and those that they look at themselves.
fn edges<'m>(model: &'m Model, reads: impl Iterator<Item = &'m Read>) -> BTreeSet<EdgeId> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&Read> = reads.collect();
    while let Some(read) = open.pop() {
        if let Read::Rising(id) | Read::Falling(id) = read {
            if found.insert(*id) {
                open.extend(&model.edges[*id].of.reads);
            }
        }
    }
    found
}

/// No longer than this.
pub(super) fn cap<K: Ord>(times: &mut BTreeMap<K, u64>, longest: u32) {
    for time in times.values_mut() {
        *time = (*time).min(u64::from(longest));
    }
}
