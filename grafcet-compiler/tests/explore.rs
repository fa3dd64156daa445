//! The exploration of small charts whose situations one can count by hand.

use grafcet_compiler::analysis::explore::{Exploration, Limits};
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::model::{self, Model, StepId, TransitionId};
use grafcet_compiler::parse;

fn model(chart: &str) -> Model {
    let mut sink = Sink::new();
    let chart = parse::chart(chart.parse().expect("tokens"), &mut sink).expect("a chart");
    let model = model::resolve(&chart, &mut sink);
    let messages = sink.finish();
    assert!(messages.is_empty(), "{messages:?}");
    model
}

/// What was found, in words.
#[derive(Default, PartialEq, Debug)]
struct Found {
    unreachable: Vec<String>,
    dead: Vec<String>,
    doubled: Vec<String>,
    deadlocks: Vec<String>,
    stuck: Vec<String>,
}

fn explore(chart: &str) -> Found {
    let model = model(chart);
    let exploration = Exploration::of(&model, &Limits::default());
    let step = |id: StepId| model.steps[id].name.to_string();
    let arc = |id: TransitionId| {
        let t = &model.transitions[id];
        format!("{} -[{}]-> {}", model.steps_text(&t.sources), t.condition.text, model.steps_text(&t.targets))
    };
    Found {
        unreachable: model.steps.ids().filter(|id| !exploration.reachable(*id)).map(step).collect(),
        dead: model.transitions.ids().filter(|id| !exploration.can_clear(*id)).map(arc).collect(),
        doubled: model
            .steps
            .ids()
            .filter_map(|id| exploration.unsafe_step(id))
            .map(|found| format!("{} by {}", found.path.text(&model), arc(found.by)))
            .collect(),
        deadlocks: exploration.deadlocks().iter().map(|found| found.path.text(&model)).collect(),
        stuck: exploration
            .stuck_joins()
            .iter()
            .map(|found| {
                let culprit = found.culprit.map(arc).unwrap_or_default();
                format!(
                    "{} waits in {}: {} left by {culprit}",
                    step(found.waiting),
                    found.path.text(&model),
                    arc(found.join)
                )
            })
            .collect(),
    }
}

#[test]
fn a_circle_is_fine() {
    assert_eq!(explore("sfc C { input a, b: bool; initial step A; step B; A -[a]-> B -[b]-> A; }"), Found::default());
    assert_eq!(
        explore("grafcet C { input a, b: bool; initial step A; step B; A -[a]-> B -[b]-> A; }"),
        Found::default()
    );
}

#[test]
fn probe() {
    for chart in [
        "sfc C { input a, b: bool; initial step A; step B; step Q; step E; step F; A -[a]-> (B, Q); B -[b]-> A; Q -[a]-> E; (B, E) -[b]-> F -[a]-> A; }",
        "sfc C { input a, b: bool; initial step A; step B; step Q; step E; A -[a]-> B; A -[b]-> Q; (B, Q) -[true]-> E -[a]-> A; }",
        "sfc C { input a, b: bool; initial step A; step B; step Q; step E; step F; A -[a]-> (B, Q); B -[b]-> F; Q -[a]-> E; (B, E) -[a]-> F -[a]-> A; }",
        "sfc C { input a, b: bool; initial step A; step B; step Q; A -[a && Q.X]-> B -[b]-> A; B -[a && !b && !Q.X]-> Q; }",
        "grafcet C { input a, b: bool; initial step A; step B; step Q; A -[rising(a)]-> B; A -[falling(a)]-> Q; B -[rising(a)]-> A; Q -[b]-> Q; }",
        "sfc C { input a: bool; var v: bool; initial step A; step B {S v;} step Q {R v;} A -[a]-> B -[!v]-> Q -[v]-> A; }",
        "sfc C { input a: bool; var v: bool; initial step A; step B {S v;} step Q {R v;} A -[a]-> B -[v]-> Q -[!v]-> A; }",
    ] {
        println!("{chart}\n  {:#?}", explore(chart));
    }
}

/// A34: in the actions of the cycle that leaves a step, its time is what it had reached.
#[test]
fn a_step_just_left_keeps_its_time() {
    let found = explore(
        "sfc C { input a, b: bool; var v: bool; initial step S1; step S2; step S3; final step S4; step S5;
         S1 -[!b]-> S2; S1 -[v]-> S4; S2 -[a]-> S3; S3 -[b]-> S5; S5 -[!b]-> S1; step S6 { P1 v = S2.T >= 1m; }
         S2 -[!a && b]-> S6 -[b]-> S1; }",
    );
    assert_eq!(found, Found::default());
}

/// A piece that an order holds in the middle of a search goes on from there: with `budget 20;` no more than the pieces is explored.
#[test]
fn a_piece_is_held_on_its_way() {
    let model = model(
        "grafcet Held { budget 20; input go, back, keep, w1, w2, w3, w4, w5: bool;
           partial Guard { initial step G0; step G1 { force Main {*}; } G0 -[Main::B.X && keep]-> G1 -[back && !keep]-> G0; }
           partial Main { initial step A; step B; step C; step E; A -[go && !back]-> B -[!back]-> C -[!go]-> A; B -[back]-> E -[!back && !go]-> A; }
           partial Wide { initial step W0; step W1; step W2; step W3; step W4; step W5;
             W0 -[w1]-> W1 -[w2]-> W2 -[w3]-> W3 -[w4 && !w1]-> W4 -[w5]-> W5 -[!w5 && w1]-> W0; } }",
    );
    let exploration = Exploration::of(&model, &Limits::situations(20));
    assert!(!exploration.is_complete());
    assert!(model.transitions.ids().all(|id| exploration.can_clear(id)));
}
