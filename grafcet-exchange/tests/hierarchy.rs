//! Flip-flops of partial grafcets that act on each other: timelines worked out by hand, in each flavour. A scan is one evolution.

mod common;

#[path = "machine/mod.rs"]
mod machine;

use common::model;
use grafcet_exchange::st::{Flavour, Form, Options, structured_text};
use machine::{Dialect, Machine, Value};

const FLAVOURS: [(Flavour, Dialect); 3] =
    [(Flavour::Iec, Dialect::Iec), (Flavour::Codesys, Dialect::Codesys), (Flavour::Tia, Dialect::Tia)];

fn program(chart: &str, flavour: Flavour) -> String {
    let options = Options { form: Form::FlipFlops, flavour, ..Options::default() };
    structured_text(&model(chart), &options).expect("a translation").text
}

/// Each line has the inputs that are on, and what the scan shows of these names.
fn timeline(chart: &str, inputs: &str, names: &str, lines: &[(&str, &str)]) {
    for (flavour, dialect) in FLAVOURS {
        let text = program(chart, flavour);
        let mut machine = Machine::of(&text, dialect).unwrap_or_else(|error| panic!("{error}\n{text}"));
        for (number, (on, expected)) in lines.iter().enumerate() {
            machine.now += 100;
            for input in inputs.split(' ').chain(["Init"]) {
                machine.set(input, Value::Bool(on.split(' ').any(|one| one == input))).expect("an input");
            }
            machine.scan().expect("a scan");
            let shown = names.split(' ').map(|name| machine.get(name).expect("a variable").number().to_string());
            assert_eq!(shown.collect::<Vec<_>>().join(" "), *expected, "line {}, {on}\n{text}", number + 1);
        }
    }
}

/// What an enclosing step activates and empties does what it does on activation, deactivation and events; what would clear in the evolution in
/// which it is left does not (A19).
#[test]
fn an_enclosing_step() {
    let chart = "grafcet Line { input start, stop, full, part: bool; output run, hold: bool; output ins, outs, moves, parts: u8;
        partial Main { initial step Idle;
            enclosing step Auto { run;
                partial Work {
                    linked step Fill { P1 ins = (ins + 1) % 100; P0 outs = (outs + 1) % 100; on rising(part) parts = (parts + 1) % 100; }
                    step Wait { hold; }
                    Fill -[full => moves = (moves + 1) % 100]-> Wait -[!full]-> Fill; } }
            Idle -[start]-> Auto -[stop]-> Idle; } }";
    let names = "SR_Idle SR_Auto SR_Fill SR_Wait run hold ins outs moves parts";
    let lines = [
        ("", "1 0 0 0 0 0 0 0 0 0"),
        // Nothing moves in an enclosure that is not active, and no event is seen.
        ("full part", "1 0 0 0 0 0 0 0 0 0"),
        ("start", "0 1 1 0 1 0 1 0 0 0"),
        ("part", "0 1 1 0 1 0 1 0 0 1"),
        ("full part", "0 1 0 1 1 1 1 1 1 1"),
        ("", "0 1 1 0 1 0 2 1 1 1"),
        // The outer one wins: `Wait` is not entered and nothing is counted but what leaves and the event of a step that was active.
        ("stop full part", "1 0 0 0 0 0 2 2 1 2"),
        ("part", "1 0 0 0 0 0 2 2 1 2"),
        ("start", "0 1 1 0 1 0 3 2 1 2"),
        ("full", "0 1 0 1 1 1 3 3 2 2"),
        // It begins with what is linked, wherever it was left.
        ("stop full", "1 0 0 0 0 0 3 3 2 2"),
        ("start full", "0 1 1 0 1 0 4 3 2 2"),
        ("Init start", "1 0 0 0 0 0 0 0 0 0"),
        ("start", "0 1 1 0 1 0 1 0 0 0"),
    ];
    timeline(chart, "start stop full part", names, &lines);
}

