//! Searches that turn for ever: everything is as it was some evolutions before, and nothing new was asked in between.

use std::cell::Cell;
use std::rc::Rc;

use super::Done;
use super::trail::Lengths;
use crate::analysis::explore::valuation::knowledge::Learnt;
use crate::analysis::explore::valuation::{Snapshot, Valuation};
use crate::list::List;
use crate::model::{StepId, TransitionId};
use crate::sorted::{sort_by_key, sort_unstable};

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

/// Two evolutions with which later ones are compared, and all since the first of them, without a new question: a search that is stopped
/// after twice as many evolutions as there are steps comes back to one of the two, if it turns.
pub(super) struct Anchors {
    older: usize,
    newer: Option<usize>,
    /// How many questions there had been, and how often something known had been forgotten.
    known: (usize, usize),
    /// How often actions that are not followed had run before the older one.
    acts: usize,
    /// From the older one on, with what had happened.
    moments: Vec<(Moment, Lengths)>,
}

/// A turn that some search makes for ever.
#[derive(Debug)]
pub(crate) struct Turn {
    /// What was known of the atoms while it turned.
    given: Learnt,
    /// As they follow each other.
    moments: Vec<Moment>,
    /// Their places, by the moment ascending.
    order: Vec<usize>,
    /// How many of what comes next stand before each of them.
    places: Vec<Lengths>,
    /// As they clear.
    pub(crate) transitions: Vec<TransitionId>,
    /// What else happens in it; not noted where turns are looked for.
    pub(crate) able: Vec<TransitionId>,
    pub(crate) enabled: Vec<TransitionId>,
    /// AND-convergences among those that are enabled.
    pub(crate) joins: Vec<TransitionId>,
    doubled: Vec<(StepId, TransitionId)>,
    /// Actions run in it that are not followed.
    acts: bool,
    /// What happens in it has been noted; see [`Turn::is_new`].
    noted: Cell<bool>,
}

impl Turn {
    /// The moment at which this search is, if it turns so: it is where that one was and knows what that knew.
    fn at(&self, valuation: &Valuation<'_>) -> Option<usize> {
        let (given, _) = valuation.knowledge();
        if self.given.iter().any(|(atom, known)| given.get(*atom) != *known) {
            return None;
        }
        let now = Moment::of(valuation);
        let found = self.order.binary_search_by(|place| self.moments[*place].cmp(&now));
        found.ok().map(|found| self.order[found])
    }

    /// The situations of the turn.
    pub(crate) fn situations(&self) -> impl Iterator<Item = &[StepId]> {
        self.moments.iter().map(|moment| &moment.now.active[..])
    }

    /// What happens in a whole turn and so many evolutions more, from the moment with this number on.
    fn tell(&self, at: usize, more: usize, done: &mut Done) {
        let period = self.moments.len();
        let place = |moment: usize| match self.places.get(moment) {
            Some(place) => (place.cleared, place.doubled),
            None => (self.transitions.len(), self.doubled.len()),
        };
        let mut pieces = vec![at..period, 0..at];
        if at + more <= period {
            pieces.push(at..at + more);
        } else {
            pieces.extend([at..period, 0..at + more - period]);
        }
        for piece in pieces {
            let (from, to) = (place(piece.start), place(piece.end));
            done.cleared.extend_from_slice(&self.transitions[from.0..to.0]);
            done.doubled.extend_from_slice(&self.doubled[from.1..to.1]);
        }
    }

    /// Whether nobody has asked before.
    pub(crate) fn is_new(&self) -> bool {
        !self.noted.replace(true)
    }
}

/// Where the search turns in a circle without asking anything new, it turns until the bound: it goes there at once, or whole turns are
/// left out. Returned is how many evolutions it has made then.
pub(super) fn skip(
    valuation: &mut Valuation<'_>,
    evolution: usize,
    done: &mut Done,
    anchors: &mut Option<Anchors>,
) -> usize {
    if evolution < SOON {
        return evolution;
    }
    let bound = valuation.net.max_evolutions.max(evolution);
    let left = bound - evolution;
    let found = is_alone(valuation).then(|| known(valuation)).flatten();
    // A part of a turn is not worth it, and not all of it would happen.
    if let Some((turn, at)) = found.filter(|(turn, _)| turn.moments.len() <= left) {
        let period = turn.moments.len();
        let moment = &turn.moments[(at + left) % period];
        valuation.now.clone_from(&moment.now);
        valuation.previous.clone_from(&moment.previous);
        valuation.just_entered.clone_from(&moment.just_entered);
        if turn.acts {
            valuation.forget_volatile();
        }
        turn.tell(at, left % period, done);
        done.passed = Some(turn);
        return bound;
    }
    if let Some(met) = anchors.take_if(|anchors| anchors.is_met(valuation)) {
        let period = met.moments.len();
        if is_alone(valuation) {
            met.remember(valuation, done);
        }
        return bound - left % period;
    }
    go_by(valuation, evolution, done, anchors);
    evolution
}

