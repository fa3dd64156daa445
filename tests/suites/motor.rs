//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::motor::{Motor, MotorInputs, MotorStep};

#[test]
fn sequence_1() {
    let mut chart = Motor::new();

    // Cycle 0: -
    let inputs = MotorInputs { on: false, off: false, over_temp: false };
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[MotorStep::Off]), "cycle 0: {:?}", chart.situation());
    assert!(!outputs.relay, "cycle 0: relay");
    assert!(!outputs.green, "cycle 0: green");
    assert!(outputs.red, "cycle 0: red");

    // Cycle 1: -
    let inputs = MotorInputs { on: false, off: false, over_temp: false };
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut ());
    assert!(chart.is_exactly(&[MotorStep::Off]), "cycle 1: {:?}", chart.situation());
    assert!(!outputs.relay, "cycle 1: relay");
    assert!(!outputs.green, "cycle 1: green");
    assert!(outputs.red, "cycle 1: red");

    // Cycle 2: Off → On
    let inputs = MotorInputs { on: true, off: false, over_temp: false };
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut ());
    assert!(chart.is_exactly(&[MotorStep::On]), "cycle 2: {:?}", chart.situation());
    assert!(outputs.relay, "cycle 2: relay");
    assert!(outputs.green, "cycle 2: green");
    assert!(!outputs.red, "cycle 2: red");

    // Cycle 3: -
    let inputs = MotorInputs { on: false, off: false, over_temp: false };
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut ());
    assert!(chart.is_exactly(&[MotorStep::On]), "cycle 3: {:?}", chart.situation());
    assert!(outputs.relay, "cycle 3: relay");
    assert!(outputs.green, "cycle 3: green");
    assert!(!outputs.red, "cycle 3: red");

    // Cycle 4: On → Off
    let inputs = MotorInputs { on: false, off: false, over_temp: true };
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut ());
    assert!(chart.is_exactly(&[MotorStep::Off]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.relay, "cycle 4: relay");
    assert!(!outputs.green, "cycle 4: green");
    assert!(outputs.red, "cycle 4: red");
}
