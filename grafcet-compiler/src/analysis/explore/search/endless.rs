//! Circles that turn for ever once they are entered (A30), found in all searches of all situations that can be reached.
//!
//! A circle is entered where a transition clears in a stable situation and the search turns in it. It is a fault where
//! none of its transitions ever begins a search that comes to rest, and neither does one that leads into it. What lies
//! after a search without end is not looked at, and a search that turns is followed for one turn only: so this can come to its end
//! where the budget is not enough for the whole chart.

use std::rc::Rc;

use super::Search;
use super::graph::{Graph, Seen};
use super::leaf::Leaf;
use super::settles::is_followed;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::semantics;
use crate::analysis::explore::semantics::turn::Turn;
use crate::analysis::{Union, circles};
use crate::list::List;
use crate::model::{Arena, Id, Model, StepId, TransitionId};
use crate::sorted::{Set, sort};

/// The transitions of each circle, in the direction of evolution; `None` where so many units of work do not suffice, or something
/// is not followed.
pub(crate) fn circles(model: &Model, net: &Net, limit: u64) -> Option<Vec<Vec<TransitionId>>> {
    if !is_followed(net) {
        return None;
    }
    let mut seen = Seen::nothing(net);
    let mut search = Search::new(net, None, false, limit, &mut seen);
    if !net.clocks.is_empty() {
        search = search.with_time();
    }
    search.valuation.to_the_turn = true;
    // What the chart claims has nothing to do with its circles.
    search.graph.watched.clear();
    search.roots();
    let mut found = Found::new(model, net);
    let mut number = 0;
    while number < search.graph.states.len() {
        let state = Rc::clone(&search.graph.states[number]);
        let enabled = semantics::enabled(net, None, &state.active);
        for leaf in search.runs(&state, &enabled, false)? {
            let from = Start { state: number, first: state.first };
            if leaf.done.unstable {
                found.turns(from, leaf)?;
            } else if leaf.done.too_long {
                return None;
            } else {
                found.rests(from, &leaf);
                let granted = !leaf.cycle.granted.is_empty();
                let to = search.commit(number, leaf);
                found.ways.push((number, to, granted));
            }
        }
        number += 1;
    }
    found.certain(search.graph.states.len())
}

/// Whether some circle may turn for ever once it is entered, as far as what can be done from the situations of a chart shows it: each
/// of the transitions of such a circle never begins a search that comes to rest, and has a source step from another of them.
pub(crate) fn may_be(net: &Net, graph: &Graph) -> bool {
    // Times count as unknown in it, and what stands above a partial grafcet can give steps back, too.
    if !graph.complete || !is_followed(net) || !net.clocks.is_empty() || !net.hierarchy.is_empty() {
        return true;
    }
    let mut left = Arena::filled(net.arcs.len(), true);
    // What lies after a search without end shows nothing.
    let mut met = vec![false; graph.states.len()];
    let mut open = vec![0];
    while let Some(state) = open.pop() {
        if std::mem::replace(&mut met[state], true) {
            continue;
        }
        for edge in &graph.edges[state] {
            let Some(begun) = edge.rests else { continue };
            open.push(edge.to);
            if !graph.states[state].first {
                edge.cleared[..begun].iter().for_each(|transition| left[*transition] = false);
            }
        }
    }
    let mut given = Arena::filled(net.leaving.len(), 0_usize);
    for (_, arc) in net.arcs.iter().filter(|(id, _)| left[*id]) {
        arc.targets.iter().for_each(|step| given[*step] += 1);
    }
    let mut changes = true;
    while changes {
        changes = false;
        for (id, arc) in net.arcs.iter() {
            // Other sources may be left and entered beside the circle.
            if left[id] && !arc.sources.is_empty() && arc.sources.iter().all(|step| given[*step] == 0) {
                left[id] = false;
                arc.targets.iter().for_each(|step| given[*step] -= 1);
                changes = true;
            }
        }
    }
    left.values().any(|left| *left)
}

/// Where a search begins.
#[derive(Clone, Copy)]
struct Start {
    state: usize,
    /// Before the first cycle.
    first: bool,
}

/// A circle in which some search turns.
struct Ring {
    transitions: Vec<TransitionId>,
    steps: Set<StepId>,
}

