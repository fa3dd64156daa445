//! Passes, each on small charts of its own: what a person reads, and at inputs that reach what the pass has made.

use std::fmt::Write as _;
use std::path::Path;

use grafcet_compiler::model::Model;
use grafcet_compiler::program::Role;
use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::{Outcome, compare, program as optimised, sleeps};
use grafcet_conformance::reader;

use super::forks::WASH;
use super::kept::{doors, line, mash};
use super::regions::{BOXES, CELL, PLANT};
use super::{read, recorded};

/// A small chart for each pass: its program in front of it and after it, as pseudo-code.
#[test]
fn each_pass_is_as_recorded() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/golden/passes");
    let lamp = "sfc Lamp { input on, off: bool; output lamp, fan: bool; initial step Off { R fan; } step On { S fan; lamp if off; } \
                Off -[on && !off]-> On -[off]-> Off; }";
    let twice = "sfc Twice { input a: bool; output n: u8; output p: bool; initial step A { p; } step B { P1 n = 3; p; } \
                 A -[a]-> B -[!a]-> A; }";
    let called =
        "sfc Called { input a: bool; action heat(); initial step A; step B { heat(); } A -[a]-> B -[!a]-> A; }";
    let horn = "sfc Horn { input a, b: bool; action beep(n: u8); initial step A { N beep(1) if b; } step B { N beep(2) if a; } step C { N beep(1); } A -[a]-> B -[b]-> C -[!a]-> A; }";
    let stairs = "grafcet Stairs { input on, off: bool; output lamp, warm: bool; initial step Dark { R warm; } step Lit { lamp; S warm; } \
                  Dark -[on]-> Lit -[off]-> Dark; }";
    let timed =
        "sfc Timed { input a: bool; output p: bool; initial step A; step B { p; } A -[rising(a)]-> B -[5ms/B]-> A; }";
    let pair = "sfc Pair { input a, b, c, d: bool; output p, q, r: bool; initial step Start { p; } step A1 { q; } step A2; step B1 { p; } \
                step B2 { r; } Start -[a]-> (A1, B1); A1 -[b]-> A2; B1 -[c]-> B2; (A2, B2) -[d]-> Start; }";
    let waits =
        "sfc Waits { input a: bool; output p: bool; initial step A; step B { p; } A -[a && 9ms/A]-> B -[5ms/B]-> A; }";
    let drum = "sfc Drum { input empty, again, full: bool; output pump, valve: bool; initial step Drain { pump; } step Fill { valve; } step Spin; \
                Drain -[empty && again]-> Fill -[full]-> Drain; Drain -[empty && !again]-> Spin -[!empty]-> Drain; }";
    let watch = "grafcet Watch { input on: bool; output lamp: bool; initial step Off; step On { lamp; } \
                 Off -[on]-> On -[5ms/On || !on]-> Off; }";
    let signal = "grafcet Signal { input on: bool; output lamp, wait: bool; initial step Off; step Asked { S wait; } step On { lamp; R wait; } \
                  Off -[on && 3ms/Off]-> Asked -[5ms/Asked]-> On -[5ms/On]-> Off; }";
    let kettle = kettle("");
    let stored = "sfc Stored { input a, b: bool; output lamp, p: bool; initial step Idle { R lamp; } step A1 { S lamp; } step A2; step B1 { p; } step B2; \
                  Idle -[a]-> (A1, B1); A1 -[b]-> A2; B1 -[a && b]-> B2; (A2, B2) -[!a]-> Idle; }";
    let stopped = "grafcet Stopped { input a, b, stop: bool; output p, q: bool; initial step Idle; step A1 { p; } step A2; step B { q; } step Off; \
                   Idle -[a]-> (A1, B); A1 -[b]-> A2; (A2, B) -[a]-> Idle; any -[stop]-> Off -[!stop]-> Idle; }";
    let cases = [
        (Pass::Marks, lamp),
        (Pass::Acted, horn),
        (Pass::Decompose, lamp),
        (Pass::Outputs, lamp),
        (Pass::Peel, PLANT),
        (Pass::Straight, signal),
        (Pass::Split, lamp),
        (Pass::Known, called),
        (Pass::Join, twice),
        (Pass::Told, signal),
        (Pass::Moved, waits),
        (Pass::Search, stairs),
        (Pass::Several, pair),
        (Pass::Apart, &mash()),
        (Pass::Rounds, PLANT),
        (Pass::Starting, watch),
        (Pass::Stays, CELL),
        (Pass::Hoist, timed),
        (Pass::Forward, lamp),
        (Pass::Before, &kettle),
        (Pass::Shown, stored),
        (Pass::Begun, CELL),
        (Pass::Anew, &doors("q;", "S door;")),
        (Pass::Dead, lamp),
        (Pass::Once, drum),
        (Pass::Equal, stopped),
        (Pass::Store, lamp),
        (Pass::Tables, &belt(9)),
        (Pass::Next, &wash()),
        (Pass::Passed, &wash()),
        (Pass::Records, lamp),
        (Pass::Working, stairs),
        (Pass::Numbers, &programme()),
        (Pass::Kinds, &crossed_belt()),
        (Pass::Nested, PLANT),
        (Pass::United, BOXES),
        (Pass::Arms, BOXES),
        (Pass::Direct, WASH),
        (Pass::Fences, pair),
        (Pass::Common, &line("stop && a")),
        (Pass::Limits, &wash()),
    ];
    assert_eq!(cases.map(|(pass, _)| pass), Pass::ALL, "a chart for each pass, in their order");
    for (at, (pass, chart)) in cases.into_iter().enumerate() {
        let model = read(chart);
        // The passes after `Split` are read without what the last ones take away.
        let shaping = [
            Pass::Known,
            Pass::Join,
            Pass::Told,
            Pass::Moved,
            Pass::Search,
            Pass::Several,
            Pass::Apart,
            Pass::Rounds,
            Pass::Starting,
            Pass::Stays,
            Pass::Hoist,
            Pass::Before,
            Pass::Shown,
            Pass::Begun,
        ]
        .contains(&pass);
        let tidy = if shaping { &[Pass::Dead][..] } else { &[] };
        let before = optimised(&model, &[&Pass::ALL[..at], tidy].concat()).expect("a program");
        let after = optimised(&model, &[&Pass::ALL[..=at], tidy].concat()).expect("a program");
        assert_ne!(before.to_string(), after.to_string(), "{pass:?}");
        recorded(
            &root.join(format!("{pass:?}.txt").to_lowercase()),
            &format!("{before}\n\n---- {pass:?} ----\n\n{after}"),
        );
    }
}

