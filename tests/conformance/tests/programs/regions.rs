//! Passes over several regions: parallel branches, partial grafcets, and what a search over them does.

use grafcet_compiler::model::{Id, OutputId};
use grafcet_compiler::program::passes::Pass;
use grafcet_compiler::program::{Expr, Role, Statement};
use grafcet_conformance::program::program as optimised;

use super::passes::{drawn, each_left_out, kettle, storm};
use super::read;

/// Whether branches have moved is told by the states that the cycle began with, also where a step is left and entered in other ways, where a time is over and where
/// several regions move at once. Where no state is free to mark a time that is over, or a step is left and entered at once, the cycle stores it.
#[test]
fn branches_tell_by_their_states_whether_they_have_moved() {
    for (more, told) in [
        ("", true),
        ("B2 -[a && 4ms/B2]-> B1;", false),
        ("A2 -[b && 4ms/A2]-> A1;", false),
        ("A1 -[a && b && c]-> A1;", false),
        ("step B3 { P1 n = 1; } B1 -[a && !b && 7ms/B1]-> B3 -[9ms/B3 || c]-> B2;", false),
        ("step B3 { P1 n = 1; } B1 -[a && !b]-> B3 -[9ms/B3 || c]-> B2;", true),
        ("step D1; step D2; B2 -[a && b]-> (D1, D2); (D1, D2) -[!a]-> B2;", false),
    ] {
        let model = read(&kettle(more));
        let program = optimised(&model, &Pass::ALL).expect("a program");
        assert_eq!(program.place(Role::Settled).is_none(), told, "{more}: {program}");
        assert_eq!(program.place(Role::Reading).is_none(), told, "{more}: {program}");
        each_left_out(&model, &storm(&["a", "b", "c"], 300), 120);
    }
}

/// A count that changes with the steps does not tell more than they do; one that changes beside them does. That a time is over is also marked by no step at all,
/// where the step that stays active is not the first of its branch.
#[test]
fn counts_move_with_the_steps() {
    for (more, told) in [("", true), ("S f if a && c;", false), ("N n = (n + 1) % 50;", false), ("N n = 3;", false)] {
        let model = read(&format!(
            "sfc Holes {{ input a, b, c: bool; output p, q: bool; var n: u8 = 0; var f: bool; initial step Idle {{ P1 n = 0; P1 f = false; }} step Move {{ P1 n = (n + 1) % 50; p; }}              step Down {{ {more} }} step End; step Heat {{ q; }} step Hot; Idle -[a]-> (Move, Heat); Move -[b && 2ms/Move]-> Down; Down -[n < 3 && !b]-> Move;              Down -[n >= 3 && !b]-> End; Heat -[c || f]-> Hot; (End, Hot) -[7ms/Hot && !c]-> Idle; }}"
        ));
        let program = optimised(&model, &Pass::ALL).expect("a program");
        assert_eq!(program.place(Role::Settled).is_none(), told, "{more}: {program}");
        assert_eq!(program.place(Role::Reading).is_none(), told, "{more}: {program}");
        let marks = program.to_string().matches("before.state.Heat = none").count();
        assert_eq!(marks, usize::from(told), "{more}: {program}");
        each_left_out(&model, &storm(&["a", "b", "c"], 300), 120);
    }
}