/// At the beginning what is initial within an initial enclosing step is active, later what is linked (A18); a source transition within one waits for it
/// (A17); an enclosing step within another is reached in the same evolution.
#[test]
fn an_initial_enclosing_step() {
    let chart = "grafcet Cell { input a, b, c: bool; output deep: bool; output homes, feeds: u8;
        partial Main {
            initial enclosing step On {
                partial Outer {
                    initial step Home { P1 homes = (homes + 1) % 100; }
                    linked enclosing step Go { partial Inner { linked step Deep { deep; } step Deeper; Deep -[b]-> Deeper; () -[rising(c) => feeds = (feeds + 1) % 100]-> Deep; } }
                    Home -[b]-> Go; } }
            step Off;
            On -[a]-> Off -[!a]-> On; } }";
    let names = "SR_On SR_Off SR_Home SR_Go SR_Deep SR_Deeper deep homes feeds";
    let lines = [
        ("", "1 0 1 0 0 0 0 1 0"),
        ("c", "1 0 1 0 0 0 0 1 0"),
        ("", "1 0 1 0 0 0 0 1 0"),
        // `Go` is not active yet: what `c` would let clear does not.
        ("b c", "1 0 0 1 1 0 1 1 0"),
        ("b", "1 0 0 1 0 1 0 1 0"),
        ("b c", "1 0 0 1 1 1 1 1 1"),
        ("a", "0 1 0 0 0 0 0 1 1"),
        ("a c", "0 1 0 0 0 0 0 1 1"),
        ("", "1 0 0 1 1 0 1 1 1"),
        ("Init", "1 0 1 0 0 0 0 1 0"),
    ];
    timeline(chart, "a b c", names, &lines);
}

/// Each kind of order, in the evolution in which it is given; a partial grafcet clears nothing in it, nor in that in which it ends (A11, A13).
#[test]
fn forcing_orders() {
    let chart =
        "grafcet Plant { input stop, hold, jump, go, part: bool; output belt: bool; output ins, outs, moves: u8;
        partial Safety {
            initial step Ready;
            step Empty { force Work {}; }
            step Again { force Work {INIT}; }
            step Hold { force Work {*}; }
            step Put { force Work {Run, Side}; }
            Ready -[stop]-> Empty -[!stop]-> Again -[go]-> Ready;
            Ready -[hold && !stop]-> Hold -[!hold]-> Ready;
            Ready -[jump && !stop && !hold]-> Put -[!jump]-> Ready; }
        partial Work {
            initial step Idle;
            step Run { belt; P1 ins = (ins + 1) % 100; P0 outs = (outs + 1) % 100; }
            step Side;
            Idle -[go => moves = (moves + 1) % 100]-> Run -[part && !go]-> Idle; } }";
    let names = "SR_Ready SR_Empty SR_Again SR_Hold SR_Put SR_Idle SR_Run SR_Side belt ins outs moves";
    let lines = [
        ("", "1 0 0 0 0 1 0 0 0 0 0 0"),
        ("go", "1 0 0 0 0 0 1 0 1 1 0 1"),
        // Held from the evolution on in which the order appears, up to that in which it ends.
        ("hold part", "0 0 0 1 0 0 1 0 1 1 0 1"),
        ("hold part", "0 0 0 1 0 0 1 0 1 1 0 1"),
        ("part", "1 0 0 0 0 0 1 0 1 1 0 1"),
        ("part", "1 0 0 0 0 1 0 0 0 1 1 1"),
        // Forcing activates, and `go` clears nothing, so nothing is done on clearing.
        ("jump go", "0 0 0 0 1 0 1 1 1 2 1 1"),
        ("part", "1 0 0 0 0 0 1 1 1 2 1 1"),
        ("part", "1 0 0 0 0 1 0 1 0 2 2 1"),
        ("go", "1 0 0 0 0 0 1 1 1 3 2 2"),
        // It deactivates, too.
        ("stop", "0 1 0 0 0 0 0 0 0 3 3 2"),
        ("stop go", "0 1 0 0 0 0 0 0 0 3 3 2"),
        ("", "0 0 1 0 0 1 0 0 0 3 3 2"),
        ("go", "1 0 0 0 0 1 0 0 0 3 3 2"),
        ("go", "1 0 0 0 0 0 1 0 1 4 3 3"),
        ("stop Init", "1 0 0 0 0 1 0 0 0 0 0 0"),
    ];
    timeline(chart, "stop hold jump go part", names, &lines);
}

