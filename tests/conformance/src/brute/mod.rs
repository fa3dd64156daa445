//! The checker against brute force: what it says about small charts beside what a naive exploration of all inputs finds.
//!
//! - `graph`: every state that the interpreter can reach, with every valuation of the inputs
//! - `verdicts`: what the states say about steps, transitions, joins and deadlocks
//! - `compare`, `replay`: the checker's answers and ways beside these
//! - `facts`: what the rest of the compiler takes for granted, beside what happens
//! - `circles`: what turns for ever whenever it is entered
//! - `rules`: what is reported beside what happens
//! - `nested`: what is decided by reduction
//! - `claims`: the properties that stand in the chart; `responses`: those over more than one cycle; `memories`: their edges and delays
//! - `closed`: charts with their plants; `machines`: random ones
//! - `make`: small random charts, broken ones included
//! - `run`: one after the other, and the smallest form of one that differs

mod circles;
pub(crate) mod claims;
pub(crate) mod closed;
pub mod compare;
mod draw;
mod facts;
pub mod graph;
mod hierarchy;
pub(crate) mod machines;
pub mod make;
pub(crate) mod memories;
mod nested;
mod replay;
pub(crate) mod responses;
mod rules;
pub mod run;
pub mod verdicts;
mod words;

use std::collections::BTreeSet;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::{Diagnostic, Severity, Sink};
use grafcet_compiler::model::Model;
use grafcet_compiler::{check, model, parse};
use proc_macro2::TokenStream;

/// The model of a chart whose lints are allowed. One that is only `unstable` is a chart, too, and so is one that breaks its own
/// properties.
///
/// # Errors
/// The first rule, or message of notation, that refuses the chart.
pub fn resolve(text: &str) -> Result<Model, String> {
    let (model, diagnostics) = look(text);
    let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Deny);
    for error in errors {
        match error.rule {
            Some(rule) if rule.name == "unstable" || claims::RULES.contains(&rule.name) => {}
            Some(rule) => return Err(rule.name.to_owned()),
            None => {
                return Err(error
                    .notes
                    .first()
                    .map_or_else(String::new, |(_, message)| format!("notation: {message}")));
            }
        }
    }
    model.ok_or_else(String::new)
}

/// The rules that report something where no lint is allowed.
fn reported(text: &str) -> BTreeSet<&'static str> {
    let strict: String = text.lines().filter(|line| !line.starts_with("#![")).map(|line| format!("{line}\n")).collect();
    look(&strict).1.iter().filter_map(|diagnostic| Some(diagnostic.rule?.name)).collect()
}

/// What the compiler does before it generates code.
fn look(text: &str) -> (Option<Model>, Vec<Diagnostic>) {
    let mut sink = Sink::new();
    let Ok(tokens) = text.parse::<TokenStream>() else { return (None, Vec::new()) };
    let Some(chart) = parse::chart(tokens, &mut sink) else { return (None, sink.finish()) };
    let model = model::resolve(&chart, &mut sink);
    check::drawing(&model, &mut sink);
    let complete = !chart.incomplete && !model.incomplete;
    if complete && !sink.has_errors() {
        check::evolution(&model, &Facts::of(&model), None, &mut sink);
    }
    (complete.then_some(model), sink.finish())
}
