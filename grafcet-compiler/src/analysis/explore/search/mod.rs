//! From situation to situation.

pub(crate) mod alone;
pub(crate) mod endless;
pub(crate) mod graph;
pub(crate) mod index;
pub(crate) mod leaf;
pub(crate) mod reduction;
pub(crate) mod settles;
pub(crate) mod situations;
pub(crate) mod some_ways;
pub(crate) mod whole;

use crate::list::List;
use std::rc::Rc;

use self::graph::{Cycle, Doubled, Edge, End, Graph, Origin, Seen};
use self::index::Index;
use self::leaf::Leaf;
use crate::analysis::explore::net::formula::AtomId;
use crate::analysis::explore::net::slots::{Bit, SlotId};
use crate::analysis::explore::net::units::UnitId;
use crate::analysis::explore::net::{Net, Order};
use crate::analysis::explore::semantics;
use crate::analysis::explore::semantics::trail::Trail;
use crate::analysis::explore::semantics::turn::Turn;
use crate::analysis::explore::valuation::knowledge::{Known, Learnt};
use crate::analysis::explore::valuation::{State, Valuation, When};
use crate::model::{Id, StepId, TransitionId};
use crate::sorted::{Set, sort, sort_unstable};

/// Explores one piece of a chart, or all of it.
pub(crate) struct Search<'n, 's> {
    pub(crate) valuation: Valuation<'n>,
    pub(crate) graph: Graph,
    pub(crate) index: Index,
    pub(crate) seen: &'s mut Seen,
    pub(crate) limit: u64,
    /// Slots that other pieces write, too.
    pub(crate) foreign: Vec<SlotId>,
    /// What has nothing to do with each other is not tried in all combinations.
    lazy: bool,
    /// Orders or an enclosing step can hold the piece as it is.
    commanded: bool,
    /// An order can hold the piece in the middle of a search.
    held: bool,
    /// The last state from which that was noted, and in which situations.
    holds: (usize, Set<Vec<StepId>>),
    /// See [`Search::cut_anywhere`].
    cut: bool,
    /// See [`Search::thoroughly`].
    pub(crate) thorough: bool,
    /// See [`Search::with_time`].
    pub(crate) timed: bool,
    /// See [`Search::while_it_settles`].
    settles: bool,
}

impl<'n, 's> Search<'n, 's> {
    pub(crate) fn new(net: &'n Net, unit: Option<UnitId>, lazy: bool, limit: u64, seen: &'s mut Seen) -> Self {
        let foreign = unit.map_or_else(Vec::new, |unit| net.foreign_slots(unit));
        Self {
            valuation: Valuation::new(net, unit),
            graph: Graph::of(net, unit),
            index: Index::default(),
            seen,
            limit,
            foreign,
            lazy,
            commanded: false,
            held: false,
            holds: (0, Set::new()),
            cut: false,
            thorough: false,
            timed: false,
            settles: false,
        }
    }

    /// A search of the chart may be stopped in the middle of what the piece does.
    pub(crate) fn cut_anywhere(mut self, may_be: bool) -> Self {
        self.cut = may_be;
        self
    }

    /// Until a search for stability is stopped by its bound.
    pub(crate) fn while_it_settles(mut self) -> Self {
        self.settles = true;
        self
    }

    /// Whatever can be done from a state can be done from each situation that it stands for: what the edges of the next
    /// cycle compare with is decided, and states that agree in less are not taken for one; times are followed. The watched
    /// expressions are left out.
    pub(crate) fn thoroughly(mut self) -> Self {
        self.thorough = true;
        self.timed = true;
        self.graph.watched.clear();
        self
    }

    /// No time falls back: those that have to be followed are.
    pub(crate) fn with_time(mut self) -> Self {
        self.timed = true;
        self
    }

    /// The whole chart from its initial situation, or a piece of it from all situations in which it can start.
    /// Returns the units of work it took.
    pub(crate) fn run(mut self) -> (Graph, u64) {
        self.explore();
        (self.graph, self.valuation.work)
    }

    /// The same; returned is whether all was seen, and which of the watched pairs of actions ran together.
    pub(crate) fn run_beside(mut self, pairs: usize) -> (bool, Vec<bool>) {
        self.valuation.have_met = vec![false; pairs];
        self.explore();
        (self.graph.complete, self.valuation.have_met)
    }

    /// From the beginning, or from the state at which the budget ran out before.
    fn explore(&mut self) {
        if self.graph.states.is_empty() {
            self.roots();
        }
        let mut next = self.graph.end.take().map_or(0, |end| end.state);
        while next < self.graph.states.len() {
            if !self.expand(next) {
                let (work, asked) = (self.valuation.work, self.valuation.asked());
                self.graph.end = Some(End { state: next, work, asked });
                return;
            }
            next += 1;
        }
        self.graph.complete = true;
    }

