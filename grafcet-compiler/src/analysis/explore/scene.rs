//! One cycle's valuation, as far as it has been asked for.

use std::rc::Rc;

use super::formula::{Formula, Kind};
use super::knowledge::{Knowledge, Known, Learnt, Tape};
use super::net::Net;
use super::slots::Bit;
use super::waiting::{Groups, Waits};

/// A situation at the end of a cycle, with what the next one remembers of it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct State {
    /// Before the first cycle.
    pub(super) first: bool,
    /// Active steps, ascending.
    pub(super) active: Box<[usize]>,
    pub(super) slots: Box<[Bit]>,
    /// What edges compare with: the atoms' values in the last snapshot, as far as they were decided. All values that
    /// agree with this are possible.
    pub(super) before: Box<[(usize, Known)]>,
}

/// Situation and followed values at one moment.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(super) struct Snapshot {
    /// Ascending.
    pub(super) active: Vec<usize>,
    pub(super) slots: Vec<Bit>,
}

/// Which snapshot a formula is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum When {
    Now,
    /// The one that edges count as present.
    Sample,
    /// The one that edges compare it with.
    Before,
}

pub(super) struct Scene<'n> {
    pub(super) net: &'n Net,
    /// The piece that is explored alone; none is the whole chart.
    pub(super) unit: Option<usize>,
    pub(super) tape: Tape,
    /// Of this cycle.
    given: Knowledge,
    /// Of the cycle before.
    recorded: Knowledge,
    pub(super) now: Snapshot,
    /// `sfc`: the snapshot the cycle started from, while its actions run.
    pub(super) start: Option<Snapshot>,
    /// `grafcet`: the evolution before, in all but the first of a cycle.
    pub(super) previous: Option<Snapshot>,
    /// The snapshot has no predecessor: no edges (A26).
    pub(super) edgeless: bool,
    /// Steps entered in this cycle: their time is zero.
    pub(super) fresh: Vec<usize>,
    /// What the running block has written.
    pub(super) own: Vec<(usize, Bit)>,
    /// Transitions that need not be tried in all combinations are not.
    pub(super) lazy: bool,
    /// How those that are enabled at the start are tried.
    pub(super) groups: Option<Rc<Groups>>,
    /// Transitions that wait in this run.
    still: Vec<usize>,
    is_still: Vec<bool>,
    /// Atoms that only they read; asking for one spoils the run.
    reserved: Vec<bool>,
    reserved_atoms: Vec<usize>,
    /// This run is not independent of what waits in it.
    pub(super) spoilt: bool,
    /// Another run shows the same.
    pub(super) redundant: bool,
    /// What this run takes for granted of atoms that are not followed; see [`super::unfollowed`].
    pub(super) granted: Learnt,
    /// Some of that was asked for when actions might have changed it already.
    pub(super) late: bool,
    /// Actions that are not followed may have run in this cycle.
    acted: bool,
    pub(super) waits: Waits,
    /// For trying out whether transitions can wait.
    pub(super) trial: Option<Box<Scene<'n>>>,
    /// Units of work done.
    pub(super) work: u64,
}

impl<'n> Scene<'n> {
    pub(super) fn new(net: &'n Net, unit: Option<usize>) -> Self {
        let atoms = net.atoms.len();
        Self {
            net,
            unit,
            tape: Tape::default(),
            given: Knowledge::new(atoms),
            recorded: Knowledge::new(atoms),
            now: Snapshot::default(),
            start: None,
            previous: None,
            edgeless: false,
            fresh: Vec::new(),
            own: Vec::new(),
            lazy: false,
            groups: None,
            still: Vec::new(),
            is_still: vec![false; net.arcs.len()],
            reserved: vec![false; atoms],
            reserved_atoms: Vec::new(),
            spoilt: false,
            redundant: false,
            granted: Vec::new(),
            late: false,
            acted: false,
            waits: Waits::new(),
            trial: None,
            work: 0,
        }
    }