/// The turn that the search makes, if it has made it once or is where another search has made it: from a ring of a thousand steps that
/// all inputs let turn, each of its situations is another beginning of the same turn.
pub(super) fn of(
    valuation: &mut Valuation<'_>,
    evolution: usize,
    done: &Done,
    anchors: &mut Option<Anchors>,
) -> Option<Rc<Turn>> {
    if let Some((turn, _)) = known(valuation) {
        return Some(turn);
    }
    if let Some(met) = anchors.take_if(|anchors| anchors.is_met(valuation)) {
        return Some(met.remember(valuation, done));
    }
    go_by(valuation, evolution, done, anchors);
    None
}

/// Whether nothing else decides how the search goes on than what a turn remembers: no partial grafcet acts on another, of none is
/// looked at a piece, nothing waits in it, and nobody watches which actions meet.
fn is_alone(valuation: &Valuation<'_>) -> bool {
    valuation.net.hierarchy.is_empty() && valuation.unit.is_none() && !valuation.lazy && valuation.have_met.is_empty()
}

/// The turn of another search that this one is in, and where.
fn known(valuation: &Valuation<'_>) -> Option<(Rc<Turn>, usize)> {
    valuation.turns.iter().find_map(|turn| Some((Rc::clone(turn), turn.at(valuation)?)))
}

/// An evolution that was not met before.
fn go_by(valuation: &Valuation<'_>, evolution: usize, done: &Done, anchors: &mut Option<Anchors>) {
    let known = valuation.has_known();
    // What was known in the turn must be known in all of it.
    if anchors.as_ref().is_some_and(|anchors| anchors.known != known) {
        *anchors = None;
    }
    let now = || (Moment::of(valuation), done.lengths());
    match anchors {
        Some(anchors) => {
            if evolution.is_power_of_two() {
                anchors.add(evolution);
            }
            anchors.moments.push(now());
        }
        None if evolution.is_power_of_two() => {
            let acts = valuation.acts;
            *anchors = Some(Anchors { older: evolution, newer: None, known, acts, moments: vec![now()] });
        }
        None => {}
    }
}

impl Anchors {
    fn add(&mut self, evolution: usize) {
        if let Some(newer) = self.newer.replace(evolution) {
            self.forget_before(newer);
        }
    }

    fn forget_before(&mut self, newer: usize) {
        self.moments.drain(..newer - self.older);
        self.older = newer;
    }

    /// Whether the search has turned once since one of them, without asking anything new; that is the older one then.
    fn is_met(&mut self, valuation: &Valuation<'_>) -> bool {
        if self.known != valuation.has_known() {
            return false;
        }
        if self.moments[0].0.is_now(valuation) {
            return true;
        }
        let is_now = |newer: &mut usize| self.moments[*newer - self.older].0.is_now(valuation);
        let Some(newer) = self.newer.take_if(is_now) else { return false };
        self.forget_before(newer);
        true
    }

    /// The turn since then, which other searches may make.
    fn remember(self, valuation: &mut Valuation<'_>, done: &Done) -> Rc<Turn> {
        let (moments, mut places): (Vec<Moment>, Vec<Lengths>) = self.moments.into_iter().unzip();
        let start = places[0].clone();
        for place in &mut places {
            place.cleared -= start.cleared;
            place.doubled -= start.doubled;
        }
        let mut order: Vec<usize> = (0..moments.len()).list();
        sort_by_key(&mut order, |place| &moments[*place]);
        let (known, _) = valuation.knowledge();
        let mut given = Learnt::new();
        for atom in known.learnt() {
            given.push((*atom, known.get(*atom)));
        }
        let (net, enabled) = (valuation.net, done.enabled_later[start.enabled_later..].to_vec());
        let turn = Rc::new(Turn {
            given,
            moments,
            order,
            places,
            transitions: done.cleared[start.cleared..].to_vec(),
            able: done.able[start.able..].to_vec(),
            joins: enabled.iter().copied().filter(|transition| net.arcs[*transition].sources.len() > 1).list(),
            enabled,
            doubled: done.doubled[start.doubled..].to_vec(),
            acts: valuation.acts != self.acts,
            noted: Cell::new(false),
        });
        if valuation.turns.len() == KNOWN {
            valuation.turns.remove(0);
        }
        valuation.turns.push(Rc::clone(&turn));
        turn
    }
}
