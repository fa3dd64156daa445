//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

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

    // Cycle 4: Reject → Feed
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Feed]), "cycle 4: {:?}", chart.situation());
    assert!(outputs.feed, "cycle 4: feed");
    assert!(!outputs.keep, "cycle 4: keep");
    assert!(!outputs.reject, "cycle 4: reject");

    // Cycle 5: Feed → Measure
    let inputs = SorterInputs { piece: true, length: 497 };
    let outputs = chart.scan(&inputs, Ticks::new(500), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Measure]), "cycle 5: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 5: feed");
    assert!(!outputs.keep, "cycle 5: keep");
    assert!(!outputs.reject, "cycle 5: reject");

    // Cycle 6: Measure → Keep
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(600), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Keep]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 6: feed");
    assert!(outputs.keep, "cycle 6: keep");
    assert!(!outputs.reject, "cycle 6: reject");

    // Cycle 7: Keep → Feed
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(700), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Feed]), "cycle 7: {:?}", chart.situation());
    assert!(outputs.feed, "cycle 7: feed");
    assert!(!outputs.keep, "cycle 7: keep");
    assert!(!outputs.reject, "cycle 7: reject");

    // Cycle 8: Feed → Measure
    let inputs = SorterInputs { piece: true, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(800), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Measure]), "cycle 8: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 8: feed");
    assert!(!outputs.keep, "cycle 8: keep");
    assert!(!outputs.reject, "cycle 8: reject");

    // Cycle 9: Measure → Reject
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(900), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Reject]), "cycle 9: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 9: feed");
    assert!(!outputs.keep, "cycle 9: keep");
    assert!(outputs.reject, "cycle 9: reject");

    // Cycle 10: -
    let inputs = SorterInputs { piece: true, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(1000), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Reject]), "cycle 10: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 10: feed");
    assert!(!outputs.keep, "cycle 10: keep");
    assert!(outputs.reject, "cycle 10: reject");

    // Cycle 11: Reject → Feed
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(1100), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Feed]), "cycle 11: {:?}", chart.situation());
    assert!(outputs.feed, "cycle 11: feed");
    assert!(!outputs.keep, "cycle 11: keep");
    assert!(!outputs.reject, "cycle 11: reject");

    // Cycle 12: Feed → Measure
    let inputs = SorterInputs { piece: true, length: 497 };
    let outputs = chart.scan(&inputs, Ticks::new(1200), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Measure]), "cycle 12: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 12: feed");
    assert!(!outputs.keep, "cycle 12: keep");
    assert!(!outputs.reject, "cycle 12: reject");

    // Cycle 13: Measure → Keep
    let inputs = SorterInputs { piece: false, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(1300), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Keep]), "cycle 13: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 13: feed");
    assert!(outputs.keep, "cycle 13: keep");
    assert!(!outputs.reject, "cycle 13: reject");

    // Cycle 14: -
    let inputs = SorterInputs { piece: true, length: 0 };
    let outputs = chart.scan(&inputs, Ticks::new(1400), &mut ());
    assert!(chart.is_exactly(&[SorterStep::Keep]), "cycle 14: {:?}", chart.situation());
    assert!(!outputs.feed, "cycle 14: feed");
    assert!(outputs.keep, "cycle 14: keep");
    assert!(!outputs.reject, "cycle 14: reject");
}
