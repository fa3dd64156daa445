//! Charts with more situations than can be explored: twenty parallel branches have 3 × 10¹⁵. What is wrong with the drawing
//! is found all the same, and nothing is said about the good ones.

mod judged;

use std::fmt::Write;

use judged::{expanded, rules};

const BRANCHES: usize = 20;
const STEPS: usize = 5;

/// Parallel branches; `more` is added, and `without` left out.
fn branches(dialect: &str, inputs: usize, more: &str, without: &str) -> String {
    let names = |letter: &str, count: usize| {
        let names: Vec<String> = (0..count).map(|number| format!("{letter}{number}")).collect();
        names.join(", ")
    };
    let mut body = String::from("initial step Start; step End;\n");
    let (mut first, mut last) = (Vec::new(), Vec::new());
    for branch in 0..BRANCHES {
        for number in 0..STEPS {
            _ = writeln!(body, "step S{branch}_{number};");
            if number + 1 < STEPS {
                let input = (branch * STEPS + number) % inputs;
                _ = writeln!(body, "S{branch}_{number} -[i{input}]-> S{branch}_{};", number + 1);
            }
        }
        first.push(format!("S{branch}_0"));
        last.push(format!("S{branch}_{}", STEPS - 1));
    }
    _ = writeln!(body, "Start -[go]-> ({}); ({}) -[true]-> End;", first.join(", "), last.join(", "));
    assert!(without.is_empty() || body.contains(without), "{without}");
    let body = body.replacen(without, "", usize::from(!without.is_empty()));
    format!(
        "{dialect} Chart {{ #![allow(grafcet::unused_input, grafcet::overlapping_branches)]
         input go, other: bool; input {}: bool; {body} End -[!go]-> Start; {more} }}",
        names("i", inputs)
    )
}

/// In both dialects, with inputs of their own and with few that the branches share.
fn all_say(more: &str, without: &str, expected: &[&str]) {
    for dialect in ["sfc", "grafcet"] {
        for inputs in [BRANCHES * STEPS, 12] {
            let said = rules(&branches(dialect, inputs, more, without));
            assert_eq!(said, expected, "{dialect}, {inputs} inputs, {more}, without {without}");
        }
    }
}

#[test]
fn nothing_is_said_about_good_branches() {
    all_say("", "", &[]);
}

#[test]
fn a_way_back_is_proved_by_reduction() {
    all_say("home Start;", "", &[]);
    all_say("step Trap; S7_2 -[other]-> Trap; home Start;", "", &["property_undecided", "stuck_join"]);
}

#[test]
fn a_branch_that_is_left_by_a_jump() {
    all_say("S3_2 -[other]-> End;", "", &["unsafe_step"]);
}

#[test]
fn a_branch_that_nothing_joins() {
    all_say("", ", S7_4", &["unsafe_step"]);
}

#[test]
fn a_branch_that_ends_in_a_trap() {
    all_say("step Trap; S7_2 -[other]-> Trap;", "", &["stuck_join"]);
}

/// Serde derives for arrays of up to 32 bytes only: the chart's message comes before rustc's, which does not name the encoding.
#[test]
fn flags_of_more_than_32_bytes_do_not_go_with_serde() {
    let marked = |steps: usize, derives: &str, encoding: &str| {
        let (mut names, mut chain) = (String::new(), String::from("S0"));
        for number in 1..steps {
            _ = write!(names, "step S{number}; ");
            _ = write!(chain, " -[a]-> S{number}");
        }
        let chart =
            format!("{derives} sfc Long {{ input a: bool; {encoding} initial step S0; {names} {chain} -[a]-> S0; }}");
        let code = expanded(&chart);
        code.matches("go together with serde").count()
    };
    let both = "#[derive(serde::Serialize)] #[cfg_attr(feature = \"store\", derive(Hash, Serialize, Deserialize))]";
    assert_eq!(marked(255, both, "encoding flags;"), 2);
    assert_eq!(marked(255, "#[derive(Deserialize)]", "encoding flags;"), 0);
    assert_eq!(marked(254, both, "encoding flags;"), 0);
    assert_eq!(marked(255, both, ""), 0);
    assert_eq!(marked(255, "#[derive(Hash, rkyv::Serialize)]", "encoding flags;"), 0);
}
