//! What runs have covered.

use grafcet_sim::{Chart, Coverage, Missing, Simulation, Trace, Value, assert_covered, script};

const SOURCE: &str = "sfc C {
    input a, b: bool;
    initial step A;
    step B;
    A -[a && !b]-> B;
    B -[!a]-> A;
}";

/// What is missing after cycles with these inputs.
fn missing(inputs: &[(bool, bool)]) -> Vec<String> {
    let chart = Chart::parse(SOURCE).expect("a chart");
    let mut run = Simulation::new(&chart).expect("understood");
    for (a, b) in inputs {
        run.cycle(0, &[("a", (*a).into()), ("b", (*b).into())]).expect("understood");
    }
    run.coverage().missing().iter().map(ToString::to_string).collect()
}

#[test]
fn nothing_ran() {
    let all = missing(&[]);
    assert_eq!(all.len(), 2 + 2 + 6, "{all:?}");
    assert_eq!(all[0], "step `A` was never active");
}

#[test]
fn a_part_has_to_decide_as_both() {
    let decided = "never decided as";
    // The first cycle asks nothing.
    let first = [(false, false)];
    let parts = |inputs: &[(bool, bool)]| -> Vec<String> {
        let of_a = missing(&[&first, inputs].concat());
        of_a.into_iter().filter(|line| line.contains(decided) && line.contains("A → B")).collect()
    };
    assert_eq!(parts(&[]).len(), 4);
    // Both parts are against it: neither decides.
    assert_eq!(parts(&[(false, true)]).len(), 4);
    assert_eq!(parts(&[(false, false)]).len(), 3);
    let left = parts(&[(false, false), (true, true)]);
    assert_eq!(
        left,
        [
            "`a` never decided as true in the condition of `A → B`",
            "`b` never decided as false in the condition of `A → B`"
        ]
    );
    assert!(parts(&[(false, false), (true, true), (true, false)]).is_empty());
    let all = [(false, false), (false, false), (true, true), (true, false), (true, false), (false, false)];
    assert!(missing(&all).is_empty());
}

#[test]
fn a_file_for_tools() {
    let chart = Chart::parse(SOURCE).expect("a chart");
    let mut run = Simulation::new(&chart).expect("understood");
    let cycles = [(false, false), (true, false)].map(|(a, b)| (0, vec![("a", Value::Bool(a)), ("b", Value::Bool(b))]));
    let trace = Trace::run(&mut run, cycles).expect("understood");
    let expected = "TN:C
SF:src/main.rs
FN:3,A
FN:4,B
FNDA:1,A
FNDA:1,B
FNF:2
FNH:2
BRDA:5,0,0,1
BRDA:5,0,1,0
BRDA:5,0,2,0
BRDA:5,0,3,1
BRDA:6,1,0,-
BRDA:6,1,1,-
BRF:6
BRH:2
DA:3,1
DA:4,1
DA:5,1
DA:6,0
LF:4
LH:3
end_of_record
";
    assert_eq!(trace.coverage.lcov("src/main.rs"), expected);
    let text = trace.coverage.to_string();
    assert!(text.starts_with("C: 2 of 2 steps active, 1 of 2 transitions cleared, 2 of 6 decisions"), "{text}");
    assert!(trace.coverage.missing().contains(&Missing::Transition("B → A".to_owned())));
}

#[test]
fn runs_add_up() {
    let chart = Chart::parse(SOURCE).expect("a chart");
    let run = |inputs: &[(bool, bool)]| {
        let mut run = Simulation::new(&chart).expect("understood");
        let cycles = inputs.iter().map(|(a, b)| (0, vec![("a", Value::Bool(*a)), ("b", Value::Bool(*b))]));
        Trace::run(&mut run, cycles).expect("understood").coverage
    };
    let mut all = run(&[(false, false), (false, false), (true, true), (true, false)]);
    all.assert_covered(&[
        "transition `B → A`",
        "`a` never decided as true in the condition of `B",
        "`a` never decided as false in the condition of `B",
    ]);
    all.add(&run(&[(false, false), (true, false), (true, false), (false, false)]));
    all.assert_covered(&[]);
}

#[test]
#[should_panic(expected = "not covered of C:\n  transition `B → A` never cleared")]
fn what_is_missing_ends_a_test() {
    let chart = Chart::parse(SOURCE).expect("a chart");
    let mut run = Simulation::new(&chart).expect("understood");
    for (a, b) in [(false, false), (false, false), (true, true), (true, false), (true, false)] {
        run.cycle(0, &[("a", a.into()), ("b", b.into())]).expect("understood");
    }
    run.coverage().assert_covered(&["`a` never decided as false in the condition of `B"]);
}

