//! Whether every search for stability of a `grafcet` comes to an end (A30).
//!
//! A search without end clears some transitions again and again. Each of them is enabled anew by one that clears
//! before it in the same cycle, so somewhere there is a circle of transitions that all clear on one set of inputs. Two
//! transitions whose conditions exclude each other by what stays constant during a cycle never do. Where no such circle
//! is left, the search ends.

use std::collections::BTreeMap;

use super::{Condition, Logic};
use crate::model::{Binary, Id, Model, Name, Qualifier, Read, TransitionId, Tree, Unary};

/// What is known about the end of the search.
pub struct Stability {
    certain: bool,
}

impl Stability {
    /// Looks at the circles of a chart.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let events = model.associations.values().any(|a| a.qualifier == Qualifier::On);
        Self { certain: !events && !is_refilled(model) && !has_circle(&mut Follows::new(model)) }
    }

    /// Whether the situation after an evolution follows from the one before it and from what stays constant during a cycle: a
    /// search that comes back to a situation then goes on for ever.
    #[must_use]
    pub fn is_memoryless(model: &Model) -> bool {
        let follows = |read: &Read| is_constant_read(read) || matches!(read, Read::Active(_) | Read::MacroActive(_));
        model.transitions.values().flat_map(|transition| &transition.condition.reads).all(follows)
    }

    /// Every search ends after each transition has cleared at most once.
    #[must_use]
    pub fn is_certain(&self) -> bool {
        self.certain
    }
}

/// Whether a source transition, which nothing has to enable, may go on filling a chart in which what clears depends on what
/// is active or stored: the steps behind it can then turn each other on and off.
fn is_refilled(model: &Model) -> bool {
    let varies = |read: &Read| match read {
        Read::Rising(id) | Read::Falling(id) => model.edges[*id].of.reads.iter().any(|read| !is_constant_read(read)),
        other => !is_constant_read(other),
    };
    let mut transitions = model.transitions.values();
    transitions.any(|transition| transition.sources.is_empty())
        && model.transitions.values().flat_map(|transition| &transition.condition.reads).any(varies)
}

/// Which transitions a transition may enable in the same cycle.
struct Follows<'m> {
    model: &'m Model,
    logic: Logic<'m>,
    leaving: Vec<Vec<TransitionId>>,
    /// By transition, the number of its condition among the different ones.
    condition_of: Vec<usize>,
    conditions: Vec<Condition>,
    /// Whether two conditions can hold together, as far as that was asked.
    together: BTreeMap<(usize, usize), bool>,
}

impl<'m> Follows<'m> {
    fn new(model: &'m Model) -> Self {
        let logic = Logic::new(model);
        let mut leaving = vec![Vec::new(); model.steps.len()];
        for (id, transition) in model.transitions.iter() {
            for step in &transition.sources {
                leaving[step.index()].push(id);
            }
        }
        let mut different: BTreeMap<Tree, usize> = BTreeMap::new();
        let mut conditions = Vec::new();
        let mut condition_of = Vec::new();
        for transition in model.transitions.values() {
            let tree = constant_part(&transition.condition.tree, true);
            let number = *different.entry(tree).or_insert_with_key(|tree| {
                conditions.push(logic.condition(tree));
                conditions.len() - 1
            });
            condition_of.push(number);
        }
        Self { model, logic, leaving, condition_of, conditions, together: BTreeMap::new() }
    }

    fn after(&mut self, id: TransitionId) -> Vec<TransitionId> {
        if !self.model.forces.is_empty() || self.model.partials.len() > 1 {
            // Forcing and enclosing activate steps without a transition of their own.
            return self.model.transitions.ids().collect();
        }
        let next = self.model.transitions[id].targets.iter().flat_map(|step| self.leaving[step.index()].clone());
        next.collect::<Vec<_>>().into_iter().filter(|other| self.can_clear_together(id, *other)).collect()
    }

    fn can_clear_together(&mut self, a: TransitionId, b: TransitionId) -> bool {
        let (a, b) = (self.condition_of[a.index()], self.condition_of[b.index()]);
        let (logic, conditions) = (&self.logic, &self.conditions);
        *self.together.entry((a.min(b), a.max(b))).or_insert_with(|| !logic.exclusive(&conditions[a], &conditions[b]))
    }
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

fn is_constant_read(read: &Read) -> bool {
    matches!(read, Read::Name(Name::Input(_) | Name::Param(_)) | Read::Delay(_) | Read::Ticks(_))
}

fn is_constant(tree: &Tree) -> bool {
    match tree {
        Tree::Bool(_) | Tree::Int(_) => true,
        Tree::Read(read) => is_constant_read(read),
        Tree::Unary(_, inner) => is_constant(inner),
        Tree::Binary(_, a, b) => is_constant(a) && is_constant(b),
        Tree::Opaque { reads, .. } => reads.iter().all(is_constant_read),
        Tree::Elapsed(..) | Tree::MacroElapsed(..) => false,
    }
}

/// Depth-first search with an explicit stack: charts may be long.
fn has_circle(follows: &mut Follows<'_>) -> bool {
    const NEW: u8 = 0;
    const OPEN: u8 = 1;
    const DONE: u8 = 2;
    let mut state = vec![NEW; follows.model.transitions.len()];
    for root in follows.model.transitions.ids() {
        if state[root.index()] != NEW {
            continue;
        }
        state[root.index()] = OPEN;
        let mut path = vec![(root, follows.after(root).into_iter())];
        while let Some((at, next)) = path.last_mut() {
            let Some(child) = next.next() else {
                state[at.index()] = DONE;
                path.pop();
                continue;
            };
            match state[child.index()] {
                NEW => {
                    state[child.index()] = OPEN;
                    path.push((child, follows.after(child).into_iter()));
                }
                OPEN => return true,
                _ => {}
            }
        }
    }
    false
}
