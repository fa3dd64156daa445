//! `let`: a chart with named conditions is the chart that is written out.

use std::fmt::Write as _;

use grafcet_compiler::compile;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use quote::quote;

fn model(chart: &str) -> Model {
    let mut sink = Sink::new();
    let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let messages = sink.finish();
    assert!(messages.is_empty(), "{messages:?}");
    model
}

fn errors(chart: &str) -> Vec<String> {
    let mut sink = Sink::new();
    let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
    model::resolve(&chart, &mut sink);
    sink.finish().into_iter().flat_map(|diagnostic| diagnostic.notes).map(|(_, message)| message).collect()
}

/// The expansion without texts and without the parentheses around what a name stands for.
fn code(chart: &str) -> String {
    let tokens = compile(&quote!(::grafcet), chart.parse().expect("tokens")).to_string();
    let code = &tokens[tokens.find("fn cycle").expect("a cycle")..];
    let code = &code[..code.find("fn next_deadline").expect("a deadline")];
    code.chars().filter(|c| !"() ".contains(*c)).collect()
}

const CHART: &str = "
    input auto, manual, next: bool; input n: u8; output a, b: bool; output v: u16; action heat(on: bool);
    LETS
    initial step A { a if !GO; } step B { b if BOTH; P1 { if GO { v = v + 1; } } heat(GO && manual); }
    A -[GO && manual]-> B -[!BOTH || f(GO)]-> A;
    B -[rising(GO) && 5s/GO/2s]-> A;
    B -[HIGH && rising(BOTH) && f(3, GO)]-> B;";

fn with(head: &str, lets: &str, go: &str, both: &str, high: &str) -> String {
    let body = CHART.replace("LETS", lets).replace("GO", go).replace("BOTH", both).replace("HIGH", high);
    format!("{head} M {{ {body} }}")
}

#[test]
fn a_name_is_what_it_stands_for() {
    let lets = "let go = auto || rising(next); let both = go && n < 3; let high = 3s/B && B.X;";
    let (go, both, high) = ("(auto || rising(next))", "((auto || rising(next)) && n < 3)", "(3s/B && B.X)");
    let head = "sfc";
    let (named, written) = (with(head, lets, "go", "both", "high"), with(head, "", go, both, high));
    let (one, other) = (model(&named), model(&written));
    assert_eq!(one.edges.len(), other.edges.len());
    assert_eq!(one.delays.len(), other.delays.len());
    for (a, b) in one.edges.values().zip(other.edges.values()) {
        assert_eq!(a.of.tree, b.of.tree);
    }
    for (a, b) in one.transitions.values().zip(other.transitions.values()).take(1) {
        assert_eq!((&a.condition.tree, &a.condition.reads), (&b.condition.tree, &b.condition.reads));
    }
    assert_eq!(one.transitions.values().next().expect("one").condition.text, "go && manual");
    assert_eq!(code(&named), code(&written));
}

#[test]
fn an_unused_name_costs_nothing() {
    let plain = "sfc M { input a, _b: bool; initial step A; step B; A -[a]-> B -[1s/B]-> A; }";
    let named = plain.replace("initial", "let _w = rising(a) && 5s/_b/2s; let _v = _w || rising(_b); initial");
    assert_eq!(code(plain), code(&named));
}

#[test]
fn names_that_grow_without_measure_are_refused() {
    let mut lets = String::from("let a0 = x && y;");
    for i in 1..64 {
        write!(lets, "let a{i} = a{} && a{};", i - 1, i - 1).expect("a string");
    }
    let chart = format!("sfc M {{ input x, y: bool; {lets} initial step A; step B; A -[a63]-> B -[x]-> A; }}");
    let messages = errors(&chart);
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(messages[0].contains("terms"), "{messages:?}");
}

#[test]
fn names_that_nest_without_measure_are_refused() {
    let mut lets = String::from("let a0 = x;");
    for i in 1..2_000 {
        write!(lets, "let a{i} = !a{};", i - 1).expect("a string");
    }
    let chart = format!("sfc M {{ input x, y: bool; {lets} initial step A; step B; A -[a1999]-> B -[x]-> A; }}");
    let messages = errors(&chart);
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(messages[0].contains("nested too deeply"), "{messages:?}");
}

#[test]
fn a_deep_name_in_a_deep_expression_overflows_no_stack() {
    let ors = |first: &str| (0..250).fold(first.to_owned(), |text, _| format!("{text} || x"));
    let chart = format!(
        "sfc M {{ input x, y: bool; let deep = {}; initial step A; step B; A -[{}]-> B -[x]-> A; }}",
        ors("y"),
        ors("deep")
    );
    let check = move || {
        let messages = errors(&chart);
        assert_eq!(messages.len(), 1, "{messages:?}");
        assert!(messages[0].contains("nested too deeply"), "{messages:?}");
    };
    let thread = std::thread::Builder::new().stack_size(2 << 20).spawn(check).expect("a thread");
    thread.join().expect("no overflow");
}

#[test]
fn a_thousand_uses_take_no_time() {
    let mut chains = String::new();
    for i in 0..1_000 {
        write!(chains, "step S{i}; S{i} -[go && x]-> S{};", (i + 1) % 1_000).expect("a string");
    }
    let chart = format!("sfc M {{ input x, y: bool; let go = x || rising(y) || 5s/y/2s; initial {chains} }}");
    let start = std::time::Instant::now();
    let _ = compile(&quote!(::grafcet), chart.parse().expect("tokens"));
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}
