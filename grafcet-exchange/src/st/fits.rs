//! What structured text of these forms cannot say.

use grafcet_compiler::analysis::{Facts, combinational};
use grafcet_compiler::diagnostic::Mark;
use grafcet_compiler::model::{Model, Name, Place, StepId, Ty};

use super::{Form, expr};
use crate::Refused;

/// All of it, in the order of the chart.
pub(super) fn refused(model: &Model, form: Form) -> Vec<Refused> {
    let mut refused = Vec::new();
    if form == Form::Case {
        hierarchy(model, &mut refused);
        partials(model, &mut refused);
        loose(model, &mut refused);
        following(model, &mut refused);
    }
    types(model, true, &mut refused);
    if refused.is_empty() && form == Form::Case {
        refused.extend(several(model));
    }
    refused
}

/// What one part of the chart does to another.
fn hierarchy(model: &Model, refused: &mut Vec<Refused>) {
    for step in model.steps.values().filter(|step| !step.encloses.is_empty()) {
        let why =
            "enclosing steps have no translation into the CASE form of structured text: use the form of flip-flops";
        refused.push(Refused::at((&step.name).into(), why));
    }
    for force in model.forces.values() {
        let why =
            "forcing orders have no translation into the CASE form of structured text: use the form of flip-flops";
        refused.push(Refused::at(force.mark, why));
    }
}

/// Nets that stand beside each other.
fn partials(model: &Model, refused: &mut Vec<Refused>) {
    for partial in model.partials.values().filter(|partial| partial.enclosed_by.is_none()) {
        if let Some(name) = &partial.name {
            let why = "partial grafcets have no translation into the CASE form of structured text: use the form of flip-flops, or export a chart of one net";
            refused.push(Refused::at(name.into(), why));
        }
    }
}

/// Transitions without a step in front of them or after them.
fn loose(model: &Model, refused: &mut Vec<Refused>) {
    for transition in model.transitions.values() {
        if transition.sources.is_empty() || transition.targets.is_empty() {
            let why = "source and sink transitions have no translation into the CASE form of structured text: use the form of flip-flops, or give it a step at both ends";
            refused.push(Refused::at(transition.mark, why));
        }
    }
}

/// `listed`: whether lists of variants can be numbers.
pub(crate) fn types(model: &Model, listed: bool, refused: &mut Vec<Refused>) {
    let mut all: Vec<Name> = model.inputs.ids().map(Name::Input).collect();
    all.extend(model.params.ids().map(Name::Param));
    all.extend(model.outputs.ids().map(Name::Output));
    all.extend(model.vars.ids().map(Name::Var));
    for name in all {
        if expr::kind(model.ty(name)).is_none() && !(listed && model.variants_of(name).is_some()) {
            let ident = model.value_name(name);
            if !listed && model.variants_of(name).is_some() {
                let message = format!(
                    "`{ident}` is a variant of a list, which structured text has as a number (`cargo grafcet export st`) and SFC has not; use an integer"
                );
                refused.push(Refused::at(ident.into(), message));
                continue;
            }
            let what = match model.ty(name) {
                Ty::Other(_) => "is of a type of the program",
                _ => "is an integer that no PLC has",
            };
            let lists = if listed { ", or a list of variants (`mode: Mode in {Off, Auto}`)" } else { "" };
            let message = format!(
                "`{ident}` {what}, which structured text of these forms does not have; use `bool`, `time`, `f32`, `f64`, an integer of 8 to 64 bits{lists}"
            );
            refused.push(Refused::at(ident.into(), message));
        }
    }
}

/// Variables of a `grafcet` that continuous actions assert.
fn following(model: &Model, refused: &mut Vec<Refused>) {
    for var in combinational::in_order(model) {
        let name = model.place_name(Place::Var(var));
        let message = format!(
            "`{name}` follows the situation within an evolution, which the CASE form of structured text cannot: use the form of flip-flops, make it an output, or set and reset it"
        );
        refused.push(Refused::at(name.into(), message));
    }
}

/// The steps that can be active together, where there are such.
fn several(model: &Model) -> Option<Refused> {
    let facts = Facts::of(model);
    let steps: Vec<StepId> = model.steps.ids().filter(|step| facts.concurrency.reachable(*step)).collect();
    if facts.initial.len() != 1 {
        return Some(Refused::whole(
            "the CASE form has one number for the active step, and here not exactly one is initial: use the form of flip-flops",
        ));
    }
    for (index, a) in steps.iter().enumerate() {
        for b in &steps[index + 1..] {
            if facts.concurrency.together(*a, *b) {
                let (first, second) = (&model.steps[*a].name, &model.steps[*b].name);
                let message = format!(
                    "the CASE form has one number for the active step, and `{first}` and `{second}` can be active together: use the form of flip-flops"
                );
                return Some(Refused::at(Mark::from(first), message));
            }
        }
    }
    None
}

/// What is left out by an `any` stays active beside what it enters, and it comes before all other transitions of the net, not of a step.
pub(crate) fn anys(model: &Model, refused: &mut Vec<Refused>) {
    let parallel = several(model).is_some();
    for any in model.anys.values().filter(|_| parallel) {
        let mark = model.transitions[any.first].mark;
        refused.push(Refused::at(
            mark,
            "`any` beside parallel branches has no translation into structured text: draw its transitions one by one",
        ));
    }
}
