//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Ticks};

use super::branch_on_result::{Sorter, SorterInputs, SorterStep};

#[test]
fn sequence_1() {
    let mut chart = Sorter::new();

    // Cycle 0: -
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Feed]), "cycle 0: {:?}", chart.situation());
    assert!(outputs.feed, "cycle 0: feed");
    assert!(!outputs.keep, "cycle 0: keep");
    assert!(!outputs.reject, "cycle 0: reject");

    // Cycle 1: -
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Feed]), "cycle 1: {:?}", chart.situation());
    assert!(outputs.feed, "cycle 1: feed");
    assert!(!outputs.keep, "cycle 1: keep");
    assert!(!outputs.reject, "cycle 1: reject");

    // Cycle 2: Feed → Measure
    let inputs = SorterInputs { piece: true, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Measure]), "cycle 2: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 2: feed");
    assert!(!outputs.keep, "cycle 2: keep");
    assert!(!outputs.reject, "cycle 2: reject");

    // Cycle 3: Measure → Reject
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Reject]), "cycle 3: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 3: feed");
    assert!(!outputs.keep, "cycle 3: keep");
    assert!(outputs.reject, "cycle 3: reject");

    // Cycle 4: -
    let inputs = SorterInputs { piece: true, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Reject]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 4: feed");
    assert!(!outputs.keep, "cycle 4: keep");
    assert!(outputs.reject, "cycle 4: reject");

    // Cycle 5: Reject → Feed
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(500), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Feed]), "cycle 5: {:?}", chart.situation());
    assert!(outputs.feed, "cycle 5: feed");
    assert!(!outputs.keep, "cycle 5: keep");
    assert!(!outputs.reject, "cycle 5: reject");

    // Cycle 6: Feed → Measure
    let inputs = SorterInputs { piece: true, length: 497 };
    let outputs = chart.scan(&inputs, Ticks::new(600), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Measure]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 6: feed");
    assert!(!outputs.keep, "cycle 6: keep");
    assert!(!outputs.reject, "cycle 6: reject");

    // Cycle 7: Measure → Keep
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(700), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Keep]), "cycle 7: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 7: feed");
    assert!(outputs.keep, "cycle 7: keep");
    assert!(!outputs.reject, "cycle 7: reject");

    // Cycle 8: -
    let inputs = SorterInputs { piece: true, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(800), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Keep]), "cycle 8: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 8: feed");
    assert!(outputs.keep, "cycle 8: keep");
    assert!(!outputs.reject, "cycle 8: reject");

    // Cycle 9: Keep → Feed
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(900), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Feed]), "cycle 9: {:?}", chart.situation());
    assert!(outputs.feed, "cycle 9: feed");
    assert!(!outputs.keep, "cycle 9: keep");
    assert!(!outputs.reject, "cycle 9: reject");
}
