//! `any -[stop]-> Stopped`: read from the chart's text, not from the conditions that the compiler made of it.
//!
//! "From every step of its net but the targets, enabled while a step that is no target is active. It comes before all other
//! transitions of its net: in an evolution in which it clears, nothing else of that net clears, all that is active there is left,
//! the targets are entered. Several: in source order. `except` leaves steps out." What is left out stays active, and so does an active
//! target.

use std::collections::{BTreeMap, BTreeSet};

use super::value::Error;
use super::view::{Situation, View};
use grafcet_compiler::model::{AnyId, Model, PartialId, StepId, TransitionId, Tree};

/// For each net the `any` that clears; `is_free` says whether the hierarchy lets a net clear anything.
pub(super) fn clearing(
    view: &View<'_>,
    is_free: impl Fn(PartialId) -> bool,
) -> Result<BTreeMap<PartialId, AnyId>, Error> {
    let mut clearing = BTreeMap::new();
    for (id, any) in view.model.anys.iter() {
        let enabled = sources(id, view.model).iter().any(|step| view.situation.contains(step));
        let first = !clearing.contains_key(&any.partial);
        if enabled && first && is_free(any.partial) && view.holds(condition(any.first, view.model))? {
            clearing.insert(any.partial, id);
        }
    }
    Ok(clearing)
}

/// Whether the `any` that clears in its net, if one does, lets this transition clear.
pub(super) fn lets(clearing: &BTreeMap<PartialId, AnyId>, id: TransitionId, model: &Model) -> bool {
    let transition = &model.transitions[id];
    match clearing.get(&transition.partial) {
        Some(any) => transition.any == Some(*any),
        // One that stands for an `any` clears with it alone.
        None => transition.any.is_none(),
    }
}

/// Whether the `any` that clears in its net leaves one of the steps of this transition.
pub(super) fn leaves(clearing: &BTreeMap<PartialId, AnyId>, id: TransitionId, model: &Model) -> bool {
    let transition = &model.transitions[id];
    let left = clearing.get(&transition.partial).map(|any| sources(*any, model)).unwrap_or_default();
    transition.sources.iter().any(|step| left.contains(step))
}

/// What is written in the brackets.
pub(super) fn condition(id: TransitionId, model: &Model) -> &Tree {
    model.transitions[id].own_condition()
}

/// The steps it stands for: all of its net but the targets and what is left out, of macro-steps with their expansions.
pub(super) fn sources(id: AnyId, model: &Model) -> Situation {
    let any = &model.anys[id];
    let mut out: BTreeSet<StepId> = targets(id, model);
    for expansion in model.macros.values() {
        if any.except.contains(&expansion.name) || out.contains(&expansion.entry) {
            out.extend(&expansion.steps);
        }
    }
    let steps = model.partials[any.partial].steps.iter().copied();
    steps.filter(|step| !out.contains(step) && !any.except.contains(&model.steps[*step].name)).collect()
}

/// The steps it enters.
pub(super) fn targets(id: AnyId, model: &Model) -> Situation {
    model.transitions[model.anys[id].first].targets.iter().copied().collect()
}
