//! One cycle's valuation, as far as it has been asked for.

pub(crate) mod computed;
pub(crate) mod kept;
pub(crate) mod knowledge;

mod decide;
mod sample;
mod values;

use crate::list::List;
use crate::model::{Arena, StepId, TransitionId};
use std::rc::Rc;

use self::knowledge::{Knowledge, Known, Learnt, Tape};
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::formula::{AtomId, Kind};
use crate::analysis::explore::net::links::Tries;
use crate::analysis::explore::net::slots::{Bit, SlotId};
use crate::analysis::explore::net::units::UnitId;
use crate::analysis::explore::search::reduction::{Groups, Waits};
use crate::analysis::explore::semantics::turn::Turn;
use crate::sorted::sort_unstable;

/// A situation at the end of a cycle, with what the next one remembers of it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct State {
    /// Before the first cycle.
    pub(crate) first: bool,
    /// Active steps, ascending.
    pub(crate) active: Box<[StepId]>,
    /// By [`SlotId`].
    pub(crate) slots: Box<[Bit]>,
    /// What edges compare with: the atoms' values in the last snapshot, as far as they were decided. All values that
    /// agree with this are possible.
    pub(crate) before: Box<[(AtomId, Known)]>,
    /// What times have reached, where they are followed.
    pub(crate) ages: Box<[(AtomId, Known)]>,
}

/// Situation and followed values at one moment.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub(crate) struct Snapshot {
    /// Ascending.
    pub(crate) active: Vec<StepId>,
    /// By [`SlotId`].
    pub(crate) slots: Vec<Bit>,
}

/// Which snapshot a formula is about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum When {
    Now,
    /// The one that edges count as present.
    Sample,
    /// The one that edges compare it with.
    Before,
}

pub(crate) struct Valuation<'n> {
    pub(crate) net: &'n Net,
    /// The piece that is explored alone; none is the whole chart.
    pub(crate) unit: Option<UnitId>,
    pub(crate) tape: Tape,
    /// Of this cycle.
    given: Knowledge,
    /// Of the cycle before.
    recorded: Knowledge,
    /// That of it which is so wherever this cycle begins, if anything is computed.
    pub(crate) before: Learnt,
    pub(crate) now: Snapshot,
    /// `sfc`: the snapshot the cycle started from, while its actions run.
    pub(crate) start: Option<Snapshot>,
    /// `grafcet`: the evolution before, in all but the first of a cycle.
    pub(crate) previous: Option<Snapshot>,
    /// The snapshot has no predecessor: no edges (A26).
    pub(crate) edgeless: bool,
    /// Steps entered in this cycle: their time is zero.
    pub(crate) just_entered: Vec<StepId>,
    /// What the running block has written.
    pub(crate) own: Vec<(SlotId, Bit)>,
    /// Searches for stability are not stopped by the bound, but where they are seen to turn for ever.
    pub(crate) to_the_turn: bool,
    /// The last turns that were seen so.
    pub(crate) turns: Vec<Rc<Turn>>,
    /// Transitions that need not be tried in all combinations are not.
    pub(crate) lazy: bool,
    /// How those that are enabled at the start are tried.
    pub(crate) groups: Option<Rc<Groups>>,
    /// Transitions that wait in this run.
    still: Vec<TransitionId>,
    is_still: Arena<TransitionId, bool>,
    /// Atoms that only they read; asking for one spoils the run.
    reserved: Arena<AtomId, bool>,
    reserved_atoms: Vec<AtomId>,
    /// This run is not independent of what waits in it.
    pub(crate) spoilt: bool,
    /// Another run shows the same.
    pub(crate) redundant: bool,
    /// There are no numbers that compare as was decided.
    pub(crate) impossible: bool,
    /// What this run takes for granted of atoms that are not followed; see [`crate::analysis::explore::net::unfollowed`].
    pub(crate) granted: Learnt,
    /// Some of that was asked for when actions might have changed it already.
    pub(crate) late: bool,
    /// Actions that are not followed may have run in this cycle.
    acted: bool,
    /// How often they may have, and how often that let something be forgotten.
    pub(crate) acts: usize,
    forgotten: usize,
    /// The watched pairs of actions that have run together in this run, and which have been seen to before.
    pub(crate) met: Vec<usize>,
    pub(crate) have_met: Vec<bool>,
    pub(crate) waits: Waits,
    /// For trying out whether transitions can wait.
    pub(crate) trial: Option<Box<Valuation<'n>>>,
    /// Whether there are numbers as they were decided, where some are computed; and what may still be tried.
    pub(crate) tries: Tries,
    pub(crate) left: u64,
    /// Units of work done.
    pub(crate) work: u64,
}

