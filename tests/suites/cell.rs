//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::cell::{Cell, CellInputs, CellStep};

#[test]
fn sequence_1() {
    let mut chart = Cell::new();

    // Cycle 0: -
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Manual]), "cycle 0: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 0: conveyor");
    assert!(!outputs.clamp, "cycle 0: clamp");
    assert!(!outputs.drill, "cycle 0: drill");
    assert!(!outputs.stamp, "cycle 0: stamp");
    assert!(!outputs.alarm, "cycle 0: alarm");
    assert_eq!(outputs.parts, 0, "cycle 0: parts");

    // Cycle 1: Manual → Auto, Feed → Close
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: true, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Close]), "cycle 1: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 1: conveyor");
    assert!(outputs.clamp, "cycle 1: clamp");
    assert!(!outputs.drill, "cycle 1: drill");
    assert!(!outputs.stamp, "cycle 1: stamp");
    assert!(!outputs.alarm, "cycle 1: alarm");
    assert_eq!(outputs.parts, 0, "cycle 1: parts");

    // Cycle 2: Ready → Stopped, Stopped forces Modes {}
    let inputs = CellInputs { estop: true, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut ());
    assert!(chart.is_exactly(&[CellStep::Stopped]), "cycle 2: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 2: conveyor");
    assert!(outputs.clamp, "cycle 2: clamp");
    assert!(!outputs.drill, "cycle 2: drill");
    assert!(!outputs.stamp, "cycle 2: stamp");
    assert!(outputs.alarm, "cycle 2: alarm");
    assert_eq!(outputs.parts, 0, "cycle 2: parts");

    // Cycle 3: Stopped → Restart, Restart → Ready
    let inputs = CellInputs { estop: false, ack: true, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Manual]), "cycle 3: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 3: conveyor");
    assert!(!outputs.clamp, "cycle 3: clamp");
    assert!(!outputs.drill, "cycle 3: drill");
    assert!(!outputs.stamp, "cycle 3: stamp");
    assert!(!outputs.alarm, "cycle 3: alarm");
    assert_eq!(outputs.parts, 0, "cycle 3: parts");

    // Cycle 4: -
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Manual]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 4: conveyor");
    assert!(!outputs.clamp, "cycle 4: clamp");
    assert!(!outputs.drill, "cycle 4: drill");
    assert!(!outputs.stamp, "cycle 4: stamp");
    assert!(!outputs.alarm, "cycle 4: alarm");
    assert_eq!(outputs.parts, 0, "cycle 4: parts");

    // Cycle 5: Ready → Stopped, Stopped forces Modes {}
    let inputs = CellInputs { estop: true, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(500), &mut ());
    assert!(chart.is_exactly(&[CellStep::Stopped]), "cycle 5: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 5: conveyor");
    assert!(!outputs.clamp, "cycle 5: clamp");
    assert!(!outputs.drill, "cycle 5: drill");
    assert!(!outputs.stamp, "cycle 5: stamp");
    assert!(outputs.alarm, "cycle 5: alarm");
    assert_eq!(outputs.parts, 0, "cycle 5: parts");

    // Cycle 6: Stopped forces Modes {}
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(600), &mut ());
    assert!(chart.is_exactly(&[CellStep::Stopped]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 6: conveyor");
    assert!(!outputs.clamp, "cycle 6: clamp");
    assert!(!outputs.drill, "cycle 6: drill");
    assert!(!outputs.stamp, "cycle 6: stamp");
    assert!(outputs.alarm, "cycle 6: alarm");
    assert_eq!(outputs.parts, 0, "cycle 6: parts");

    // Cycle 7: Stopped → Restart, Restart → Ready
    let inputs = CellInputs { estop: false, ack: true, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(700), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Manual]), "cycle 7: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 7: conveyor");
    assert!(!outputs.clamp, "cycle 7: clamp");
    assert!(!outputs.drill, "cycle 7: drill");
    assert!(!outputs.stamp, "cycle 7: stamp");
    assert!(!outputs.alarm, "cycle 7: alarm");
    assert_eq!(outputs.parts, 0, "cycle 7: parts");

    // Cycle 8: Manual → Auto
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(800), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Feed]), "cycle 8: {:?}", chart.situation());
    assert!(outputs.conveyor, "cycle 8: conveyor");
    assert!(!outputs.clamp, "cycle 8: clamp");
    assert!(!outputs.drill, "cycle 8: drill");
    assert!(!outputs.stamp, "cycle 8: stamp");
    assert!(!outputs.alarm, "cycle 8: alarm");
    assert_eq!(outputs.parts, 0, "cycle 8: parts");

    // Cycle 9: Auto → Manual
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(900), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Manual]), "cycle 9: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 9: conveyor");
    assert!(!outputs.clamp, "cycle 9: clamp");
    assert!(!outputs.drill, "cycle 9: drill");
    assert!(!outputs.stamp, "cycle 9: stamp");
    assert!(!outputs.alarm, "cycle 9: alarm");
    assert_eq!(outputs.parts, 0, "cycle 9: parts");

    // Cycle 10: Manual → Auto
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1000), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Feed]), "cycle 10: {:?}", chart.situation());
    assert!(outputs.conveyor, "cycle 10: conveyor");
    assert!(!outputs.clamp, "cycle 10: clamp");
    assert!(!outputs.drill, "cycle 10: drill");
    assert!(!outputs.stamp, "cycle 10: stamp");
    assert!(!outputs.alarm, "cycle 10: alarm");
    assert_eq!(outputs.parts, 0, "cycle 10: parts");

    // Cycle 11: Feed → Close, Close → Closed, Closed → (Drill, Stamp)
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: true, clamped: true, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1100), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Drill, CellStep::Stamp]), "cycle 11: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 11: conveyor");
    assert!(outputs.clamp, "cycle 11: clamp");
    assert!(outputs.drill, "cycle 11: drill");
    assert!(outputs.stamp, "cycle 11: stamp");
    assert!(!outputs.alarm, "cycle 11: alarm");
    assert_eq!(outputs.parts, 0, "cycle 11: parts");

    // Cycle 12: -
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1200), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Drill, CellStep::Stamp]), "cycle 12: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 12: conveyor");
    assert!(outputs.clamp, "cycle 12: clamp");
    assert!(outputs.drill, "cycle 12: drill");
    assert!(outputs.stamp, "cycle 12: stamp");
    assert!(!outputs.alarm, "cycle 12: alarm");
    assert_eq!(outputs.parts, 0, "cycle 12: parts");

    // Cycle 13: Drill → Drilled
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: false, clamped: false, drilled: true, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1300), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Drilled, CellStep::Stamp]), "cycle 13: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 13: conveyor");
    assert!(outputs.clamp, "cycle 13: clamp");
    assert!(!outputs.drill, "cycle 13: drill");
    assert!(outputs.stamp, "cycle 13: stamp");
    assert!(!outputs.alarm, "cycle 13: alarm");
    assert_eq!(outputs.parts, 0, "cycle 13: parts");

    // Cycle 14: Stamp → Stamped, (Drilled, Stamped) → Release, Release → Deliver, Deliver → Feed, Auto → Manual
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: true };
    let outputs = chart.scan(&inputs, Ticks::new(1400), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Manual]), "cycle 14: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 14: conveyor");
    assert!(!outputs.clamp, "cycle 14: clamp");
    assert!(!outputs.drill, "cycle 14: drill");
    assert!(!outputs.stamp, "cycle 14: stamp");
    assert!(!outputs.alarm, "cycle 14: alarm");
    assert_eq!(outputs.parts, 1, "cycle 14: parts");

    // Cycle 15: Manual → Auto
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1500), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Feed]), "cycle 15: {:?}", chart.situation());
    assert!(outputs.conveyor, "cycle 15: conveyor");
    assert!(!outputs.clamp, "cycle 15: clamp");
    assert!(!outputs.drill, "cycle 15: drill");
    assert!(!outputs.stamp, "cycle 15: stamp");
    assert!(!outputs.alarm, "cycle 15: alarm");
    assert_eq!(outputs.parts, 1, "cycle 15: parts");

    // Cycle 16: Feed → Close, Close → Closed, Closed → (Drill, Stamp)
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: true, clamped: true, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1600), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Drill, CellStep::Stamp]), "cycle 16: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 16: conveyor");
    assert!(outputs.clamp, "cycle 16: clamp");
    assert!(outputs.drill, "cycle 16: drill");
    assert!(outputs.stamp, "cycle 16: stamp");
    assert!(!outputs.alarm, "cycle 16: alarm");
    assert_eq!(outputs.parts, 1, "cycle 16: parts");

    // Cycle 17: Drill → Drilled
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: true, clamped: true, drilled: true, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1700), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Drilled, CellStep::Stamp]), "cycle 17: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 17: conveyor");
    assert!(outputs.clamp, "cycle 17: clamp");
    assert!(!outputs.drill, "cycle 17: drill");
    assert!(outputs.stamp, "cycle 17: stamp");
    assert!(!outputs.alarm, "cycle 17: alarm");
    assert_eq!(outputs.parts, 1, "cycle 17: parts");

    // Cycle 18: Stamp → Stamped, (Drilled, Stamped) → Release
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: true, clamped: true, drilled: true, stamped: true };
    let outputs = chart.scan(&inputs, Ticks::new(1800), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Release]), "cycle 18: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 18: conveyor");
    assert!(!outputs.clamp, "cycle 18: clamp");
    assert!(!outputs.drill, "cycle 18: drill");
    assert!(!outputs.stamp, "cycle 18: stamp");
    assert!(!outputs.alarm, "cycle 18: alarm");
    assert_eq!(outputs.parts, 2, "cycle 18: parts");

    // Cycle 19: Ready → Stopped, Stopped forces Modes {}
    let inputs = CellInputs { estop: true, ack: false, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1900), &mut ());
    assert!(chart.is_exactly(&[CellStep::Stopped]), "cycle 19: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 19: conveyor");
    assert!(!outputs.clamp, "cycle 19: clamp");
    assert!(!outputs.drill, "cycle 19: drill");
    assert!(!outputs.stamp, "cycle 19: stamp");
    assert!(outputs.alarm, "cycle 19: alarm");
    assert_eq!(outputs.parts, 2, "cycle 19: parts");

    // Cycle 20: Stopped → Restart, Restart → Ready
    let inputs = CellInputs { estop: false, ack: true, auto: false, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(2000), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Manual]), "cycle 20: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 20: conveyor");
    assert!(!outputs.clamp, "cycle 20: clamp");
    assert!(!outputs.drill, "cycle 20: drill");
    assert!(!outputs.stamp, "cycle 20: stamp");
    assert!(!outputs.alarm, "cycle 20: alarm");
    assert_eq!(outputs.parts, 2, "cycle 20: parts");

    // Cycle 21: Manual → Auto
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: false, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(2100), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Feed]), "cycle 21: {:?}", chart.situation());
    assert!(outputs.conveyor, "cycle 21: conveyor");
    assert!(!outputs.clamp, "cycle 21: clamp");
    assert!(!outputs.drill, "cycle 21: drill");
    assert!(!outputs.stamp, "cycle 21: stamp");
    assert!(!outputs.alarm, "cycle 21: alarm");
    assert_eq!(outputs.parts, 2, "cycle 21: parts");

    // Cycle 22: Feed → Close, Close → Closed, Closed → (Drill, Stamp)
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: true, clamped: true, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(2200), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Drill, CellStep::Stamp]), "cycle 22: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 22: conveyor");
    assert!(outputs.clamp, "cycle 22: clamp");
    assert!(outputs.drill, "cycle 22: drill");
    assert!(outputs.stamp, "cycle 22: stamp");
    assert!(!outputs.alarm, "cycle 22: alarm");
    assert_eq!(outputs.parts, 2, "cycle 22: parts");

    // Cycle 23: Drill → Drilled
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: true, clamped: true, drilled: true, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(2300), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Drilled, CellStep::Stamp]), "cycle 23: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 23: conveyor");
    assert!(outputs.clamp, "cycle 23: clamp");
    assert!(!outputs.drill, "cycle 23: drill");
    assert!(outputs.stamp, "cycle 23: stamp");
    assert!(!outputs.alarm, "cycle 23: alarm");
    assert_eq!(outputs.parts, 2, "cycle 23: parts");

    // Cycle 24: Stamp → Stamped, (Drilled, Stamped) → Release
    let inputs = CellInputs { estop: false, ack: false, auto: true, part: true, clamped: true, drilled: true, stamped: true };
    let outputs = chart.scan(&inputs, Ticks::new(2400), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Release]), "cycle 24: {:?}", chart.situation());
    assert!(!outputs.conveyor, "cycle 24: conveyor");
    assert!(!outputs.clamp, "cycle 24: clamp");
    assert!(!outputs.drill, "cycle 24: drill");
    assert!(!outputs.stamp, "cycle 24: stamp");
    assert!(!outputs.alarm, "cycle 24: alarm");
    assert_eq!(outputs.parts, 3, "cycle 24: parts");

    // Cycle 25: Release → Deliver
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: true, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(2500), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Deliver]), "cycle 25: {:?}", chart.situation());
    assert!(outputs.conveyor, "cycle 25: conveyor");
    assert!(!outputs.clamp, "cycle 25: clamp");
    assert!(!outputs.drill, "cycle 25: drill");
    assert!(!outputs.stamp, "cycle 25: stamp");
    assert!(!outputs.alarm, "cycle 25: alarm");
    assert_eq!(outputs.parts, 3, "cycle 25: parts");

    // Cycle 26: -
    let inputs = CellInputs { estop: false, ack: false, auto: false, part: true, clamped: false, drilled: false, stamped: false };
    let outputs = chart.scan(&inputs, Ticks::new(2600), &mut ());
    assert!(chart.is_exactly(&[CellStep::Ready, CellStep::Auto, CellStep::Deliver]), "cycle 26: {:?}", chart.situation());
    assert!(outputs.conveyor, "cycle 26: conveyor");
    assert!(!outputs.clamp, "cycle 26: clamp");
    assert!(!outputs.drill, "cycle 26: drill");
    assert!(!outputs.stamp, "cycle 26: stamp");
    assert!(!outputs.alarm, "cycle 26: alarm");
    assert_eq!(outputs.parts, 3, "cycle 26: parts");
}
