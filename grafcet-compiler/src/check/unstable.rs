//! `unstable`: a circle that turns without end once it is entered (A30).
//!
//! Such a circle is found among the transitions that lead from one step to one and whose conditions look at nothing but
//! inputs and params: if the conditions that are not always true are all equivalent, one of them being true makes all of
//! them true, and nothing changes that during the cycle. Any other circle needs inputs that coincide.

use std::collections::BTreeMap;

use crate::analysis::Logic;
use crate::diagnostic::{Sink, rules};
use crate::model::{Id, Model, Name, Read, StepId, TransitionId, Tree};

pub(super) fn check(model: &Model, sink: &mut Sink) {
    let logic = Logic::new(model);
    let mut always: Vec<TransitionId> = Vec::new();
    let mut alike: BTreeMap<Vec<Read>, Vec<TransitionId>> = BTreeMap::new();
    for (id, transition) in model.transitions.iter() {
        let plain = transition.sources.len() == 1 && transition.targets.len() == 1;
        if !plain || transition.sources == transition.targets || !is_constant(&transition.condition.reads) {
            continue;
        }
        if transition.condition.tree == Tree::Bool(true) {
            always.push(id);
        } else if !logic.never(&logic.condition(&transition.condition.tree)) {
            let mut reads = transition.condition.reads.clone();
            reads.sort_unstable();
            alike.entry(reads).or_default().push(id);
        }
    }
    report(model, circle(model, &always), sink);
    for candidates in alike.values() {
        for class in classes(model, &logic, candidates) {
            let edges: Vec<_> = class.iter().chain(&always).copied().collect();
            let found = circle(model, &edges).filter(|found| found.iter().any(|id| class.contains(id)));
            report(model, found, sink);
        }
    }
}

/// Whether a condition keeps its value during a cycle.
fn is_constant(reads: &[Read]) -> bool {
    reads.iter().all(|read| matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Ticks(_)))
}

/// Transitions with equivalent conditions.
fn classes(model: &Model, logic: &Logic<'_>, candidates: &[TransitionId]) -> Vec<Vec<TransitionId>> {
    let mut classes: Vec<Vec<TransitionId>> = Vec::new();
    for id in candidates {
        let condition = &model.transitions[*id].condition.tree;
        let same = |class: &&mut Vec<TransitionId>| {
            let condition = logic.condition(condition);
            let first = class.first().map(|first| logic.condition(&model.transitions[*first].condition.tree));
            first.is_some_and(|first| logic.equivalent(&first, &condition))
        };
        match classes.iter_mut().find(same) {
            Some(class) => class.push(*id),
            None => classes.push(vec![*id]),
        }
    }
    classes
}

/// The transitions of a circle among `edges`, in its direction.
fn circle(model: &Model, edges: &[TransitionId]) -> Option<Vec<TransitionId>> {
    let mut leaving: BTreeMap<StepId, Vec<TransitionId>> = BTreeMap::new();
    for id in edges {
        leaving.entry(model.transitions[*id].sources[0]).or_default().push(*id);
    }
    let mut done = vec![false; model.steps.len()];
    for root in leaving.keys() {
        let mut path: Vec<(StepId, usize, Option<TransitionId>)> = vec![(*root, 0, None)];
        while let Some((step, next, _)) = path.last_mut() {
            let Some(id) = leaving.get(step).and_then(|ids| ids.get(*next)).copied() else {
                done[step.index()] = true;
                path.pop();
                continue;
            };
            *next += 1;
            let target = model.transitions[id].targets[0];
            if let Some(start) = path.iter().position(|(step, ..)| *step == target) {
                let inner = path[start + 1..].iter().filter_map(|(_, _, by)| *by);
                return Some(inner.chain([id]).collect());
            }
            if !done[target.index()] {
                path.push((target, 0, Some(id)));
            }
        }
    }
    None
}

fn report(model: &Model, circle: Option<Vec<TransitionId>>, sink: &mut Sink) {
    let Some(circle) = circle else { return };
    let names: Vec<_> =
        circle.iter().map(|id| model.steps[model.transitions[*id].sources[0]].name.to_string()).collect();
    let first = names.first().cloned().unwrap_or_default();
    let message = format!(
        "the circle `{} → {first}` never comes to rest: once one of its transitions clears, all of them do, again and \
         again in the same cycle; let one wait for something else, e.g. for an edge: `rising(…)`",
        names.join(" → ")
    );
    let notes = circle.iter().map(|id| (model.transitions[*id].mark, message.clone())).collect();
    sink.rule(&rules::UNSTABLE, &[], notes);
}
