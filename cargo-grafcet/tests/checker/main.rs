//! `prove --with`: what the tool makes of the answers of a checker, and how it shows that it waits. The checker is in this program, too.

#[path = "../common/mod.rs"]
mod common;
mod model;
#[path = "../common/tmux.rs"]
mod tmux;

use std::env;
use std::fs;
use std::path::Path;
use std::thread;
use std::time::Duration;

use common::{Done, folder, tool};
use serde_json::Value;
use tmux::Tmux;

const CHARTS: &str = "
grafcet! { sfc Motor { input on, hot: bool; output relay: bool; initial step Off; step On { relay; }
    Off -[on && !hot]-> On -[!on]-> Off;
    never relay && Off.X;
    home Off; } }
grafcet! { sfc Hoist { input up, down: bool; output raise, lower: bool; initial step Wait; step Up { raise; } step Down { lower; }
    Wait -[up]-> Up -[!up]-> Wait; Wait -[down && !up]-> Down -[!down]-> Wait;
    assume never up && down;
    always raise => !up;
    never raise && down;
    Up leads_to Wait;
    Up before Down; } }
grafcet! { sfc Count { input go: bool; var n: u8 = 253; initial step A; step B { P1 n = n + 1; } A -[go]-> B -[!go]-> A;
    always n >= 253;
    never n == 254; } }
";

/// How it is called by the tool: this program, which answers where a file of a question is named.
fn command(words: &str) -> String {
    let program = env::current_exe().expect("this program");
    format!("'{}' --exact answers --nocapture {words}", program.display())
}

/// The checker. As a test it has nothing to do: only the tool names a question.
#[test]
fn answers() {
    let words: Vec<String> = env::args().collect();
    let Some(question) = words.iter().find(|word| [".aig", ".aag", ".btor2"].iter().any(|end| word.ends_with(end)))
    else {
        return;
    };
    let has = |word: &str| words.iter().any(|other| other == word);
    if has("sleeps") {
        thread::sleep(Duration::from_secs(600));
    }
    let model = model::read(Path::new(question));
    let mut answer = if has("proves") {
        "0\nb0\n.\n".to_owned()
    } else if has("refutes") {
        model.witness(&[vec![false; model.inputs()], vec![false; model.inputs()]])
    } else if has("refuses") {
        "2\nb0\n.\n".to_owned()
    } else {
        model.check()
    };
    if has("stops") {
        answer.truncate(answer.len() - 3);
    }
    if has("narrow") {
        answer = answer.replace("\n1", "\n");
    }
    if has("silent") {
        answer = "Nothing is known.\n".to_owned();
    }
    match words.iter().find(|word| word.ends_with("witness")) {
        Some(file) => fs::write(file, answer).expect("the witness"),
        None => println!("\n{answer}"),
    }
}

fn prove(more: &[&str]) -> Done {
    let folder = folder(&[("charts.rs", CHARTS)]);
    tool(folder.path(), &[&["prove", "charts.rs"], more].concat())
}

/// Without what a checker adds.
fn verdicts(done: &Done) -> Vec<&str> {
    done.out
        .lines()
        .filter(|line| !line.starts_with("    by the word of") && !line.starts_with("    decided here"))
        .collect()
}

#[test]
fn a_checker_says_the_same() {
    let own = prove(&[]);
    assert_eq!(own.code, Some(1), "{own:?}");
    for words in ["{aig}", "{aag}", "{btor2}", "", "{aig} {witness}", "{btor2} {witness}"] {
        let done = prove(&["--with", &command(words)]);
        assert_eq!((done.code, done.err.as_str()), (Some(1), ""), "{words}");
        assert_eq!(verdicts(&own), verdicts(&done), "{words}");
    }
    let done = prove(&["--with", &command("{aig}"), "--chart", "Motor"]);
    assert_eq!(done.code, Some(0), "{done:?}");
    let by = env::current_exe().expect("this program");
    let expected = format!(
        "Motor: proved: never relay && Off.X\n    by the word of `{}`, without a certificate\nMotor: proved: home Off\n    \
         decided here: a way home is nothing that checkers of circuits are asked\n",
        by.file_name().expect("its name").display()
    );
    assert_eq!(done.out, expected);
}

#[test]
fn programs_are_told_by_whom() {
    let with = command("{aig}");
    let done = prove(&["--json", "--with", &with]);
    let said: Vec<Value> = done.out.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
    let by: Vec<(&Value, &Value)> = said.iter().map(|one| (&one["verdict"], &one["by"])).collect();
    let (with, none) = (Value::from(with), Value::Null);
    let [proved, broken, undecided] = ["proved", "broken", "undecided"].map(Value::from);
    let expected = [
        (&proved, &with),
        (&proved, &none),
        (&broken, &with),
        (&proved, &with),
        (&broken, &with),
        (&broken, &with),
        (&undecided, &with),
        (&broken, &with),
    ];
    assert_eq!(by, expected, "{done:?}");
    assert_eq!(said[2]["cycles"], 2);
}