/// A fence stands where a register would hold a step for too long, each way lead to what its state does, or a jump table have a word for each step.
#[test]
fn fences_stand_by_the_shape_of_an_evolution() {
    let wash = wash();
    let table = "  fence on ARMv6-M\n  if goes:";
    // Ways of their own, to states that share what they do.
    let rungs = |steps: usize| {
        let mut text = "sfc Rungs { input a, b: bool; output p: bool; var n: u8 = 0; ".to_owned();
        for step in 0..steps {
            let (on, far, action) =
                ((step + 1) % steps, (step + 3) % steps, ["", "p;", "P1 n = n.wrapping_add(1);"][step % 3]);
            let (initial, on_time) = (if step == 0 { "initial " } else { "" }, format!("{}ms/S{step}", step + 2));
            let input = ["a", "b"][step % 2];
            _ = write!(text, "{initial}step S{step} {{ {action} }} ");
            _ = write!(text, "S{step} -[{input}]-> S{on}; S{step} -[!{input} && {on_time}]-> S{far}; ");
        }
        text + "}"
    };
    let long = rungs(30).replacen("sfc", "grafcet", 1);
    let circle = circle("")
        .replacen("input a, b, d", "input a, b", 1)
        .replace("-[b]-> S2;", "-[a && 5ms/S1]-> S2; S1 -[b && !a]-> S0;");
    for (chart, there, elsewhere) in [
        (&wash, table, Some("\n  fence\n")),
        (&rungs(12), "  fence\n  match ", Some("if goes")),
        (&rungs(11), "  fence on ARMv6-M\n  match ", Some("if goes")),
        (&rungs(5), "match state", Some("fence")),
        (&circle, "    fence on ARMv6-M\n", None),
        (&circle, "    fence\n    if goes: now.state = table(state)", None),
        (&circle, "  fence\n  match state", None),
        (&long, "    fence inputs\n    fence\n", Some("fence on ARMv6-M")),
    ] {
        let text = optimised(&read(chart), &Pass::ALL).expect("a program").to_string();
        assert!(text.contains(there), "{there}\n{text}");
        assert!(elsewhere.is_none_or(|elsewhere| !text.contains(elsewhere)), "{elsewhere:?}\n{text}");
    }
}