/// Branches within a branch: what joins them is asked first, and after that each is a match of its own, in which no other one has a step that cannot be there.
#[test]
fn branches_stand_within_a_branch() {
    for more in ["", "&& 2ms/A2", "&& 3ms/R2"] {
        let model = read(&format!(
            "sfc Nested {{ input a, b, c: bool; output p, q, r: bool; initial step Start; step A; step A1 {{ p; }} step A2; step B1 {{ q; }} step B2; step End;              step R1; step R2 {{ r; }} step R3; Start -[a]-> (A, R1); A -[b]-> (A1, B1); A1 -[a]-> A2; B1 -[c && 3ms/B1]-> B2; (A2, B2) -[b {more}]-> End;              R1 -[c]-> R2; R1 -[!c && a]-> R3; R2 -[2ms/R2]-> R3; (End, R3) -[!a]-> Start; }}"
        ));
        let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
        let cycle = program.split("\ncycle\n").nth(1).expect("a cycle");
        assert!(!cycle.contains("clears.") && !cycle.contains("entered."), "{more}: {cycle}");
        let (join, others) = cycle.split_once("if state.Start is End && state.R1 is R3 && !a:").expect("the join");
        assert!(!join.contains("match state.B1"), "{more}: {cycle}");
        let joined = others.split("else:").next().expect("what follows it");
        assert!(!joined.contains("state.B1"), "beside End no step of B is active: {more}: {cycle}");
        each_left_out(&model, &storm(&["a", "b", "c"], 400), 120);
    }
}

/// Where the reading of the clock is kept, one evolution asks the field for it; a search, and a cycle that keeps none, the argument. Of a time that is over nothing is
/// told where its step is not active.
#[test]
fn one_evolution_asks_its_field_for_the_clock() {
    let chart = |dialect: &str, time: &str| {
        format!(
            "{dialect} Press {{ input a, b, c: bool; output p, q: bool; initial step Start; step A1 {{ p; }} step A2; step B1 {{ q; }} step B2; \
             Start -[a]-> (A1, B1); A1 -[b && 3ms/A1]-> A2; B1 -[c {time}]-> B2; (A2, B2) -[!a]-> Start; }}"
        )
    };
    for (dialect, time, kept) in [("sfc", "", true), ("sfc", "&& 5ms/B1", false), ("grafcet", "", false)] {
        let model = read(&chart(dialect, time));
        let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
        let cycle = program.split("\ncycle\n").nth(1).expect("a cycle");
        assert_eq!(cycle.contains("fence but on ARMv6-M"), kept, "{dialect}, {time}: {cycle}");
        assert_eq!(cycle.contains("since(now, since."), !kept, "{dialect}, {time}: {cycle}");
        let told = cycle.matches("passed.Start = false").count() + cycle.matches("passed.A1 = false").count();
        assert_eq!(told, usize::from(kept), "only where A1 is entered: {dialect}, {time}: {cycle}");
        each_left_out(&model, &storm(&["a", "b", "c"], 300), 120);
    }
}

/// A branch that looks at a step of another one is a match of its own, in front of it or, where they look at each other, after a copy of its state. What clears a join is
/// asked before, whatever stands where in the chart.
#[test]
fn branches_look_at_each_other() {
    let chart = |of_a: &str, of_b: &str| {
        format!(
            "sfc Hoists {{ input a, b, c: bool; output p, q, r: bool; initial step Start {{ r; }} step A1; step A2 {{ p; }} step A3; \
             step B1; step B2 {{ q; }} step B3; Start -[true]-> (A1, B1); A1 -[a {of_a}]-> A2; A2 -[c && 3ms/A2]-> A3; \
             B1 -[b {of_b}]-> B2; B2 -[c && 5ms/B2]-> B3; (A3, B3) -[!a]-> Start; }}"
        )
    };
    for (of_a, of_b, copied) in [
        ("", "&& !A2.X", None),
        ("&& !B2.X", "", None),
        ("&& !B2.X", "&& !A2.X", Some("was.state.Start")),
        ("&& B2.X", "&& (A2.X || A1.X && c)", Some("was.state.Start")),
        ("&& 4ms/B1", "&& !A2.X", None),
    ] {
        let model = read(&chart(of_a, of_b));
        let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
        let cycle = program.split("\ncycle\n").nth(1).expect("a cycle");
        assert!(!cycle.contains("clears.") && !cycle.contains("entered."), "{of_a}, {of_b}: {cycle}");
        assert_eq!(cycle.matches("if state.Start is A3 && state.B1 is B3").count(), 1, "{of_a}, {of_b}: {cycle}");
        assert_eq!(cycle.matches("state.Start = A2").count(), 1, "{of_a}, {of_b}: {cycle}");
        assert_eq!(cycle.matches("state.B1 = B2").count(), 1, "{of_a}, {of_b}: {cycle}");
        if let Some(copy) = copied {
            assert!(cycle.contains(&format!("{copy} is A")), "{of_a}, {of_b}: {cycle}");
        }
        each_left_out(&model, &storm(&["a", "b", "c"], 300), 60);
    }
}

