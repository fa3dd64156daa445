//! A line, its conveyor, an arm, a lift and a clamp: what is proved of their controller with all five plants, and mistakes planted in it.

use std::time::Duration;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::plant;
use grafcet_compiler::program::{Encoding, counted};
use grafcet_prove::circuit::Circuit;
use grafcet_prove::{Limit, Verdict, decide};

const CELL: &str = "
    sfc Cell {
        clock 500ms;
        input start, arrived, up, down, back, out, gripped: bool;
        output belt, lower, extend, grip, done, alarm: bool;

        initial step Ready;
        step Feed { belt; }
        step Fetch { lower; }
        step Grip { lower; grip; }
        step Lift { grip; }
        step Carry { grip; extend; }
        step Place { grip; extend; lower; }
        step Release { extend; lower; }
        step Rise { extend; }
        step Done { done; }
        step Missed { alarm; }
        step Stuck { alarm; grip; extend; }

        Ready -[start && up && back]-> Feed -[arrived]-> Fetch -[down]-> Grip -[gripped]-> Lift -[up]-> Carry
            -[out]-> Place -[down]-> Release -[!gripped]-> Rise -[up]-> Done -[back && !start]-> Ready;
        Fetch -[3s/Fetch]-> Missed -[up && !start]-> Ready;
        Grip -[1s/Grip]-> Missed;
        Place -[3s/Place]-> Stuck -[up && !start]-> Carry;

        assume cycle within 500ms;
        never !Tower::Top.X && (Arm::Going.X || Arm::Coming.X);
        never Jaw::Open.X && Carry.X;
        never Tower::Bottom.X && belt;
        never Belt::Moving.X && lower;
        Lift leads_to Carry within 2s;
        Carry leads_to Place within 3s;
        Rise leads_to Done within 2s;
        Feed leads_to Fetch within 4s;
        Fetch leads_to Grip.X || alarm within 5s;
        start leads_to done || alarm within 20s;
    }
    plant Line {
        input done, alarm: bool;
        output start: bool;
        choice part_wanted;
        initial step Quiet;
        step Asks { start; }
        Quiet -[part_wanted && !done && !alarm]-> Asks -[done || alarm]-> Quiet;
    }
    plant Belt {
        input belt, lower: bool;
        output arrived: bool;
        initial step Empty;
        step Moving;
        step There { arrived; }
        Empty -[belt]-> Moving -[1s..3s/Moving]-> There -[!belt && lower]-> Empty;
    }
    plant Tower {
        input lower: bool;
        output up, down: bool;
        fault jammed;
        initial step Top { up; }
        step Going;
        step Bottom { down; }
        step Coming;
        Top -[lower && !jammed]-> Going -[!lower]-> Coming;
        Going -[500ms..1s/Going && !jammed]-> Bottom -[!lower]-> Coming -[500ms..1s/Coming]-> Top;
    }
    plant Arm {
        input extend: bool;
        output back, out: bool;
        initial step In { back; }
        step Going;
        step Far { out; }
        step Coming;
        In -[extend]-> Going -[500ms..2s/Going]-> Far -[!extend]-> Coming -[500ms..2s/Coming]-> In;
        Going -[!extend]-> Coming -[extend]-> Going;
    }
    plant Jaw {
        input grip: bool;
        output gripped: bool;
        fault empty;
        initial step Open;
        step Shut { gripped; }
        Open -[grip && !empty]-> Shut -[!grip]-> Open;
    }";

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
    let program = counted(&model, &Facts::of(&model), Encoding::Regions).expect("a program");
    let circuit = Circuit::of(&program).expect("a circuit");
    let limit = || Limit::time(Duration::from_secs(60));
    let verdict = |property: usize| {
        let bad = circuit.bad.iter().find(|bad| bad.property == property).expect("it is modelled");
        decide(&program, &circuit, *bad, &limit()).expect("no internal error")
    };
    asked.iter().map(|property| verdict(*property)).collect()
}

#[test]
fn the_cell_keeps_what_it_claims() {
    assert_eq!(judged(CELL, &[0, 1, 2, 3, 4, 5, 6, 7, 8]), [None; 9]);
}

/// The line keeps its button pressed until it is answered. With the longest times of the plants, a cycle for each side to see the other, and
/// faults that come and go again just in time it takes 3.5 s to feed, 3 s to fetch, 1 s to grip, 1.5 s to lift, 2.5 s to carry, 3 s to place,
/// half a second to release and 1.5 s to rise, and with a cycle more for each step less than 20 s.
#[test]
fn the_whole_cycle_is_done_in_time() {
    let Verdict::Proved(proof) = verdicts(CELL, &[9]).remove(0) else { panic!("it is proved") };
    // By sums, as the page says, and not by much trying.
    let known = "Feed.X && Belt::Moving.X => time <= Belt::time";
    assert!(include_str!("../../../docs/proof.md").contains(known));
    assert!(proof.known.iter().any(|one| one == known), "{:#?}", proof.known);
}

/// Without its limit of time, to place may take as long as the lift is jammed.
#[test]
fn a_cycle_that_waits_for_ever_is_not() {
    let text = CELL.replacen("Place -[3s/Place]-> Stuck", "Place -[false]-> Stuck", 1);
    let text = text.replace("done || alarm within 20s", "done || alarm within 5s");
    assert!(judged(&text, &[9])[0].is_some());
}

/// Each is found, on the shortest way: worked out by hand, with the shortest times that the plants allow and a cycle for each side to see
/// the other. The part has come in cycle 4, the tower is down in 6, and up again in 9.
#[test]
fn planted_mistakes_are_found() {
    let mistakes = [
        ("Lift { grip; }", "Lift { grip; extend; }", 0, 8),
        ("-[up]-> Carry", "-[true]-> Carry", 0, 9),
        ("-[up]-> Done", "-[true]-> Done", 0, 16),
        ("step Rise { extend; }", "step Rise;", 0, 15),
        ("-[gripped]-> Lift", "-[true]-> Lift", 1, 10),
        ("Lift { grip; }", "Lift;", 1, 10),
        ("step Grip { lower; grip; }", "step Grip { lower; grip; belt; }", 2, 7),
        ("-[arrived]-> Fetch", "-[true]-> Fetch", 3, 3),
        ("-[up]-> Carry", "-[up && arrived]-> Carry", 4, 12),
        ("Fetch -[3s/Fetch]-> Missed", "Fetch -[6s/Fetch]-> Missed", 8, 15),
    ];
    let mut found = Vec::new();
    for (right, wrong, property, cycles) in mistakes {
        let text = CELL.replacen(right, wrong, 1);
        assert_ne!(text, CELL, "{right}");
        found.push((wrong, judged(&text, &[property])[0].unwrap_or(0), cycles));
    }
    let wrong: Vec<_> = found.iter().filter(|(_, found, cycles)| found != cycles).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
