//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::line24v::{Line24V, Line24VInputs, Line24VStep};

#[test]
fn sequence_1() {
    let mut chart = Line24V::new();

    // Cycle 0: -
    let inputs = Line24VInputs { b1: false, b2: false, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S1]), "cycle 0: {:?}", chart.situation());
    assert!(outputs.q1, "cycle 0: q1");
    assert!(!outputs.q2, "cycle 0: q2");
    assert!(!outputs.q3, "cycle 0: q3");

    // Cycle 1: S1 → S2, S2 → S3
    let inputs = Line24VInputs { b1: true, b2: true, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S3]), "cycle 1: {:?}", chart.situation());
    assert!(!outputs.q1, "cycle 1: q1");
    assert!(outputs.q2, "cycle 1: q2");
    assert!(!outputs.q3, "cycle 1: q3");

    // Cycle 2: S3 → S4, S4 → S1
    let inputs = Line24VInputs { b1: false, b2: false, b3: true, b4: true, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S1]), "cycle 2: {:?}", chart.situation());
    assert!(outputs.q1, "cycle 2: q1");
    assert!(!outputs.q2, "cycle 2: q2");
    assert!(!outputs.q3, "cycle 2: q3");

    // Cycle 3: -
    let inputs = Line24VInputs { b1: false, b2: false, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S1]), "cycle 3: {:?}", chart.situation());
    assert!(outputs.q1, "cycle 3: q1");
    assert!(!outputs.q2, "cycle 3: q2");
    assert!(!outputs.q3, "cycle 3: q3");

    // Cycle 4: S1 → S2
    let inputs = Line24VInputs { b1: true, b2: false, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S2]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.q1, "cycle 4: q1");
    assert!(outputs.q2, "cycle 4: q2");
    assert!(!outputs.q3, "cycle 4: q3");

    // Cycle 5: -
    let inputs = Line24VInputs { b1: false, b2: false, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(500), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S2]), "cycle 5: {:?}", chart.situation());
    assert!(!outputs.q1, "cycle 5: q1");
    assert!(outputs.q2, "cycle 5: q2");
    assert!(!outputs.q3, "cycle 5: q3");

    // Cycle 6: S2 → S3
    let inputs = Line24VInputs { b1: false, b2: true, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(600), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S3]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.q1, "cycle 6: q1");
    assert!(outputs.q2, "cycle 6: q2");
    assert!(!outputs.q3, "cycle 6: q3");

    // Cycle 7: -
    let inputs = Line24VInputs { b1: false, b2: false, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(700), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S3]), "cycle 7: {:?}", chart.situation());
    assert!(!outputs.q1, "cycle 7: q1");
    assert!(outputs.q2, "cycle 7: q2");
    assert!(!outputs.q3, "cycle 7: q3");

    // Cycle 8: S3 → S4
    let inputs = Line24VInputs { b1: false, b2: false, b3: true, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(800), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S4]), "cycle 8: {:?}", chart.situation());
    assert!(!outputs.q1, "cycle 8: q1");
    assert!(!outputs.q2, "cycle 8: q2");
    assert!(!outputs.q3, "cycle 8: q3");

    // Cycle 9: -
    let inputs = Line24VInputs { b1: false, b2: false, b3: false, b4: false, b5: false };
    let outputs = chart.scan(&inputs, Ticks::new(900), &mut ());
    assert!(chart.is_exactly(&[Line24VStep::S4]), "cycle 9: {:?}", chart.situation());
    assert!(!outputs.q1, "cycle 9: q1");
    assert!(!outputs.q2, "cycle 9: q2");
    assert!(!outputs.q3, "cycle 9: q3");
}
