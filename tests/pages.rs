//! The pages for users, beside what `cargo test --doc` and `cargo xtask first-chart` do with them.

mod charts;

use std::fs;

/// The pages whose charts are examples to follow.
const PAGES: [&str; 7] = [
    "README.md",
    "docs/cookbook.md",
    "docs/drawing.md",
    "docs/first-chart.md",
    "docs/language.md",
    "docs/porting.md",
    "docs/semantics.md",
];

/// The blocks of a page in that language, with the lines that rustdoc hides.
fn blocks<'p>(page: &'p str, language: &str) -> Vec<&'p str> {
    let begin = format!("\n```{language}\n");
    page.split(&begin).skip(1).filter_map(|rest| rest.split("\n```").next()).collect()
}

/// Not even a warning, which a test of rustdoc does not show.
#[test]
fn nothing_is_said_about_the_charts_of_the_pages() {
    for name in PAGES {
        let page = fs::read_to_string(name).expect("a page");
        let visible = |line: &str| line.strip_prefix("# ").unwrap_or(line).to_owned() + "\n";
        let code: Vec<String> =
            blocks(&page, "rust").iter().map(|block| block.lines().map(visible).collect()).collect();
        let charts: Vec<_> = code.iter().flat_map(|block| charts::charts(block)).collect();
        assert!(!charts.is_empty(), "{name} has no chart");
        for chart in charts {
            let text = chart.to_string();
            let code = charts::expand(chart).to_string();
            let said = code.split('"').find(|literal| literal.contains("[grafcet::"));
            assert_eq!(said, None, "{name}: {text}");
        }
    }
}

/// Blocks marked `rs` are no tests of rustdoc: they name what only the program has.
const PROGRAMS: [&str; 2] = ["examples/rtic/src/main.rs", "examples/embassy/src/main.rs"];

/// Without the indentation, which is that of the place where the lines stand.
fn lines(code: &str) -> Vec<&str> {
    code.lines().map(str::trim).filter(|line| !line.is_empty()).collect()
}

#[test]
fn what_is_shown_of_the_programs_stands_in_them() {
    let page = fs::read_to_string("docs/cookbook.md").expect("the cookbook");
    let shown: Vec<&str> = blocks(&page, "rs");
    assert_eq!(shown.len(), PROGRAMS.len(), "one block for each program");
    for (shown, program) in shown.into_iter().zip(PROGRAMS) {
        let code = fs::read_to_string(program).expect("a program");
        let (code, shown) = (lines(&code), lines(shown));
        assert!(code.windows(shown.len()).any(|part| part == shown), "{program} does not hold:\n{shown:#?}");
    }
}
