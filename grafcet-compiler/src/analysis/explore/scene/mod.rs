//! One cycle's valuation, as far as it has been asked for.

mod decide;
mod sample;
mod values;

use crate::list::List;
use std::rc::Rc;

use super::computed;
use super::formula::Kind;
use super::knowledge::{Knowledge, Known, Learnt, Tape};
use super::links::Tries;
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
    /// What times have reached, where they are followed.
    pub(super) ages: Box<[(usize, Known)]>,
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
    /// That of it which is so wherever this cycle begins, if anything is computed.
    pub(super) before: Learnt,
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
    /// Searches for stability are not stopped by the bound, but where they are seen to turn for ever.
    pub(super) to_the_turn: bool,
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
    /// There are no numbers that compare as was decided.
    pub(super) impossible: bool,
    /// What this run takes for granted of atoms that are not followed; see [`super::unfollowed`].
    pub(super) granted: Learnt,
    /// Some of that was asked for when actions might have changed it already.
    pub(super) late: bool,
    /// Actions that are not followed may have run in this cycle.
    acted: bool,
    /// The watched pairs of actions that have run together in this run, and which have been seen to before.
    pub(super) met: Vec<usize>,
    pub(super) have_met: Vec<bool>,
    pub(super) waits: Waits,
    /// For trying out whether transitions can wait.
    pub(super) trial: Option<Box<Scene<'n>>>,
    /// Whether there are numbers as they were decided, where some are computed; and what may still be tried.
    pub(super) tries: Tries,
    pub(super) left: u64,
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
            before: Learnt::new(),
            now: Snapshot::default(),
            start: None,
            previous: None,
            edgeless: false,
            fresh: Vec::new(),
            own: Vec::new(),
            to_the_turn: false,
            lazy: false,
            groups: None,
            still: Vec::new(),
            is_still: vec![false; net.arcs.len()],
            reserved: vec![false; atoms],
            reserved_atoms: Vec::new(),
            spoilt: false,
            redundant: false,
            impossible: false,
            granted: Vec::new(),
            late: false,
            acted: false,
            met: Vec::new(),
            have_met: Vec::new(),
            waits: Waits::new(),
            trial: None,
            tries: Tries::new(),
            left: computed::ALL,
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
        if self.net.links.any_computed() {
            self.before.clear();
            self.before.extend(&state.before[..]);
        }
        for (atom, known) in &state.ages {
            self.given.learn(*atom, *known);
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
        self.impossible = false;
        self.granted.clear();
        self.late = false;
        self.acted = false;
        self.met.clear();
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
            pairs.filter(|(_, known)| *known != Known::Unknown).list()
        };
        (known(&self.given), known(&self.recorded))
    }

    /// What is known of this cycle, and of the one before.
    pub(super) fn knowledge(&self) -> (&Knowledge, &Knowledge) {
        (&self.given, &self.recorded)
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
                    Kind::Free | Kind::Number(..) | Kind::Since(_) | Kind::MacroSince(_) | Kind::Phase(_) => true,
                    Kind::Step(step) | Kind::Was(step) => !self.is_own(step),
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

    /// The atoms of which something is known in this run.
    pub(super) fn asked(&self) -> Vec<usize> {
        let mut asked: Vec<usize> = self.given.learnt().iter().chain(self.recorded.learnt()).copied().list();
        asked.sort_unstable();
        asked.dedup();
        asked
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

    /// What calls give may be another value in the next evolution.
    pub(super) fn forget_calls(&mut self) {
        self.acted = true;
        for atom in &self.net.calls {
            self.given.forget(*atom);
        }
    }

    /// Actions that are not followed may have changed what is known of variables.
    pub(super) fn forget_volatile(&mut self) {
        self.acted = true;
        self.impossible |= !self.goes_together();
        for atom in self.given.learnt().to_vec() {
            if self.net.atoms[atom].volatile {
                self.given.forget(atom);
            }
        }
    }
}
