//! Lint levels decide what is said, and nothing else: the code is the same with each of them.

use std::fs;
use std::path::{Path, PathBuf};

use grafcet_compiler::diagnostic::rules;
use proc_macro2::TokenStream;
use quote::quote;

/// What a chart expands to, as text, with this line at its beginning.
fn expanded(chart: &str, line: &str) -> String {
    let (head, body) = chart.split_once('{').expect("a chart");
    let chart: TokenStream = format!("{head} {{ {line} {body}").parse().expect("tokens");
    grafcet_compiler::compile(&quote!(::grafcet), chart).to_string()
}

/// The charts in the macro calls of a file.
fn charts(path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).expect("a file");
    let mut charts = Vec::new();
    let mut rest = &text[..];
    while let Some(at) = rest.find("grafcet! {") {
        let start = at + "grafcet! {".len();
        let mut depth = 1;
        let end = rest[start..].char_indices().find_map(|(index, c)| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            (depth == 0).then_some(start + index)
        });
        let end = end.unwrap_or(rest.len());
        charts.push(rest[start..end].trim().to_owned());
        rest = &rest[end..];
    }
    charts
}

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    files.retain(|path| path.extension().is_some_and(|is| is == "rs"));
    files.sort();
    files
}

/// The warnings at the beginning may differ; all items after them are the same.
fn same(one: &str, other: &str) -> bool {
    let (long, short) = if one.len() > other.len() { (one, other) } else { (other, one) };
    long.ends_with(short)
}

/// The rules that a chart may set to this level.
fn settable(level: &str) -> impl Iterator<Item = &'static str> {
    let lowers = level != "deny";
    rules::ALL.iter().filter(move |rule| rule.can_be_allowed || !lowers).map(|rule| rule.name)
}

#[test]
fn good_charts() {
    let mut count = 0;
    for chart in files("tests/good").iter().step_by(2).flat_map(|path| charts(path)) {
        let plain = expanded(&chart, "");
        for level in ["allow", "deny"] {
            let all = settable(level).map(|rule| format!("#![{level}(grafcet::{rule})]")).collect::<Vec<_>>().concat();
            // Off by default, it is about inputs that nobody may ever give.
            let all = all.replace("#![deny(grafcet::possible_instability)]", "");
            assert!(same(&plain, &expanded(&chart, &all)), "{level}: {chart}");
            count += 1;
        }
    }
    assert!(count > 20);
}

#[test]
fn each_rule() {
    let charts = [
        "pub grafcet Line { input b1, b2, b3: bool; output q1, q2: bool; initial step S1 { q1; } step S2 { S q2; } \
         step S3 { R q2; } S1 -[b1 && !b3]-> S2 -[b2]-> S3 -[b3]-> S1; }",
        // Two stored actions that race, which the chart allows.
        "pub grafcet Raced { input a, b, c: bool; output q: bool; initial step S0; step S1 { S q; } step S2; \
         #[allow(grafcet::write_race)] step S3 { R q; } step S4; S0 -[true]-> (S2, S4); S2 -[a]-> S1 -[!a]-> S2; \
         S4 -[b]-> S3 -[c]-> S4; }",
        "pub sfc Motor { input on, off: bool; output relay: bool; initial step Off; step On { N relay; } \
         Off -[on]-> On -[off]-> Off; }",
    ];
    for chart in charts {
        let plain = expanded(chart, "");
        assert!(!plain.contains("compile_error"), "{plain}");
        for level in ["allow", "warn", "deny"] {
            for rule in settable(level) {
                let other = expanded(chart, &format!("#![{level}(grafcet::{rule})]"));
                // Where somebody wants to know about inputs that may never be given, there is an error.
                let refused = rule == "possible_instability" && other.contains("compile_error");
                assert!(refused || same(&plain, &other), "{level}({rule}): {chart}");
            }
        }
    }
}

#[test]
fn races_keep_their_order_however_they_are_allowed() {
    let raced = |chart: &str, step: &str| {
        format!(
            "pub grafcet Raced {{ {chart} input a, b: bool; output q: bool; initial step S0; step S1 {{ S q; }} step S2; \
             {step} step S3 {{ R q; }} step S4; S0 -[true]-> (S2, S4); S2 -[a]-> S1 -[!a]-> S2; S4 -[b]-> S3 -[!b]-> S4; }}"
        )
    };
    let plain = expanded(&raced("#![allow(grafcet::write_race)]", ""), "");
    assert!(!plain.contains("compile_error"), "{plain}");
    for other in [raced("#![warn(grafcet::write_race)]", ""), raced("", "#[allow(grafcet::write_race)]")] {
        assert!(same(&plain, &expanded(&other, "")));
    }
    // Both are written after the evolution, in the order of the source: the one that resets last.
    let last = |text: &str| plain.rfind(text).unwrap_or_else(|| panic!("{text}: {plain}"));
    assert!(last("q_ = true") < last("q_ = false"), "{plain}");
}
