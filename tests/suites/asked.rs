//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::asked::{Asked, AskedInputs, AskedStep};

/// What the program around `Asked` answers in a cycle.
#[derive(Clone, Copy, Debug)]
struct Answers {
    /// `is_calm(3)`
    is_calm_3: bool,
}

/// To be written by you: after this, the functions and constants of the program that the chart asks give these answers. What they look at, as a
/// `thread_local!` that they read under `cfg(test)`, can be set here; of what cannot change it can be asserted that it is so.
fn the_program_answers(answers: Answers) {
    super::asked::answer(answers.is_calm_3);
}

#[test]
fn sequence_1() {
    let mut chart = Asked::new();

    // Cycle 0: -
    let inputs = AskedInputs { on: false };
    the_program_answers(Answers { is_calm_3: false });
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[AskedStep::Off]), "cycle 0: {:?}", chart.situation());
    assert!(!outputs.relay, "cycle 0: relay");

    // Cycle 1: -
    let inputs = AskedInputs { on: false };
    the_program_answers(Answers { is_calm_3: false });
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut ());
    assert!(chart.is_exactly(&[AskedStep::Off]), "cycle 1: {:?}", chart.situation());
    assert!(!outputs.relay, "cycle 1: relay");

    // Cycle 2: Off → On
    let inputs = AskedInputs { on: true };
    the_program_answers(Answers { is_calm_3: true });
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut ());
    assert!(chart.is_exactly(&[AskedStep::On]), "cycle 2: {:?}", chart.situation());
    assert!(outputs.relay, "cycle 2: relay");

    // Cycle 3: -
    let inputs = AskedInputs { on: false };
    the_program_answers(Answers { is_calm_3: true });
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut ());
    assert!(chart.is_exactly(&[AskedStep::On]), "cycle 3: {:?}", chart.situation());
    assert!(outputs.relay, "cycle 3: relay");

    // Cycle 4: On → Off
    let inputs = AskedInputs { on: false };
    the_program_answers(Answers { is_calm_3: false });
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut ());
    assert!(chart.is_exactly(&[AskedStep::Off]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.relay, "cycle 4: relay");
}
