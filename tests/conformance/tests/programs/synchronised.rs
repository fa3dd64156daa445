//! Charts whose branches many transitions synchronise: a program has each transition in one place.

use grafcet_compiler::program::passes::Pass;
use grafcet_conformance::program::program as optimised;

use super::passes::{drawn, each_left_out, storm};
use super::read;

/// Places between stations are branches of their own, which are full or empty.
const STATIONS: &str = "sfc Stations { input a, b, c, d: bool; output p, q, r: bool; initial step Start; \
     step Wait; step Saw { p; } step Empty; step Full; step Idle; step Bend { q; } step Free; step Taken { r; } \
     Start -[true]-> (Wait, Empty, Idle, Free); Wait -[a]-> Saw; (Saw, Empty) -[b]-> (Wait, Full); \
     (Idle, Full) -[true]-> (Bend, Empty); (Bend, Free) -[c]-> (Idle, Taken); Taken -[d]-> Free; }";

/// Two want one crane; what each of them gives back the other one may take.
const CRANE: &str = "grafcet Crane { input a, b, c, d: bool; output p, q: bool; initial step Free; initial step Idle1; initial step Idle2; \
     step Carry1 { p; } step Carry2 { q; } (Free, Idle1) -[a]-> Carry1; Carry1 -[c && !a]-> (Free, Idle1); \
     (Free, Idle2) -[b && !(Idle1.X && a)]-> Carry2; Carry2 -[d && !b]-> (Free, Idle2); }";

fn text(chart: &str) -> String {
    optimised(&read(chart), &Pass::ALL).expect("a program").to_string()
}

fn is_the_same(chart: &str) {
    let inputs = [("a", false), ("b", false), ("c", false), ("d", false)];
    each_left_out(&read(chart), &drawn(&inputs, 300), 100);
}

/// A transition is asked for by the state of one of its regions, and says what it changes in all of them; of a region that one in front of it
/// may have written it asks for a copy.
#[test]
fn a_transition_stands_in_one_place() {
    let stations = text(STATIONS);
    for part in [
        "\n        Saw:\n          if state.Empty is Empty && b:\n            state.Start = Wait\n            state.Empty = Full\n",
        "\n        Idle:\n          if was.state.Empty is Full:\n            state.Empty = Empty\n            state.Idle = Bend\n",
    ] {
        assert!(stations.contains(part), "{part}\n{stations}");
    }
    assert!(!stations.contains("clears."), "{stations}");
    is_the_same(STATIONS);
    is_the_same(&STATIONS.replacen("sfc", "grafcet", 1).replacen("Start -[true]", "Start -[rising(a)]", 1));
}

/// Transitions that exclude each other are asked one after the other, and each of them tells that the search goes on.
#[test]
fn transitions_tell_that_something_moves() {
    let crane = text(CRANE);
    assert!(!crane.contains("moves.16 ||") && !crane.contains("was.state.Free"), "{crane}");
    is_the_same(CRANE);
    // Where both clear, the crane has the state that it had: whoever gives it back has moved himself.
    is_the_same(&CRANE.replacen("Carry1 -[c && !a]", "Carry1 -[true]", 1));
}

/// A step that one transition leaves and another one enters at once stays active (A4).
#[test]
fn a_step_is_left_and_entered_at_once() {
    let chart = "grafcet Twice { input a, b, c, d: bool; output p, q, r: bool; initial step A { p; } step B { q; } step C; step D { r; } step E; \
         A -[a]-> (B, C, D); (B, C) -[!a]-> A; B -[b]-> B; (C, D) -[c && d]-> (C, E); (E, B) -[!d]-> (B, D); }";
    is_the_same(chart);
}

/// Who asks later on for what has cleared is told by the transitions, or has them asked beforehand: for actions on activation, times, and what the next cycle would do.
#[test]
fn what_has_cleared_is_kept_for_others() {
    let timed = STATIONS.replacen("output p", "output n: u8; output p", 1).replacen(
        "Bend { q; }",
        "Bend { q; P1 n = n % 50 + 1; D 3ms r; }",
        1,
    );
    let timed = timed.replacen("Taken { r; }", "Taken;", 1).replacen("-[d]->", "-[d && 5ms/Taken]->", 1);
    is_the_same(&timed);
    is_the_same(&timed.replacen("sfc", "grafcet", 1).replacen("Start -[true]", "Start -[rising(a)]", 1));
}