/// A search that turns for ever.
struct EndlessSearch {
    from: Start,
    /// What cleared in its first evolution.
    entries: Vec<TransitionId>,
    rings: Vec<usize>,
    /// It relies on values that are not followed.
    granted: bool,
}

struct Found<'m> {
    model: &'m Model,
    net: &'m Net,
    rings: Vec<Ring>,
    /// The circles of a turn.
    known: Vec<(Rc<Turn>, Vec<usize>)>,
    turns: Vec<EndlessSearch>,
    /// By transition, whether it begins a search that comes to rest; the same of the first cycle.
    comes_to_rest: Arena<TransitionId, bool>,
    rests_at_first: Arena<TransitionId, bool>,
    /// Whether the first cycle can come to rest, and whether it can leave the chart as it is: the initial situation is then a
    /// stable one.
    first_rests: bool,
    first_stays: bool,
    /// From where to where cycles lead that come to rest, and whether they rely on values that are not followed.
    ways: Vec<(usize, usize, bool)>,
}

impl<'m> Found<'m> {
    fn new(model: &'m Model, net: &'m Net) -> Self {
        let never = Arena::filled(net.arcs.len(), false);
        Self {
            model,
            net,
            rings: Vec::new(),
            known: Vec::new(),
            turns: Vec::new(),
            comes_to_rest: never.clone(),
            rests_at_first: never,
            first_rests: false,
            first_stays: false,
            ways: Vec::new(),
        }
    }

    fn rests(&mut self, from: Start, leaf: &Leaf) {
        self.first_rests |= from.first;
        self.first_stays |= from.first && leaf.done.cleared.is_empty() && !leaf.done.evolves;
        let known = if from.first { &mut self.rests_at_first } else { &mut self.comes_to_rest };
        for transition in &leaf.done.cleared[..leaf.done.at_first] {
            known[*transition] = true;
        }
    }

    /// `None` if it was not followed until it turned.
    fn turns(&mut self, from: Start, leaf: Leaf) -> Option<()> {
        let rings = self.rings_of(leaf.done.turn?);
        let entries = leaf.done.cleared[..leaf.done.at_first].to_vec();
        let granted = !leaf.cycle.granted.is_empty();
        self.turns.push(EndlessSearch { from, entries, rings, granted });
        Some(())
    }

    fn rings_of(&mut self, turn: Rc<Turn>) -> Vec<usize> {
        if let Some((_, rings)) = self.known.iter().rev().find(|(known, _)| Rc::ptr_eq(known, &turn)) {
            return rings.clone();
        }
        let rings = self.separate(&turn.transitions);
        let rings = rings.into_iter().map(|ring| self.number(ring)).list();
        self.known.push((turn, rings.clone()));
        rings
    }

    /// The circles of one turn: those that have no step in common, and do not ask for each other's, are different ones.
    fn separate(&self, turn: &[TransitionId]) -> Vec<Vec<TransitionId>> {
        let mut known = Set::new();
        let turn: Vec<TransitionId> = turn.iter().copied().filter(|transition| known.insert(*transition)).list();
        let mut union = Union::new(self.net.leaving.len());
        for transition in &turn {
            let arc = &self.net.arcs[*transition];
            let mut steps = arc.sources.iter().and(&arc.targets).and(&arc.reads_steps);
            if let Some(first) = steps.next() {
                steps.for_each(|step| union.join(first.index(), step.index()));
            }
        }
        let mut groups: Vec<(usize, Vec<TransitionId>)> = Vec::new();
        for transition in turn {
            let arc = &self.net.arcs[transition];
            let root = arc.sources.first().or(arc.targets.first()).map(|step| union.root(step.index()));
            let Some(root) = root else { continue };
            match groups.iter_mut().find(|(of, _)| *of == root) {
                Some((_, group)) => group.push(transition),
                None => groups.push((root, vec![transition])),
            }
        }
        let rings = groups.into_iter().map(|(_, group)| circles::without_followers(self.model, group));
        rings.filter(|ring| !ring.is_empty()).list()
    }

