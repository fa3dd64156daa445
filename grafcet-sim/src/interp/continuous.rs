//! `grafcet`: continuous actions (A9, A10, A32, A35) and combinational variables (A22).

use super::value::{Error, Value};
use super::view::View;
use grafcet_compiler::model::{Association, AssociationId, Effect, Model, OutputId, Place, VarId};

/// Whether the association is a continuous action: N, and L and D by A32.
pub(super) fn is_continuous(association: &Association) -> bool {
    association.qualifier.is_continuous()
}

/// The continuous associations of a place in a `grafcet`, in source order.
pub(super) fn associations_of(model: &Model, place: Place) -> impl DoubleEndedIterator<Item = AssociationId> {
    let of_place = move |association: &Association| match association.effect {
        Effect::Control(at) | Effect::Assign(at, _) => at == place,
        Effect::Call(..) | Effect::Block(_) => false,
    };
    let grafcet = model.is_grafcet();
    let found = model.associations.iter().filter(move |(_, a)| grafcet && is_continuous(a) && of_place(a));
    found.map(|(id, _)| id)
}

/// A22: whether a variable of a `grafcet` is asserted by continuous actions.
#[must_use]
pub fn is_combinational(model: &Model, var: VarId) -> bool {
    associations_of(model, Place::Var(var)).next().is_some()
}

/// A22: in each evolution the OR over its associations on the situation of that evolution.
pub(super) fn combinational(var: VarId, view: &View<'_>) -> Result<bool, Error> {
    for id in associations_of(view.model, Place::Var(var)) {
        if asserts(&view.model.associations[id], view)? {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Whether the step is active and the condition holds. A32: `L t q` is `q if !(t/Step)`, `D t q` is `q if t/Step`.
pub(super) fn asserts(association: &Association, view: &View<'_>) -> Result<bool, Error> {
    if !view.situation.contains(&association.step) {
        return Ok(false);
    }
    if let Some(time) = association.time {
        let elapsed = view.elapsed(time, association.step)?;
        if elapsed == (association.qualifier.limits()) {
            return Ok(false);
        }
    }
    association.condition.as_ref().map_or(Ok(true), |condition| view.holds(&condition.tree))
}

/// The value of a continuous output on the stable situation (A9): the OR of its associations (A10), or the value assigned
/// while one is active and the initial one otherwise (A35). `None` for an output without continuous actions.
///
/// Where several active associations assign, the last in the source wins, as in A31; the standard forbids the case
/// (`conflicting_values`).
pub(super) fn output(id: OutputId, initial: Value, view: &View<'_>) -> Result<Option<Value>, Error> {
    let place = Place::Output(id);
    let mut found = false;
    for id in associations_of(view.model, place).rev() {
        found = true;
        let association = &view.model.associations[id];
        if !asserts(association, view)? {
            continue;
        }
        return match &association.effect {
            Effect::Assign(_, value) => view.value_for(place, &value.tree).map(Some),
            _ => Ok(Some(Value::Bool(true))),
        };
    }
    Ok(found.then_some(initial))
}
