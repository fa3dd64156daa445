//! One mistake gives one message: what follows from what was said is left out.

mod judged;

use judged::{expanded, rules};

/// The texts of the messages of one rule.
fn messages(chart: &str, rule: &str) -> Vec<String> {
    let code = expanded(chart);
    let mut texts: Vec<String> =
        code.split('"').filter(|text| text.contains(&format!("[grafcet::{rule}]"))).map(str::to_owned).collect();
    texts.dedup();
    texts
}

/// Both dialects.
fn both(chart: &str, expected: &[&str]) {
    for dialect in ["sfc", "grafcet"] {
        let text = format!("{dialect} C {{ input a, b, c: bool; {chart} }}");
        let mut found = rules(&text);
        found.retain(|rule| rule != "unused_input" && rule != "overlapping_branches");
        assert_eq!(found, expected, "{text}");
    }
}

const STEPS: &str = "initial step A; step B; step C; step E;";

#[test]
fn a_convergence_of_alternatives_is_one_mistake() {
    both(&format!("{STEPS} A -[a]-> B; A -[b && !a]-> C; (B, C) -[true]-> E; E -[c]-> A;"), &["stuck_join"]);
    both(&format!("{STEPS} A -[a]-> B; A -[b && !a]-> C; (B, C) -[true]-> E; E -[c]-> A; home A;"), &["stuck_join"]);
    both("initial step A; step B; step C; A -[a]-> B; A -[b]-> C; (B, C) -[true]-> A;", &["stuck_join"]);
    // Where both can go on otherwise nothing waits.
    let others = "B -[c]-> A; C -[c]-> A;";
    both(
        &format!("{STEPS} A -[a]-> B; A -[b && !a]-> C; (B, C) -[!c]-> E; E -[c]-> A; {others}"),
        &["dead_transition"],
    );
}

#[test]
fn what_is_allowed_explains_nothing() {
    let chart = format!("{STEPS} A -[a]-> B; A -[b && !a]-> C; (B, C) -[true]-> E; E -[c]-> A; home A;");
    let allowed = format!("sfc C {{ #![allow(grafcet::stuck_join)] input a, b, c: bool; {chart} }}");
    assert_eq!(rules(&allowed), ["dead_transition", "not_home"]);
    let chart = format!("{STEPS} A -[a]-> (B, C); B -[b]-> E; C -[c]-> A; home A;");
    let allowed = format!(
        "sfc C {{ #![allow(grafcet::unsafe_step)] #![allow(grafcet::deadlock)] input a, b, c: bool; {chart} }}"
    );
    assert!(rules(&allowed).contains(&"not_home".to_owned()), "{:?}", rules(&allowed));
}

#[test]
fn a_forgotten_convergence_is_one_mistake() {
    let branches = "initial step A; step B1; step B2; step C1; step C2; A -[a]-> (B1, C1); B1 -[b]-> B2; C1 -[c]-> C2;";
    both(&format!("{branches} B2 -[true]-> A;"), &["unsafe_step"]);
    both(&format!("{branches} B2 -[true]-> A; C2 -[true]-> A;"), &["unsafe_step"]);
    for dialect in ["sfc", "grafcet"] {
        let text = format!("{dialect} C {{ input a, b, c: bool; {branches} B2 -[true]-> A; }}");
        let places = messages(&text, "unsafe_step");
        let first = places.iter().filter(|text| text.contains("this transition can activate")).count();
        assert_eq!(first, 1, "{places:?}");
    }
    let text = format!("sfc C {{ input a, b, c: bool; {branches} B2 -[true]-> A; home A; }}");
    assert_eq!(rules(&text), ["unsafe_step"]);
}

#[test]
fn no_way_home_follows_from_a_deadlock() {
    both("initial step A; step B; step E; A -[a]-> B -[b]-> A; A -[c && !a]-> E; home A;", &["deadlock"]);
}

#[test]
fn no_way_home_because_of_what_comes_later() {
    let steps = "initial step A; step B; step C; step E;";
    // The chart ends two steps further on.
    both(&format!("{steps} A -[a]-> B -[b]-> C -[c]-> E; home A;"), &["deadlock"]);
    both(&format!("{steps} A -[a]-> B -[b]-> C -[c]-> B; B -[c && !b]-> E; home A;"), &["deadlock"]);
    // What would lead back never clears, for one reason or another.
    both(&format!("{steps} A -[a]-> B -[b]-> C -[c]-> E -[A.X]-> A; home A;"), &["dead_transition"]);
    both(&format!("{steps} A -[a]-> B -[b]-> C -[c]-> E -[a && !a]-> A; home A;"), &["never_true"]);
    both("initial step A; step B; step C; A -[a]-> B -[b]-> A; C -[c]-> A; home C;", &["unreachable_step"]);
    // Another circle is another mistake.
    both(
        &format!(
            "{steps} step F; A -[a]-> B -[A.X]-> A; A -[c && !a]-> C -[c]-> E -[!c]-> C; B -[b]-> F -[c]-> B; home A;"
        ),
        &["dead_transition", "not_home"],
    );
}
