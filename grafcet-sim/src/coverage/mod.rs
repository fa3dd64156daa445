//! What runs have covered: steps that were active, transitions that cleared, parts of conditions that decided.

mod report;

use grafcet_compiler::model::{Binary, Model, TransitionId, Tree, Unary};

use crate::blocked::written;
use crate::chart::Chart;
use crate::cycle::Cycle;
use crate::interp::Error;
use crate::names::Names;

/// What runs have covered.
///
/// Of a condition each part at `&&`, `||` and `!` has to decide once as true and once as false: with the other parts as they were, the
/// condition would have had the other value (masking MC/DC).
#[derive(Clone, PartialEq, Debug)]
pub struct Coverage {
    pub(crate) names: Names,
    /// How often each was entered, the start of the chart included.
    steps: Vec<u64>,
    transitions: Vec<Covered>,
    begun: bool,
}

#[derive(Clone, PartialEq, Eq, Debug)]
struct Covered {
    cleared: u64,
    /// Its condition was looked at.
    asked: u64,
    /// The parts that can have two values, in source order.
    parts: Vec<PartCovered>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
struct PartCovered {
    text: String,
    /// How often it decided as true.
    when_true: u64,
    when_false: u64,
}

/// Something that no run has covered.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Missing {
    /// The step of this name was never active.
    Step(String),
    /// The transition of this name never cleared.
    Transition(String),
    /// A part of the condition of this transition never decided with this value.
    Part { transition: String, part: String, value: bool },
}

/// By what a chart can be covered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Criterion {
    /// Each step was active.
    Steps,
    /// Each transition cleared.
    Transitions,
    /// Each part of a condition decided once as true and once as false (masking MC/DC).
    Conditions,
}

impl Coverage {
    /// Nothing of this chart is covered yet.
    #[must_use]
    pub fn of(chart: &Chart) -> Self {
        let (model, names) = (chart.model(), chart.names());
        let mut transitions: Vec<Covered> = Vec::new();
        for (id, transition) in model.transitions.iter() {
            if names.transition(id) == transitions.len() {
                let mut parts = Vec::new();
                each_part(written(transition), &mut |part| {
                    parts.push(PartCovered { text: model.tree_text(part), when_true: 0, when_false: 0 });
                });
                transitions.push(Covered { cleared: 0, asked: 0, parts });
            }
        }
        Self { steps: vec![0; names.steps.len()], transitions, names: names.clone(), begun: false }
    }

    /// A condition is looked at.
    pub(crate) fn asked(&mut self, id: TransitionId, model: &Model, holds: &dyn Fn(&Tree) -> Result<bool, Error>) {
        let condition = written(&model.transitions[id]);
        let mut values = Vec::new();
        each_part(condition, &mut |part| values.push(holds(part).ok()));
        let covered = &mut self.transitions[self.names.transition(id)];
        covered.asked += 1;
        for (index, part) in covered.parts.iter_mut().enumerate() {
            let Some(value) = values[index] else { continue };
            let outcome = |of| {
                let mut values = values.clone();
                values[index] = Some(of);
                of_parts(condition, &mut values.into_iter())
            };
            if let (Some(with), Some(without)) = (outcome(value), outcome(!value)) {
                let decided = if value { &mut part.when_true } else { &mut part.when_false };
                *decided += u64::from(with != without);
            }
        }
    }

    /// A cycle has run.
    pub(crate) fn ran(&mut self, cycle: &Cycle) {
        if !std::mem::replace(&mut self.begun, true) {
            let before = cycle.evolutions.first().map_or(&cycle.steps, |first| &first.steps);
            let entered = cycle.evolutions.first().map_or(&[][..], |first| &first.activated);
            let left = cycle.evolutions.first().map_or(&[][..], |first| &first.deactivated);
            before.iter().filter(|step| !entered.contains(step)).chain(left).for_each(|step| self.steps[*step] += 1);
        }
        for evolution in &cycle.evolutions {
            evolution.activated.iter().for_each(|step| self.steps[*step] += 1);
            evolution.cleared.iter().for_each(|transition| self.transitions[*transition].cleared += 1);
        }
    }

    /// Takes in what another run of the same chart has covered.
    ///
    /// # Panics
    /// It is another chart, or another version of it.
    #[track_caller]
    pub fn add(&mut self, other: &Self) {
        assert!(self.names == other.names, "coverage of two different charts");
        self.steps.iter_mut().zip(&other.steps).for_each(|(a, b)| *a += b);
        for (a, b) in self.transitions.iter_mut().zip(&other.transitions) {
            a.cleared += b.cleared;
            a.asked += b.asked;
            for (a, b) in a.parts.iter_mut().zip(&b.parts) {
                a.when_true += b.when_true;
                a.when_false += b.when_false;
            }
        }
    }

    /// What no run has covered, in source order: steps, transitions, parts of conditions.
    #[must_use]
    pub fn missing(&self) -> Vec<Missing> {
        let steps = self.names.steps.iter().zip(&self.steps).filter(|(_, count)| **count == 0);
        let mut missing: Vec<Missing> = steps.map(|(step, _)| Missing::Step(step.name.clone())).collect();
        let transitions = || self.names.transitions.iter().zip(&self.transitions);
        let never = transitions().filter(|(_, covered)| covered.cleared == 0);
        missing.extend(never.map(|(transition, _)| Missing::Transition(transition.name.clone())));
        for (transition, covered) in transitions() {
            for part in &covered.parts {
                for (value, count) in [(true, part.when_true), (false, part.when_false)] {
                    if count == 0 {
                        let (transition, part) = (transition.name.clone(), part.text.clone());
                        missing.push(Missing::Part { transition, part, value });
                    }
                }
            }
        }
        missing
    }

    /// How often each step was entered, by its place in [`Names::steps`].
    #[must_use]
    pub fn entered(&self) -> &[u64] {
        &self.steps
    }

    /// How often each transition cleared, by its place in [`Names::transitions`].
    #[must_use]
    pub fn cleared(&self) -> Vec<u64> {
        self.transitions.iter().map(|covered| covered.cleared).collect()
    }
}

/// Calls `f` with the parts of a condition that can have two values.
fn each_part(tree: &Tree, f: &mut dyn FnMut(&Tree)) {
    match tree {
        Tree::Bool(_) => {}
        Tree::Unary(Unary::Not, inner) => each_part(inner, f),
        Tree::Binary(Binary::And | Binary::Or, a, b) => {
            each_part(a, f);
            each_part(b, f);
        }
        part => f(part),
    }
}

/// The value of a condition whose parts have these values; a part without one would panic in Rust.
fn of_parts(tree: &Tree, values: &mut std::vec::IntoIter<Option<bool>>) -> Option<bool> {
    match tree {
        Tree::Bool(value) => Some(*value),
        Tree::Unary(Unary::Not, inner) => of_parts(inner, values).map(|value| !value),
        Tree::Binary(operator @ (Binary::And | Binary::Or), a, b) => {
            // Both use up their parts, whatever is lazy in Rust.
            let (a, b) = (of_parts(a, values), of_parts(b, values));
            let decisive = *operator == Binary::Or;
            if a? == decisive { Some(decisive) } else { b }
        }
        _ => values.next().flatten(),
    }
}
