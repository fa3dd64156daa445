//! What the form of flip-flops can say, and this one cannot.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Association, Effect, Id, Model, Place, Qualifier, StepId};

use super::order;
use crate::Refused;
use crate::st::action::{Role, Written, role, shared_calls};

/// All of it.
pub(super) fn refused(model: &Model, written: &BTreeMap<Place, Written>) -> Vec<Refused> {
    let mut refused = Vec::new();
    shared_calls(model, &mut refused);
    for transition in model.transitions.values() {
        if transition.sources.len() != 1 || transition.targets.len() != 1 {
            let message =
                "the CASE form has one number for the active step: use the form of flip-flops for parallel branches";
            refused.push(Refused::at(transition.mark, message));
        }
    }
    for (place, how) in written {
        let stored_in_sfc = !model.is_grafcet() && how.set_or_reset && how.otherwise;
        if how.continuous && (how.set_or_reset || how.otherwise) || stored_in_sfc {
            let name = model.place_name(*place);
            let message = format!(
                "`{name}` is acted on in two ways, which the CASE form cannot tell apart: use the form of flip-flops"
            );
            refused.push(Refused::at(name.into(), message));
        }
    }
    for association in model.associations.values() {
        if let Some(message) = too_much(model, association) {
            refused.push(Refused::at(association.mark, format!("{message}: use the form of flip-flops")));
        }
    }
    if refused.is_empty() {
        order::refused(model, written, &mut refused);
    }
    refused
}

fn too_much(model: &Model, association: &Association) -> Option<String> {
    use Qualifier::{D, L};
    let sfc = !model.is_grafcet();
    let word = association.qualifier.word();
    let others = || model.associations.values().filter(|other| !std::ptr::eq(*other, association));
    match (association.qualifier, &association.effect) {
        (qualifier, _) if qualifier.has_time() && qualifier.has_flip_flop() => {
            Some(format!("what `{word}` does outlives its step, which the CASE form has no place for"))
        }
        (qualifier, effect)
            if qualifier != Qualifier::N
                && !matches!(effect, Effect::Control(_))
                && role(model, association).ok() == Some(Role::Body) =>
        {
            Some(format!(
                "`{word}` of what runs has a time or a pulse of its own, which the CASE form has no place for"
            ))
        }
        (L | D, _) if sfc && association.condition.is_some() => Some(format!(
            "in an `sfc` the time of `{word}` runs with the condition, and the CASE form has the time of the step alone"
        )),
        (L | D, Effect::Control(place)) if sfc => {
            let near = |other: &&Association| {
                let timed =
                    matches!(other.qualifier, L | D) && matches!(&other.effect, Effect::Control(at) if at == place);
                timed && (other.step == association.step || follows(model, association.step, other.step))
            };
            others().any(|other| near(&other)).then(|| format!("two steps one after the other share the time of `{word}`, and the CASE form has the time of the step alone"))
        }
        (_, Effect::Assign(place, _)) if role(model, association).ok() == Some(Role::Continuous(*place)) => {
            let twice = others().any(|other| other.step == association.step && other.effect.writes().contains(place));
            twice.then(|| format!("`{}` has two values in one step", model.place_name(*place)))
        }
        (Qualifier::N, Effect::Call(action, _)) => {
            let next = |other: &Association| {
                matches!(other.effect, Effect::Call(same, _) if same == *action)
                    && follows(model, association.step, other.step)
            };
            let name = &model.actions[*action].name;
            if sfc && follows(model, association.step, association.step) {
                return Some(format!(
                    "`{name}` goes on where its step is entered anew, and the program would begin it"
                ));
            }
            if others().any(next) {
                return Some(format!("two steps one after the other call `{name}`, which goes on between them"));
            }
            association.condition.is_some().then(|| format!("whether `{name}` has begun depends on a condition"))
        }
        (Qualifier::N, Effect::Block(_) | Effect::Assign(Place::Var(_), _)) if association.condition.is_some() => {
            Some("its last run depends on a condition".to_owned())
        }
        _ => None,
    }
}

/// Whether a transition leads from one to the other, in either direction.
fn follows(model: &Model, a: StepId, b: StepId) -> bool {
    let leads = |from: StepId, to: StepId| {
        model.leaving[from.index()].iter().any(|id| model.transitions[*id].targets.contains(&to))
    };
    leads(a, b) || leads(b, a)
}
