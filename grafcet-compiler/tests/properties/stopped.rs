//! Searches for stability that their bound stops (A30): a situation in which one can stop is not passed over, whatever the budget.

use super::judged::said;

/// Where one of these rules speaks, and no other.
fn says(chart: &str, rule: &str) {
    let said = said(chart);
    assert!(!said.is_empty() && said.iter().all(|one| one.starts_with(&format!("{rule}: "))), "{chart}: {said:#?}");
}

#[test]
fn a_search_is_stopped_in_a_step_that_no_other_cycle_ends_in() {
    let chart = |budget: &str| {
        format!(
            "grafcet Z {{ {budget} input a, b, c, d, e: bool; output motor: bool; \
             initial step S1; step S2; step S3 {{ motor; }} step S4; step S5; step S6; step S7; step S8; step S9; step S10; \
             S1 -[a]-> S2 -[b]-> S3 -[b]-> S4 -[c]-> S5 -[d]-> S6 -[e]-> S7 -[a]-> S8 -[c]-> S1; \
             S4 -[!c && d]-> S9 -[e]-> S10 -[d]-> S1; never motor; }}"
        )
    };
    // With the smaller budget not all combinations of the inputs are tried.
    says(&chart("budget 5;"), "property_violated");
    says(&chart(""), "property_violated");
}

/// A ring of two steps in a partial grafcet of its own, by two inputs of its own.
fn ring(number: usize) -> String {
    format!(
        "partial Ring{number} {{ initial step A{number}; step B{number}; A{number} -[x{number}]-> B{number} -[y{number}]-> A{number}; }} "
    )
}

#[test]
fn a_search_is_stopped_in_the_middle_of_what_one_partial_grafcet_does() {
    // A ring goes on for ever; its second step sets the chain going, and the third evolution would lead from `C2` on.
    let rings: String = (0..6).map(ring).collect();
    let chart = format!(
        "grafcet C {{ max_evolutions 2; budget 5; input s, x0, y0, x1, y1, x2, y2, x3, y3, x4, y4, x5, y5: bool; {rings} \
         partial Chain {{ initial step C1; step C2; step C3; C1 -[B0.X && s]-> C2 -[s]-> C3 -[!s]-> C1; C2 -[!s]-> C1; }} }}"
    );
    let found = said(&chart);
    assert!(!found.iter().any(|one| one.starts_with("dead_transition: ")), "{found:#?}");
}

#[test]
fn a_transition_that_clears_where_the_bound_stops_is_not_dead() {
    let chart = "grafcet R { #![allow(grafcet::overlapping_branches, grafcet::unsafe_step)] clock 100us; \
                 input a, b, c: bool; input f: f32; input i: i16; input tin: time; \
                 input e: Mode in {Off, Auto, Manual}; input col: Colour in {Red, Green, Blue, Amber}; \
                 param pt: time = 800us; param pe: Mode in {Off, Auto, Manual} = Mode::Auto; \
                 var vu: u8 = 5; var vt: time = 600us; var ve: Colour in {Red, Green, Blue, Amber} = Colour::Blue; \
                 initial step S1; step S2; step S3; step S4; step S5; step S6; \
                 S1 -[a]-> S2; S2 -[(pt/S2 || col == Colour::Red)]-> S3; S2 -[e == Mode::Auto]-> S3; \
                 S3 -[b && !(rising(c && !(vu < 200)))]-> S4; S4 -[vt == tin]-> S5; S5 -[f != f]-> S6; S6 -[i > 3]-> S3; \
                 S3 -[(blink(100us/300us, S3))]-> S1; S3 -[else]-> S3; }";
    let found = said(chart);
    assert!(!found.iter().any(|one| one.starts_with("dead_transition: ")), "{found:#?}");
}
