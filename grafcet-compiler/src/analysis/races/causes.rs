//! What stored actions follow from, and whether two causes can come about in one evolution.

use super::Race;
use crate::list::List;
use crate::model::{ForceOrder, Id, PartialId, StepId, TransitionId};
use crate::sorted::Set;

/// Hierarchies are not deeper than this; a circle in them is refused elsewhere.
const DEPTH: usize = 16;

/// The change of the situation that an action belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum When {
    Entered(StepId),
    Left(StepId),
    /// An event while the step is active, or in an `sfc` in each cycle.
    Active(StepId),
    Cleared(TransitionId),
}

/// What an action follows from.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Cause {
    /// The activation of the initial situation.
    Start,
    Transition(TransitionId),
    /// The step is active.
    While(StepId),
}

impl<'m> Race<'m> {
    /// What activates or deactivates a step: transitions, those that enter or leave the enclosing step, and those that bring a
    /// forcing order.
    pub(super) fn causes(&self, when: When, depth: usize) -> Set<Cause> {
        let transitions = |ids: &[TransitionId]| ids.iter().copied().map(Cause::Transition).collect::<Set<_>>();
        let (step, mut causes) = match when {
            When::Cleared(id) => return Set::from([Cause::Transition(id)]),
            When::Active(step) => return Set::from([Cause::While(step)]),
            When::Entered(step) => (step, transitions(&self.entering[step.index()])),
            When::Left(step) => (step, transitions(&self.leaving[step.index()])),
        };
        if depth == DEPTH {
            return causes;
        }
        let own = &self.model.steps[step];
        let outer = self.model.partials[own.partial].enclosed_by;
        if matches!(when, When::Left(_)) {
            causes.extend(outer.into_iter().flat(|outer| self.causes(When::Left(outer), depth + 1)));
            let empties = self.orders(own.partial).filter(|(_, order)| !self.activates(order, step));
            causes.extend(empties.flat(|(by, _)| self.causes(When::Entered(by), depth + 1)));
            return causes;
        }
        if own.initial && outer.is_none() {
            causes.insert(Cause::Start);
        }
        let link = outer.filter(|_| own.linked);
        causes.extend(link.into_iter().flat(|outer| self.causes(When::Entered(outer), depth + 1)));
        let forced = self.orders(own.partial).filter(|(_, order)| self.activates(order, step));
        causes.extend(forced.flat(|(by, _)| self.causes(When::Entered(by), depth + 1)));
        causes
    }

    /// The steps that force a partial grafcet, and how; holding it changes nothing.
    fn orders(&self, partial: PartialId) -> impl Iterator<Item = (StepId, &'m ForceOrder)> {
        self.model
            .orders_on(partial)
            .map(|force| (force.step, &force.order))
            .filter(|(_, order)| **order != ForceOrder::Hold)
    }

    fn activates(&self, order: &ForceOrder, step: StepId) -> bool {
        match order {
            ForceOrder::Steps(steps) => steps.contains(&step),
            ForceOrder::Init => self.model.steps[step].initial,
            ForceOrder::Hold => false,
        }
    }

    pub(super) fn happen_together(&self, a: Cause, b: Cause) -> bool {
        match (a, b) {
            (Cause::Start, Cause::Start) => true,
            // A37: the activation of the initial situation is an evolution of its own.
            (Cause::Start, _) | (_, Cause::Start) => false,
            (Cause::While(x), Cause::While(y)) => x == y || self.concurrency.together(x, y),
            (Cause::While(step), Cause::Transition(id)) | (Cause::Transition(id), Cause::While(step)) => {
                !self.model.is_grafcet() || self.active_before(id, step)
            }
            (Cause::Transition(x), Cause::Transition(y)) => {
                x == y || self.enabled_together(x, y) && !self.prevents(x, y) && !self.prevents(y, x)
            }
        }
    }

    /// Whether what a transition brings about keeps another from clearing in the same evolution: it leaves or empties what
    /// encloses it (A19), or brings an order on its partial grafcet (A13).
    fn prevents(&self, id: TransitionId, other: TransitionId) -> bool {
        let (clears, mut partial) = (&self.model.transitions[id], self.model.transitions[other].partial);
        let orders = || clears.targets.iter().flat(|step| &self.model.steps[*step].forces);
        let mut orders = orders().map(|id| &self.model.forces[*id]).list();
        if orders.iter().any(|force| force.target == partial) {
            return true;
        }
        orders.retain(|force| force.order != ForceOrder::Hold);
        for _ in 0..DEPTH {
            let Some(outer) = self.model.partials[partial].enclosed_by else { return false };
            partial = self.model.steps[outer].partial;
            let left = clears.sources.contains(&outer) && !clears.targets.contains(&outer);
            if left && !self.is_entered_beside(outer, id)
                || orders.iter().any(|force| force.target == partial && !self.activates(&force.order, outer))
            {
                return true;
            }
        }
        false
    }

    /// Whether another transition can enter the step in the evolution in which this one leaves it: then it stays active, and what it
    /// encloses goes on (A4g, A19).
    fn is_entered_beside(&self, step: StepId, leaving: TransitionId) -> bool {
        self.entering[step.index()].iter().any(|id| *id != leaving && self.enabled_together(*id, leaving))
    }

    /// Whether the transition can clear while the step is active.
    fn active_before(&self, cause: TransitionId, step: StepId) -> bool {
        let sources = &self.model.transitions[cause].sources;
        sources.iter().all(|source| *source == step || self.concurrency.together(*source, step))
    }

    /// Whether the two can clear in one evolution: in an `sfc` one that takes a step away from the other prevents it.
    fn enabled_together(&self, a: TransitionId, b: TransitionId) -> bool {
        let (first, second) = (&self.model.transitions[a], &self.model.transitions[b]);
        let share = |x: &StepId, y: &StepId| x == y && self.model.is_grafcet();
        first
            .sources
            .iter()
            .all(|x| second.sources.iter().all(|y| share(x, y) || x != y && self.concurrency.together(*x, *y)))
    }
}
