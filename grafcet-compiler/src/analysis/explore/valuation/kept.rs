//! A valuation in the middle of a cycle, to which a later run of the same cycle goes back.

use super::knowledge::{Knowledge, Learnt};
use super::{Snapshot, Valuation};
use crate::model::StepId;

/// What a run changes.
#[derive(Default)]
pub(crate) struct Kept {
    given: Learnt,
    recorded: Learnt,
    now: Snapshot,
    previous: Option<Snapshot>,
    edgeless: bool,
    just_entered: Vec<StepId>,
    /// How many transitions wait, and how many atoms are reserved for them.
    still: usize,
    reserved: usize,
    redundant: bool,
    impossible: bool,
    granted: Learnt,
    late: bool,
    acted: bool,
    /// How many pairs of actions have run together.
    met: usize,
}

impl Kept {
    /// Keeps the valuation as it is now, in the memory of what was kept before.
    pub(crate) fn keep(&mut self, valuation: &Valuation<'_>) {
        valuation.given.write_to(&mut self.given);
        valuation.recorded.write_to(&mut self.recorded);
        self.now.copy(&valuation.now);
        match (&mut self.previous, &valuation.previous) {
            (Some(kept), Some(previous)) => kept.copy(previous),
            (kept, previous) => kept.clone_from(previous),
        }
        self.edgeless = valuation.edgeless;
        self.just_entered.clone_from(&valuation.just_entered);
        (self.still, self.reserved) = (valuation.still.len(), valuation.reserved_atoms.len());
        (self.redundant, self.impossible) = (valuation.redundant, valuation.impossible);
        self.granted.clone_from(&valuation.granted);
        (self.late, self.acted) = (valuation.late, valuation.acted);
        self.met = valuation.met.len();
    }

    pub(crate) fn restore(&self, valuation: &mut Valuation<'_>) {
        valuation.given.read(&self.given);
        valuation.recorded.read(&self.recorded);
        valuation.now.copy(&self.now);
        valuation.previous.clone_from(&self.previous);
        valuation.edgeless = self.edgeless;
        valuation.just_entered.clone_from(&self.just_entered);
        for transition in valuation.still.drain(self.still..) {
            valuation.is_still[transition] = false;
        }
        for atom in valuation.reserved_atoms.drain(self.reserved..) {
            valuation.reserved[atom] = false;
        }
        (valuation.redundant, valuation.impossible) = (self.redundant, self.impossible);
        valuation.granted.clone_from(&self.granted);
        (valuation.late, valuation.acted) = (self.late, self.acted);
        valuation.met.truncate(self.met);
        valuation.own.clear();
    }
}

impl Knowledge {
    fn write_to(&self, learnt: &mut Learnt) {
        learnt.clear();
        for atom in self.learnt() {
            learnt.push((*atom, self.get(*atom)));
        }
    }

    fn read(&mut self, learnt: &Learnt) {
        self.clear();
        for (atom, known) in learnt {
            self.learn(*atom, *known);
        }
    }
}

impl Snapshot {
    fn copy(&mut self, other: &Self) {
        self.active.clone_from(&other.active);
        self.slots.clone_from(&other.slots);
    }
}
