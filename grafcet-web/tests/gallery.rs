//! Every chart that the page offers is without fault, and runs.

use std::path::{Path, PathBuf};

use grafcet_web::gallery::{Shown, of_markdown, of_rust};
use grafcet_web::{Play, check, look};
use serde_json::{Value, json};

fn charts() -> Vec<Shown> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let read =
        |path: PathBuf| std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut charts: Vec<Shown> =
        of_markdown(&read(root.join("docs/cookbook.md"))).expect("Rust").into_iter().map(|(_, shown)| shown).collect();
    for folder in ["examples/charts", "tests/good"] {
        let entries = std::fs::read_dir(root.join(folder)).expect("a folder");
        let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
        files.retain(|file| file.extension().is_some_and(|end| end == "rs"));
        files.sort();
        charts.extend(files.into_iter().flat_map(|file| of_rust(&read(file)).expect("Rust")));
    }
    charts
}

#[test]
fn all_of_them_run() {
    let charts = charts();
    assert!(charts.len() > 80, "{} charts", charts.len());
    for Shown { name, text } in charts {
        let seen: Value = serde_json::from_str(&look(&text)).expect("JSON");
        assert!(seen["name"] == json!(name) && seen["drawing"].is_string(), "{text}");
        let said: Value = serde_json::from_str(&check(&text)).expect("JSON");
        assert_eq!((&said["messages"], &said["runs"]), (&json!([]), &json!(true)), "{text}");
        let mut play = Play::new(&text, 10).unwrap_or_else(|error| panic!("{name}: {error}"));
        play.advance(20).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}
