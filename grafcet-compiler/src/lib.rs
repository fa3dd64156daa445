//! The compiler of `grafcet!` as an ordinary library.
//!
//! Tokens become an [`ast`], names are resolved into a [`model`], [`analysis`] finds facts about it, [`check`]
//! turns them into [`diagnostic`]s, [`program`] makes its cycle a program and `codegen` prints that as Rust.

pub mod analysis;
pub mod ast;
pub mod check;
mod codegen;
pub mod describe;
pub mod diagnostic;
pub mod fingerprint;
pub mod held;
mod list;
mod mark;
mod methods;
pub mod model;
pub mod parse;
mod place;
mod plan;
pub mod plant;
pub mod program;
mod qualifier;
mod quoted;
mod raw;
mod similar;
pub mod sorted;
mod visit;

use crate::list::{List, PushAll};

use proc_macro2::TokenStream;

use analysis::{Facts, Prover};
use diagnostic::{Diagnostic, Sink};
use model::Model;
use plan::Plan;

/// What is wanted of a compilation beside the usual.
#[derive(Clone, Copy, Default)]
pub struct Wanted<'p> {
    /// What the flight recorder needs to know of the chart: the macro's feature `record`.
    pub recorded: bool,
    /// Who decides the properties that the checker leaves open: the macro's feature `prove`.
    pub prover: Option<&'p Prover>,
}

/// Compiles the tokens of one macro call.
///
/// `root` is the path of the facade crate in the generated code, e.g. `::grafcet`. The result is always valid Rust:
/// where the chart has mistakes, it holds their messages and the chart's types with empty bodies.
#[must_use]
pub fn compile(root: &TokenStream, chart: TokenStream) -> TokenStream {
    compile_with(root, chart, Wanted::default())
}

/// The same with more than the usual.
#[must_use]
pub fn compile_with(root: &TokenStream, chart: TokenStream, wanted: Wanted<'_>) -> TokenStream {
    let Some(call) = plant::Call::of(&chart) else { return alone(chart, root, wanted).tokens(root) };
    let compiled = alone(chart, root, wanted);
    let sound = compiled.sound;
    let mut tokens = compiled.tokens(root);
    tokens.extend(plants(&call, sound, root, wanted).0);
    tokens
}

/// What [`compile_with`] says of one macro call, as data for tools: the chart first, then its plants and what is claimed with
/// them. `wanted.recorded` has no part in it.
#[must_use]
pub fn diagnose(chart: TokenStream, wanted: Wanted<'_>) -> Vec<Diagnostic> {
    // As far as a chart is compiled before its code is written, which says nothing more.
    let root = place::quote!(::grafcet);
    let call = plant::Call::of(&chart);
    let compiled = by(chart, &root, wanted, &|_| TokenStream::new());
    let mut messages = compiled.messages;
    messages.push_all(call.into_iter().flat(|call| plants(&call, compiled.sound, &root, wanted).1));
    messages
}

/// What is made of one chart.
pub(crate) struct Compiled {
    pub(crate) messages: Vec<Diagnostic>,
    /// The chart's types, or their stub.
    items: TokenStream,
    /// Nothing is wrong with it.
    pub(crate) sound: bool,
}

impl Compiled {
    /// The messages, and the items after them.
    pub(crate) fn tokens(self, root: &TokenStream) -> TokenStream {
        let mut tokens = diagnostic::tokens(&self.messages, root);
        tokens.extend(self.items);
        tokens
    }
}

/// The plants of a call as tokens, and what is said of them.
fn plants(call: &plant::Call, sound: bool, root: &TokenStream, wanted: Wanted<'_>) -> (TokenStream, Vec<Diagnostic>) {
    let compile = |plant: TokenStream| alone(plant, root, Wanted::default());
    plant::items(call, sound, wanted.prover, root, &compile)
}

/// A chart without its plants.
fn alone(chart: TokenStream, root: &TokenStream, wanted: Wanted<'_>) -> Compiled {
    let fingerprint = wanted.recorded.then(|| fingerprint::of(&chart));
    let generate = |sound: &Sound<'_, '_>| {
        codegen::generate((sound.model, sound.facts, &sound.plan(wanted.recorded)), root, fingerprint)
    };
    by(chart, root, wanted, &generate)
}

/// What the fields of the state hold that a recorded chart has, by their names in its code; empty where it has mistakes.
#[must_use]
pub fn meanings(root: &TokenStream, chart: TokenStream) -> Vec<(String, held::Held)> {
    let found = std::cell::RefCell::new(Vec::new());
    let wanted = Wanted { recorded: true, ..Wanted::default() };
    let look = |sound: &Sound<'_, '_>| {
        *found.borrow_mut() = codegen::meanings(sound.model, &sound.plan(wanted.recorded), root);
        TokenStream::new()
    };
    by(chart, root, wanted, &look);
    found.into_inner()
}

/// The same by way of a program, which `lower` makes of the chart: a third opinion for tests and tools.
#[cfg(feature = "program")]
#[must_use]
pub fn compile_program(root: &TokenStream, chart: TokenStream, lower: Lower) -> TokenStream {
    let print = |sound: &Sound<'_, '_>| codegen::print(lower(sound.model, sound.facts), &sound.plan(false), root);
    by(chart, root, Wanted::default(), &print).tokens(root)
}

/// From the model to a program, such as the naive one.
#[cfg(feature = "program")]
pub type Lower = for<'m> fn(&'m Model, &Facts<'_>) -> Result<program::Program<'m>, program::Refused>;

/// A chart in which nothing is wrong.
struct Sound<'s, 'm> {
    model: &'m Model,
    facts: &'s Facts<'m>,
}

impl<'m> Sound<'_, 'm> {
    /// What its code will look like, of one that is `recorded` or not. Who only looks for mistakes asks for none.
    fn plan(&self, recorded: bool) -> Plan<'m> {
        Plan::of(self.model, self.facts, recorded)
    }
}

/// What all have in common; `generate` writes the items of a chart in which nothing is wrong.
fn by(
    chart: TokenStream,
    root: &TokenStream,
    wanted: Wanted<'_>,
    generate: &dyn Fn(&Sound<'_, '_>) -> TokenStream,
) -> Compiled {
    let mut sink = Sink::new();
    let written = plant::chart_of(&chart);
    let Some(chart) = parse::chart(chart, &mut sink) else {
        return Compiled { messages: sink.finish(), items: TokenStream::new(), sound: false };
    };
    let _keyword = place::AtKeyword::at(chart.keyword);
    let model = model::resolve(&chart, &mut sink);
    check::drawing(&model, &mut sink);
    let complete = !chart.incomplete && !model.incomplete;
    let facts = (complete && sink.leaves_evolution()).then(|| Facts::of(&model));
    let sound = facts.as_ref().and_then(|facts| {
        check::evolution(&model, facts, wanted.prover, &mut sink);
        if !sink.has_more_than_claims() {
            check::initial_values(&model, &mut sink);
        }
        (!sink.has_more_than_claims()).then_some(Sound { model: &model, facts })
    });
    let items = match sound {
        Some(sound) => generate(&sound),
        // What could not be read may be where the time is used.
        _ => {
            let timed = model.uses_time() || chart.incomplete && parse::mentions_time(written);
            codegen::stub(&model, timed, wanted.recorded, root)
        }
    };
    let sound = !sink.has_errors();
    Compiled { messages: sink.finish(), items, sound }
}
