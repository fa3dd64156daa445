//! States, and the cycles that lead from one to another.

use std::rc::Rc;

use crate::analysis::Relation;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::formula::AtomId;
use crate::analysis::explore::net::units::UnitId;
use crate::analysis::explore::valuation::State;
use crate::analysis::explore::valuation::knowledge::{Known, Learnt};
use crate::model::{Arena, Id, StepId, TransitionId};
use crate::sorted::{Map, Set};

/// What was seen on the way, in any part of the chart.
#[derive(Debug)]
pub(crate) struct Seen {
    /// Steps that were active, transient situations included.
    pub(crate) reachable: Arena<StepId, bool>,
    pub(crate) enabled: Arena<TransitionId, bool>,
    pub(crate) able: Arena<TransitionId, bool>,
    /// Pairs of steps that were active together.
    pub(crate) together: Relation,
    /// The situations themselves, transient ones included, where somebody asks for them.
    pub(crate) situations: Option<Set<Vec<StepId>>>,
}

impl Seen {
    pub(crate) fn nothing(net: &Net) -> Self {
        let arcs = net.arcs.len();
        let steps = net.leaving.len();
        Self {
            reachable: Arena::filled(steps, false),
            enabled: Arena::filled(arcs, false),
            able: Arena::filled(arcs, false),
            together: Relation::new(steps),
            situations: None,
        }
    }

    pub(crate) fn situation(&mut self, active: &[StepId]) {
        if let Some(all) = &mut self.situations {
            all.insert(active.to_vec());
        }
        for (position, step) in active.iter().enumerate() {
            self.reachable[*step] = true;
            for other in &active[position + 1..] {
                self.together.insert(step.index(), other.index());
            }
        }
    }
}

/// How a state was reached first.
#[derive(Debug)]
pub(crate) struct Origin {
    pub(crate) from: usize,
    pub(crate) cycle: Cycle,
}

/// One cycle.
#[derive(Clone, Debug)]
pub(crate) struct Cycle {
    pub(crate) given: Vec<(AtomId, Known)>,
    /// What it demands of the cycle before, because of edges.
    pub(crate) past: Vec<(AtomId, Known)>,
    /// What it takes for granted of atoms that are not followed.
    pub(crate) granted: Learnt,
    pub(crate) cleared: Vec<TransitionId>,
}

/// A cycle from one state to another; those that differ in their inputs only are one.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Edge {
    pub(crate) to: usize,
    pub(crate) cleared: Box<[TransitionId]>,
    /// How many of them have begun the search for stability, where it came to rest.
    pub(crate) rests: Option<usize>,
    /// AND-convergences enabled by a situation inside the cycle.
    pub(crate) joins: Box<[TransitionId]>,
    /// Steps that what stands above has left or entered in between.
    pub(crate) changed: Box<[StepId]>,
    /// In a thorough search what it takes for granted, as values that atoms have before the cycle; none where it is not that
    /// simple.
    pub(crate) granted: Option<Box<[(AtomId, Known)]>>,
}

/// A cycle that activates a step while it is active.
#[derive(Debug)]
pub(crate) struct Doubled {
    pub(crate) from: usize,
    pub(crate) cycle: Cycle,
    pub(crate) by: TransitionId,
    /// The situation at its end.
    pub(crate) end: Box<[StepId]>,
}

/// Where an exploration was given up.
#[derive(Debug)]
pub(crate) struct End {
    /// The state whose cycles were being run, which are explored in their order.
    pub(crate) state: usize,
    pub(crate) work: u64,
    /// The atoms that its cycles asked for last.
    pub(crate) asked: Vec<AtomId>,
}

/// The states of a chart, or of a piece of it.
#[derive(Debug)]
pub(crate) struct Graph {
    pub(crate) unit: Option<UnitId>,
    pub(crate) states: Vec<Rc<State>>,
    pub(crate) origins: Vec<Option<Origin>>,
    pub(crate) edges: Vec<Vec<Edge>>,
    /// States that stand for what another part of the chart does to this one.
    pub(crate) entries: Vec<usize>,
    /// The steps that were activated while they were active.
    pub(crate) doubled: Map<StepId, Doubled>,
    /// Per watched expression: from which state on which cycle ends with it holding, and the state at its end.
    pub(crate) watched: Vec<Option<(usize, Cycle, Rc<State>)>>,
    /// All of it was explored.
    pub(crate) complete: bool,
    /// Where the budget ran out.
    pub(crate) end: Option<End>,
    /// Not everything was tried in all combinations, and a search for stability did not come to its end: it stops elsewhere
    /// when more clears at once.
    pub(crate) cut_off: bool,
    /// Some search for stability was stopped by its bound.
    pub(crate) unstable: bool,
}

impl Graph {
    /// Nothing of the chart, or of a piece of it.
    pub(crate) fn of(net: &Net, unit: Option<UnitId>) -> Self {
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
