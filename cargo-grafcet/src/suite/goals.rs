//! What a test suite has to show.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::model::{Id, Model, StepId, Tree};
use grafcet_sim::{Blocked, Chart, Cycle, Names, Why};

/// Transitions by their places in [`Names::transitions`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Goal {
    /// The transition clears.
    Cleared(usize),
    /// Its steps are active in a cycle, and it does not clear.
    Waited(usize),
    /// The second one clears, and what it leaves the first one has entered.
    Pair(usize, usize),
}

impl Goal {
    pub(crate) fn text(self, names: &Names) -> String {
        let name = |place: usize| &names.transitions[place].name;
        match self {
            Self::Cleared(one) => format!("`{}` clears", name(one)),
            Self::Waited(one) => format!("`{}` does not clear although its steps are active", name(one)),
            Self::Pair(first, second) => format!("`{}`, and then `{}`", name(first), name(second)),
        }
    }
}

/// By transition the steps at both its ends.
pub(crate) struct Ends {
    from: Vec<Vec<usize>>,
    to: Vec<Vec<usize>>,
    /// The condition always holds: there is no other way.
    always: Vec<bool>,
}

/// By step the transition that has entered it last.
pub(crate) type Entered = BTreeMap<usize, usize>;

impl Ends {
    pub(crate) fn of(model: &Model) -> Self {
        let numbers = |steps: &[StepId]| steps.iter().map(|step| step.index()).collect();
        let drawn = || model.drawn_transitions().map(|(_, one)| one);
        let from = drawn().map(|one| numbers(one.any.map_or(&one.sources, |any| &model.anys[any].sources)));
        let always = drawn().map(|one| one.condition.tree == Tree::Bool(true)).collect();
        Self { from: from.collect(), to: drawn().map(|one| numbers(&one.targets)).collect(), always }
    }

    /// Whose conditions count with that of a transition: those that leave one of its steps, and where evolutions follow in the same cycle, those that
    /// leave what it enters.
    pub(crate) fn beside(&self, one: usize, is_grafcet: bool) -> impl Iterator<Item = usize> {
        let both = |a: &[usize], b: &[usize]| a.iter().any(|step| b.contains(step));
        (0..self.from.len()).filter(move |other| {
            let from = &self.from[*other];
            *other != one && (both(&self.from[one], from) || is_grafcet && both(&self.to[one], from))
        })
    }

    /// All there is to show of a chart.
    pub(crate) fn goals(&self, chart: &Chart, pairs: bool) -> BTreeSet<Goal> {
        let all = 0..chart.names().transitions.len();
        let mut goals: BTreeSet<Goal> = all.clone().map(Goal::Cleared).collect();
        goals.extend(all.clone().filter(|one| !self.always[*one]).map(Goal::Waited));
        let follows = |first: usize, second: usize| self.to[first].iter().any(|step| self.from[second].contains(step));
        if pairs {
            let both = all.clone().flat_map(|first| all.clone().map(move |second| (first, second)));
            goals.extend(both.filter(|(a, b)| follows(*a, *b)).map(|(a, b)| Goal::Pair(a, b)));
        }
        goals
    }

    /// What a cycle has shown, after one that ended with `before`, which the first one has not: it waits for nothing. `entered` is brought up to date.
    pub(crate) fn shown(&self, before: Option<&Blocked>, cycle: &Cycle, entered: &mut Entered) -> BTreeSet<Goal> {
        let mut shown = BTreeSet::new();
        let cleared: Vec<usize> = cycle.cleared().collect();
        let waited = before.into_iter().flat_map(|before| &before.waiting);
        let waited = waited.filter(|one| !matches!(one.why, Why::Frozen(_)) && !cleared.contains(&one.transition));
        shown.extend(waited.map(|one| Goal::Waited(one.transition)));
        for evolution in &cycle.evolutions {
            for one in &evolution.cleared {
                shown.insert(Goal::Cleared(*one));
                let first = self.from[*one].iter().filter(|step| evolution.deactivated.contains(step));
                let first = first.filter_map(|step| entered.get(step));
                shown.extend(first.map(|first| Goal::Pair(*first, *one)));
            }
            evolution.deactivated.iter().for_each(|step| _ = entered.remove(step));
            for one in &evolution.cleared {
                entered.extend(self.to[*one].iter().map(|step| (*step, *one)));
            }
        }
        shown
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use grafcet_sim::{Chart, Simulation};

    use super::{Ends, Entered, Goal};

    #[test]
    fn what_is_forced_is_entered_by_no_transition() {
        let chart = Chart::parse(
            "grafcet C { input a, b, c: bool;
               partial One { initial step A; step B { force Two {V}; } A -[a]-> B -[!a]-> A; }
               partial Two { initial step V; step Y; V -[b]-> Y -[c]-> V; } }",
        )
        .unwrap_or_else(|refused| panic!("{refused}"));
        let ends = Ends::of(chart.model());
        let mut simulation = Simulation::new(&chart).expect("understood");
        let (mut entered, mut pairs) = (Entered::new(), Vec::new());
        // Transitions are numbered in the order of the source: `V → Y` is 2, `Y → V` is 3.
        let cycles = ["", "b", "c", "b", "a", "", "b"];
        for inputs in cycles {
            let set = ["a", "b", "c"].map(|name| (name, inputs.contains(name).into()));
            let cycle = simulation.cycle(0, &set).expect("understood");
            let shown = ends.shown(None, &cycle, &mut entered);
            pairs.push(shown.into_iter().filter(|goal| matches!(goal, Goal::Pair(..))).collect::<BTreeSet<_>>());
        }
        let only = |goals: &[Goal]| goals.iter().copied().collect::<BTreeSet<_>>();
        assert_eq!(pairs[2..4], [only(&[Goal::Pair(2, 3)]), only(&[Goal::Pair(3, 2)])]);
        // Now `V` is active by force.
        assert_eq!(pairs[5..], [only(&[Goal::Pair(0, 1)]), only(&[])]);
    }
}
