//! Naive programs: the corpus, random charts beside the interpreter, and what a person reads. No rustc is needed.

use std::fmt::Write as _;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Id, Model, OutputId, Place, Read};
use grafcet_compiler::parse;
use grafcet_compiler::program::passes::Pass;
use grafcet_compiler::program::run::{Error, Foreign, Machine};
use grafcet_compiler::program::{Refused, Role, Statement, Value, naive};
use grafcet_conformance::program::{Outcome, Programmed, compare, program as optimised, rests, sleeps};
use grafcet_conformance::{chart, fragments, play, random, reader};
use proc_macro2::TokenStream;

mod delays;
mod forks;
mod growth;
mod integers;
mod kept;
mod length;
mod nearly;
mod needs;
mod passes;
mod regions;
mod shapes;
mod synchronised;
mod told;
mod watched;

#[path = "../../../charts/mod.rs"]
#[allow(dead_code, unreachable_pub, reason = "its other half is for expansions")]
mod charts;

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

/// Every file of the corpus, naive and after all passes, what `next_deadline` says included.
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
        for passes in [&[][..], &Pass::ALL] {
            let result = optimised(&model, passes).and_then(|program| {
                let mut subject = Programmed::new(&program)?;
                play::against_the_file(&mut subject, &case.lines).map_err(|difference| difference.to_string())
            });
            match result {
                Ok(()) => played += 1,
                Err(error) => _ = writeln!(failures, "{name}, {} passes: {error}", passes.len()),
            }
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
    assert!(played > 380, "only {played} are played");
}

/// Always the same charts; `cargo xtask conformance --program` compares more.
#[test]
fn random_charts_do_what_the_interpreter_does() {
    let (mut compared, mut failures) = (0, String::new());
    for (seed, grafcet) in (900_000..900_060).flat_map(|seed| [(seed, false), (seed, true)]) {
        let made = random::chart(seed, grafcet, 40);
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        let lines = reader::read(&format!("{}---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
        match compare(&model, &lines, &[]) {
            Ok(Outcome::Same) => compared += 1,
            Ok(Outcome::NotUnderstood(_)) => {}
            Err(error) => _ = writeln!(failures, "{grafcet} {seed}: {error}\n{}", made.chart),
        }
        if let Err(error) = sleeps(&model, &lines[..lines.len().min(10)], &[]) {
            _ = writeln!(failures, "{grafcet} {seed} asleep: {error}\n{}", made.chart);
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
    assert!(passes_left_out(910_000..910_012, true) > 0, "too few are a match");
}

/// How many of the charts are a match after all passes.
fn passes_left_out(seeds: Range<u64>, grafcet: bool) -> usize {
    const EACH: usize = 4;
    let (mut charts, mut compared, mut matched, mut failures) = (0, 0, 0, String::new());
    for seed in seeds {
        let made = random::chart(seed, grafcet, 40);
        let Ok(model) = chart::resolve(&made.chart) else { continue };
        let lines = reader::read(&format!("{}---\n{}", made.chart, made.timeline)).expect("a timeline").lines;
        let whole = optimised(&model, &Pass::ALL).expect("a program");
        matched += usize::from(is_match(&whole.cycle));
        let in_turn = Pass::ALL.into_iter().cycle().skip(charts * EACH).take(EACH);
        for left_out in in_turn.map(Some).chain([None]) {
            let mut passes = Pass::ALL.to_vec();
            // What observers are told is compared, too.
            passes.retain(|pass| Some(*pass) != left_out && (*pass != Pass::Marks || seed % 2 == 0));
            match compare(&model, &lines, &passes) {
                Ok(Outcome::Same) => compared += 1,
                Ok(Outcome::NotUnderstood(_)) => {}
                Err(error) => _ = writeln!(failures, "{grafcet} {seed} without {left_out:?}: {error}\n{}", made.chart),
            }
            if let Err(error) = sleeps(&model, &lines[..lines.len().min(10)], &passes) {
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
    assert_eq!(sleeps(&model, &lines, &[]), Ok(()));
}

/// An edge of an edge that only an action looks at: what conditions would have seen of it is a cycle late, and nobody asks.
#[test]
fn an_edge_that_nothing_asks_for_is_no_reason_to_go_on() {
    let model = read(
        "sfc C { input a: bool; output w: bool; initial step A { L 4ms { w = rising(falling(B.X)); } } step B; step D { w if 6ms/D; } \
         A -[!a]-> B -[a]-> D; }",
    );
    let lines =
        reader::read("---\n---\n@0 | |\n@1 | |\na @2 | |\na @3 | |\na @4 | |\na @5 | |\n").expect("a timeline").lines;
    assert_eq!(rests(&model, &lines, &[]), Ok(()));
}

/// An edge in what a step does leaves something to the next cycle while that step is active, one that can but let a transition clear nothing. What the step leaves is told by the
/// state that the cycle is said to have begun with.
#[test]
fn an_edge_leaves_something_where_somebody_asks_for_it() {
    let chart = "sfc Vent { input a, b, c: bool; output p, q: bool; initial step A { p; } step B { q if rising(c); } step C; \
         A -[a]-> B -[b && 5ms/B]-> C -[rising(a) || 9ms/C]-> A; }";
    let model = read(chart);
    let program = optimised(&model, &Pass::ALL).expect("a program");
    assert_eq!(program.place(Role::Settled), None, "{program}");
    assert!(!program.to_string().contains("edge0.now = c"), "{program}");
    let event = chart.replacen("q if rising(c)", "q if 3ms/B; P1 p = falling(c)", 1);
    let hindered = chart.replacen("-[rising(a) ||", "-[!rising(b) &&", 1);
    let search = chart.replacen("sfc", "grafcet", 1).replacen("q if", "q = true on", 1);
    let branches =
        chart.replacen("A -[a]-> B -[", "step D; step E; A -[a]-> (B, D); D -[falling(b)]-> E; (B, E) -[", 1);
    for chart in [chart, &event, &hindered, &search, &branches] {
        passes::each_left_out(&read(chart), &passes::storm(&["a", "b", "c"], 300), 150);
    }
}

/// What the checks refuse has no program, whoever asks.
#[test]
fn what_has_no_meaning_is_refused() {
    let refused = |text: &str| naive(&read(text), &Facts::of(&read(text))).err();
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
    let program = naive(&model, &Facts::of(&model)).expect("a program");
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
                let program = optimised(&model, passes).expect("a program");
                _ = write!(text, "{}{program}", if text.is_empty() { "" } else { "\n\n" });
            }
            recorded(&root.join(format!("tests/golden/{folder}/{name}.txt")), &text);
        }
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
