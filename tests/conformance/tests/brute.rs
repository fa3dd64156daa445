//! The checker against brute force, on a few hundred small random charts; `cargo xtask brute` takes thousands.

use std::fmt::Write as _;

use grafcet_conformance::brute::make;
use grafcet_conformance::brute::run::{self, Kind, Outcome, number};

/// Each chart of a kind, and all differences at once. So many of them have to be compared exactly, so that the test is one.
fn agree(kind: Kind, exactly: usize) {
    let (mut differences, mut exact, mut claims) = (String::new(), 0, [0; 3]);
    for index in 0..150 {
        let (text, outcome) = number(index, kind).expect("a chart that the interpreter understands");
        let Outcome::Compared(comparison) = outcome else { continue };
        exact += usize::from(comparison.exact);
        claims.iter_mut().zip(comparison.claims).for_each(|(all, own)| *all += own);
        for difference in comparison.differences {
            _ = writeln!(differences, "chart {index}: {}: {}\n{text}", difference.kind, difference.text);
        }
    }
    assert!(differences.is_empty(), "{differences}\n`cargo xtask brute` makes them smaller");
    assert!(exact >= exactly, "only {exact} charts were compared exactly");
    let [proved, broken, _] = claims;
    assert!(proved >= 30 && broken >= 30, "only {proved} properties were proved, and {broken} broken");
}

const FAST: usize = 1500;

#[test]
fn sfc() {
    agree(Kind { grafcet: false, timed: false, cycles: FAST }, 80);
}

#[test]
fn grafcet() {
    agree(Kind { grafcet: true, timed: false, cycles: FAST }, 60);
}

#[test]
fn sfc_with_times() {
    agree(Kind { grafcet: false, timed: true, cycles: FAST }, 0);
}

#[test]
fn grafcet_with_times() {
    agree(Kind { grafcet: true, timed: true, cycles: FAST }, 0);
}

/// Both say the same of a chart that once made a difference, and everything in it is looked at.
fn agree_on(head: &str, chart: &str) {
    let text = format!("{head} {{\n{}\n{chart}\n}}\n", make::allowed());
    let Outcome::Compared(comparison) = run::chart(&text, 20_000).expect("understood") else { panic!("{text}") };
    assert!(comparison.exact, "{text}");
    assert_eq!(comparison.differences, []);
}

/// What is entered by a step that is left and entered at once is left in the next evolution, whatever clears there.
#[test]
fn an_enclosure_after_two_transitions_at_once() {
    let chart = "input a, c: bool; initial step S1; initial step S2; step S3; \
                 enclosing step S5 { partial G { linked step S6; step S7; S6 -[true]-> S7; } } \
                 S1 -[c]-> S3 -[a]-> S5; S2 -[a]-> S1;";
    agree_on("grafcet C", chart);
}

/// From `(S2, S4)` the `any` leads to `S4`, which is active: that is what it says, and no step is unsafe by it. The shortest way
/// that makes `S4` unsafe is a longer one.
#[test]
fn an_active_target_of_an_any() {
    let chart = "input b, e: bool; input level: u8; initial step S1; step S2; step S4; \
                 S1 -[b]-> (S4, S2); S4 -[e]-> S2; S2 -[e]-> S1; any except S4 -[level > 200]-> S4;";
    agree_on("sfc C", chart);
}

/// `S1 -> S4 -> S5 -> S1` turns whenever `d` is held. With all that the inputs can do beside, in searches that turn until their
/// bound, the situations after these are more than the budget is enough for; the circle is found all the same.
#[test]
fn a_circle_in_a_chart_that_is_not_explored_to_its_end() {
    let chart = "input a, c, d, e: bool; input level: u8; var v0: bool; \
                 initial step S1; step S3; step S4; step S5; step S6; step S7; step S8 { on rising(c) v0 = a; } \
                 S1 -[level != 0]-> S3; S1 -[d]-> S4; S4 -[true]-> S5; S5 -[a]-> S7; S5 -[d]-> S8; S1 -[e]-> S6; \
                 S5 -[d]-> S1; any -[v0]-> S1;";
    agree_on("grafcet C", chart);
}

