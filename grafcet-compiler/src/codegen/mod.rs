//! The generated code: one file per artefact. After the gates nothing can fail: model and plan in, tokens out.

mod bind;
mod chart_impl;
mod cleared;
mod deadline;
mod derives;
mod description;
mod editor;
mod encoding;
mod force;
mod late;
mod machine;
mod meaning;
mod names;
mod outside;
mod program;
mod recipe;
mod record;
mod requirements;
mod rust;
mod state;
mod stub;
mod types;
mod variants;
mod writes;

use proc_macro2::TokenStream;

use self::machine::Machine;
use self::names::Names;
use crate::analysis::{Facts, Situations};
use crate::held::Held;
use crate::model::Model;
use crate::place::{self, quote};
use crate::plan::Plan;
use crate::program::Refused;
#[cfg(feature = "program")]
use crate::program::{
    Program,
    passes::{self, Pass},
};
pub(crate) use stub::stub;

/// Everything the artefacts are written from.
struct Cx<'m> {
    model: &'m Model,
    plan: &'m Plan<'m>,
    names: Names,
    /// The facade's hidden module, by absolute path.
    p: TokenStream,
}

/// The items of a chart; with its number also what a recorder needs to know of it.
pub(crate) fn generate(
    (model, facts, plan): (&Model, &Facts<'_>, &Plan<'_>),
    root: &TokenStream,
    fingerprint: Option<u32>,
) -> TokenStream {
    let cx = Cx::new(model, plan, root);
    let machine = match &plan.program {
        Ok(program) => program::machine(&cx, program),
        Err(refused) => return refuse(refused),
    };
    let (items, forced) = (items(&cx, &machine), force::all(&cx, &machine, || facts.situations(model)));
    let recorded = fingerprint.map(|fingerprint| {
        let is_looked_at = !cx.is_alone() && Situations::are_stored(model);
        let situations = if is_looked_at { facts.situations(model) } else { &Situations::Unknown };
        record::all(&cx, &machine, situations, fingerprint)
    });
    quote!(#items #recorded #forced)
}

/// What the fields of the chart's state hold, by their names; of a chart that is recorded.
pub(crate) fn meanings(model: &Model, plan: &Plan<'_>, root: &TokenStream) -> Vec<(String, Held)> {
    let cx = Cx::new(model, plan, root);
    match &plan.program {
        Ok(program) => program::meanings(&cx, program),
        Err(_) => Vec::new(),
    }
}

/// The items of a chart by a program that somebody else has made of it, without what observers are told.
#[cfg(feature = "program")]
pub(crate) fn print(program: Result<Program<'_>, Refused>, plan: &Plan<'_>, root: &TokenStream) -> TokenStream {
    match program {
        Ok(mut program) => {
            passes::optimise(&mut program, &[Pass::Marks]);
            let cx = Cx::new(program.model, plan, root);
            items(&cx, &program::machine(&cx, &program))
        }
        Err(refused) => refuse(&refused),
    }
}

/// The attribute of what holds Rust of the user that may never come back; none where nothing of it can.
fn unreached(model: &Model) -> Option<TokenStream> {
    model.may_be_endless().then(|| quote!(#[allow(unreachable_code, clippy::diverging_sub_expression)]))
}

/// A chart that has passed the checks is never refused.
fn refuse(refused: &Refused) -> TokenStream {
    let refused = refused.to_string();
    quote!(::core::compile_error!(#refused);)
}

impl<'m> Cx<'m> {
    fn new(model: &'m Model, plan: &'m Plan<'m>, root: &TokenStream) -> Self {
        let root = place::moved(root);
        Self { model, plan, names: Names::of(model), p: quote!(#root::__private) }
    }

    /// One region whose state is an enum has one active step by itself; bits may be set for several.
    fn is_alone(&self) -> bool {
        self.plan.one_step && !self.model.flags
    }
}

fn items(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let types = types::all(cx);
    let recipe = recipe::all(cx);
    let description::Said { drawing, items: description } = description::all(cx);
    let (states, state) = (&machine.types, state::chart(cx, machine, &drawing));
    let chart = chart_impl::inherent(cx, machine);
    let uniform = chart_impl::uniform(cx);
    let mentions = editor::mentions(cx.model, &cx.names, &cx.p);
    let variants = variants::all(cx);
    let vars = outside::vars(cx, machine);
    // The chart comes first: of two charts with one name that is what rustc complains of first.
    quote!(#state #types #variants #recipe #states #chart #vars #uniform #description #mentions)
}
