//! Timelines worked out by hand: edges, delays and times of what the chart itself changes, blocks that read what others write, and calls that share an
//! action.

mod common;
#[path = "machine/mod.rs"]
mod machine;

use common::model;
use grafcet_exchange::st::{Flavour, Form, Options, Order, structured_text};
use machine::{Dialect, Machine, Value};

const FLAVOURS: [(Flavour, Dialect); 3] =
    [(Flavour::Iec, Dialect::Iec), (Flavour::Codesys, Dialect::Codesys), (Flavour::Tia, Dialect::Tia)];

/// What is shown after a scan: at this time, with these inputs.
type Row<'a> = (u64, &'a [(&'a str, bool)], &'a [i128]);

/// In each flavour these rows.
fn shows(chart: &str, (form, order): (Form, Option<Order>), names: &[&str], rows: &[Row<'_>]) {
    for (flavour, dialect) in FLAVOURS {
        let options = Options { form, order, flavour, ..Options::default() };
        let text = structured_text(&model(chart), &options).unwrap_or_else(|refused| panic!("{refused:?}")).text;
        let mut machine = Machine::of(&text, dialect).unwrap_or_else(|error| panic!("{error}\n{text}"));
        for (now, inputs, expected) in rows {
            machine.now = *now;
            for (name, value) in *inputs {
                machine.set(name, Value::Bool(*value)).expect("an input");
            }
            machine.scan().expect("a scan");
            let shown: Vec<i128> = names.iter().map(|name| machine.get(name).expect("a variable").number()).collect();
            assert_eq!(shown, *expected, "at {now}, {names:?}\n{text}");
        }
    }
}

const FLIP_FLOPS: (Form, Option<Order>) = (Form::FlipFlops, None);
const ON: &[(&str, bool)] = &[("a", true)];
const OFF: &[(&str, bool)] = &[("a", false)];

/// An action sees the edge in the scan that enters its step, a transition in the one after it.
#[test]
fn edges_of_steps_in_an_sfc() {
    let chart = "sfc C { input a: bool; output lit: bool; initial step A; step B { N lit if rising(B.X); } step E { N lit if falling(B.X); }
        A -[a]-> B -[rising(B.X)]-> E -[!a]-> A; }";
    let names = ["SR_A", "SR_B", "SR_E", "lit"];
    let rows: &[Row<'_>] = &[
        (0, OFF, &[1, 0, 0, 0]),
        (10, ON, &[0, 1, 0, 1]),
        (20, ON, &[0, 0, 1, 1]),
        (30, ON, &[0, 0, 1, 0]),
        (40, OFF, &[1, 0, 0, 0]),
        (50, ON, &[0, 1, 0, 1]),
        (60, &[("Init", true), ("a", true)], &[1, 0, 0, 0]),
        (70, &[("Init", false), ("a", true)], &[0, 1, 0, 1]),
    ];
    shows(chart, FLIP_FLOPS, &names, rows);
}

/// A scan is an evolution. Initial steps have no edge in the first one; later the one after that which enters a step sees it.
#[test]
fn edges_of_steps_in_a_grafcet() {
    let chart = "grafcet C { input a: bool; var n: u8 = 0; initial step A; step B { P1 n = (n + 1) % 9; } step E;
        A -[rising(A.X) || a && n == 0]-> B -[rising(n > 0) || n > 1 && !a]-> E -[!a]-> A; }";
    let names = ["SR_A", "SR_B", "SR_E", "n"];
    let rows: &[Row<'_>] = &[
        (0, OFF, &[1, 0, 0, 0]),
        (10, OFF, &[1, 0, 0, 0]),
        (20, OFF, &[1, 0, 0, 0]),
        (30, ON, &[0, 1, 0, 1]),
        (40, ON, &[0, 0, 1, 1]),
        (50, OFF, &[1, 0, 0, 1]),
        (60, ON, &[0, 1, 0, 2]),
        (70, ON, &[0, 1, 0, 2]),
        (80, OFF, &[0, 0, 1, 2]),
    ];
    shows(chart, FLIP_FLOPS, &names, rows);
}