/// The same in a search: who looks stands in front, and what all rounds compare with is copied once.
#[test]
fn partial_grafcets_look_at_each_other() {
    for (of_a, of_b) in [("", "&& !A::A2.X"), ("&& !B::B2.X", "&& !A::A2.X && !A::A3.X")] {
        let model = read(&format!(
            "grafcet Hoists {{ input a, b, c: bool; output p, q: bool; partial A {{ initial step A1; step A2 {{ p; }} step A3; A1 -[a {of_a}]-> A2; \
             A2 -[c && !a && 3ms/A2]-> A3 -[!c]-> A1; }} partial B {{ initial step B1; step B2 {{ q; }} step B3; B1 -[b && !c {of_b}]-> B2; \
             B2 -[c && 5ms/B2]-> B3 -[!b]-> B1; }} }}"
        ));
        let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
        let cycle = program.split("\ncycle\n").nth(1).expect("a cycle");
        assert!(!cycle.contains("clears.") && !cycle.contains("entered."), "{of_a}, {of_b}: {cycle}");
        for step in ["state.A1 = A2", "state.B1 = B2"] {
            assert_eq!(cycle.matches(step).count(), 1, "{of_a}, {of_b}: {cycle}");
        }
        assert_eq!(cycle.matches("was.state.A1 = state.A1").count(), 1, "{of_a}, {of_b}: {cycle}");
        each_left_out(&model, &storm(&["a", "b", "c"], 300), 60);
    }
}

/// Joins that look into an enclosing step see what was active there before the evolution that leaves it: a state that nothing can meet after it.
#[test]
fn joins_look_into_what_is_left_beside_them() {
    let model = read(
        "grafcet Mixed { input m, z, d, e, g, s, u, v, x, y: bool; output p, q: bool; \
         partial J { initial step J0; step Ja; step Ja2; step Jb; step Jb2; step J3 { p; } J0 -[s]-> (Ja, Jb); Ja -[u]-> Ja2; Jb -[v]-> Jb2; \
           (Ja2, Jb2) -[E::Q1.X && x]-> J3; (Ja2, Jb2) -[E::Q2.X && y]-> J0; J3 -[!x]-> J0; } \
         partial O { initial step Y; \
           enclosing step X { partial E { linked step E0; step Pa; step Q1; step Q2 { q; } E0 -[d]-> (Pa, Q1); Q1 -[e]-> Q2; (Pa, Q2) -[g]-> E0; } } \
           step Z { force J {INIT}; } Y -[m]-> X -[!m]-> Y; Y -[z && !m]-> Z -[!z]-> Y; } }",
    );
    let text = "---\n---\nm @0 | |\nm d @1 | |\nm e @2 | |\nm s @3 | |\nm u v @4 | |\ny @5 | |\n@6 | |\n";
    each_left_out(&model, text, 7);
    let inputs = ["m", "z", "d", "e", "g", "s", "u", "v", "x", "y"];
    each_left_out(&model, &storm(&inputs, 400), 0);
}