    /// Begins a cycle.
    pub(super) fn begin(&mut self, state: &State) {
        self.work += 2 + state.active.len() as u64;
        self.reset();
        for (atom, known) in &state.before {
            self.recorded.learn(*atom, *known);
        }
        self.now.active.clear();
        self.now.active.extend(&state.active[..]);
        self.now.slots.clear();
        self.now.slots.extend(&state.slots[..]);
        self.start = None;
        self.previous = None;
        self.edgeless = state.first;
        self.fresh.clear();
        if state.first {
            self.fresh.extend(&state.active[..]);
        }
        self.own.clear();
    }

    fn reset(&mut self) {
        self.given.clear();
        self.recorded.clear();
        while let Some(transition) = self.still.pop() {
            self.is_still[transition] = false;
        }
        while let Some(atom) = self.reserved_atoms.pop() {
            self.reserved[atom] = false;
        }
        self.spoilt = false;
        self.redundant = false;
        self.granted.clear();
        self.late = false;
        self.acted = false;
    }

    /// Begins in the middle of another scene's cycle, knowing only this.
    pub(super) fn resume(&mut self, other: &Self, given: &[(usize, Known)], recorded: &[(usize, Known)]) {
        self.work += 1;
        self.reset();
        for (atom, known) in given {
            self.given.learn(*atom, *known);
        }
        for (atom, known) in recorded {
            self.recorded.learn(*atom, *known);
        }
        self.now.clone_from(&other.now);
        self.start.clone_from(&other.start);
        self.previous.clone_from(&other.previous);
        self.edgeless = other.edgeless;
        self.fresh.clone_from(&other.fresh);
    }

    /// What is known of these atoms in this cycle, and in the snapshot that edges compare with.
    pub(super) fn knowledge_of(&self, atoms: &[usize]) -> (Learnt, Learnt) {
        let known = |knowledge: &Knowledge| -> Vec<(usize, Known)> {
            let pairs = atoms.iter().map(|atom| (*atom, knowledge.get(*atom)));
            pairs.filter(|(_, known)| *known != Known::Unknown).collect()
        };
        (known(&self.given), known(&self.recorded))
    }

    /// The transitions wait in this cycle, under these values of what edges look at.
    pub(super) fn wait(&mut self, transitions: &[usize], values: &[(usize, Known)]) {
        let net = self.net;
        for (atom, known) in values {
            self.given.learn(*atom, *known);
        }
        for transition in transitions {
            self.still.push(*transition);
            self.is_still[*transition] = true;
            for atom in &net.arcs[*transition].atoms {
                if net.unfollowed[*atom] {
                    self.granted.push((*atom, Known::Unknown));
                }
                let free = match net.atoms[*atom].kind {
                    Kind::Free | Kind::Number(..) | Kind::Since(_) | Kind::MacroSince(_) => true,
                    Kind::Step(step) => !self.is_own(step),
                    Kind::Macro(id) => !self.owns(id),
                    Kind::Slot(_) => false,
                };
                if free && !self.reserved[*atom] && !self.is_settled(*atom) {
                    self.reserved[*atom] = true;
                    self.reserved_atoms.push(*atom);
                }
            }
        }
    }

    /// Whether the transition waits in this cycle.
    pub(super) fn is_still(&self, transition: usize) -> bool {
        self.is_still[transition]
    }

    /// Whether any transition does.
    pub(super) fn is_waited(&self) -> bool {
        !self.still.is_empty()
    }

    /// Whether nothing is left to be asked about the atom.
    fn is_settled(&self, atom: usize) -> bool {
        match self.given.get(atom) {
            Known::Unknown => false,
            Known::Bool(_) => true,
            Known::Range(low, high) => low == high,
        }
    }

    /// Whether the formula holds; what is not decided yet is decided now.
    pub(super) fn decide(&mut self, formula: &Formula, when: When) -> bool {
        if let Some(value) = self.known(formula, when) {
            return value;
        }
        match formula {
            Formula::Const(value) => *value,
            Formula::Is(atom) => self.ask(*atom, when),
            Formula::Below(atom, bound) => self.ask_below(*atom, *bound, when),
            Formula::Equals(atom, bound) => self.ask_equal(*atom, *bound, when),
            Formula::Not(inner) => !self.decide(inner, when),
            Formula::And(a, b) => self.decide(a, when) && self.decide(b, when),
            Formula::Or(a, b) => self.decide(a, when) || self.decide(b, when),
            Formula::Same(a, b) => self.decide(a, when) == self.decide(b, when),
            Formula::Rising(edge) => match &self.net.edges[*edge] {
                Some(of) => self.decide(of, When::Sample) && !self.decide(of, When::Before),
                None => false,
            },
            Formula::Falling(edge) => match &self.net.edges[*edge] {
                Some(of) => !self.decide(of, When::Sample) && self.decide(of, When::Before),
                None => false,
            },
            Formula::Shared(index) => self.decide(&self.net.shared[*index], when),
        }
    }

