//! A fork of several branches: what they do is asked for where they are active, put into the outputs at once, and a search that goes on for ever is stopped after an evolution.

use std::fmt::Write as _;

use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::program as optimised;

use super::passes::{drawn, each_left_out};
use super::read;

/// Four branches put four outputs together.
pub(super) const WASH: &str = "grafcet Wash { input start, a, b, c, off: bool; output water, brush, foam, lamp: bool; initial step Idle; \
     step Left1 { water; brush; } step Left2 { foam; lamp; } step Right1 { water; foam; } step Right2 { brush; } step Top1 { brush; lamp; } \
     step Top2 { foam; } step Back1 { lamp; } step Back2 { water; } \
     Idle -[start]-> (Left1, Right1, Top1, Back1); Left1 -[a]-> Left2; Right1 -[b]-> Right2; Top1 -[c]-> Top2; Back1 -[a && c]-> Back2; \
     (Left2, Right2, Top2, Back2) -[off]-> Idle; }";

const INPUTS: [(&str, bool); 5] = [("start", false), ("a", false), ("b", false), ("c", false), ("off", false)];

fn text(chart: &str, left_out: &[Pass]) -> String {
    let mut passes = Pass::ALL.to_vec();
    passes.retain(|pass| !left_out.contains(pass));
    optimised(&read(chart), &passes).expect("a program").to_string()
}

fn is_the_same(chart: &str) {
    each_left_out(&read(chart), &drawn(&INPUTS, 300), 100);
}

/// A search that has made as many evolutions as the bound says has come back to the step that is active alone: nothing is tried and taken back.
#[test]
fn a_search_that_goes_on_for_ever_is_stopped_after_an_evolution() {
    let stopped = text(WASH, &[]);
    let end =
        "      break\n    evolutions = evolutions + 1\n    if evolutions == 20:\n      stable = false\n      break\n";
    assert!(stopped.contains(end) && !stopped.contains("was.state"), "{stopped}");
    is_the_same(WASH);
    is_the_same(&WASH.replacen("input start", "max_evolutions 9; input start", 1));
    // What asks for a step of another branch may wait for it as long as it likes.
    for other in [
        WASH.replacen("Left1 -[a]", "Left1 -[a && !Right1.X]", 1),
        WASH.replacen("input start", "max_evolutions 3; input start", 1),
    ] {
        let tried = text(&other, &[]);
        assert!(tried.contains("state.Idle = was.state.") && !tried.contains(end), "{tried}");
        is_the_same(&other);
    }
}

/// Outside the branches nobody asks for them.
#[test]
fn what_branches_do_is_asked_for_where_they_are_active() {
    let within = "  match state.Idle\n    Idle:\n    else:\n      match state.Idle\n        Left1:\n";
    assert!(text(WASH, &[]).contains(within), "{}", text(WASH, &[]));
    // An arm that does something stays, and so does what all others share.
    let busy = WASH.replacen("initial step Idle;", "initial step Idle { lamp; } step End { foam; }", 1);
    let busy = busy.replacen("-[off]-> Idle;", "-[off]-> End; End -[!off]-> Idle;", 1);
    let shown = text(&busy, &[]);
    assert!(shown.contains("  match state.Idle\n    Idle: lamp = true\n    End: foam = true\n    else:\n"), "{shown}");
    is_the_same(&busy);
    // Two branches are asked for as they were.
    let two = "grafcet Two { input start, a, b, c, off: bool; output p, q: bool; initial step Idle; step A1 { p; } step A2; step B1 { q; } step B2; \
               Idle -[start]-> (A1, B1); A1 -[a]-> A2; B1 -[b]-> B2; (A2, B2) -[off && !c]-> Idle; }";
    assert!(!text(two, &[]).contains("else:\n      match state.Idle\n        A1: p"), "{}", text(two, &[]));
}

