//! SARIF beside its schema (`sarif/NOTICE.md`).

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::{folder, tool};
use jsonschema::Validator;
use serde_json::{Value, json};

const SCHEMA: &str = include_str!("sarif/sarif-schema-2.1.0.json");

fn schema() -> Validator {
    let schema: Value = serde_json::from_str(SCHEMA).expect("JSON");
    // It says draft 4, and uses a format that came later, `uri-reference`.
    jsonschema::draft7::options().should_validate_formats(true).build(&schema).expect("a schema")
}

fn assert_valid(validator: &Validator, log: &Value, about: &str) {
    let faults: Vec<String> =
        validator.iter_errors(log).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(faults.is_empty(), "{about}: {faults:#?}");
}

fn sarif(folder: &Path, files: &[&str]) -> Value {
    let done = tool(folder, &[&["check"], files, &["--sarif"]].concat());
    serde_json::from_str(&done.out).unwrap_or_else(|error| panic!("{error}: {done:?}"))
}

/// What rustc prints for bad charts is recorded in `tests/ui`: each of these charts, with all places that its messages name.
#[test]
fn every_bad_chart_of_the_project() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/ui");
    let validator = schema();
    let (mut results, mut related) = (0, 0);
    for file in rust_files(&root) {
        let name = file.strip_prefix(&root).expect("below it").display().to_string();
        let done = tool(&root, &["check", &name, "--sarif"]);
        // A file that is no Rust, or has no chart, is nothing to check.
        let Ok(log) = serde_json::from_str::<Value>(&done.out) else {
            assert_eq!(done.code, Some(2), "{done:?}");
            continue;
        };
        assert_valid(&validator, &log, &name);
        let all = log["runs"][0]["results"].as_array().expect("results");
        results += all.len();
        related += all.iter().filter(|result| !result["relatedLocations"].is_null()).count();
    }
    println!("{results} results, {related} of them with others who take part");
    assert!(results > 100 && related > 10, "{results}, {related}");
}

/// In a folder and all below it.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.path()).collect();
    entries.sort();
    for entry in entries {
        if entry.is_dir() {
            files.extend(rust_files(&entry));
        } else if entry.extension().is_some_and(|end| end == "rs") {
            files.push(entry);
        }
    }
    files
}

#[test]
fn nothing_to_say_and_paths_of_all_kinds() {
    let good = "grafcet! { sfc Good { input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; } }";
    let bad = "grafcet! { sfc Bad { input a: bool; initial step A; step B; A -[a]-> B; } }";
    let folder = folder(&[("good.rs", good), ("Über alles/100% #1.rs", bad)]);
    let validator = schema();
    let log = sarif(folder.path(), &["good.rs"]);
    assert_valid(&validator, &log, "good.rs");
    assert_eq!(log["runs"][0]["results"], json!([]));
    let name = "Über alles/100% #1.rs";
    let path = folder.path().join(name);
    for file in [name, &path.display().to_string()] {
        let log = sarif(folder.path(), &[file]);
        assert_valid(&validator, &log, file);
        assert_eq!(log["runs"][0]["results"].as_array().map(Vec::len), Some(1), "{log}");
    }
}

/// The schema finds what is wrong.
#[test]
fn what_is_no_sarif() {
    let bad = "grafcet! { sfc Bad { input a: bool; initial step A; step B; A -[a]-> B; } }";
    let folder = folder(&[("bad.rs", bad)]);
    let (validator, log) = (schema(), sarif(folder.path(), &["bad.rs"]));
    assert_valid(&validator, &log, "bad.rs");
    let changes: [fn(&mut Value); 5] = [
        |log| log["version"] = "2.0.0".into(),
        |log| log["runs"][0]["results"][0]["level"] = "fatal".into(),
        |log| log["runs"][0]["results"][0]["message"] = json!({}),
        |log| log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0.into(),
        |log| {
            log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] = "a b".into();
        },
    ];
    for (number, change) in changes.iter().enumerate() {
        let mut wrong = log.clone();
        change(&mut wrong);
        assert!(!validator.is_valid(&wrong), "change {number}");
    }
}
