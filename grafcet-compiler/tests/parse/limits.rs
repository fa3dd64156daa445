//! Hostile sizes: whatever is nested or repeated, the compiler neither overflows a thread's stack nor takes long.

use std::fmt::Write as _;
use std::thread;

use grafcet_compiler::ast::Chart;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::{compile, parse};
use quote::quote;

use crate::run;

/// What can be nested in an expression: opening, core, closing.
const EXPRESSIONS: &[(&str, &str, &str)] = &[
    ("(", "a", ")"),
    ("[", "a", "]"),
    ("{", "a", "}"),
    ("a(", "a", ")"),
    ("a.b(", "a", ")"),
    ("a[", "a", "]"),
    ("if a {", "a", "} else {a}"),
    ("if ", "a", "{} else {}"),
    ("match a { _ => ", "a", "}"),
    ("match ", "a", "{}"),
    ("loop {", "a", "}"),
    ("|| {", "a", "}"),
    ("A { a: ", "a", "}"),
    ("{ let a = ", "a", "; }"),
    ("{ fn a() ", "{}", "}"),
    ("{ const A: u8 = ", "a", "; }"),
    ("{ mod a { fn a() ", "{}", "} }"),
    ("{ impl A { fn a() ", "{}", "} }"),
    ("!", "a", ""),
    ("- ", "a", ""),
    ("* ", "a", ""),
    ("& ", "a", ""),
    ("& mut ", "a", ""),
    ("a || ", "a", ""),
    ("a -!", "a", ""),
    ("a + ", "a", ""),
    ("a = ", "a", ""),
    ("a += ", "a", ""),
    ("a .. ", "a", ""),
    ("", "a", " as u8"),
    ("|| ", "a", ""),
    ("|a, b| ", "a", ""),
    ("move || ", "a", ""),
    ("return ", "a", ""),
    ("break ", "a", ""),
    ("if a {} else ", "{}", ""),
    ("", "a", "?"),
    ("", "a", "()"),
    ("", "a", ".a"),
    ("", "a", ".a()"),
    ("", "a", "[a]"),
    ("fn() -> ", "u8", ""),
    ("let a = ", "a", ""),
    ("a < ", "a", ""),
    ("a::<", "a", ">"),
    ("|| -> u8 { ", "a", "}"),
    ("async {", "a", "}"),
    ("while ", "a", "{}"),
    ("for a in ", "a", "{}"),
    ("a!(", "a", ")"),
    ("#[a] ", "a", ""),
    ("3s/(", "a", ")/2s"),
    ("rising(", "a", ")"),
    ("A::", "a", ""),
    ("if {} (a) = ", "a", ""),
    ("a -[a]-> ", "a", ""),
];

/// The same for types.
const TYPES: &[(&str, &str, &str)] = &[
    ("& ", "u8", ""),
    ("*const ", "u8", ""),
    ("(", "u8", ")"),
    ("[", "u8", ";1]"),
    ("A<", "u8", ">"),
    ("fn() -> ", "u8", ""),
    ("fn(", "u8", ")"),
    ("<", "u8", " as A>::B"),
    ("impl A<", "u8", ">"),
    ("dyn A<", "u8", ">"),
    ("A<B = ", "u8", ">"),
    ("A<B: ", "u8", ">"),
    ("A<{", "1", "}>"),
    ("[u8; ", "1", "]"),
    ("& dyn A<", "u8", ">"),
    ("dyn A + ", "A", ""),
    ("A<B, ", "u8", ">"),
];

/// The same for patterns.
const PATTERNS: &[(&str, &str, &str)] = &[
    ("& ", "a", ""),
    ("(", "a", ")"),
    ("[", "a", "]"),
    ("a @ ", "a", ""),
    ("a | ", "a", ""),
    ("A { a: ", "a", "}"),
    ("box ", "a", ""),
    ("A(", "a", ")"),
];

/// The same for the structure of a chart.
const BODIES: &[(&str, &str, &str)] = &[
    ("partial A {", "step B;", "}"),
    ("macro step A {", "entry step B;", "}"),
    ("enclosing step A { partial B {", "step C;", "} }"),
    ("step A {", "q;", "}"),
];

