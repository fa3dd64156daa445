//! The checker against brute force: what it says about small charts beside what a naive exploration of all inputs finds.
//!
//! - `graph`: every state that the interpreter can reach, with every valuation of the inputs
//! - `verdicts`: what the states say about steps, transitions, joins and deadlocks
//! - `compare`, `replay`: the checker's answers and ways beside these
//! - `facts`: what the rest of the compiler takes for granted, beside what happens
//! - `make`: small random charts, broken ones included
//! - `run`: one after the other, and the smallest form of one that differs

pub mod compare;
mod draw;
mod facts;
pub mod graph;
mod hierarchy;
pub mod make;
mod replay;
pub mod run;
pub mod verdicts;
mod words;

use grafcet_compiler::diagnostic::{Severity, Sink};
use grafcet_compiler::model::Model;
use grafcet_compiler::{check, model, parse};
use proc_macro2::TokenStream;

/// The model of a chart whose lints are allowed; everything that is left are errors.
///
/// # Errors
/// The first rule, or message of notation, that refuses the chart.
pub fn resolve(text: &str) -> Result<Model, String> {
    let tokens: TokenStream = text.parse().map_err(|error| format!("tokens: {error}"))?;
    let mut sink = Sink::new();
    let Some(chart) = parse::chart(tokens, &mut sink) else { return Err(refused(sink)) };
    let model = model::resolve(&chart, &mut sink);
    check::drawing(&model, &mut sink);
    let complete = !chart.incomplete && !model.incomplete;
    if complete && !sink.has_errors() {
        check::evolution(&model, &mut sink);
    }
    if !complete || sink.has_errors() {
        return Err(refused(sink));
    }
    _ = sink.finish();
    Ok(model)
}

fn refused(sink: Sink) -> String {
    let all = sink.finish();
    let first = all.iter().find(|diagnostic| diagnostic.severity == Severity::Deny);
    first.map_or_else(String::new, |diagnostic| match diagnostic.rule {
        Some(rule) => rule.name.to_owned(),
        None => diagnostic.notes.first().map_or_else(String::new, |(_, message)| format!("notation: {message}")),
    })
}
