//! Some ways through a chart with more situations than the budget allows. All of them are real.
//!
//! The transitions of one cluster move at a time, those of the others wait as far as the inputs allow. So parallel branches
//! are gone through one after the other instead of in all interleavings, and a branch that is left too early, or one in
//! which there is no way on, is met soon. That nothing else happens does not follow from this; but from where the ways end
//! all is tried out, and if that comes to an end within the budget, what waits there waits forever.

use std::rc::Rc;

use super::Search;
use super::graph::{Graph, Seen};
use super::leaf::Leaf;
use super::reduction;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::semantics;
use crate::analysis::explore::semantics::trail::Trail;
use crate::analysis::explore::valuation::{State, When};
use crate::analysis::explore::verdicts::Report;
use crate::analysis::explore::verdicts::future::{Future, ends};
use crate::analysis::explore::verdicts::path::{Deadlock, StuckJoin};
use crate::list::{List, PushAll};
use crate::model::{Arena, StepId, TransitionId};
use crate::sorted::sort_by_key;

/// How often the inputs are chosen anew so that a transition clears, or waits.
const TRIES: usize = 64;

/// From so many states a transition is given its turn until it has cleared once.
const TURNS: u8 = 8;

/// So many ends of ways are looked at.
const ENDS: usize = 8;

/// So many activations of active steps are followed back to find a shorter way.
const REPLAYS: usize = 6;

/// What was found on some ways.
pub(crate) struct FoundOnWays {
    /// Shorter ones before longer ones.
    pub(crate) graphs: Vec<Graph>,
    pub(crate) deadlocks: Vec<Deadlock>,
    pub(crate) stuck_joins: Vec<StuckJoin>,
    pub(crate) work: u64,
}

/// Goes through a chart twice: the clusters in the order of the source, and the other way round.
pub(crate) fn go(net: &Net, limit: u64, seen: &mut Seen) -> FoundOnWays {
    let mut ways = FoundOnWays { graphs: Vec::new(), deadlocks: Vec::new(), stuck_joins: Vec::new(), work: 0 };
    let mut long = Vec::new();
    for backwards in [false, true] {
        let (graph, done, work) = search(net, limit / 3, seen).wander(backwards);
        ways.work += work;
        ways.shorten(net, &graph, limit / 60, seen);
        if !graph.cut_off {
            ways.judge(net, &graph, &done, limit / 60, seen);
        }
        long.push(graph);
    }
    ways.graphs.push_all(long);
    ways
}

fn search<'n, 's>(net: &'n Net, limit: u64, seen: &'s mut Seen) -> Search<'n, 's> {
    let mut search = Search::new(net, None, false, limit, seen);
    search.graph.watched.clear();
    search
}

impl FoundOnWays {
    /// Goes only what led to each activation of an active step; all else waits.
    fn shorten(&mut self, net: &Net, graph: &Graph, limit: u64, seen: &mut Seen) {
        let mut plans: Vec<Vec<TransitionId>> = Vec::new();
        for (step, doubled) in &graph.doubled {
            let mut cycles: Vec<&[TransitionId]> = vec![&doubled.cycle.cleared];
            let mut at = doubled.from;
            while let Some(origin) = &graph.origins[at] {
                cycles.push(&origin.cycle.cleared);
                at = origin.from;
            }
            cycles.reverse();
            plans.push(led_to(net, &cycles, *step, doubled.by));
        }
        sort_by_key(&mut plans, Vec::len);
        for plan in plans.into_iter().take(REPLAYS) {
            let (graph, work) = search(net, limit, seen).follow(&plan);
            self.work += work;
            self.graphs.push(graph);
        }
    }

    /// What never goes on where the ways end.
    fn judge(&mut self, net: &Net, graph: &Graph, expanded: &[bool], limit: u64, seen: &mut Seen) {
        for end in ends(graph, expanded).into_iter().take(ENDS) {
            let state = &graph.states[end];
            if state.first || state.active.is_empty() {
                continue;
            }
            let (beyond, work) = search(net, limit, seen).from(state).run();
            self.work += work;
            if !beyond.complete {
                continue;
            }
            let future = Future::of(net, &beyond);
            let report = Report { net, graph: &beyond };
            let way = Report { net, graph }.path_to(end);
            let here = |deadlock: Deadlock| Deadlock { path: way.clone(), ..deadlock };
            self.deadlocks.push_all(report.deadlocks_of(&future, [0]).into_iter().map(here));
            for stuck in report.stuck_joins_of(&future, [0]) {
                let culprit = Report { net, graph }.parting(end, stuck.join);
                self.stuck_joins.push(StuckJoin { culprit, path: way.clone(), ..stuck });
            }
        }
    }
}

