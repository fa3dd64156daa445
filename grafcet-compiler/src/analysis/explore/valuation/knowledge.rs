//! What is known of the atoms, and the choices by which it became known.

use crate::analysis::explore::net::formula::AtomId;
use crate::model::Arena;

/// What is known of an atom's value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Known {
    /// Nothing has been asked.
    Unknown,
    Bool(bool),
    /// A number from the first to the last.
    Range(i128, i128),
}

/// Atoms by number, with what is known of them.
pub(crate) type Learnt = Vec<(AtomId, Known)>;

/// What is known of each atom, by number. Clearing costs what was learnt, not the number of atoms.
#[derive(Debug)]
pub(crate) struct Knowledge {
    values: Arena<AtomId, Known>,
    learnt: Vec<AtomId>,
}

impl Knowledge {
    pub(crate) fn new(atoms: usize) -> Self {
        Self { values: Arena::filled(atoms, Known::Unknown), learnt: Vec::new() }
    }

    pub(crate) fn get(&self, atom: AtomId) -> Known {
        self.values[atom]
    }

    pub(crate) fn learn(&mut self, atom: AtomId, known: Known) {
        if self.values[atom] == Known::Unknown {
            self.learnt.push(atom);
        }
        self.values[atom] = known;
    }

    pub(crate) fn forget(&mut self, atom: AtomId) {
        self.values[atom] = Known::Unknown;
    }

    pub(crate) fn clear(&mut self) {
        while let Some(atom) = self.learnt.pop() {
            self.values[atom] = Known::Unknown;
        }
    }

    /// The atoms something was learnt about; one that was forgotten in between may come twice.
    pub(crate) fn learnt(&self) -> &[AtomId] {
        &self.learnt
    }
}

/// The answers of one run, in the order of the questions. Runs that follow each other take all possible answers.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    /// The answer and how many there are.
    answers: Vec<(usize, usize)>,
    at: usize,
}

impl Tape {
    /// An answer from 0 to below `count`.
    pub(crate) fn choose(&mut self, count: usize) -> usize {
        if self.at == self.answers.len() {
            self.answers.push((0, count));
        }
        let answer = self.answers[self.at].0;
        self.at += 1;
        answer
    }

    /// How many questions there were so far.
    pub(crate) fn asked(&self) -> usize {
        self.at
    }

    /// Whether the first `count` answers of this run are those of the run before.
    pub(crate) fn repeats(&self, count: usize) -> bool {
        count < self.answers.len()
    }

    /// Goes on after the first `count` answers.
    pub(crate) fn skip_to(&mut self, count: usize) {
        self.at = count;
    }

    /// Goes to the next sequence of answers; `false` if this was the last.
    pub(crate) fn advance(&mut self) -> bool {
        self.answers.truncate(self.at);
        self.at = 0;
        while let Some((answer, count)) = self.answers.pop() {
            if answer + 1 < count {
                self.answers.push((answer + 1, count));
                return true;
            }
        }
        false
    }

    /// The same, where the first `floor` answers stay.
    pub(crate) fn advance_above(&mut self, floor: usize) -> bool {
        self.answers.truncate(self.at);
        self.at = 0;
        while self.answers.len() > floor {
            if let Some((answer, count)) = self.answers.pop() {
                if answer + 1 < count {
                    self.answers.push((answer + 1, count));
                    return true;
                }
            }
        }
        false
    }

    /// Gives the first `count` answers again, then new ones.
    pub(crate) fn rewind_to(&mut self, count: usize) {
        self.answers.truncate(count);
        self.at = 0;
    }

    pub(crate) fn restart(&mut self) {
        self.answers.clear();
        self.at = 0;
    }
}