/// A delay is looked at where the scan before has left everything as it was: what the chart only passes does not interrupt it.
#[test]
fn delays_of_what_a_grafcet_changes() {
    let chart = "grafcet C { input a: bool; initial step A; step B; step E; step G;
        A -[a]-> B -[!a]-> E -[true]-> B; B -[a && 100ms/(B.X)]-> G -[!a]-> A; }";
    let names = ["SR_A", "SR_B", "SR_E", "SR_G"];
    let rows: &[Row<'_>] = &[
        (0, OFF, &[1, 0, 0, 0]),
        (10, ON, &[0, 1, 0, 0]),
        // The scan before has changed something.
        (20, ON, &[0, 1, 0, 0]),
        (30, ON, &[0, 1, 0, 0]),
        (40, OFF, &[0, 0, 1, 0]),
        (50, ON, &[0, 1, 0, 0]),
        (129, ON, &[0, 1, 0, 0]),
        (130, ON, &[0, 0, 0, 1]),
    ];
    shows(chart, FLIP_FLOPS, &names, rows);
    let numbers: Vec<[i128; 1]> = [10, 20, 20, 20, 30, 20, 20, 40].map(|number| [number]).into();
    let case: Vec<Row<'_>> =
        rows.iter().zip(&numbers).map(|((now, inputs, _), shown)| (*now, *inputs, &shown[..])).collect();
    shows(chart, (Form::Case, None), &["StepNo"], &case);
}

/// It goes off late, too, and in an `sfc` is looked at in each scan.
#[test]
fn delays_of_what_an_sfc_changes() {
    let chart = "sfc C { input a: bool; output lit: bool; initial step A { N lit if 20ms/B.X/30ms; } step B { N lit if 20ms/B.X/30ms; }
        A -[a]-> B -[!a]-> A; }";
    let rows: &[Row<'_>] = &[
        (0, OFF, &[1, 0, 0]),
        (10, ON, &[0, 1, 0]),
        (20, ON, &[0, 1, 0]),
        (39, ON, &[0, 1, 0]),
        (40, ON, &[0, 1, 1]),
        (50, OFF, &[1, 0, 1]),
        (60, OFF, &[1, 0, 1]),
        (89, OFF, &[1, 0, 1]),
        (90, OFF, &[1, 0, 0]),
    ];
    shows(chart, FLIP_FLOPS, &["SR_A", "SR_B", "lit"], rows);
}

/// A step that is entered anew: what runs when it is left sees the time that it had reached, all else zero.
#[test]
fn times_of_a_step_that_is_entered_anew() {
    let chart = "sfc C { input a: bool; output last, first: time; output late: bool; initial step A { P0 last = A.T; P1 first = A.T; N late if 30ms/A; }
        A -[rising(a)]-> A; }";
    let rows: &[Row<'_>] = &[
        (0, OFF, &[0, 0, 0]),
        (30, OFF, &[0, 0, 1]),
        (40, ON, &[40, 0, 0]),
        (69, ON, &[40, 0, 0]),
        (70, OFF, &[40, 0, 1]),
        (90, ON, &[50, 0, 0]),
    ];
    shows(chart, FLIP_FLOPS, &["last", "first", "late"], rows);
}

/// What is done once in a `grafcet` sees times and steps as they were before the evolution.
#[test]
fn what_runs_once_in_a_grafcet_sees_what_there_was() {
    let chart = "grafcet C { input a: bool; output last, own: time; var n: u8 = 0; initial step A; step B { P1 last = A.T; P1 own = B.T; P1 { if A.X && !B.X { n = (n + 1) % 9; } } }
        A -[a]-> B -[!a && n > 0]-> A; }";
    let rows: &[Row<'_>] = &[
        (0, OFF, &[0, 0, 0]),
        (30, OFF, &[0, 0, 0]),
        (40, ON, &[40, 0, 1]),
        (50, ON, &[40, 0, 1]),
        (60, OFF, &[40, 0, 1]),
        (75, ON, &[15, 0, 2]),
    ];
    shows(chart, FLIP_FLOPS, &["last", "own", "n"], rows);
}

/// The initial situation is activated from nothing.
#[test]
fn what_the_first_activation_sees() {
    let chart = "grafcet C { input a: bool; output n: u8; initial step A { P1 { if A.X { n = 1; } else { n = 2; } } } step B { P1 { if A.X { n = 3; } } }
        A -[a]-> B -[!a]-> A; }";
    let rows: &[Row<'_>] = &[(0, OFF, &[2]), (10, ON, &[3]), (20, OFF, &[2])];
    shows(chart, FLIP_FLOPS, &["n"], rows);
}

