//! What the rules report about a chart beside what happens in it: no fault without a report, no report without a fault.

use std::collections::BTreeSet;

use grafcet_compiler::analysis::explore::{Exploration, Limits};
use grafcet_compiler::diagnostic::rules::ALL;
use grafcet_compiler::model::{Model, Transition, TransitionId};

use super::compare::Difference;
use super::graph::Graph;
use super::verdicts::Verdicts;
use super::{circles, facts, replay};

/// What is reported too much or too little; `exact` as in a [`Comparison`](super::compare::Comparison).
///
/// # Errors
/// The interpreter does not understand the chart.
pub(super) fn check(model: &Model, graph: &Graph, text: &str, exact: bool) -> Result<Vec<Difference>, String> {
    let verdicts = Verdicts::of(model, graph);
    let rules = Rules { reported: super::reported(text), exact };
    let mut wrong = Vec::new();
    let unreachable = verdicts.reachable.len() < model.steps.len();
    let dead = is_any_missing(model, &verdicts.fireable);
    let idle = is_any_missing(model, &verdicts.cleared);
    let grafcet = model.is_grafcet();
    rules.needs(grafcet && !facts::races(model, graph).is_empty(), &["write_race"], &mut wrong);
    rules.needs(grafcet && !verdicts.overlapping.is_empty(), &["overlapping_branches"], &mut wrong);
    rules.speaks_for(&["unreachable_step"], unreachable, &mut wrong);
    rules.speaks_for(&["dead_transition"], dead, &mut wrong);
    rules.speaks_for(&["shadowed_branch"], idle, &mut wrong);
    // Searches that turn until the bound can take more than the budget: then single partial grafcets are looked at, each as if
    // the others could be in any step. The circles are to be mended first.
    let assumed: Vec<_> = model.assumptions.iter().map(|assumption| &assumption.never.tree).collect();
    let complete = || Exploration::assuming(model, &Limits::default(), &[], &assumed).is_complete();
    let excused = rules.reported.contains("unstable") && !complete();
    rules.speaks_for(&["unsafe_step"], excused || !verdicts.unsafe_steps.is_empty(), &mut wrong);
    rules.speaks_for(&["stuck_join"], !verdicts.stuck.is_empty(), &mut wrong);
    rules.speaks_for(&["deadlock"], !verdicts.deadlocks.is_empty(), &mut wrong);
    rules.circles(model, graph, text, &mut wrong)?;
    // Where the drawing is wrong, nobody looks at how the chart evolves; an instable one has that to mend first.
    let evolves = ["several_initial_steps", "unstable"].iter().all(|rule| !rules.reported.contains(rule));
    if exact && evolves {
        // What cannot go on or be reached is reported once, by one of the rules about it: after a branch that always
        // holds that is `always_true`.
        let dead_ends = [
            "never_true",
            "always_true",
            "shadowed_branch",
            "unreachable_step",
            "dead_transition",
            "stuck_join",
            "deadlock",
        ];
        let ends = unreachable || dead || !verdicts.deadlocks.is_empty();
        // A chart with unsafe steps can have more situations than are looked at by default; these are to be mended first.
        let seen = !rules.reported.contains("unsafe_step") || Exploration::of(model, &Limits::default()).is_complete();
        rules.needs(ends && seen, &dead_ends, &mut wrong);
        // A source transition is meant to bring one token after the other.
        let sources = model.transitions.values().all(|transition| !transition.sources.is_empty());
        rules.needs(sources && !verdicts.unsafe_steps.is_empty(), &["unsafe_step"], &mut wrong);
    }
    Ok(wrong)
}

/// Whether a transition is not among these, and no other for which the same `any` stands.
fn is_any_missing(model: &Model, among: &BTreeSet<TransitionId>) -> bool {
    let anys: BTreeSet<_> = among.iter().filter_map(|id| model.transitions[*id].any).collect();
    let missing = |(id, transition): (TransitionId, &Transition)| {
        !among.contains(&id) && transition.any.is_none_or(|any| !anys.contains(&any))
    };
    model.transitions.iter().any(missing)
}

struct Rules {
    reported: BTreeSet<&'static str>,
    exact: bool,
}

impl Rules {
    /// A fault that one of these rules has to report.
    fn needs(&self, fault: bool, rules: &[&str], wrong: &mut Vec<Difference>) {
        let known = rules.iter().all(|rule| ALL.iter().any(|known| known.name == *rule));
        if fault && known && !rules.iter().any(|rule| self.reported.contains(rule)) {
            wrong.push(Difference {
                kind: format!("{} missed", rules.join(" or ")),
                text: format!("{:?}", self.reported),
            });
        }
    }

    /// A30: a circle that turns for ever whenever it is entered is reported, and no other.
    fn circles(&self, model: &Model, graph: &Graph, text: &str, wrong: &mut Vec<Difference>) -> Result<(), String> {
        let reported = super::look(text).1.iter().any(|one| one.rule.is_some_and(|rule| rule.name == "unstable"));
        // With times brute force sees some of the ways by which a circle can be entered.
        if !model.is_grafcet() || !self.exact || !reported && graph.cycles().all(|(_, edge)| edge.stable) {
            return Ok(());
        }
        let Some(certain) = circles::certain(model, graph)? else { return Ok(()) };
        if reported == certain.is_empty() {
            let kind = if reported { "unstable is a false alarm" } else { "unstable missed" };
            let arrows = certain.iter().flatten().map(|id| replay::arrow(model, *id)).collect::<Vec<_>>();
            wrong.push(Difference { kind: kind.to_owned(), text: arrows.join("; ") });
        }
        Ok(())
    }

    /// Rules that report nothing but this fault.
    fn speaks_for(&self, rules: &[&str], fault: bool, wrong: &mut Vec<Difference>) {
        if let Some(rule) = rules.iter().find(|rule| self.exact && !fault && self.reported.contains(*rule)) {
            wrong.push(Difference { kind: format!("{rule} is a false alarm"), text: format!("{:?}", self.reported) });
        }
    }
}