/// The transitions that led to both activations of a step, in their order.
fn led_to(net: &Net, cycles: &[&[TransitionId]], step: StepId, by: TransitionId) -> Vec<TransitionId> {
    // Who activated each step last, and what each clearing needed.
    let mut active: Arena<StepId, Option<usize>> = Arena::filled(net.leaving.len(), None);
    let mut events: Vec<(TransitionId, Vec<usize>)> = Vec::new();
    let last = cycles.len().saturating_sub(1);
    let mut needed: Vec<usize> = Vec::new();
    for (number, cycle) in cycles.iter().enumerate() {
        for transition in *cycle {
            let arc = &net.arcs[*transition];
            let causes = arc.sources.iter().filter_map(|source| active[*source]).list();
            let event = events.len();
            events.push((*transition, causes));
            if number == last && *transition == by {
                needed.push_all(active[step].into_iter().and([event]));
            }
            for target in &arc.targets {
                active[*target] = Some(event);
            }
        }
    }
    let mut wanted = vec![false; events.len()];
    while let Some(event) = needed.pop() {
        if !std::mem::replace(&mut wanted[event], true) {
            needed.extend(&events[event].1);
        }
    }
    events.iter().zip(wanted).filter(|(_, wanted)| *wanted).map(|((transition, _), _)| *transition).list()
}

impl Search<'_, '_> {
    /// Explores from this state on.
    fn from(mut self, state: &State) -> Self {
        self.insert(state.clone(), None);
        self
    }

    /// Goes some ways; also says which states were looked at.
    fn wander(mut self, backwards: bool) -> (Graph, Vec<bool>, u64) {
        self.roots();
        let mut expanded = vec![false];
        let mut turns = Arena::filled(self.valuation.net.arcs.len(), TURNS);
        let mut next = 0;
        // All ways go on in turn: one that leads round in a circle must not use up the budget of the others.
        while next < self.graph.states.len() && !self.is_spent() {
            self.ways_on(next, backwards, &mut turns);
            expanded.resize(self.graph.states.len(), false);
            expanded[next] = !self.is_spent();
            next += 1;
        }
        (self.graph, expanded, self.valuation.work)
    }

    /// Goes on from a state.
    fn ways_on(&mut self, number: usize, backwards: bool, turns: &mut Arena<TransitionId, u8>) {
        let net = self.valuation.net;
        let state = Rc::clone(&self.graph.states[number]);
        let enabled = self.open(&state);
        let mut clusters = reduction::groups(net, &enabled);
        if backwards {
            clusters.reverse();
        }
        // Branches with common inputs carry each other past alternatives.
        let is_alternative = |transition: &TransitionId| {
            net.arcs[*transition].sources.iter().any(|source| net.leaving[*source].len() > 1)
        };
        for transition in enabled.iter().filter(|transition| is_alternative(transition)) {
            if turns[*transition] > 0 {
                turns[*transition] -= 1;
                if let Some(leaf) = self.aim(&state, &enabled, Some(*transition)) {
                    turns[*transition] = 0;
                    self.commit(number, leaf);
                }
            }
        }
        let known = self.graph.states.len();
        for transition in clusters.into_iter().flat(|cluster| cluster.into_iter().map(Some).and([None])) {
            match transition {
                Some(transition) => {
                    if let Some(leaf) = self.aim(&state, &enabled, Some(transition)) {
                        self.commit(number, leaf);
                    }
                }
                // The end of a cluster.
                None if self.graph.states.len() > known || self.is_spent() => return,
                None => {}
            }
        }
        // Nothing moves; but what edges compare with may become another.
        if let Some(leaf) = self.aim(&state, &enabled, None) {
            self.commit(number, leaf);
        }
    }

