//! Which partial grafcets act on which, and the initial situation that follows from it.

use crate::list::{List, PushAll};
use crate::model::{ForceOrder, Model, PartialId, StepId};
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
