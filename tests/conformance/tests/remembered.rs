//! Properties that remember: edges, delays, what blinks; and how their clocks go with those of steps and actions.

use grafcet_compiler::analysis::{Facts, Prover};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model};
use grafcet_compiler::parse;
use grafcet_compiler::program::counted;
use grafcet_compiler::{Wanted, compile_with};
use grafcet_conformance::prove::{Bounds, Counts, remembering};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, decide};
use quote::quote;
use std::time::Duration;

fn read(text: &str) -> Model {
    let mut sink = Sink::new();
    let tokens = text.parse().expect("tokens");
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink)).expect("a chart");
    assert!(sink.finish().iter().all(|message| message.rule.is_some()), "it is understood");
    model
}

fn verdicts(model: &Model) -> Vec<Verdict> {
    let program = counted(model, &Facts::of(model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let decided =
        circuit.bad.iter().map(|bad| decide(&program, &circuit, *bad, &Limit::time(Duration::from_secs(600))));
    decided.collect::<Result<_, _>>().expect("no internal error")
}

/// Every verdict and every length as brute force finds them, which keeps the past itself.
#[test]
fn what_properties_remember_is_judged_as_brute_force_finds_it() {
    let mut counts = Counts::default();
    let bounds = Bounds { cycles: 1_500, time: Duration::from_secs(600) };
    for chart in 0..60 {
        remembering(chart, chart % 2 == 1, bounds, &mut counts).expect("no difference");
    }
    assert!(
        counts.proved > 60 && counts.broken > 20 && counts.undecided.is_empty() && counts.refused == 0,
        "{counts:?}"
    );
}

/// A door whose properties ask for edges, delays and what blinks, and after how many cycles each is broken in an `sfc` and in a `grafcet`.
const REMEMBERED: &[(&str, Option<usize>, Option<usize>)] = &[
    ("never rising(motor) && !start", None, None),
    ("always rising(motor) => pressed", None, None),
    // In a `grafcet` what has been shut for long closes in the cycle in which it opens.
    ("always falling(motor) => lamp", None, Some(3)),
    ("always falling(Open.X) => 3s/shut", None, None),
    // It stands open for 3 s, is shut, and starts again within the second.
    ("always 3s/Open.X/1s => !motor", Some(6), Some(5)),
    ("never 2s/(Open.X && !lamp)", None, None),
    ("never 6s/Opening.X", None, None),
    ("never 4s/Opening.X", Some(3), Some(3)),
    ("always 3s/shut => Rest.X || Opening.X", Some(3), None),
    ("always Opening.X && blink(500ms, Opening) => lamp", None, None),
    ("never lamp && Opening.X && !blink(500ms, Opening)", None, None),
    ("never blink(500ms, Opening) && Opening.T > 600ms && Opening.T < 900ms", None, None),
    ("never blink(500ms, Opening) && Opening.T > 600ms && Opening.T < 1100ms", Some(3), Some(3)),
    // Pressed once more, when it is open.
    ("pressed leads_to motor within 1s", Some(5), Some(3)),
    ("rising(1s/shut) before falling(2s/shut)", None, None),
    // An edge of an edge: it has just begun, and goes on.
    ("never falling(rising(motor)) && motor && rising(shut)", Some(3), Some(3)),
];

fn door(dialect: &str, property: &str) -> String {
    format!(
        "{dialect} Door {{ clock 100ms; input open, shut, start: bool; output motor, lamp: bool; let pressed = rising(start);
         initial step Rest; step Opening {{ motor; lamp if blink(500ms); }} step Open {{ lamp; }}
         Rest -[pressed]-> Opening -[open || 5s/Opening]-> Open -[3s/shut]-> Rest; {property} }}"
    )
}

#[test]
fn edges_delays_and_what_blinks_are_followed_in_properties() {
    for (property, of_sfc, of_grafcet) in REMEMBERED {
        for (dialect, expected) in [("sfc", of_sfc), ("grafcet", of_grafcet)] {
            match (verdicts(&read(&door(dialect, &format!("{property};")))).remove(0), expected) {
                (Verdict::Proved(_), None) => {}
                (Verdict::Violated(way), Some(length)) if way.len() == *length => {}
                (verdict, _) => panic!("{dialect}: {property}: {verdict:?}"),
            }
        }
    }
}

