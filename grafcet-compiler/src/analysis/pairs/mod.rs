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
use crate::list::{List, PushAll};
use crate::model::{Id, Model, StepId, TransitionId};
use crate::sorted::Set;

/// What was found.
pub(super) struct Pairs {
    pub(super) relation: Relation,
    /// Steps that some situation contains.
    pub(super) reachable: Vec<bool>,
    /// Transitions that some evolution clears.
    pub(super) clears: Vec<bool>,
}

/// The pairs among those that `may_meet`, from the `initial` situation on; what the conditions of `granted` ask for is taken for granted.
pub(super) fn of(model: &Model, may_meet: &Relation, initial: &Set<StepId>, granted: &Set<TransitionId>) -> Pairs {
    let mut search = Search::new(Chart::of(model, may_meet, granted), may_meet);
    let start: Vec<usize> = initial.iter().map(|step| step.index()).list();
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

struct Search {
    chart: Rc<Chart>,
    /// What may meet, and is not forced away.
    allowed: Relation,
    relation: Relation,
    reachable: Vec<bool>,
    clears: Vec<bool>,
    work: Vec<usize>,
    queued: Vec<bool>,
    /// Per transition, by its demands and partners: that these have cleared together is known.
    together: Vec<Vec<bool>>,
}

impl Search {
    fn new(chart: Chart, may_meet: &Relation) -> Self {
        let (steps, arcs) = (chart.part_of.len(), chart.arcs.len());
        let mut allowed = may_meet.clone();
        for (step, away) in chart.away.iter().enumerate() {
            for other in away {
                allowed.remove(step, *other);
            }
        }
        Self {
            together: chart.arcs.iter().map(|arc| vec![false; arc.demands.len() * arc.partners.len()]).list(),
            chart: Rc::new(chart),
            allowed,
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
        for (number, demand) in arc.demands.iter().enumerate() {
            if !self.is_possible(&chart, arc, demand) {
                continue;
            }
            self.clears[index] = true;
            self.enter_together(&arc.entered);
            let gone = chart.gone(arc, demand);
            for target in &arc.entered {
                for bystander in self.relation.new_beside(&demand.active, *target, &self.allowed, &gone) {
                    if self.reachable[bystander] {
                        self.relate(*target, bystander);
                    }
                }
            }
            for (at, partner) in arc.partners.iter().enumerate() {
                let at = number * arc.partners.len() + at;
                if !self.together[index][at] && self.clear_together(&chart, demand, *partner) {
                    self.together[index][at] = true;
                    for a in &arc.entered {
                        for b in &chart.arcs[*partner].entered {
                            self.reach(*b);
                            self.relate(*a, *b);
                        }
                    }
                }
            }
        }
    }

    /// Whether another transition may clear in the same evolution.
    fn clear_together(&self, chart: &Chart, demand: &Demand, partner: usize) -> bool {
        let other = &chart.arcs[partner];
        let meets = |theirs: &Demand| {
            let is_excluded = |a: &usize| theirs.active.iter().any(|b| a != b && !self.relation.contains(*a, *b));
            // What fails most often is asked first.
            !demand.active.iter().any(is_excluded)
                && demand.inactive.is_disjoint(&theirs.active)
                && theirs.inactive.is_disjoint(&demand.active)
                && self.is_possible(chart, other, theirs)
        };
        other.demands.iter().any(meets)
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
        let (mut pair, mut open) = (Some((a, b)), Vec::new());
        while let Some((a, b)) = pair {
            if a != b && self.allowed.contains(a, b) && self.relation.insert(a, b) {
                self.queue_all(&chart.needing[a]);
                self.queue_all(&chart.needing[b]);
                for (one, other) in [(a, b), (b, a)].into_iter().filter(|(one, _)| !chart.forces[*one].is_empty()) {
                    let forced = chart.forces[one].iter().flat(|(_, forced)| forced);
                    open.push_all(forced.map(|step| (*step, other)));
                }
            }
            pair = open.pop();
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
