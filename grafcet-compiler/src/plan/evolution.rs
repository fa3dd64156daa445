//! How one evolution is computed: which transitions are looked at together, and where.

use crate::analysis::Facts;
use crate::list::List;
use crate::model::{Id, Model, PartialId, StepId, TransitionId};
use crate::sorted::Set;

/// The order and grouping of the transitions.
pub struct Evolution {
    /// The partial grafcets, from top to bottom.
    pub partials: Vec<PartialId>,
    /// Per step, the transitions that are looked at when it is active, in source order: each transition stands at its
    /// first source step, but for those in `contests`.
    pub owned: Vec<Vec<TransitionId>>,
    /// Per step, whether at most one of its transitions can clear at a time: by priority in an `sfc`, by their
    /// conditions in a `grafcet`.
    pub exclusive: Vec<bool>,
    /// `sfc`: transitions that compete for source steps of an AND-convergence, in source order (A28).
    pub contests: Vec<Vec<TransitionId>>,
    /// Steps that may be activated and left in the same evolution: they are entered after everything else.
    pub entered_last: Set<StepId>,
}

impl Evolution {
    pub(super) fn of(model: &Model, facts: &Facts<'_>) -> Self {
        let contests = if model.is_grafcet() { Vec::new() } else { contests(model) };
        let contested: Set<TransitionId> = contests.iter().flatten().copied().collect();
        let mut owned = vec![Vec::new(); model.steps.len()];
        for (id, transition) in model.transitions.iter().filter(|(id, _)| !contested.contains(id)) {
            if let Some(first) = transition.sources.first() {
                owned[first.index()].push(id);
            }
        }
        let exclusive = facts.exclusive(model).to_vec();
        let entered_last = facts.left_and_entered(model).clone();
        Self { partials: facts.top_down.clone(), owned, exclusive, contests, entered_last }
    }
}

/// Groups of transitions that share source steps, where one of them has several.
fn contests(model: &Model) -> Vec<Vec<TransitionId>> {
    let mut group: Vec<usize> = (0..model.transitions.len()).list();
    let mut first_of_step: Vec<Option<usize>> = vec![None; model.steps.len()];
    for (id, transition) in model.transitions.iter() {
        for step in &transition.sources {
            match first_of_step[step.index()] {
                None => first_of_step[step.index()] = Some(id.index()),
                Some(other) => {
                    let (a, b) = (root(&group, id.index()), root(&group, other));
                    group[a.max(b)] = a.min(b);
                }
            }
        }
    }
    let mut groups: Vec<Vec<TransitionId>> = vec![Vec::new(); model.transitions.len()];
    for id in model.transitions.ids() {
        groups[root(&group, id.index())].push(id);
    }
    let contest =
        |ids: &Vec<TransitionId>| ids.len() > 1 && ids.iter().any(|id| model.transitions[*id].sources.len() > 1);
    groups.into_iter().filter(contest).list()
}

fn root(group: &[usize], mut item: usize) -> usize {
    while group[item] != item {
        item = group[item];
    }
    item
}