/// An output that ends each cycle as its flip-flop is set after the ways, but not one that something asks for.
#[test]
fn an_output_that_shows_a_field_is_set_once() {
    for (lamp, once) in [("S lamp;", true), ("S lamp; p if lamp;", false)] {
        let model = read(&format!(
            "sfc Stored {{ input a, b: bool; output lamp, p: bool; initial step Idle {{ R lamp; }} step A1 {{ {lamp} }} step A2; step B1; step B2; \
             Idle -[a]-> (A1, B1); A1 -[b]-> A2; B1 -[a && b]-> B2; (A2, B2) -[!a]-> Idle; }}"
        ));
        let program = optimised(&model, &Pass::ALL).expect("a program");
        let output = program.place(Role::Output(OutputId::new(0))).expect("an output");
        let last = matches!(program.cycle.last(), Some(Statement::Set(place, Expr::Place(_))) if *place == output);
        assert_eq!(last, once, "{lamp}: {program}");
        each_left_out(&model, &storm(&["a", "b"], 200), 0);
    }
}

/// A partial grafcet that an order empties is without a step where that order stands, and nowhere else: there is no arm for what lies below it there.
#[test]
fn what_an_order_empties_is_empty_beside_it_alone() {
    let chart = |restart: &str| {
        format!(
            "grafcet Emptied {{ input stop, a, b: bool; output q: bool; \
             partial Safety {{ initial step Run; step Stopped {{ force Modes {{}}; force Side {{}}; }} step Restart {{ {restart} }} \
               Run -[stop]-> Stopped -[!stop]-> Restart -[true]-> Run; }} \
             partial Modes {{ initial step Manual {{ force Side {{INIT}}; }} step Auto; Manual -[a]-> Auto -[!a]-> Manual; }} \
             partial Side {{ initial step Free; step Busy {{ q; }} Free -[b]-> Busy -[!b]-> Free; }} }}"
        )
    };
    for (restart, beside) in [("force Modes {INIT};", false), ("", true)] {
        let model = read(&chart(restart));
        let text = optimised(&model, &before(Pass::United)).expect("a program").to_string();
        let (_, search) = text.split_once("loop").expect("a search");
        assert_eq!(search.contains("none:"), beside, "{restart}: {text}");
        each_left_out(&model, &storm(&["stop", "a", "b"], 200), 0);
    }
}

/// A stop that forces two modes, one of which encloses two branches; a part beside them that looks at the branches.
pub(super) const PLANT: &str = "grafcet Plant { input stop, go, auto, x, y, z: bool; output p, q, r, s: bool; output n: bool = false; \
     partial Safety { initial step Ready; step Stopped { force Modes {}; p; } step Restart { force Modes {INIT}; force Side {INIT}; } \
       Ready -[stop]-> Stopped -[!stop && rising(go)]-> Restart -[true]-> Ready; } \
     partial Modes { initial step Manual { q; } enclosing step Auto { partial Work { linked step Wait; step A1 { r; } step A2; \
       step B1 { P1 n = !n; } step B2; \
       Wait -[x]-> (A1, B1); A1 -[y]-> A2; B1 -[z && A2.X]-> B2; B1 -[5ms/B1]-> B2; (A2, B2) -[!x]-> Wait; } } \
       Manual -[rising(auto)]-> Auto -[!auto && Work::Wait.X]-> Manual; } \
     partial Side { initial step S1 { S s; } step S2 { force Other {}; R s; } S1 -[Work::A1.X || x && y]-> S2 -[!Work::B1.X && !x]-> S1; } \
     partial Other { initial step O1; step O2; O1 -[z]-> O2 -[y && 3ms/O2]-> O1; } }";

/// What forces and encloses, what is forced and enclosed, and what looks at both, at random inputs.
#[test]
fn a_search_goes_from_above_downwards() {
    let model = read(PLANT);
    let program = optimised(&model, &Pass::ALL).expect("a program");
    let Some(Statement::Loop { body, .. }) = program.cycle.iter().find(|one| matches!(one, Statement::Loop { .. }))
    else {
        panic!("{program}");
    };
    assert!(body.iter().any(|one| matches!(one, Statement::Match(..))), "{program}");
    let text = drawn(&[("stop", true), ("go", false), ("auto", false), ("x", false), ("y", false), ("z", false)], 240);
    each_left_out(&model, &text, 40);
}