/// Ten steps, each with a number that is shown.
fn programme() -> String {
    let mut text = "sfc Programme { input a, b: bool; output phase: u8 = 9; output p: bool; ".to_owned();
    for step in 0..10 {
        let (initial, on) = (if step == 0 { "initial " } else { "" }, (step + 1) % 10);
        let phase = if step % 4 == 3 { String::new() } else { format!("phase = {};", step / 2) };
        _ = write!(text, "{initial}step S{step} {{ {phase} {} }} ", ["", "p;", ""][step % 3]);
        _ = write!(text, "S{step} -[{}]-> S{on}; ", ["a", "b && !a", "!b"][step % 3]);
    }
    text + "}"
}

/// Two branches by time, of which one has a step that stays active beyond it.
pub(super) fn kettle(more: &str) -> String {
    format!(
        "sfc Kettle {{ input a, b, c: bool; output p, q: bool; output n: u8; initial step Idle; step A1 {{ p; }} step A2; step B1 {{ q; }} step B2; \
         Idle -[a && 2ms/Idle]-> (A1, B1); A1 -[3ms/A1]-> A2; B1 -[b && 5ms/B1]-> B2; (A2, B2) -[c]-> Idle; {more} }}"
    )
}

/// When timelines begin: not at zero, with which a field could agree by chance, and near the end of the clock, which they pass.
const BEGINNING: u32 = u32::MAX - 60;

/// Inputs at random, for some cycles each.
pub(super) fn storm(inputs: &[&str], cycles: u32) -> String {
    let (mut text, mut seed) = ("---\n---\n".to_owned(), 7_u32);
    for cycle in 0..cycles {
        if cycle % 3 == 0 {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        }
        for (bit, name) in inputs.iter().enumerate() {
            if seed >> (20 + bit) & 1 == 1 {
                _ = write!(text, "{name} ");
            }
        }
        _ = writeln!(text, "@{} | |", BEGINNING.wrapping_add(cycle * 2 - cycle % 3));
    }
    text
}

/// The same in each cycle anew, some of them rarely.
pub(super) fn drawn(inputs: &[(&str, bool)], cycles: u32) -> String {
    let (mut text, mut seed) = ("---\n---\n".to_owned(), 1_u32);
    for cycle in 0..cycles {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        for (bit, (name, rarely)) in inputs.iter().enumerate() {
            let bits = seed >> (8 + 4 * bit) & 15;
            if if *rarely { bits == 0 } else { bits > 6 } {
                _ = write!(text, "{name} ");
            }
        }
        _ = writeln!(text, "@{} | |", BEGINNING.wrapping_add(cycle * 2));
    }
    text
}

/// Steps of which each waits for the same as others.
fn belt(steps: usize) -> String {
    let mut text = "sfc Belt { input a, b: bool; output p: bool; ".to_owned();
    for step in 0..steps {
        let initial = if step == 0 { "initial " } else { "" };
        let input = ["a", "!b"][usize::from(step % 4 == 2)];
        let action = if step % 3 == 1 { " { p; }" } else { ";" };
        _ = write!(text, "{initial}step S{step}{action} S{step} -[{input}]-> S{}; ", (step + 1) % steps);
    }
    text + "}"
}

/// A belt whose steps wait and act alike, but for one that acts as others do: what a table says of both has to tell it apart.
fn crossed_belt() -> String {
    let mut text = "sfc Belt { optimize size; input a, b: bool; output q0, q1, q2, q3, q4, q5: bool; ".to_owned();
    for step in 0..24 {
        let initial = if step == 0 { "initial " } else { "" };
        let condition = ["a", "b", "a && b", "!a", "!b", "a || b"][step % 6];
        let output = if step == 7 { 5 } else { step % 6 };
        _ = write!(text, "{initial}step S{step} {{ q{output}; }} S{step} -[{condition}]-> S{}; ", (step + 1) % 24);
    }
    text + "}"
}

