//! What one run of a cycle has led to.

use super::Search;
use super::graph::Cycle;
use crate::analysis::explore::net::formula::AtomId;
use crate::analysis::explore::net::slots::Bit;
use crate::analysis::explore::semantics::{self, Done};
use crate::analysis::explore::valuation::knowledge::Learnt;
use crate::analysis::explore::valuation::{State, When};
use crate::list::List;
use crate::model::Id;

/// The outcome of one run.
pub(crate) struct Leaf {
    pub(crate) next: State,
    pub(crate) done: Done,
    pub(crate) cycle: Cycle,
    pub(crate) late: bool,
    /// The watched expressions that hold, each with what it takes.
    pub(crate) watched: Vec<(usize, Cycle)>,
    /// The watched pairs of actions that ran together.
    pub(crate) met: Vec<usize>,
}

impl Search<'_, '_> {
    /// What a run has led to; none where the assumptions exclude it, or it shows nothing that another does not.
    pub(crate) fn leaf(&mut self, state: &State, when: When, done: Done) -> Option<Leaf> {
        // What the assumptions say belongs to the snapshot with which the next cycle's edges compare.
        if self.thorough {
            self.valuation.decide_edges(when);
        }
        let assumed = self.is_assumed();
        let mut next = semantics::end(&self.valuation, when);
        for slot in &self.foreign {
            next.slots[slot.index()] = Bit::Any;
        }
        let decided = self.timed.then(|| self.valuation.decided());
        if self.timed {
            next.ages = self.valuation.ages(&state.active).into();
        }
        // What the watched expressions ask for is no part of the way on.
        let news = || !done.doubled.is_empty() || self.watches() || self.number_of(&next, &next.before).is_none();
        let (given, past) = match decided {
            Some(decided) => decided,
            None if news() => self.valuation.decided(),
            None => (Vec::new(), Vec::new()),
        };
        let (granted, late) = (self.valuation.granted.clone(), self.valuation.late);
        let cycle = Cycle { given, past, granted, cleared: done.cleared.clone() };
        let holding = self.holding();
        if !assumed || !self.is_assumed() || self.valuation.redundant {
            return None;
        }
        let watched = holding.into_iter().map(|index| (index, self.beside(&cycle, index))).list();
        let met = self.valuation.met.clone();
        Some(Leaf { next, done, cycle, late, watched, met })
    }

    /// Whether watched expressions are left that have not been seen to hold.
    fn watches(&self) -> bool {
        self.graph.watched.iter().any(Option::is_none)
    }

    /// Those of them that hold at the end of this run.
    fn holding(&mut self) -> Vec<usize> {
        if !self.watches() {
            return Vec::new();
        }
        self.valuation.forget_volatile();
        let net = self.valuation.net;
        let open: Vec<usize> =
            (0..self.graph.watched.len()).filter(|index| self.graph.watched[*index].is_none()).list();
        open.into_iter().filter(|index| self.valuation.decide(&net.watched[*index], When::Now)).list()
    }

    /// The cycle with what a watched expression asked for, without what others did.
    fn beside(&self, cycle: &Cycle, index: usize) -> Cycle {
        let (mut atoms, net) = (Vec::new(), self.valuation.net);
        net.collect(&net.watched[index], &mut atoms, &mut Vec::new());
        let own = |before: &Learnt, after: Learnt| -> Learnt {
            let known = |atom: &AtomId| before.iter().any(|(other, _)| other == atom);
            after.into_iter().filter(|(atom, _)| atoms.contains(atom) || known(atom)).list()
        };
        let (given, past) = self.valuation.decided();
        Cycle {
            given: own(&cycle.given, given),
            past: own(&cycle.past, past),
            granted: own(&cycle.granted, self.valuation.granted.clone()),
            cleared: cycle.cleared.clone(),
        }
    }

    /// Whether the run is one that the assumptions allow, and so is what it takes for the inputs of the cycle before; and
    /// whether there are numbers that compare so.
    pub(crate) fn is_assumed(&mut self) -> bool {
        self.allows(When::Now)
            && self.allows(When::Before)
            && !self.valuation.impossible
            && self.valuation.goes_together()
    }

    fn allows(&mut self, when: When) -> bool {
        let net = self.valuation.net;
        let mut open: Vec<usize> = (0..net.assumed_never.len()).list();
        loop {
            // Only assumptions about something that matters in this run are decided.
            let touched = open.iter().position(|index| self.valuation.touches(&net.assumed_never[*index], when));
            let Some(touched) = touched else { return true };
            let index = open.remove(touched);
            if self.valuation.decide_inputs(&net.assumed_never[index], when) {
                return false;
            }
        }
    }
}
