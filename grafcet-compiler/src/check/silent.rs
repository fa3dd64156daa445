//! What is dead and of which nobody has said anything yet.
//!
//! The other rules leave out what follows from something else. Here it is made sure that this something was said: what is dead
//! is explained by a transition or a step of which something was said, step by step backwards. What is not explained so, as where
//! two things wait for each other, is said.

use super::reach;
use crate::analysis::Concurrency;
use crate::analysis::explore::Exploration;
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::List;
use crate::model::{Model, Read, StepId, TransitionId};
use crate::sorted::Set;

/// Of what something was said, whether or not the chart wants to see it.
#[derive(Default)]
pub(super) struct Told {
    pub(super) steps: Set<StepId>,
    pub(super) transitions: Set<TransitionId>,
}

pub(super) struct Silent<'m> {
    pub(super) model: &'m Model,
    pub(super) structure: &'m Concurrency,
    pub(super) exploration: &'m Exploration,
}

impl Silent<'_> {
    /// Says what is dead and not explained, one cause after the other.
    pub(super) fn check(&self, mut told: Told, sink: &mut Sink) {
        let idle = reach::idle(self.model, self.exploration);
        let lost: Vec<StepId> = self.model.steps.ids().filter(|step| !self.exploration.reachable(*step)).list();
        if idle.is_empty() && lost.is_empty() {
            return;
        }
        self.explain(&idle, &lost, &mut told);
        loop {
            let open = |id: &&TransitionId| !told.transitions.contains(id);
            // First what does not wait for steps that are never active.
            let waits = |id: &&TransitionId| !self.waits_for(**id).is_empty();
            let cause = idle.iter().filter(open).find(|id| !waits(id)).or_else(|| idle.iter().find(open));
            if let Some(id) = cause {
                reach::dead_transition(self.model, self.exploration, *id, sink);
                // What leaves every step is one arrow to its author.
                let same = |other: &&TransitionId| {
                    let any = self.model.transitions[**other].any;
                    any.is_some() && any == self.model.transitions[*id].any
                };
                told.transitions.extend(idle.iter().filter(same));
                told.transitions.insert(*id);
            } else if let Some(step) = lost.iter().find(|step| !told.steps.contains(step)) {
                let name = &self.model.steps[*step].name;
                let message = format!("step `{name}` is never active: nothing that leads to it ever happens");
                let notes = vec![(Mark::from(name), message)];
                sink.rule(&rules::UNREACHABLE_STEP, &self.model.levels_of(&self.model.steps[*step]), notes);
                told.steps.insert(*step);
            } else {
                return;
            }
            self.explain(&idle, &lost, &mut told);
        }
    }

    /// Adds what follows from what was said.
    fn explain(&self, idle: &Set<TransitionId>, lost: &[StepId], told: &mut Told) {
        let mut changed = true;
        while changed {
            changed = false;
            for step in lost {
                if !told.steps.contains(step) && self.step_follows(*step, told) {
                    changed |= told.steps.insert(*step);
                }
            }
            for id in idle {
                if !told.transitions.contains(id) && self.transition_follows(*id, told) {
                    changed |= told.transitions.insert(*id);
                }
            }
        }
    }

    fn step_follows(&self, step: StepId, told: &Told) -> bool {
        let entering = self.model.transitions.iter().filter(|(_, transition)| transition.targets.contains(&step));
        let around = self.model.partials[self.model.steps[step].partial].enclosed_by;
        let forced = |force: &crate::model::Force| force.target == self.model.steps[step].partial;
        around.is_some_and(|outer| told.steps.contains(&outer))
            || self.model.forces.values().any(|force| forced(force) && told.steps.contains(&force.step))
            || entering.into_iter().any(|(id, transition)| {
                told.transitions.contains(&id) || transition.sources.iter().any(|source| told.steps.contains(source))
            })
    }

    fn transition_follows(&self, id: TransitionId, told: &Told) -> bool {
        if self.waits_for(id).iter().any(|step| told.steps.contains(step)) {
            return true;
        }
        // It could clear, as it is drawn, if something else did of which it was said that it never does.
        let depends = self.exploration.is_barred(id) || !self.exploration.is_enabled(id) || self.reads_steps(id);
        depends && self.structure.can_clear(id) && !told.transitions.is_empty()
    }

    fn reads_steps(&self, id: TransitionId) -> bool {
        let reads = self.model.transitions[id].condition.reads.iter();
        reads.into_iter().any(|read| {
            !matches!(read, Read::Name(crate::model::Name::Input(_) | crate::model::Name::Param(_)) | Read::Ticks(_))
        })
    }

    /// The steps that are never active and that its condition reads.
    fn waits_for(&self, id: TransitionId) -> Vec<StepId> {
        reach::read_steps(self.model, id).filter(|step| !self.exploration.reachable(*step)).list()
    }
}