/// Ten steps of a sequence by time, some of which wait for the same, one with two ways and one that stays beyond its time.
fn wash() -> String {
    let mut text = "sfc Wash { input a, b: bool; output p, q: bool; var n: bool; ".to_owned();
    for step in 0..10 {
        let action = ["", "p; ", "S q; ", "R q; P1 n = !n; ", "p if a; "][step % 5];
        _ = write!(text, "{}step S{step} {{ {action}}} ", if step == 0 { "initial " } else { "" });
    }
    for (step, condition) in
        ["a", "5ms/S1", "5ms/S2", "5ms/S3", "a", "a && 3ms/S5", "5ms/S6", "5ms/S7"].iter().enumerate()
    {
        _ = write!(text, "S{step} -[{condition}]-> S{}; ", step + 1);
    }
    text + "S8 -[b]-> S9; S8 -[!b && 5ms/S8]-> S2; S9 -[5ms/S9 && n]-> S1; S9 -[5ms/S9 && !n]-> S0; }"
}

/// Twenty-four steps of a circle that wait for four things; `more` stands in one of them.
fn circle(more: &str) -> String {
    let mut text = "grafcet Circle { input a, b, d: bool; output p: bool; output n: u8 = 0; ".to_owned();
    for step in 0..24 {
        let action = if step == 7 { more } else { ["", "p; "][step % 2] };
        _ = write!(text, "{}step S{step} {{ {action}}} ", if step == 0 { "initial " } else { "" });
    }
    for step in 0..24 {
        _ = write!(text, "S{step} -[{}]-> S{}; ", ["a", "b", "!a", "!b"][step % 4], (step + 1) % 24);
    }
    text + "}"
}

/// The searches of a `grafcet` of one region: one that turns for ever while both inputs are there, one that goes on by a table, one that
/// ends with one of its steps, and one that ends with each of them; and by time, with two ways and with one that has no end. In a long one
/// a table says what is next, also beside a step that goes on and stays.
#[test]
fn searches_of_one_region_end_where_they_have_to() {
    let (belt, wash) = (belt(9).replacen("sfc", "grafcet", 1), wash().replacen("sfc", "grafcet", 1));
    let turns = "grafcet Turns { input a, b: bool; output p: bool; initial step A { R p; } step B { S p; } A -[a]-> B -[b]-> A; }";
    let ends = "grafcet Ends { input a, b: bool; output p, q: bool; initial step A; step B { p; } step C { p; q; } A -[a]-> B -[b]-> C -[!a]-> A; }";
    let once = "grafcet Once { input a, b: bool; output p: bool; output n: u8 = 0; initial step A { P1 n = 1; } step B { p; P1 n = 2; } \
                A -[a]-> B -[!a]-> A; }";
    let ways = "grafcet Ways { input a, b: bool; output p: bool; initial step A; step B { p; } step C; \
                A -[a && 2ms/A]-> B; A -[!a && b]-> C; B -[4ms/B || b]-> A; C -[a]-> A; }";
    let signal = "grafcet Signal { input a, b: bool; output p, q: bool; initial step A; step B { S p; } step C { q; R p; } step D; \
                  A -[a && 3ms/A]-> B -[5ms/B]-> C -[5ms/C]-> D -[5ms/D]-> A; }";
    // `p` is set on one way to C and not on the other, `q` wherever B has been.
    let held = "grafcet Held { input a, b: bool; output p, q, r: bool; initial step A; step B { S q; R r; } step C; step D { R p; R q; } \
                step E { S p; S r; } A -[a]-> B; A -[!a && b]-> E; B -[!a]-> C; E -[a]-> B; C -[2ms/C || b]-> D; D -[!b]-> A; }";
    // The activation stores `ready` on copies of all outputs.
    let entered = "grafcet Entered { input a, b: bool; output p, q, ready: bool; initial step A { S ready; } step B { S p; R ready; } \
                   step C { R p; S q; } step D { R q; } A -[a]-> B -[b]-> C -[!a]-> D -[!b]-> A; }";
    // `p` is on in most steps: so the cycle begins, and A takes it away.
    let mostly = "grafcet Mostly { input a, b: bool; output p: bool; initial step A { R p; } step B { S p; } step C; step D; \
                  A -[a]-> B -[b]-> C -[!a]-> D -[!b]-> A; }";
    // It asks for `p` there, which is as it begins.
    let asks = "grafcet Asks { input a, b: bool; output p, ready: bool; initial step A { S ready if !p; } step B { S p; R ready; } step C { R p; } \
                A -[a]-> B -[b]-> C -[!a]-> A; }";
    let (circle, stays) = (circle(""), circle("on rising(d) n = (n + 1) % 50; on rising(p) n = 9; "));
    for (chart, has) in [
        (circle.as_str(), "now.state = table(now.state)"),
        (stays.as_str(), "if goes: now.state = table(state)"),
        (belt.as_str(), "table("),
        (wash.as_str(), "since"),
        (turns, "evolutions == 6"),
        (ends, "if now.state is A"),
        (once, "match state"),
        (ways, "loop"),
        (signal, "if goes:"),
        (held, "since"),
        (entered, "loop"),
        (asks, "loop"),
        (mostly, "A: p = false"),
    ] {
        let model = read(chart);
        let program = optimised(&model, &Pass::ALL).expect("a program");
        assert!(program.to_string().contains(has), "{program}");
        let mut text = "---\n---\n".to_owned();
        for cycle in 0..200_u32 {
            let inputs = ["", "a", "b", "a b", "a", "b", "a b"][(cycle / 2 % 7) as usize];
            let inputs = if chart == stays && cycle % 3 == 0 { format!("{inputs} d") } else { inputs.to_owned() };
            _ = writeln!(text, "{inputs} @{} | |", cycle * 2 - cycle % 3);
        }
        each_left_out(&model, &text, 60);
    }
    let stored = |chart: &str| {
        let model = read(chart);
        let program = optimised(&model, &Pass::ALL).expect("a program");
        let outputs =
            program.places.into_iter().filter(|place| place.is_field && matches!(place.role, Role::Output(_)));
        outputs.map(|place| place.name).collect::<Vec<_>>()
    };
    assert_eq!(stored(held), ["p"], "how B was entered tells what it holds, and so in C");
    assert!(stored(signal).is_empty() && stored(entered).is_empty() && stored(mostly).is_empty());
    assert_eq!(stored(asks), ["p", "ready"]);
}