    pub(crate) fn roots(&mut self) {
        let net = self.valuation.net;
        let Some(unit) = self.valuation.unit else {
            self.root(true, net.initial.clone());
            return;
        };
        self.held = self.cut;
        let own = |steps: &[StepId]| -> Vec<StepId> {
            steps.iter().filter(|step| net.unit_of[**step] == unit).copied().list()
        };
        let initial = own(&net.initial);
        let sourceless = net.sourceless.iter().any(|t| net.arcs[*t].targets.iter().any(|s| net.unit_of[*s] == unit));
        if !initial.is_empty() || sourceless {
            self.root(true, initial);
        }
        let Some(part) = net.unit_of.iter().find(|(_, of)| **of == unit).map(|(step, _)| &net.parts[net.part_of[step]])
        else {
            return;
        };
        self.commanded = part.enclosed_by.is_some() || !part.orders.is_empty();
        self.held |= part.orders.iter().any(|(_, order)| matches!(order, Order::Hold));
        let orders = part.orders.iter().filter_map(|(_, order)| match order {
            Order::To(steps) => Some(own(steps)),
            Order::Hold => None,
        });
        let starts: Vec<Vec<StepId>> = orders.and([own(&part.linked)]).list();
        for start in starts {
            if !start.is_empty() || sourceless && self.commanded {
                let entry = self.root(false, start);
                self.graph.entries.push(entry);
            }
        }
    }

    fn root(&mut self, first: bool, active: Vec<StepId>) -> usize {
        let mut slots = self.valuation.net.initial_slots.values().copied().list();
        if first {
            for slot in &self.foreign {
                slots[slot.index()] = Bit::Any;
            }
        } else {
            slots.fill(Bit::Any);
        }
        let (active, slots) = (active.into(), slots.into());
        self.insert(State { first, active, slots, before: Box::default(), ages: Box::default() }, None)
    }

    /// The number of a state; where one is known that differs by knowing less of the past, it stands for both.
    pub(crate) fn insert(&mut self, state: State, origin: Option<Origin>) -> usize {
        let general = !state.before.is_empty() && !self.thorough;
        let known = general.then(|| self.number_of(&state, &[])).flatten();
        if let Some(known) = known.or_else(|| self.number_of(&state, &state.before)) {
            return known;
        }
        self.seen.situation(&state.active);
        let (number, state) = (self.graph.states.len(), Rc::new(state));
        self.index.insert(&state, number);
        self.graph.states.push(state);
        self.graph.origins.push(origin);
        self.graph.edges.push(Vec::new());
        number
    }

    /// The number of this state, if it remembers `past` of the cycle before.
    pub(crate) fn number_of(&self, state: &State, past: &[(AtomId, Known)]) -> Option<usize> {
        self.index.find(&self.graph.states, state, past)
    }

    /// Runs all cycles from a state; `false` if the budget ran out.
    fn expand(&mut self, number: usize) -> bool {
        let net = self.valuation.net;
        let state = Rc::clone(&self.graph.states[number]);
        let enabled = semantics::enabled(net, self.valuation.unit, &state.active);
        if net.grafcet || !state.first {
            for transition in &enabled {
                self.seen.enabled[*transition] = true;
            }
        }
        let mut leaves = None;
        if self.lazy && (net.grafcet || !state.first) {
            self.valuation.begin(&state);
            self.valuation.groups = reduction::at_start(&mut self.valuation, &enabled).map(Rc::new);
            leaves = self.runs(&state, &enabled, true);
        }
        let Some(leaves) = leaves.or_else(|| self.runs(&state, &enabled, false)) else { return false };
        for leaf in leaves {
            self.commit(number, leaf);
        }
        if self.commanded && !state.before.is_empty() {
            let held = State { before: Box::default(), first: false, ..(*state).clone() };
            let cycle = Cycle { given: Vec::new(), past: Vec::new(), granted: Vec::new(), cleared: Vec::new() };
            self.hold(held, Origin { from: number, cycle });
        }
        sort(&mut self.graph.edges[number]);
        self.graph.edges[number].dedup();
        if !state.first && !net.grafcet {
            self.probe(&state, &enabled);
        }
        self.valuation.work < self.limit
    }

    /// Runs the cycle under all valuations; `lazy`: transitions that have nothing to do with each other one at a time. None
    /// if the budget ran out, or they do have to do with each other.
    pub(crate) fn runs(&mut self, state: &State, enabled: &[TransitionId], lazy: bool) -> Option<Vec<Leaf>> {
        let mut leaves = Vec::new();
        self.valuation.lazy = lazy;
        self.valuation.tape.restart();
        let mut trail = Trail::followed();
        loop {
            let (when, done) = semantics::run(&mut self.valuation, state, enabled, &mut trail);
            let leaf = self.leaf(state, when, done);
            if self.valuation.spoilt {
                return None;
            }
            if let Some(leaf) = leaf {
                self.graph.unstable |= leaf.done.unstable;
                if self.graph.unstable && self.settles {
                    return None;
                }
                self.graph.cut_off |= lazy && leaf.done.unstable;
                leaves.push(leaf);
            }
            if self.valuation.work >= self.limit {
                return None;
            }
            if !self.valuation.tape.advance() {
                return Some(leaves);
            }
        }
    }

