//! The decisions of `docs/semantics.md` by which a chart is refused: each with a chart that breaks it and one beside it that
//! does not. The other decisions are charts of `tests/conformance`.

#[allow(dead_code, reason = "the file is shared")]
mod charts;

/// Whether the rule refuses a chart with these declarations, steps and transitions.
fn refuses(rule: &str, dialect: &str, body: &str) -> bool {
    let chart = format!("{dialect} C {{ {body} }}").parse().expect("tokens");
    let code = charts::expand(chart).to_string();
    let other = code.split("compile_error").skip(1).find(|said| !said.contains(&format!("[grafcet::{rule}]")));
    assert_eq!(other, None, "another error than `{rule}`");
    code.contains("compile_error")
}

#[test]
fn a07_two_stored_actions_in_one_evolution_do_not_write_one_variable() {
    let chart = |second: &str| {
        format!(
            "input a, b: bool; output q: bool; output n: u8; initial step A; step B {{ P1 n = 1; }} step C {{ {second} }}
             step E {{ q; }} A -[a]-> (B, C); (B, C) -[b && n > 0]-> E; E -[!b]-> A;"
        )
    };
    assert!(refuses("write_race", "grafcet", &chart("P1 n = 2;")));
    assert!(!refuses("write_race", "grafcet", &chart("q;")));
}

#[test]
fn a08_an_output_is_assigned_or_allocated_and_never_both() {
    let chart = |action: &str| {
        format!("input a: bool; output q: bool; initial step A {{ R q; }} step B {{ {action} }} A -[a]-> B -[!a]-> A;")
    };
    assert!(refuses("mixed_modes", "grafcet", &chart("q;")));
    assert!(!refuses("mixed_modes", "grafcet", &chart("S q;")));
}

/// Two charts with a master each, and a third one that both can force.
fn masters(first: &str, second: &str) -> String {
    format!(
        "input a, b, c: bool; output q: bool;
         partial G1 {{ initial step A1; step B1 {{ {first} }} A1 -[a]-> B1 -[!a]-> A1; }}
         partial G2 {{ initial step A2; step B2 {{ {second} }} A2 -[b]-> B2 -[!b]-> A2; }}
         partial G3 {{ initial step A3; step B3 {{ q; }} A3 -[c]-> B3 -[!c]-> A3; }}"
    )
}

#[test]
fn a14_two_orders_do_not_force_one_partial_grafcet_at_the_same_time() {
    assert!(refuses("two_masters", "grafcet", &masters("force G3 {};", "force G3 {INIT};")));
    assert!(!refuses("two_masters", "grafcet", &masters("force G3 {};", "")));
}

#[test]
fn a14_forcing_has_no_circle() {
    assert!(refuses("forcing_circle", "grafcet", &masters("force G2 {};", "force G1 {};")));
    assert!(!refuses("forcing_circle", "grafcet", &masters("force G2 {};", "force G3 {};")));
}

#[test]
fn a16_a_partial_grafcet_in_an_enclosure_is_not_forced() {
    let chart = |forced: &str| {
        format!(
            "input a, b, c: bool; output q: bool;
             partial Top {{ initial step A; step B {{ force {forced} {{}}; }} A -[a]-> B -[!a]-> A; }}
             partial Outer {{
                 initial step C;
                 enclosing step F {{ partial Inner {{ linked step G {{ q; }} step H; G -[c]-> H -[!c]-> G; }} }}
                 C -[b]-> F -[!b]-> C;
             }}"
        )
    };
    assert!(refuses("forced_enclosure", "grafcet", &chart("Inner")));
    assert!(!refuses("forced_enclosure", "grafcet", &chart("Outer")));
}

#[test]
fn a18_an_enclosure_has_a_linked_step() {
    let chart = |link: &str| {
        format!(
            "input a, b: bool; output q: bool; initial step A;
             enclosing step B {{ partial Inner {{ {link} step C {{ q; }} step E; C -[a]-> E -[!a]-> C; }} }}
             A -[b]-> B -[!b]-> A;"
        )
    };
    assert!(refuses("enclosure_without_link", "grafcet", &chart("")));
    assert!(!refuses("enclosure_without_link", "grafcet", &chart("linked")));
}

#[test]
fn a21_only_a_partial_grafcet_with_an_initial_step_is_initialised() {
    let chart = |initial: &str| {
        format!(
            "input a, b, c: bool; output q: bool;
             partial Top {{ initial step A; step B {{ force Low {{INIT}}; }} step C {{ force Low {{F}}; }}
                 A -[a]-> B -[!a]-> C -[b]-> A; }}
             partial Low {{ {initial} step E {{ q; }} step F; E -[b]-> F -[!b]-> E; }}"
        )
    };
    assert!(refuses("init_without_initial", "grafcet", &chart("")));
    assert!(!refuses("init_without_initial", "grafcet", &chart("initial")));
}

#[test]
fn a22_a_continuous_output_is_not_read_in_a_condition() {
    let chart = |action: &str, reset: &str| {
        format!(
            "input a: bool; output q: bool; initial step A {{ {reset} }} step B {{ {action} }} A -[a]-> B -[q && !a]-> A;"
        )
    };
    assert!(refuses("reads_continuous", "grafcet", &chart("q;", "")));
    assert!(!refuses("reads_continuous", "grafcet", &chart("S q;", "R q;")));
}

#[test]
fn a30_a_circle_that_always_turns_is_refused() {
    let chart = |back: &str| {
        format!("input a: bool; output q: bool; initial step A; step B {{ q; }} A -[a]-> B -[{back}]-> A;")
    };
    assert!(refuses("unstable", "grafcet", &chart("a")));
    assert!(!refuses("unstable", "grafcet", &chart("!a")));
}