/// What is forced takes its enclosures along (A15): emptied with their step, and where an order activates that, beginning with what is linked; an
/// order of an initial step forces from the beginning.
#[test]
fn forcing_with_enclosures() {
    let chart = "grafcet Rig { input x, y, z: bool; output i, j: bool;
        partial Up { initial step A { force Down {F}; } step B { force Down {}; } step C { force Down {INIT}; } step K { force Down {*}; } step E;
            A -[x]-> B -[!x]-> C -[y]-> K -[!y]-> E -[x && y]-> A; }
        partial Down {
            initial enclosing step Work { partial In { initial step I { i; } linked step J { j; } I -[z]-> J -[z]-> I; } }
            step F;
            Work -[y]-> F -[!z && !y]-> Work; } }";
    let names = "SR_A SR_B SR_C SR_K SR_E SR_Work SR_F SR_I SR_J i j";
    let lines = [
        ("", "1 0 0 0 0 0 1 0 0 0 0"),
        ("z", "1 0 0 0 0 0 1 0 0 0 0"),
        ("x", "0 1 0 0 0 0 0 0 0 0 0"),
        ("", "0 0 1 0 0 1 0 0 1 0 1"),
        // What is forced to be active already stays so, and its enclosures go on.
        ("z", "0 0 1 0 0 1 0 1 0 1 0"),
        ("y", "0 0 0 1 0 1 0 1 0 1 0"),
        // `{*}` holds `Work`, and leaves what it encloses to itself.
        ("y z", "0 0 0 1 0 1 0 0 1 0 1"),
        ("", "0 0 0 0 1 1 0 0 1 0 1"),
        ("y", "0 0 0 0 1 0 1 0 0 0 0"),
        ("", "0 0 0 0 1 1 0 0 1 0 1"),
        ("x y z", "1 0 0 0 0 0 1 0 0 0 0"),
    ];
    timeline(chart, "x y z", names, &lines);
}

/// An `any` of a `grafcet` leaves what is active in its net, also beside parallel branches, and nothing else of it clears.
#[test]
fn any_beside_parallel_branches() {
    let chart = "grafcet Par { input go, next, stop: bool; output p, q: bool; output moves: u8;
        initial step A; step B { p; } step C { q; } step K; step E;
        any except A -[stop]-> E;
        A -[go]-> (B, C); B -[next => moves = (moves + 1) % 100]-> K; (C, K) -[go]-> A; E -[!stop]-> A; }";
    let names = "SR_A SR_B SR_C SR_K SR_E p q moves";
    let lines = [
        ("", "1 0 0 0 0 0 0 0"),
        ("stop", "1 0 0 0 0 0 0 0"),
        ("go", "0 1 1 0 0 1 1 0"),
        ("next", "0 0 1 1 0 0 1 1"),
        ("go", "1 0 0 0 0 0 0 1"),
        ("go", "0 1 1 0 0 1 1 1"),
        ("next stop", "0 0 0 0 1 0 0 1"),
        ("stop", "0 0 0 0 1 0 0 1"),
        ("", "1 0 0 0 0 0 0 1"),
    ];
    timeline(chart, "go next stop", names, &lines);
}

/// The page of the tool shows what is written.
#[test]
fn what_the_page_shows() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/tool.md");
    let page = std::fs::read_to_string(file).expect("the page of the tool");
    let mut blocks = page.split("```").skip(1).step_by(2).skip_while(|block| !block.starts_with("rust\n// press.rs"));
    let chart = blocks.next().expect("the chart");
    let chart = &chart[chart.find("grafcet Press").expect("its name")..chart.rfind('}').expect("its end")];
    let shown = blocks.find_map(|block| block.strip_prefix("text\n")).expect("what is written");
    let text = program(chart, Flavour::Iec);
    assert!(text.contains(shown), "{text}");
}