/// A program remembers nothing for a property: its code is that of the chart that claims the same without edges and delays.
#[test]
fn what_properties_remember_costs_nothing() {
    let prover: &Prover = &grafcet_prove::rule;
    let code = |dialect: &str, property: &str| {
        let chart = door(dialect, property).parse().expect("tokens");
        compile_with(&quote!(::grafcet), chart, Wanted { recorded: false, prover: Some(prover) }).to_string()
    };
    for dialect in ["sfc", "grafcet"] {
        let remembered = "never rising(motor) && Rest.X; never 2s/(falling(motor) && motor) && Rest.X;";
        let plain = "never motor && Rest.X; never (motor && motor) && Rest.X;";
        assert!(code(dialect, remembered) == code(dialect, plain), "{dialect}");
    }
}

/// The clock of a stored action goes with that of its step.
#[test]
fn stored_and_delayed_outputs_go_with_the_times_of_steps() {
    let oven = |property: &str| {
        format!(
            "sfc Oven {{ input start, stop: bool; output kept, ds, sl: bool; initial step Rest {{ R kept; R ds; R sl; }}
             step Run {{ SD 4s kept; DS 4s ds; SL 4s sl; }} step Done; Rest -[start]-> Run -[stop || 10s/Run]-> Done -[!start]-> Rest; {property}; }}"
        )
    };
    for (property, expected) in [
        ("never kept && Run.X && Run.T < 4s", None),
        ("never kept && Run.X && Run.T < 4100ms", Some(3)),
        ("always Run.X && Run.T >= 4s => kept", None),
        ("never ds && Run.X && Run.T < 4s", None),
        ("never ds && Run.X && Run.T < 5s", Some(3)),
        ("never sl && Run.X && Run.T > 4s", None),
        ("never sl && Run.X && Run.T > 3s", Some(3)),
        // What was stored goes on in Done.
        ("never kept && !Run.X", Some(3)),
        ("never kept && Rest.X", None),
    ] {
        match (verdicts(&read(&oven(property))).remove(0), expected) {
            (Verdict::Proved(_), None) => {}
            (Verdict::Violated(way), Some(length)) if way.len() == length => {}
            (verdict, _) => panic!("{property}: {verdict:?}"),
        }
    }
}

/// Periods of 0.5 s and 0.7 s begin together every 3.5 s: for the first time after 12 s at 14 s, which one long cycle may bring. Times that are
/// told apart only up to what they are compared with would show that a cycle later, or never.
#[test]
fn long_times_are_as_far_in_each_period() {
    let both = "blink(100ms/400ms, Run) && blink(100ms/600ms, Run)";
    for (property, expected) in [
        (format!("never {both} && Run.T > 12s"), Some(3)),
        (format!("never {both} && Run.T > 200ms && Run.T < 3500ms"), None),
        (format!("never {both} && Run.T > 200ms && Run.T <= 3500ms"), Some(3)),
    ] {
        let text = format!(
            "sfc C {{ clock 100ms; input start, stop: bool; initial step Rest; step Run; Rest -[start]-> Run -[stop]-> Rest; {property}; }}"
        );
        match (verdicts(&read(&text)).remove(0), expected) {
            (Verdict::Proved(_), None) => {}
            (Verdict::Violated(way), Some(length)) if way.len() == length => {}
            (verdict, _) => panic!("{property}: {verdict:?}"),
        }
    }
}

#[test]
fn what_blinks_goes_with_the_time_of_its_step_in_fine_ticks() {
    let text = door("sfc", "never blink(500ms, Opening) && Opening.T > 600ms && Opening.T < 900ms;");
    for clock in ["50ms", "10ms"] {
        let verdict = verdicts(&read(&text.replacen("clock 100ms", &format!("clock {clock}"), 1))).remove(0);
        assert!(matches!(verdict, Verdict::Proved(_)), "{clock}: {verdict:?}");
    }
}
