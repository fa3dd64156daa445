//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::stroke::{Press, PressInputs, PressStep};

#[test]
fn sequence_1() {
    let mut chart = Press::new();

    // Cycle 0: -
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: false, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[PressStep::Rest]), "cycle 0: {:?}", chart.situation());
    assert!(!outputs.lower, "cycle 0: lower");
    assert!(!outputs.lift, "cycle 0: lift");
    assert!(outputs.lamp, "cycle 0: lamp");

    // Cycle 1: -
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: false, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut ());
    assert!(chart.is_exactly(&[PressStep::Rest]), "cycle 1: {:?}", chart.situation());
    assert!(!outputs.lower, "cycle 1: lower");
    assert!(!outputs.lift, "cycle 1: lift");
    assert!(outputs.lamp, "cycle 1: lamp");

    // Cycle 2: Rest → Lower
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: true, top: true, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut ());
    assert!(chart.is_exactly(&[PressStep::Lower]), "cycle 2: {:?}", chart.situation());
    assert!(outputs.lower, "cycle 2: lower");
    assert!(!outputs.lift, "cycle 2: lift");
    assert!(!outputs.lamp, "cycle 2: lamp");

    // Cycle 3: -
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: false, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut ());
    assert!(chart.is_exactly(&[PressStep::Lower]), "cycle 3: {:?}", chart.situation());
    assert!(outputs.lower, "cycle 3: lower");
    assert!(!outputs.lift, "cycle 3: lift");
    assert!(!outputs.lamp, "cycle 3: lamp");

    // Cycle 4: Lower → Hold
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: false, bottom: true };
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut ());
    assert!(chart.is_exactly(&[PressStep::Hold]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.lower, "cycle 4: lower");
    assert!(!outputs.lift, "cycle 4: lift");
    assert!(!outputs.lamp, "cycle 4: lamp");

    // Cycle 5: -
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: false, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(500), &mut ());
    assert!(chart.is_exactly(&[PressStep::Hold]), "cycle 5: {:?}", chart.situation());
    assert!(!outputs.lower, "cycle 5: lower");
    assert!(!outputs.lift, "cycle 5: lift");
    assert!(!outputs.lamp, "cycle 5: lamp");

    // Cycle 6: Hold → Lift
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: false, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(1400), &mut ());
    assert!(chart.is_exactly(&[PressStep::Lift]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.lower, "cycle 6: lower");
    assert!(outputs.lift, "cycle 6: lift");
    assert!(!outputs.lamp, "cycle 6: lamp");

    // Cycle 7: -
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: false, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(1500), &mut ());
    assert!(chart.is_exactly(&[PressStep::Lift]), "cycle 7: {:?}", chart.situation());
    assert!(!outputs.lower, "cycle 7: lower");
    assert!(outputs.lift, "cycle 7: lift");
    assert!(!outputs.lamp, "cycle 7: lamp");

    // Cycle 8: Lift → Rest
    let inputs = PressInputs { semi_automatic: false, manual: false, paused: false, push: false, start: false, top: true, bottom: false };
    let outputs = chart.scan(&inputs, Ticks::new(1600), &mut ());
    assert!(chart.is_exactly(&[PressStep::Rest]), "cycle 8: {:?}", chart.situation());
    assert!(!outputs.lower, "cycle 8: lower");
    assert!(!outputs.lift, "cycle 8: lift");
    assert!(outputs.lamp, "cycle 8: lamp");
}