/// A variable that continuous actions assert follows the situation: transitions ask for it on that before the scan, actions on that after it.
#[test]
fn variables_that_follow_the_situation() {
    let chart = "grafcet Doors { input a, b, c: bool; output lit, both: bool; output seen: u8; var open, free: bool;
        partial Left { initial step Shut; step Open { open; P1 seen = (seen + 1) % 100 if free; } Shut -[a]-> Open -[!a && !free]-> Shut; }
        partial Right { initial step Idle; step Run { open if b; free if !open; } step Stop { lit if open; both if free; } Idle -[c && open]-> Run -[!c]-> Stop -[free || a]-> Idle; } }";
    let names = "SR_Open SR_Run SR_Stop open free lit both seen";
    let lines = [
        ("", "0 0 0 0 0 0 0 0"),
        // `open` is true after this scan; `c` asks for it in the next one.
        ("a c", "1 0 0 1 0 0 0 0"),
        ("a c", "1 1 0 1 0 0 0 0"),
        ("c", "0 1 0 0 1 0 0 0"),
        // `free` was true before.
        ("a c", "1 1 0 1 0 0 0 1"),
        ("", "0 0 1 0 0 0 0 1"),
        ("", "0 0 1 0 0 0 0 1"),
        ("a b", "1 0 0 1 0 0 0 1"),
        ("a b c", "1 1 0 1 0 0 0 1"),
        ("a b", "1 0 1 1 0 1 0 1"),
    ];
    timeline(chart, "a b c", names, &lines);
    // It follows inputs, too, in the scan in which a transition asks for it.
    let chart = "grafcet Gate { input b: bool; output q: bool; var v: bool; initial step A { v if b; } step B { q; } A -[v]-> B -[!b]-> A; }";
    timeline(
        chart,
        "b",
        "SR_A SR_B v",
        &[("", "1 0 0"), ("b", "0 1 0"), ("b", "0 1 0"), ("", "1 0 0"), ("b", "0 1 0")],
    );
}

/// In a `grafcet` calls at an instant are calls of their own, in the order of the source, those on clearing after them, and what is called as long as a
/// step is active comes last.
#[test]
fn calls_at_instants() {
    let chart = "grafcet Bell { input a, b: bool; action ring(n: u8); initial step Off { P0 ring(1); }
        step On { P1 ring(2); N ring(3); P0 ring(4); on rising(b) ring(5); } Off -[a => ring(6)]-> On -[!a]-> Off; }";
    for (flavour, dialect) in FLAVOURS {
        let text = program(chart, flavour);
        let mut machine = Machine::of(&text, dialect).expect("understood");
        let mut scan = |a, b| -> Vec<(i128, i128)> {
            machine.set("a", Value::Bool(a)).expect("an input");
            machine.set("b", Value::Bool(b)).expect("an input");
            machine.scan().expect("a scan");
            machine.calls.iter().map(|call| (call.arguments[0].number(), call.arguments[1].number())).collect()
        };
        assert_eq!(scan(false, false), []);
        assert_eq!(scan(true, true), [(0, 1), (0, 2), (0, 6), (0, 3)]);
        assert_eq!(scan(true, false), [(1, 3)]);
        assert_eq!(scan(true, true), [(0, 5), (1, 3)]);
        assert_eq!(scan(false, true), [(0, 4), (2, 3)]);
    }
}

/// Several steps call one action as long as they are active: that is one call, with the arguments of the last in the source, at the end those of the one
/// that was active last (A31).
#[test]
fn one_call_of_several_steps() {
    let chart = "grafcet Heat { input a, b: bool; action heat(n: u8); action light(); initial step Off; step Low { N heat(4); light(); } step High { N heat(7) if b; light(); }
        step Both { light(); } Off -[a]-> (Low, High); Low -[!a]-> Both; (High, Both) -[!a && !b]-> Off; }";
    for (flavour, dialect) in FLAVOURS {
        let text = program(chart, flavour);
        let mut machine = Machine::of(&text, dialect).expect("understood");
        let mut scan = |a, b| -> Vec<Vec<i128>> {
            machine.set("a", Value::Bool(a)).expect("an input");
            machine.set("b", Value::Bool(b)).expect("an input");
            machine.scan().expect("a scan");
            machine.calls.iter().map(|call| call.arguments.iter().map(|one| one.number()).collect()).collect()
        };
        assert_eq!(scan(false, true), Vec::<Vec<i128>>::new());
        assert_eq!(scan(true, false), [vec![0, 4], vec![0]]);
        assert_eq!(scan(true, true), [vec![1, 7], vec![1]]);
        assert_eq!(scan(true, false), [vec![1, 4], vec![1]]);
        assert_eq!(scan(false, true), [vec![1, 7], vec![1]]);
        // Both end, with what was said last.
        assert_eq!(scan(false, false), [vec![2, 7], vec![2]]);
        assert_eq!(scan(false, false), Vec::<Vec<i128>>::new());
        assert_eq!(scan(true, false), [vec![0, 4], vec![0]]);
    }
}
