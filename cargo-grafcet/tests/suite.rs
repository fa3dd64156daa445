//! `tests`: suites that show all of a chart.

mod common;

use std::fs;
use std::path::Path;

use common::{Done, folder, tool};
use serde_json::Value;

const MOTOR: &str = "sfc Motor { input on, off, hot: bool; output relay: bool; initial step Off; step On { N relay; }
    Off -[on && !hot]-> On -[off || hot]-> Off; }";

fn suite(chart: &str, more: &[&str]) -> Done {
    let folder = folder(&[("chart.rs", chart)]);
    tool(folder.path(), &[&["tests", "chart.rs"], more].concat())
}

/// How many cycles, and what is not shown.
fn told(chart: &str, more: &[&str]) -> (u64, Vec<String>) {
    let done = suite(chart, &[more, &["--json"]].concat());
    let told: Value = serde_json::from_str(done.out.trim_end()).unwrap_or_else(|error| panic!("{error}: {done:?}"));
    let open = told["open"].as_array().expect("a list").iter();
    let open: Vec<String> = open.map(|one| format!("{}: {}", one["goal"], one["why"]).replace('"', "")).collect();
    let never = told["never"].as_array().expect("a list").iter().filter_map(Value::as_str);
    let dead = never.filter(|goal| goal.ends_with("` clears")).count();
    assert_eq!(done.code, Some(i32::from(!open.is_empty() || dead > 0)), "{done:?}");
    (told["cycles"].as_u64().expect("a number"), open)
}

#[test]
fn no_more_cycles_than_goals() {
    // The first cycle enters `Off`; then each of the two transitions is waited for and clears: four cycles more, and none of them can show two of these.
    let done = suite(MOTOR, &[]);
    assert_eq!(done.code, Some(0), "{done:?}");
    let lines: Vec<&str> = done.out.lines().collect();
    assert_eq!(lines[1..5], ["# Off | - | -", "-", "# Off | - | -", "@100 -"]);
    assert_eq!(lines[5..9], ["# On | relay | Off → On", "@200 on", "# On | relay | -", "@300 -"]);
    assert_eq!(lines[9], "# Off | - | On → Off");
    assert!(["@400 off", "@400 hot"].contains(&lines[10]), "{}", lines[10]);
    assert_eq!(
        lines[12],
        "Motor: 1 sequence, 5 cycles: 2 of 2 transitions clear, 2 of 2 do not although their steps are active"
    );
}

#[test]
fn values_times_and_what_the_program_tells() {
    let all = [
        // Numbers on both sides of constants, parameters, and what is computed of them.
        "sfc C { input level: u8; input x: i16; param most: u8 = 40; var n: i16 = 0;
           initial step A; step B { P { n = x * 2; } } step G;
           A -[level > most && level != 41]-> B -[n >= 14]-> G -[level < 3]-> A; B -[n < -3]-> A; }",
        // Edges, delays, times that are shorter than the step of time and longer.
        "sfc C { input a, b: bool; initial step A; step B; step G;
           A -[rising(a) && falling(b)]-> B -[3s/a]-> G -[20ms/G]-> A; }",
        // Variants, functions and constants.
        "sfc C { input mode: Mode in {Off, Auto, Manual}; input x: u8; input kind: Kind; initial step A; step B; step G; step H;
           A -[mode == Mode::Manual && near(x)]-> B -[x > LIMIT]-> G -[kind == Kind::Large]-> H -[kind != Kind::Large && x == 3]-> A; }",
        // A grafcet goes on in one cycle; what waits for a step of another part.
        "grafcet C { input a, b, c: bool; partial One { initial step A; step B; step G; A -[a]-> B; B -[b && Two::Y.X]-> G -[!a]-> A; B -[!b]-> A; }
           partial Two { initial step V; step Y; V -[c]-> Y -[!c && One::A.X]-> V; } }",
        // What is assumed never comes.
        "sfc C { input up, down: bool; initial step A; step B; assume never up && down; A -[up]-> B -[!up || down]-> A; }",
        // Held back by the modes.
        "sfc C { modes; input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; }",
    ];
    let nothing: [String; 0] = [];
    for chart in all {
        assert_eq!(told(chart, &[]).1, nothing, "{chart}");
    }
}

#[test]
fn what_is_assumed_never_comes() {
    // Nor in the first cycle, and not as the rest position of inputs.
    let done = suite(
        "sfc C { input a, guard: bool; initial step A; step B; assume never !guard; A -[a]-> B -[!a]-> A; }",
        &[],
    );
    assert_eq!(done.code, Some(0), "{done:?}");
    let cycles: Vec<&str> =
        done.out.lines().filter(|line| line.starts_with('@') || line.starts_with("guard")).collect();
    assert_eq!(cycles, ["guard", "@100 guard", "@200 a guard", "@300 a guard", "@400 guard"]);
}

