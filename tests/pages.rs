//! The pages for users, beside what `cargo test --doc` and `cargo xtask first-chart` do with them.

mod charts;

use std::fs;

/// The pages whose charts are examples to follow.
const PAGES: [&str; 8] = [
    "README.md",
    "docs/cookbook.md",
    "docs/drawing.md",
    "docs/first-chart.md",
    "docs/language.md",
    "docs/porting.md",
    "docs/semantics.md",
    "docs/tool.md",
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

/// The cells of a row of the table after a heading of `docs/cost.md`.
fn measured<'p>(cost: &'p str, heading: &str, row: &str) -> Vec<&'p str> {
    let table = cost.split(&format!("\n## {heading}\n")).nth(1).expect("a heading");
    let row = table.lines().find_map(|line| line.strip_prefix(&format!("| {row} | "))).expect("a row");
    row.trim_end_matches(" |").split(" | ").map(|cell| cell.trim_matches('*')).collect()
}

#[test]
fn the_figures_of_the_readme_are_those_that_were_measured() {
    let readme = fs::read_to_string("README.md").expect("the README");
    let cost = fs::read_to_string("docs/cost.md").expect("what a chart costs");
    let table = readme.split("\n## What it costs\n").nth(1).expect("a table of costs");
    let table: Vec<&str> = table.lines().skip_while(|line| !line.starts_with("| ---")).skip(1).collect();
    let table = table.split(|line| line.is_empty()).next().expect("rows");
    assert_eq!(table.len(), OF_THE_README.len());
    for (row, chart) in table.iter().zip(OF_THE_README) {
        let (_, figures) = row.trim_matches(['|', ' ']).split_once(" | ").expect("figures");
        let shown = ["Flash", "Instructions, busy", "RAM"].map(|heading| {
            let columns = measured(&cost, heading, chart);
            let figure = |cell: &&str| cell.parse::<f64>().expect("a figure");
            let by_hand = if figure(&columns[1]) <= figure(&columns[2]) { columns[1] } else { columns[2] };
            format!("{} | {by_hand}", columns[0])
        });
        assert_eq!(figures, shown.join(" | "), "{chart}");
    }
}

/// Which charts the rows of the README's table are.
const OF_THE_README: [&str; 3] = ["chain100 sfc", "par8 sfc", "cell grafcet"];

/// What rustc says in the README is what the compiler says.
#[test]
fn the_error_of_the_readme_is_the_compilers() {
    let readme = fs::read_to_string("README.md").expect("the README");
    let chart = blocks(&readme, "rust")[0].replace("step Lift { N lift; }", "step Lift { N lower; N lift; }");
    let [chart] = &charts::charts(&chart)[..] else { panic!("one chart") };
    let code = charts::expand(chart.clone()).to_string();
    let said = code.split('"').find(|literal| literal.contains("[grafcet::")).expect("a message");
    // The table of cycles stands on lines of their own, and rustc indents them.
    let said = said.replace("\\n", "\n       ");
    assert!(readme.contains(&format!("```text\nerror: {said}\n")), "{said}");
}
