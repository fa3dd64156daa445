//! States, and the cycles that lead from one to another.

use std::rc::Rc;

use super::knowledge::{Known, Learnt};
use super::net::Net;
use super::scene::State;
use crate::analysis::Relation;
use crate::sorted::Map;

/// What was seen on the way, in any part of the chart.
#[derive(Debug)]
pub(super) struct Seen {
    /// Steps that were active, transient situations included.
    pub(super) reachable: Vec<bool>,
    pub(super) enabled: Vec<bool>,
    pub(super) able: Vec<bool>,
    /// Pairs of steps that were active together.
    pub(super) together: Relation,
}

impl Seen {
    pub(super) fn nothing(net: &Net) -> Self {
        let arcs = net.arcs.len();
        let steps = net.leaving.len();
        Self {
            reachable: vec![false; steps],
            enabled: vec![false; arcs],
            able: vec![false; arcs],
            together: Relation::new(steps),
        }
    }

    pub(super) fn situation(&mut self, active: &[usize]) {
        for (position, step) in active.iter().enumerate() {
            self.reachable[*step] = true;
            for other in &active[position + 1..] {
                self.together.insert(*step, *other);
            }
        }
    }
}

/// How a state was reached first.
#[derive(Debug)]
pub(super) struct Origin {
    pub(super) from: usize,
    pub(super) cycle: Cycle,
}

/// One cycle.
#[derive(Clone, Debug)]
pub(super) struct Cycle {
    pub(super) given: Vec<(usize, Known)>,
    /// What it demands of the cycle before, because of edges.
    pub(super) past: Vec<(usize, Known)>,
    /// What it takes for granted of atoms that are not followed.
    pub(super) granted: Learnt,
    pub(super) cleared: Vec<usize>,
}

/// A cycle from one state to another; those that differ in their inputs only are one.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Edge {
    pub(super) to: usize,
    pub(super) cleared: Box<[usize]>,
    /// AND-convergences enabled by a situation inside the cycle.
    pub(super) joins: Box<[usize]>,
    /// Steps that what stands above has left or entered in between.
    pub(super) changed: Box<[usize]>,
    /// In a thorough search what it takes for granted, as values that atoms have before the cycle; none where it is not that
    /// simple.
    pub(super) granted: Option<Box<[(usize, Known)]>>,
}

/// A cycle that activates a step while it is active.
#[derive(Debug)]
pub(super) struct Doubled {
    pub(super) from: usize,
    pub(super) cycle: Cycle,
    pub(super) by: usize,
    /// The situation at its end.
    pub(super) end: Box<[usize]>,
}

/// Where an exploration was given up.
#[derive(Debug)]
pub(super) struct End {
    /// The state whose cycles were being run, which are explored in their order.
    pub(super) state: usize,
    pub(super) work: u64,
    /// The atoms that its cycles asked for last.
    pub(super) asked: Vec<usize>,
}

/// The states of a chart, or of a piece of it.
#[derive(Debug)]
pub(super) struct Graph {
    pub(super) unit: Option<usize>,
    pub(super) states: Vec<Rc<State>>,
    pub(super) origins: Vec<Option<Origin>>,
    pub(super) edges: Vec<Vec<Edge>>,
    /// States that stand for what another part of the chart does to this one.
    pub(super) entries: Vec<usize>,
    /// The steps that were activated while they were active.
    pub(super) doubled: Map<usize, Doubled>,
    /// Per watched expression: from which state on which cycle ends with it holding, and the state at its end.
    pub(super) watched: Vec<Option<(usize, Cycle, Rc<State>)>>,
    /// All of it was explored.
    pub(super) complete: bool,
    /// Where the budget ran out.
    pub(super) end: Option<End>,
    /// Not everything was tried in all combinations, and a search for stability did not come to its end: it stops elsewhere
    /// when more clears at once.
    pub(super) cut_off: bool,
    /// Some search for stability was stopped by its bound.
    pub(super) unstable: bool,
}

impl Graph {
    /// Nothing of the chart, or of a piece of it.
    pub(super) fn of(net: &Net, unit: Option<usize>) -> Self {
        Self {
            unit,
            states: Vec::new(),
            origins: Vec::new(),
            edges: Vec::new(),
            entries: Vec::new(),
            doubled: Map::new(),
            watched: vec![None; if unit.is_none() { net.watched.len() } else { 0 }],
            complete: false,
            end: None,
            cut_off: false,
            unstable: false,
        }
    }
}