impl<'n> Valuation<'n> {
    pub(crate) fn new(net: &'n Net, unit: Option<UnitId>) -> Self {
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
            just_entered: Vec::new(),
            own: Vec::new(),
            to_the_turn: false,
            turns: Vec::new(),
            lazy: false,
            groups: None,
            still: Vec::new(),
            is_still: Arena::filled(net.arcs.len(), false),
            reserved: Arena::filled(atoms, false),
            reserved_atoms: Vec::new(),
            spoilt: false,
            redundant: false,
            impossible: false,
            granted: Vec::new(),
            late: false,
            acted: false,
            acts: 0,
            forgotten: 0,
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
    pub(crate) fn begin(&mut self, state: &State) {
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
        self.just_entered.clear();
        if state.first {
            self.just_entered.extend(&state.active[..]);
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

    /// Begins in the middle of another valuation's cycle, knowing only this.
    pub(crate) fn resume(&mut self, other: &Self, given: &[(AtomId, Known)], recorded: &[(AtomId, Known)]) {
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
        self.just_entered.clone_from(&other.just_entered);
    }

    /// What is known of these atoms in this cycle, and in the snapshot that edges compare with.
    pub(crate) fn knowledge_of(&self, atoms: &[AtomId]) -> (Learnt, Learnt) {
        let known = |knowledge: &Knowledge| -> Vec<(AtomId, Known)> {
            let pairs = atoms.iter().map(|atom| (*atom, knowledge.get(*atom)));
            pairs.filter(|(_, known)| *known != Known::Unknown).list()
        };
        (known(&self.given), known(&self.recorded))
    }

    /// What is known of this cycle, and of the one before.
    pub(crate) fn knowledge(&self) -> (&Knowledge, &Knowledge) {
        (&self.given, &self.recorded)
    }

    /// The transitions wait in this cycle, under these values of what edges look at.
    pub(crate) fn wait(&mut self, transitions: &[TransitionId], values: &[(AtomId, Known)]) {
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
    pub(crate) fn asked(&self) -> Vec<AtomId> {
        let mut asked: Vec<AtomId> = self.given.learnt().iter().and(self.recorded.learnt()).copied().list();
        sort_unstable(&mut asked);
        asked.dedup();
        asked
    }

    /// Whether the transition waits in this cycle.
    pub(crate) fn is_still(&self, transition: TransitionId) -> bool {
        self.is_still[transition]
    }

    /// Whether any transition does.
    pub(crate) fn is_waited(&self) -> bool {
        !self.still.is_empty()
    }

    /// Whether nothing is left to be asked about the atom.
    fn is_settled(&self, atom: AtomId) -> bool {
        match self.given.get(atom) {
            Known::Unknown => false,
            Known::Bool(_) => true,
            Known::Range(low, high) => low == high,
        }
    }

    /// Whether something is left to be asked about one of the atoms.
    pub(crate) fn is_open(&self, atoms: &[AtomId]) -> bool {
        atoms.iter().any(|atom| !self.is_settled(*atom))
    }

    /// What calls give may be another value in the next evolution.
    pub(crate) fn forget_calls(&mut self) {
        self.act();
        for atom in &self.net.calls {
            self.forget(*atom);
        }
    }

    fn act(&mut self) {
        self.acted = true;
        self.acts += 1;
    }

    fn forget(&mut self, atom: AtomId) {
        self.forgotten += usize::from(self.given.get(atom) != Known::Unknown);
        self.given.forget(atom);
    }

    /// How many questions there have been in this run, and how often something known was forgotten: where both are as they were, what was
    /// known has been known all the time, and nothing else.
    pub(crate) fn has_known(&self) -> (usize, usize) {
        (self.tape.asked(), self.forgotten)
    }

    /// Actions that are not followed may have changed what is known of variables.
    pub(crate) fn forget_volatile(&mut self) {
        self.act();
        let net = self.net;
        if !net.has_volatile || !self.given.learnt().iter().any(|atom| net.atoms[*atom].volatile) {
            return;
        }
        self.impossible |= !self.goes_together();
        for atom in self.given.learnt().to_vec() {
            if self.net.atoms[atom].volatile {
                self.forget(atom);
            }
        }
    }
}
