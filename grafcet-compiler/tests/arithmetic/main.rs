//! Arithmetic in conditions: hand-written ones, and [`drawn`] ones.

mod drawn;
mod expr;
#[path = "../judged/mod.rs"]
mod judged;

use judged::said;

/// The chart is right.
fn holds(chart: &str) {
    assert_eq!(said(chart), Vec::<String>::new(), "{chart}");
}

/// Something is said by this rule, in which this stands.
fn fails(chart: &str, rule: &str, word: &str) {
    let said = said(chart);
    assert!(said.iter().any(|one| one.starts_with(rule) && one.contains(word)), "{chart}: {said:#?}");
}

/// From `B` there is one way back.
fn back(condition: &str) -> String {
    format!(
        "sfc Chart {{ #![allow(grafcet::unused_input, grafcet::unused_param, grafcet::never_true, grafcet::dead_transition, grafcet::deadlock)] input go: bool; input lv, lw: u8; input big: u32; input sg: i16; \
         input n: usize; input x: f32; param hi: u8 = 9; initial step A; step B; A -[go]-> B; B -[{condition}]-> A; home A; }}"
    )
}

#[test]
fn a_way_home_needs_values() {
    for condition in [
        "lv * 2 == 6",
        "lv + lw > 8 && lv < 5 && lw < 6",
        "lv.wrapping_mul(2) == 6 && lv > 3",
        "lv as u16 * 4 > 1019",
        "u16::from(lv) + u16::from(lw) == 510",
        "big % 10 == 3 && big / 10 == 2 && big & 1 == 1",
        "big & 0x30 == 0x10 && big & 0x10 != 0",
        "sg.abs() > 5 && sg < 5",
        "big & 0x8000_0000 != 0 && big & 0xF == 5 && big >> 8 & 1 == 1",
        "(big | 0xFF) == 0x1FF && big & 0x10 == 0 && big ^ 3 == 0x100",
        "rising(lv * 2 == 6) && lv < 4",
        "lv.saturating_sub(lw) > 3 && lw.abs_diff(lv) < 5",
        "hi - 1 > lv && lv > 3",
        "lv > 0 && 100 / lv > 30",
        "big * big == 81 && big > 8",
        "lv - lw == 1 && lw << 1 == 4",
        "n - 5 > 7 && n < 14",
        "(go as u8) + lv == 1 && lv == 0",
    ] {
        holds(&back(condition));
    }
    for condition in [
        "lv < 1 && lv * 2 > 5",
        "lv * 2 == 5",
        "lv + lw > 8 && lv < 4 && lw < 6",
        "lv as u16 > 300",
        "(lv as u16) * 4 > 1019 && lv < 255",
        "big % 10 == 3 && big / 10 == 2 && big & 1 == 0",
        "big & 0x10 != 0 && big & 0x30 == 0",
        "big & 1 == 1 && big & 3 == 2",
        "(big << 4) & 0xF != 0 || (big >> 4) & 0xF000_0000 != 0",
        "rising(lv * 2 == 5)",
        "lv >= lw && lv - lw > 200 && lv < 150",
        "sg.abs() == 5 && sg > 5",
        "lv.min(3) > 3",
        "lv.clamp(3, 5) == 6",
        "lv.saturating_add(lw) < lv",
        "lv >> 3 == 31 && lv < 248",
        "(go as u8) + lv == 1 && lv == 1 && go",
    ] {
        fails(&back(condition), "not_home", "no way back");
    }
    // Only where a result does not fit into its type, or nobody knows.
    for (condition, word) in [
        ("lv * 2 == 6 && lv > 3", "`lv * 2`"),
        ("sg.abs() < 5 && sg < -5", "`sg.abs()`"),
        ("lv - 1 > 250 && lv < 200", "`lv - 1`"),
        ("lv.ilog2() > 20", "`lv.ilog2()`"),
        ("lv << lw == 4 && lw > 1", "`lv << lw`"),
        ("rising(lv * 2 == 6) && lv > 4", "`lv * 2`"),
        ("x * 2.0 > 3.0 && x < 1.0", "`x * 2.0`"),
        ("lv / (lw - lw) > 3", "`lv / (lw - lw)`"),
        ("n + 5 > 5_000_000_000", "`n + 5`"),
    ] {
        fails(&back(condition), "property_undecided", word);
    }
}

/// A variable that is not followed, with inputs that cannot be chosen whatever it is.
#[test]
fn what_is_tied_to_a_variable_cannot_be_chosen() {
    let chart = |ways: &str| {
        format!(
            "sfc Chart {{ input lv, new: u8; var c: u8; initial step A; step B {{ P1 c = new; }} A -[lv > 3]-> B; {ways} home A; }}"
        )
    };
    for ways in [
        "B -[lv < 3 && c > lv]-> A; B -[lv > 100 && c <= lv]-> A;",
        "B -[lv < 3 && c + lv > 5]-> A; B -[lv > 100 && c + lv <= 5]-> A;",
        "B -[lv < 3 && near(c, lv)]-> A; B -[lv > 100 && !near(c, lv)]-> A;",
    ] {
        let pure = if ways.contains("near") { "assume pure near;" } else { "" };
        fails(&chart(&format!("{pure} {ways}")), "property_undecided", "c");
    }
    holds(&chart("B -[c > lv]-> A; B -[c <= lv]-> A;"));
}

#[test]
fn two_floats() {
    let chart = |rest: &str| {
        format!(
            "sfc Heater {{ #![allow(grafcet::unused_input, grafcet::never_true, grafcet::dead_transition, grafcet::deadlock)] input t, u: f32; input p, hi, lo: f64; \
             output heat, cool: bool; initial step Rest; step Heat {{ N heat; }} step Cool {{ N cool; }} \
             Rest -[p < lo]-> Cool -[p >= lo]-> Rest; {rest} }}"
        )
    };
    let ring = "Rest -[p > hi]-> Heat -[p <= hi]-> Rest;";
    holds(&chart(&format!(
        "{ring} home Rest; never heat && cool; assume never lo > hi; never Rest.X && p > hi && p < lo;"
    )));
    fails(&chart(&format!("{ring} never Rest.X && p > hi && p < lo;")), "property_violated", "p > hi");
    // Which is no number is neither.
    fails(
        &chart(&format!("{ring} assume never lo > hi; always Rest.X => p <= hi || p > hi;")),
        "property_violated",
        "",
    );
    holds(&chart("Rest -[t > u && u > 3.0 && t > 3.5]-> Heat -[t < u]-> Rest; home Rest;"));
    fails(&chart("Rest -[t > u && u > 3.0]-> Heat -[t < u && u < 2.0 && t > 2.0]-> Rest; home Rest;"), "not_home", "");
    fails(&chart("Rest -[t > u]-> Heat -[t < t]-> Rest; home Rest;"), "not_home", "");
    holds(&chart("Rest -[t > u]-> Heat -[t != t && !(u < t) && u > 3.0]-> Rest; home Rest;"));
}
