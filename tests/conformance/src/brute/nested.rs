//! What is decided by reduction, beside what happens.

use std::collections::BTreeSet;

use grafcet_compiler::analysis::{Concurrency, Nesting};
use grafcet_compiler::model::{Model, Tree};

use super::compare::Difference;
use super::graph::Graph;
use super::replay;
use super::verdicts::Verdicts;

/// The differences, how many ways back were proved, and of how many charts the structure told all.
pub(super) fn check(
    model: &Model,
    graph: &Graph,
    verdicts: &Verdicts,
    never: &[&Tree],
) -> (Vec<Difference>, [usize; 2]) {
    let mut differences = Vec::new();
    let mut differ = |kind: &str, text: String| differences.push(Difference { kind: format!("nested: {kind}"), text });
    let Some(nesting) = Nesting::of(model) else { return (differences, [0; 2]) };
    let mut proved = 0;
    for step in model.steps.ids().filter(|step| nesting.returns_to(model, &[*step], never)) {
        proved += 1;
        if graph.can_miss(model, &BTreeSet::from([step])) {
            differ("home", model.steps[step].name.to_string());
        }
    }
    if !nesting.tells_all(model, never) {
        return (differences, [proved, 0]);
    }
    let situations: BTreeSet<_> = graph.states.iter().map(|state| state.situation.clone()).collect();
    // One of them may be that before the first cycle.
    if nesting.situations() + 1 < situations.len() as u64 {
        differ("situations", format!("{} by brute force, {} by the structure", situations.len(), nesting.situations()));
    }
    for (what, is_empty) in [
        ("unsafe", verdicts.unsafe_steps.is_empty()),
        ("deadlock", verdicts.deadlocks.is_empty()),
        ("stuck", verdicts.stuck.is_empty()),
    ] {
        if !is_empty {
            differ(what, "not found by the structure".to_owned());
        }
    }
    if let Some(step) = model.steps.ids().find(|step| !verdicts.reachable.contains(step)) {
        differ("reachable", model.steps[step].name.to_string());
    }
    if let Some(arc) = model.transitions.ids().find(|arc| !verdicts.fireable.contains(arc)) {
        differ("can clear", replay::arrow(model, arc));
    }
    let concurrency = Concurrency::of(model);
    for a in model.steps.ids() {
        for b in model.steps.ids().filter(|b| a < *b) {
            if concurrency.together(a, b) != verdicts.together.contains(&(a, b)) {
                differ("together", format!("{}, {}", model.steps[a].name, model.steps[b].name));
            }
        }
    }
    (differences, [proved, 1])
}
