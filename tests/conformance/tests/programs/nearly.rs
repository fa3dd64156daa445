//! Charts that are nearly those which a pass makes shorter, and for which it must not do the same.

use std::fmt::Write as _;

use super::passes::{drawn, each_left_out, storm};
use super::read;

fn plays(chart: &str) {
    let model = read(chart);
    each_left_out(&model, &storm(&["a", "b", "c"], 300), 100);
    each_left_out(&model, &drawn(&[("a", false), ("b", false), ("c", true)], 300), 0);
}

/// A time that has reached one limit has not reached the next one, and one that is short of a limit may have reached the one before.
#[test]
fn a_limit_tells_nothing_of_one_that_is_a_tick_further() {
    plays(
        "sfc Limits { input a, b, c: bool; output p, q: bool; initial step A; step B { p; } step C { q; } step E { p; q; } \
         A -[5ms/A && a]-> B; A -[6ms/A && b]-> C; A -[5ms/A && c]-> E; B -[5ms/B]-> A; B -[4ms/B && a]-> C; C -[true]-> A; E -[!c]-> A; }",
    );
}

/// That the time of one branch is short of a limit says nothing of the time of another one.
#[test]
fn a_limit_tells_nothing_of_another_time() {
    plays(
        "sfc Times { input a, b, c: bool; output p, q: bool; initial step I; step A { p; } step B; step F; step G { q; } step H { p; } \
         I -[true]-> (A, F); A -[a && 7ms/A]-> B -[b && a && 8ms/B]-> A; F -[3ms/F]-> G -[a]-> F; F -[5ms/A && b]-> H -[5ms/H]-> F; \
         (B, G) -[!a && c]-> I; }",
    );
}

/// Of two branches one shows a variable, the other one does `first` and `second`.
fn meter(third: &str, more: &str, [first, second]: [&str; 2]) -> String {
    format!(
        "sfc Meter {{ input a, b, c: bool; output lamp, p: bool; var m: bool = false; initial step Idle {{ N lamp if m; }} \
         step A1 {{ N lamp if m; }} step A2 {{ {third} }} step A3 {{ {more} }} step A4 {{ N lamp if m; }} \
         step B1 {{ p; }} step B2 {{ {first} }} step B3 {{ {second} }} \
         Idle -[a]-> (A1, B1); A1 -[b]-> A2 -[!b]-> A3 -[c && !b]-> A4 -[c && a]-> A1; A4 -[!c]-> A2; \
         B1 -[c]-> B2 -[!c && !b]-> B3 -[b]-> B1; (A3, B2) -[a && b]-> Idle; }}"
    )
}

/// An output shows what a variable was when it was asked: where a later action of the cycle writes that, the output is not what the variable holds in the end.
#[test]
fn an_output_shows_what_a_variable_was_before_others_wrote_it() {
    let (plain, more) = ("N lamp if m;", "N lamp if m || c;");
    let writes = [["P1 m = true;", "P1 m = false;"], ["P1 { m = true; }", "P1 { m = false; }"]];
    for (third, writes) in [plain, more].into_iter().flat_map(|third| writes.map(|writes| (third, writes))) {
        plays(&meter(third, plain, writes));
    }
}

/// An output that in one step is off, or on, or what an input says, is not everywhere what the variable holds that the other steps show.
#[test]
fn an_output_that_one_step_tells_otherwise_is_not_what_a_variable_holds() {
    for third in ["", "N lamp;", "N lamp if c;", "N lamp if m || c;"] {
        plays(&meter(third, "P1 m = true; N lamp;", ["", ""]));
    }
    // It is off while the lamp is on.
    let chart = meter("N lamp if m || c;", "P1 m = false; N lamp;", ["", ""]);
    plays(&chart.replacen("m: bool = false", "m: bool = true", 1));
}

/// A branch that waits in two states beside one step of another branch is not in that which one of them tells.
#[test]
fn what_stands_alone_in_one_state_does_not_in_all() {
    plays(
        "sfc Alone { input a, b, c: bool; initial step S0; step S1; step S2; step S3; step S4; step S5; step S6; step S7; step S8; step S9; \
         S0 -[a]-> (S1, S2); S2 -[a]-> S3; S3 -[a]-> S4; (S1, S4) -[a]-> S5; S5 -[a]-> (S6, S7); (S6, S7) -[a]-> S8; S8 -[a]-> S9; S9 -[a]-> S0; }",
    );
}

