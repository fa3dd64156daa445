//! Every name in the generated code.
//!
//! Hygiene keeps our locals from the user's, but a `let` or a parameter that is called like a constant, a static, or a variant that a `use`
//! brings in is a pattern of that, whoever wrote it. So what generated code binds ends with an underscore (`inputs_`), which no
//! item of a program does; fields, which are no patterns, do not.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

use crate::list::List;
use crate::model::{
    ActionId, AnyId, AssociationId, DelayId, EdgeId, Effect, Id, MacroId, Model, OutputId, Place, Qualifier, StepId,
    Transition, TransitionId, VarId,
};
use crate::place::{self, quote};
use crate::plan::{Plan, RegionId, Target};
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

/// The state of a region before the evolution; that of all, where they are bits.
pub(super) fn before(region: RegionId, plan: &Plan<'_>) -> Ident {
    state("before", region, plan)
}

/// The state of a region after the evolution; that of all, where they are bits.
pub(super) fn after(region: RegionId, plan: &Plan<'_>) -> Ident {
    state("after", region, plan)
}

fn state(name: &str, region: RegionId, plan: &Plan<'_>) -> Ident {
    if plan.regions.are_flags() { local(name) } else { local(&numbered(name, name, region, plan)) }
}

/// Whether a step of the region was left and entered again in one evolution.
pub(super) fn again(region: RegionId, plan: &Plan<'_>) -> Ident {
    local(&numbered("again", "again", region, plan))
}

fn numbered(single: &str, many: &str, region: RegionId, plan: &Plan<'_>) -> String {
    match plan.regions.all().len() {
        1 => single.to_owned(),
        _ => format!("{many}_{region}"),
    }
}

/// The field that remembers an output, or its value of the last cycle.
pub(super) fn output_field(model: &Model, output: OutputId) -> Ident {
    own_of("out_", &model.outputs[output].name)
}

/// The field that remembers what an output was in the cycle before, only because it is read.
pub(super) fn output_last_field(model: &Model, output: OutputId) -> Ident {
    own_of("out_last_", &model.outputs[output].name)
}

/// The field of a variable.
pub(super) fn var_field(model: &Model, var: VarId) -> Ident {
    own_of("var_", &model.vars[var].name)
}