/// A macro-step is active since the first of its steps was.
#[test]
fn times_of_macro_steps() {
    let chart = "grafcet C { input a, b: bool; output lit: bool; initial step A; macro step M { entry step I; exit step O { lit if blink(20ms, M); } I -[b]-> O; }
        A -[a]-> M -[50ms/M]-> A; }";
    let both: &[(&str, bool)] = &[("a", true), ("b", true)];
    let rows: &[Row<'_>] = &[
        (0, &[("a", false), ("b", false)], &[1, 0, 0, 0]),
        (10, &[("a", true), ("b", false)], &[0, 1, 0, 0]),
        (30, both, &[0, 0, 1, 0]),
        (40, both, &[0, 0, 1, 0]),
        (50, both, &[0, 0, 1, 1]),
        (59, both, &[0, 0, 1, 1]),
        (60, &[("a", false), ("b", false)], &[1, 0, 0, 0]),
    ];
    shows(chart, FLIP_FLOPS, &["SR_A", "SR_I", "SR_O", "lit"], rows);
}

/// A block sees its own writes, and otherwise what there was before the evolution, whatever others have written since.
#[test]
fn blocks_beside_others() {
    let chart = "grafcet C { input a: bool; output m: u8; var n: u8 = 1; initial step A { P0 n = 7; }
        step B { P1 { m = n; if n < 9 { n = n + 1; } m = m + n; } } A -[a && n < 9]-> B; B -[!a && n < 9]-> A; }";
    // The block has m = 1, n = 2, m = 3; it stands after what leaves A.
    let rows: &[Row<'_>] = &[(0, OFF, &[0, 1]), (10, ON, &[3, 2]), (20, OFF, &[3, 2]), (30, ON, &[5, 3])];
    shows(chart, FLIP_FLOPS, &["m", "n"], rows);
}

/// Of several steps that delay one place the one that is active counts.
#[test]
fn times_that_share_a_timer() {
    let chart = "sfc C { input a: bool; output lit: bool; initial step A { D 20ms lit; } step B { D 50ms lit; } A -[a]-> B -[!a]-> A; }";
    let rows: &[Row<'_>] = &[
        (0, OFF, &[0]),
        (20, OFF, &[1]),
        // 30 ms since the first of both.
        (30, ON, &[0]),
        (49, ON, &[0]),
        (50, ON, &[1]),
        (60, OFF, &[1]),
    ];
    shows(chart, FLIP_FLOPS, &["lit"], rows);
}

/// One action control for all: first, repeated, final, each with the arguments of who acts; R ends what is stored.
#[test]
fn calls_that_share_an_action() {
    let chart = "sfc C { input a, b: bool; action heat(to: u8); initial step A { N heat(4); } step B { SD 20ms heat(6); } step E { R heat(0); P1 heat(9); }
        A -[a]-> B -[b]-> E -[!a]-> A; }";
    let mut machine = calling(chart);
    let mut calls = |now, a, b| calls_of(&mut machine, now, a, b).into_iter().map(|(_, told)| told).collect::<Vec<_>>();
    assert_eq!(calls(0, false, false), [[0, 4]]);
    assert_eq!(calls(10, false, false), [[1, 4]]);
    assert_eq!(calls(20, true, false), [[2, 4]], "the final call of the step left");
    assert!(calls(39, true, false).is_empty());
    assert_eq!(calls(40, true, false), [[0, 6]], "20 ms are over");
    assert_eq!(calls(50, true, false), [[1, 6]]);
    assert_eq!(calls(60, true, true), [[0, 9], [2, 6]], "P1 is one call, the end by R another, among the rest");
    assert!(calls(70, true, true).is_empty());
    assert_eq!(calls(80, false, true), [[0, 4]]);
}

fn calling(chart: &str) -> Machine {
    let options = Options { form: Form::FlipFlops, ..Options::default() };
    let text = structured_text(&model(chart), &options).unwrap_or_else(|refused| panic!("{refused:?}")).text;
    Machine::new(&text).expect("structured text")
}

/// The calls of a scan: of which action, and what it is told, the phase first.
fn calls_of(machine: &mut Machine, now: u64, a: bool, b: bool) -> Vec<(String, Vec<i128>)> {
    machine.now = now;
    machine.set("a", Value::Bool(a)).expect("an input");
    machine.set("b", Value::Bool(b)).expect("an input");
    machine.scan().expect("a scan");
    let told = |call: &machine::Call| call.arguments.iter().map(|value| value.number()).collect();
    machine.calls.iter().map(|call| (call.instance.clone(), told(call))).collect()
}

