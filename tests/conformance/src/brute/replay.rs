//! The ways that the checker shows must exist, and be the shortest.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::analysis::explore::{Demand, Exploration, Given, Path, PathCycle};
use grafcet_compiler::model::{Id, Model, Name, Read, StepId, TransitionId, Tree};
use grafcet_sim::interp::{Evolution, Value};

use super::compare::Difference;
use super::graph::{Edge, Graph};
use super::verdicts::activated_while_active;

const NOT_SHORTEST: &str = "not the shortest way";

/// What is wrong with the ways of an exploration.
#[must_use]
pub(super) fn check(model: &Model, graph: &Graph, explored: &Exploration) -> Vec<Difference> {
    let depths = graph.depths();
    let mut wrong = Vec::new();
    let activates_again = |evolution: &Evolution, step| activated_while_active(evolution, model).contains(&step);
    for step in model.steps.ids() {
        let Some(activation) = explored.unsafe_step(step) else { continue };
        let name = &model.steps[step].name;
        // The way may end in the middle of a cycle, after the evolution that activates the step.
        let activates = |edge: &Edge, end: &PathCycle| {
            let mut entered = false;
            starts_with(edge.done(model), &end.cleared, &mut |evolution| entered |= activates_again(evolution, step))
                && entered
        };
        let entered = |edge: &Edge| edge.done(model).iter().any(|evolution| activates_again(evolution, step));
        let shortest = graph.cycles().filter(|(_, edge)| entered(edge)).map(|(from, _)| depths[&from] + 1).min();
        let found = way(model, graph, &activation.path, activates);
        wrong.extend(judge(&format!("{name} unsafe"), model, &activation.path, found, shortest));
    }
    for deadlock in explored.deadlocks() {
        let steps: BTreeSet<StepId> = deadlock.steps.iter().copied().collect();
        let found = way(model, graph, &deadlock.path, |edge, end| {
            like(model, graph, edge, end) && steps.is_subset(&graph.states[edge.to].situation)
        });
        wrong.extend(judge(&format!("deadlock in {:?}", names(model, &steps)), model, &deadlock.path, found, None));
    }
    wrong
}

/// The same where the ways need not be the shortest.
#[must_use]
pub(super) fn real(model: &Model, graph: &Graph, explored: &Exploration) -> Vec<Difference> {
    check(model, graph, explored).into_iter().filter(|difference| difference.kind != NOT_SHORTEST).collect()
}

/// What is wrong with a way to the end of a cycle.
pub(super) fn leads(
    model: &Model,
    graph: &Graph,
    path: &Path,
    what: &str,
    end: impl Fn(&Edge) -> bool,
) -> Option<Difference> {
    let found = way(model, graph, path, |edge, cycle| like(model, graph, edge, cycle) && end(edge));
    judge(what, model, path, found, None)
}

fn judge(what: &str, model: &Model, path: &Path, found: bool, shortest: Option<usize>) -> Option<Difference> {
    let shown = || {
        let cycle = |cycle: &PathCycle| {
            let given: Vec<String> = cycle.given.iter().map(|given| given.text(model)).collect();
            let cleared: Vec<String> = cycle.cleared.iter().map(|id| arrow(model, *id)).collect();
            let active = cycle.active.iter().copied().collect();
            format!("\n    {} | {} | {:?}", given.join(", "), cleared.join("; "), names(model, &active))
        };
        path.cycles.iter().map(cycle).collect::<String>()
    };
    if !found {
        return Some(Difference { kind: "no such way".to_owned(), text: format!("{what}{}", shown()) });
    }
    let length = path.cycles.len();
    match shortest {
        // The first cycle is left out where nothing happens in it.
        Some(shortest) if shortest != length && shortest != length + 1 => {
            let text = format!("{what}: {length} cycles, the shortest {shortest} with the first{}", shown());
            Some(Difference { kind: NOT_SHORTEST.to_owned(), text })
        }
        _ => None,
    }
}