/// Inputs that stay for some cycles, of which many are as long as a cycle may be: whatever lasts goes around the clock.
fn far(inputs: &[&str]) -> String {
    let (mut text, mut seed, mut now, mut held) = ("---\n---\n".to_owned(), 3_u32, 9_u32, 0);
    for cycle in 0..600 {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        if cycle % 6 == 0 {
            held = seed >> 20;
        }
        for (bit, name) in inputs.iter().enumerate() {
            if held >> bit & 1 == 1 {
                _ = write!(text, "{name} ");
            }
        }
        _ = writeln!(text, "@{now} | |");
        now = now.wrapping_add([1, 2, 0x7fff_ffff, 0x7fff_ffff][(seed >> 28) as usize % 4]);
    }
    text
}

/// A step that is left when its time is over, but only together with another one, stays beyond its time; so does one that leads back to itself, where the bound stops the search.
#[test]
fn a_step_may_stay_when_its_time_is_over() {
    for chart in [
        "sfc Join { input a, b, c: bool; output p, q: bool; initial step I; step A { p; } step B; step C { q; } \
         I -[a]-> (A, B); B -[c]-> C -[b && !c]-> B; (A, C) -[5ms/A]-> I; }",
        "grafcet Kept { max_evolutions 3; input a, b, c: bool; output p, q: bool; initial step A { p; } step B { q; } \
         A -[5ms/A]-> A; A -[b]-> B -[a && !b]-> A; }",
    ] {
        each_left_out(&read(chart), &far(&["a", "b", "c"]), 0);
        each_left_out(&read(chart), &storm(&["a", "b", "c"], 300), 100);
    }
}

/// Two partial grafcets one of which waits for the other need more evolutions than the longest way of one; one with parallel branches begins as often as another one forces it to. A bound
/// in between stops them.
#[test]
fn a_search_that_is_longer_than_its_bound_is_stopped() {
    let waits = "output p, q: bool; partial X { initial step A; step B; step C; step E { p; } A -[a]-> B -[true]-> C -[true]-> E -[rising(b)]-> A; } \
                 partial Y { initial step F; step G { q; } F -[E.X]-> G -[rising(c)]-> F; }";
    let mut forces = "output p, q: bool; partial Above { initial step M0; ".to_owned();
    for time in 0..3 {
        let (from, at, to) = (2 * time, 2 * time + 1, 2 * time + 2);
        let waits = if time == 0 { "a" } else { "T2.X" };
        _ = write!(
            forces,
            "step M{at} {{ force Below {{T1}}; }} step M{to}; M{from} -[{waits}]-> M{at} -[true]-> M{to}; "
        );
    }
    forces += "M6 -[rising(b)]-> M0; } partial Below { initial step T1; step U; step V; step T2 { q; } \
               T1 -[true]-> (U, V); (U, V) -[true]-> T2; T2 -[rising(c)]-> T1; }";
    for (partials, bounds) in [(waits, 3..6), (&forces, 8..12)] {
        for bound in bounds {
            plays(&format!("grafcet Long {{ max_evolutions {bound}; input a, b, c: bool; {partials} }}"));
        }
    }
}

/// A stop that would panic beside a step that it does not leave is not asked there.
#[test]
fn what_would_panic_elsewhere_is_asked_where_it_does_not() {
    let mut text = "Line { input a, b, c: bool; output p, q: bool; var k: u8 = 0; initial step Idle { P1 k = 0; } step Stopped { q; P1 k = 0; } \
                    step T0 { p if a; P1 k = 4; } Idle -[a && !c]-> T0; "
        .to_owned();
    for step in 1..16 {
        _ = write!(text, "step T{step} {{ p if a; }} T{} -[b && {}ms/T{0}]-> T{step}; ", step - 1, 2 + step % 3);
    }
    text += "T15 -[!b]-> Idle; Stopped -[!c]-> Idle; any except (Idle, Stopped) -[20 / k > 3 && c]-> Stopped; }";
    for dialect in ["sfc", "grafcet"] {
        plays(&format!("{dialect} {text}"));
    }
}
