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

/// From each of its three hundred steps all inputs let the ring turn until the bound stops it: that is followed once.
#[test]
fn a_ring_that_its_inputs_let_turn_is_explored_whole() {
    let mut body = String::from("initial step S0 { S lamp; } step S1 { R lamp; }\n");
    for step in 0..300 {
        if step > 1 {
            _ = writeln!(body, "step S{step};");
        }
        _ = writeln!(body, "S{step} -[i{}]-> S{};", step % 16, (step + 1) % 300);
    }
    let inputs: Vec<String> = (0..16).map(|input| format!("i{input}")).collect();
    let chart = |claim: &str| {
        format!("grafcet Chart {{ input {}: bool; output lamp: bool; {body} {claim} }}", inputs.join(", "))
    };
    assert_eq!(rules(&chart("never S9.X && lamp; home S0;")), [] as [&str; 0]);
    assert_eq!(rules(&chart("never S0.X && lamp; home S0;")), ["property_violated"]);
}

/// The ring gives `n` a new value in each turn, so that another way may be taken in each: the turns are not alike.
#[test]
fn a_ring_in_which_something_is_forgotten_is_followed() {
    let mut body = String::from("initial step Idle; step A0 { P1 n = level; } step Other;\n");
    for step in 0..12 {
        if step > 0 {
            _ = writeln!(body, "step A{step};");
        }
        let condition = if step == 10 { "n > 5" } else { "true" };
        _ = writeln!(body, "A{step} -[{condition}]-> A{};", (step + 1) % 12);
    }
    let chart = format!(
        "grafcet Chart {{ max_evolutions 36; input level: u16; input go: bool; var n: u16 = 9; {body}
         Idle -[n > 5]-> A1; A10 -[n <= 5]-> Other; Other -[go]-> Idle; never Other.X; }}"
    );
    assert_eq!(rules(&chart), ["property_undecided"]);
}

/// A search that is stopped after twelve evolutions has cleared as many transitions, wherever it was in its turn then.
#[test]
fn a_way_through_a_turn_has_what_clears_and_no_more() {
    let said = judged::said(
        "grafcet Chart { input x, y: bool; initial step Idle; step Pa; step Qu; step Pb; step Pc;
         Idle -[x]-> (Pa, Qu); Pa -[x]-> (Qu, Pb); Pb -[x]-> Pc; Pc -[x]-> Pa; Qu -[y]-> Idle; }",
    );
    let way = said
        .iter()
        .flat_map(|one| one.lines())
        .find(|line| line.contains("x, !y"))
        .expect("a way to where Qu is activated again");
    assert_eq!(way.matches('→').count(), 12, "{way}");
    assert!(way.contains("Pb → Pc | (Qu, Pc)"), "{way}");
}
