//! What `check` says, and by which exit code.

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::{folder, tool};
use serde_json::Value;

/// The step `Ende` cannot be left; `Öl` in front of it is one letter of two bytes.
const WRONG: &str = "\
grafcet! {
    sfc Press {
        input a: bool;
        output q: bool;
        initial step A { q; }
        /* Öl */ step Ende;
        A -[a]-> Ende;
    }
}
";

/// An input that nothing reads is a warning.
const WARNED: &str =
    "grafcet! { sfc Warned { input a, unused: bool; initial step A; step B; A -[a]-> B -[!a]-> A; } }\n";

#[test]
fn exit_codes() {
    let good = WARNED.replace(", unused", "");
    let folder = folder(&[("wrong.rs", WRONG), ("warned.rs", WARNED), ("good.rs", &good)]);
    let code = |arguments: &[&str]| tool(folder.path(), &[&["check"], arguments].concat()).code;
    assert_eq!(code(&["good.rs"]), Some(0));
    assert_eq!(code(&["warned.rs"]), Some(0));
    assert_eq!(code(&["warned.rs", "--deny-warnings"]), Some(1));
    assert_eq!(code(&["good.rs", "--deny-warnings"]), Some(0));
    assert_eq!(code(&["good.rs", "wrong.rs"]), Some(1));
    assert_eq!(code(&["wrong.rs", "--json"]), Some(1));
    assert_eq!(code(&["wrong.rs", "--sarif"]), Some(1));
    assert_eq!(code(&["gone.rs"]), Some(2));
    assert_eq!(code(&["--no-such-option"]), Some(2));
    assert_eq!(code(&["--help"]), Some(0));
    assert_eq!(
        tool(folder.path(), &["check", "good.rs", "wrong.rs", "warned.rs"]).out.lines().last(),
        Some("3 charts: 1 error, 1 warning")
    );
}

#[test]
fn a_message_stands_at_its_place() {
    let folder = folder(&[("wrong.rs", WRONG)]);
    let done = tool(folder.path(), &["check", "wrong.rs"]);
    let lines: Vec<&str> = done.out.lines().map(str::trim_end).collect();
    assert!(lines[0].starts_with("error[grafcet::deadlock]: in `Ende`"), "{}", lines[0]);
    assert_eq!(
        lines[1..5],
        [" --> wrong.rs:6:23", "  |", "6 |         /* Öl */ step Ende;", "  |                       ^^^^"]
    );
    // Colours are for terminals.
    assert!(!done.out.contains('\u{1b}'));
    assert!(tool(folder.path(), &["--color", "always", "check", "wrong.rs"]).out.contains("\u{1b}["));
}

#[test]
fn one_json_object_a_message() {
    let folder = folder(&[("wrong.rs", WRONG), ("warned.rs", WARNED)]);
    let done = tool(folder.path(), &["check", "wrong.rs", "warned.rs", "--json"]);
    let messages: Vec<Value> = done.out.lines().map(parsed).collect();
    assert_eq!(messages.len(), 2, "{}", done.out);
    let [wrong, warned] = [&messages[0], &messages[1]];
    assert_eq!(
        [&wrong["level"], &wrong["rule"], &wrong["chart"], &wrong["file"]],
        ["error", "grafcet::deadlock", "Press", "wrong.rs"]
    );
    let note = &wrong["notes"][0];
    assert_eq!(
        [&note["start"]["line"], &note["start"]["column"], &note["end"]["line"], &note["end"]["column"]],
        [6, 23, 6, 27]
    );
    let bytes =
        [&note["bytes"][0], &note["bytes"][1]].map(|byte| byte.as_u64().and_then(|byte| usize::try_from(byte).ok()));
    assert_eq!(bytes[0].zip(bytes[1]).and_then(|(start, end)| WRONG.get(start..end)), Some("Ende"));
    assert!(note["table"].as_str().is_some_and(|table| table.contains("A → Ende")), "{note}");
    assert_eq!([&warned["level"], &warned["rule"]], ["warning", "grafcet::unused_input"]);
}

fn parsed(line: &str) -> Value {
    serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"))
}

