//! How long a search can be that comes to an end, in a chart with parallel branches or partial grafcets.
//!
//! Conditions that look at nothing a search changes hold throughout it, or not. So what clears in an evolution is a transition of which the evolution before has
//! entered a source step: a search is a path through the chart. Where that comes twice to a step which is active alone, the search goes on for ever, as the
//! situation is the same; and between two of these steps it comes to no step twice, if there is no circle without them.

use crate::analysis::Concurrency;
use crate::analysis::edges::is_edge_of_inputs;
use crate::list::List;
use crate::model::{Id, Model, Qualifier, Read, StepId, TimeRef, Transition};

use super::is_constant_read;

/// The first evolution sees edges, the second one that they are gone.
const BEFORE: usize = 2;

/// The most evolutions of a search that ends; `None` where that is not known.
pub(super) fn longest(model: &Model, concurrency: &Concurrency) -> Option<usize> {
    let is_ruled = !model.forces.is_empty() || model.partials.values().any(|partial| partial.enclosed_by.is_some());
    let on_events = model.associations.values().any(|association| association.qualifier == Qualifier::On);
    // What was forced by hand is no situation that the chart comes to.
    if model.forceable || is_ruled || on_events {
        return None;
    }
    for transition in model.transitions.values() {
        let mut reads = transition.condition.reads.iter();
        if transition.sources.is_empty()
            || transition.any.is_some()
            || !reads.all(|read| holds(model, transition, read))
        {
            return None;
        }
    }
    let paths = Paths::of(model, concurrency)?;
    let (mut between, mut alone) = (0, 0);
    for step in model.steps.ids() {
        if paths.alone[step.index()] {
            alone += paths.from(model, step);
        } else {
            between = between.max(paths.longest[step.index()]);
        }
    }
    Some(BEFORE + between + alone)
}

/// Whether a condition is the same in all evolutions but the first, as long as its transition's source steps are not entered anew.
fn holds(model: &Model, transition: &Transition, read: &Read) -> bool {
    match read {
        Read::Elapsed(TimeRef::Ticks(_) | TimeRef::Param(_), step) | Read::Since(step) => {
            transition.sources.contains(step)
        }
        read => is_constant_read(read) || is_edge_of_inputs(model, read),
    }
}

/// The longest paths that come to no step which is active alone, counted in transitions, the last of which may lead to one.
struct Paths {
    alone: Vec<bool>,
    longest: Vec<usize>,
}

impl Paths {
    /// `None` where there is a circle without such a step.
    fn of(model: &Model, concurrency: &Concurrency) -> Option<Self> {
        // Of a sequence, which may be long, nobody has to know what is connected.
        let is_sequence = model.steps.ids().all(|step| concurrency.beside(step).next().is_none());
        let parts = if is_sequence { vec![0; model.steps.len()] } else { parts(model) };
        let is_alone = |step: StepId| concurrency.beside(step).all(|other| parts[other.index()] != parts[step.index()]);
        let alone: Vec<bool> = model.steps.ids().map(is_alone).list();
        let mut paths = Self { alone, longest: vec![0; model.steps.len()] };
        // After as many rounds as there are steps a path that becomes longer is a circle.
        for _ in 0..=model.steps.len() {
            let mut grows = false;
            for step in model.steps.ids() {
                if !paths.alone[step.index()] {
                    let longest = paths.from(model, step);
                    grows |= longest > paths.longest[step.index()];
                    paths.longest[step.index()] = longest;
                }
            }
            if !grows {
                return Some(paths);
            }
        }
        None
    }

    /// The longest from a step on.
    fn from(&self, model: &Model, step: StepId) -> usize {
        let mut longest = 0;
        for id in &model.leaving[step.index()] {
            let targets = &model.transitions[*id].targets;
            let following = targets.iter().filter(|target| !self.alone[target.index()]);
            longest = longest.max(1 + following.map(|target| self.longest[target.index()]).max().unwrap_or(0));
        }
        longest
    }
}

/// Steps that transitions connect have the same number.
fn parts(model: &Model) -> Vec<usize> {
    let mut parts: Vec<usize> = (0..model.steps.len()).list();
    for transition in model.transitions.values() {
        let mut steps = transition.sources.iter().chain(&transition.targets);
        let Some(first) = steps.next() else { continue };
        for step in steps {
            let (from, to) = (parts[step.index()], parts[first.index()]);
            parts.iter_mut().filter(|part| **part == from).for_each(|part| *part = to);
        }
    }
    parts
}