/// What another part has made of a state in front is not what was there when the round began.
#[test]
fn a_state_from_before_the_round_is_not_made_anew() {
    let chart = "grafcet Line { input a, b, c, d: bool; output p, q, r: bool; \
         partial Robot { initial step Home { p; } step There; Home -[a && Box::Open.X]-> There -[b]-> Home; } \
         partial Box { initial step Open; step Shut { q; } step Side1; step Side2 { r; } step Done; \
           Open -[Robot::Home.X && c]-> (Shut, Side1); Side1 -[d && Robot::Home.X]-> Side2; \
           (Shut, Side1) -[Robot::There.X && c]-> Done; (Shut, Side2) -[Robot::There.X]-> Done; Done -[!c && Robot::Home.X]-> Open; } }";
    let chart = chart.replacen("Side1 -[d &&", "Side1 -[d && !c &&", 1);
    is_the_same(&chart);
}

/// In a chart that is not safe (`S5` leads back into the step that forks) a transition that is asked first leaves a step as well: what it puts into the truth by which that step
/// is left stands in front of the transitions that are written one by one, so these may not take the truth for theirs alone.
#[test]
fn what_leaves_a_step_may_be_known_before() {
    let chart = "sfc Gathered { input a: bool; input b: bool; input c: bool; input d: bool; input e: bool; param p: time in 0s..1h = 4ms; output q0: bool; output q1: \
     bool; output q2: bool; output y: u8; output z: i16; var n: i16 = 0; action act0(r0: u8, r1: bool); let w0 = ((a) != ((3ms/S8))); initial step S1 { } \
     step S2 { } step S3 { } step S4 { N q1; S q1; N q1 if (1ms/q2); D 6ms z = ((z + 4) % 50); } step S5 { q1; N q1 if (!a || S2.X); } step S6 { P1 n = (z \
     & 7); } step S7 { } step S8 { N act0(((y * 3) % 50), ((d) != (!w0))) if (e && w0); P1 { z = (n & 7); n += 3; n %= 50; } } step S9 { D 8ms n = ((z + (z \
     & 7)) % 50); } step S10 { N act0(((0 * 3) % 50), false); S n = ((6 + ((n + z) % 50)) % 50); N act0(4, (d || !w0)); P q0; } S1 -[true]-> S2; S2 -[b]-> \
     (S3, S4, S5); S3 -[!q0]-> S6; S3 -[(((blink(2ms, S9) && (z >= z))) ^ ((y == y)))]-> S7; S3 -[((((y == y)) != (S2.X)) && a)]-> S8; S6 -[(!d || (d && \
     falling(d)))]-> S9; S7 -[t3159: !((20ms/S6))]-> S9; S8 -[(n < z)]-> S9; (S9, S4, S5) -[(((z == 2) && (z >= z)) || !d)]-> S10; S10 -[(((S8.X) != (e)) \
     || (3ms/S7))]-> S1; S5 -[!d]-> S2; }";
    each_left_out(&read(chart), &storm(&["a", "b", "c", "d", "e"], 120), 3);
}

/// In an `sfc` a branch stands in front of the convergence of its step: what that asks of the branch is asked there, so that the regions are compiled one by one. What stands
/// for several of their states is not known in front of where it is gathered.
#[test]
fn a_convergence_asks_what_a_branch_before_it_asks() {
    let chart = "sfc Loop { input a, b, c, d, f: bool; output p, q, r: bool; initial step I; step A { p; } step B { q; } step C; step D { r; } \
         I -[a]-> (A, C); A -[b]-> B; C -[c]-> D; B -[!c]-> A; (B, D) -[c && d]-> I; }";
    let plays = |chart: &str| each_left_out(&read(chart), &storm(&["a", "b", "c", "d", "f"], 300), 100);
    let shown = text(chart);
    assert!(!shown.contains("clears.") && !shown.contains("entered."), "{shown}");
    plays(chart);
    let stopped = chart.replacen("I; }", "I; step X; any except I -[rising(f)]-> X; X -[!f]-> I; }", 1);
    let shown = text(&stopped);
    assert!(!shown.contains("clears.A→X") && !shown.contains("clears.C→X"), "{shown}");
    for stopped in [&stopped, &stopped.replacen("except I", "except (I, B)", 1)] {
        plays(stopped);
        let search = stopped.replacen("sfc", "grafcet", 1);
        plays(&search);
        plays(&search.replacen("step C;", "step C; step E;", 1).replacen("B -[!c]-> A;", "B -[!c]-> E -[!b]-> A;", 1));
    }
    let three = "sfc Three { input a, b, c, d, f: bool; output p: bool; initial step I; step A; step B; step C; step D { p; } step Y; step Z; step X; \
         I -[a]-> (A, C, Y); A -[b]-> B; C -[c]-> D; Y -[d]-> Z; (B, D, Z) -[c && d]-> I; any except (I, B, C, Y) -[f]-> X; X -[!f]-> I; }";
    plays(three);
    plays(&three.replacen("sfc", "grafcet", 1));
}