/// P0 beside the end of what is stored: one call, the final one, with the arguments of P0.
#[test]
fn a_final_call_beside_p0() {
    let mut machine = calling(
        "sfc C { input a, b: bool; action heat(to: u8); initial step A { S heat(4); } step B { P0 heat(5); } step E { R heat(0); }
        A -[a]-> B -[b]-> E -[!a]-> A; }",
    );
    let heat = |told: [i128; 2]| vec![("heat".to_owned(), told.to_vec())];
    assert_eq!(calls_of(&mut machine, 0, false, false), heat([0, 4]));
    assert_eq!(calls_of(&mut machine, 10, true, false), heat([1, 4]));
    assert_eq!(calls_of(&mut machine, 20, true, true), heat([2, 5]));
    assert_eq!(calls_of(&mut machine, 30, true, true), []);
}

/// A delay ends where its step is entered anew, too: its final call stands in front of what begins.
#[test]
fn a_delayed_call_of_a_step_that_is_entered_anew() {
    let mut machine = calling(
        "sfc C { input a, b: bool; action heat(to: u8); action mark(); initial step A { D 20ms heat(4); P1 mark(); } step B { N heat(5); }
        A -[b]-> B -[!b]-> A; A -[rising(a) && !b]-> A; }",
    );
    let (heat, mark) = (|told: [i128; 2]| ("heat".to_owned(), told.to_vec()), ("mark".to_owned(), vec![0]));
    assert_eq!(calls_of(&mut machine, 0, false, false), std::slice::from_ref(&mark));
    assert_eq!(calls_of(&mut machine, 20, false, false), [heat([0, 4])]);
    assert_eq!(calls_of(&mut machine, 30, true, false), [heat([2, 4]), mark]);
    assert_eq!(calls_of(&mut machine, 49, true, false), []);
    assert_eq!(calls_of(&mut machine, 50, true, false), [heat([0, 4])]);
}

/// What nothing drives R does not end: a block and an assignment have an action control of their own.
#[test]
fn a_reset_of_what_nothing_drives() {
    let chart =
        "sfc C { input a: bool; output m: u8; initial step A { S m = 4; } step B { R m = 5; } A -[a]-> B -[!a]-> A; }";
    shows(chart, FLIP_FLOPS, &["m"], &[(0, OFF, &[4]), (10, ON, &[4]), (20, OFF, &[4])]);
}

/// In a CASE that acts first a transition asks what the scan before has left, and an action does so, too.
#[test]
fn edges_of_steps_in_a_case() {
    let chart = "sfc C { input a: bool; output lit: bool; initial step A; step B { N lit if rising(B.X); } step E { N lit if falling(B.X); }
        A -[a]-> B -[rising(B.X) && !a]-> E -[!a]-> A; B -[falling(A.X)]-> A; }";
    let rows: &[Row<'_>] = &[
        (0, OFF, &[10, 0]),
        (10, ON, &[20, 0]),
        // It acts, and leaves: what it does is off again.
        (20, ON, &[10, 0]),
        (30, ON, &[20, 0]),
        (40, OFF, &[30, 0]),
        (50, ON, &[30, 1]),
        (60, ON, &[30, 0]),
    ];
    shows(chart, (Form::Case, None), &["StepNo", "lit"], rows);
}

/// A CASE that evolves first has edges and delays of variables, too.
#[test]
fn edges_of_variables_in_a_case_that_evolves_first() {
    let chart = "sfc C { input a: bool; var n: u8 = 0; initial step A; step B { P1 n = (n + 1) % 3; } step E;
        A -[a]-> B -[rising(n == 1)]-> E -[!a]-> A; B -[20ms/(n == 2)]-> A; }";
    let rows: &[Row<'_>] = &[
        (0, OFF, &[10, 0]),
        (10, ON, &[20, 1]),
        (20, ON, &[30, 1]),
        (30, OFF, &[10, 1]),
        (40, ON, &[20, 2]),
        (50, ON, &[20, 2]),
        (69, ON, &[20, 2]),
        (70, ON, &[10, 2]),
    ];
    shows(chart, (Form::Case, Some(Order::EvolveFirst)), &["StepNo", "n"], rows);
}
