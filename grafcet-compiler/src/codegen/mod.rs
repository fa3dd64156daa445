//! The generated code: one file per artefact. After the gates nothing can fail: model and plan in, tokens out.

mod acting;
mod apart;
mod bind;
mod branches;
mod chart_impl;
mod control;
mod cycle;
mod deadline;
mod derives;
mod description;
mod editor;
mod encoding;
mod evolution;
mod grafcet;
mod hierarchy;
mod late;
mod long;
mod machine;
mod names;
mod nest;
mod outputs;
mod outside;
#[cfg(feature = "program")]
mod program;
mod recipe;
mod record;
mod requirements;
mod rust;
mod segments;
mod sfc;
mod situation;
mod state;
mod stored;
mod stub;
mod time;
mod types;
mod variants;
mod walk;
mod writes;

use proc_macro2::TokenStream;

use self::machine::Machine;
use self::names::Names;
use crate::analysis::{Facts, Together};
use crate::model::Model;
use crate::place::{self, quote};
use crate::plan::Plan;
#[cfg(feature = "program")]
use crate::program::Program;
pub(crate) use stub::stub;

/// Everything the artefacts are written from.
struct Cx<'m> {
    model: &'m Model,
    plan: &'m Plan,
    names: Names,
    /// The facade's hidden module, by absolute path.
    p: TokenStream,
}

/// The items of a chart.
pub(crate) fn generate(model: &Model, plan: &Plan, root: &TokenStream) -> TokenStream {
    let cx = Cx::new(model, plan, root);
    items(&cx, &Machine::planned(&cx))
}

/// The same, and what a recorder needs to know of the chart.
pub(crate) fn generate_recorded(
    (model, facts, plan): (&Model, &Facts<'_>, &Plan),
    root: &TokenStream,
    fingerprint: u32,
) -> TokenStream {
    let cx = Cx::new(model, plan, root);
    let machine = Machine::planned(&cx);
    // One region whose state is an enum has one active step, or none, by itself.
    let by_itself = plan.regions.is_single() && !plan.shape.is_flags();
    let together = if by_itself { Together::default() } else { Together::of(model, facts) };
    let (items, recorded) = (items(&cx, &machine), record::all(&cx, &machine, &together, fingerprint));
    quote!(#items #recorded)
}

/// The items of a chart whose cycle is a program.
#[cfg(feature = "program")]
pub(crate) fn print(program: &Program<'_>, plan: &Plan, root: &TokenStream) -> TokenStream {
    let cx = Cx::new(program.model, plan, root);
    items(&cx, &program::machine(&cx, program))
}

impl<'m> Cx<'m> {
    fn new(model: &'m Model, plan: &'m Plan, root: &TokenStream) -> Self {
        let root = place::moved(root);
        Self { model, plan, names: Names::of(model), p: quote!(#root::__private) }
    }
}

fn items(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let types = types::all(cx);
    let recipe = recipe::all(cx);
    let (states, state) = (&machine.types, state::chart(cx, machine));
    let chart = chart_impl::inherent(cx, machine);
    let uniform = chart_impl::uniform(cx);
    let description = description::all(cx);
    let mentions = editor::mentions(cx.model, &cx.names, &cx.p);
    let variants = variants::all(cx);
    let vars = outside::vars(cx, machine);
    quote!(#types #variants #recipe #states #state #chart #vars #uniform #description #mentions)
}
