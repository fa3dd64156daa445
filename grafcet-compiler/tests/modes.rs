//! `modes;` (A39): what is proved of a chart that is held back, and what is said about it.

mod judged;

use judged::{expanded, rules, said};

const NONE: [&str; 0] = [];

/// A selection whose branches are exclusive, so that by hand alone both never come together.
fn press(lines: &str) -> String {
    format!(
        "sfc C {{ modes; input a, b: bool; output q, r, lamp: bool; initial step A {{ lamp if manual; }} step B {{ q if !paused; }} \
         step D1 {{ r; }} A -[a && !b]-> B -[b]-> A; A -[b && !a]-> D1 -[a]-> A; {lines} }}"
    )
}

#[test]
fn the_inputs_can_be_read_and_their_conditions_are_neither_always_nor_never() {
    assert_eq!(rules(&press("")), NONE);
    assert_eq!(rules(&press("any except A -[manual && b]-> A;")), NONE);
    assert_eq!(rules(&press("never q && r; home A;")), NONE);
}

#[test]
fn what_only_the_button_does_is_left_out() {
    // By hand each branch of a convergence goes on alone, and C would be entered twice.
    let chart = "grafcet C { modes; input a: bool; output q: bool; initial step A; step B; step E { q if a && E.X; } step F; \
                 A -[a]-> (B, E); (B, E) -[!a]-> F -[a]-> A; never A.X && B.X; }";
    assert_eq!(rules(chart), NONE);
    // The own way of the chart is looked at in every mode but that.
    let chart = press("never B.X && b && paused;");
    assert_eq!(rules(&chart), ["property_violated"]);
    let chart = press("never B.X && manual;");
    assert_eq!(rules(&chart), ["property_violated"]);
    // B is entered by its condition, or by hand.
    let entered = "sfc C { modes; input a: bool; output q, ok: bool; initial step A; step B { q; S ok; } step E { R ok; } \
                   A -[a]-> B -[!a]-> E -[a]-> A; always q => B.X && ok; }";
    assert_eq!(rules(entered), NONE);
}

#[test]
fn what_is_wrong_with_a_condition_is_still_seen() {
    assert_eq!(rules(&press("B -[a && !a]-> D1;")), ["never_true"]);
}

#[test]
fn a_chart_without_the_word_has_none_of_the_inputs() {
    let code = expanded(&press("").replace(" modes;", "").replace("if manual", "if a").replace("if !paused", "if a"));
    assert!(!code.contains("compile_error"), "{code}");
    for word in ["manual", "paused", "inputs . push", "semi_automatic"] {
        assert!(!code.contains(word), "{word}");
    }
}

#[test]
fn it_stands_once_for_what_it_holds_back() {
    let chart = "grafcet C { input a: bool; partial One { modes; initial step A; step B; A -[a]-> B -[!a]-> A; } \
                 partial Two { modes; initial step X; step Y; X -[a]-> Y -[!a]-> X; } }";
    assert_eq!(said(chart), NONE);
    // Once at the outer one, and at each that it holds back anyway.
    assert_eq!(said(&chart.replacen("input", "modes; input", 1)).len(), 3);
}