fn every_shape() -> Vec<(String, String, String)> {
    let around = |shapes: &[(&str, &str, &str)], before: &str, after: &str| {
        let shape = |(open, core, close): &(&str, &str, &str)| {
            (format!("{before}\0{open}"), (*core).to_owned(), format!("{close}\0{after}"))
        };
        shapes.iter().map(shape).collect::<Vec<_>>()
    };
    let mut all = around(EXPRESSIONS, "sfc M { initial step A { q if ", "; } }");
    all.extend(around(EXPRESSIONS, "grafcet M { A -[", "]-> B; }"));
    all.extend(around(TYPES, "sfc M { input a: ", "; }"));
    all.extend(around(PATTERNS, "sfc M { step A { P1 { let ", " = b; } } }"));
    all.extend(around(BODIES, "grafcet M {", "}"));
    all
}

/// The text with `count` levels.
fn nested((open, core, close): &(String, String, String), count: usize) -> String {
    let (before, open) = open.split_once('\0').expect("a mark");
    let (close, after) = close.split_once('\0').expect("a mark");
    format!("{before}{}{core}{}{after}", open.repeat(count), close.repeat(count))
}

fn refused(text: &str) -> bool {
    run(text).1.iter().any(|(_, message)| message.contains("nested too deeply"))
}

fn with_stack(megabytes: usize, work: impl FnOnce() + Send + 'static) {
    let thread = thread::Builder::new().stack_size(megabytes << 20).spawn(work).expect("a thread");
    thread.join().expect("no panic");
}

/// Every shape, as deep as the parser lets it pass, and deeper. An overflow of the stack would end the process.
#[test]
fn nothing_overflows_the_stack_of_a_thread() {
    with_stack(2, || {
        for shape in every_shape() {
            let (mut passes, mut fails) = (1, 2000);
            while fails - passes > 1 {
                let middle = usize::midpoint(passes, fails);
                *(if refused(&nested(&shape, middle)) { &mut fails } else { &mut passes }) = middle;
            }
            assert!(passes >= 8, "{shape:?} passes only {passes} deep");
            for count in [passes, fails, 2000] {
                let tokens = nested(&shape, count).parse().expect("tokens");
                drop(compile(&quote!(::grafcet), tokens));
            }
        }
    });
}

#[test]
fn deep_groups_are_refused_at_their_place() {
    let (_, errors) = run(&format!("sfc M {{ step A {{ q if {}a{}; }} }}", "(".repeat(200), ")".repeat(200)));
    assert_eq!(errors.len(), 1);
    assert!(errors[0].1.contains("nested too deeply"), "{errors:?}");
}

/// `steps` steps with two associations each, declarations, and one transition a line or all in one chain.
fn large(steps: usize, one_chain: bool) -> String {
    let mut text = "sfc Large {\n".to_owned();
    for n in 0..steps {
        writeln!(text, "input a{n}, b{n}: bool; output q{n}: bool;").expect("a string");
    }
    for n in 0..steps {
        let initial = if n == 0 { "initial " } else { "" };
        writeln!(text, "/// Step {n}.\n{initial}step S{n} {{ N q{n}; S r if a{n} && !b{n}; }}").expect("a string");
    }
    text.push_str("S0");
    for n in 1..steps {
        write!(text, " -[t{n}: a{n} && S{}.X || level > {n}]-> S{n}", n - 1).expect("a string");
        if !one_chain {
            write!(text, ";\nS{n}").expect("a string");
        }
    }
    text + " -[true]-> S0;\n}"
}

/// The chart and the number of messages.
fn parsed(text: &str) -> (Option<Chart>, usize) {
    let tokens = text.parse().expect("tokens");
    let mut sink = Sink::new();
    let chart = parse::chart(tokens, &mut sink);
    (chart, sink.finish().len())
}

#[test]
fn a_thousand_steps_parse() {
    for one_chain in [false, true] {
        let (chart, messages) = parsed(&large(1000, one_chain));
        assert!(chart.is_some_and(|chart| !chart.incomplete));
        assert_eq!(messages, 0);
    }
}

#[test]
fn a_thousand_mistakes_are_all_found() {
    let (inputs, lines, chains) = ("input a: bool\n", "N q\n", "A -[x y]-> B\n");
    let body = format!("{} step A {{ {} }} {}", inputs.repeat(1000), lines.repeat(1000), chains.repeat(1000));
    let (chart, messages) = parsed(&format!("sfc M {{ {body} }}"));
    assert!(chart.is_some_and(|chart| chart.incomplete));
    assert_eq!(messages, 4000);
}