    fn number(&mut self, transitions: Vec<TransitionId>) -> usize {
        let set = |ring: &[TransitionId]| ring.iter().copied().collect::<Set<_>>();
        let own = set(&transitions);
        let known = self.rings.iter().position(|ring| set(&ring.transitions) == own);
        known.unwrap_or_else(|| {
            let arcs = transitions.iter().map(|id| &self.net.arcs[*id]);
            let steps = arcs.flat(|arc| arc.sources.iter().and(&arc.targets).copied()).collect();
            self.rings.push(Ring { transitions, steps });
            self.rings.len() - 1
        })
    }

    /// The circles that turn whenever they are entered; `None` where one may never be entered, as that relies on values that are
    /// not followed.
    fn certain(self, states: usize) -> Option<Vec<Vec<TransitionId>>> {
        let real = self.real(states);
        let (mut certain, mut doubtful): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
        for turn in &self.turns {
            let found = if turn.granted || !real[turn.from.state] { &mut doubtful } else { &mut certain };
            for ring in &turn.rings {
                if !found.contains(ring) && self.is_entered(turn, *ring) && self.never_rests(*ring) {
                    found.push(*ring);
                }
            }
        }
        if doubtful.iter().any(|ring| !certain.contains(ring)) {
            return None;
        }
        // What turns beside a circle because that waits for it, and need not turn whenever that does, is none of it.
        let set = |ring: &usize| self.rings[*ring].transitions.iter().copied().collect::<Set<_>>();
        let sets: Vec<Set<TransitionId>> = certain.iter().map(set).list();
        certain.retain(|ring| !sets.iter().any(|other| *other != set(ring) && other.is_subset(&set(ring))));
        let mut certain: Vec<_> = certain.into_iter().map(|ring| self.rings[ring].transitions.clone()).list();
        sort(&mut certain);
        Some(certain)
    }

    /// Which states can be reached without relying on what is not followed.
    fn real(&self, states: usize) -> Vec<bool> {
        let mut real = vec![false; states];
        real.iter_mut().take(1).for_each(|first| *first = true);
        loop {
            let mut changed = false;
            for (from, to, granted) in &self.ways {
                if real[*from] && !real[*to] && !granted {
                    real[*to] = true;
                    changed = true;
                }
            }
            if !changed {
                return real;
            }
        }
    }

    /// Whether what begins this search always ends in the circle.
    fn is_entered(&self, turn: &EndlessSearch, ring: usize) -> bool {
        let first = turn.from.first;
        let comes_to_rest = if first { &self.rests_at_first } else { &self.comes_to_rest };
        first && !self.first_rests
            || turn.entries.iter().any(|entry| {
                !comes_to_rest[*entry] && self.leads_to(*entry, ring) && self.always_turns(*entry, ring, first)
            })
    }

    /// Whether no transition of the circle begins a search that comes to rest, or turns elsewhere.
    fn never_rests(&self, ring: usize) -> bool {
        self.rings[ring].transitions.iter().all(|id| {
            let rests = self.comes_to_rest[*id] || self.first_stays && self.rests_at_first[*id];
            !rests && self.always_turns(*id, ring, false)
        })
    }

    /// Whether all searches without end that the transition begins turn in the circle, or in one through its steps.
    fn always_turns(&self, entry: TransitionId, ring: usize, first: bool) -> bool {
        let own = &self.rings[ring].steps;
        let touches = |other: &usize| *other == ring || !self.rings[*other].steps.is_disjoint(own);
        let begun = |turn: &&EndlessSearch| turn.from.first == first && turn.entries.contains(&entry);
        self.turns.iter().filter(begun).all(|turn| turn.rings.iter().any(touches))
    }

    /// Whether clearing the transition has to do with the circle: it is drawn with it, or the circle waits for steps,
    /// variables or commands.
    fn leads_to(&self, entry: TransitionId, ring: usize) -> bool {
        let unit = self.net.unit_of_arc(entry);
        self.rings[ring].transitions.iter().any(|id| {
            let arc = &self.net.arcs[*id];
            let part = &self.net.parts[arc.partial];
            self.net.unit_of_arc(*id) == unit
                || arc.reads_slots
                || !arc.reads_steps.is_empty()
                || part.enclosed_by.is_some()
                || !part.orders.is_empty()
        })
    }
}
