//! Naive programs: the corpus, random charts beside the interpreter, and what a person reads. No rustc is needed.

use std::fmt::Write as _;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Id, Model, OutputId, Place, Read};
use grafcet_compiler::parse;
use grafcet_compiler::program::passes::{Pass, optimise};
use grafcet_compiler::program::run::{Error, Foreign, Machine};
use grafcet_compiler::program::{Encoding, Expr, Program, Refused, Role, Statement, Value, naive};
use grafcet_conformance::program::{Outcome, Programmed, compare, program as optimised, sleeps};
use grafcet_conformance::{chart, fragments, play, random, reader};
use proc_macro2::TokenStream;

#[path = "../../charts/mod.rs"]
#[allow(dead_code, unreachable_pub, reason = "its other half is for expansions")]
mod charts;

const ENCODINGS: [Encoding; 2] = [Encoding::Regions, Encoding::Flags];

fn corpus() -> Vec<(String, String)> {
    let entries = fs::read_dir(env!("CARGO_MANIFEST_DIR")).expect("the corpus is there");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("a folder entry").path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "chart"));
    files.sort();
    let read = |path: &PathBuf| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        (name, fs::read_to_string(path).expect("a corpus file can be read"))
    };
    files.iter().map(read).collect()
}

fn resolved(tokens: TokenStream) -> Model {
    let mut sink = Sink::new();
    let model = parse::chart(tokens, &mut sink).map(|chart| model::resolve(&chart, &mut sink));
    _ = sink.finish();
    model.expect("a chart")
}

fn read(text: &str) -> Model {
    resolved(fragments::plain(text).parse().expect("tokens"))
}

