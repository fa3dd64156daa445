//! Properties over more than one cycle, on the graph of all cycles: what has been seen is a part of the state.

use std::collections::{BTreeMap, VecDeque};

use grafcet_compiler::model::{Claim, Model, Tree};

use super::graph::{Edge, Graph, LEAP, passes};

/// Whether a property over more than one cycle is broken.
#[derive(Debug)]
pub(crate) enum Broken {
    /// After so many cycles at least.
    In(usize),
    /// Something never comes.
    Endless,
}

/// How a property over several cycles is broken, if it is; none for one about single cycles.
///
/// # Errors
/// The interpreter does not understand it.
pub(crate) fn broken(model: &Model, graph: &Graph, claim: &Claim) -> Result<Option<Broken>, String> {
    let (one, other) = match claim {
        Claim::LeadsTo { from, to, .. } => (from, to),
        Claim::Before { first, then } => (first, then),
        Claim::Never(_) | Claim::Always { .. } | Claim::Home(..) => return Ok(None),
    };
    Ok(Edges::of(model, graph, &one.tree, &other.tree)?.broken(claim))
}

/// By state, its cycles; the first state is what is before the first cycle.
pub(crate) struct Edges(pub(crate) Vec<Vec<Step>>);

/// A cycle, as far as a property is concerned.
#[derive(Clone)]
pub(crate) struct Step {
    /// The state after it.
    pub(crate) to: usize,
    /// So much time has passed before it.
    pub(crate) elapsed: u32,
    /// Two conditions at its end.
    pub(crate) one: bool,
    pub(crate) other: bool,
    /// Of what is taken to come again and again, what comes.
    pub(crate) comes: Vec<bool>,
}

/// How much time passes before a cycle: the graph has each valuation without time first, then with a leap.
fn elapsed(graph: &Graph, index: usize) -> u32 {
    if index < graph.valuations.len() { 0 } else { LEAP }
}

impl Edges {
    pub(super) fn of(model: &Model, graph: &Graph, one: &Tree, other: &Tree) -> Result<Self, String> {
        let passes = passes(model);
        let step = |(index, edge): (usize, &Edge)| {
            let often = model.often.iter().map(|often| graph.holds(model, edge, &often.tree));
            let elapsed = elapsed(graph, index);
            Ok(Step {
                to: edge.to,
                elapsed,
                one: graph.holds(model, edge, one)?,
                other: graph.holds(model, edge, other)?,
                comes: often.chain(passes.then_some(Ok(elapsed > 0))).collect::<Result<_, String>>()?,
            })
        };
        let of_state = |edges: &Vec<Edge>| edges.iter().enumerate().map(step).collect::<Result<_, String>>();
        Ok(Self(graph.states.iter().map(|state| of_state(&state.cycles)).collect::<Result<_, _>>()?))
    }

    /// How a property of these two conditions is broken, if it is; of one about single cycles the first says where.
    pub(crate) fn broken(&self, claim: &Claim) -> Option<Broken> {
        match claim {
            Claim::LeadsTo { within: None, .. } => self.endless().then_some(Broken::Endless),
            Claim::LeadsTo { within: Some(ticks), .. } => {
                let late = |since: Option<u32>, from: bool, to: bool, elapsed: u32| {
                    let passed = since.map(|since| since.saturating_add(elapsed).min(*ticks));
                    let next = if to { None } else { passed.or(from.then_some(0)) };
                    (next, !to && passed.or(from.then_some(0)) == Some(*ticks))
                };
                self.shortest(None, late).map(Broken::In)
            }
            Claim::Before { .. } => {
                let early = |seen: bool, first: bool, then: bool, _| (seen || first, then && !seen && !first);
                self.shortest(false, early).map(Broken::In)
            }
            Claim::Never(_) | Claim::Always { .. } => self.shortest((), |(), one, _, _| ((), one)).map(Broken::In),
            Claim::Home(..) => None,
        }
    }

    /// After how many cycles `next` says first that it is broken.
    pub(super) fn shortest<S: Ord + Copy>(
        &self,
        start: S,
        next: impl Fn(S, bool, bool, u32) -> (S, bool),
    ) -> Option<usize> {
        let mut known = BTreeMap::from([((0, start), 0)]);
        let mut queue = VecDeque::from([(0, start)]);
        while let Some((state, seen)) = queue.pop_front() {
            let depth = known[&(state, seen)] + 1;
            for edge in &self.0[state] {
                let (after, broken) = next(seen, edge.one, edge.other, edge.elapsed);
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
    fn endless(&self) -> bool {
        // Nodes where the chart waits; before the first cycle it does not.
        let mut waiting = vec![false; self.0.len()];
        let mut reached = vec![[false; 2]; self.0.len()];
        let mut queue = vec![(0, false)];
        reached[0][0] = true;
        while let Some((state, waits)) = queue.pop() {
            waiting[state] |= waits;
            for edge in &self.0[state] {
                let next = (waits || edge.one) && !edge.other;
                if !std::mem::replace(&mut reached[edge.to][usize::from(next)], true) {
                    queue.push((edge.to, next));
                }
            }
        }
        let component = self.components(&waiting);
        let mut comes = BTreeMap::<usize, Vec<bool>>::new();
        for (state, cycles) in self.0.iter().enumerate().filter(|(state, _)| waiting[*state]) {
            for edge in cycles {
                let inside = waiting[edge.to] && !edge.other;
                if !inside || component[state] != component[edge.to] {
                    continue;
                }
                let come = comes.entry(component[state]).or_insert_with(|| vec![false; edge.comes.len()]);
                come.iter_mut().zip(&edge.comes).for_each(|(come, comes)| *come |= comes);
            }
        }
        comes.values().any(|come| come.iter().all(|one| *one))
    }

    /// By state, a number that those have in common which lead to each other while the chart waits (Kosaraju).
    fn components(&self, waiting: &[bool]) -> Vec<usize> {
        let goes_on = |edge: &Step| waiting[edge.to] && !edge.other;
        let mut back = vec![Vec::new(); self.0.len()];
        for (state, cycles) in self.0.iter().enumerate().filter(|(state, _)| waiting[*state]) {
            cycles.iter().filter(|edge| goes_on(edge)).for_each(|edge| back[edge.to].push(state));
        }
        let (mut seen, mut order) = (vec![false; self.0.len()], Vec::new());
        for start in (0..self.0.len()).filter(|state| waiting[*state]) {
            if std::mem::replace(&mut seen[start], true) {
                continue;
            }
            let mut open = vec![(start, 0)];
            while let Some((state, index)) = open.last_mut() {
                let Some(edge) = self.0[*state].get(*index) else {
                    order.push(*state);
                    open.pop();
                    continue;
                };
                *index += 1;
                if goes_on(edge) && !std::mem::replace(&mut seen[edge.to], true) {
                    open.push((edge.to, 0));
                }
            }
        }
        let mut component = vec![usize::MAX; self.0.len()];
        for start in order.into_iter().rev() {
            let mut open = vec![start];
            while let Some(state) = open.pop() {
                if component[state] == usize::MAX {
                    component[state] = start;
                    open.extend(&back[state]);
                }
            }
        }
        component
    }
}