/// While `a` is held all three of `S8 -> S9 -> S10` turn, and what encloses them is left and entered again in each evolution: many
/// different turns, more than the budget for situations is enough for.
#[test]
fn circles_in_an_enclosure_that_turns_itself() {
    let chart = "input a, b, c, d, e: bool; initial step S1; initial step S7; step S4; final step S5; step S6; \
                 enclosing step S2 { partial G1 { linked step S8; step S9; step S10; S8 -[a]-> S9 -[a]-> S10 -[a]-> S8; } } \
                 S6 -[d]-> S2; S2 -[a]-> S7; S1 -[c]-> (S4, S6); S7 -[a]-> (S7, S2); S7 -[b]-> S6; S6 -[rising(e)]-> S5;";
    agree_on("grafcet C", chart);
}

/// The verdicts of brute force on charts that were thought through by hand.
mod by_hand {
    use std::collections::BTreeSet;

    use grafcet_conformance::brute::graph::Graph;
    use grafcet_conformance::brute::make::allowed;
    use grafcet_conformance::brute::resolve;
    use grafcet_conformance::brute::verdicts::Verdicts;

    /// The names of unreachable and unsafe steps, of the steps of deadlocks, and of those that wait for ever.
    fn verdicts(dialect: &str, chart: &str) -> [String; 4] {
        let allow = allowed();
        let model = resolve(&format!("{dialect} C {{ {allow} input a, b: bool; {chart} }}")).expect("a chart");
        let graph = Graph::of(&model, 10_000).expect("understood").expect("small");
        let verdicts = Verdicts::of(&model, &graph);
        let names = |steps: BTreeSet<_>| {
            steps.into_iter().map(|id| model.steps[id].name.to_string()).collect::<Vec<_>>().join(" ")
        };
        let unreachable = model.steps.ids().filter(|id| !verdicts.reachable.contains(id)).collect();
        let dead = verdicts.deadlocks.iter().flat_map(|(_, steps)| steps.iter().copied()).collect();
        let stuck = verdicts.stuck.iter().map(|(_, step)| *step).collect();
        [names(unreachable), names(verdicts.unsafe_steps.clone()), names(dead), names(stuck)]
    }

    #[test]
    fn a_sound_parallel_branch() {
        let chart = "initial step A; step B; step C; A -[a]-> (B, C); (B, C) -[b]-> A;";
        assert_eq!(verdicts("sfc", chart), ["", "", "", ""]);
        assert_eq!(verdicts("grafcet", chart), ["", "", "", ""]);
    }

    #[test]
    fn branches_that_come_together_one_by_one() {
        let chart = "initial step A; step B; step C; A -[a]-> (B, C); B -[b]-> A; C -[a && b]-> A;";
        // B leads back to A, A starts C again while it is active, and C leads to A while it is active.
        assert_eq!(verdicts("sfc", chart), ["", "A B C", "", ""]);
    }

    #[test]
    fn a_convergence_after_a_selection() {
        let chart = "initial step A; step B; step C; A -[a]-> B; A -[!a]-> C; (B, C) -[b]-> A;";
        assert_eq!(verdicts("sfc", chart), ["", "", "B C", "B C"]);
    }

    #[test]
    fn a_final_step_is_no_deadlock() {
        let chart = "initial step A; step B; final step C; A -[a]-> B; A -[b && !a]-> C;";
        assert_eq!(verdicts("sfc", chart), ["", "", "B", ""]);
    }

    #[test]
    fn a_condition_that_cannot_hold_there() {
        let chart = "initial step A; step B; step C; A -[a]-> B -[A.X]-> C -[b]-> A;";
        assert_eq!(verdicts("sfc", chart), ["C", "", "B", ""]);
    }

    #[test]
    fn a_transient_step_is_reachable() {
        let chart = "initial step A; step B; step C; A -[a]-> B -[true]-> C -[!a]-> A;";
        assert_eq!(verdicts("grafcet", chart), ["", "", "", ""]);
    }

    #[test]
    fn both_branches_of_a_grafcet_clear() {
        let chart = "initial step A; step B; step C; A -[a]-> B -[!a]-> A; A -[a]-> C -[!a && b]-> A;";
        assert_eq!(verdicts("grafcet", chart), ["", "A C", "", ""]);
        assert_eq!(verdicts("sfc", chart), ["C", "", "", ""]);
    }
}
