//! Conditions that always have the same value, whatever the inputs.

use super::{Condition, Logic};
use crate::list::{List, PushAll};
use crate::model::{AnyId, Binary, Id, Model, Read, StepId, Transition, TransitionId, Tree};
use crate::sorted::Set;

/// The value that a condition always has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Constant {
    Never,
    Always,
}

/// The transitions whose condition is no condition.
#[derive(Default)]
pub(crate) struct Constants {
    /// It never holds.
    pub(crate) never: Set<TransitionId>,
    pub(crate) always: Set<TransitionId>,
    /// It always holds while its sources are active, as it asks for them.
    pub(crate) while_enabled: Set<TransitionId>,
}

impl Constants {
    /// Those of a chart; `conditions` are those of the transitions. An `any` is one transition here: where another `any` comes before it, its conditions differ by the
    /// steps in front of it.
    pub(crate) fn of(model: &Model, logic: &Logic<'_>, conditions: &[Condition]) -> Self {
        let mut found = Self::default();
        let plain = Logic::new(model);
        for ((id, transition), condition) in model.transitions.iter().zip(conditions) {
            if let Some(any) = transition.any {
                if model.anys[any].first == id {
                    found.of_any(model, any, logic, conditions);
                }
                continue;
            }
            match constant(logic, condition, &transition.condition.tree) {
                Some(Constant::Never) => _ = found.never.insert(id),
                Some(Constant::Always) => _ = found.always.insert(id),
                None if holds_while_enabled(&plain, transition) => _ = found.while_enabled.insert(id),
                None => {}
            }
        }
        found
    }

    fn of_any(&mut self, model: &Model, any: AnyId, logic: &Logic<'_>, conditions: &[Condition]) {
        let all = model.transitions.ids().filter(|id| model.transitions[*id].any == Some(any)).list();
        let tree = |id: TransitionId| &model.transitions[id].condition.tree;
        let mut known: Option<(TransitionId, Constant)> = None;
        for id in &all {
            if known.is_some_and(|(before, _)| tree(before) == tree(*id)) {
                continue;
            }
            let Some(value) = constant(logic, &conditions[id.index()], tree(*id)) else { return };
            if known.is_some_and(|(_, before)| before != value) {
                return;
            }
            known = Some((*id, value));
        }
        match known {
            Some((_, Constant::Never)) => self.never.extend(all),
            Some((_, Constant::Always)) => self.always.extend(all),
            None => {}
        }
    }
}

/// The value that a condition always has.
pub(crate) fn constant(logic: &Logic<'_>, condition: &Condition, tree: &Tree) -> Option<Constant> {
    // A name alone can have any value.
    if matches!(tree, Tree::Bool(true) | Tree::Read(Read::Name(_))) {
        return None;
    }
    if logic.never(condition) {
        return Some(Constant::Never);
    }
    logic.always(condition).then_some(Constant::Always)
}

/// Whether a condition holds because it asks for the steps in front of the transition. That another step is not active
/// then, as in `!Other.X`, may be said to be safe.
fn holds_while_enabled(logic: &Logic<'_>, transition: &Transition) -> bool {
    let own = |read: &Read| matches!(read, Read::Active(step) if transition.sources.contains(step));
    if transition.otherwise.is_some() || transition.any.is_some() || !transition.condition.reads.iter().any(own) {
        return false;
    }
    let condition = &logic.condition(&transition.condition.tree);
    let active = |step: &StepId| logic.condition(&Tree::Read(Read::Active(*step)));
    let active: Vec<Condition> = transition.sources.iter().map(active).list();
    let mut goals: Vec<_> = active.iter().map(|source| (source, true)).list();
    if logic.impossible(&goals) {
        return false;
    }
    goals.push((condition, false));
    logic.impossible(&goals)
}

/// Two steps that a condition wants to be active together, and that never are.
pub(crate) fn never_together(logic: &Logic<'_>, tree: &Tree) -> Option<(StepId, StepId)> {
    let mut steps: Vec<StepId> = Vec::new();
    let mut open = vec![tree];
    while let Some(tree) = open.pop() {
        match tree {
            Tree::Binary(Binary::And | Binary::BitAnd, a, b) => open.push_all([&**b, &**a]),
            Tree::Read(Read::Active(step)) => steps.push(*step),
            _ => {}
        }
    }
    let active = |step: &StepId| logic.condition(&Tree::Read(Read::Active(*step)));
    let active: Vec<Condition> = steps.iter().map(active).list();
    let pairs = (0..steps.len()).flat(|a| (a + 1..steps.len()).map(move |b| (a, b)));
    let mut excluded = pairs.filter(|(a, b)| logic.impossible(&[(&active[*a], true), (&active[*b], true)]));
    excluded.next().map(|(a, b)| (steps[a], steps[b]))
}
