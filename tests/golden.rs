//! What the two charts of the source documents and one full chart per dialect expand to, as a reader would like to see it.
//!
//! A change of the code generator shows as a change of `tests/golden/*.rs`. `cargo xtask bless` records them anew; the test
//! `expansion` compiles and runs what is recorded.

mod charts;

use std::fs;

/// The files with charts, and what the expansions of their charts are called.
const FILES: &[(&str, &[&str])] = &[
    ("examples/charts/motor.rs", &["motor"]),
    ("examples/charts/line24v.rs", &["line24v"]),
    ("tests/full.rs", &["batch", "cell", "stations"]),
];

#[test]
fn expansions_are_as_recorded() {
    for (file, names) in FILES {
        let rust = fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        let charts = charts::charts(&rust);
        assert_eq!(charts.len(), names.len(), "the charts of {file}");
        for (chart, name) in charts.into_iter().zip(*names) {
            let expansion = syn::parse2(charts::expand(chart)).expect("an expansion is a list of items");
            compare(&format!("tests/golden/{name}.rs"), &prettyplease::unparse(&expansion));
        }
    }
}

/// Compares with the file, or writes it where `BLESS=1` is set.
fn compare(path: &str, now: &str) {
    let now = format!("// Recorded by `cargo xtask bless`.\n\n{now}");
    if std::env::var_os("BLESS").is_some_and(|bless| bless == "1") {
        return fs::write(path, now).unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    let recorded = fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}; run `cargo xtask bless`"));
    let different = recorded.lines().zip(now.lines()).enumerate().find(|(_, (before, now))| before != now);
    if let Some((line, (before, now))) = different {
        panic!("{path}:{}: was\n{before}\nand is\n{now}\nIf that is meant, run `cargo xtask bless`", line + 1);
    }
    assert_eq!(recorded.lines().count(), now.lines().count(), "{path} has another length; `cargo xtask bless`?");
}
