//! What the cookbook shows of whole programs stands in these programs, word for word: there it is compiled and run.

use std::fs;

/// Blocks marked `rs` are no tests of rustdoc: they name what only the program has.
const PROGRAMS: [&str; 2] = ["examples/rtic/src/main.rs", "examples/embassy/src/main.rs"];

/// Without the indentation, which is that of the place where the lines stand.
fn lines(code: &str) -> Vec<&str> {
    code.lines().map(str::trim).filter(|line| !line.is_empty()).collect()
}

#[test]
fn what_is_shown_of_the_programs_stands_in_them() {
    let page = fs::read_to_string("docs/cookbook.md").expect("the cookbook");
    let shown: Vec<&str> = page.split("\n```rs\n").skip(1).filter_map(|rest| rest.split("\n```").next()).collect();
    assert_eq!(shown.len(), PROGRAMS.len(), "one block for each program");
    for (shown, program) in shown.into_iter().zip(PROGRAMS) {
        let code = fs::read_to_string(program).expect("a program");
        let (code, shown) = (lines(&code), lines(shown));
        assert!(code.windows(shown.len()).any(|part| part == shown), "{program} does not hold:\n{shown:#?}");
    }
}
