//! What the rules report about a chart beside what happens in it: no fault without a report, no report without a fault.

use std::collections::BTreeSet;

use grafcet_compiler::analysis::explore::{Exploration, Limits};
use grafcet_compiler::diagnostic::rules::ALL;
use grafcet_compiler::model::Model;

use super::compare::Difference;
use super::facts;
use super::graph::Graph;
use super::verdicts::Verdicts;

/// What is reported too much or too little; `exact` as in a [`Comparison`](super::compare::Comparison).
#[must_use]
pub(super) fn check(model: &Model, graph: &Graph, text: &str, exact: bool) -> Vec<Difference> {
    let verdicts = Verdicts::of(model, graph);
    let rules = Rules { reported: super::reported(text), exact };
    let mut wrong = Vec::new();
    let count = model.transitions.len();
    let unreachable = verdicts.reachable.len() < model.steps.len();
    let dead = verdicts.fireable.len() < count;
    let idle = verdicts.cleared.len() < count;
    let grafcet = model.is_grafcet();
    rules.needs(grafcet && !facts::races(model, graph).is_empty(), &["write_race"], &mut wrong);
    rules.needs(grafcet && !verdicts.overlapping.is_empty(), &["overlapping_branches"], &mut wrong);
    rules.speaks_for(&["unreachable_step"], unreachable, &mut wrong);
    rules.speaks_for(&["dead_transition"], dead, &mut wrong);
    rules.speaks_for(&["shadowed_branch"], idle, &mut wrong);
    rules.speaks_for(&["unsafe_step"], !verdicts.unsafe_steps.is_empty(), &mut wrong);
    rules.speaks_for(&["stuck_join"], !verdicts.stuck.is_empty(), &mut wrong);
    rules.speaks_for(&["deadlock"], !verdicts.deadlocks.is_empty(), &mut wrong);
    rules.circles(graph, text, &mut wrong);
    // Where the drawing is wrong, nobody looks at how the chart evolves; an instable one has that to mend first.
    let evolves = ["several_initial_steps", "unstable"].iter().all(|rule| !rules.reported.contains(rule));
    if exact && evolves {
        // What cannot go on or be reached is reported once, by one of the rules about it: behind a branch that always
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
    wrong
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

    /// A30: where every search ends, no circle turns for ever. One that is not proved to turn is not reported, and is no difference.
    fn circles(&self, graph: &Graph, text: &str, wrong: &mut Vec<Difference>) {
        let reported = super::look(text).1.iter().any(|one| one.rule.is_some_and(|rule| rule.name == "unstable"));
        if reported && self.exact && graph.cycles().all(|(_, edge)| edge.stable) {
            wrong.push(Difference {
                kind: "unstable is a false alarm".to_owned(),
                text: format!("{:?}", self.reported),
            });
        }
    }

    /// Rules that report nothing but this fault.
    fn speaks_for(&self, rules: &[&str], fault: bool, wrong: &mut Vec<Difference>) {
        if let Some(rule) = rules.iter().find(|rule| self.exact && !fault && self.reported.contains(*rule)) {
            wrong.push(Difference { kind: format!("{rule} is a false alarm"), text: format!("{:?}", self.reported) });
        }
    }
}
