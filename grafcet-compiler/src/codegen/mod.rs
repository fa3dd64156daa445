//! The generated code: one file per artefact. Behind the gates nothing can fail: model and plan in, tokens out.

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
mod long;
mod names;
mod nest;
mod outputs;
mod outside;
mod recipe;
mod requirements;
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

use self::names::Names;
use crate::model::Model;
use crate::place::{self, quote};
use crate::plan::Plan;
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
    let root = place::moved(root);
    let (names, p) = (Names::of(model), quote!(#root::__private));
    let cx = Cx { model, plan, names, p };
    let types = types::all(&cx);
    let recipe = recipe::all(&cx);
    let state = state::all(&cx);
    let chart = chart_impl::inherent(&cx);
    let uniform = chart_impl::uniform(&cx);
    let description = description::all(&cx);
    let mentions = editor::mentions(model, &cx.names, &cx.p);
    let variants = variants::all(&cx);
    let vars = outside::vars(&cx);
    quote!(#types #variants #recipe #state #chart #vars #uniform #description #mentions)
}
