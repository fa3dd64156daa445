//! `simulate`: scripts without a terminal, and a terminal (tmux), whose screens are those of the same script.

mod common;
#[path = "common/tmux.rs"]
mod tmux;

use std::fs;

use common::{folder, tool};
use serde_json::{Value, json};
use tmux::Tmux;

const CHARTS: &str = "
grafcet! { sfc Motor { input on, hot: bool; input load: u8; output relay: bool; initial step Off; step On { relay; }
    Off -[on && !hot && calm(load)]-> On -[!on || 10 / load > 7]-> Off; } }
grafcet! { sfc Log { input go: bool; var n: u16 = 0; initial step A; step B { P { for i in 0..3 { n = n + i; } } } A -[go]-> B -[!go]-> A; } }
";

#[test]
fn scripts() {
    let files = [
        ("charts.rs", CHARTS),
        ("good.script", "load=4\n@2500 on load=4 `calm(load)`\n"),
        ("bad.script", "-\non `calm(x)`\n"),
        // Divided by a load of zero.
        ("fails.script", "-\non `calm(load)`\non\n"),
        ("log.script", "-\ngo\n"),
    ];
    let folder = folder(&files);
    let play = |chart: &str, script: &str, more: &[&str]| {
        tool(folder.path(), &[&["simulate", "charts.rs", "--chart", chart, "--script", script], more].concat())
    };
    let done = play("Motor", "good.script", &[]);
    assert_eq!((done.code, done.err.as_str()), (Some(0), ""), "{done:?}");
    assert!(done.out.contains("1      2.5 s  on load=4  On     relay    Off → On\n"), "{}", done.out);
    assert!(done.out.contains("│●On"), "{}", done.out);
    assert!(
        done.out.ends_with("`On → Off` waits for `!on` (on = true) or `(10 / load) > 7` (load = 4)\n"),
        "{}",
        done.out
    );

    let done = play("Motor", "good.script", &["--json"]);
    let cycles: Vec<Value> = done.out.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
    let expected = json!({
        "cycle": 1, "now": 2500, "inputs": { "on": true, "hot": false, "load": 4 }, "outside": { "calm(load)": true }, "params": {},
        "steps": ["On"], "outputs": { "relay": true }, "variables": {}, "happened": ["Off → On"], "stable": true,
        "waits": ["`On → Off` waits for `!on` (on = true) or `(10 / load) > 7` (load = 4)"],
    });
    assert_eq!((cycles.len(), &cycles[1]), (2, &expected));

    let done = play("Motor", "bad.script", &[]);
    let said = "error: bad.script: line 2: ``calm(x)`` is no input of the chart with a value that it can have\n";
    assert_eq!((done.code, done.err.as_str()), (Some(2), said));
    let done = play("Motor", "fails.script", &[]);
    assert_eq!(done.code, Some(1));
    assert_eq!(done.err, "error: cycle 2 of fails.script cannot be run: division by zero\n");
    let done = play("Log", "log.script", &[]);
    assert_eq!(done.code, Some(0), "{done:?}");
    assert!(done.err.starts_with("note: `{ for i"), "{}", done.err);
    assert!(done.err.ends_with("` is Rust that is not simulated: it writes nothing\n"), "{}", done.err);
    assert_eq!(play("Motor", "good.script", &["--frames", "20x5"]).code, Some(2));
    // What it covers can be asked, too.
    let done = tool(folder.path(), &["coverage", "charts.rs", "--chart", "Motor", "--script", "good.script"]);
    assert_eq!((done.code, done.err.as_str()), (Some(1), ""), "{done:?}");
    assert!(done.out.starts_with("Motor: 2 of 2 steps active, 1 of 2 transitions cleared"), "{}", done.out);
    // Without a terminal there is nothing to play in.
    let done = tool(folder.path(), &["simulate", "charts.rs", "--chart", "Motor"]);
    assert_eq!(done.code, Some(2));
    assert_eq!(done.err, "error: there is no terminal to play in; --script FILE runs cycles without one\n");
}

#[test]
fn the_terminal_shows_what_the_script_does() {
    let folder = folder(&[("charts.rs", CHARTS), ("same.script", "-\n@100 on\n@200 on\n@400\n")]);
    let chart = ["simulate", "charts.rs", "--chart", "Motor"];
    let frames = tool(folder.path(), &[&chart[..], &["--script", "same.script", "--frames", "100x30"]].concat());
    let lines: Vec<&str> = frames.out.lines().collect();
    let screens: Vec<String> = lines.chunks(30).map(|screen| screen.join("\n")).collect();
    assert_eq!(screens.len(), 4, "{frames:?}");
    let command = format!("{} {}; echo ended $?; read end", env!("CARGO_BIN_EXE_cargo-grafcet"), chart.join(" "));
    let tmux = Tmux::run(folder.path(), "100", "30", &command);
    tmux.comes_to("before the first cycle");
    tmux.keys(&["Enter"]);
    tmux.shows(&screens[0]);
    tmux.keys(&["o", "Enter"]);
    tmux.shows(&screens[1]);
    tmux.keys(&["Enter"]);
    tmux.shows(&screens[2]);
    // Back in time, and on another way.
    tmux.keys(&["BSpace"]);
    tmux.shows(&screens[1]);
    tmux.keys(&["BSpace"]);
    tmux.shows(&screens[0]);
    tmux.keys(&["o", "Enter", "+", "Enter"]);
    let screen = tmux.comes_to("cycle 2 · 300 ms · time step 200 ms · stopped");
    assert!(screen.contains("`Off → On` waits for `calm(load)` (load = 0)"), "{screen}");
    // A function of the program, a number, and the chart moves.
    tmux.keys(&["c", "l", "5", "Enter", "Enter"]);
    let screen = tmux.comes_to("│●On");
    let line = |begin: &str, end: &str| screen.lines().any(|line| line.contains(begin) && line.ends_with(end));
    for (begin, end) in [("│in On ", " │"), ("│Off → On ", " │"), ("│  relay ", " ● │"), ("›l load ", " 5 │")]
    {
        assert!(line(begin, end), "{begin}…{end}\n{screen}");
    }
    tmux.keys(&["C-s"]);
    tmux.comes_to("4 cycles in motor.script");
    let saved = fs::read_to_string(folder.path().join("motor.script")).expect("the script");
    assert_eq!(saved, "-\n@100 on\n@300 on\n@500 on load=5 `calm(load)`\n");
    // It runs by itself until somebody stops it: cycles come without a key.
    tmux.keys(&["Space"]);
    tmux.comes_to("cycle 6 · ");
    tmux.keys(&["Space"]);
    tmux.comes_to("stopped");
    tmux.keys(&["Escape"]);
    tmux.comes_to("ended 0");
    // What is there already is not written over unasked.
    let again = Tmux::run(&folder.path().join("."), "100", "30", &command);
    again.comes_to("before the first cycle");
    again.keys(&["C-s"]);
    again.comes_to("motor.script is there already: begin with --save FILE");
}
