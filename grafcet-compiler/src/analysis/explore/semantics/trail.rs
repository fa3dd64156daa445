//! Runs of a search for stability that follow each other answer the first questions alike: they are taken up where they part.
//!
//! A chain of transient steps asks one question an evolution, and each run goes one evolution further than the one before: from its
//! beginning that would be a hundred evolutions for fourteen runs.

use super::Done;
use crate::analysis::explore::valuation::Valuation;
use crate::analysis::explore::valuation::kept::Kept;

/// The way of the last run, as far as others may be taken up from it.
#[derive(Default)]
pub(crate) struct Trail {
    /// What has happened in the run.
    pub(super) done: Done,
    pub(super) evolutions: usize,
    /// The units of work that had been done when it began.
    work: u64,
    /// Before evolutions that asked something, the first of them first.
    marks: Vec<Mark>,
    /// Their memory is used again.
    spare: Vec<Mark>,
    /// Other runs follow.
    followed: bool,
}

/// How things were before an evolution.
#[derive(Default)]
struct Mark {
    /// How many questions there had been.
    asked: usize,
    evolutions: usize,
    /// Units of work since the run began.
    work: u64,
    lengths: Lengths,
    kept: Kept,
}

/// How much had happened by then.
#[derive(Clone, Default, Debug)]
pub(super) struct Lengths {
    pub(super) cleared: usize,
    pub(super) able: usize,
    pub(super) enabled_later: usize,
    transient: usize,
    pub(super) doubled: usize,
}

impl Trail {
    /// For runs that follow each other from one state.
    pub(crate) fn followed() -> Self {
        Self { followed: true, ..Self::default() }
    }

    /// Whether runs may be taken up in the middle: in the first evolution, and where transitions are not tried in all combinations, more is
    /// asked than their conditions.
    pub(super) fn is_marked(&self, valuation: &Valuation<'_>) -> bool {
        self.followed && self.evolutions > 0 && !valuation.lazy
    }

    /// A run begins.
    pub(super) fn begin(&mut self, valuation: &Valuation<'_>) {
        self.done = Done::default();
        self.evolutions = 0;
        self.work = valuation.work;
        self.spare.append(&mut self.marks);
    }

    /// An evolution comes next in which something may be asked.
    pub(super) fn mark(&mut self, valuation: &Valuation<'_>, lengths: Lengths) {
        if self.marks.last().is_some_and(|mark| mark.asked == valuation.tape.asked()) {
            // It is taken up there.
            return;
        }
        let mut mark = self.spare.pop().unwrap_or_default();
        mark.asked = valuation.tape.asked();
        mark.evolutions = self.evolutions;
        mark.work = valuation.work - self.work;
        mark.lengths = lengths;
        mark.kept.keep(valuation);
        self.marks.push(mark);
    }

    /// Nothing is to be taken up before an evolution that has asked nothing.
    pub(super) fn unmark(&mut self, valuation: &Valuation<'_>) {
        if self.marks.last().is_some_and(|mark| mark.asked == valuation.tape.asked()) {
            self.spare.extend(self.marks.pop());
        }
    }

    /// Goes back to the last evolution before which this run has answered as the one before; `false` where it has to begin anew.
    pub(super) fn take_up(&mut self, valuation: &mut Valuation<'_>) -> bool {
        while self.marks.last().is_some_and(|mark| !valuation.tape.repeats(mark.asked)) {
            self.spare.extend(self.marks.pop());
        }
        let Some(mark) = self.marks.last() else { return false };
        valuation.tape.skip_to(mark.asked);
        // As many as if it had been run again.
        self.work = valuation.work;
        valuation.work += mark.work;
        mark.kept.restore(valuation);
        self.evolutions = mark.evolutions;
        self.done.shorten(&mark.lengths);
        true
    }
}

impl Done {
    pub(super) fn lengths(&self) -> Lengths {
        Lengths {
            cleared: self.cleared.len(),
            able: self.able.len(),
            enabled_later: self.enabled_later.len(),
            transient: self.transient.len(),
            doubled: self.doubled.len(),
        }
    }

    fn shorten(&mut self, lengths: &Lengths) {
        self.cleared.truncate(lengths.cleared);
        self.able.truncate(lengths.able);
        self.enabled_later.truncate(lengths.enabled_later);
        self.transient.truncate(lengths.transient);
        self.doubled.truncate(lengths.doubled);
        (self.unstable, self.turn, self.passed, self.too_long) = (false, None, None, false);
    }
}
