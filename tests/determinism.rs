//! The same chart gives the same bytes in two processes: nothing in the compiler depends on a hash, an address or the
//! time.

mod charts;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Where the other process writes its expansions.
const FILE: &str = "GRAFCET_EXPANSIONS";

#[test]
fn two_processes_expand_the_same_charts_to_the_same_bytes() {
    assert!(!expand(&many_names()).contains("compile_error"), "the large chart is in order");
    let here = expansions();
    assert!(here.matches("struct").count() > 100, "there is something to compare");
    for process in ["first", "second"] {
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("expansions-{process}.rs"));
        let this = env::current_exe().expect("the path of this test");
        let mut other = Command::new(this);
        other.args(["--exact", "the_other_process", "--include-ignored"]).env(FILE, &file);
        let output = other.output().expect("a second process");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
        let there = fs::read_to_string(&file).expect("the expansions of the other process");
        let line = here.lines().zip(there.lines()).position(|(here, there)| here != there);
        assert_eq!(line, None, "the chart in this line of the {process} process has another expansion");
        assert_eq!(here.len(), there.len());
        fs::remove_file(&file).expect("the file of the other process");
    }
}

/// Not a test of its own: the body of the processes that the test above starts.
#[test]
#[ignore = "started by the other test"]
fn the_other_process() {
    if let Some(file) = env::var_os(FILE) {
        fs::write(file, expansions()).expect("a file to write to");
    }
}

/// One line a chart: the seeds, all charts of `tests/conformance` and `tests/ui`, broken ones too, and one with many names.
fn expansions() -> String {
    let mut files = vec![PathBuf::from("examples/charts/motor.rs"), PathBuf::from("examples/charts/line24v.rs")];
    for group in fs::read_dir("tests/ui").expect("the folder of charts") {
        let group = fs::read_dir(group.expect("a group").path()).expect("a folder of charts");
        files.extend(group.map(|file| file.expect("a file").path()));
    }
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    let texts = files.iter().map(|file| fs::read_to_string(file).expect("a file of charts"));
    let expansions = corpus().into_iter().chain(texts).chain([many_names()]).map(|text| expand(&text));
    expansions.collect()
}

/// The charts of the conformance corpus, each as it would stand in the source.
fn corpus() -> Vec<String> {
    let files = fs::read_dir("tests/conformance").expect("the folder of the corpus");
    let mut files: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "chart"));
    files.sort();
    let texts = files.iter().map(|file| fs::read_to_string(file).expect("a file of the corpus"));
    let chart = |text: String| text.split_once("\n---\n").map(|(chart, _)| format!("grafcet! {{ {chart}\n}}"));
    texts.map(|text| chart(text).expect("a chart and its timeline")).collect()
}

fn expand(text: &str) -> String {
    let lines =
        charts::charts(text).into_iter().map(|chart| charts::expand(chart).to_string().replace('\n', " ") + "\n");
    lines.collect()
}

/// A chart with hundreds of names of every kind, and with parallel branches, edges, times and actions.
fn many_names() -> String {
    let mut text = String::from("grafcet! { sfc Many { #![allow(grafcet::timed_contention)] clock 10ms;\n");
    for i in 0..50 {
        let _ = writeln!(text, "input i{i}, level{i}: u16; output q{i}: bool; output speed{i}: u16 = {i};");
        let _ = writeln!(text, "var v{i}: bool; param p{i}: time = {i}s; action act{i}(a: u16, b: bool);");
    }
    text.push_str("initial step Start;\n");
    for i in 0..150 {
        let n = i % 50;
        let _ = writeln!(
            text,
            "step A{i} {{ N q{n}; speed{n} = i{n}; act{n}(level{n}, v{n}); P1 v{n} = i{n} > 5; L p{n} act{n}(1, true); }}"
        );
    }
    text.push_str("Start -[true]-> (A0, A50, A100);\n");
    for i in (0..150).filter(|i| i % 50 < 49) {
        let (n, next) = (i % 50, i + 1);
        let _ = writeln!(text, "A{i} -[t{i}: rising(i{n} > 3) || p{n}/A{i} || 3s/v{n}/2s]-> A{next};");
    }
    text.push_str("(A49, A99, A149) -[level0 > 7]-> Start; } }\n");
    text
}