/// Of two convergences of the same steps the later one asks for an edge, which is found in front of both: what that is there is not what the part begins with.
#[test]
fn a_convergence_asks_for_what_has_been_found_in_front_of_it() {
    for dialect in ["sfc", "grafcet"] {
        let chart = format!(
            "{dialect} Edge {{ input a, b, c, d: bool; output p: bool; initial step I {{ p; }} step A; step B; step C; step D; step E; \
             I -[a]-> (A, B, C); (A, B, C) -[c]-> D -[!c]-> I; (A, B, C) -[rising(C.X)]-> E -[d]-> I; }}"
        );
        each_left_out(&read(&chart), &storm(&["a", "b", "c", "d"], 300), 100);
    }
}

/// What gives up all branches leads back to the step in which they began, as a convergence does: that it does so is asked by the region of that step alone.
#[test]
fn what_gives_up_branches_may_lead_back_to_where_they_began() {
    let chart = "sfc Back { input a, b, c, d, f: bool; output q, r: bool; initial step I { R q; } step A { S q; } step B { R q; } step C; \
         step E { S r; } step F { R r; } I -[a]-> (A, C); A -[b]-> B -[!b]-> A; C -[c]-> E -[!c]-> F -[c]-> C; (B, F) -[d]-> I; \
         any except I -[f]-> I; }";
    let shown = text(chart);
    assert!(!shown.contains("entered.") && !shown.contains("clears."), "{shown}");
    each_left_out(&read(chart), &storm(&["a", "b", "c", "d", "f"], 300), 100);
    let edge = chart.replacen("-[f]->", "-[rising(f) || a && b && c]->", 1);
    each_left_out(&read(&edge), &storm(&["a", "b", "c", "d", "f"], 300), 100);
    let search = chart.replacen("sfc", "grafcet", 1).replacen("-[!b]-> A", "-[!b && d]-> A", 1);
    each_left_out(&read(&search), &storm(&["a", "b", "c", "d", "f"], 300), 100);
}

/// Actions of two branches that change the same value at once do so in the order of the chart, also where those of one branch are looked up by its state.
#[test]
fn actions_at_once_keep_their_order() {
    let chart = "sfc Both { input a, b, c, d: bool; output n: u8; initial step Idle; \
         step A1 { P1 n = n % 50 + 1; P0 n = n % 40 * 2; } step B1 { P1 n = n % 40 * 3; P0 n = n % 60 + 2; } \
         step A2 { P1 n = n % 50 + 3; P0 n = n % 30 * 2; } step B2 { P1 n = n % 30 * 4; P0 n = n % 60 + 5; } step A3; step B3; \
         Idle -[a]-> (A1, B1); A1 -[b]-> A2; B1 -[b || d]-> B2; A2 -[c]-> A3; B2 -[c]-> B3; (A3, B3) -[!a]-> Idle; }";
    is_the_same(chart);
    is_the_same(&chart.replacen("sfc", "grafcet", 1));
}

/// What stops all steps is asked first, in one place, and what it does is done once; arithmetic, which may panic, beside the steps alone that it stops.
#[test]
fn a_stop_is_asked_first_if_it_cannot_panic() {
    let mixer = include_str!("../../../golden/shapes/branches_stopped.chart");
    let chart = |stop: &str| {
        mixer.replacen("input start", "param y: u8 = 9; input start", 1).replacen(
            "any -[stop]",
            &format!("any -[{stop}]"),
            1,
        )
    };
    let compared = chart("stop && y > 3");
    assert!(
        text(&compared).contains("\n    if stop && y > 3:\n      if !(state.Idle is Stopped):\n"),
        "{}",
        text(&compared)
    );
    let computed = text(&chart("stop && 9 - y < 3"));
    assert!(computed.contains("\n      Idle:\n        if stop && 9 - y < 3:"), "{computed}");
    for chart in [mixer, &compared] {
        let inputs = ["start", "full", "mixed", "weighed", "stop", "ack"].map(|input| (input, input == "stop"));
        each_left_out(&read(chart), &drawn(&inputs, 300), 100);
    }
}
