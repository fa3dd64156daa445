//! What delays keep (A36), and what they cost.

use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::program as optimised;

use super::passes::{each_left_out, storm};
use super::read;

/// Of inputs alone, and on both sides of zero.
const VAT: &str = "{ input full, hot, empty, stop: bool; output pump, heat, drain: bool; \
                   initial step Idle; step Fill { pump; } step Heat { heat if 3ms/hot; } step Drain { drain; } \
                   Idle -[0s/stop/4ms]-> Fill -[5ms/full/2ms]-> Heat -[4ms/hot || stop]-> Drain -[6ms/empty]-> Idle; }";

/// So no cycle adds to a counter.
#[test]
fn a_delay_is_the_reading_at_which_it_has_changed() {
    for dialect in ["sfc", "grafcet"] {
        let model = read(&format!("{dialect} Vat {VAT}"));
        let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
        assert!(!program.contains("elapsed") && !program.contains("held"), "{program}");
        // Where it takes no time one way, that way has no reading.
        let begins = |delay: usize| program.matches(&format!("delay{delay}.since = now")).count();
        let mut all: Vec<usize> = (0..5).map(begins).collect();
        all.sort_unstable();
        assert_eq!(all, [1, 1, 1, 1, 2], "{program}");
        each_left_out(&model, &storm(&["full", "hot", "empty", "stop"], 400), 100);
    }
}

/// What the delays do stands in front of the match on the state, though less is left of it in the first cycle.
#[test]
fn the_first_cycle_has_its_part_of_what_stands_in_front() {
    let model = read(&format!("sfc Vat {VAT}"));
    let without: Vec<Pass> = Pass::ALL.into_iter().filter(|pass| *pass != Pass::Hoist).collect();
    let [hoisted, left] = [&Pass::ALL[..], &without]
        .map(|passes| optimised(&model, passes).expect("a program").to_string().matches(".since = now").count());
    assert_eq!((hoisted, left), (6, 28));
}

/// A time that may be exchanged is added up.
#[test]
fn a_delay_with_a_param_is_counted() {
    let model = read(
        "grafcet Lamp { param soak: time = 4ms; input a: bool; output q: bool; initial step A; step B { q; } \
         A -[soak/a]-> B -[2ms/!a]-> A; }",
    );
    let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
    assert!(program.contains("delay0.held") && program.contains("delay1.since"), "{program}");
    each_left_out(&model, &storm(&["a"], 300), 100);
}

/// A search begins again after one that has changed what a delay looks at, and only there.
#[test]
fn a_delay_of_a_step_has_another_search() {
    let chart = |of: &str| {
        let text = format!(
            "grafcet Lamp {{ input a, b: bool; output q: bool; initial step A; step B {{ q; }} A -[a]-> B -[3ms/{of}]-> A; }}"
        );
        let model = read(&text);
        each_left_out(&model, &storm(&["a", "b"], 300), 100);
        optimised(&model, &Pass::ALL).expect("a program").to_string()
    };
    assert!(!chart("b").contains("settled"));
    assert!(chart("(B.X && b)").contains("settled"));
}

/// Readings of the clock are compared with each other only where none lies more than 2^31 ticks ahead.
#[test]
fn a_deadline_beside_a_long_time_is_not_late() {
    let model = read(
        "grafcet Long { clock 1us; input a, b: bool; output q: bool; initial step A; step B { q; } \
         A -[1s/a]-> B -[40m/b]-> A; }",
    );
    let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
    assert!(program.contains("delay0.since") && program.contains("delay1.held"), "{program}");
    let text = "---\n---\n@0 | |\na b @10 | |\na b @500000 | |\na b @1000009 | |\na b @1000010 | |\na b @1000011 | |\n";
    each_left_out(&model, text, 6);
}

/// In the first cycle the state of the chart is that it is to come: what asks for it does not stand in front.
#[test]
fn what_asks_for_the_first_situation_is_not_asked_before_it() {
    let delays = "Idle -[2ms/(3ms/(Idle.X && b))]-> (One, Three); Three -[y]-> Four;";
    let edges = "Idle -[rising(Idle.X && b)]-> (One, Three); Three -[rising(2ms/y)]-> Four;";
    for ways in [delays, edges] {
        let model = read(&format!(
            "sfc First {{ input b, y, z: bool; output q: bool; initial step Idle; step One {{ q; }} step Three; step Four; \
             {ways} (One, Four) -[z]-> Idle; }}"
        ));
        let from_the_first: Vec<String> = (0..12).map(|at| format!("b @{at} | |")).collect();
        each_left_out(&model, &format!("---\n---\n{}\n", from_the_first.join("\n")), 12);
        each_left_out(&model, &storm(&["b", "y", "z"], 300), 100);
    }
}
