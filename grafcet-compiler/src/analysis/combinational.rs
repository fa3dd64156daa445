//! Boolean variables of a `grafcet` that continuous actions assert: they hold no value of their own (A22).

use crate::model::{Association, Effect, Model, Name, Place, Qualifier, Read, VarId};
use crate::sorted::Set;

/// The combinational variables, each behind those it reads; those on a circle, which is refused, come last.
#[must_use]
pub fn in_order(model: &Model) -> Vec<VarId> {
    if !model.is_grafcet() {
        return Vec::new();
    }
    let mut waiting: Vec<VarId> = model.vars.ids().filter(|var| asserted(model, *var).next().is_some()).collect();
    let mut order = Vec::new();
    loop {
        let ready = |var: &VarId| reads(model, *var).iter().all(|other| !waiting.contains(other));
        let Some(next) = waiting.iter().position(ready) else { break };
        order.push(waiting.remove(next));
    }
    order.extend(waiting);
    order
}

/// The continuous actions that assert a variable.
pub fn asserted(model: &Model, var: VarId) -> impl Iterator<Item = &Association> {
    model.associations.values().filter(move |association| {
        matches!(association.qualifier, Qualifier::N | Qualifier::L | Qualifier::D)
            && matches!(association.effect, Effect::Control(Place::Var(place)) if place == var)
    })
}

/// The variables that the conditions of a combinational variable read, through edges and delays too.
#[must_use]
pub fn reads(model: &Model, var: VarId) -> Set<VarId> {
    let mut found = Set::new();
    for condition in asserted(model, var).filter_map(|association| association.condition.as_ref()) {
        for read in &condition.reads {
            if let Read::Name(Name::Var(other)) = read {
                found.insert(*other);
            }
        }
    }
    found
}
