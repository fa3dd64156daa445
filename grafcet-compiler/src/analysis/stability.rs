//! Whether every search for stability of a `grafcet` comes to an end (A30).
//!
//! A search without end clears some transitions again and again. Each of them is enabled anew by one that clears
//! before it in the same cycle, so somewhere there is a circle of transitions that all clear on one set of inputs. Two
//! transitions whose conditions exclude each other by what stays constant during a cycle never do. Where no such circle
//! is left, the search ends.

use super::Logic;
use crate::model::{Binary, Id, Model, Name, Qualifier, Read, Tree, Unary};

/// What is known about the end of the search.
pub struct Stability {
    certain: bool,
}

impl Stability {
    /// Looks at the circles of a chart.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let events = model.associations.values().any(|a| a.qualifier == Qualifier::On);
        Self { certain: !events && !has_circle(&follows(model)) }
    }

    /// Every search ends after each transition has cleared at most once.
    #[must_use]
    pub fn is_certain(&self) -> bool {
        self.certain
    }
}

/// Per transition the ones it may enable in the same cycle.
fn follows(model: &Model) -> Vec<Vec<usize>> {
    let logic = Logic::new(model);
    let mut leaving = vec![Vec::new(); model.steps.len()];
    for (id, transition) in model.transitions.iter() {
        transition.sources.iter().for_each(|step| leaving[step.index()].push(id));
    }
    let conditions: Vec<Tree> = model.transitions.values().map(|t| constant_part(&t.condition.tree, true)).collect();
    let structure_changes = !model.forces.is_empty() || model.partials.len() > 1;
    model
        .transitions
        .iter()
        .map(|(id, transition)| {
            if structure_changes {
                // Forcing and enclosing activate steps without a transition of their own.
                return model.transitions.ids().map(Id::index).collect();
            }
            let next = transition.targets.iter().flat_map(|step| &leaving[step.index()]);
            let together = |other: usize| !logic.exclusive(&conditions[id.index()], &conditions[other]);
            next.map(|other| other.index()).filter(|other| together(*other)).collect()
        })
        .collect()
}

/// What a condition demands of the values that stay constant during a cycle: everything else is taken as favourable.
fn constant_part(tree: &Tree, favourable: bool) -> Tree {
    match tree {
        Tree::Bool(_) | Tree::Int(_) => tree.clone(),
        Tree::Unary(Unary::Not, inner) => Tree::Unary(Unary::Not, Box::new(constant_part(inner, !favourable))),
        Tree::Binary(operator @ (Binary::And | Binary::Or), a, b) => {
            Tree::Binary(*operator, Box::new(constant_part(a, favourable)), Box::new(constant_part(b, favourable)))
        }
        other if is_constant(other) => other.clone(),
        _ => Tree::Bool(favourable),
    }
}

fn is_constant(tree: &Tree) -> bool {
    let constant =
        |read: &Read| matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Delay(_) | Read::Ticks(_));
    match tree {
        Tree::Bool(_) | Tree::Int(_) => true,
        Tree::Read(read) => constant(read),
        Tree::Unary(_, inner) => is_constant(inner),
        Tree::Binary(_, a, b) => is_constant(a) && is_constant(b),
        Tree::Opaque { reads, .. } => reads.iter().all(constant),
        Tree::Elapsed(..) | Tree::MacroElapsed(..) => false,
    }
}

/// Depth-first search with an explicit stack: charts may be long.
fn has_circle(follows: &[Vec<usize>]) -> bool {
    const NEW: u8 = 0;
    const OPEN: u8 = 1;
    const DONE: u8 = 2;
    let mut state = vec![NEW; follows.len()];
    for root in 0..follows.len() {
        if state[root] != NEW {
            continue;
        }
        state[root] = OPEN;
        let mut path = vec![(root, 0)];
        while let Some((at, next)) = path.last_mut() {
            let Some(child) = follows[*at].get(*next).copied() else {
                state[*at] = DONE;
                path.pop();
                continue;
            };
            *next += 1;
            match state[child] {
                NEW => {
                    state[child] = OPEN;
                    path.push((child, 0));
                }
                OPEN => return true,
                _ => {}
            }
        }
    }
    false
}
