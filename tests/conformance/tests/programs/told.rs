//! What a cycle need not keep, as something else tells it: timers of actions, what an edge compares with at first, whether a cycle has moved.

use std::fmt::Write as _;

use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::program as optimised;

use super::passes::{each_left_out, storm};
use super::read;

fn text(chart: &str) -> String {
    optimised(&read(chart), &Pass::ALL).expect("a program").to_string()
}

/// L, D or DS on several steps that neither are active together nor follow each other: the time of each step tells what their timer would. Where one leads to another, the timer runs on.
#[test]
fn steps_apart_from_each_other_share_no_timer() {
    for qualifier in ["L", "D", "DS"] {
        let chart = |next: &str| {
            format!(
                "sfc Blow {{ input a, b: bool; output blow, p: bool; initial step Idle {{ R blow; }} step Pick {{ {qualifier} 5ms blow; }} step Move {{ p; }} \
                 step Place {{ {qualifier} 3ms blow; p; }} step Rest; \
                 Idle -[a]-> Pick -[b && 2ms/Pick]-> {next}; Move -[!b]-> Place -[!a && 4ms/Place]-> Rest -[b || 6ms/Rest]-> Idle; Place -[a && b && 8ms/Place]-> Place; }}"
            )
        };
        for (next, is_shared) in [("Move", false), ("Place", true)] {
            let chart = chart(next);
            let program = text(&chart);
            assert_eq!(program.contains("_TMR.blow"), is_shared, "{program}");
            each_left_out(&read(&chart), &storm(&["a", "b"], 300), 150);
        }
    }
    // Beside each other they are one input of it.
    let beside = "sfc Blow { input a, b: bool; output blow: bool; initial step Idle; step A1 { L 5ms blow; } step A2; step B1; step B2 { L 5ms blow; } \
                  Idle -[a]-> (A1, B1); A1 -[b]-> A2; B1 -[!a]-> B2; (A2, B2) -[a && 3ms/B2]-> Idle; }";
    assert!(text(beside).contains("L_TMR.blow"));
    each_left_out(&read(beside), &storm(&["a", "b"], 300), 150);
}

/// The first cycle has no edges (A26): an input that is on already does not rise, one that is off does not fall. Where both are asked for, the first cycle has to look.
#[test]
fn a26_what_an_edge_compares_with_at_first_needs_no_first_cycle() {
    for (edges, looks) in [
        (["rising(a)", "rising(b) || c"], false),
        (["falling(a)", "falling(b) && !c"], false),
        (["rising(a)", "falling(b && c)"], false),
        (["rising(a)", "falling(a)"], true),
    ] {
        let [first, second] = edges;
        let chart = format!(
            "grafcet Edges {{ input a, b, c: bool; output p: bool; initial step A; step B {{ p; }} step C; A -[{first}]-> B -[{second}]-> C -[!c]-> A; }}"
        );
        assert_eq!(text(&chart).contains("first"), looks, "{edges:?}: {}", text(&chart));
        for dialect in ["sfc", "grafcet"] {
            let model = read(&chart.replacen("grafcet", dialect, 1));
            each_left_out(&model, &storm(&["a", "b", "c"], 200), 100);
            each_left_out(&model, &storm(&["c", "b", "a"], 200), 100);
        }
    }
}

/// A chart with branches that keeps the reading anyway compares its states at the end of a cycle where many ways would tell that they have moved.
#[test]
fn whether_many_ways_have_moved_is_compared_once() {
    let (mut steps, mut arrows) = (String::new(), String::new());
    for at in 0..12 {
        _ = write!(steps, "step F{at} {{ {} if blink(2ms/1ms); }} step G{at};", ["p", "q"][at % 2]);
    }
    for at in 0..11 {
        let next = at + 1;
        _ = write!(
            arrows,
            "F{at} -[a && 4ms/F{at}]-> F{next}; F{at} -[!a && b && 5ms/F{at}]-> Out; G{at} -[b]-> G{next}; G{at} -[!b && a && 7ms/G{at}]-> G0;"
        );
    }
    let chart = format!(
        "sfc Long {{ input a, b: bool; output p, q: bool; initial step Idle; step Out; {steps} Idle -[a]-> (F0, G0); {arrows} (F11, G11) -[!a]-> Idle; (Out, G11) -[b]-> Idle; }}"
    );
    let chart = chart.replacen("G0 -[!b && a && 7ms/G0]-> G0;", "", 1);
    let program = text(&chart);
    assert!(program.contains("before.state.Idle != state.Idle || before.state.G0 != state.G0"), "{program}");
    assert!(!program.contains("settled"), "{program}");
    each_left_out(&read(&chart), &storm(&["a", "b"], 300), 100);
}

