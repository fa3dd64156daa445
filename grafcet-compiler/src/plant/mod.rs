//! `plant Cylinder { … }` after the chart of a call: what the machine does on the chart's outputs, for proofs and for the host.
//!
//! A plant is an `sfc` with inputs that nobody drives. So nothing after this room knows of choices:
//!
//! - `call`: the tokens of a call, taken apart
//! - `written`: `either`, `2s..4s/Moving`, `fault` and `choice` become inputs and plain transitions
//! - `wires`: whose outputs are whose inputs
//! - `mentions`: `Cylinder::Out.X` in the chart's properties becomes an input that only the proof has
//!
//! The controller's code is made of the chart alone, without what its properties say of plants: a plant costs nothing there.

mod call;
mod mentions;
mod wires;
mod written;

use proc_macro2::TokenStream;

use crate::Compiled;
use crate::analysis::{Facts, Prover};
use crate::ast::{Body, Chart, Item, Property, Setting};
use crate::check;
use crate::diagnostic::{self, Diagnostic, Sink};
use crate::list::{List, PushAll};
use crate::model::{self, Model, Plant, Plants};
use crate::parse;
use crate::place::quote;

pub(crate) use call::Call;
pub(crate) use written::KEYWORD;

/// The tokens of a call's chart.
pub(crate) fn chart_of(tokens: &TokenStream) -> TokenStream {
    Call::of(tokens).map_or_else(|| tokens.clone(), |call| call.chart)
}

/// The model of a call, together with its plants where it has some: what a proof is about.
///
/// Mistakes go to `sink`. `None` where the chart or a plant cannot be read.
pub fn model(tokens: TokenStream, sink: &mut Sink) -> Option<Model> {
    match Call::of(&tokens) {
        Some(call) => system(&call, sink),
        None => parse::chart(tokens, sink).map(|chart| model::resolve(&chart, sink)),
    }
}

/// The plants as types for the host, and what the chart claims with them, with what is wrong; and this once more as data. `sound`:
/// nothing is wrong with the chart alone.
pub(crate) fn items(
    call: &Call,
    sound: bool,
    prover: Option<&Prover>,
    root: &TokenStream,
    compile: &dyn Fn(TokenStream) -> Compiled,
) -> (TokenStream, Vec<Diagnostic>) {
    let (mut items, mut all_sound, mut sink, mut of_plants) = (TokenStream::new(), sound, Sink::new(), Vec::new());
    named_once(call, &mut sink);
    for (index, plant) in call.plants.iter().enumerate() {
        let plain = written::plain(plant, call, &mut sink);
        let mut said = Sink::new();
        if let Some(chart) = parse::chart(plain.tokens.clone(), &mut said) {
            written::refuse(&chart.body, &mut sink);
        }
        // Compiling says the same.
        _ = said.finish();
        let compiled = compile(plain.tokens);
        all_sound &= compiled.sound;
        of_plants.push_all(compiled.messages.iter().cloned());
        let tokens = match call.namesake(index) {
            Some(_) => diagnostic::tokens(&compiled.messages, root),
            None => compiled.tokens(root),
        };
        let cfgs = &plant.cfgs;
        items.extend(if cfgs.is_empty() {
            tokens
        } else {
            let root = crate::place::moved(root);
            quote!(#root::__private::under! { [cfg(all(#cfgs))] #tokens })
        });
    }
    if all_sound && !sink.has_errors() {
        if let Some(model) = system(call, &mut sink) {
            if !sink.has_errors() {
                check::with_plants(&model, &Facts::of(&model), prover, &mut sink);
            }
        }
    }
    let mut messages = sink.finish();
    let mut tokens = diagnostic::tokens(&messages, root);
    tokens.extend(items);
    messages.push_all(of_plants);
    (tokens, messages)
}

/// A chart and its plants that have one name could not be told apart, nor a plant and a partial grafcet in front of the name of a step.
fn named_once(call: &Call, sink: &mut Sink) {
    let partials = call.partials();
    for (index, plant) in call.plants.iter().enumerate() {
        let name = &plant.name;
        if let Some(other) = call.namesake(index) {
            sink.notation(name, format!("{other} of this call is called `{name}` already"));
        } else if partials.contains(&name.to_string()) {
            let message = format!(
                "a partial grafcet of the chart is called `{name}` already, and `{name}::…` in a claim would be either of them"
            );
            sink.notation(name, message);
        }
    }
}

/// The chart with its plants.
fn system(call: &Call, sink: &mut Sink) -> Option<Model> {
    named_once(call, sink);
    let mut list = Vec::new();
    for plant in &call.plants {
        let plain = written::plain(plant, call, sink);
        let chart = parse::chart(plain.tokens, sink)?;
        let model = model::resolve(&chart, sink);
        check::drawing(&model, sink);
        written::refuse(&chart.body, sink);
        list.push((model, plain.free));
    }
    let models: Vec<&Model> = list.iter().map(|(model, _)| model).list();
    let mentions = mentions::replaced(call, &models, sink);
    let chart = parse::chart(mentions.tokens.clone(), sink)?;
    let mut system = model::resolve(&chart, sink);
    sink.reword(&|text| mentions.said(text));
    mentions::only_in_claims(&system, &mentions, sink);
    let (driven, wires) = wires::of(&system, &list, sink);
    let watched = mentions.watched(&system);
    mentions.name(&mut system);
    let list = list.into_iter().zip(wires).map(|((model, _), wires)| Plant { model, wires }).list();
    system.plants = Plants { list, driven, watched };
    Some(system)
}

/// Leaves out of a chart what it claims with its plants: all properties but ways home, and assumptions over plants.
pub(crate) fn leave_out(chart: &mut Chart, plants: Vec<String>) {
    let stays = |item: &Item| match item {
        Item::Property(property) => matches!(property, Property::Home { .. }),
        Item::Setting(Setting::AssumeNever { condition, .. } | Setting::AssumeOften { condition, .. }) => {
            !mentions::any(condition, &plants)
        }
        // They are about what a solver alone looks at.
        Item::Setting(Setting::AssumeOrder { .. }) => false,
        _ => true,
    };
    let Body { items, .. } = &mut chart.body;
    items.retain(stays);
    chart.plants = plants;
}
