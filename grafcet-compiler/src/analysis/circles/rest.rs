//! Where a search for stability can come to rest: what can be the beginning of the next one.

use std::rc::Rc;

use super::run::{Node, Outcome, Run};
use super::view::View;
use super::{Circles, Goals, borrowed};
use crate::list::List;
use crate::model::{ForceOrder, Id, Model, PartialId, Read, StepId, TransitionId, Tree};
use crate::sorted::Set;

/// How many situations are looked at to find out which of them are stable.
const LOOKED_AT: usize = 600;

impl Circles<'_> {
    /// The steps in which a search can come to rest, found by following all of them; `None` where that is too much.
    pub(super) fn resting(&self) -> Option<Set<StepId>> {
        let is_target = |partial: PartialId| !self.model.partials[partial].forced_by.is_empty();
        let commanded = |id: &StepId| {
            let step = &self.model.steps[*id];
            step.linked || step.initial && is_target(step.partial) || self.is_forced(*id)
        };
        let mut resting: Set<StepId> = self.model.steps.ids().filter(commanded).collect();
        let mut waiting: Vec<TransitionId> = self.model.transitions.ids().list();
        let mut starts = vec![Some(self.start())];
        let mut looked_at = 0;
        while !starts.is_empty() {
            for start in starts.drain(..) {
                let mut run = Run::new(self, start);
                while let Some(outcome) = run.next() {
                    if looked_at + run.looked_at() > LOOKED_AT {
                        return None;
                    }
                    match outcome {
                        Outcome::Rests(steps) => resting.extend(steps),
                        Outcome::Endless(..) => {}
                        Outcome::Undecided => return None,
                    }
                }
                looked_at += run.looked_at();
            }
            waiting.retain(|id| {
                let enabled = self.needs(*id).is_subset(&resting);
                if enabled {
                    starts.push(self.entry(*id));
                }
                !enabled
            });
        }
        Some(resting)
    }

    /// Whether the transition can clear in a stable situation; `resting` are the steps of such, where that is known.
    pub(super) fn can_enter(&self, id: TransitionId, resting: Option<&Set<StepId>>) -> bool {
        let rests = match resting {
            Some(resting) => self.needs(id).is_subset(resting),
            None => self.model.transitions[id].sources.iter().all(|step| self.can_rest(*step)),
        };
        rests && !self.logic.impossible(&borrowed(&self.cleared(id)))
    }

    /// The steps that have to be active for the transition to clear: its sources, and those that its condition asks for.
    fn needs(&self, id: TransitionId) -> Set<StepId> {
        let transition = &self.model.transitions[id];
        let asked_for = |read: &Read| match read {
            Read::Active(step) | Read::Elapsed(_, step) => {
                let inactive = (Rc::new(self.logic.condition(&Tree::Read(Read::Active(*step)))), false);
                let goals: Goals = self.cleared(id).into_iter().and([inactive]).list();
                self.logic.impossible(&borrowed(&goals)).then_some(*step)
            }
            _ => None,
        };
        let asked_for = transition.condition.reads.iter().filter_map(asked_for);
        transition.sources.iter().copied().and(asked_for).collect()
    }

    pub(super) fn is_forced(&self, step: StepId) -> bool {
        let listed = |order: &ForceOrder| matches!(order, ForceOrder::Steps(steps) if steps.contains(&step));
        self.model.forces.values().any(|force| listed(&force.order))
    }

    /// Whether a search can end with the step active: something activates it, and nothing of what leaves it clears then.
    fn can_rest(&self, step: StepId) -> bool {
        if !self.reachable[step.index()] {
            return false;
        }
        let own = &self.model.steps[step];
        if own.linked || self.is_forced(step) {
            return true;
        }
        let alone = Set::from([step]);
        let first = Node {
            active: alone.clone(),
            just_entered: alone.clone(),
            before: alone,
            goals: Vec::new(),
            parent: None,
            cleared: Vec::new(),
        };
        let starts = own.initial.then_some(first);
        let entered = self.model.entering[step.index()].iter().filter_map(|id| self.entry(*id));
        starts.into_iter().and(entered).any(|node| {
            let view = View::new(self, &node);
            // A convergence waits for steps of which nothing is known here.
            let enabled = self.model.leaving[step.index()]
                .iter()
                .filter(|id| self.model.transitions[**id].sources.iter().all(|source| node.active.contains(source)));
            let stay = enabled.map(|id| (Rc::new(view.condition(*id)), false));
            let goals: Goals = node.goals.iter().cloned().and(stay).list();
            !self.logic.impossible(&borrowed(&goals))
        })
    }
}

/// The steps that can be reached if `can_clear` is right.
pub(super) fn reachable(model: &Model, can_clear: impl Fn(TransitionId) -> bool) -> Vec<bool> {
    let mut reachable = vec![false; model.steps.len()];
    let mut waits: Vec<usize> = model.transitions.values().map(|transition| transition.sources.len()).list();
    let mut work: Vec<StepId> = Vec::new();
    for (id, step) in model.steps.iter() {
        let forced = |order: &ForceOrder| matches!(order, ForceOrder::Steps(steps) if steps.contains(&id));
        if step.initial || step.linked || model.forces.values().any(|force| forced(&force.order)) {
            work.push(id);
        }
    }
    for (id, transition) in model.transitions.iter() {
        if transition.sources.is_empty() && can_clear(id) {
            work.extend(&transition.targets);
        }
    }
    while let Some(step) = work.pop() {
        if std::mem::replace(&mut reachable[step.index()], true) {
            continue;
        }
        for id in &model.leaving[step.index()] {
            waits[id.index()] -= 1;
            if waits[id.index()] == 0 && can_clear(*id) {
                work.extend(&model.transitions[*id].targets);
            }
        }
    }
    reachable
}
