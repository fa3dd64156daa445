//! What users of other state machine crates ask for.

use grafcet::{Phase, grafcet};

/// Charts with the same names of steps and signals stand in one module, and are seen from where they may be.
mod machines {
    use grafcet::grafcet;

    grafcet! {
        /// Seen wherever the module is.
        pub sfc Pump { input on: bool; output run: bool; initial step Off; step On { N run; } Off -[on]-> On -[!on]-> Off; }
    }
    grafcet! {
        pub(crate) grafcet Valve { input on: bool; output run: bool; initial step Off; step On { run; } Off -[on]-> On -[!on]-> Off; }
    }
    grafcet! {
        pub(super) sfc Fan { input on: bool; output run: bool; initial step Off; step On { N run; } Off -[on]-> On -[!on]-> Off; }
    }
    grafcet! {
        sfc Own { input on: bool; output run: bool; initial step Off; step On { N run; } Off -[on]-> On -[!on]-> Off; }
    }

    /// Nobody outside can name `Own`.
    pub(crate) fn runs(on: bool) -> bool {
        let mut own = Own::new();
        own.cycle(&OwnInputs::default());
        own.cycle(&OwnInputs { on }).run && own.is_active(OwnStep::On)
    }
}

#[test]
fn several_charts_stand_in_one_file() {
    let (mut pump, mut valve, mut fan) = (machines::Pump::new(), machines::Valve::new(), machines::Fan::new());
    pump.cycle(&machines::PumpInputs::default());
    fan.cycle(&machines::FanInputs::default());
    assert!(pump.cycle(&machines::PumpInputs { on: true }).run);
    assert!(valve.cycle(&machines::ValveInputs { on: true }).run);
    assert!(fan.cycle(&machines::FanInputs { on: true }).run);
    assert!(machines::runs(true) && !machines::runs(false));
    let steps = (pump.situation(), valve.situation(), fan.situation());
    assert_eq!(steps, (machines::PumpStep::On, machines::ValveStep::On, machines::FanStep::On));
}

grafcet! {
    sfc Sequence {
        input next: bool;
        action note(what: &'static str);
        action hold(what: &'static str);

        initial step First { P1 note("enter First"); N hold("First"); P0 note("leave First"); }
        step Second { P1 note("enter Second"); P0 note("leave Second"); }

        First -[next]-> Second -[next]-> First;
    }
}

grafcet! {
    grafcet Stable {
        input next: bool;
        action note(what: &'static str);

        initial step First { P1 note("enter First"); P0 note("leave First"); }
        step Second { P1 note("enter Second"); P0 note("leave Second"); }

        First -[next]-> Second -[!next]-> First;
    }
}

#[derive(Default)]
struct Log(Vec<String>);

impl SequenceActions for Log {
    fn note(&mut self, _: Phase, what: &'static str) {
        self.0.push(what.to_owned());
    }

    fn hold(&mut self, phase: Phase, what: &'static str) {
        self.0.push(format!("{phase:?} {what}"));
    }
}

impl StableActions for Log {
    fn note(&mut self, _: Phase, what: &'static str) {
        self.0.push(what.to_owned());
    }
}

/// A29: deactivations (P0) and final calls, then activations (P1), then the rest; in each the actions in the order in which
/// they first stand in the source, `note` before `hold`.
#[test]
fn what_is_left_runs_before_what_is_entered() {
    let (mut chart, mut log) = (Sequence::new(), Log::default());
    for next in [false, true, false, true] {
        chart.cycle(&SequenceInputs { next }, &mut log);
    }
    let entered = ["enter First", "First First"];
    let to_second = ["leave First", "Final First", "enter Second"];
    let to_first = ["leave Second", "enter First", "First First"];
    assert_eq!(log.0, [&entered[..], &to_second, &to_first].concat());
}

/// A33: in source order within their evolution, also where a step is entered that stands above the one that is left.
#[test]
fn a_grafcet_calls_in_source_order() {
    let (mut chart, mut log) = (Stable::new(), Log::default());
    for next in [false, true, false] {
        chart.cycle(&StableInputs { next }, &mut log);
    }
    assert_eq!(log.0, ["enter First", "leave First", "enter Second", "enter First", "leave Second"]);
}