/// A stop above two branches by time in an enclosing step, one of which stays active beyond its time; what is stored changes in several places.
pub(super) const CELL: &str = "grafcet Cell { input stop, ack, go, x, y: bool; output clamp, p, q: bool; output n: bool = false; \
     partial Safety { initial step Ready; step Stopped { force Modes {}; p; } step Restart { force Modes {INIT}; } \
       Ready -[stop]-> Stopped -[!stop && rising(ack)]-> Restart -[true]-> Ready; } \
     partial Modes { initial step Manual { R clamp; } enclosing step Auto { \
       partial Work { linked step Wait; step Close { S clamp; } step Work { q; } step Open { R clamp; P1 n = !n; } \
         Wait -[x]-> Close -[4ms/Close]-> Work -[y]-> Open -[!x]-> Wait; } \
       partial Side { linked step Off; step On { q; } step Late; Off -[y && 3ms/Off]-> On -[5ms/On]-> Late -[!y]-> Off; } } \
       Manual -[rising(go)]-> Auto -[!go && Work::Wait.X]-> Manual; } }";

/// Of several partial grafcets the first cycle is a state, no reading is kept, a time begins where a step asks for it, and a stored output changes where it is written.
#[test]
fn partial_grafcets_keep_little() {
    let model = read(CELL);
    let program = optimised(&model, &Pass::ALL).expect("a program");
    for role in [Role::Reading, Role::Settled, Role::Passed(2)] {
        assert!(program.place(role).is_none(), "{role:?}: {program}");
    }
    assert!(program.place(Role::Passed(3)).is_some(), "Off stays active beyond its time: {program}");
    assert!(program.place(Role::First).is_none_or(|first| !program.places[first.0].is_field), "{program}");
    let text = program.to_string();
    assert!(!text.contains("next.clamp") && !text.contains("evolutions"), "{program}");
    assert_eq!(text.matches("since.Wait = now").count(), 1, "{program}");
    let inputs = [("stop", true), ("ack", false), ("go", false), ("x", false), ("y", false)];
    each_left_out(&model, &drawn(&inputs, 400), 200);
}

/// What two regions store in a round, each reads of the other as it was before (A5): one of the values waits for the end of the round.
#[test]
fn what_a_round_stores_is_read_as_it_was() {
    let model = read(
        "grafcet Reads { input a, b: bool; output p: bool; var n, m: bool = false; \
         partial One { initial step A { P1 n = false; } step B { P1 n = true; } A -[a && !b && !m]-> B -[b]-> A; } \
         partial Two { initial step X { P1 m = false; } step Y { P1 m = true; p; } X -[a && !n]-> Y -[!a]-> X; } }",
    );
    let text = optimised(&model, &Pass::ALL).expect("a program").to_string();
    assert!(text.contains("n = next.n") && !text.contains("next.m"), "{text}");
    each_left_out(&model, &drawn(&[("a", false), ("b", false)], 100), 0);
}

/// A step that an order from above may keep active is not left when its time is over, and its deadline has to know that; one that loses what encloses it is.
#[test]
fn an_order_from_above_keeps_steps_beyond_their_time() {
    for (order, kept) in [
        ("force Modes {};", false),
        ("force Modes {INIT};", false),
        ("force Modes {Manual};", false),
        ("force Modes {Auto};", true),
        ("force Modes {*};", true),
        ("force Work {*};", true),
        ("force Work {Close};", true),
        ("force Work {Wait};", false),
        ("force Side {*};", false),
    ] {
        let model = read(&CELL.replacen("force Modes {};", order, 1));
        let program = optimised(&model, &Pass::ALL).expect("a program");
        assert_eq!(program.place(Role::Passed(2)).is_some(), kept, "{order}: {program}");
        let inputs = [("stop", true), ("ack", false), ("go", false), ("x", false), ("y", false)];
        each_left_out(&model, &drawn(&inputs, 200), 100);
    }
}

