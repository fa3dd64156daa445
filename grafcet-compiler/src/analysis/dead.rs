//! What never happens: transitions that never clear, steps that are never active, and what of that follows from what.

use super::Facts;
use super::explore::Exploration;
use crate::list::{List, PushAll};
use crate::model::{Blinker, ForceOrder, Id, Model, Name, Read, StepId, Transition, TransitionId};
use crate::sorted::Set;

/// What never happens in a chart.
pub(crate) struct Dead<'m> {
    model: &'m Model,
    exploration: &'m Exploration,
    facts: &'m Facts<'m>,
    /// The transitions that never clear although each of their sources can be active.
    pub(crate) idle: Set<TransitionId>,
    /// The steps that are never active.
    pub(crate) lost: Vec<StepId>,
    /// By step: arrows lead to it from where the chart starts, whatever the conditions.
    drawn: Vec<bool>,
}

/// What is explained: of it, or of what it follows from, something was said.
#[derive(Default)]
pub(crate) struct Explained {
    pub(crate) steps: Set<StepId>,
    pub(crate) transitions: Set<TransitionId>,
}

impl<'m> Dead<'m> {
    /// What the exploration has found.
    pub(crate) fn of(model: &'m Model, facts: &'m Facts<'m>, exploration: &'m Exploration) -> Self {
        let lost = model.steps.ids().filter(|step| !exploration.reachable(*step)).list();
        let drawn = drawn(model, &facts.initial);
        Self { model, exploration, facts, idle: idle(model, exploration), lost, drawn }
    }

    /// Whether arrows lead to a step from where the chart starts, whatever the conditions.
    pub(crate) fn is_drawn(&self, step: StepId) -> bool {
        self.drawn[step.index()]
    }

    /// Of a step that is never active: a transition to it that could clear, if not something else always came first.
    pub(crate) fn beaten(&self, step: StepId, said: &Set<TransitionId>) -> Option<&'m Transition> {
        let open = |id: TransitionId| {
            let sources = &self.model.transitions[id].sources;
            !self.idle.contains(&id)
                && !said.contains(&id)
                && sources.iter().all(|source| self.exploration.reachable(*source))
        };
        let first = self.model.entering[step.index()].iter().find(|id| open(**id));
        first.map(|id| &self.model.transitions[*id])
    }

    /// The idle transitions that only wait for steps to which other dead ones lead, `said` among them.
    pub(crate) fn follow_ups(&self, said: &Set<TransitionId>) -> Set<TransitionId> {
        let mut follow = self.waiting_for_others();
        let is_barred = |id: &&TransitionId| self.exploration.is_barred(**id);
        if !said.is_empty() && self.idle.iter().any(|id| is_barred(&id)) {
            let otherwise = self.facts.assumed.across_partials_from(self.model, &self.facts.initial, said);
            follow.extend(self.idle.iter().filter(is_barred).filter(|id| otherwise.can_clear(**id)));
        }
        follow
    }

    fn waiting_for_others(&self) -> Set<TransitionId> {
        let model = self.model;
        let mut open: Vec<(TransitionId, Vec<StepId>)> = self.idle.iter().map(|id| (*id, self.waits_for(*id))).list();
        let mut waiting = vec![false; model.transitions.len()];
        for (id, _) in open.iter().filter(|(_, waits)| !waits.is_empty()) {
            waiting[id.index()] = true;
        }
        let mut following = vec![false; model.steps.len()];
        let mut follow = Set::new();
        let causes = open.iter().filter(|(_, waits)| waits.is_empty());
        let mut work: Vec<StepId> = causes.flat(|(id, _)| model.transitions[*id].targets.iter().copied()).list();
        // Of steps to which no arrow leads it has been said.
        work.push_all(model.steps.ids().filter(|step| !self.is_drawn(*step)));
        while !work.is_empty() {
            while let Some(step) = work.pop() {
                if !std::mem::replace(&mut following[step.index()], true) {
                    // What waits itself leads on only where it follows.
                    let onward = model.leaving[step.index()].iter().filter(|id| !waiting[id.index()]);
                    work.extend(onward.flat(|id| &model.transitions[*id].targets));
                }
            }
            open.retain(|(id, waits)| {
                let follows = waits.iter().any(|step| following[step.index()]);
                if follows {
                    follow.insert(*id);
                    waiting[id.index()] = false;
                    work.extend(&model.transitions[*id].targets);
                }
                !follows
            });
        }
        follow
    }

    /// The steps that are never active and that the condition of a transition reads.
    pub(crate) fn waits_for(&self, id: TransitionId) -> Vec<StepId> {
        let mut steps = Vec::new();
        for read in &self.model.transitions[id].condition.reads {
            match read.about() {
                Some(Blinker::Step(step)) => steps.push(step),
                Some(Blinker::Macro(id)) => steps.extend(&self.model.macros[id].steps),
                None => {}
            }
        }
        steps.retain(|step| !self.exploration.reachable(*step));
        steps
    }

    /// What of a kind with a cause is to be named first: it does not wait for steps that are never active.
    pub(crate) fn cause(&self, explained: &Explained) -> Option<TransitionId> {
        let open = |id: &&TransitionId| !explained.transitions.contains(id);
        let cause = self.idle.iter().filter(open).find(|id| self.waits_for(**id).is_empty());
        cause.or_else(|| self.idle.iter().find(open)).copied()
    }

    /// Adds what follows from what is explained.
    pub(crate) fn explain(&self, explained: &mut Explained) {
        let mut changed = true;
        while changed {
            changed = false;
            for step in &self.lost {
                if !explained.steps.contains(step) && self.step_follows(*step, explained) {
                    changed |= explained.steps.insert(*step);
                }
            }
            for id in &self.idle {
                if !explained.transitions.contains(id) && self.transition_follows(*id, explained) {
                    changed |= explained.transitions.insert(*id);
                }
            }
        }
    }

    fn step_follows(&self, step: StepId, explained: &Explained) -> bool {
        let partial = self.model.steps[step].partial;
        let around = self.model.partials[partial].enclosed_by;
        around.is_some_and(|outer| explained.steps.contains(&outer))
            || self.model.orders_on(partial).any(|force| explained.steps.contains(&force.step))
            || self.model.entering[step.index()].iter().any(|id| {
                explained.transitions.contains(id)
                    || self.model.transitions[*id].sources.iter().any(|source| explained.steps.contains(source))
            })
    }

    fn transition_follows(&self, id: TransitionId, explained: &Explained) -> bool {
        if self.waits_for(id).iter().any(|step| explained.steps.contains(step)) {
            return true;
        }
        // It could clear, as it is drawn, if something else did of which it was said that it never does.
        let depends = self.exploration.is_barred(id) || !self.exploration.is_enabled(id) || self.reads_steps(id);
        depends && self.facts.assumed.can_clear(id) && !explained.transitions.is_empty()
    }

    fn reads_steps(&self, id: TransitionId) -> bool {
        let reads = self.model.transitions[id].condition.reads.iter();
        reads.into_iter().any(|read| !matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_)))
    }
}