/// Whether a way exists: from the start, or from what can be there after the first cycle.
fn way(model: &Model, graph: &Graph, path: &Path, last: impl Fn(&Edge, &PathCycle) -> bool) -> bool {
    let Some((end, before)) = path.cycles.split_last() else { return true };
    let afterwards = graph.states[0].cycles.iter().map(|edge| edge.to).collect();
    [BTreeSet::from([0]), afterwards].into_iter().any(|start: BTreeSet<usize>| {
        let mut here = start;
        for cycle in before {
            let edges = here.iter().flat_map(|state| given(graph, *state, cycle));
            here = edges.filter(|edge| like(model, graph, edge, cycle)).map(|edge| edge.to).collect();
        }
        here.iter().flat_map(|state| given(graph, *state, end)).any(|edge| last(edge, end))
    })
}

/// The cycles from a state whose inputs are as a cycle of a way demands.
fn given<'g>(graph: &'g Graph, state: usize, cycle: &PathCycle) -> impl Iterator<Item = &'g Edge> {
    let inputs = |edge: &Edge| &graph.valuations[edge.valuation];
    graph.states[state].cycles.iter().filter(move |edge| cycle.given.iter().all(|given| holds(given, inputs(edge))))
}

/// Whether a cycle clears what a cycle of a way does, and ends in the same situation.
fn like(model: &Model, graph: &Graph, edge: &Edge, cycle: &PathCycle) -> bool {
    let active: BTreeSet<StepId> = cycle.active.iter().copied().collect();
    let mut count = 0;
    let cleared = starts_with(edge.done(model), &cycle.cleared, &mut |_| count += 1);
    // What a self-loop clears in the last evolution, that changes nothing, may be left out.
    let rest = &edge.done(model)[count..];
    let idle = |evolution: &Evolution| evolution.cleared.is_empty() || evolution.before == evolution.after;
    cleared && rest.iter().all(idle) && active == graph.states[edge.to].situation
}

/// Whether the first evolutions clear exactly these transitions; `seen` gets those evolutions one by one.
fn starts_with(evolutions: &[Evolution], cleared: &[TransitionId], seen: &mut impl FnMut(&Evolution)) -> bool {
    let mut rest = cleared;
    for evolution in evolutions {
        if rest.is_empty() {
            break;
        }
        let count = evolution.cleared.len();
        if count > rest.len() || rest[..count].iter().copied().collect::<BTreeSet<_>>() != evolution.cleared {
            return false;
        }
        rest = &rest[count..];
        seen(evolution);
    }
    rest.is_empty()
}

/// Whether inputs are as demanded; what is demanded of anything else is not looked at.
fn holds(given: &Given, inputs: &[Value]) -> bool {
    let Tree::Read(Read::Name(Name::Input(id))) = given.what else { return true };
    match (inputs[id.index()], given.demand) {
        (Value::Bool(value), Demand::Is(wanted)) => value == wanted,
        (Value::Int(value), Demand::Within(low, high)) => {
            low.is_none_or(|low| low <= value) && high.is_none_or(|high| value <= high)
        }
        _ => false,
    }
}

/// `A, B -[x]-> C`
#[must_use]
pub(super) fn arrow(model: &Model, id: TransitionId) -> String {
    let transition = &model.transitions[id];
    let list = |steps: &[StepId]| {
        let names: Vec<String> = steps.iter().map(|step| model.steps[*step].name.to_string()).collect();
        names.join(", ")
    };
    format!("{} -[{}]-> {}", list(&transition.sources), transition.condition.text, list(&transition.targets))
}

/// The names of steps.
#[must_use]
pub(super) fn names(model: &Model, steps: &BTreeSet<StepId>) -> Vec<String> {
    steps.iter().map(|step| model.steps[*step].name.to_string()).collect()
}

impl Graph {
    /// How many cycles it takes to come to each state.
    #[must_use]
    pub fn depths(&self) -> BTreeMap<usize, usize> {
        let mut depths = BTreeMap::from([(0, 0)]);
        // The states are numbered as they were found, breadth first.
        for (from, edge) in self.cycles() {
            let depth = depths[&from] + 1;
            depths.entry(edge.to).or_insert(depth);
        }
        depths
    }
}
