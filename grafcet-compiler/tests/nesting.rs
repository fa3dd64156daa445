//! Well-nested charts are decided by reduction: which are, how many situations they have, and from where there is a way back.

use grafcet_compiler::analysis::Nesting;
use grafcet_compiler::diagnostic::{Severity, Sink};
use grafcet_compiler::model::{Model, StepId};
use grafcet_compiler::{model, parse};

fn resolved(dialect: &str, chart: &str) -> Model {
    let text = format!("{dialect} Chart {{ input a, b, c: bool; input level: u8; {chart} }}");
    let mut sink = Sink::new();
    let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let said = sink.finish();
    assert!(said.iter().all(|one| one.severity != Severity::Deny), "{text}: {said:?}");
    model
}

/// The situations of a chart that is well nested.
fn situations(chart: &str) -> Option<u64> {
    Nesting::of(&resolved("sfc", chart)).map(|nesting| nesting.situations())
}

fn step(model: &Model, name: &str) -> StepId {
    model.steps.iter().find(|(_, step)| step.name == name).expect("a step").0
}

/// What the structure tells of a chart: all, and the way back to `O`.
fn told(dialect: &str, chart: &str) -> (bool, bool) {
    let model = resolved(dialect, chart);
    let nesting = Nesting::of(&model).expect("well nested");
    (nesting.tells_all(&model, &[]), nesting.returns_to(&model, &[step(&model, "O")], &[]))
}

/// The same in both dialects.
fn both_tell(chart: &str, expected: (bool, bool)) {
    for dialect in ["sfc", "grafcet"] {
        assert_eq!(told(dialect, chart), expected, "{dialect} {chart}");
    }
}

#[test]
fn what_is_well_nested() {
    for (chart, expected) in [
        ("initial step O; step A; O -[a]-> A -[b]-> O;", 2),
        ("initial step O; step A; step B; O -[a]-> A -[c]-> O; O -[!a && b]-> B -[c]-> O; A -[b]-> A;", 3),
        ("initial step O; step A; step B; step C; step G; O -[a]-> (A, C); A -[b]-> B; C -[c]-> G; (B, G) -[a]-> O;", 5),
        ("initial step O; step A; step B; step C; step G; O -[a]-> (A, B) -[b]-> (C, G) -[c]-> O;", 3),
        // Two ways in, two ways out, a loop within a branch and one of the block itself.
        (
            "initial step O; step A; step B; step C; step E; O -[a]-> (A, C); O -[!a && b]-> (B, C); A -[b]-> B -[c]-> A; A -[a]-> E;
             (E, C) -[a]-> O; (E, C) -[!a && b]-> O; (E, C) -[!a && c]-> (A, C);",
            4,
        ),
        // Blocks within blocks.
        (
            "initial step O; step A; step B; step C; step G; step E; step F; O -[a]-> (A, B); A -[b]-> (C, G); (C, G) -[c]-> E; B -[c]-> F;
             (E, F) -[true]-> O;",
            7,
        ),
        ("initial step A; initial step B; step C; (A, B) -[a]-> C -[b]-> (A, B);", 2),
    ] {
        assert_eq!(situations(chart), Some(expected), "{chart}");
    }
}

#[test]
fn what_is_not() {
    for chart in [
        // A branch that is left alone, one that ends in a trap, branches that meet in different convergences.
        "initial step O; step A; step B; O -[a]-> (A, B) -[b]-> O; A -[c]-> O;",
        "initial step O; step A; step B; step C; O -[a]-> (A, B) -[b]-> O; A -[c]-> C;",
        "initial step O; step A; step B; step C; step G; O -[a]-> (A, C); A -[b]-> B; C -[c]-> G; (A, C) -[c]-> O; (B, G) -[a]-> O;",
        // A jump into a branch; two starts in one sequence; nothing that goes on; two charts in one.
        "initial step O; step A; step B; O -[a]-> (A, B) -[b]-> O; O -[c]-> A;",
        "initial step O; initial step A; O -[a]-> A -[b]-> O;",
        "initial step O; step A; O -[a]-> A;",
        "initial step O; initial step T; step A; step B; O -[a]-> A -[b]-> O; T -[a]-> B -[b]-> T;",
    ] {
        assert_eq!(situations(chart), None, "{chart}");
    }
}

