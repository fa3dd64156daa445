//! `grafcet`: partial grafcets from the top of the hierarchy to its bottom, enclosures, forcing (A11-A19, A21).

use std::collections::{BTreeMap, BTreeSet};

use super::Evolution;
use super::any;
use super::value::Error;
use super::view::Situation;
use grafcet_compiler::model::{AnyId, Force, ForceOrder, Model, Partial, PartialId, StepId, TransitionId};

/// All partial grafcets, each after those that enclose or may force it.
pub(super) fn top_down(model: &Model) -> Result<Vec<PartialId>, Error> {
    let mut order = Vec::new();
    for id in model.partials.ids() {
        visit(id, model, &mut order, &mut Vec::new())?;
    }
    Ok(order)
}

fn visit(id: PartialId, model: &Model, order: &mut Vec<PartialId>, path: &mut Vec<PartialId>) -> Result<(), Error> {
    if order.contains(&id) {
        return Ok(());
    }
    if path.contains(&id) {
        let name = model.partials[id].name.as_ref().map_or_else(|| "the chart".to_owned(), ToString::to_string);
        return Err(Error::Circle(name));
    }
    path.push(id);
    let enclosing = model.partials[id].enclosed_by.into_iter();
    let forcing = model.orders_on(id).map(|force| force.step);
    for step in enclosing.chain(forcing) {
        visit(model.steps[step].partial, model, order, path)?;
    }
    path.pop();
    order.push(id);
    Ok(())
}

/// A18, A21: the steps activated at start.
///
/// Partial grafcets start in their initial steps; those in an initial enclosing step too, in the initial steps inside. An order of
/// an initial step forces from the start (A11), and what it forces is entered as later (A15). Reading chosen: `{*}` at start
/// holds the initial steps, since `new()` shows them before any order could hold something else.
pub(super) fn initial_situation(model: &Model) -> Result<Situation, Error> {
    let mut situation = Situation::new();
    // Partial grafcets that an order put where they are: enclosures below them are entered by their links.
    let mut forced = BTreeSet::new();
    for id in top_down(model)? {
        let partial = &model.partials[id];
        let outer = partial.enclosed_by.map(|step| (step, model.steps[step].partial));
        let steps = match (order_for(id, &situation, model), outer) {
            (Some(ForceOrder::Steps(steps)), _) => {
                forced.insert(id);
                steps.clone()
            }
            (Some(ForceOrder::Init), _) => {
                forced.insert(id);
                initial_steps(partial, model)
            }
            (_, Some((step, _))) if !situation.contains(&step) => Vec::new(),
            (_, Some((_, outer))) if forced.contains(&outer) => {
                forced.insert(id);
                linked_steps(partial, model)
            }
            _ => initial_steps(partial, model),
        };
        situation.extend(steps);
    }
    Ok(situation)
}

/// One evolution of the whole chart, whose situation before and fireable transitions (rule 4) are known. Those that the
/// hierarchy stops do not clear.
pub(super) fn evolve(evolution: &mut Evolution, anys: &BTreeMap<PartialId, AnyId>, model: &Model) -> Result<(), Error> {
    for id in top_down(model)? {
        let partial = &model.partials[id];
        let before = &evolution.before;
        let here: Situation = partial.steps.iter().copied().filter(|step| before.contains(step)).collect();
        let after = match forced_to(partial, id, &here, before, &evolution.after, model) {
            Some(after) => after,
            None => {
                let after = clear(id, &here, &evolution.fireable, model, &mut evolution.cleared);
                // What an `any` leaves, whatever transitions the model has for it.
                let left = anys.get(&id).map(|any| any::sources(*any, model)).unwrap_or_default();
                let targets = anys.get(&id).map(|any| any::targets(*any, model)).unwrap_or_default();
                after.difference(&left).copied().chain(targets).collect()
            }
        };
        evolution.after.extend(after);
    }
    Ok(())
}

/// Rule 5: `X' = (X − sources(F)) ∪ targets(F)`, activation wins.
fn clear(
    id: PartialId,
    here: &Situation,
    fireable: &BTreeSet<TransitionId>,
    model: &Model,
    cleared: &mut BTreeSet<TransitionId>,
) -> Situation {
    let mut left = Situation::new();
    let mut targets = Situation::new();
    for transition in fireable.iter().filter(|t| model.transitions[**t].partial == id) {
        cleared.insert(*transition);
        left.extend(&model.transitions[*transition].sources);
        targets.extend(&model.transitions[*transition].targets);
    }
    here.difference(&left).chain(&targets).copied().collect()
}

/// The situation that the hierarchy above imposes on a partial grafcet, which then clears nothing; `None` where it is free.
///
/// `above` is the situation after the evolution of everything above it.
fn forced_to(
    partial: &Partial,
    id: PartialId,
    here: &Situation,
    before: &Situation,
    above: &Situation,
    model: &Model,
) -> Option<Situation> {
    // A11, A13: an order of a step that is active after the evolution overwrites the situation in this very evolution.
    match order_for(id, above, model) {
        Some(ForceOrder::Steps(steps)) => return Some(steps.iter().copied().collect()),
        Some(ForceOrder::Init) => return Some(initial_steps(partial, model).into_iter().collect()),
        Some(ForceOrder::Hold) => return Some(here.clone()),
        None => {}
    }
    let enclosing = partial.enclosed_by?;
    match (before.contains(&enclosing), above.contains(&enclosing)) {
        // A19: the enclosing step that is left wins over what is inside.
        (_, false) => Some(Situation::new()),
        (false, true) => Some(linked_steps(partial, model).into_iter().collect()),
        (true, true) => None,
    }
}

/// The order that a situation gives to a partial grafcet. A14 leaves at most one; the last in the source otherwise.
fn order_for<'m>(target: PartialId, situation: &Situation, model: &'m Model) -> Option<&'m ForceOrder> {
    let gives = |force: &&Force| force.target == target && situation.contains(&force.step);
    model.forces.values().rev().find(gives).map(|force| &force.order)
}

/// Whether neither an order nor a step that encloses it keeps a partial grafcet from clearing (A13, A17).
pub(super) fn is_free(id: PartialId, situation: &Situation, model: &Model) -> bool {
    let enclosing = model.partials[id].enclosed_by;
    order_for(id, situation, model).is_none() && enclosing.is_none_or(|step| situation.contains(&step))
}

/// A17: whether the transition is enabled: all its source steps are active and so is the enclosing step. What an active step
/// forces is frozen, also in the evolution in which the order ends (A13).
pub(super) fn is_enabled(id: TransitionId, situation: &Situation, model: &Model) -> bool {
    let transition = &model.transitions[id];
    is_free(transition.partial, situation, model) && transition.sources.iter().all(|step| situation.contains(step))
}

fn initial_steps(partial: &Partial, model: &Model) -> Vec<StepId> {
    partial.steps.iter().copied().filter(|step| model.steps[*step].initial).collect()
}

fn linked_steps(partial: &Partial, model: &Model) -> Vec<StepId> {
    partial.steps.iter().copied().filter(|step| model.steps[*step].linked).collect()
}
