//! What the compiler says about a chart, for tests of rules.
#![allow(dead_code, reason = "each test asks in its way")]

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::{Diagnostic, Sink};
use grafcet_compiler::{check, compile, model, parse};
use quote::quote;

/// The code of a chart.
pub(crate) fn expanded(chart: &str) -> String {
    compile(&quote!(::grafcet), chart.parse().expect("tokens")).to_string()
}

/// The rules that speak about a chart to its user, in alphabetic order; `error` for a mistake of the notation alone.
pub(crate) fn rules(chart: &str) -> Vec<String> {
    let code = expanded(chart);
    let named = code.split("[grafcet::").skip(1).filter_map(|rest| rest.split_once(']'));
    let mut rules: Vec<String> = named.map(|(rule, _)| rule.to_owned()).collect();
    if rules.is_empty() && code.contains("compile_error") {
        rules.push("error".to_owned());
    }
    rules.sort_unstable();
    rules.dedup();
    rules
}

/// All that is said about a chart.
pub(crate) fn diagnostics(chart: &str) -> Vec<Diagnostic> {
    let mut sink = Sink::new();
    if let Some(chart) = parse::chart(chart.parse().expect("tokens"), &mut sink) {
        let model = model::resolve(&chart, &mut sink);
        check::drawing(&model, &mut sink);
        if !sink.has_errors() {
            check::evolution(&model, &Facts::of(&model), None, &mut sink);
        }
    }
    sink.finish()
}

/// The rule and the first message of all that is said.
pub(crate) fn said(chart: &str) -> Vec<String> {
    let text = |one: Diagnostic| format!("{}: {}", name(&one), one.notes[0].1);
    diagnostics(chart).into_iter().map(text).collect()
}

/// The rules alone.
pub(crate) fn names(chart: &str) -> Vec<&'static str> {
    diagnostics(chart).iter().map(name).collect()
}

fn name(one: &Diagnostic) -> &'static str {
    one.rule.map_or("notation", |rule| rule.name)
}
