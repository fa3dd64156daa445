//! Which steps have transitions that exclude each other, and which may be left and entered at once.

use super::{Concurrency, Logic};
use crate::list::List;
use crate::model::{Id, Model, StepId, TransitionId};
use crate::sorted::Set;

/// Per step, whether at most one of its transitions can clear at a time: by priority in an `sfc`, by their conditions in a `grafcet`.
pub(super) fn exclusive(model: &Model) -> Vec<bool> {
    let logic = Logic::new(model);
    let all_exclude = |ids: &Vec<TransitionId>| {
        let conditions: Vec<_> = ids.iter().map(|id| logic.condition(&model.transitions[*id].condition.tree)).list();
        let all: Vec<_> = ids.iter().zip(&conditions).list();
        let exclude = |(a, first): (&TransitionId, _), (b, second): (&TransitionId, _)| {
            model.exclude_each_other(*a, *b) || logic.exclusive(first, second)
        };
        all.iter().enumerate().all(|(i, a)| all[i + 1..].iter().all(|b| exclude(*a, *b)))
    };
    model.leaving.iter().map(|transitions| !model.is_grafcet() || all_exclude(transitions)).list()
}

/// Steps that one transition may take away while another gives them back: activation wins (rule 5 of IEC 60848).
pub(super) fn left_and_entered(model: &Model, concurrency: &Concurrency, exclusive: &[bool]) -> Set<StepId> {
    let kept = model.transitions.values().flat(|transition| {
        let overlapping = |step: &&StepId| transition.sources.contains(step) && !exclusive[step.index()];
        transition.targets.iter().filter(overlapping)
    });
    let entered_twice = model.steps.ids().filter(|step| concurrency.activated_while_active(*step));
    entered_twice.and(kept.copied()).collect()
}