#[test]
fn pairs() {
    // Two ways in and two ways out: four pairs within `B`, and two ways in after each way out.
    let chart =
        "sfc C { input a, b: bool; initial step A; step B; A -[a]-> B -[a && b]-> A; A -[b]-> B -[!a && !b]-> A; }";
    let (single, open) = told(chart, &[]);
    assert_eq!(open.len(), 0, "{open:?}");
    let done = suite(chart, &["--pairs"]);
    assert!(
        done.out.ends_with("4 of 4 transitions clear, 4 of 4 do not although their steps are active, 8 of 8 pairs\n"),
        "{}",
        done.out
    );
    // Eight pairs are eight ways in and out at least, of which four are needed anyhow.
    let (all, _) = told(chart, &["--pairs"]);
    assert!(all >= 9 && all > single, "{all} {single}");
    // Three ways out after each way in: one of them needs a way in that shows nothing new by itself.
    let chart = "sfc C { input a, b, c: bool; initial step A; step B; step W; A -[a]-> B; A -[b]-> B; B -[a]-> W; B -[b]-> W; B -[c]-> W; W -[true]-> A; }";
    assert_eq!(told(chart, &["--pairs"]).1.len(), 0);
}

#[test]
fn what_cannot_be_shown() {
    let chart = "sfc C { input a: bool; initial step A; step B; step G; A -[a]-> B -[a && B.T > 2s && !a]-> G; B -[!a]-> A; G -[true]-> A; }";
    let (_, open) = told(chart, &["--limit", "0s"]);
    assert_eq!(open.len(), 2, "{open:?}");
    assert!(open[0].starts_with("`B → G` clears: the compiler says: "), "{open:?}");
    assert!(open[1].starts_with("`G → A` clears: "), "{open:?}");
    // What is frozen waits for nothing.
    let chart =
        "grafcet C { input a: bool; partial One { initial step A { force Two {*}; } step B { force Two {*}; } A -[a]-> B -[!a]-> A; }
       partial Two { initial step V; step Y; V -[a]-> Y -[!a]-> V; } }";
    let (_, open) = told(chart, &["--limit", "0s"]);
    assert!(
        open.iter().any(|one| one.starts_with("`V → Y` does not clear although its steps are active: ")),
        "{open:?}"
    );
    // Of what no value is known, there is no way; and an effort that is too small is said.
    let chart =
        "sfc C { input x: u32; initial step A; step B; A -[x % 4096 == 77 && x / 4096 == 99]-> B -[true]-> A; }";
    let (_, open) = told(chart, &["--limit", "0s"]);
    assert_eq!(open[0], "`A → B` clears: in none of the 2 states that the tried values and times lead to");
    let (_, open) = told(MOTOR, &["--effort", "1", "--limit", "0s"]);
    assert!(
        open.iter().all(|one| one.ends_with("not found in 1 cycles, which is the effort that was allowed")),
        "{open:?}"
    );
}