    /// The transitions that can clear first in a cycle.
    fn open(&mut self, state: &State) -> Vec<TransitionId> {
        let net = self.valuation.net;
        if state.first && !net.grafcet {
            return Vec::new();
        }
        let enabled = semantics::enabled(net, None, &state.active);
        for transition in &enabled {
            self.seen.enabled[*transition] = true;
        }
        enabled
    }

    /// Clears these transitions one after the other.
    fn follow(mut self, plan: &[TransitionId]) -> (Graph, u64) {
        self.roots();
        let mut at = 0;
        // Cleared although it was not their turn.
        let mut ahead: Vec<TransitionId> = Vec::new();
        for transition in plan {
            if let Some(position) = ahead.iter().position(|other| other == transition) {
                ahead.remove(position);
                continue;
            }
            let mut idle = 0;
            loop {
                let state = Rc::clone(&self.graph.states[at]);
                let enabled = self.open(&state);
                let aimed =
                    if enabled.contains(transition) { self.aim(&state, &enabled, Some(*transition)) } else { None };
                let done = aimed.is_some();
                let Some(leaf) = aimed.or_else(|| self.aim(&state, &enabled, None)) else {
                    return (self.graph, self.valuation.work);
                };
                ahead.extend(leaf.done.cleared.iter().filter(|other| *other != transition));
                at = self.commit(at, leaf);
                if done {
                    break;
                }
                idle += 1;
                if idle > 2 || self.is_spent() {
                    return (self.graph, self.valuation.work);
                }
            }
            if !self.graph.doubled.is_empty() {
                break;
            }
        }
        (self.graph, self.valuation.work)
    }

    /// A cycle in which a transition clears (or none, if that is what is wanted), and as few others as the inputs allow.
    fn aim(&mut self, state: &State, enabled: &[TransitionId], at: Option<TransitionId>) -> Option<Leaf> {
        let net = self.valuation.net;
        self.valuation.lazy = false;
        self.valuation.tape.restart();
        self.valuation.begin(state);
        let others = enabled.iter().copied().filter(|transition| Some(*transition) != at);
        let goals: Vec<TransitionId> = at.into_iter().and(others).list();
        for (number, goal) in goals.iter().enumerate() {
            let clears = Some(*goal) == at;
            let floor = self.valuation.tape.asked();
            let mut tries = 0;
            while self.valuation.decide(&net.arcs[*goal].condition, When::Now) != clears {
                tries += 1;
                let again = tries < TRIES && !self.is_spent() && self.valuation.tape.advance_above(floor);
                if !again {
                    if clears {
                        return None;
                    }
                    self.valuation.tape.rewind_to(floor);
                }
                self.valuation.begin(state);
                for before in &goals[..number] {
                    self.valuation.decide(&net.arcs[*before].condition, When::Now);
                }
                if !again {
                    break;
                }
            }
        }
        let (when, done) = semantics::go_on(&mut self.valuation, state, enabled, &mut Trail::default());
        if at.is_some_and(|transition| !done.cleared.contains(&transition)) {
            return None;
        }
        self.leaf(state, when, done)
    }

    fn is_spent(&self) -> bool {
        self.valuation.work >= self.limit
    }
}

impl Report<'_> {
    /// The transition on the way to a state with which a convergence was lost: until then arrows led to all its sources.
    fn parting(&self, state: usize, join: TransitionId) -> Option<TransitionId> {
        self.parted_by(state, join, &|before| self.leads_to(&self.graph.states[before].active, join))
    }

    /// Whether arrows lead from the active steps to all sources of a convergence, not by itself.
    fn leads_to(&self, active: &[StepId], join: TransitionId) -> bool {
        let mut reached = Arena::filled(self.net.leaving.len(), false);
        let mut work = active.to_vec();
        while let Some(step) = work.pop() {
            if !std::mem::replace(&mut reached[step], true) {
                let arcs = self.net.leaving[step].iter().filter(|transition| **transition != join);
                work.extend(arcs.flat(|transition| &self.net.arcs[*transition].targets));
            }
        }
        self.net.arcs[join].sources.iter().all(|source| reached[*source])
    }
}