/// A sequence by time that only `5ms` and a button keep apart: most of it is a table of times.
#[test]
fn a_table_says_how_long_each_step_takes() {
    let model = read(
        "sfc Lights { input a: bool; output r, y, g: bool; initial step A { g; } step B { y; } step C { r; } step D { r; y; } step E { y; } \
         A -[a && 5ms/A]-> B -[3ms/B]-> C -[70000ms/C]-> D -[2ms/D]-> E -[4ms/E]-> A; }",
    );
    let program = optimised(&model, &Pass::ALL).expect("a program");
    assert!(program.to_string().contains("times(state)"), "{program}");
    let mut text = "---\n---\n".to_owned();
    let mut now = 0;
    for cycle in 0..200_u32 {
        now += [1, 1, 2, 1, 30_000][(cycle % 5) as usize];
        _ = writeln!(text, "{} @{now} | |", ["a", "", ""][(cycle / 4 % 3) as usize]);
    }
    let lines = reader::read(&text).expect("a timeline").lines;
    assert!(matches!(compare(&model, &lines, &Pass::ALL), Ok(Outcome::Same)));
    assert_eq!(sleeps(&model, &lines[..60], &Pass::ALL), Ok(()));
}

/// Steps that wait for the same, each of which leads elsewhere, at the times at which they do.
#[test]
fn steps_that_wait_for_the_same_lead_elsewhere() {
    let model = read(&wash());
    let program = optimised(&model, &Pass::ALL).expect("a program");
    assert!(program.to_string().contains("if goes:"), "{program}");
    let mut text = "---\n---\n".to_owned();
    for cycle in 0..400_u32 {
        let inputs = ["", "a", "b", "a b", "a"][(cycle / 3 % 5) as usize];
        _ = writeln!(text, "{inputs} @{} | |", cycle * 2 - cycle % 3);
    }
    each_left_out(&model, &text, 80);
}

