//! Written by `cargo grafcet tests`: from the chart, to be confirmed by a person.

#![allow(clippy::pedantic, reason = "written by a program")]

use grafcet::{Chart as _, Phase, Ticks};

use super::recipe::{Dyer, DyerActions, DyerInputs, DyerStep};

#[derive(Default)]
struct Calls(Vec<String>);

impl DyerActions for Calls {
    fn heat(&mut self, phase: Phase, setpoint: i16) {
        self.0.push(format!("{phase:?} heat({})", setpoint));
    }
    fn drum(&mut self, phase: Phase, rpm: u16) {
        self.0.push(format!("{phase:?} drum({})", rpm));
    }
}

#[test]
fn sequence_1() {
    let mut chart = Dyer::new();

    // Cycle 0: -
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(0), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Idle]), "cycle 0: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 0: inlet");
    assert!(!outputs.outlet, "cycle 0: outlet");
    assert!(outputs.ready, "cycle 0: ready");
    assert_eq!(calls.0.join("; "), "", "cycle 0");

    // Cycle 1: -
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(100), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Idle]), "cycle 1: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 1: inlet");
    assert!(!outputs.outlet, "cycle 1: outlet");
    assert!(outputs.ready, "cycle 1: ready");
    assert_eq!(calls.0.join("; "), "", "cycle 1");

    // Cycle 2: Idle → Fill
    let inputs = DyerInputs { start: true, full: false, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(200), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Fill]), "cycle 2: {:?}", chart.situation());
    assert!(outputs.inlet, "cycle 2: inlet");
    assert!(!outputs.outlet, "cycle 2: outlet");
    assert!(!outputs.ready, "cycle 2: ready");
    assert_eq!(calls.0.join("; "), "", "cycle 2");

    // Cycle 3: -
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(300), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Fill]), "cycle 3: {:?}", chart.situation());
    assert!(outputs.inlet, "cycle 3: inlet");
    assert!(!outputs.outlet, "cycle 3: outlet");
    assert!(!outputs.ready, "cycle 3: ready");
    assert_eq!(calls.0.join("; "), "", "cycle 3");

    // Cycle 4: Fill → Wash, first heat(40), first drum(45)
    let inputs = DyerInputs { start: false, full: true, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(400), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Wash]), "cycle 4: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 4: inlet");
    assert!(!outputs.outlet, "cycle 4: outlet");
    assert!(!outputs.ready, "cycle 4: ready");
    assert_eq!(calls.0.join("; "), "First heat(40); First drum(45)", "cycle 4");

    // Cycle 5: repeated heat(40), repeated drum(45)
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(500), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Wash]), "cycle 5: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 5: inlet");
    assert!(!outputs.outlet, "cycle 5: outlet");
    assert!(!outputs.ready, "cycle 5: ready");
    assert_eq!(calls.0.join("; "), "Repeated heat(40); Repeated drum(45)", "cycle 5");

    // Cycle 6: Wash → Dye, repeated heat(60), repeated drum(55)
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 40 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(4400), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Dye]), "cycle 6: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 6: inlet");
    assert!(!outputs.outlet, "cycle 6: outlet");
    assert!(!outputs.ready, "cycle 6: ready");
    assert_eq!(calls.0.join("; "), "Repeated heat(60); Repeated drum(55)", "cycle 6");

    // Cycle 7: repeated heat(60), repeated drum(55)
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(4500), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Dye]), "cycle 7: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 7: inlet");
    assert!(!outputs.outlet, "cycle 7: outlet");
    assert!(!outputs.ready, "cycle 7: ready");
    assert_eq!(calls.0.join("; "), "Repeated heat(60); Repeated drum(55)", "cycle 7");

    // Cycle 8: Dye → Drain, final heat(60), repeated drum(45)
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 60 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(10400), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Drain]), "cycle 8: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 8: inlet");
    assert!(outputs.outlet, "cycle 8: outlet");
    assert!(!outputs.ready, "cycle 8: ready");
    assert_eq!(calls.0.join("; "), "Final heat(60); Repeated drum(45)", "cycle 8");

    // Cycle 9: repeated drum(45)
    let inputs = DyerInputs { start: false, full: false, empty: false, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(10500), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Drain]), "cycle 9: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 9: inlet");
    assert!(outputs.outlet, "cycle 9: outlet");
    assert!(!outputs.ready, "cycle 9: ready");
    assert_eq!(calls.0.join("; "), "Repeated drum(45)", "cycle 9");

    // Cycle 10: Drain → Idle, final drum(45)
    let inputs = DyerInputs { start: false, full: false, empty: true, temperature: 0 };
    let mut calls = Calls::default();
    let outputs = chart.scan(&inputs, Ticks::new(10600), &mut calls);
    assert!(chart.is_exactly(&[DyerStep::Idle]), "cycle 10: {:?}", chart.situation());
    assert!(!outputs.inlet, "cycle 10: inlet");
    assert!(!outputs.outlet, "cycle 10: outlet");
    assert!(outputs.ready, "cycle 10: ready");
    assert_eq!(calls.0.join("; "), "Final drum(45)", "cycle 10");
}
