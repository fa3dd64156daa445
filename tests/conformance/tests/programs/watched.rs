//! A sequence with watchdogs, and what it holds: steps that wait for the same share an arm, and what a field holds is shown once.

use std::fmt::Write as _;

use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::program as optimised;

use super::passes::{each_left_out, storm};
use super::read;

/// `steps` of them; each waits for one of three inputs, no longer than its watchdog says.
fn watched(steps: usize) -> String {
    let mut text =
        "sfc Unit { input a, b, c, ack: bool; output p, q, grip, alarm: bool; initial step Idle { p; } ".to_owned();
    for step in 0..steps {
        let action = ["p;", "q;", "S grip;", "R grip;"][step % 4];
        _ = write!(text, "step S{step} {{ {action} }} ");
    }
    text += "step Late { alarm; } step Lost { alarm; R grip; } Idle -[a && !ack]-> S0; Late -[ack]-> Idle; Lost -[ack]-> Idle; ";
    for step in 0..steps {
        let (input, time) = (["a", "b", "c"][step % 3], [4, 6, 3][step % 3]);
        let next = if step + 1 < steps { format!("S{}", step + 1) } else { "Idle".to_owned() };
        if step % 3 == 1 {
            _ = write!(text, "S{step} -[ack]-> Lost; ");
        }
        _ = write!(text, "S{step} -[{input}]-> {next}; S{step} -[{time}ms/S{step}]-> Late; ");
    }
    text + "}"
}

fn text(chart: &str) -> String {
    optimised(&read(chart), &Pass::ALL).expect("a program").to_string()
}

/// The table says which step is next, so those that wait for the same share an arm: with the way onward in the table, and those to the faults beside it. Where few would,
/// each has its own.
#[test]
fn steps_that_wait_for_the_same_share_an_arm_and_what_is_held_is_shown_once() {
    let long = text(&watched(18));
    assert!(long.contains("    S1|S4|S7|S10|S13|S16:\n"), "{long}");
    assert!(long.contains("state = table(state)"), "{long}");
    let short = text(&watched(4));
    assert!(!short.contains("table("), "{short}");
    for chart in [&long, &short] {
        assert_eq!(chart.matches("  grip = S_FF.grip").count(), 1, "{chart}");
    }
    for dialect in ["sfc", "grafcet"] {
        for steps in [4, 18, 24] {
            let chart = watched(steps).replacen("sfc", dialect, 1);
            each_left_out(&read(&chart), &storm(&["a", "b", "c", "ack"], 300), 150);
        }
    }
}
