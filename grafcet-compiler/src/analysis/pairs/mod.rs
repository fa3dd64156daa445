//! Which pairs of steps a situation can contain, where partial grafcets ask for each other's steps, force and enclose each
//! other.
//!
//! The structure of the arrows tells nothing about two partial grafcets. Here a transition clears beside a step only where
//! its condition can hold there, as far as it asks for steps: all steps it asks for must meet its sources, that step and
//! each other. Orders and enclosing steps bring their situations along. It is a superset of what can happen, as long as
//! every pair that an evolution leads to follows from pairs of the situation before it:
//!
//! - Two transitions that clear together lead where one after the other leads, unless both ask for steps, they share a
//!   source, or one that asks for steps activates a source of the other again; those are taken together.
//! - A step stays beside a transition that clears, unless the transition takes it, empties the partial grafcet around it or
//!   has it forced away, or another one leaves it that has to clear at the same time: what leaves or enters such a step is
//!   taken together with that transition.

mod chart;
mod demands;
mod drags;

use std::rc::Rc;

use self::chart::{Arc, Chart};
use self::demands::Demand;
use super::Relation;
use super::hierarchy::initial_situation;
use crate::list::{List, PushAll};
use crate::model::{Id, Model, TransitionId};
use crate::sorted::Set;

/// What was found.
pub(super) struct Pairs {
    pub(super) relation: Relation,
    /// Steps that some situation contains.
    pub(super) reachable: Vec<bool>,
    /// Transitions that some evolution clears.
    pub(super) clears: Vec<bool>,
}

/// The pairs among those that `may_meet`; what the conditions of `granted` ask for is taken for granted.
pub(super) fn of(model: &Model, may_meet: &Relation, granted: &Set<TransitionId>) -> Pairs {
    let mut search = Search::new(Chart::of(model, may_meet, granted), may_meet);
    let start: Vec<usize> = initial_situation(model).iter().map(|step| step.index()).list();
    search.enter_together(&start);
    search.queue_all(&search.chart.sourceless.clone());
    // In rounds: what a transition leads to is looked at once for all that has become known meanwhile.
    while !search.work.is_empty() {
        for arc in std::mem::take(&mut search.work) {
            search.queued[arc] = false;
            search.fire(arc);
        }
    }
    Pairs { relation: search.relation, reachable: search.reachable, clears: search.clears }
}

struct Search<'m> {
    chart: Rc<Chart>,
    may_meet: &'m Relation,
    relation: Relation,
    reachable: Vec<bool>,
    clears: Vec<bool>,
    work: Vec<usize>,
    queued: Vec<bool>,
}

impl<'m> Search<'m> {
    fn new(chart: Chart, may_meet: &'m Relation) -> Self {
        let (steps, arcs) = (chart.part_of.len(), chart.arcs.len());
        Self {
            chart: Rc::new(chart),
            may_meet,
            relation: Relation::new(steps),
            reachable: vec![false; steps],
            clears: vec![false; arcs],
            work: Vec::new(),
            queued: vec![false; arcs],
        }
    }

    /// What clearing a transition can lead to.
    fn fire(&mut self, index: usize) {
        let chart = Rc::clone(&self.chart);
        let arc = &chart.arcs[index];
        for demand in &arc.demands {
            if !self.is_possible(&chart, arc, demand) {
                continue;
            }
            self.clears[index] = true;
            let entered = chart.entered(&arc.targets);
            self.enter_together(&entered);
            let needed: Vec<usize> = demand.active.iter().copied().list();
            for target in &entered {
                let bystanders = self.relation.common_beyond(&needed, *target).into_iter().and(needed.iter().copied());
                for bystander in bystanders.list() {
                    if self.reachable[bystander] && chart.stays(bystander, arc, demand, &entered) {
                        self.relate(*target, bystander);
                    }
                }
            }
            for partner in &arc.partners {
                self.fire_together(&chart, demand, *partner, &entered);
            }
        }
    }

    /// The same where another transition clears in the same evolution.
    fn fire_together(&mut self, chart: &Chart, demand: &Demand, partner: usize, entered: &[usize]) {
        let other = &chart.arcs[partner];
        let meets = |search: &Self, theirs: &Demand| {
            let apart = |a: &usize| theirs.active.iter().any(|b| a != b && !search.relation.contains(*a, *b));
            search.is_possible(chart, other, theirs)
                && demand.inactive.is_disjoint(&theirs.active)
                && theirs.inactive.is_disjoint(&demand.active)
                && !demand.active.iter().any(apart)
        };
        if other.demands.iter().any(|theirs| meets(self, theirs)) {
            for a in entered {
                for b in chart.entered(&other.targets) {
                    self.reach(b);
                    self.relate(*a, b);
                }
            }
        }
    }

    /// Whether some situation may contain all that this demand needs, and no order holds the partial grafcet.
    fn is_possible(&self, chart: &Chart, arc: &Arc, demand: &Demand) -> bool {
        let meets = |(a, b): (usize, usize)| self.relation.contains(a, b);
        let mut pairs =
            demand.active.iter().enumerate().flat(|(place, a)| demand.active[place + 1..].iter().map(|b| (*a, *b)));
        demand.active.iter().all(|step| self.reachable[*step] && !chart.commands[*step].contains(&arc.partial))
            && pairs.all(meets)
    }

    fn enter_together(&mut self, steps: &[usize]) {
        for (position, a) in steps.iter().enumerate() {
            self.reach(*a);
            for b in &steps[position + 1..] {
                self.relate(*a, *b);
            }
        }
    }

    fn reach(&mut self, step: usize) {
        if std::mem::replace(&mut self.reachable[step], true) {
            return;
        }
        let chart = Rc::clone(&self.chart);
        self.queue_all(&chart.needing[step]);
        self.queue_all(&chart.sourceless);
        for (_, forced) in &chart.forces[step] {
            self.enter_together(forced);
            for other in forced {
                self.relate(step, *other);
            }
        }
        for related in self.relation.of(step).list() {
            self.queue_all(&chart.needing[related]);
        }
    }

    /// Notes that two steps can be active together, and with them what they force.
    fn relate(&mut self, a: usize, b: usize) {
        let chart = Rc::clone(&self.chart);
        let mut pairs = vec![(a, b)];
        while let Some((a, b)) = pairs.pop() {
            let barred = !self.may_meet.contains(a, b) || chart.forces_away(a, b) || chart.forces_away(b, a);
            if a == b || barred || !self.relation.insert(a, b) {
                continue;
            }
            self.queue_all(&chart.needing[a]);
            self.queue_all(&chart.needing[b]);
            for (one, other) in [(a, b), (b, a)] {
                let forced = chart.forces[one].iter().flat(|(_, forced)| forced);
                pairs.push_all(forced.map(|step| (*step, other)));
            }
        }
    }

    fn queue_all(&mut self, arcs: &[usize]) {
        for arc in arcs {
            if !std::mem::replace(&mut self.queued[*arc], true) {
                self.work.push(*arc);
            }
        }
    }
}
