//! What one run of a cycle has led to.

use super::cycle::{self, Done};
use super::graph::Cycle;
use super::knowledge::Learnt;
use super::scene::{State, When};
use super::search::Search;
use super::slots::Bit;
use crate::list::List;

/// The outcome of one run.
pub(super) struct Leaf {
    pub(super) next: State,
    pub(super) done: Done,
    pub(super) cycle: Cycle,
    pub(super) late: bool,
    /// The watched expressions that hold, each with what it takes.
    pub(super) watched: Vec<(usize, Cycle)>,
    /// The watched pairs of actions that ran together.
    pub(super) met: Vec<usize>,
}

impl Search<'_, '_> {
    /// What a run has led to; none where the assumptions exclude it, or it shows nothing that another does not.
    pub(super) fn leaf(&mut self, state: &State, when: When, done: Done) -> Option<Leaf> {
        // What the assumptions say belongs to the snapshot with which the next cycle's edges compare.
        if self.thorough {
            self.scene.decide_edges(when);
        }
        let assumed = self.is_assumed();
        let mut next = cycle::end(&self.scene, when);
        for slot in &self.foreign {
            next.slots[*slot] = Bit::Any;
        }
        let decided = self.timed.then(|| self.scene.decided());
        if self.timed {
            next.ages = self.scene.ages(&state.active).into();
        }
        // What the watched expressions ask for is no part of the way on.
        let news = || !done.doubled.is_empty() || self.watches() || !self.index.contains_key(&next);
        let (given, past) = match decided {
            Some(decided) => decided,
            None if news() => self.scene.decided(),
            None => (Vec::new(), Vec::new()),
        };
        let (granted, late) = (self.scene.granted.clone(), self.scene.late);
        let cycle = Cycle { given, past, granted, cleared: done.cleared.clone() };
        let holding = self.holding();
        if !assumed || !self.is_assumed() || self.scene.redundant {
            return None;
        }
        let watched = holding.into_iter().map(|index| (index, self.beside(&cycle, index))).list();
        let met = self.scene.met.clone();
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
        self.scene.forget_volatile();
        let net = self.scene.net;
        let open: Vec<usize> =
            (0..self.graph.watched.len()).filter(|index| self.graph.watched[*index].is_none()).list();
        open.into_iter().filter(|index| self.scene.decide(&net.watched[*index], When::Now)).list()
    }

    /// The cycle with what a watched expression asked for, without what others did.
    fn beside(&self, cycle: &Cycle, index: usize) -> Cycle {
        let (mut atoms, net) = (Vec::new(), self.scene.net);
        net.collect(&net.watched[index], &mut atoms, &mut Vec::new());
        let own = |before: &Learnt, after: Learnt| -> Learnt {
            let known = |atom: &usize| before.iter().any(|(other, _)| other == atom);
            after.into_iter().filter(|(atom, _)| atoms.contains(atom) || known(atom)).list()
        };
        let (given, past) = self.scene.decided();
        Cycle {
            given: own(&cycle.given, given),
            past: own(&cycle.past, past),
            granted: own(&cycle.granted, self.scene.granted.clone()),
            cleared: cycle.cleared.clone(),
        }
    }

    /// Whether the run is one that the assumptions allow, and so is what it takes for the inputs of the cycle before; and
    /// whether there are numbers that compare so.
    pub(super) fn is_assumed(&mut self) -> bool {
        self.allows(When::Now) && self.allows(When::Before) && !self.scene.impossible && self.scene.goes_together()
    }

    fn allows(&mut self, when: When) -> bool {
        let net = self.scene.net;
        let mut open: Vec<usize> = (0..net.assumed_never.len()).list();
        loop {
            // Only assumptions about something that matters in this run are decided.
            let touched = open.iter().position(|index| self.scene.touches(&net.assumed_never[*index], when));
            let Some(touched) = touched else { return true };
            let index = open.remove(touched);
            if self.scene.decide_inputs(&net.assumed_never[index], when) {
                return false;
            }
        }
    }
}
