//! Proofs from one evolution of a search for stability to the next.

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::program::counted;
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, by_evolutions, decide};

use crate::{read, verdicts};

/// A search that may go through all of the chart is no longer circuit for what is proved from evolution to evolution.
#[test]
fn a_long_search_is_gone_through_evolution_by_evolution() {
    let model = read(
        "grafcet Mixer {
            input start, stop, reset, full, hot: bool; input select: Mode in {Manual, Auto, Clean};
            output inlet, heater, stirrer, horn: bool;
            var mode: Mode in {Manual, Auto, Clean} = Mode::Manual; var alarms: u8 = 0;
            param soak: time in 1s..60s = 10s;
            initial step Idle { P1 mode = Mode::Manual; } step Chosen { P1 mode = select; } step Fill { inlet; }
            step Heat { heater; stirrer if mode != Mode::Clean; } step Soak { stirrer; } step Fault { horn; P1 alarms = alarms.saturating_add(1); }
            Idle -[start && alarms < 3]-> Chosen; Chosen -[mode == Mode::Auto || mode == Mode::Clean]-> Fill; Chosen -[mode == Mode::Manual && !start]-> Idle;
            Fill -[full && !stop]-> Heat; Fill -[30s/Fill && !full || stop]-> Fault; Heat -[hot && !stop]-> Soak; Heat -[stop]-> Fault;
            Soak -[Soak.T >= soak]-> Idle; Fault -[reset && alarms < 3]-> Idle;
            never heater && mode == Mode::Manual; always alarms <= 3; never Soak.T > 60s; never alarms > 2 && Fill.X;
            never alarms > 1; never Fill.X && mode == Mode::Clean; }",
    );
    let found = verdicts(&model);
    for verdict in &found[..4] {
        let Verdict::Proved(proof) = verdict else { panic!("{verdict:?}") };
        let circuit = proof.beside.as_ref().expect("the circuit of one evolution");
        assert!(circuit.fields.iter().any(|field| field.name == "within a search"));
    }
    // Shortest ways are those of whole cycles; one is enough here.
    for (verdict, cycles) in found[4..].iter().zip([1, 1]) {
        let Verdict::Violated(way) = verdict else { panic!("{verdict:?}") };
        assert_eq!(way.len(), cycles, "{way:?}");
    }
}

/// A search that circles ends at its bound, also where it is gone through evolution by evolution, and on the inputs with which it began.
#[test]
fn what_a_search_leaves_at_its_bound_is_no_secret() {
    let model = read(
        "grafcet C { input a, b: bool; output q: bool; initial step A; step B { q; } step D; A -[a]-> B -[a]-> A; A -[b && !a]-> D -[!b]-> A;
         never a && A.X; never a && B.X; never !a && q && b; never D.X && !b; never D.X && a && q; }",
    );
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let mut broken = 0;
    for bad in &circuit.bad {
        let verdict = decide(&program, &circuit, *bad, &Limit::none()).expect("no internal error");
        let proof = by_evolutions(&program, bad.property, &Limit::none()).expect("no internal error");
        match verdict {
            Verdict::Violated(_) => {
                broken += 1;
                assert!(proof.is_none(), "property {} is broken", bad.property);
            }
            verdict => assert!(matches!(verdict, Verdict::Proved(_)) && proof.is_some(), "property {}", bad.property),
        }
    }
    assert_eq!(broken, 3);
}
