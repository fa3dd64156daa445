//! Every name in the generated code.

use proc_macro2::{Ident, Span};
use quote::format_ident;

use crate::model::{Id, Model, OutputId, StepId, Transition, TransitionId, VarId};
use crate::plan::{Plan, RegionId};

/// The names of one chart's items.
pub(super) struct Names {
    /// `Motor`
    pub(super) chart: Ident,
    /// `MotorInputs`
    pub(super) inputs: Ident,
    /// `MotorOutputs`
    pub(super) outputs: Ident,
    /// `MotorStep`
    pub(super) step: Ident,
    /// `MotorTransition`
    pub(super) transition: Ident,
    /// `MotorSituation`, where the situation is more than one step.
    pub(super) situation: Ident,
    /// The variant of a region's state for "none of its steps is active".
    pub(super) empty: Ident,
    /// The variant of the first region's state for "the first cycle is still to come".
    pub(super) start: Ident,
    transitions: Vec<Ident>,
}

impl Names {
    pub(super) fn of(model: &Model) -> Self {
        let chart = &model.name;
        let with = |suffix: &str| format_ident!("{chart}{suffix}");
        Self {
            chart: chart.clone(),
            inputs: with("Inputs"),
            outputs: with("Outputs"),
            step: with("Step"),
            transition: with("Transition"),
            situation: with("Situation"),
            empty: fresh(model, "NONE"),
            start: local("INIT"),
            transitions: transitions(model),
        }
    }

    /// The private enum of a region's steps.
    pub(super) fn region(&self, region: RegionId, plan: &Plan) -> Ident {
        let chart = &self.chart;
        let name = match plan.regions.all().len() {
            1 => format!("__{chart}State"),
            _ => format!("__{chart}Region{region}"),
        };
        Ident::new(&name.replace("r#", ""), Span::mixed_site().located_at(chart.span()))
    }

    /// The variant of a transition in `MotorTransition`.
    pub(super) fn transition_variant(&self, id: TransitionId) -> &Ident {
        &self.transitions[id.index()]
    }
}

/// The field that holds the state of a region.
pub(super) fn region_field(region: RegionId, plan: &Plan) -> Ident {
    numbered("situation", "region", region, plan)
}

/// The state of a region before the evolution.
pub(super) fn before(region: RegionId, plan: &Plan) -> Ident {
    numbered("before", "before", region, plan)
}

/// The state of a region after the evolution.
pub(super) fn after(region: RegionId, plan: &Plan) -> Ident {
    numbered("after", "after", region, plan)
}

/// Whether a step of the region was left and entered again in one evolution.
pub(super) fn again(region: RegionId, plan: &Plan) -> Ident {
    numbered("again", "again", region, plan)
}

fn numbered(single: &str, many: &str, region: RegionId, plan: &Plan) -> Ident {
    match plan.regions.all().len() {
        1 => local(single),
        _ => local(&format!("{many}_{region}")),
    }
}

/// The field that remembers an output, or its value of the last cycle.
pub(super) fn output_field(model: &Model, output: OutputId) -> Ident {
    prefixed("out_", &model.outputs[output].name)
}

/// The field of a variable.
pub(super) fn var_field(model: &Model, var: VarId) -> Ident {
    prefixed("var_", &model.vars[var].name)
}

/// The local that collects the value of an output in this cycle.
pub(super) fn output_local(model: &Model, output: OutputId) -> Ident {
    prefixed("new_", &model.outputs[output].name)
}

/// The local with the value of an output before the actions of this cycle.
pub(super) fn output_last(model: &Model, output: OutputId) -> Ident {
    prefixed("last_", &model.outputs[output].name)
}

/// The local that says that an active step resets a target in this cycle.
pub(super) fn output_reset(model: &Model, output: OutputId) -> Ident {
    prefixed("reset_", &model.outputs[output].name)
}

/// A step as a variant of a private enum.
pub(super) fn private_variant(model: &Model, step: StepId) -> Ident {
    let mut name = model.steps[step].name.clone();
    name.set_span(Span::mixed_site());
    name
}

/// A name of ours that no token of the user can mean.
pub(super) fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

fn prefixed(prefix: &str, name: &Ident) -> Ident {
    local(&format!("{prefix}{}", name.to_string().trim_start_matches("r#")))
}

/// `name`, with underscores behind it until no step is called so.
fn fresh(model: &Model, name: &str) -> Ident {
    let mut name = name.to_owned();
    while model.steps.values().any(|step| step.name == name) {
        name.push('_');
    }
    local(&name)
}

/// `Go` for `-[go: x]->`; else from the steps, `OffToOn`; numbered where that is taken.
fn transitions(model: &Model) -> Vec<Ident> {
    let mut taken = std::collections::BTreeSet::new();
    let mut names = vec![None; model.transitions.len()];
    // The names the user chose come first.
    for (id, transition) in model.transitions.iter() {
        if let Some(name) = &transition.name {
            let camel = camel(&name.to_string());
            if taken.insert(camel.clone()) {
                names[id.index()] = Some(Ident::new(&camel, name.span()));
            }
        }
    }
    for (id, transition) in model.transitions.iter() {
        if names[id.index()].is_some() {
            continue;
        }
        let base = from_steps(model, transition);
        let mut name = base.clone();
        let mut number = 2;
        while !taken.insert(name.clone()) {
            name = format!("{base}{number}");
            number += 1;
        }
        names[id.index()] = Some(Ident::new(&name, transition.mark.start));
    }
    names.into_iter().flatten().collect()
}

fn from_steps(model: &Model, transition: &Transition) -> String {
    let list = |steps: &[StepId], none: &str| {
        if steps.is_empty() {
            return none.to_owned();
        }
        let names: Vec<_> = steps.iter().map(|step| camel(&model.steps[*step].name.to_string())).collect();
        names.join("And")
    };
    format!("{}To{}", list(&transition.sources, "Source"), list(&transition.targets, "Sink"))
}

/// `warm_up` is `WarmUp`.
fn camel(name: &str) -> String {
    let words = name.trim_start_matches("r#").split('_').filter(|word| !word.is_empty());
    let mut camel: String = words
        .map(|word| {
            let mut chars = word.chars();
            chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
        })
        .collect();
    if !camel.starts_with(char::is_alphabetic) {
        camel.insert(0, 'T');
    }
    if camel == "Self" { "Self_".to_owned() } else { camel }
}