/// What runs on in a sequence stands after its match where several of its states would have it, and what one state alone has stays there.
#[test]
fn only_times_of_many_states_stand_after_the_match() {
    let (mut steps, mut arrows) = (String::new(), String::new());
    for at in 0..10 {
        _ = write!(steps, "step S{at} {{ {}; }} ", ["p", "q"][at % 2]);
    }
    for at in 0..9 {
        _ = write!(arrows, "S{at} -[a && b]-> S{}; S{at} -[!a && 6ms/S{at}]-> Fault; ", at + 1);
    }
    let chart = format!(
        "sfc Runs {{ input a, b: bool; output p, q, horn, fan: bool; initial step Idle {{ R horn; SD 4ms fan; }} step Go {{ R fan; }} {steps} step Fault {{ SD 5ms horn; }} \
         Idle -[a]-> Go -[b]-> S0; {arrows} S9 -[!b]-> Idle; Fault -[a && b]-> S0; Fault -[b && !a && 9ms/Fault]-> Go; }}"
    );
    let program = text(&chart);
    let after = program.split("fence").last().unwrap_or_default();
    assert_eq!(program.matches("Sd_TMR.horn.stage == 0").count(), 1, "{program}");
    assert!(after.contains("Sd_TMR.horn.stage == 0"), "{program}");
    each_left_out(&read(&chart), &storm(&["a", "b"], 300), 150);
}

/// A timer of an action, and the delay of a condition, with literals are readings of the clock: beside them nothing counts, and nothing keeps the reading of the last cycle. A stage
/// says whether the reading counts, so that what is over stays so however long it lasts.
#[test]
fn timers_and_delays_with_literals_are_readings() {
    for actions in [
        ["SD 3ms q;", "R q;", ""],
        ["SL 3ms q;", "R q;", "SL 3ms q;"],
        ["L 3ms q if a;", "", "L 3ms q if b;"],
        ["D 2ms q if !b;", "", "D 2ms q;"],
        ["DS 2ms q if a;", "R q;", ""],
        ["SD 0ms q;", "R q;", ""],
    ] {
        let [first, second, third] = actions;
        for time in ["", "param t: time = 3ms;"] {
            let timed = |action: &str| {
                if time.is_empty() {
                    action.to_owned()
                } else {
                    action.replace("3ms", "t").replace("2ms", "t").replace("0ms", "t")
                }
            };
            let chart = format!(
                "sfc Timers {{ input a, b: bool; output q, p: bool; {time} initial step A {{ {} }} step B {{ p; {} }} step C {{ {} }} A -[a]-> B -[b]-> C -[!a]-> A; }}",
                timed(third),
                timed(first),
                timed(second)
            );
            let program = text(&chart);
            assert_eq!(program.contains("TMR.q.stage"), time.is_empty(), "{program}");
            assert_eq!(program.contains("elapsed"), !time.is_empty(), "{program}");
            each_left_out(&read(&chart), &storm(&["a", "b"], 300), 150);
        }
    }
    for delay in ["3ms/a", "2ms/a/4ms", "0ms/a/2ms", "2ms/(3ms/a/1ms)"] {
        for dialect in ["sfc", "grafcet"] {
            let chart = format!(
                "{dialect} Delays {{ input a, b: bool; output q: bool; initial step A {{ q if {delay}; }} step B {{ q; }} A -[b && {delay}]-> B -[!({delay})]-> A; }}"
            );
            let program = text(&chart);
            assert!(program.contains("delay0.stage") && !program.contains("elapsed"), "{program}");
            each_left_out(&read(&chart), &storm(&["a", "b"], 300), 150);
        }
    }
}
