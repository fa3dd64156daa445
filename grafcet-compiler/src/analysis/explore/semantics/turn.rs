//! Searches that turn for ever: everything is as it was some evolutions before, and nothing new was asked in between.

use std::rc::Rc;

use crate::analysis::explore::valuation::knowledge::Learnt;
use crate::analysis::explore::valuation::{Snapshot, Valuation};
use crate::model::{StepId, TransitionId};
use crate::sorted::{sort, sort_unstable};

/// So many times the bound a search is followed that may turn for ever.
pub(super) const FAR: usize = 16;

/// Most searches come to rest before so many evolutions.
const SOON: usize = 8;

/// So many turns are remembered.
const KNOWN: usize = 8;

/// What decides how a search goes on, besides what is known of the atoms.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Moment {
    now: Snapshot,
    previous: Option<Snapshot>,
    /// Ascending.
    just_entered: Vec<StepId>,
}

impl Moment {
    fn of(valuation: &Valuation<'_>) -> Self {
        let mut just_entered = valuation.just_entered.clone();
        sort_unstable(&mut just_entered);
        Self { now: valuation.now.clone(), previous: valuation.previous.clone(), just_entered }
    }

    fn is_now(&self, valuation: &Valuation<'_>) -> bool {
        // What differs most is looked at first.
        self.now == valuation.now && *self == Self::of(valuation)
    }
}

/// An evolution with which later ones are compared.
pub(super) struct Anchor {
    evolution: usize,
    /// How many transitions had cleared.
    cleared: usize,
    asked: usize,
    moment: Moment,
    /// After it, where the turn is looked for.
    since: Vec<Moment>,
}

/// A turn that some search makes for ever.
#[derive(Debug)]
pub(crate) struct Turn {
    /// What was known of the atoms while it turned.
    given: Learnt,
    /// Ascending.
    moments: Vec<Moment>,
    /// As they clear.
    pub(crate) transitions: Vec<TransitionId>,
}

impl Turn {
    /// Whether a search turns so that is where this one is and knows what it knows.
    fn takes(&self, valuation: &Valuation<'_>) -> bool {
        let (given, _) = valuation.knowledge();
        self.given.iter().all(|(atom, known)| given.get(*atom) == *known)
            && self.moments.binary_search(&Moment::of(valuation)).is_ok()
    }
}

/// Where the search turns in a circle without asking anything new, it turns until the bound: whole turns are left out.
pub(super) fn skip(valuation: &Valuation<'_>, evolution: usize, anchor: &mut Option<Anchor>) -> usize {
    if evolution < SOON {
        return evolution;
    }
    if let Some(known) = anchor.as_ref().filter(|known| known.is_met(valuation)) {
        let period = evolution - known.evolution;
        let bound = valuation.net.max_evolutions.max(evolution);
        return bound - (bound - evolution) % period;
    }
    if evolution.is_power_of_two() {
        *anchor = Some(Anchor::new(valuation, evolution, 0));
    }
    evolution
}

/// The turn that the search makes, if it has made it once or is where another search has made it: from a ring of a thousand steps that
/// all inputs let turn, each of its situations is another beginning of the same turn.
pub(super) fn of(
    valuation: &mut Valuation<'_>,
    evolution: usize,
    cleared: &[TransitionId],
    anchor: &mut Option<Anchor>,
) -> Option<Rc<Turn>> {
    if let Some(turn) = valuation.turns.iter().find(|turn| turn.takes(valuation)) {
        return Some(Rc::clone(turn));
    }
    if let Some(known) = anchor.take_if(|known| known.is_met(valuation)) {
        let turn = Rc::new(known.turn(valuation, cleared));
        if valuation.turns.len() == KNOWN {
            valuation.turns.remove(0);
        }
        valuation.turns.push(Rc::clone(&turn));
        return Some(turn);
    }
    if evolution.is_power_of_two() {
        *anchor = Some(Anchor::new(valuation, evolution, cleared.len()));
    } else if let Some(anchor) = anchor.as_mut().filter(|anchor| anchor.asked == valuation.tape.asked()) {
        anchor.since.push(Moment::of(valuation));
    }
    None
}

impl Anchor {
    fn new(valuation: &Valuation<'_>, evolution: usize, cleared: usize) -> Self {
        let (asked, moment) = (valuation.tape.asked(), Moment::of(valuation));
        Self { evolution, cleared, asked, moment, since: Vec::new() }
    }

    /// Whether the search has turned once since then, without asking anything new.
    fn is_met(&self, valuation: &Valuation<'_>) -> bool {
        self.asked == valuation.tape.asked() && self.moment.is_now(valuation)
    }

    /// The turn since then.
    fn turn(self, valuation: &Valuation<'_>, cleared: &[TransitionId]) -> Turn {
        let mut moments = self.since;
        moments.push(self.moment);
        sort(&mut moments);
        let (known, _) = valuation.knowledge();
        let mut given = Learnt::new();
        for atom in known.learnt() {
            given.push((*atom, known.get(*atom)));
        }
        Turn { given, moments, transitions: cleared[self.cleared..].to_vec() }
    }
}