/// The field of the outputs to be returned.
pub(super) fn output_local(model: &Model, output: OutputId) -> TokenStream {
    let name = &model.outputs[output].name;
    quote!(outputs_.#name)
}

/// The local with the value of an output before the actions of this cycle.
pub(super) fn output_last(model: &Model, output: OutputId) -> Ident {
    prefixed("last_", &model.outputs[output].name)
}

/// The local that says that an active step resets a target in this cycle.
pub(super) fn output_reset(model: &Model, output: OutputId) -> Ident {
    prefixed("reset_", &model.outputs[output].name)
}

/// The field that counts the time of a region's active step.
pub(super) fn step_time(region: RegionId, plan: &Plan<'_>) -> Ident {
    own(&numbered("since", "since", region, plan))
}

/// The time of the step that was active before the evolution.
pub(super) fn step_time_before(region: RegionId, plan: &Plan<'_>) -> Ident {
    local(&numbered("since_before", "since_before", region, plan))
}

/// The field that counts the time of a macro-step.
pub(super) fn macro_time(id: MacroId) -> Ident {
    own(&format!("macro_since_{}", id.index()))
}

/// The field that counts how far something that blinks is in its period.
pub(super) fn phase(index: usize) -> Ident {
    own(&format!("phase_{index}"))
}

/// What it was before the evolution.
pub(super) fn phase_before(index: usize) -> Ident {
    local(&format!("phase_before_{index}"))
}

/// The local that says that an `any` has cleared in this evolution.
pub(super) fn any_cleared(any: AnyId) -> Ident {
    local(&format!("any_cleared_{}", any.index()))
}

/// The field that remembers the expression of an edge.
pub(super) fn edge_field(id: EdgeId) -> Ident {
    own(&format!("edge_{}", id.index()))
}

/// The local that keeps what an edge compares with.
pub(super) fn edge_kept(id: EdgeId) -> Ident {
    local(&format!("edge_before_{}", id.index()))
}

/// The local that holds whether an edge is there, rising or falling.
pub(super) fn edge_local(id: EdgeId, rising: bool) -> Ident {
    local(&format!("{}_now_{}", if rising { "rising" } else { "falling" }, id.index()))
}

/// The field and the local of an edge that is sampled after the evolution.
pub(super) fn late_edge(id: EdgeId, side: Option<bool>) -> Ident {
    let late = format!("late_{}", id.index());
    side.map_or_else(
        || own(&late),
        |rising| local(&format!("{}_now_{late}", if rising { "rising" } else { "falling" })),
    )
}

/// The field of a delay.
pub(super) fn delay_field(id: DelayId) -> Ident {
    own(&format!("delay_{}", id.index()))
}

/// The local that says that a step which is both left and kept shall be active.
pub(super) fn enter_local(step: StepId) -> Ident {
    local(&format!("enter_{}", step.index()))
}

/// The local that says that a step has been left by a transition of higher priority.
pub(super) fn left_local(step: StepId) -> Ident {
    local(&format!("left_{}", step.index()))
}

/// The local that says that one of the branches beside an `else` has cleared.
pub(super) fn other_branch(otherwise: TransitionId) -> Ident {
    local(&format!("other_branch_{}", otherwise.index()))
}

/// The local that collects the value of a stored place during an evolution.
pub(super) fn collected(model: &Model, place: Place) -> Ident {
    prefixed("next_", model.place_name(place))
}

/// The local with the value of a combinational variable.
pub(super) fn combinational(model: &Model, var: VarId) -> Ident {
    prefixed("is_", &model.vars[var].name)
}

/// The local that says whether the condition of an assigned output held before the first action ran.
pub(super) fn holds(id: AssociationId) -> Ident {
    local(&format!("holds_{}", id.index()))
}

/// The field of a place.
pub(super) fn place_field(model: &Model, place: Place) -> Ident {
    match place {
        Place::Output(id) => output_field(model, id),
        Place::Var(id) => var_field(model, id),
    }
}

/// The field that says whether an action was called continuously in the cycle before.
pub(super) fn called(model: &Model, action: ActionId) -> Ident {
    own_of("called_", &model.actions[action].name)
}

/// The field that remembers which association called an action last.
pub(super) fn called_number(model: &Model, action: ActionId) -> Ident {
    own_of("association_", &model.actions[action].name)
}

/// The local that says that a call on an event or a clearing is due.
pub(super) fn due(kind: &str, index: usize) -> Ident {
    local(&format!("due_{kind}_{index}"))
}

/// A field that belongs to a target of the action control: `timer_flag_l_heat`.
pub(super) fn target(prefix: &str, model: &Model, index: usize, target: &Target) -> Ident {
    let first = target.associations.first().map(|id| &model.associations[*id].effect);
    match first {
        Some(Effect::Control(place)) => own_of(&format!("{prefix}_"), model.place_name(*place)),
        Some(Effect::Call(action, _)) => own_of(&format!("{prefix}_"), &model.actions[*action].name),
        Some(Effect::Assign(place, _)) => own_of(&format!("{prefix}_{index}_"), model.place_name(*place)),
        _ => own(&format!("{prefix}_{index}")),
    }
}

/// A local that belongs to such a target: `flag_n_heat_`.
pub(super) fn target_local(prefix: &str, model: &Model, index: usize, of: &Target) -> Ident {
    local(&target(prefix, model, index, of).to_string())
}

/// The prefix of a target's flag for a qualifier: `flag_sd`.
pub(super) fn flag(qualifier: Qualifier) -> String {
    format!("flag_{}", qualifier.word().to_lowercase())
}

/// The number of an association among those of its target, as it is remembered.
pub(super) fn association_number(target: &Target, id: AssociationId) -> Literal {
    Literal::usize_unsuffixed(target.associations.iter().position(|other| *other == id).unwrap_or_default())
}

/// The prefix of the field for the condition of an association in the cycle before.
pub(super) fn held(target: &Target, id: AssociationId) -> String {
    format!("held_{}", association_number(target, id))
}

/// The type in which a number below `count` is remembered.
pub(super) fn number_type(count: usize, p: &TokenStream) -> TokenStream {
    match count {
        0..=256 => quote!(#p::u8),
        _ => quote!(#p::u16),
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
