//! Every name in the generated code.
//!
//! Hygiene keeps our locals from the user's, but a `let` or a parameter that is called like a constant, a static, or a variant that a `use`
//! brings in is a pattern of that, whoever wrote it. So what generated code binds ends with an underscore (`inputs_`), which no
//! item of a program does; fields, which are no patterns, do not.

use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

use crate::list::List;
use crate::model::{Id, Model, StepId, Transition, TransitionId};
use crate::place::{self, quote};
use crate::plan::Plan;
use crate::program::RegionId;
use crate::sorted::Set;

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
    /// `MotorParams`
    pub(super) params: Ident,
    /// `MotorActions`
    pub(super) actions: Ident,
    /// The variant of a region's state for "none of its steps is active".
    pub(super) empty: Ident,
    /// The variant of the first region's state for "the first cycle is still to come".
    pub(super) start: Ident,
    transitions: Vec<Ident>,
}

impl Names {
    pub(super) fn of(model: &Model) -> Self {
        let chart = &model.name;
        let with = |suffix: &str| format_ident!("{chart}{suffix}", span = place::here());
        let steps: Set<String> = model.steps.values().map(|step| step.name.to_string()).collect();
        Self {
            chart: chart.clone(),
            inputs: with("Inputs"),
            outputs: with("Outputs"),
            step: with("Step"),
            transition: with("Transition"),
            situation: with("Situation"),
            params: with("Params"),
            actions: with("Actions"),
            empty: unused(&steps, "NONE"),
            start: own("INIT"),
            transitions: transitions(model),
        }
    }

    /// The private enum of a region's steps.
    pub(super) fn region(&self, region: RegionId, plan: &Plan<'_>) -> Ident {
        let chart = &self.chart;
        let name = match plan.regions.all().len() {
            1 => format!("__{chart}State"),
            _ => format!("__{chart}Region{region}"),
        };
        Ident::new(&name.replace("r#", ""), place::mixed().located_at(chart.span()))
    }

    /// The first region's state together with the mark of an unstable search.
    pub(super) fn marked(&self, plan: &Plan<'_>) -> Ident {
        format_ident!("{}Mark", self.region(0, plan))
    }

    /// The variant of a transition in `MotorTransition`.
    pub(super) fn transition_variant(&self, id: TransitionId) -> &Ident {
        &self.transitions[id.index()]
    }
}

/// The field that holds the state of a region.
pub(super) fn region_field(region: RegionId, plan: &Plan<'_>) -> Ident {
    own(&numbered("situation", "region", region, plan))
}

/// The same where it is a local of a cycle, or the method that tells it (`encoding flags;`).
pub(super) fn region_local(region: RegionId, plan: &Plan<'_>) -> Ident {
    local(&numbered("situation", "region", region, plan))
}

/// What that local began with.
pub(super) fn before(region: RegionId, plan: &Plan<'_>) -> Ident {
    local(&numbered("before", "before", region, plan))
}

fn numbered(single: &str, many: &str, region: RegionId, plan: &Plan<'_>) -> String {
    match plan.regions.all().len() {
        1 => single.to_owned(),
        _ => format!("{many}_{region}"),
    }
}

/// A step as a variant of a private enum.
pub(super) fn private_variant(model: &Model, step: StepId) -> Ident {
    let mut name = model.steps[step].name.clone();
    name.set_span(place::mixed());
    name
}

/// Whether a block has written a place: `written_speed`.
pub(super) fn written(name: &Ident) -> Ident {
    prefixed("written_", name)
}

/// A local or a parameter: no token of the user can mean it, and it means no item of the user.
pub(super) fn local(name: &str) -> Ident {
    own(&format!("{name}_"))
}

/// A parameter of a public function: documentation shows it without the underscore. What the user wrote reads the inputs by the name of theirs.
pub(super) fn parameter(name: &str, ty: &TokenStream) -> TokenStream {
    let (bound, shown) = (Ident::new(&format!("{name}_"), place::here()), Ident::new(name, place::here()));
    quote!(#[cfg(not(doc))] #bound: #ty, #[cfg(doc)] #shown: #ty)
}

/// The same name in the body of a function that documentation evaluates, as it does with `const fn`.
pub(super) fn bound_in_const(name: &str) -> TokenStream {
    let (bound, shown) = (Ident::new(&format!("{name}_"), place::here()), Ident::new(name, place::here()));
    quote!(#[cfg(doc)] let #bound = #shown;)
}

/// Any other name of ours: a field, a function, a variant.
pub(super) fn own(name: &str) -> Ident {
    Ident::new(name, place::mixed())
}

fn prefixed(prefix: &str, name: &Ident) -> Ident {
    local(own_of(prefix, name).to_string().as_str())
}

fn own_of(prefix: &str, name: &Ident) -> Ident {
    own(&format!("{prefix}{}", name.to_string().trim_start_matches("r#")))
}

/// `name`, with underscores after it until no step is called so.
fn unused(steps: &Set<String>, name: &str) -> Ident {
    let mut name = name.to_owned();
    while steps.contains(&name) {
        name.push('_');
    }
    own(&name)
}

/// `Go` for `-[go: x]->`; else from the steps, `OffToOn`; numbered where that is taken.
fn transitions(model: &Model) -> Vec<Ident> {
    let mut taken = Set::new();
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
        if let Some(first) = transition.any.map(|any| model.anys[any].first).filter(|first| *first != id) {
            let name = names[first.index()].clone();
            names[id.index()] = name;
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
    names.into_iter().flatten().list()
}

fn from_steps(model: &Model, transition: &Transition) -> String {
    let list = |steps: &[StepId], none: &str| {
        if steps.is_empty() {
            return none.to_owned();
        }
        let names: Vec<_> = steps.iter().map(|step| camel(&model.steps[*step].name.to_string())).list();
        names.join("And")
    };
    let sources = if transition.any.is_some() { "Any".to_owned() } else { list(&transition.sources, "Source") };
    format!("{sources}To{}", list(&transition.targets, "Sink"))
}

/// `warm_up` is `WarmUp`.
fn camel(name: &str) -> String {
    let words = name.trim_start_matches("r#").split('_').filter(|word| !word.is_empty());
    let mut camel: String = words
        .map(|word| {
            let mut chars = word.chars();
            chars.next().map_or_else(String::new, |first| first.to_uppercase().and(chars).collect())
        })
        .collect();
    if !camel.starts_with(char::is_alphabetic) {
        camel.insert(0, 'T');
    }
    if camel == "Self" { "Self_".to_owned() } else { camel }
}