#[test]
fn scripts_protocol_and_what_has_no_rust() {
    let program = MOTOR.replace("!hot", "calm(3)");
    let folder = folder(&[("chart.rs", MOTOR), ("program.rs", &program)]);
    let run = |arguments: &[&str]| tool(folder.path(), arguments);
    let read = |file: &str| fs::read_to_string(folder.path().join(file)).expect(file);
    let done = run(&["tests", "chart.rs", "--out", "scripts", "--protocol", "motor.md"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    assert_eq!(done.out.lines().count(), 1, "{}", done.out);
    // What the suite claims, coverage finds on its own.
    let done = run(&["coverage", "chart.rs", "--script", "scripts/motor-1.script"]);
    assert!(done.out.starts_with("Motor: 2 of 2 steps active, 2 of 2 transitions cleared"), "{}", done.out);
    let page = read("motor.md");
    assert!(
        page.starts_with("# Protocol: Motor\n\nWhat is expected is from the chart, to be confirmed by a person.\n"),
        "{page}"
    );
    assert!(page.contains("| ☐ | 3 | 200 ms | on | On | relay | Off → On | |\n"), "{page}");
    assert_eq!(page.matches('☐').count(), 5);
    let done = run(&["tests", "program.rs", "--rust", "motor.rs"]);
    let said = "note: the chart asks its program: `the_program_answers` in motor.rs has to be written by you; until then its tests fail\n";
    assert_eq!((done.code, done.err.as_str()), (Some(0), said));
    let rust = read("motor.rs");
    for part in [
        "struct Answers {\n    /// `calm(3)`\n    calm_3: bool,\n}\n",
        "fn the_program_answers(answers: Answers) {\n    todo!(",
        "    the_program_answers(Answers { calm_3: true });\n",
        "    the_program_answers(Answers { calm_3: false });\n",
    ] {
        assert!(rust.contains(part), "{part}\n{rust}");
    }
    syn::parse_file(&rust).expect("Rust");
}

/// `tests/suites.rs` runs them with the compiled charts.
#[test]
fn suites_of_the_examples() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = folder(&[]);
    for name in ["branch_on_result", "cell", "line24v", "motor", "pick_and_place", "recipe", "stroke", "tickless"] {
        let (source, path) = (format!("examples/charts/{name}.rs"), format!("super::{name}"));
        let written = folder.path().join(name).display().to_string();
        let done = tool(&root, &["tests", &source, "--rust", &written, "--path", &path]);
        assert_eq!((done.code, done.err.as_str()), (Some(0), ""), "{name}: {done:?}");
        let (kept, written) = (root.join(format!("tests/suites/{name}.rs")), fs::read_to_string(&written).expect(name));
        // `cargo xtask bless` records them anew.
        if std::env::var_os("BLESS").is_some() {
            fs::write(&kept, &written).expect(name);
        }
        assert_eq!(fs::read_to_string(&kept).expect(name), written, "{name}");
    }
}

/// The same of a chart that asks its program: `tests/suites/asked.rs` is what is written, with the function that a person has to write.
#[test]
fn a_suite_that_asks_the_program() {
    const TO_BE_WRITTEN: &str = "    todo!(\"let the program answer {answers:?}\")\n";
    const BY_A_PERSON: &str = "    super::asked::answer(answers.is_calm_3);\n";
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = folder(&[]);
    let written = folder.path().join("asked.rs").display().to_string();
    let done = tool(&root, &["tests", "tests/suites/program/asked.rs", "--rust", &written, "--path", "super::asked"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    let written = fs::read_to_string(&written).expect("written");
    assert_eq!(written.matches(TO_BE_WRITTEN).count(), 1, "{written}");
    let written = written.replace(TO_BE_WRITTEN, BY_A_PERSON);
    let kept = root.join("tests/suites/asked.rs");
    if std::env::var_os("BLESS").is_some() {
        fs::write(&kept, &written).expect("kept");
    }
    assert_eq!(fs::read_to_string(&kept).expect("kept"), written);
}

/// Values that nobody guesses, in both dialects, and a number of cycles that the search does not go.
#[test]
fn the_prover_finds_ways() {
    let nothing: [String; 0] = [];
    for dialect in ["sfc", "grafcet"] {
        let chart = format!(
            "{dialect} C {{ input x: u32; initial step A; step B; A -[x % 4096 == 77 && x / 4096 == 99]-> B -[x > 0]-> A; }}"
        );
        assert_eq!(told(&chart, &[]).1, nothing, "{dialect}");
    }
    // Only as long as it is asked.
    let chart =
        "sfc C { input x: u32; initial step A; step B; A -[x % 4096 == 77 && x / 4096 == 99]-> B -[x > 0]-> A; }";
    assert!(!told(chart, &["--limit", "0s"]).1.is_empty());
}

/// Each step is left in the cycle that enters it, or never entered: the search does not show that, the prover does.
#[test]
fn the_prover_proves_that_there_is_no_way() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (file, never) in [("car_wash", 2), ("interlocked", 2), ("token_ring", 3)] {
        let file = format!("tests/good/{file}.rs");
        // Long, as other tests run at the same time.
        let done = tool(&root, &["tests", &file, "--limit", "10min", "--json"]);
        let told: Value = serde_json::from_str(done.out.trim_end()).unwrap_or_else(|error| panic!("{error}: {done:?}"));
        assert_eq!(told["open"].as_array().map(Vec::len), Some(0), "{file}: {told}");
        let all: Vec<&str> = told["never"].as_array().expect("a list").iter().filter_map(Value::as_str).collect();
        assert_eq!((all.len(), done.code), (never, Some(0)), "{file}: {all:?}");
        assert!(
            all.iter().all(|one| one.ends_with(" does not clear although its steps are active")),
            "{file}: {all:?}"
        );
    }
    // A way of the prover counts only where the simulation shows the goal: here its step is active where a circle of the chart is stopped, and is left in the
    // next cycle all the same.
    let done = tool(&root, &["tests", "tests/good/handshake.rs", "--limit", "10min", "--json"]);
    let told: Value = serde_json::from_str(done.out.trim_end()).unwrap_or_else(|error| panic!("{error}: {done:?}"));
    let why = "the prover leads to where it could be, and the search finds no way on from there";
    assert_eq!(
        (told["open"][0]["why"].as_str(), told["open"][1].as_str(), done.code),
        (Some(why), None, Some(1)),
        "{told}"
    );
    // A transition that never clears is a fault, of which the compiler need not know: that `n` is even takes more than its states.
    for dialect in ["sfc", "grafcet"] {
        let count = "step B { P1 n = (n + 2) & 30; }";
        let chart = format!(
            "{dialect} C {{ input a: bool; var n: u8 = 0; initial step A; {count} step G; A -[a && n != 31]-> B -[!a && n != 31]-> A; B -[n == 31]-> G -[!a]-> A; }}"
        );
        let done = suite(&chart, &["--json"]);
        let told: Value = serde_json::from_str(done.out.trim_end()).unwrap_or_else(|error| panic!("{error}: {done:?}"));
        assert_eq!(done.code, Some(1), "{told}");
        let said = format!("{} {}", told["never"], told["open"]);
        assert!(said.contains("`G → A` clears"), "{told}");
    }
}