#[test]
fn nothing_is_left_to_explore() {
    both_tell("initial step O; step A; step B; step C; O -[a]-> (A, B); A -[b]-> C; (C, B) -[c]-> O;", (true, true));
    both_tell("initial step O; step A; O -[rising(a)]-> A -[A.T >= 5s && level > 3]-> O;", (true, true));
}

/// Branches with the same inputs move together: not all that the structure allows happens.
#[test]
fn branches_with_common_inputs() {
    let chart =
        "initial step O; step A; step B; step C; step G; O -[a]-> (A, C); A -[b]-> B; C -[b]-> G; (B, G) -[c]-> O;";
    both_tell(chart, (false, true));
}

/// A choice that is made as soon as it can be, or after some time; nobody can wait there for ever.
#[test]
fn a_choice_in_time() {
    both_tell("initial step O; step A; step B; O -[a]-> A -[b]-> O; O -[!a && O.T >= 5s]-> B -[b]-> O;", (false, true));
    let sooner = "initial step O; step A; step B; O -[a]-> A -[b]-> O; O -[5s/O]-> B -[b]-> O;";
    assert_eq!(told("sfc", sooner), (false, true));
    // Whoever waits has gone on before: one of the first two is always true.
    let never = "initial step O; step A; step B; O -[a]-> A -[b]-> O; O -[!a && O.T < 5s]-> B -[b]-> O; O -[!a && O.T >= 5s]-> B;";
    assert_eq!(told("sfc", never), (false, false));
}

/// Who waits for too long waits for ever: nothing is proved where something has to be done in time, unless there is another
/// way for who is late.
#[test]
fn in_time() {
    both_tell("initial step O; step A; O -[a]-> A -[b && A.T < 5s]-> O;", (false, false));
    both_tell("initial step O; step A; O -[a]-> A -[b && !(5s/A)]-> O;", (false, false));
    both_tell("initial step O; step A; step B; O -[a]-> A -[b && !(5s/A)]-> O; A -[5s/A]-> B -[c]-> O;", (false, true));
    both_tell(
        "initial step O; step A; step B; O -[a]-> A -[b && 5s > A.T]-> O; A -[c && 5s <= A.T]-> B -[!a]-> O;",
        (true, true),
    );
    both_tell(
        "initial step O; step A; step B; O -[a]-> A -[b && A.T < 5s]-> O; A -[c && !b && A.T < 5s]-> B -[c]-> O;",
        (false, false),
    );
    // One of the two would have to be in time.
    both_tell(
        "initial step O; step A; step B; O -[a]-> (A, B); (A, B) -[b && A.T >= 5s && B.T < 5s]-> O;",
        (false, false),
    );
}

/// In a `grafcet` several transitions clear together, and inputs can lead on at once.
#[test]
fn what_does_not_follow_in_a_grafcet() {
    let overlapping = "initial step O; step A; step B; O -[a]-> A -[c]-> O; O -[b]-> B -[c]-> O;";
    assert_eq!((told("sfc", overlapping), told("grafcet", overlapping)), ((true, true), (false, false)));
    let passing = "initial step O; step A; O -[a]-> A -[a]-> O;";
    assert_eq!((told("sfc", passing), told("grafcet", passing)), ((true, true), (false, false)));
}

/// Inputs can lead on at once for several steps: after the convergence every round comes past `O` with `b` and `c`.
#[test]
fn passing_through_a_home_step() {
    let chart = "initial step H; step O; step A; step B; step C; step E; step F; step G; H -[b]-> O -[c]-> (A, B); \
                 A -[a]-> (C, E); (C, E) -[!c]-> F; (F, B) -[b && c]-> G -[true]-> H;";
    assert_eq!((told("sfc", chart).1, told("grafcet", chart).1), (true, false));
    let waits = chart.replace("G -[true]", "G -[!b]");
    assert!(told("grafcet", &waits).1);
}

/// Values that actions write, other steps and Rust that is not looked into are left to the exploration.
#[test]
fn conditions_that_are_not_about_inputs() {
    both_tell("var done: bool; initial step O { P1 done = true; } step A; O -[done]-> A -[a]-> O;", (false, false));
    both_tell("initial step O; step A; O -[a]-> A -[level.count_ones() > 3]-> O;", (false, false));
}