/// The time of a step with which a branch begins counts from the first cycle.
#[test]
fn times_of_initial_steps_begin_with_the_first_cycle() {
    let model = read(
        "grafcet Two { input a, b: bool; output p: bool; partial Up { initial step A; step B { p; } A -[b && 3ms/A]-> B -[5ms/B]-> A; } \
         partial Down { initial step C; step E; C -[a]-> E -[!a]-> C; } }",
    );
    let program = optimised(&model, &Pass::ALL).expect("a program");
    assert!(program.to_string().contains("since.A = now"), "{program}");
    each_left_out(&model, &drawn(&[("a", false), ("b", false)], 60), 60);
}

/// What a region does is asked for beside those states of another one alone beside which it does something, if these have one block.
#[test]
fn what_nothing_is_done_for_is_not_asked() {
    let text = |order: &str| {
        let chart = format!(
            "grafcet Stop {{ input stop, ack, go, jog: bool; output alarm, manual, belt: bool;
                partial Safety {{ initial step Ready; step Stopped {{ force Modes {order}; alarm; }}
                    Ready -[stop]-> Stopped -[!stop && ack]-> Ready; }}
                partial Modes {{ initial step Manual {{ manual; belt if jog; }} step Auto {{ belt; }}
                    Manual -[go && !stop]-> Auto -[!go && !stop]-> Manual; }} }}"
        );
        optimised(&read(&chart), &before(Pass::United)).expect("a program").to_string()
    };
    let [emptied, manual] = ["{}", "{INIT}"].map(text);
    assert!(emptied.contains("    Stopped: alarm = true\n    else:\n      match state.Manual\n"), "{emptied}");
    assert!(manual.contains("    Stopped: alarm = true\n  match state.Manual\n"), "{manual}");
}

/// The passes in front of one.
fn before(pass: Pass) -> Vec<Pass> {
    Pass::ALL.into_iter().take_while(|other| *other != pass).collect()
}

/// A stop above two modes, one of which encloses a sequence; a part beside them that only the sequence waits for.
pub(super) const BOXES: &str = "grafcet Boxes { input stop, ack, auto, a, b, c: bool; output p, q, r, s, t: bool; output n: bool = false; \
     partial Safety { initial step Ready; step Stopped { force Modes {}; p; } step Restart { force Modes {INIT}; } \
       Ready -[stop]-> Stopped -[!stop && rising(ack)]-> Restart -[true]-> Ready; } \
     partial Modes { initial step Manual { q; } enclosing step Auto { partial Work { linked step Wait { r; } step Fill { s if Side::Off.X; } step Turn; \
       step Close { P1 n = !n; } step Leave { q if Auto.X; } \
       Wait -[a && !b]-> Fill -[b]-> Turn -[3ms/Turn]-> Close -[c && Side::Off.X]-> Leave -[!a]-> Wait; } } \
       Manual -[rising(auto)]-> Auto -[!auto && !c && Work::Wait.X]-> Manual; } \
     partial Side { initial step Off; step On { t if Modes::Auto.X; } Off -[ack && Modes::Auto.X]-> On -[!ack && Safety::Ready.X]-> Off; } }";

/// Regions that have no more states together than steps are one place, if each way leads to one of its states: a stop leaves no mode, and what an enclosing step encloses is
/// within one of them.
#[test]
fn regions_that_go_together_share_a_place() {
    let places = |chart: &str| {
        let model = read(chart);
        let program = optimised(&model, &Pass::ALL).expect("a program");
        let states = program.places.iter().filter(|place| matches!(place.role, Role::State(_))).count();
        (states, program.united.iter().map(|united| united.regions.clone()).collect::<Vec<_>>())
    };
    assert_eq!(places(BOXES), (2, vec![vec![0, 1, 2]]));
    // A mode that outlives the stop is a state of its own beside it.
    assert_eq!(places(&BOXES.replacen("force Modes {};", "force Modes {*};", 1)), (3, vec![vec![1, 2]]));
    // In each state of the sequence the part beside it may be in each of its own.
    assert_eq!(places(CELL), (2, vec![vec![0, 1, 2]]));
    // By hand a chart is led to any situation.
    assert_eq!(places(&BOXES.replacen("input stop", "forceable; input stop", 1)).0, 4);
    let inputs = [("stop", true), ("ack", false), ("auto", false), ("a", false), ("b", false), ("c", false)];
    each_left_out(&read(BOXES), &drawn(&inputs, 400), 200);
}