/// A table leads from each step to its next one, and nowhere while its condition does not hold.
#[test]
fn a_table_says_which_step_is_next() {
    for (chart, table) in [(belt(9), "table("), (crossed_belt(), "kinds(")] {
        goes_by_table(&chart, table);
        goes_by_table(&chart.replacen("sfc", "grafcet", 1), table);
    }
    // Asked for size, the table and what the steps do ask for the state as it is stored.
    let small = belt(24).replacen("sfc Belt {", "sfc Belt { optimize size;", 1);
    goes_by_table(&small, "state = table(state)");
    goes_by_table(&small.replacen("sfc", "grafcet", 1), "now.state = table(state)");
}

fn goes_by_table(chart: &str, table: &str) {
    let model = read(chart);
    let program = optimised(&model, &Pass::ALL).expect("a program");
    assert!(program.to_string().contains(table), "{program}");
    let mut text = "---\n---\n".to_owned();
    for cycle in 0..80_u32 {
        let inputs = ["", "a", "b", "a b", "a"][(cycle / 2 % 5) as usize];
        _ = writeln!(text, "{inputs} @{cycle} | |");
    }
    let lines = reader::read(&text).expect("a timeline").lines;
    assert!(matches!(compare(&model, &lines, &Pass::ALL), Ok(Outcome::Same)));
}

/// Who asks for size gets no table of kinds where it would stand beside jump tables, and actions that stand after the evolution on each processor.
#[test]
fn size_is_what_was_asked_for() {
    let printed = |chart: &str, name: &str| {
        let small = chart.replacen(name, &format!("{name} optimize size;"), 1);
        [chart, &small].map(|text| optimised(&read(text), &Pass::ALL).expect("a program").to_string())
    };
    let fences = |text: &str| text.lines().filter(|line| line.trim() == "fence").count();
    let [usual, small] = printed(&wash(), "sfc Wash {");
    assert_eq!((fences(&usual), fences(&small)), (0, 1), "{small}");
    let [usual, small] = printed(&belt(24), "sfc Belt {");
    assert!(!small.contains("kinds("), "{small}");
    // What is next is computed, and asks for the state as it is stored.
    assert_eq!((fences(&usual), fences(&small)), (0, 1), "{small}");
    assert!(small.contains("  fence\n  if goes: state = table(state)"), "{small}");
}

/// A step that no way leaves has no arm where the next state is decided, and keeps its state where that is stored.
#[test]
fn what_cannot_be_left_stays() {
    let model = read(
        "sfc Stays { input b: bool; output q: bool; initial step A; step B { q; } step C; A -[!b]-> B -[rising(A.X)]-> C -[rising(C.X)]-> A; }",
    );
    let mut text = "---\n---\n".to_owned();
    for cycle in 0..12 {
        _ = writeln!(text, "{}@{cycle} | |", ["b ", "b ", "", "", "b "][cycle % 5]);
    }
    each_left_out(&model, &text, 6);
}

/// What a search compares an edge with it reads where it asks for it, in each round.
#[test]
fn a_search_reads_its_edges_where_it_asks_for_them() {
    let model = read(
        "grafcet Sorter { input a, b, c: bool; output p, q: bool; initial step Idle; step Left { p; } step Right { q; } \
         Idle -[rising(a)]-> Left -[b]-> Right -[falling(c)]-> Idle; }",
    );
    let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
    assert!(program.contains("loop, at most"), "{program}");
    assert!(!program.contains("edge0.now") && program.contains("!edge0.before && a"), "{program}");
    each_left_out(&model, &storm(&["a", "b", "c"], 300), 120);
}

/// All passes, and all but one, do at a timeline what the interpreter does; asleep at its first lines.
pub(super) fn each_left_out(model: &Model, text: &str, asleep: usize) {
    let lines = reader::read(text).expect("a timeline").lines;
    for left_out in Pass::ALL.map(Some).into_iter().chain([None]) {
        let mut passes = Pass::ALL.to_vec();
        passes.retain(|pass| Some(*pass) != left_out);
        let outcome = compare(model, &lines, &passes);
        assert!(matches!(outcome, Ok(Outcome::Same)), "{left_out:?}: {:?}", outcome.err());
        assert_eq!(sleeps(model, &lines[..asleep], &passes), Ok(()), "{left_out:?}");
    }
}