/// The transitions that never clear although their sources can be active.
fn idle(model: &Model, exploration: &Exploration) -> Set<TransitionId> {
    let is_idle = |(id, transition): &(TransitionId, &Transition)| {
        !exploration.can_clear(*id) && transition.sources.iter().all(|source| exploration.reachable(*source))
    };
    // An `any` is idle where all of its transitions are.
    let mut clears = vec![false; model.anys.len()];
    for (id, transition) in model.transitions.iter() {
        if let Some(any) = transition.any {
            clears[any.index()] |= exploration.can_clear(id);
        }
    }
    let alone = |(_, transition): &(TransitionId, &Transition)| transition.any.is_none_or(|any| !clears[any.index()]);
    model.transitions.iter().filter(is_idle).filter(alone).map(|(id, _)| id).collect()
}

/// The steps to which arrows lead from where the chart starts, whatever the conditions.
fn drawn(model: &Model, initial: &Set<StepId>) -> Vec<bool> {
    let mut drawn = vec![false; model.steps.len()];
    let mut work: Vec<StepId> = initial.iter().copied().list();
    work.push_all(model.steps.iter().filter(|(_, step)| step.linked).map(|(id, _)| id));
    for force in model.forces.values() {
        match &force.order {
            ForceOrder::Hold => {}
            ForceOrder::Steps(steps) => work.extend(steps),
            ForceOrder::Init => {
                let steps = model.partials[force.target].steps.iter();
                work.extend(steps.filter(|step| model.steps[**step].initial));
            }
        }
    }
    let mut missing: Vec<usize> = model.transitions.values().map(|transition| transition.sources.len()).list();
    for transition in model.transitions.values() {
        if transition.sources.is_empty() {
            work.extend(&transition.targets);
        }
    }
    while let Some(step) = work.pop() {
        if std::mem::replace(&mut drawn[step.index()], true) {
            continue;
        }
        for id in &model.leaving[step.index()] {
            missing[id.index()] -= 1;
            if missing[id.index()] == 0 {
                work.extend(&model.transitions[*id].targets);
            }
        }
    }
    drawn
}