/// Every file of the corpus in both encodings, what `next_deadline` says included.
#[test]
fn every_program_behaves_as_worked_out_by_hand() {
    let (mut played, mut failures) = (0, String::new());
    for (name, text) in corpus() {
        let case = reader::read(&text).expect("a chart and a timeline");
        let model = read(&case.chart);
        if model.forceable {
            // A program makes no cycle by hand.
            continue;
        }
        for encoding in ENCODINGS {
            let result = naive(&model, &Facts::of(&model), encoding).map_err(|refused| refused.to_string()).and_then(
                |program| {
                    let mut subject = Programmed::new(&program)?;
                    play::against_the_file(&mut subject, &case.lines).map_err(|difference| difference.to_string())
                },
            );
            match result {
                Ok(()) => played += 1,
                Err(error) => _ = writeln!(failures, "{name} {encoding:?}: {error}"),
            }
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
    assert!(played > 280, "only {played} are played");
}

/// Always the same charts; `cargo xtask conformance --program` compares more.
#[test]
fn random_charts_do_what_the_interpreter_does() {
    let (mut compared, mut failures) = (0, String::new());
    for (seed, grafcet) in (900_000..900_060).flat_map(|seed| [(seed, false), (seed, true)]) {
        let made = random::chart(seed, grafcet, 40);
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        let lines = reader::read(&format!("{}---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
        let encoding = ENCODINGS[usize::from(seed % 3 == 0)];
        match compare(&model, &lines, encoding, &[]) {
            Ok(Outcome::Same) => compared += 1,
            Ok(Outcome::NotUnderstood(_)) => {}
            Err(error) => _ = writeln!(failures, "{grafcet} {seed} {encoding:?}: {error}\n{}", made.chart),
        }
        if let Err(error) = sleeps(&model, &lines[..lines.len().min(10)], encoding, &[]) {
            _ = writeln!(failures, "{grafcet} {seed} {encoding:?} asleep: {error}\n{}", made.chart);
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
    assert!(compared > 60, "only {compared} are compared");
}

/// The same of an `sfc` after all passes, and after all but one; the next three charts leave out other ones.
/// `cargo xtask conformance --program` compares more.
#[test]
fn no_pass_changes_what_an_sfc_does() {
    assert!(passes_left_out(910_000..910_027, false) > 2, "too few are a match");
}

#[test]
fn no_pass_changes_what_a_grafcet_does() {
    assert!(passes_left_out(910_000..910_009, true) > 0, "too few are a match");
}

/// How many of the charts are a match after all passes.
fn passes_left_out(seeds: Range<u64>, grafcet: bool) -> usize {
    const EACH: usize = 4;
    let (mut charts, mut compared, mut matched, mut failures) = (0, 0, 0, String::new());
    for seed in seeds {
        let made = random::chart(seed, grafcet, 40);
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        let lines = reader::read(&format!("{}---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
        let whole = optimised(&model, Encoding::Regions, &Pass::ALL).expect("a program");
        matched += usize::from(is_match(&whole.cycle));
        let in_turn = Pass::ALL.into_iter().cycle().skip(charts * EACH).take(EACH);
        for left_out in in_turn.map(Some).chain([None]) {
            let mut passes = Pass::ALL.to_vec();
            // What observers are told is compared, too.
            passes.retain(|pass| Some(*pass) != left_out && (*pass != Pass::Marks || seed % 2 == 0));
            match compare(&model, &lines, Encoding::Regions, &passes) {
                Ok(Outcome::Same) => compared += 1,
                Ok(Outcome::NotUnderstood(_)) => {}
                Err(error) => _ = writeln!(failures, "{grafcet} {seed} without {left_out:?}: {error}\n{}", made.chart),
            }
            if let Err(error) = sleeps(&model, &lines[..lines.len().min(10)], Encoding::Regions, &passes) {
                _ = writeln!(failures, "{grafcet} {seed} without {left_out:?} asleep: {error}\n{}", made.chart);
            }
        }
        charts += 1;
    }
    assert!(failures.is_empty(), "\n{failures}");
    assert!(charts * EACH >= Pass::ALL.len(), "some pass is left out by none of {charts} charts");
    assert!(compared > charts * EACH / 2, "only {compared} are compared");
    matched
}

/// Whether the state decides what is done, in the cycle or in its search. No naive program does that.
fn is_match(cycle: &[Statement<'_>]) -> bool {
    cycle.iter().any(|statement| match statement {
        Statement::Match(..) => true,
        Statement::Loop { body, .. } => is_match(body),
        _ => false,
    })
}

/// A pulse that ends one cycle after it began: what it has written is written anew by another block then.
#[test]
fn a_block_that_ends_is_looked_at_again() {
    let model = read(
        "sfc C { input go: bool; output w: bool; output q: bool; initial step A; step B { S { w = true; } P w = false; N q if 9ms/B; } \
         A -[go]-> B -[!go]-> A; }",
    );
    let lines = reader::read("---\n---\n@0 | |\ngo @1 | |\ngo @30 | |\n").expect("a timeline").lines;
    for encoding in ENCODINGS {
        assert_eq!(sleeps(&model, &lines, encoding, &[]), Ok(()), "{encoding:?}");
    }
}

/// What the checks refuse has no program, whoever asks.
#[test]
fn what_has_no_meaning_is_refused() {
    let refused = |text: &str| naive(&read(text), &Facts::of(&read(text)), Encoding::Regions).err();
    let circle = "grafcet C { var a, b: bool; initial step A { a if b; b if a; } step B; A -[a]-> B -[true]-> A; }";
    assert_eq!(refused(circle), Some(Refused::Circle));
    let forcing = "grafcet C { partial Up { initial step A { force Down {}; } step A2; A -[true]-> A2 -[true]-> A; }
                   partial Down { initial step B { force Up {}; } step B2; B -[true]-> B2 -[true]-> B; } }";
    assert_eq!(refused(forcing), Some(Refused::Circle));
    let late = "grafcet C { output q: bool; initial step A { SD 5s q; } step B; A -[true]-> B -[true]-> A; }";
    assert_eq!(refused(late), Some(Refused::Target("A".to_owned())));
    let bare = "sfc C { output q: bool; initial step A { P1 q; } step B; A -[true]-> B -[true]-> A; }";
    assert_eq!(refused(bare), Some(Refused::Target("A".to_owned())));
}

/// `level.abs() > 5` and a block with a loop, as whoever runs the program knows them.
struct Known;

impl Foreign for Known {
    fn value(&mut self, text: &str, reads: &[(Read, Value)]) -> Result<Value, Error> {
        match (text, reads) {
            ("level.abs()", [(_, Value::Int(level))]) => Ok(Value::Int(level.abs())),
            _ => Err(Error::NotUnderstood(text.to_owned())),
        }
    }

    fn block(&mut self, text: &str, reads: &[(Read, Value)]) -> Result<Vec<(Place, Value)>, Error> {
        match reads {
            [(_, Value::Int(n))] => Ok(vec![(Place::Output(OutputId::new(0)), Value::Int(n + 3))]),
            _ => Err(Error::NotUnderstood(text.to_owned())),
        }
    }
}

#[test]
fn rust_that_is_not_looked_into_is_asked_for() {
    let model = read(
        "sfc C { input level: i16; output n: u8; initial step A; step B { P1 { for _ in 0..3 { n += 1; } } } \
         A -[level.abs() > 5]-> B -[level.abs() < 5]-> A; }",
    );
    let program = naive(&model, &Facts::of(&model), Encoding::Regions).expect("a program");
    let mut machine = Machine::new(&program, &mut Known).expect("initial values");
    let n = program.place(Role::Output(OutputId::new(0))).expect("an output");
    let mut shown = Vec::new();
    for level in [0, 5, -6, -6, 0, 9] {
        machine.cycle(&[Value::Int(level)], 0, &mut Known).expect("known");
        shown.push(machine.value(n));
    }
    assert_eq!(shown, [0, 0, 3, 3, 3, 6].map(Value::Int));
}

/// The programs of the examples, as pseudo-code. `cargo xtask bless` records them anew.
#[test]
fn programs_are_as_recorded() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for name in ["branch_on_result", "cell", "controller", "line24v", "motor", "recipe", "tickless"] {
        let rust = fs::read_to_string(root.join(format!("examples/charts/{name}.rs"))).expect("an example");
        for (folder, passes) in [("program", &[][..]), ("program/optimised", &Pass::ALL)] {
            let mut text = String::new();
            for chart in charts::charts(&rust) {
                let model = resolved(chart);
                let encoding = if model.flags { Encoding::Flags } else { Encoding::Regions };
                let program = optimised(&model, encoding, passes).expect("a program");
                _ = write!(text, "{}{program}", if text.is_empty() { "" } else { "\n\n" });
            }
            recorded(&root.join(format!("tests/golden/{folder}/{name}.txt")), &text);
        }
    }
    let flags = read(
        "sfc Pair { input b1, b2: bool; output q: bool; initial step S1; step S2 { q; } S1 -[b1]-> S2 -[b2]-> S1; }",
    );
    let program: Program<'_> = naive(&flags, &Facts::of(&flags), Encoding::Flags).expect("a program");
    recorded(&root.join("tests/golden/program/flags.txt"), &program.to_string());
}

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
    for (pass, chart) in [
        (Pass::Marks, lamp),
        (Pass::Apart, lamp),
        (Pass::Outputs, lamp),
        (Pass::Split, lamp),
        (Pass::Known, called),
        (Pass::Join, twice),
        (Pass::Moved, waits),
        (Pass::Search, stairs),
        (Pass::Several, pair),
        (Pass::Rounds, PLANT),
        (Pass::Hoist, timed),
        (Pass::Forward, lamp),
        (Pass::Dead, lamp),
        (Pass::Once, drum),
        (Pass::Store, lamp),
        (Pass::Tables, &belt()),
        (Pass::Next, &wash()),
        (Pass::Passed, &wash()),
        (Pass::Records, lamp),
        (Pass::Fences, pair),
    ] {
        let model = read(chart);
        let at = Pass::ALL.iter().position(|other| *other == pass).expect("a pass");
        // The passes after `Split` are read without what the last ones take away.
        let shaping = [Pass::Known, Pass::Join, Pass::Moved, Pass::Search, Pass::Several, Pass::Rounds, Pass::Hoist]
            .contains(&pass);
        let tidy = if shaping { &[Pass::Dead][..] } else { &[] };
        let before = optimised(&model, Encoding::Regions, &[&Pass::ALL[..at], tidy].concat()).expect("a program");
        let after = optimised(&model, Encoding::Regions, &[&Pass::ALL[..=at], tidy].concat()).expect("a program");
        assert_ne!(before.to_string(), after.to_string(), "{pass:?}");
        recorded(
            &root.join(format!("{pass:?}.txt").to_lowercase()),
            &format!("{before}\n\n---- {pass:?} ----\n\n{after}"),
        );
    }
}

/// Nine steps, two of which wait for the same as others.
fn belt() -> String {
    let mut text = "sfc Belt { input a, b: bool; output p: bool; ".to_owned();
    for step in 0..9 {
        let initial = if step == 0 { "initial " } else { "" };
        let input = ["a", "!b"][usize::from(step % 4 == 2)];
        let action = if step % 3 == 1 { " { p; }" } else { ";" };
        _ = write!(text, "{initial}step S{step}{action} S{step} -[{input}]-> S{}; ", (step + 1) % 9);
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

/// A stop that forces two modes, one of which encloses two branches; a part beside them that looks at the branches.
const PLANT: &str = "grafcet Plant { input stop, go, auto, x, y, z: bool; output p, q, r, s: bool; output n: bool = false; \
     partial Safety { initial step Ready; step Stopped { force Modes {}; p; } step Restart { force Modes {INIT}; force Side {INIT}; } \
       Ready -[stop]-> Stopped -[!stop && rising(go)]-> Restart -[true]-> Ready; } \
     partial Modes { initial step Manual { q; } enclosing step Auto { partial Work { linked step Wait; step A1 { r; } step A2; \
       step B1 { P1 n = !n; } step B2; \
       Wait -[x]-> (A1, B1); A1 -[y]-> A2; B1 -[z && A2.X]-> B2; B1 -[5ms/B1]-> B2; (A2, B2) -[!x]-> Wait; } } \
       Manual -[rising(auto)]-> Auto -[!auto && Work::Wait.X]-> Manual; } \
     partial Side { initial step S1 { S s; } step S2 { force Other {}; R s; } S1 -[Work::A1.X || x && y]-> S2 -[!Work::B1.X && !x]-> S1; } \
     partial Other { initial step O1; step O2; O1 -[z]-> O2 -[y && 3ms/O2]-> O1; } }";

/// What forces and encloses, what is forced and enclosed, and what looks at both, at random inputs.
#[test]
fn a_search_goes_from_above_downwards() {
    let model = read(PLANT);
    let program = optimised(&model, Encoding::Regions, &Pass::ALL).expect("a program");
    let Some(Statement::Loop { body, .. }) = program.cycle.iter().find(|one| matches!(one, Statement::Loop { .. }))
    else {
        panic!("{program}");
    };
    assert!(body.iter().any(|one| matches!(one, Statement::Match(..))), "{program}");
    let (mut text, mut seed) = ("---\n---\n".to_owned(), 1_u32);
    for cycle in 0..240_u32 {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let mut inputs = String::new();
        for (bit, (name, rarely)) in
            [("stop", true), ("go", false), ("auto", false), ("x", false), ("y", false), ("z", false)]
                .into_iter()
                .enumerate()
        {
            let bits = seed >> (8 + 4 * bit) & 15;
            if if rarely { bits == 0 } else { bits > 6 } {
                _ = write!(inputs, "{name} ");
            }
        }
        _ = writeln!(text, "{inputs}@{} | |", cycle * 2);
    }
    let lines = reader::read(&text).expect("a timeline").lines;
    for left_out in Pass::ALL.map(Some).into_iter().chain([None]) {
        let mut passes = Pass::ALL.to_vec();
        passes.retain(|pass| Some(*pass) != left_out);
        let outcome = compare(&model, &lines, Encoding::Regions, &passes);
        assert!(matches!(outcome, Ok(Outcome::Same)), "{left_out:?}: {:?}", outcome.err());
        assert_eq!(sleeps(&model, &lines[..40], Encoding::Regions, &passes), Ok(()), "{left_out:?}");
    }
}

/// A sequence by time that only `5ms` and a button keep apart: most of it is a table of times.
#[test]
fn a_table_says_how_long_each_step_takes() {
    let model = read(
        "sfc Lights { input a: bool; output r, y, g: bool; initial step A { g; } step B { y; } step C { r; } step D { r; y; } step E { y; } \
         A -[a && 5ms/A]-> B -[3ms/B]-> C -[70000ms/C]-> D -[2ms/D]-> E -[4ms/E]-> A; }",
    );
    let program = optimised(&model, Encoding::Regions, &Pass::ALL).expect("a program");
    assert!(program.to_string().contains("times(state)"), "{program}");
    let mut text = "---\n---\n".to_owned();
    let mut now = 0;
    for cycle in 0..200_u32 {
        now += [1, 1, 2, 1, 30_000][(cycle % 5) as usize];
        _ = writeln!(text, "{} @{now} | |", ["a", "", ""][(cycle / 4 % 3) as usize]);
    }
    let lines = reader::read(&text).expect("a timeline").lines;
    assert!(matches!(compare(&model, &lines, Encoding::Regions, &Pass::ALL), Ok(Outcome::Same)));
    assert_eq!(sleeps(&model, &lines[..60], Encoding::Regions, &Pass::ALL), Ok(()));
}

/// Steps that wait for the same, each of which leads elsewhere, at the times at which they do.
#[test]
fn steps_that_wait_for_the_same_lead_elsewhere() {
    let model = read(&wash());
    let program = optimised(&model, Encoding::Regions, &Pass::ALL).expect("a program");
    assert!(program.to_string().contains("if goes:"), "{program}");
    let mut text = "---\n---\n".to_owned();
    for cycle in 0..400_u32 {
        let inputs = ["", "a", "b", "a b", "a"][(cycle / 3 % 5) as usize];
        _ = writeln!(text, "{inputs} @{} | |", cycle * 2 - cycle % 3);
    }
    let lines = reader::read(&text).expect("a timeline").lines;
    for left_out in Pass::ALL.map(Some).into_iter().chain([None]) {
        let mut passes = Pass::ALL.to_vec();
        passes.retain(|pass| Some(*pass) != left_out);
        let outcome = compare(&model, &lines, Encoding::Regions, &passes);
        assert!(matches!(outcome, Ok(Outcome::Same)), "{left_out:?}: {:?}", outcome.err());
        assert_eq!(sleeps(&model, &lines[..80], Encoding::Regions, &passes), Ok(()), "{left_out:?}");
    }
}

/// A table leads from each step to its next one, and nowhere while its condition does not hold.
#[test]
fn a_table_says_which_step_is_next() {
    let model = read(&belt());
    let program = optimised(&model, Encoding::Regions, &Pass::ALL).expect("a program");
    assert!(program.to_string().contains("table("), "{program}");
    let mut text = "---\n---\n".to_owned();
    for cycle in 0..80_u32 {
        let inputs = ["", "a", "b", "a b", "a"][(cycle / 2 % 5) as usize];
        _ = writeln!(text, "{inputs} @{cycle} | |");
    }
    let lines = reader::read(&text).expect("a timeline").lines;
    assert!(matches!(compare(&model, &lines, Encoding::Regions, &Pass::ALL), Ok(Outcome::Same)));
}

/// An arm of no step is none of a step: what two arms do is not done for the step that has none.
#[test]
fn what_only_some_states_do_is_not_hoisted() {
    let model = read(
        "grafcet Two { input a, b: bool; output p: bool; partial Up { initial step A { force Down {}; } step B; A -[a]-> B -[b]-> A; } \
         partial Down { initial step C; step D { p; } C -[a]-> D -[b]-> C; } }",
    );
    let mut program = optimised(&model, Encoding::Regions, &[]).expect("a program");
    let state = program.place(Role::State(1)).expect("a region");
    let p = program.place(Role::Output(OutputId::new(0))).expect("an output");
    let set = || vec![Statement::Set(p, Expr::Value(Value::Bool(true)))];
    let arm = |step: Option<usize>| (vec![Value::Step(step.map(|at| program.regions[1][at]))], set());
    let cycle = |arms| {
        vec![Statement::Loop { rounds: 1, body: vec![Statement::Match(state, arms, Vec::new()), Statement::Break] }]
    };
    let of_some = cycle(vec![arm(Some(0)), arm(None)]);
    let of_all = cycle(vec![arm(Some(0)), arm(Some(1)), arm(None)]);
    for (cycle, hoisted) in [(of_some, false), (of_all, true)] {
        program.cycle = cycle;
        optimise(&mut program, &[Pass::Hoist]);
        let Some(Statement::Loop { body, .. }) = program.cycle.first() else { panic!("{program}") };
        assert_eq!(matches!(body[0], Statement::Set(..)), hoisted, "{program}");
    }
}

fn recorded(path: &Path, now: &str) {
    if std::env::var_os("BLESS").is_some_and(|bless| bless == "1") {
        return fs::write(path, now).expect("the folder is there");
    }
    let before = fs::read_to_string(path).unwrap_or_default();
    let different = before.lines().zip(now.lines()).find(|(before, now)| before != now);
    assert!(before == now, "{}: {different:?}\nIf that is meant, run `cargo xtask bless`", path.display());
}

/// A chart of a thousand steps: each state is looked at with what concerns it, and not with all fourteen thousand statements, which
/// takes more than ten times as long.
#[test]
fn a_long_chart_takes_no_time() {
    let mut text = "sfc Long { input a: bool; output p, q, r: bool; ".to_owned();
    for step in 0..1000 {
        let initial = if step == 0 { "initial " } else { "" };
        let action = ["N p", "S q", "R q", "L 5ms r"][step % 4];
        let condition = if step % 2 == 0 { "a".to_owned() } else { format!("5ms/S{step}") };
        _ = write!(text, "{initial}step S{step} {{ {action}; }} S{step} -[{condition}]-> S{}; ", (step + 1) % 1000);
    }
    let model = read(&format!("{text}}}"));
    let mut program = naive(&model, &Facts::of(&model), Encoding::Regions).expect("a program");
    let start = Instant::now();
    optimise(&mut program, &Pass::ALL);
    let seconds = start.elapsed().as_secs_f64();
    let is_match = |statement: &&Statement<'_>| matches!(statement, Statement::Match(..));
    assert_eq!(program.cycle.iter().filter(is_match).count(), 2, "it is no match");
    println!("1,000 steps: {seconds:.3} s");
    assert!(seconds < 3.0, "1,000 steps take {seconds:.3} s");
}