    /// Whether the formula holds, as far as that follows from what has been decided.
    fn known(&mut self, formula: &Formula, when: When) -> Option<bool> {
        self.work += 1;
        match formula {
            Formula::Const(value) => Some(*value),
            Formula::Is(atom) => match self.value(*atom, when) {
                Known::Bool(value) => Some(value),
                _ => None,
            },
            Formula::Below(atom, bound) => match self.value(*atom, when) {
                Known::Range(_, high) if high < *bound => Some(true),
                Known::Range(low, _) if low >= *bound => Some(false),
                _ => None,
            },
            Formula::Equals(atom, bound) => match self.value(*atom, when) {
                Known::Range(low, high) if low == *bound && high == *bound => Some(true),
                Known::Range(low, high) if *bound < low || *bound > high => Some(false),
                _ => None,
            },
            Formula::Not(inner) => self.known(inner, when).map(|value| !value),
            Formula::And(a, b) => match self.known(a, when) {
                Some(false) => Some(false),
                Some(true) => self.known(b, when),
                None => self.known(b, when).filter(|b| !b),
            },
            Formula::Or(a, b) => match self.known(a, when) {
                Some(true) => Some(true),
                Some(false) => self.known(b, when),
                None => self.known(b, when).filter(|b| *b),
            },
            Formula::Same(a, b) => Some(self.known(a, when)? == self.known(b, when)?),
            Formula::Rising(edge) => self.known_edge(*edge, true),
            Formula::Falling(edge) => self.known_edge(*edge, false),
            Formula::Shared(index) => self.known(&self.net.shared[*index], when),
        }
    }

    fn known_edge(&mut self, edge: usize, to: bool) -> Option<bool> {
        if self.edgeless {
            return Some(false);
        }
        let net = self.net;
        let Some(of) = &net.edges[edge] else { return Some(false) };
        let now = self.known(of, When::Sample);
        if now == Some(!to) {
            return Some(false);
        }
        match self.known(of, When::Before) {
            Some(before) if before == to => Some(false),
            Some(_) => now.map(|now| now == to),
            None => None,
        }
    }

    /// What is known of an atom.
    fn value(&mut self, atom: usize, when: When) -> Known {
        if self.reserved[atom] {
            self.spoilt = true;
        }
        self.value_of(atom, when)
    }

    fn value_of(&self, atom: usize, when: When) -> Known {
        let net = self.net;
        let kind = net.atoms[atom].kind;
        if when == When::Before && self.previous.is_none() {
            return self.recorded_value(atom, kind);
        }
        match kind {
            Kind::Number(low, high) => match self.given.get(atom) {
                Known::Unknown => Known::Range(low, high),
                known => known,
            },
            Kind::Step(step) if self.is_own(step) => Known::Bool(self.at(when).active.binary_search(&step).is_ok()),
            Kind::Macro(id) if self.owns(id) => Known::Bool(self.any_active(id, when)),
            Kind::Free | Kind::Step(_) | Kind::Macro(_) => self.given.get(atom),
            Kind::Slot(slot) => self.slot(slot, when),
            Kind::Since(step) => {
                let active = self.at(when).active.binary_search(&step).is_ok();
                let timed = active || self.is_left(&[step], when);
                let zero = self.is_own(step) && (!timed || self.fresh.contains(&step));
                self.time(atom, zero)
            }
            Kind::MacroSince(id) => {
                let timed = self.any_active(id, when) || self.is_left(&net.macros[id], when);
                let zero = self.owns(id) && !timed;
                self.time(atom, zero)
            }
        }
    }