/// What is done in one state alone is asked in its arm, and nothing after it.
#[test]
fn a_condition_of_one_state_stands_in_its_arm() {
    // The part beside the sequence rests in all other states.
    let chart = BOXES.replacen("Safety::Ready.X", "Modes::Auto.X", 1);
    let chart = chart.replacen("force Modes {};", "force Modes {}; force Side {};", 1);
    let chart = chart.replacen("Manual { q; }", "Manual { force Side {INIT}; q; }", 1);
    let text = optimised(&read(&chart), &Pass::ALL).expect("a program").to_string();
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let arm = "Wait: if !auto && !c: moves.45 = true state.Ready = Manual state.Off = Off break else if a && !b:";
    assert!(words.contains(arm), "{text}");
    assert!(!text.contains("state.Ready is Wait"), "{text}");
}

/// What an edge of a step compares with is known in the first cycle, in which no arm asks for it; what a delay shows then is not.
#[test]
fn an_edge_of_a_step_begins_with_the_initial_situation() {
    let chart = "grafcet Listens { input a, b: bool; output p, q: bool; output n, m: u8; \
         partial Count { initial step Ears { on rising(Go.X) n = n % 50 + 1; on falling(Rest.X) m = m % 50 + 1; on rising(2ms/b) p = !p; } } \
         partial Drive { initial step Rest; step Go { q; } step Back; Rest -[a]-> Go -[!a]-> Back -[rising(1ms/b/5ms) || !b && 9ms/Back]-> Rest; } }";
    let text = optimised(&read(chart), &Pass::ALL).expect("a program").to_string();
    assert!(!text.contains("evolutions == 0"), "{text}");
    assert_eq!(text.matches("edge1.before = true").count(), 1, "{text}");
    assert_eq!(text.matches("edge0.before = ").count(), 2, "{text}");
    each_left_out(&read(chart), &drawn(&[("a", false), ("b", false)], 300), 100);
    // The delay is over in the first cycle: that is no edge.
    let timeline =
        drawn(&[("a", false), ("b", false)], 300).replacen("---\n---\n", "---\n---\na b @4294967230 | |\n", 1);
    each_left_out(&read(&chart.replace("rising(2ms/b)", "rising(0ms/b/4ms)")), &timeline, 100);
}

/// A variable that changes on ways alone that say that something moves is not compared with what it was; one that changes on others is.
#[test]
fn what_changes_with_the_steps_is_not_compared() {
    for (more, compared) in [("", false), ("N n = n % 3;", true), ("P0 n = 2;", false), ("S n = n % 2 + 1;", true)] {
        let chart = format!(
            "sfc Packs {{ input a, b, c: bool; output p, q: bool; var n: u8 = 0; initial step Idle {{ P1 n = 0; p if rising(c); }} step Move {{ P1 n = n % 5 + 1; }} step Down {{ {more} }} \
             step Heat {{ L 3ms q; }} step Hot; Idle -[rising(a)]-> (Move, Heat); Move -[b && 2ms/Move]-> Down; Down -[n < 3 && !b]-> Move; Heat -[falling(c)]-> Hot; \
             (Down, Hot) -[n >= 3 && 7ms/Hot]-> Idle; }}"
        );
        let model = read(&chart);
        let program = optimised(&model, &Pass::ALL).expect("a program").to_string();
        assert_eq!(program.contains("n != was.n"), compared, "{more}: {program}");
        each_left_out(&model, &storm(&["a", "b", "c"], 300), 120);
    }
}
