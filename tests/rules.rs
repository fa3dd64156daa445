//! Every rule of the checker has its entry in `docs/rules.md`, its failing chart and a neighbour that compiles; and there is
//! none of these for a rule that does not exist.

mod charts;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use grafcet_compiler::ast::{Dialect, Severity};
use grafcet_compiler::diagnostic::rules::{ALL, Rule};

/// The folders of `tests/ui` whose files are named after rules.
const GROUPS: &[&str] = &["drawing", "evolution", "actions", "conditions", "structure", "properties"];

/// What the compiler makes of the charts in a piece of Rust.
fn expansions(rust: &str) -> Vec<String> {
    charts::charts(rust).into_iter().map(|chart| charts::expand(chart).to_string()).collect()
}

/// Asserts that a chart of `rust` breaks the rule.
fn breaks(rule: &str, rust: &str, place: &str) {
    let said = format!("[grafcet::{rule}]");
    assert!(expansions(rust).iter().any(|code| code.contains(&said)), "{place}: no chart breaks `{rule}`");
}

/// Asserts that there are charts in `rust` and that nothing is wrong with them.
fn is_right(rust: &str, place: &str) {
    let expansions = expansions(rust);
    assert!(!expansions.is_empty(), "{place}: there is no chart");
    for code in expansions {
        let said = ["compile_error", "[grafcet::"].iter().find_map(|word| code.find(word));
        let said = said.map(|at| code[..at].chars().rev().take(300).collect::<Vec<_>>().into_iter().rev().collect());
        assert_eq!(said, None::<String>, "{place}");
    }
}

#[test]
fn every_rule_has_its_failing_chart_and_its_neighbour() {
    let mut stems = BTreeSet::new();
    for group in GROUPS {
        for file in fs::read_dir(Path::new("tests/ui").join(group)).expect("a folder of charts") {
            let name = file.expect("a file").file_name().into_string().expect("a name in UTF-8");
            let stem = name.split('.').next().unwrap_or_default();
            assert!(ALL.iter().any(|rule| rule.name == stem), "tests/ui/{group}/{name} belongs to no rule");
            stems.insert(format!("{group}/{stem}"));
        }
    }
    for rule in ALL {
        let own: Vec<_> = stems.iter().filter(|stem| stem.ends_with(&format!("/{}", rule.name))).collect();
        let [stem] = own[..] else { panic!("rule `{}` has {} charts in tests/ui", rule.name, own.len()) };
        let read = |extension: &str| {
            let place = format!("tests/ui/{stem}.{extension}");
            let text = fs::read_to_string(&place).unwrap_or_else(|error| panic!("{place}: {error}"));
            (text, place)
        };
        let (chart, place) = read("rs");
        breaks(rule.name, &chart, &place);
        let (messages, place) = read("stderr");
        assert!(messages.contains(&format!("[grafcet::{}]", rule.name)), "{place} does not show `{}`", rule.name);
        let (neighbour, place) = read("neighbour.rs");
        is_right(&neighbour, &place);
        assert!(alike(&chart, &neighbour), "{place} has little in common with the chart it stands beside");
    }
}

/// The level of a rule as its entry begins.
fn levels(rule: &Rule) -> String {
    let level = |dialect: Dialect| match rule.default_in(dialect) {
        Severity::Deny if !rule.can_be_allowed => "error",
        Severity::Deny => "deny",
        Severity::Warn => "warn",
        Severity::Allow => "allow",
    };
    let (grafcet, sfc) = (level(Dialect::Grafcet), level(Dialect::Sfc));
    if grafcet == sfc { grafcet.to_owned() } else { format!("{grafcet} in `grafcet`, {sfc} in `sfc`") }
}

#[test]
fn every_neighbour_is_compiled() {
    let list = fs::read_to_string("tests/neighbours.rs").expect("the list of neighbours");
    for group in fs::read_dir("tests/ui").expect("the folder of charts") {
        let group = group.expect("a group");
        let line = format!("    {}:", group.file_name().to_string_lossy());
        let listed = list.split(&line).nth(1).and_then(|rest| rest.split(';').next()).unwrap_or_default();
        let listed: Vec<_> = listed.split(',').map(str::trim).collect();
        for file in fs::read_dir(group.path()).expect("a folder of charts") {
            let name = file.expect("a file").file_name().into_string().expect("a name in UTF-8");
            if let Some(chart) = name.strip_suffix(".neighbour.rs") {
                assert!(listed.contains(&chart), "{name} is not compiled: name it in tests/neighbours.rs");
            }
        }
    }
}

/// Whether most lines of the shorter text stand in the other, too.
fn alike(a: &str, b: &str) -> bool {
    let lines = |text: &str| text.lines().map(str::trim).filter(|line| line.len() > 1).map(str::to_owned).collect();
    let (a, b): (BTreeSet<String>, BTreeSet<String>) = (lines(a), lines(b));
    2 * a.intersection(&b).count() > a.len().min(b.len())
}

#[test]
fn every_rule_has_its_entry() {
    let page = fs::read_to_string("docs/rules.md").expect("the page of rules");
    let mut entries = Vec::new();
    for entry in page.split("\n### ").skip(1) {
        let name = entry.split('`').nth(1).expect("the name of a rule in the heading");
        entries.push(name);
        let blocks: Vec<_> = entry.split("\n```").collect();
        let [text, broken, _, mended, _] = blocks[..] else {
            panic!("`{name}` does not have two charts, one that breaks it and one that is mended")
        };
        let (broken, mended) = (broken.trim_start_matches("rust"), mended.trim_start_matches("rust"));
        breaks(name, broken, "docs/rules.md");
        is_right(mended, &format!("the mended chart of `{name}` in docs/rules.md"));
        let source = text.split("\nSource: ").nth(1).unwrap_or_default();
        assert!(source.trim().len() > 3, "`{name}` does not say where it comes from");
        let level = text.lines().nth(2).unwrap_or_default();
        let rule = ALL.iter().find(|rule| rule.name == name);
        assert!(rule.is_none_or(|rule| level.starts_with(&levels(rule))), "`{name}` has another level");
    }
    entries.sort_unstable();
    let mut rules: Vec<_> = ALL.iter().map(|rule| rule.name).collect();
    rules.sort_unstable();
    assert_eq!(entries, rules, "the entries of the page on the left, the rules of the checker on the right");
}