    /// An order can hold the piece in this state.
    fn hold(&mut self, state: State, origin: Origin) {
        let from = origin.from;
        let to = self.insert(state, Some(origin));
        let (cleared, joins, changed) = (Box::default(), Box::default(), Box::default());
        self.graph.edges[from].push(Edge { to, cleared, rests: None, joins, changed, granted: None });
    }

    /// The number of the state to which it leads.
    pub(crate) fn commit(&mut self, from: usize, leaf: Leaf) -> usize {
        let net = self.valuation.net;
        let Leaf { next, done, mut cycle, late, watched, met } = leaf;
        for pair in met {
            self.valuation.have_met[pair] = true;
        }
        if self.held && self.holds.0 != from {
            self.holds = (from, Set::new());
        }
        for active in &done.transient {
            self.seen.situation(active);
            if self.held && self.holds.1.insert(active.clone()) {
                // What it remembers then is not followed within a search.
                let slots = vec![Bit::Any; net.initial_slots.len()].into();
                let (active, before, ages) = (active.clone().into(), Box::default(), Box::default());
                let state = State { first: false, active, slots, before, ages };
                self.hold(state, Origin { from, cycle: cycle.clone() });
            }
        }
        for transition in &done.able {
            self.seen.able[*transition] = true;
        }
        for transition in &done.enabled_later {
            self.seen.enabled[*transition] = true;
        }
        if let Some(turn) = done.passed.as_ref().filter(|turn| turn.is_new()) {
            self.note(turn);
        }
        sort(&mut cycle.granted);
        let rests = (!done.unstable).then_some(done.at_first);
        let demands = (self.thorough && !late).then(|| self.demands(&cycle).into_boxed_slice());
        for (step, by) in done.doubled {
            let doubled = || Doubled { from, cycle: cycle.clone(), by, end: next.active.clone() };
            self.graph.doubled.or_insert_with(step, doubled);
        }
        for (index, cycle) in watched {
            if self.graph.watched[index].is_none() {
                self.graph.watched[index] = Some((from, cycle, Rc::new(next.clone())));
            }
        }
        let mut joins: Vec<TransitionId> = done.enabled_later;
        if let Some(turn) = done.passed {
            joins.extend_from_slice(&turn.joins);
        }
        joins.retain(|transition| net.arcs[*transition].sources.len() > 1);
        sort_unstable(&mut joins);
        joins.dedup();
        let changed = self.changed(from, &next, &done.transient).into_boxed_slice();
        let (cleared, joins) = (cycle.cleared.clone().into_boxed_slice(), joins.into_boxed_slice());
        let to = self.insert(next, Some(Origin { from, cycle }));
        self.graph.edges[from].push(Edge { to, cleared, rests, joins, changed, granted: demands });
        to
    }

    /// What happens in a turn that searches make which were stopped by their bound.
    fn note(&mut self, turn: &Turn) {
        turn.situations().for_each(|active| self.seen.situation(active));
        for transition in &turn.able {
            self.seen.able[*transition] = true;
        }
        for transition in &turn.enabled {
            self.seen.enabled[*transition] = true;
        }
    }

    /// What a cycle takes for granted, with what cannot be chosen whatever that is.
    fn demands(&self, cycle: &Cycle) -> Learnt {
        let net = self.valuation.net;
        let is_bound = |(atom, _): &&(AtomId, Known)| net.bound[*atom] && !net.unfollowed[*atom];
        let mut demands = cycle.granted.clone();
        demands.extend(cycle.given.iter().filter(is_bound));
        sort(&mut demands);
        demands
    }

    /// The steps that changed in a cycle. Where partial grafcets act on each other that does not follow from what cleared and
    /// from the situation at the end.
    fn changed(&self, from: usize, next: &State, transient: &[Vec<StepId>]) -> Vec<StepId> {
        let mut changed = Vec::new();
        if self.valuation.net.hierarchy.is_empty() {
            return changed;
        }
        let mut before: &[StepId] = &self.graph.states[from].active;
        for after in transient.iter().map(|active| &active[..]).and([&next.active[..]]) {
            changed.extend(before.iter().filter(|step| after.binary_search(step).is_err()));
            changed.extend(after.iter().filter(|step| before.binary_search(step).is_err()));
            before = after;
        }
        sort_unstable(&mut changed);
        changed.dedup();
        changed
    }

    /// `sfc`: whether the conditions of the enabled transitions that never cleared so far can hold at all.
    fn probe(&mut self, state: &State, enabled: &[TransitionId]) {
        let net = self.valuation.net;
        for transition in enabled {
            if self.seen.able[*transition] {
                continue;
            }
            self.valuation.tape.restart();
            loop {
                self.valuation.begin(state);
                if self.valuation.decide(&net.arcs[*transition].condition, When::Now) && self.is_assumed() {
                    self.seen.able[*transition] = true;
                    break;
                }
                if !self.valuation.tape.advance() || self.valuation.work >= self.limit {
                    break;
                }
            }
        }
    }
}
