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

/// A search begins again behind one that has changed what a delay looks at, and only there.
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
