//! The example `pick_and_place`: a line, its conveyor, an arm, a lift and a clamp: what is proved of their controller with all five plants, and mistakes planted in it.

use std::time::Duration;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::plant;
use grafcet_compiler::program::counted;
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, decide};

/// The example for people: the controller, and after it the machine.
const FILE: &str = include_str!("../../../examples/charts/pick_and_place.rs");

/// What stands in its call of the macro.
fn cell() -> &'static str {
    let (_, call) = FILE.split_once("grafcet! {\n").expect("a call");
    call.split_once("\n}\n").expect("its end").0
}

/// Of each property that is asked for, in how many cycles it is broken; none where it is proved.
fn judged(text: &str, asked: &[usize]) -> Vec<Option<usize>> {
    let length = |verdict| match verdict {
        Verdict::Proved(_) => None,
        Verdict::Violated(way) | Verdict::Endless { way, .. } => Some(way.len()),
        Verdict::Undecided(why) => panic!("{why}"),
    };
    verdicts(text, asked).into_iter().map(length).collect()
}

fn verdicts(text: &str, asked: &[usize]) -> Vec<Verdict> {
    let mut sink = Sink::new();
    let model = plant::model(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let messages: Vec<String> = sink.finish().into_iter().flat_map(|one| one.notes).map(|(_, text)| text).collect();
    assert!(messages.is_empty(), "{messages:?}");
    let program = counted(&model, &Facts::of(&model)).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let limit = || Limit::time(Duration::from_secs(600));
    let verdict = |property: usize| {
        let bad = circuit.bad.iter().find(|bad| bad.property == property).expect("it is modelled");
        decide(&program, &circuit, *bad, &limit()).expect("no internal error")
    };
    asked.iter().map(|property| verdict(*property)).collect()
}

#[test]
fn the_cell_keeps_what_it_claims() {
    assert_eq!(judged(cell(), &[0, 1, 2, 3, 4, 5, 6, 7, 8]), [None; 9]);
}

/// The line keeps its button pressed until it is answered. With the longest times of the plants, a cycle for each side to see the other, and
/// faults that come and go again just in time it takes 3.5 s to feed, 3 s to fetch, 1 s to grip, 1.5 s to lift, 2.5 s to carry, 3 s to place,
/// half a second to release and 1.5 s to rise, and with a cycle more for each step less than 20 s.
#[test]
fn the_whole_cycle_is_done_in_time() {
    let Verdict::Proved(proof) = verdicts(cell(), &[9]).remove(0) else { panic!("it is proved") };
    // By sums, as the page says, and not by much trying.
    let known = "Feed.X && Belt::Moving.X => time <= Belt::time";
    assert!(include_str!("../../../docs/proof.md").contains(known));
    assert!(proof.known.iter().any(|one| one == known), "{:#?}", proof.known);
}

/// Without its limit of time, to place may take as long as the lift is jammed.
#[test]
fn a_cycle_that_waits_for_ever_is_not() {
    let text = cell().replacen("Place -[3s/Place]-> Jam", "Place -[false]-> Jam", 1);
    let text = text.replace("done || alarm within 20s", "done || alarm within 5s");
    assert!(judged(&text, &[9])[0].is_some());
}

/// Each is found, on the shortest way: worked out by hand, with the shortest times that the plants allow and a cycle for each side to see
/// the other. The part has come in cycle 4, the tower is down in 6, and up again in 9.
#[test]
fn planted_mistakes_are_found() {
    let mistakes = [
        ("Lift { grip; }", "Lift { grip; push; }", 0, 8),
        ("-[up]-> Carry", "-[true]-> Carry", 0, 9),
        ("-[up]-> Done", "-[true]-> Done", 0, 16),
        ("step Rise { push; }", "step Rise;", 0, 15),
        ("-[gripped]-> Lift", "-[true]-> Lift", 1, 10),
        ("Lift { grip; }", "Lift;", 1, 10),
        ("step Grip { dip; grip; }", "step Grip { dip; grip; belt; }", 2, 7),
        ("-[arrived]-> Dip", "-[true]-> Dip", 3, 3),
        ("-[up]-> Carry", "-[up && arrived]-> Carry", 4, 12),
        ("Dip -[3s/Dip]-> Lost", "Dip -[6s/Dip]-> Lost", 8, 15),
    ];
    let mut found = Vec::new();
    for (right, wrong, property, cycles) in mistakes {
        let text = cell().replacen(right, wrong, 1);
        assert_ne!(text, cell(), "{right}");
        found.push((wrong, judged(&text, &[property])[0].unwrap_or(0), cycles));
    }
    let wrong: Vec<_> = found.iter().filter(|(_, found, cycles)| found != cycles).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
