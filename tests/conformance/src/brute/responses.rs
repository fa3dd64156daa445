//! Properties over more than one cycle, on the graph of all cycles: what has been seen is a part of the state.

use std::collections::{BTreeMap, VecDeque};

use grafcet_compiler::model::{Claim, Expr, Model, Tree};

use super::graph::{Edge, Graph, LEAP, passes};

/// Whether a property over more than one cycle is broken.
pub(crate) enum Broken {
    /// After so many cycles at least.
    In(usize),
    /// Something never comes.
    Endless,
}

/// How a property is broken, if it is; none for one about single cycles.
///
/// # Errors
/// The interpreter does not understand it.
pub(crate) fn broken(model: &Model, graph: &Graph, claim: &Claim) -> Result<Option<Broken>, String> {
    match claim {
        Claim::LeadsTo { from, to, within: None } => {
            let edges = Edges::of(model, graph, &from.tree, &to.tree)?;
            Ok(edges.endless(model, graph)?.then_some(Broken::Endless))
        }
        Claim::LeadsTo { from, to, within: Some(ticks) } => {
            let edges = Edges::of(model, graph, &from.tree, &to.tree)?;
            let late = |since: Option<u32>, from: bool, to: bool, elapsed: u32| {
                let passed = since.map(|since| since.saturating_add(elapsed).min(*ticks));
                let next = if to { None } else { passed.or(from.then_some(0)) };
                (next, !to && passed == Some(*ticks))
            };
            Ok(edges.shortest(graph, None, late).map(Broken::In))
        }
        Claim::Before { first, then } => {
            let edges = Edges::of(model, graph, &first.tree, &then.tree)?;
            let early = |seen: bool, first: bool, then: bool, _| (seen || first, then && !seen && !first);
            Ok(edges.shortest(graph, false, early).map(Broken::In))
        }
        Claim::Never(_) | Claim::Always { .. } | Claim::Home(..) => Ok(None),
    }
}

/// By state and cycle, two conditions at its end.
pub(super) struct Edges(Vec<Vec<(bool, bool)>>);

/// How much time passes before a cycle: the graph has each valuation without time first, then with a leap.
fn elapsed(graph: &Graph, index: usize) -> u32 {
    if index < graph.valuations.len() { 0 } else { LEAP }
}

impl Edges {
    pub(super) fn of(model: &Model, graph: &Graph, one: &Tree, other: &Tree) -> Result<Self, String> {
        let both = |edge: &Edge| Ok((graph.holds(model, edge, one)?, graph.holds(model, edge, other)?));
        let of_state = |edges: &Vec<Edge>| edges.iter().map(both).collect::<Result<_, String>>();
        Ok(Self(graph.states.iter().map(|state| of_state(&state.cycles)).collect::<Result<_, _>>()?))
    }

    /// After how many cycles `next` says first that it is broken.
    pub(super) fn shortest<S: Ord + Copy>(
        &self,
        graph: &Graph,
        start: S,
        next: impl Fn(S, bool, bool, u32) -> (S, bool),
    ) -> Option<usize> {
        let mut known = BTreeMap::from([((0, start), 0)]);
        let mut queue = VecDeque::from([(0, start)]);
        while let Some((state, seen)) = queue.pop_front() {
            let depth = known[&(state, seen)] + 1;
            for (index, edge) in graph.states[state].cycles.iter().enumerate() {
                let (one, other) = self.0[state][index];
                let (after, broken) = next(seen, one, other, elapsed(graph, index));
                if broken {
                    return Some(depth);
                }
                known.entry((edge.to, after)).or_insert_with(|| {
                    queue.push_back((edge.to, after));
                    depth
                });
            }
        }
        None
    }

    /// Whether cycles lead back to where they began, in which what is asked for never comes, and all comes that is assumed to.
    fn endless(&self, model: &Model, graph: &Graph) -> Result<bool, String> {
        let often: Vec<&Expr> = model.often.iter().collect();
        let goals = often.len() + usize::from(passes(model));
        // Nodes where the chart waits; before the first cycle it does not.
        let mut waiting = vec![false; graph.states.len()];
        let mut reached = vec![[false; 2]; graph.states.len()];
        let mut queue = vec![(0, false)];
        reached[0][0] = true;
        while let Some((state, waits)) = queue.pop() {
            waiting[state] |= waits;
            for (index, edge) in graph.states[state].cycles.iter().enumerate() {
                let (from, to) = self.0[state][index];
                let next = (waits || from) && !to;
                if !std::mem::replace(&mut reached[edge.to][usize::from(next)], true) {
                    queue.push((edge.to, next));
                }
            }
        }
        let component = self.components(graph, &waiting);
        let mut comes = BTreeMap::<usize, Vec<bool>>::new();
        for (state, cycles) in graph.states.iter().enumerate() {
            for (index, edge) in cycles.cycles.iter().enumerate() {
                let inside = waiting[state] && waiting[edge.to] && !self.0[state][index].1;
                if !inside || component[state] != component[edge.to] {
                    continue;
                }
                let come = comes.entry(component[state]).or_insert_with(|| vec![false; goals]);
                for (goal, often) in often.iter().enumerate() {
                    come[goal] |= graph.holds(model, edge, &often.tree)?;
                }
                if let Some(time) = come.get_mut(often.len()) {
                    *time |= elapsed(graph, index) > 0;
                }
            }
        }
        Ok(comes.values().any(|come| come.iter().all(|one| *one)))
    }

    /// By state, the least state that it can reach and be reached from while the chart waits.
    fn components(&self, graph: &Graph, waiting: &[bool]) -> Vec<usize> {
        let reach = |start: usize| {
            let mut seen = vec![false; graph.states.len()];
            let mut open = vec![start];
            while let Some(state) = open.pop() {
                for (index, edge) in graph.states[state].cycles.iter().enumerate() {
                    let goes_on = waiting[edge.to] && !self.0[state][index].1;
                    if goes_on && !std::mem::replace(&mut seen[edge.to], true) {
                        open.push(edge.to);
                    }
                }
            }
            seen
        };
        let all: Vec<Vec<bool>> =
            (0..graph.states.len()).map(|state| if waiting[state] { reach(state) } else { Vec::new() }).collect();
        let together = |one: usize, other: usize| {
            waiting[one] && waiting[other] && all[one].get(other) == Some(&true) && all[other].get(one) == Some(&true)
        };
        (0..graph.states.len()).map(|state| (0..state).find(|other| together(*other, state)).unwrap_or(state)).collect()
    }
}