#[test]
fn what_is_not_so_is_no_verdict() {
    let cases = [
        (
            "Motor",
            "refutes {aig}",
            "never relay && Off.X",
            "is not so: the circuit does not break the property in its 2 cycles",
        ),
        (
            "Motor",
            "refutes {btor2}",
            "never relay && Off.X",
            "is not so: the circuit does not break the property in its 2 cycles",
        ),
        (
            "Hoist",
            "proves {aig}",
            "always raise => !up",
            "is not so: it says that the property holds, which is broken in cycle 2",
        ),
    ];
    for (chart, words, property, what) in cases {
        let done = prove(&["--chart", chart, "--with", &command(words)]);
        assert_eq!((done.code, done.out.as_str()), (Some(2), ""), "{words}: {done:?}");
        assert_eq!(done.err, format!("error: {chart}: {property}: what `{}` says {what}\n", command(words)));
    }
    let not_understood = [
        (
            "silent",
            "there is no witness in it: no line `1` and after it the number of the property (`b0`), and no line `0`",
        ),
        ("stops", "the witness does not end with a line `.`"),
        ("narrow", "values, and the circuit has"),
    ];
    for (words, what) in not_understood {
        let done = prove(&["--chart", "Hoist", "--with", &command(&format!("{words} {{aig}} {{witness}}"))]);
        assert_eq!((done.code, done.out.as_str()), (Some(2), ""), "{words}: {done:?}");
        assert!(done.err.contains("what it says is not understood: ") && done.err.contains(what), "{}", done.err);
    }
}

#[test]
fn what_cannot_be_asked() {
    let done = prove(&["--with", "no-such-checker --fast"]);
    assert_eq!(done.code, Some(2));
    let begin = "error: --with `no-such-checker --fast`: `no-such-checker` cannot be started: ";
    assert!(done.err.starts_with(begin), "{}", done.err);
    let done = prove(&["--with", "abc -c 'pdr"]);
    assert_eq!(
        (done.code, done.err.as_str()),
        (Some(2), "error: --with `abc -c 'pdr`: a quotation mark is not closed\n")
    );
    let done = prove(&["--with", " "]);
    assert_eq!((done.code, done.err.as_str()), (Some(2), "error: --with ` `: there is no command\n"));
    let done = prove(&["--chart", "Motor", "--with", &command("refuses {aig}")]);
    assert_eq!(done.code, Some(1));
    assert!(
        done.out.starts_with("Motor: undecided: never relay && Off.X\n    the checker has not found it out\n"),
        "{done:?}"
    );
    // What is no time.
    for (limit, said) in [
        ("soon", "`soon` is none of `ms`, `s`, `min` and `h`"),
        ("10", "there is no unit"),
        ("5days", "`days` is none of `ms`, `s`, `min` and `h`"),
    ] {
        let done = prove(&["--limit", limit]);
        assert!(done.code == Some(2) && done.err.contains(said), "{done:?}");
    }
}

/// What the tool's own solver does not decide soon.
const LONG: &str = "
grafcet! { sfc Count { input go: bool; var n: u8 = 253; initial step A; step B { P1 n = n + 1; } step C { P1 n = n - 1; } A -[go]-> B -[!go]-> A; A -[!go]-> C -[go]-> A;
    always n >= 10; } }
";

#[test]
fn somebody_who_waits_sees_what_for() {
    let folder = folder(&[("charts.rs", CHARTS)]);
    let sleeps = command("sleeps {aig}");
    // What is no terminal shows nothing of it.
    let arguments = ["prove", "charts.rs", "--chart", "Motor", "--limit", "700ms", "--with", &sleeps];
    let done = tool(folder.path(), &arguments);
    assert_eq!((done.code, done.err.as_str()), (Some(1), ""), "{done:?}");
    let stopped = format!("Motor: undecided: never relay && Off.X\n    `{sleeps}` was stopped at the limit\n");
    assert!(done.out.starts_with(&stopped), "{done:?}");
    fs::write(folder.path().join("arguments"), &sleeps).expect("a file");
    let program = env!("CARGO_BIN_EXE_cargo-grafcet");
    let line = format!(
        "{program} prove charts.rs --chart Motor --limit 4s --with \"$(cat arguments)\"; echo ended $?; read end"
    );
    let tmux = Tmux::run(folder.path(), "200", "30", &line);
    tmux.comes_to("sleeps {aig}, 1 s: Motor: never relay && Off.X");
    let screen = tmux.comes_to("ended 1");
    assert!(screen.contains("Motor: proved: home Off") && !screen.contains(", 1 s: "), "{screen}");
    fs::write(folder.path().join("long.rs"), LONG).expect("a file");
    let inner = folder.path().join("inner");
    fs::create_dir(&inner).expect("a folder");
    let tmux =
        Tmux::run(&inner, "60", "20", &format!("{program} prove ../long.rs --limit 3s; echo ended $?; read end"));
    // As much of it as there is room for.
    let screen = tmux.comes_to("IC3, frame ");
    assert!(screen.lines().any(|line| line.ends_with(" s: Count: always n >= 10")), "{screen}");
    let screen = tmux.comes_to("ended 1");
    let expected = "Count: undecided: always n >= 10\n    the solver was stopped at its limit\nended 1";
    assert_eq!(screen.trim_end(), expected);
}