    /// `sfc`: whether the actions run of a cycle in which one of the steps was left: it has the time it had reached (A34).
    fn is_left(&self, steps: &[usize], when: When) -> bool {
        let was = |start: &Snapshot| steps.iter().any(|step| start.active.binary_search(step).is_ok());
        when == When::Now && self.start.as_ref().is_some_and(was)
    }

    fn recorded_value(&self, atom: usize, kind: Kind) -> Known {
        match (self.recorded.get(atom), kind) {
            (Known::Unknown, Kind::Number(low, high)) => Known::Range(low, high),
            (Known::Unknown, Kind::Since(_) | Kind::MacroSince(_)) => Known::Range(0, i128::from(u32::MAX)),
            (known, _) => known,
        }
    }

    fn slot(&self, slot: usize, when: When) -> Known {
        let own = self.own.iter().rev().find(|(written, _)| *written == slot);
        let bit = match own {
            Some((_, bit)) if when == When::Now => *bit,
            _ => self.at(when).slots[slot],
        };
        match bit {
            Bit::False => Known::Bool(false),
            Bit::True => Known::Bool(true),
            Bit::Any => Known::Unknown,
        }
    }

    fn time(&self, atom: usize, zero: bool) -> Known {
        match self.given.get(atom) {
            _ if zero => Known::Range(0, 0),
            Known::Unknown => Known::Range(0, i128::from(u32::MAX)),
            known => known,
        }
    }

    fn at(&self, when: When) -> &Snapshot {
        match when {
            When::Now => &self.now,
            When::Sample => self.start.as_ref().unwrap_or(&self.now),
            When::Before => self.previous.as_ref().unwrap_or(&self.now),
        }
    }

    /// Whether the step belongs to what is explored.
    fn is_own(&self, step: usize) -> bool {
        self.unit.is_none_or(|unit| self.net.unit_of[step] == unit)
    }

    fn owns(&self, id: usize) -> bool {
        self.net.macros[id].first().is_none_or(|step| self.is_own(*step))
    }

    fn any_active(&self, id: usize, when: When) -> bool {
        let active = &self.at(when).active;
        self.net.macros[id].iter().any(|step| active.binary_search(step).is_ok())
    }

    fn ask(&mut self, atom: usize, when: When) -> bool {
        let value = self.can_hold(atom, when) && self.tape.choose(2) == 1;
        self.learn(atom, when, Known::Bool(value));
        value
    }

    /// Whether a boolean atom can be true: a step of another piece only beside the steps that are known to be active.
    fn can_hold(&self, atom: usize, when: When) -> bool {
        let net = self.net;
        let Kind::Step(step) = net.atoms[atom].kind else { return true };
        let is_apart = |other: &usize| match net.atoms[*other].kind {
            Kind::Step(of) => of != step && self.given.get(*other) == Known::Bool(true) && !net.may_meet(step, of),
            _ => false,
        };
        when == When::Before
            || self.now.active.iter().all(|own| net.may_meet(step, *own)) && !self.given.learnt().iter().any(is_apart)
    }

    fn ask_below(&mut self, atom: usize, bound: i128, when: When) -> bool {
        let Known::Range(low, high) = self.value(atom, when) else { return false };
        let below = self.tape.choose(2) == 1;
        let known = if below { Known::Range(low, bound - 1) } else { Known::Range(bound, high) };
        self.learn(atom, when, known);
        below
    }

    fn ask_equal(&mut self, atom: usize, bound: i128, when: When) -> bool {
        let Known::Range(low, high) = self.value(atom, when) else { return false };
        let mut parts = vec![(bound, bound)];
        if low < bound {
            parts.push((low, bound - 1));
        }
        if high > bound {
            parts.push((bound + 1, high));
        }
        let part = self.tape.choose(parts.len());
        self.learn(atom, when, Known::Range(parts[part].0, parts[part].1));
        part == 0
    }