#[test]
#[should_panic(expected = "excepted, but covered of C: step `A`")]
fn an_exception_that_is_none_ends_a_test() {
    let chart = Chart::parse("sfc C { input a: bool; initial step A; A -[a]-> A; }").expect("a chart");
    let mut run = Simulation::new(&chart).expect("understood");
    for a in [false, false, true] {
        run.cycle(0, &[("a", a.into())]).expect("understood");
    }
    run.coverage().assert_covered(&["step `A`"]);
}

#[test]
fn one_can_ask_for_less() {
    let chart = Chart::parse(SOURCE).expect("a chart");
    let mut run = Simulation::new(&chart).expect("understood");
    for (a, b) in [(false, false), (false, false), (true, true), (true, false)] {
        run.cycle(0, &[("a", a.into()), ("b", b.into())]).expect("understood");
    }
    assert_covered!(run.coverage(), steps);
    assert_covered!(&run.coverage(), transitions; except "transition `B → A`");
    let coverage = run.coverage();
    assert_covered!(coverage, steps, transitions; except "transition `B → A` never cleared");
    assert_covered!(coverage, conditions; except "`a` never decided as true in the condition of `B", "`a` never decided as false in the condition of `B");
}

#[test]
#[should_panic(expected = "not covered of C:\n  transition `B → A` never cleared")]
fn a_list_tells_what_was_not_covered() {
    let chart = Chart::parse(SOURCE).expect("a chart");
    let mut run = Simulation::new(&chart).expect("understood");
    for a in [false, false, true] {
        run.cycle(0, &[("a", a.into()), ("b", false.into())]).expect("understood");
    }
    assert_covered!(run.coverage(), steps, transitions);
}

#[test]
#[should_panic(expected = "excepted, but covered of C: `a` never")]
fn what_is_not_asked_for_needs_no_exception() {
    let chart = Chart::parse(SOURCE).expect("a chart");
    assert_covered!(Coverage::of(&chart), steps; except "step", "`a` never");
}

/// What `modes;` makes of conditions is none of their parts, and a condition that no mode asks decides nothing.
#[test]
fn operating_modes_are_no_parts() {
    let chart =
        Chart::parse("grafcet C { modes; input a, b: bool; initial step A; step B; A -[a && b]-> B -[!a]-> A; }")
            .expect("a chart");
    let run = |text: &str| {
        let cycles = script(chart.names(), text).expect("a script");
        Trace::play(&mut Simulation::new(&chart).expect("understood"), &cycles).expect("understood").coverage
    };
    let held = run("-\npaused\npaused a\npaused a b\nmanual a\nsemi_automatic a b\npaused push a b");
    // In the first cycle it is automatic, and `a && b` is false by both: neither decides.
    let none = "C: 1 of 2 steps active, 0 of 2 transitions cleared, 0 of 6 decisions of parts of conditions\n";
    assert!(held.to_string().starts_with(none), "{held}");
    assert!(!held.to_string().contains("paused") && !held.to_string().contains("push"), "{held}");
    // By hand a step is left without its condition.
    let by_hand = run("manual\nmanual push");
    let text = "C: 2 of 2 steps active, 1 of 2 transitions cleared, 0 of 6 decisions of parts of conditions\n";
    assert!(by_hand.to_string().starts_with(text), "{by_hand}");
    // Once pushed, the condition decides: both parts as true.
    let semi_automatic = run("-\nsemi_automatic a b\nsemi_automatic a b push");
    let text = "C: 2 of 2 steps active, 1 of 2 transitions cleared, 2 of 6 decisions of parts of conditions\n";
    assert!(semi_automatic.to_string().starts_with(text), "{semi_automatic}");
}

/// What the bound has stopped is covered when it takes place.
#[test]
fn what_the_bound_stops_is_not_covered() {
    let chart = Chart::parse(
        "grafcet T { max_evolutions 2; input a, b, c: bool; initial step S1; step S2; step S3; S1 -[a]-> S2 -[b]-> S3 -[c]-> S1; }",
    )
    .expect("a chart");
    let run = |text: &str| {
        let cycles = script(chart.names(), text).expect("a script");
        Trace::play(&mut Simulation::new(&chart).expect("understood"), &cycles).expect("understood").coverage
    };
    let stopped = run("a b c");
    assert_eq!((stopped.cleared(), stopped.entered()), (vec![1, 1, 0], &[1, 1, 1][..]));
    let text = "T: 3 of 3 steps active, 2 of 3 transitions cleared, 2 of 6 decisions of parts of conditions\n";
    assert!(stopped.to_string().starts_with(text), "{stopped}");
    let gone_on = run("a b c\nc");
    assert_eq!((gone_on.cleared(), gone_on.entered()), (vec![1, 1, 1], &[2, 1, 1][..]));
}
