//! Which partial grafcets act on which, and the initial situation that follows from it.

use super::Concurrency;
use crate::list::{List, PushAll};
use crate::model::{ForceId, ForceOrder, Model, PartialId, StepId};
use crate::sorted::Set;

/// The partial grafcets from top to bottom: what forces or encloses comes before what is forced or enclosed. Those on a
/// circle, which is refused, come last.
#[must_use]
pub fn top_down(model: &Model) -> Vec<PartialId> {
    let mut order: Vec<PartialId> = Vec::new();
    let mut waiting: Vec<PartialId> = model.partials.ids().list();
    loop {
        let ready = |id: &PartialId| masters(model, *id).iter().all(|master| order.contains(master));
        let Some(next) = waiting.iter().position(ready) else { break };
        order.push(waiting.remove(next));
    }
    order.push_all(waiting);
    order
}

/// The partial grafcets that act directly on one: those of its enclosing step and of the steps that force it.
#[must_use]
pub fn masters(model: &Model, partial: PartialId) -> Vec<PartialId> {
    let enclosing = model.partials[partial].enclosed_by.into_iter();
    let forcing = model.orders_on(partial).map(|force| force.step);
    enclosing.and(forcing).map(|step| model.steps[step].partial).list()
}

/// Whether one partial grafcet is another or acts on it through forcing orders and enclosing steps.
pub(crate) fn acts_on(model: &Model, from: PartialId, to: PartialId) -> bool {
    let mut seen = vec![to];
    let mut next = 0;
    while let Some(at) = seen.get(next).copied() {
        if at == from {
            return true;
        }
        for master in masters(model, at) {
            if !seen.contains(&master) {
                seen.push(master);
            }
        }
        next += 1;
    }
    false
}

/// The nearest step around one that is not initial.
pub(crate) fn idle_around(model: &Model, step: StepId) -> Option<StepId> {
    let mut at = step;
    while let Some(around) = model.partials[model.steps[at].partial].enclosed_by {
        if !model.steps[around].initial {
            return Some(around);
        }
        at = around;
    }
    None
}

/// A14: two orders that may force one partial grafcet at the same time.
pub(crate) fn rival_orders(model: &Model, concurrency: &Concurrency) -> Vec<(ForceId, ForceId)> {
    let mut found = Vec::new();
    for (a, first) in model.forces.iter() {
        for (b, second) in model.forces.iter().filter(|(b, second)| *b > a && first.target == second.target) {
            if first.step == second.step || concurrency.together(first.step, second.step) {
                found.push((a, b));
            }
        }
    }
    found
}

/// The initial situation: the initial steps, what an initial step forces (A11), and inside an enclosing step that is
/// active at the start its initial steps (A18), or its linked ones where a forcing order has activated it (A15, A21).
#[must_use]
pub fn initial_situation(model: &Model) -> Set<StepId> {
    initial_situation_of(model, &top_down(model))
}

/// The same of partial grafcets from top to bottom.
pub(super) fn initial_situation_of(model: &Model, top_down: &[PartialId]) -> Set<StepId> {
    let mut active = Set::new();
    let mut forced = Set::new();
    for id in top_down.iter().copied() {
        let partial = &model.partials[id];
        let steps = |wanted: fn(&crate::model::Step) -> bool| {
            partial.steps.iter().copied().filter(|step| wanted(&model.steps[*step])).list()
        };
        let order = model.orders_on(id).find(|force| active.contains(&force.step));
        match (order.map(|force| &force.order), partial.enclosed_by) {
            (Some(ForceOrder::Steps(situation)), _) => {
                active.extend(situation.iter().copied());
                forced.insert(id);
            }
            (Some(ForceOrder::Init), _) => {
                active.extend(steps(|step| step.initial));
                forced.insert(id);
            }
            (_, Some(outer)) if !active.contains(&outer) => {}
            (_, Some(outer)) if forced.contains(&model.steps[outer].partial) => {
                active.extend(steps(|step| step.linked));
                forced.insert(id);
            }
            _ => active.extend(steps(|step| step.initial)),
        }
    }
    active
}