    fn learn(&mut self, atom: usize, when: When, known: Known) {
        if self.net.unfollowed[atom] || matches!(self.net.atoms[atom].kind, Kind::Slot(_)) {
            self.late |= self.acted;
            self.granted.retain(|(other, _)| *other != atom);
            self.granted.push((atom, known));
        }
        if when == When::Before && self.previous.is_none() {
            self.recorded.learn(atom, known);
            return;
        }
        if let (Kind::Slot(slot), Known::Bool(value)) = (self.net.atoms[atom].kind, known) {
            // A value that could be either is one of the two from now on.
            let snapshot = match when {
                When::Now => &mut self.now,
                When::Sample => self.start.as_mut().unwrap_or(&mut self.now),
                When::Before => self.previous.as_mut().unwrap_or(&mut self.now),
            };
            snapshot.slots[slot] = Bit::from(value);
            return;
        }
        self.given.learn(atom, known);
    }

    /// Actions that are not followed may have changed what is known of variables.
    pub(super) fn forget_volatile(&mut self) {
        self.acted = true;
        for atom in self.given.learnt().to_vec() {
            if self.net.atoms[atom].volatile {
                self.given.forget(atom);
            }
        }
    }

    /// What was decided about this cycle, and about the cycle before it, ascending.
    pub(super) fn decided(&self) -> (Learnt, Learnt) {
        let decided = |knowledge: &Knowledge| {
            let pairs = knowledge.learnt().iter().map(|atom| (*atom, knowledge.get(*atom)));
            let mut pairs: Vec<_> = pairs.filter(|(_, known)| *known != Known::Unknown).collect();
            pairs.sort_unstable();
            pairs.dedup();
            pairs
        };
        // What assumptions say of other inputs of the cycle before need not be what was decided there.
        let mut past = decided(&self.recorded);
        past.retain(|(atom, _)| self.net.is_edge_atom[*atom]);
        (decided(&self.given), past)
    }

    /// Whether something is known of an atom of the formula, which is about inputs: in this cycle, or the one before.
    pub(super) fn touches(&self, formula: &Formula, when: When) -> bool {
        let knowledge = if when == When::Before { &self.recorded } else { &self.given };
        match formula {
            Formula::Is(atom) | Formula::Below(atom, _) | Formula::Equals(atom, _) => {
                knowledge.get(*atom) != Known::Unknown
            }
            Formula::Not(inner) => self.touches(inner, when),
            Formula::And(a, b) | Formula::Or(a, b) | Formula::Same(a, b) => {
                self.touches(a, when) || self.touches(b, when)
            }
            Formula::Const(_) | Formula::Rising(_) | Formula::Falling(_) | Formula::Shared(_) => false,
        }
    }

    /// The same as [`Scene::decide`] for what is about inputs: in this cycle, or the one before.
    pub(super) fn decide_inputs(&mut self, formula: &Formula, when: When) -> bool {
        // Between evolutions of one cycle the inputs do not change.
        let previous = self.previous.take();
        let value = self.decide(formula, when);
        self.previous = previous;
        value
    }

    /// The atoms that edges look at which may be asked for in the next cycle, ascending.
    fn edge_atoms(&self) -> Vec<usize> {
        let mut atoms: Vec<usize> = Vec::new();
        for step in &self.now.active {
            atoms.extend(&self.net.edge_atoms[*step]);
        }
        atoms.extend(&self.net.common_edge_atoms);
        atoms.sort_unstable();
        atoms.dedup();
        atoms
    }

    /// Decides all that the edges of the next cycle may compare with.
    pub(super) fn decide_edges(&mut self, when: When) {
        let (net, atoms) = (self.net, self.edge_atoms());
        for (edge, of) in net.edges.iter().enumerate() {
            if let Some(of) = of.as_ref().filter(|_| net.edge_reads(edge, &atoms)) {
                self.decide(of, when);
            }
        }
    }

    /// What the edges that may be asked for in the next cycle compare with.
    pub(super) fn sample(&self, when: When) -> Vec<(usize, Known)> {
        let net = self.net;
        let mut sampled = Vec::new();
        for atom in self.edge_atoms() {
            let known = self.value_of(atom, when);
            let said = match net.atoms[atom].kind {
                Kind::Number(low, high) => known != Known::Range(low, high),
                Kind::Since(_) | Kind::MacroSince(_) => known != Known::Range(0, i128::from(u32::MAX)),
                _ => known != Known::Unknown,
            };
            if said {
                sampled.push((atom, known));
            }
        }
        sampled
    }
}
