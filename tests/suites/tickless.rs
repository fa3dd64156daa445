//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::tickless::{Crossing, CrossingInputs, CrossingStep};

#[test]
fn sequence_1() {
    let mut chart = Crossing::new();

    // Cycle 0: -
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Cars]), "cycle 0: {:?}", chart.situation());
    assert!(outputs.green, "cycle 0: green");
    assert!(!outputs.yellow, "cycle 0: yellow");
    assert!(!outputs.red, "cycle 0: red");
    assert!(!outputs.wait, "cycle 0: wait");
    assert!(!outputs.walk, "cycle 0: walk");
    assert!(!outputs.chirp, "cycle 0: chirp");
    assert!(!outputs.hurry, "cycle 0: hurry");

    // Cycle 1: -
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Cars]), "cycle 1: {:?}", chart.situation());
    assert!(outputs.green, "cycle 1: green");
    assert!(!outputs.yellow, "cycle 1: yellow");
    assert!(!outputs.red, "cycle 1: red");
    assert!(!outputs.wait, "cycle 1: wait");
    assert!(!outputs.walk, "cycle 1: walk");
    assert!(!outputs.chirp, "cycle 1: chirp");
    assert!(!outputs.hurry, "cycle 1: hurry");

    // Cycle 2: Cars → Asked
    let inputs = CrossingInputs { button: true };
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Asked]), "cycle 2: {:?}", chart.situation());
    assert!(outputs.green, "cycle 2: green");
    assert!(!outputs.yellow, "cycle 2: yellow");
    assert!(!outputs.red, "cycle 2: red");
    assert!(outputs.wait, "cycle 2: wait");
    assert!(!outputs.walk, "cycle 2: walk");
    assert!(!outputs.chirp, "cycle 2: chirp");
    assert!(!outputs.hurry, "cycle 2: hurry");

    // Cycle 3: -
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Asked]), "cycle 3: {:?}", chart.situation());
    assert!(outputs.green, "cycle 3: green");
    assert!(!outputs.yellow, "cycle 3: yellow");
    assert!(!outputs.red, "cycle 3: red");
    assert!(outputs.wait, "cycle 3: wait");
    assert!(!outputs.walk, "cycle 3: walk");
    assert!(!outputs.chirp, "cycle 3: chirp");
    assert!(!outputs.hurry, "cycle 3: hurry");

    // Cycle 4: Asked → Yellow
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(5200), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Yellow]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 4: green");
    assert!(outputs.yellow, "cycle 4: yellow");
    assert!(!outputs.red, "cycle 4: red");
    assert!(outputs.wait, "cycle 4: wait");
    assert!(!outputs.walk, "cycle 4: walk");
    assert!(!outputs.chirp, "cycle 4: chirp");
    assert!(!outputs.hurry, "cycle 4: hurry");

    // Cycle 5: -
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(5300), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Yellow]), "cycle 5: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 5: green");
    assert!(outputs.yellow, "cycle 5: yellow");
    assert!(!outputs.red, "cycle 5: red");
    assert!(outputs.wait, "cycle 5: wait");
    assert!(!outputs.walk, "cycle 5: walk");
    assert!(!outputs.chirp, "cycle 5: chirp");
    assert!(!outputs.hurry, "cycle 5: hurry");

    // Cycle 6: Yellow → Stop
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(8200), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Stop]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 6: green");
    assert!(!outputs.yellow, "cycle 6: yellow");
    assert!(outputs.red, "cycle 6: red");
    assert!(outputs.wait, "cycle 6: wait");
    assert!(!outputs.walk, "cycle 6: walk");
    assert!(!outputs.chirp, "cycle 6: chirp");
    assert!(!outputs.hurry, "cycle 6: hurry");

    // Cycle 7: -
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(8300), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Stop]), "cycle 7: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 7: green");
    assert!(!outputs.yellow, "cycle 7: yellow");
    assert!(outputs.red, "cycle 7: red");
    assert!(outputs.wait, "cycle 7: wait");
    assert!(!outputs.walk, "cycle 7: walk");
    assert!(!outputs.chirp, "cycle 7: chirp");
    assert!(!outputs.hurry, "cycle 7: hurry");

    // Cycle 8: Stop → Walk
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(10200), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Walk]), "cycle 8: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 8: green");
    assert!(!outputs.yellow, "cycle 8: yellow");
    assert!(outputs.red, "cycle 8: red");
    assert!(!outputs.wait, "cycle 8: wait");
    assert!(outputs.walk, "cycle 8: walk");
    assert!(outputs.chirp, "cycle 8: chirp");
    assert!(!outputs.hurry, "cycle 8: hurry");

    // Cycle 9: -
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(10300), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Walk]), "cycle 9: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 9: green");
    assert!(!outputs.yellow, "cycle 9: yellow");
    assert!(outputs.red, "cycle 9: red");
    assert!(!outputs.wait, "cycle 9: wait");
    assert!(outputs.walk, "cycle 9: walk");
    assert!(outputs.chirp, "cycle 9: chirp");
    assert!(!outputs.hurry, "cycle 9: hurry");

    // Cycle 10: Walk → Clear
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(18200), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Clear]), "cycle 10: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 10: green");
    assert!(!outputs.yellow, "cycle 10: yellow");
    assert!(outputs.red, "cycle 10: red");
    assert!(!outputs.wait, "cycle 10: wait");
    assert!(!outputs.walk, "cycle 10: walk");
    assert!(!outputs.chirp, "cycle 10: chirp");
    assert!(!outputs.hurry, "cycle 10: hurry");

    // Cycle 11: -
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(18300), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Clear]), "cycle 11: {:?}", chart.situation());
    assert!(!outputs.green, "cycle 11: green");
    assert!(!outputs.yellow, "cycle 11: yellow");
    assert!(outputs.red, "cycle 11: red");
    assert!(!outputs.wait, "cycle 11: wait");
    assert!(!outputs.walk, "cycle 11: walk");
    assert!(!outputs.chirp, "cycle 11: chirp");
    assert!(!outputs.hurry, "cycle 11: hurry");

    // Cycle 12: Clear → Cars
    let inputs = CrossingInputs { button: false };
    let outputs = chart.scan(&inputs, Ticks::new(22200), &mut ());
    assert!(chart.is_exactly(&[CrossingStep::Cars]), "cycle 12: {:?}", chart.situation());
    assert!(outputs.green, "cycle 12: green");
    assert!(!outputs.yellow, "cycle 12: yellow");
    assert!(!outputs.red, "cycle 12: red");
    assert!(!outputs.wait, "cycle 12: wait");
    assert!(!outputs.walk, "cycle 12: walk");
    assert!(!outputs.chirp, "cycle 12: chirp");
    assert!(!outputs.hurry, "cycle 12: hurry");
}
