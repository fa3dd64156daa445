//! Properties over more than one cycle, as the compiler sees them without a solver: what is read, and what is said of them.

use crate::judged::{diagnostics, said};
use crate::{fails, holds, motor};

/// Nobody but a solver decides them; the message says which feature asks it.
#[test]
fn only_a_solver_looks_at_several_cycles() {
    for property in ["on leads_to On;", "on && !hot leads_to relay within 5s;", "Off before On;", "relay before green;"]
    {
        let rest = fails(&motor(property), "property_undecided", "about more than one cycle");
        assert!(rest.is_empty(), "{rest:?}");
        assert!(said(&motor(property))[0].contains("feature `prove`"));
        holds(&motor(&format!("#[allow(grafcet::property_undecided)] {property}")));
    }
}

/// `within 0s` is the end of the same cycle, which is gone through as ever; a step alone stands for its activity.
#[test]
fn what_comes_at_once_needs_no_solver() {
    holds(&motor("relay leads_to On within 0s; On leads_to relay within 0s;"));
    fails(&motor("on leads_to On within 0s;"), "property_violated", "`on` holds and `On.X` does not");
}

/// What stands on the wrong side, in the wrong place or is left out.
#[test]
fn mistakes() {
    let messages = |lines: &str| {
        let notes = diagnostics(&motor(lines)).into_iter().flat_map(|one| one.notes);
        notes.map(|(_, message)| message).collect::<Vec<_>>().join("\n")
    };
    for (lines, word) in [
        ("on leads_to ;", "expected what it leads to, found `;`"),
        ("on leads_to On within;", "after `within` stands how long it may take"),
        ("Off before ;", "expected what comes after it, found `;`"),
        ("assume often rising(on);", "an assumption is about the inputs of one cycle, and an edge takes two"),
        ("assume often relay;", "an assumption is about the inputs of one cycle, and `relay` is an output"),
        ("assume often On.X;", "an assumption is about the inputs of one cycle, and this is a step"),
        ("assume cycle within;", "after `within` stands the longest time between two cycles"),
        ("assume cycle within 0s;", "between two cycles some time passes"),
        ("assume cycle within 1s; assume cycle within 2s;", "`assume cycle` stands here a second time"),
        ("assume sometimes on;", "what comes again and again `assume often door_closed;`"),
    ] {
        assert!(messages(lines).contains(word), "{lines}: {}", messages(lines));
    }
    let inside =
        "grafcet C { input a: bool; partial P { initial step A; step B; A -[a]-> B -[!a]-> A; A leads_to B; } }";
    assert!(said(inside).iter().any(|one| one.contains("`leads_to` is about the whole chart")), "{:?}", said(inside));
}

/// Steps, inputs and chains may be called like the words.
#[test]
fn the_words_are_names_elsewhere() {
    holds(
        "sfc C { input before, often, cycle: bool; output q: bool; initial step leads_to; step within { q; } \
         leads_to -[before && often]-> within -[cycle]-> leads_to; never q && leads_to.X; }",
    );
    holds(
        "sfc C { input a: bool; output q: bool; initial step home; step before { q; } \
         home -[a]-> before -[!a]-> home; never q && home.X; #[allow(grafcet::property_undecided)] (q || a) leads_to home; }",
    );
}

/// A missing `;` is one mistake at its place.
#[test]
fn a_semicolon_is_missing() {
    let said = said(&motor("Off before On never red && relay;"));
    assert!(!said.is_empty() && said.len() < 3, "{said:?}");
}