/// What the standard asks for: a version, a driver with its rules, results with places and known rules.
#[test]
fn sarif() {
    let folder = folder(&[
        ("wrong.rs", WRONG),
        ("warned.rs", WARNED),
        ("bad.rs", "grafcet! { scf Typo { initial step A; A -[true]-> A; } }"),
    ]);
    let log = parsed(&tool(folder.path(), &["check", "wrong.rs", "warned.rs", "bad.rs", "--sarif"]).out);
    assert_eq!(log["version"], "2.1.0");
    let run = &log["runs"][0];
    let rules: Vec<&Value> =
        run["tool"]["driver"]["rules"].as_array().into_iter().flatten().map(|rule| &rule["id"]).collect();
    let results: Vec<&Value> = run["results"].as_array().into_iter().flatten().collect();
    let ids: Vec<Option<&str>> = results.iter().map(|result| result["ruleId"].as_str()).collect();
    assert_eq!(ids, [Some("grafcet::deadlock"), Some("grafcet::unused_input"), None]);
    for result in &results {
        assert!(result["ruleId"].is_null() || rules.contains(&&result["ruleId"]), "{result}");
        assert!(result["message"]["text"].as_str().is_some_and(|text| !text.is_empty()));
    }
    let region = &results[0]["locations"][0]["physicalLocation"];
    assert_eq!(region["artifactLocation"]["uri"], "wrong.rs");
    assert_eq!(
        [&region["region"]["startLine"], &region["region"]["startColumn"], &region["region"]["endColumn"]],
        [6, 23, 27]
    );
}

/// A property that the checker leaves open is one for the solver.
#[test]
fn a_solver_is_asked() {
    let chart = "grafcet! { sfc Counts { input go: bool; output q: bool; var n: u8 = 0;
        initial step A { P1 { if n < 3 { n += 1; } } } step B { q; }
        A -[go]-> B -[!go]-> A;
        never n > 3; } }";
    let folder = folder(&[("counts.rs", chart)]);
    let open = tool(folder.path(), &["check", "counts.rs", "--json"]);
    assert!(open.out.contains("grafcet::property_undecided"), "{}", open.out);
    let proved = tool(folder.path(), &["check", "counts.rs", "--prove"]);
    assert_eq!((proved.code, proved.out.as_str()), (Some(0), "1 chart: nothing to say\n"));
}

/// Every error that the tool shows of the charts for messages is one that rustc has shown, word by word.
#[test]
fn it_says_what_the_macro_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/ui");
    let mut files = Vec::new();
    below(&root, &mut files);
    assert!(files.len() > 60, "{} files", files.len());
    let (mut compared, mut said) = (0, 0);
    for file in files {
        let recorded = fs::read_to_string(file.with_extension("stderr")).unwrap_or_default();
        let Some(name) = file.to_str() else { continue };
        let out = tool(&root, &["check", name, "--json"]).out;
        for message in out.lines().map(parsed).filter(|message| message["level"] == "error") {
            for note in message["notes"].as_array().into_iter().flatten() {
                let sentence = note["message"].as_str().unwrap_or_default();
                assert!(recorded.contains(sentence), "{name}: {sentence}");
                said += 1;
            }
        }
        compared += 1;
        // The other way round: what bears the name of a rule is the compiler's.
        for line in recorded.lines().filter(|line| line.starts_with("error: ") && line.contains("[grafcet::")) {
            let sentence = line.trim_start_matches("error: ");
            // A warning that was made an error.
            let sentence = sentence
                .strip_prefix("use of deprecated")
                .and_then(|rest| rest.split_once("`: "))
                .map_or(sentence, |(_, said)| said);
            let sentence = sentence.rsplit_once(" [grafcet::").map_or(sentence, |(sentence, _)| sentence);
            let known = out.lines().map(parsed).any(|message| {
                message["notes"].as_array().into_iter().flatten().any(|note| note["message"] == sentence)
            });
            assert!(known, "{name}: {line}");
        }
    }
    assert!(compared > 60 && said > 150, "{compared} files, {said} messages");
}

fn below(folder: &Path, files: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for entry in entries.flatten().map(|entry| entry.path()) {
        if entry.is_dir() {
            below(&entry, files);
        } else if entry.extension().is_some_and(|end| end == "rs") && entry.with_extension("stderr").is_file() {
            files.push(entry);
        }
    }
    files.sort();
}

/// A plant is a chart of the same call.
#[test]
fn mistakes_of_a_plant() {
    let call = "grafcet! {
    sfc Press { input top: bool; output down: bool; initial step A { down; } step B; A -[top]-> B -[!top]-> A; }
    plant Ram { input down: bool; output top: bool; initial step Low; step High { top; } Low -[down]-> High -[!down]-> Lwo; }
}";
    let folder = folder(&[("press.rs", call)]);
    let done = tool(folder.path(), &["check", "press.rs", "--json"]);
    let said: Vec<Value> = done.out.lines().map(parsed).collect();
    assert_eq!((done.code, said.len()), (Some(1), 1), "{}", done.out);
    assert_eq!(
        [&said[0]["rule"], &said[0]["notes"][0]["start"]["line"]],
        [&Value::from("grafcet::unknown_step"), &Value::from(3)]
    );
}
