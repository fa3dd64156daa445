//! `assumptions_hold`: what the chart takes for granted, asked of the inputs while the program runs.

use grafcet::grafcet;

const FULL: u16 = 950;

/// A sensor that the chart looks at as a whole.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Scale {
    grams: u32,
}

fn is_broken(scale: Scale) -> bool {
    scale.grams > 100_000
}

grafcet! {
    /// A gate with two limit switches.
    sfc Gate {
        input open, shut: bool;
        input level: u16;
        input r#type: bool;
        input scale: Scale;
        output up: bool;

        assume never open && shut;
        assume never level >= FULL && shut;
        assume never is_broken(scale) || { let open = scale; open.grams == 7 };
        assume never r#type;

        initial step Wait { N up; }
        step Run;
        Wait -[open && level < 3]-> Run -[shut && scale.grams > 5]-> Wait;
    }
}

grafcet! {
    /// One input, one assumption.
    grafcet Button {
        input stuck, press: bool;
        output lamp: bool;
        assume never stuck;
        initial step Dark;
        step Lit { lamp; }
        Dark -[rising(press)]-> Lit -[rising(press)]-> Dark;
    }
}

#[test]
fn they_hold_as_long_as_none_is_broken() {
    let inputs = GateInputs { open: true, ..Default::default() };
    assert!(Gate::assumptions_hold(&GateInputs::default()));
    assert!(Gate::assumptions_hold(&inputs));
    assert!(!Gate::assumptions_hold(&GateInputs { shut: true, ..inputs }));
    assert!(!Gate::assumptions_hold(&GateInputs { level: 950, shut: true, ..Default::default() }));
    assert!(Gate::assumptions_hold(&GateInputs { level: 949, shut: true, ..Default::default() }));
    assert!(!Gate::assumptions_hold(&GateInputs { r#type: true, ..inputs }));
    for (grams, hold) in [(6, true), (7, false), (100_000, true), (100_001, false)] {
        assert_eq!(Gate::assumptions_hold(&GateInputs { scale: Scale { grams }, ..inputs }), hold, "{grams} g");
    }
    assert!(Button::assumptions_hold(&ButtonInputs { press: true, ..Default::default() }));
    assert!(!Button::assumptions_hold(&ButtonInputs { stuck: true, ..Default::default() }));
}

/// A broken assumption makes no cycle fail.
#[test]
fn the_chart_goes_on_where_they_are_broken() {
    let mut gate = Gate::new();
    let broken = GateInputs { open: true, shut: true, scale: Scale { grams: 7 }, ..Default::default() };
    for _ in 0..3 {
        gate.cycle(&broken);
    }
    assert!(gate.is_active(GateStep::Wait) || gate.is_active(GateStep::Run));
}
