//! Which searches for stability are certain to end (A30).

use grafcet_compiler::analysis::Stability;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;

fn model(text: &str) -> Model {
    let text = format!("grafcet C {{ input a, b, c: bool; {text} }}");
    let mut sink = Sink::new();
    let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let messages: Vec<String> = sink.finish().into_iter().flat_map(|d| d.notes).map(|(_, text)| text).collect();
    assert_eq!(messages, [""; 0], "{text}");
    model
}

/// What a source transition fills again and again can turn other steps on and off: such a search needs its bound.
#[test]
fn a_source_transition_may_keep_a_search_going() {
    let chart = |condition: &str| {
        let steps = "initial step S1; initial step S6; step S4; step S5;";
        model(&format!("{steps} S5 -[a]-> S6; S6 -[b]-> S1; S4 -[{condition}]-> S5; () -[a]-> S4;"))
    };
    assert!(!Stability::of(&chart("S6.X")).is_certain());
    assert!(Stability::of(&chart("c")).is_certain());
}

/// A search ends where each circle needs what does not hold twice in a cycle, or not together.
#[test]
fn a_circle_that_needs_what_holds_once_ends() {
    let ends = |text: &str| Stability::of(&model(text)).is_certain();
    let ring = |last: &str| format!("initial step S1; step S2; step S3; S1 -[a]-> S2 -[b]-> S3 -[{last}]-> S1;");
    assert!(!ends(&ring("c")));
    // Somewhere else in the circle, not only in the neighbouring transition.
    assert!(ends(&format!("{} step S4; S3 -[c]-> S4 -[!b]-> S1;", ring("!a"))));
    assert!(!ends(&format!("{} step S4; S3 -[c]-> S4 -[b]-> S1;", ring("!a"))));
    // An edge of inputs is one in the first evolution (A2), one of a step in any.
    assert!(ends(&ring("rising(c) && a")));
    assert!(!ends(&ring("rising(c) || a")));
    assert!(!ends(&ring("rising(S3.X)")));
    // The time of a step begins anew with it, but one of zero has elapsed at once (A35).
    assert!(ends(&ring("5s/S3")));
    assert!(!ends(&ring("0s/S3")));
    assert!(!ends(&ring("5s/S1")));
    assert!(!ends(&ring("!(5s/S3)")));
    // What is entered while it is left goes on with its time (A4g).
    assert!(!ends("initial step S1; initial step S2; S1 -[5s/S1]-> S2 -[a]-> S1;"));
}

/// What a step forces or encloses is activated with it, by no other transition.
#[test]
fn partial_grafcets_end_one_after_the_other() {
    let ends = |text: &str| Stability::of(&model(text)).is_certain();
    let above = |condition: &str| {
        format!(
            "partial Above {{ initial step S1; step S2 {{ force Below {{INIT}}; }} S1 -[a]-> S2 -[{condition}]-> S1; }}"
        )
    };
    let below = "partial Below { initial step S3; step S4; S3 -[b]-> S4; }";
    assert!(ends(&format!("{} {below}", above("!a"))));
    assert!(!ends(&format!("{} {below}", above("b"))));
    let modes = |condition: &str| {
        format!(
            "partial Modes {{ initial step S1; enclosing step S2 {{ partial Inner {{ linked step S3; step S4; \
             S3 -[b]-> S4 -[{condition}]-> S3; }} }} S1 -[rising(a)]-> S2 -[!a]-> S1; }}"
        )
    };
    assert!(ends(&modes("!b")));
    assert!(!ends(&modes("c")));
}
