//! Deadlocks in which all wait for each other, since one took what another needs.

use crate::analysis::explore::Deadlock;
use crate::analysis::explore::Exploration;
use crate::analysis::explore::StuckJoin;
use crate::list::List;
use crate::model::{Model, StepId};

impl Exploration {
    /// The deadlocks of this kind.
    #[must_use]
    pub(crate) fn contended(&self, model: &Model) -> Vec<&Deadlock> {
        self.deadlocks().iter().filter(|deadlock| self.is_contended(model, deadlock)).list()
    }

    /// Whether a convergence waits in one of them.
    pub(crate) fn in_contention(&self, model: &Model, stuck: &StuckJoin) -> bool {
        self.contended(model).iter().any(|deadlock| deadlock.steps.contains(&stuck.waiting))
    }

    /// Whether all steps wait in AND-convergences, and one of these misses what another convergence has taken.
    fn is_contended(&self, model: &Model, deadlock: &Deadlock) -> bool {
        let of = |step: StepId| self.stuck_joins().iter().filter(move |stuck| stuck.waiting == step);
        let taken = |stuck: &StuckJoin| {
            let Some(culprit) = stuck.culprit else { return false };
            let (taking, join) = (&model.transitions[culprit].sources, &model.transitions[stuck.join].sources);
            taking.len() > 1 && taking.iter().any(|source| join.contains(source))
        };
        deadlock.steps.iter().all(|step| of(*step).next().is_some())
            && deadlock.steps.iter().any(|step| of(*step).any(taken))
    }
}

/// Those of which no earlier one is a part.
#[must_use]
pub fn smallest<'e>(deadlocks: &[&'e Deadlock]) -> Vec<&'e Deadlock> {
    let mut known: Vec<&Deadlock> = Vec::new();
    for deadlock in deadlocks {
        let more = |other: &&Deadlock| other.steps.iter().all(|step| deadlock.steps.contains(step));
        if !known.iter().any(more) {
            known.push(deadlock);
        }
    }
    known
}
