//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::pick_and_place::{PickAndPlace, PickAndPlaceInputs, PickAndPlaceStep};

#[test]
fn sequence_1() {
    let mut chart = PickAndPlace::new();

    // Cycle 0: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Ready]), "cycle 0: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 0: belt");
    assert!(!outputs.dip, "cycle 0: dip");
    assert!(!outputs.push, "cycle 0: push");
    assert!(!outputs.grip, "cycle 0: grip");
    assert!(!outputs.done, "cycle 0: done");
    assert!(!outputs.alarm, "cycle 0: alarm");

    // Cycle 1: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(1), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Ready]), "cycle 1: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 1: belt");
    assert!(!outputs.dip, "cycle 1: dip");
    assert!(!outputs.push, "cycle 1: push");
    assert!(!outputs.grip, "cycle 1: grip");
    assert!(!outputs.done, "cycle 1: done");
    assert!(!outputs.alarm, "cycle 1: alarm");

    // Cycle 2: Ready → Feed
    let inputs = PickAndPlaceInputs { start: true, arrived: false, up: true, down: false, back: true, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(2), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Feed]), "cycle 2: {:?}", chart.situation());
    assert!(outputs.belt, "cycle 2: belt");
    assert!(!outputs.dip, "cycle 2: dip");
    assert!(!outputs.push, "cycle 2: push");
    assert!(!outputs.grip, "cycle 2: grip");
    assert!(!outputs.done, "cycle 2: done");
    assert!(!outputs.alarm, "cycle 2: alarm");

    // Cycle 3: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(3), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Feed]), "cycle 3: {:?}", chart.situation());
    assert!(outputs.belt, "cycle 3: belt");
    assert!(!outputs.dip, "cycle 3: dip");
    assert!(!outputs.push, "cycle 3: push");
    assert!(!outputs.grip, "cycle 3: grip");
    assert!(!outputs.done, "cycle 3: done");
    assert!(!outputs.alarm, "cycle 3: alarm");

    // Cycle 4: Feed → Dip
    let inputs = PickAndPlaceInputs { start: false, arrived: true, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(4), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Dip]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 4: belt");
    assert!(outputs.dip, "cycle 4: dip");
    assert!(!outputs.push, "cycle 4: push");
    assert!(!outputs.grip, "cycle 4: grip");
    assert!(!outputs.done, "cycle 4: done");
    assert!(!outputs.alarm, "cycle 4: alarm");

    // Cycle 5: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(5), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Dip]), "cycle 5: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 5: belt");
    assert!(outputs.dip, "cycle 5: dip");
    assert!(!outputs.push, "cycle 5: push");
    assert!(!outputs.grip, "cycle 5: grip");
    assert!(!outputs.done, "cycle 5: done");
    assert!(!outputs.alarm, "cycle 5: alarm");

    // Cycle 6: Dip → Grip
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: true, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(6), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Grip]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 6: belt");
    assert!(outputs.dip, "cycle 6: dip");
    assert!(!outputs.push, "cycle 6: push");
    assert!(outputs.grip, "cycle 6: grip");
    assert!(!outputs.done, "cycle 6: done");
    assert!(!outputs.alarm, "cycle 6: alarm");

    // Cycle 7: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(7), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Grip]), "cycle 7: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 7: belt");
    assert!(outputs.dip, "cycle 7: dip");
    assert!(!outputs.push, "cycle 7: push");
    assert!(outputs.grip, "cycle 7: grip");
    assert!(!outputs.done, "cycle 7: done");
    assert!(!outputs.alarm, "cycle 7: alarm");

    // Cycle 8: Grip → Lost
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(8), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Lost]), "cycle 8: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 8: belt");
    assert!(!outputs.dip, "cycle 8: dip");
    assert!(!outputs.push, "cycle 8: push");
    assert!(!outputs.grip, "cycle 8: grip");
    assert!(!outputs.done, "cycle 8: done");
    assert!(outputs.alarm, "cycle 8: alarm");

    // Cycle 9: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(9), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Lost]), "cycle 9: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 9: belt");
    assert!(!outputs.dip, "cycle 9: dip");
    assert!(!outputs.push, "cycle 9: push");
    assert!(!outputs.grip, "cycle 9: grip");
    assert!(!outputs.done, "cycle 9: done");
    assert!(outputs.alarm, "cycle 9: alarm");

    // Cycle 10: Lost → Ready
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: true, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(10), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Ready]), "cycle 10: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 10: belt");
    assert!(!outputs.dip, "cycle 10: dip");
    assert!(!outputs.push, "cycle 10: push");
    assert!(!outputs.grip, "cycle 10: grip");
    assert!(!outputs.done, "cycle 10: done");
    assert!(!outputs.alarm, "cycle 10: alarm");

    // Cycle 11: Ready → Feed
    let inputs = PickAndPlaceInputs { start: true, arrived: false, up: true, down: false, back: true, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(11), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Feed]), "cycle 11: {:?}", chart.situation());
    assert!(outputs.belt, "cycle 11: belt");
    assert!(!outputs.dip, "cycle 11: dip");
    assert!(!outputs.push, "cycle 11: push");
    assert!(!outputs.grip, "cycle 11: grip");
    assert!(!outputs.done, "cycle 11: done");
    assert!(!outputs.alarm, "cycle 11: alarm");

    // Cycle 12: Feed → Dip
    let inputs = PickAndPlaceInputs { start: false, arrived: true, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(12), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Dip]), "cycle 12: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 12: belt");
    assert!(outputs.dip, "cycle 12: dip");
    assert!(!outputs.push, "cycle 12: push");
    assert!(!outputs.grip, "cycle 12: grip");
    assert!(!outputs.done, "cycle 12: done");
    assert!(!outputs.alarm, "cycle 12: alarm");

    // Cycle 13: Dip → Lost
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(18), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Lost]), "cycle 13: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 13: belt");
    assert!(!outputs.dip, "cycle 13: dip");
    assert!(!outputs.push, "cycle 13: push");
    assert!(!outputs.grip, "cycle 13: grip");
    assert!(!outputs.done, "cycle 13: done");
    assert!(outputs.alarm, "cycle 13: alarm");

    // Cycle 14: Lost → Ready
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: true, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(19), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Ready]), "cycle 14: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 14: belt");
    assert!(!outputs.dip, "cycle 14: dip");
    assert!(!outputs.push, "cycle 14: push");
    assert!(!outputs.grip, "cycle 14: grip");
    assert!(!outputs.done, "cycle 14: done");
    assert!(!outputs.alarm, "cycle 14: alarm");

    // Cycle 15: Ready → Feed
    let inputs = PickAndPlaceInputs { start: true, arrived: false, up: true, down: false, back: true, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(20), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Feed]), "cycle 15: {:?}", chart.situation());
    assert!(outputs.belt, "cycle 15: belt");
    assert!(!outputs.dip, "cycle 15: dip");
    assert!(!outputs.push, "cycle 15: push");
    assert!(!outputs.grip, "cycle 15: grip");
    assert!(!outputs.done, "cycle 15: done");
    assert!(!outputs.alarm, "cycle 15: alarm");

    // Cycle 16: Feed → Dip
    let inputs = PickAndPlaceInputs { start: false, arrived: true, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(21), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Dip]), "cycle 16: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 16: belt");
    assert!(outputs.dip, "cycle 16: dip");
    assert!(!outputs.push, "cycle 16: push");
    assert!(!outputs.grip, "cycle 16: grip");
    assert!(!outputs.done, "cycle 16: done");
    assert!(!outputs.alarm, "cycle 16: alarm");

    // Cycle 17: Dip → Grip
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: true, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(22), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Grip]), "cycle 17: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 17: belt");
    assert!(outputs.dip, "cycle 17: dip");
    assert!(!outputs.push, "cycle 17: push");
    assert!(outputs.grip, "cycle 17: grip");
    assert!(!outputs.done, "cycle 17: done");
    assert!(!outputs.alarm, "cycle 17: alarm");

    // Cycle 18: Grip → Lift
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: true };
    let outputs = chart.scan(&inputs, Ticks::new(23), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Lift]), "cycle 18: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 18: belt");
    assert!(!outputs.dip, "cycle 18: dip");
    assert!(!outputs.push, "cycle 18: push");
    assert!(outputs.grip, "cycle 18: grip");
    assert!(!outputs.done, "cycle 18: done");
    assert!(!outputs.alarm, "cycle 18: alarm");

    // Cycle 19: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(24), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Lift]), "cycle 19: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 19: belt");
    assert!(!outputs.dip, "cycle 19: dip");
    assert!(!outputs.push, "cycle 19: push");
    assert!(outputs.grip, "cycle 19: grip");
    assert!(!outputs.done, "cycle 19: done");
    assert!(!outputs.alarm, "cycle 19: alarm");

    // Cycle 20: Lift → Carry
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: true, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(25), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Carry]), "cycle 20: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 20: belt");
    assert!(!outputs.dip, "cycle 20: dip");
    assert!(outputs.push, "cycle 20: push");
    assert!(outputs.grip, "cycle 20: grip");
    assert!(!outputs.done, "cycle 20: done");
    assert!(!outputs.alarm, "cycle 20: alarm");

    // Cycle 21: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(26), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Carry]), "cycle 21: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 21: belt");
    assert!(!outputs.dip, "cycle 21: dip");
    assert!(outputs.push, "cycle 21: push");
    assert!(outputs.grip, "cycle 21: grip");
    assert!(!outputs.done, "cycle 21: done");
    assert!(!outputs.alarm, "cycle 21: alarm");

    // Cycle 22: Carry → Place
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: true, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(27), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Place]), "cycle 22: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 22: belt");
    assert!(outputs.dip, "cycle 22: dip");
    assert!(outputs.push, "cycle 22: push");
    assert!(outputs.grip, "cycle 22: grip");
    assert!(!outputs.done, "cycle 22: done");
    assert!(!outputs.alarm, "cycle 22: alarm");

    // Cycle 23: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(28), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Place]), "cycle 23: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 23: belt");
    assert!(outputs.dip, "cycle 23: dip");
    assert!(outputs.push, "cycle 23: push");
    assert!(outputs.grip, "cycle 23: grip");
    assert!(!outputs.done, "cycle 23: done");
    assert!(!outputs.alarm, "cycle 23: alarm");

    // Cycle 24: Place → Drop
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: true, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(29), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Drop]), "cycle 24: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 24: belt");
    assert!(outputs.dip, "cycle 24: dip");
    assert!(outputs.push, "cycle 24: push");
    assert!(!outputs.grip, "cycle 24: grip");
    assert!(!outputs.done, "cycle 24: done");
    assert!(!outputs.alarm, "cycle 24: alarm");

    // Cycle 25: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: true };
    let outputs = chart.scan(&inputs, Ticks::new(30), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Drop]), "cycle 25: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 25: belt");
    assert!(outputs.dip, "cycle 25: dip");
    assert!(outputs.push, "cycle 25: push");
    assert!(!outputs.grip, "cycle 25: grip");
    assert!(!outputs.done, "cycle 25: done");
    assert!(!outputs.alarm, "cycle 25: alarm");

    // Cycle 26: Drop → Rise
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(31), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Rise]), "cycle 26: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 26: belt");
    assert!(!outputs.dip, "cycle 26: dip");
    assert!(outputs.push, "cycle 26: push");
    assert!(!outputs.grip, "cycle 26: grip");
    assert!(!outputs.done, "cycle 26: done");
    assert!(!outputs.alarm, "cycle 26: alarm");

    // Cycle 27: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(32), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Rise]), "cycle 27: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 27: belt");
    assert!(!outputs.dip, "cycle 27: dip");
    assert!(outputs.push, "cycle 27: push");
    assert!(!outputs.grip, "cycle 27: grip");
    assert!(!outputs.done, "cycle 27: done");
    assert!(!outputs.alarm, "cycle 27: alarm");

    // Cycle 28: Rise → Done
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: true, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(33), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Done]), "cycle 28: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 28: belt");
    assert!(!outputs.dip, "cycle 28: dip");
    assert!(!outputs.push, "cycle 28: push");
    assert!(!outputs.grip, "cycle 28: grip");
    assert!(outputs.done, "cycle 28: done");
    assert!(!outputs.alarm, "cycle 28: alarm");

    // Cycle 29: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(34), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Done]), "cycle 29: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 29: belt");
    assert!(!outputs.dip, "cycle 29: dip");
    assert!(!outputs.push, "cycle 29: push");
    assert!(!outputs.grip, "cycle 29: grip");
    assert!(outputs.done, "cycle 29: done");
    assert!(!outputs.alarm, "cycle 29: alarm");

    // Cycle 30: Done → Ready
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: true, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(35), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Ready]), "cycle 30: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 30: belt");
    assert!(!outputs.dip, "cycle 30: dip");
    assert!(!outputs.push, "cycle 30: push");
    assert!(!outputs.grip, "cycle 30: grip");
    assert!(!outputs.done, "cycle 30: done");
    assert!(!outputs.alarm, "cycle 30: alarm");

    // Cycle 31: Ready → Feed
    let inputs = PickAndPlaceInputs { start: true, arrived: false, up: true, down: false, back: true, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(36), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Feed]), "cycle 31: {:?}", chart.situation());
    assert!(outputs.belt, "cycle 31: belt");
    assert!(!outputs.dip, "cycle 31: dip");
    assert!(!outputs.push, "cycle 31: push");
    assert!(!outputs.grip, "cycle 31: grip");
    assert!(!outputs.done, "cycle 31: done");
    assert!(!outputs.alarm, "cycle 31: alarm");

    // Cycle 32: Feed → Dip
    let inputs = PickAndPlaceInputs { start: false, arrived: true, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(37), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Dip]), "cycle 32: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 32: belt");
    assert!(outputs.dip, "cycle 32: dip");
    assert!(!outputs.push, "cycle 32: push");
    assert!(!outputs.grip, "cycle 32: grip");
    assert!(!outputs.done, "cycle 32: done");
    assert!(!outputs.alarm, "cycle 32: alarm");

    // Cycle 33: Dip → Grip
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: true, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(38), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Grip]), "cycle 33: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 33: belt");
    assert!(outputs.dip, "cycle 33: dip");
    assert!(!outputs.push, "cycle 33: push");
    assert!(outputs.grip, "cycle 33: grip");
    assert!(!outputs.done, "cycle 33: done");
    assert!(!outputs.alarm, "cycle 33: alarm");

    // Cycle 34: Grip → Lift
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: true };
    let outputs = chart.scan(&inputs, Ticks::new(39), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Lift]), "cycle 34: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 34: belt");
    assert!(!outputs.dip, "cycle 34: dip");
    assert!(!outputs.push, "cycle 34: push");
    assert!(outputs.grip, "cycle 34: grip");
    assert!(!outputs.done, "cycle 34: done");
    assert!(!outputs.alarm, "cycle 34: alarm");

    // Cycle 35: Lift → Carry
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: true, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(40), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Carry]), "cycle 35: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 35: belt");
    assert!(!outputs.dip, "cycle 35: dip");
    assert!(outputs.push, "cycle 35: push");
    assert!(outputs.grip, "cycle 35: grip");
    assert!(!outputs.done, "cycle 35: done");
    assert!(!outputs.alarm, "cycle 35: alarm");

    // Cycle 36: Carry → Place
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: true, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(41), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Place]), "cycle 36: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 36: belt");
    assert!(outputs.dip, "cycle 36: dip");
    assert!(outputs.push, "cycle 36: push");
    assert!(outputs.grip, "cycle 36: grip");
    assert!(!outputs.done, "cycle 36: done");
    assert!(!outputs.alarm, "cycle 36: alarm");

    // Cycle 37: Place → Jam
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(47), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Jam]), "cycle 37: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 37: belt");
    assert!(!outputs.dip, "cycle 37: dip");
    assert!(outputs.push, "cycle 37: push");
    assert!(outputs.grip, "cycle 37: grip");
    assert!(!outputs.done, "cycle 37: done");
    assert!(outputs.alarm, "cycle 37: alarm");

    // Cycle 38: -
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: false, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(48), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Jam]), "cycle 38: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 38: belt");
    assert!(!outputs.dip, "cycle 38: dip");
    assert!(outputs.push, "cycle 38: push");
    assert!(outputs.grip, "cycle 38: grip");
    assert!(!outputs.done, "cycle 38: done");
    assert!(outputs.alarm, "cycle 38: alarm");

    // Cycle 39: Jam → Carry
    let inputs = PickAndPlaceInputs { start: false, arrived: false, up: true, down: false, back: false, out: false, gripped: false };
    let outputs = chart.scan(&inputs, Ticks::new(49), &mut ());
    assert!(chart.is_exactly(&[PickAndPlaceStep::Carry]), "cycle 39: {:?}", chart.situation());
    assert!(!outputs.belt, "cycle 39: belt");
    assert!(!outputs.dip, "cycle 39: dip");
    assert!(outputs.push, "cycle 39: push");
    assert!(outputs.grip, "cycle 39: grip");
    assert!(!outputs.done, "cycle 39: done");
    assert!(!outputs.alarm, "cycle 39: alarm");
}