/// Outputs are put together in their own places, be they many or few, unless something asks for them.
#[test]
fn outputs_are_put_together_in_their_own_places() {
    assert!(!text(WASH, &[]).contains("next."), "{}", text(WASH, &[]));
    assert!(text(WASH, &[Pass::Direct]).contains("foam = next.foam"), "{}", text(WASH, &[Pass::Direct]));
    let few =
        WASH.replacen("step Top2 { foam; }", "step Top2;", 1).replacen("Left2 { foam; lamp; }", "Left2 { lamp; }", 1);
    assert!(!text(&few, &[]).contains("next."), "{}", text(&few, &[]));
    let asked = WASH.replacen("Left1 -[a]", "Left1 -[a && !foam]", 1);
    let kept = text(&asked, &[]);
    assert!(kept.contains("foam = next.foam") && !kept.contains("water = next.water"), "{kept}");
    for chart in [few, asked, WASH.replacen("foam, lamp: bool", "foam: bool; output lamp: bool = true", 1)] {
        is_the_same(&chart);
    }
}

/// A number is put into its output at once, too, and what the output begins with is not put there first. Of several the last one counts (A35), also with the value
/// that the output begins with.
#[test]
fn an_output_begins_with_its_own_value() {
    let heat = "grafcet Heat { #![allow(grafcet::conflicting_values)] input start, a, b, c, off: bool; output power: u16 = 3; output n: u8; output p: bool; \
                initial step Idle; step A1 { power = 10; } step A2 { power = 3; n = 4; } step A3; step B1 { p; power = 3; } step B2 { n = 9; power = 7; } \
                Idle -[start]-> (A1, B1); A1 -[a]-> A2 -[b]-> A3; B1 -[b]-> B2; (A3, B2) -[off]-> Idle; }";
    let (shown, left_out) = (text(heat, &[]), text(heat, &[Pass::Direct]));
    assert!(left_out.contains("next.power = 3") && !shown.contains("next."), "{shown}");
    is_the_same(heat);
    is_the_same(&heat.replacen("n = 9", "n = 0", 1));
    is_the_same(&heat.replacen("p: bool;", "p: bool; output lag: time = 2ms;", 1).replacen(
        "step A3;",
        "step A3 { lag = 5ms; }",
        1,
    ));
}

/// The tables of a long sequence still ask for its state where a place in front of it is gone.
#[test]
fn tables_follow_when_places_are_counted_anew() {
    let mut ring =
        "grafcet Ring { optimize size; input start, a, b, c, off: bool; output p: bool; output level: u8; ".to_owned();
    for step in 0..24 {
        let initial = if step == 0 { "initial " } else { "" };
        let action = ["", "p;", "level = 8;", "level = 3 + 4;"][step % 4];
        let input = ["start", "!a", "b", "!c"][step % 4];
        _ = write!(ring, "{initial}step S{step} {{ {action} }} S{step} -[{input}]-> S{}; ", (step + 1) % 24);
    }
    ring.push('}');
    let shown = text(&ring, &[]);
    assert!(shown.contains("table(now.state)") && !shown.contains("next.level"), "{shown}");
    is_the_same(&ring);
}

/// An event that is an edge of inputs comes in the first evolution of a search alone, and one of a step, or of what is stored with steps, after a clearing: they keep no search from
/// its end. What an event stores may be the next event.
#[test]
fn a_search_with_events_that_come_to_an_end_has_no_bound() {
    for (event, bounded) in [
        ("rising(c)", false),
        ("falling(b) && n < 4", false),
        ("rising(c) || falling(b)", false),
        ("rising(B.X)", false),
        ("rising(c) || falling(A.X && b) && n < 4", false),
        ("rising(m > 1)", false),
        ("rising(n > 1)", true),
        ("rising(c) || rising(n > 1 && B.X)", true),
        ("rising(rising(c) || A.X)", true),
    ] {
        let chart = format!(
            "grafcet Seen {{ input a, b, c: bool; output q: bool; var n: u8 = 0; var m: u8 = 0; initial step A {{ P1 m = m % 3 + 1; }} step B {{ on {event} n = n % 5 + 1; }} step C {{ q; on rising(b) n = 0; P0 m = 1; }} \
             A -[a]-> B -[!a && n > 2]-> C -[b || 4ms/C]-> A; }}"
        );
        assert_eq!(text(&chart, &[]).contains("stable: bool"), bounded, "{event}");
        is_the_same(&chart);
    }
}
