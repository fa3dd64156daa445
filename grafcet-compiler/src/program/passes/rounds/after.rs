//! What several ends of ways would do the same, done once after them.
//!
//! ```text
//! match state.R                          goes = false
//!   R:                                   match state.R
//!     if stop:                             R:
//!       state.R = S                          if stop:
//!       state.M = none                         state.R = S
//!     else:                       ->           state.M = none
//!       match state.M                        else: goes = true
//!         A: …                             T: goes = true
//!   T:                                   if goes:
//!     match state.M                        match state.M
//!       A: …                                 A: …
//! ```

use std::cell::RefCell;

use super::super::several::{Env, weight};
use super::super::uses::{Effects, same_block};
use super::turn::Free;
use crate::program::build::yes;
use crate::program::{Expr, PlaceId, Statement};
use crate::sorted::{Map, Set};

/// In statements: what is more is not done at the end of several ways.
pub(super) const FEW: usize = 8;

/// In statements: so much less there has to be so that one end alone leaves something to what stands after the ways.
const MUCH: usize = 12;

/// What is done at the end of a way with one part, and with those that it leads.
pub(super) struct Unit<'m> {
    /// The part's number.
    pub(super) at: usize,
    pub(super) statements: Vec<Statement<'m>>,
    /// Of one part that is more than `FEW`: what is known in front of it.
    pub(super) known: Option<Env>,
}

/// What stands after the ways.
pub(super) struct Shared<'m> {
    /// False where the ways begin.
    pub(super) goes: Vec<PlaceId>,
    pub(super) statements: Vec<Statement<'m>>,
}

/// A unit that some ends leave to what stands after them.
struct Chosen {
    /// The part's number.
    at: usize,
    /// By end, where it stands there.
    ends: Vec<(usize, usize)>,
    weight: usize,
}

/// Hands out places that tell whether something after the ways is to be done.
pub(super) struct After<'t> {
    free: &'t Free,
    /// By the region that leads and the first unit after it: ends that do the same shall look the same.
    given: RefCell<Map<(usize, usize), PlaceId>>,
}

impl<'t> After<'t> {
    pub(super) fn of(free: &'t Free) -> Self {
        Self { free, given: RefCell::default() }
    }

    /// Takes what is shared out of the ends of the ways of a region.
    pub(super) fn share<'m>(&self, region: usize, ends: &mut [Vec<Unit<'m>>]) -> Shared<'m> {
        let given = self.given.borrow().clone();
        let led = self.led(region, ends);
        // What was tried out needs no places.
        self.given.replace(given);
        let groups = self.groups(region, ends, &led);
        self.take(region, &groups, ends)
    }

    /// What one end does alone, and leaves to what stands after the ways, too: what others share would otherwise have to come after it.
    fn led(&self, region: usize, ends: &[Vec<Unit<'_>>]) -> Set<usize> {
        let mut led = units(ends);
        let with_all = saved(&self.groups(region, ends, &led));
        if with_all < saved(&self.groups(region, ends, &Set::new())) + MUCH {
            return Set::new();
        }
        for unit in &units(ends) {
            led.remove(unit);
            if saved(&self.groups(region, ends, &led)) < with_all {
                led.insert(*unit);
            }
        }
        led
    }

    /// Those units of which it pays that they stand after the ways, by the ends that leave them. Of `led` ones a single end may.
    fn groups(&self, region: usize, ends: &[Vec<Unit<'_>>], led: &Set<usize>) -> Vec<Vec<Chosen>> {
        let mut alone = Set::new();
        loop {
            let groups = groups(chosen(ends, (&alone, led), self.free.moves));
            let rejected = groups.iter().filter(|group| !self.is_worth(region, group, ends.len()));
            let before = alone.len();
            alone.extend(rejected.flatten().map(|unit| unit.at));
            if alone.len() == before {
                return groups;
            }
        }
    }

    fn is_worth(&self, region: usize, group: &[Chosen], ends: usize) -> bool {
        let Some(first) = group.first() else { return false };
        let weight: usize = group.iter().map(|unit| unit.weight).sum();
        let is_much = first.ends.len() == 1 || weight > FEW;
        weight > 0 && (first.ends.len() == ends || is_much && self.place(region, first.at).is_some())
    }

    fn place(&self, region: usize, at: usize) -> Option<PlaceId> {
        let mut given = self.given.borrow_mut();
        if let Some(place) = given.get(&(region, at)) {
            return Some(*place);
        }
        let place = *self.free.goes.get(given.len())?;
        given.insert((region, at), place);
        Some(place)
    }

    fn take<'m>(&self, region: usize, groups: &[Vec<Chosen>], ends: &mut [Vec<Unit<'m>>]) -> Shared<'m> {
        let mut all: Vec<(usize, Option<PlaceId>, Vec<Statement<'m>>)> = Vec::new();
        let mut goes = Vec::new();
        for group in groups {
            let Some(first) = group.first() else { continue };
            let place = (first.ends.len() < ends.len()).then(|| self.place(region, first.at)).flatten();
            goes.extend(place);
            for unit in group {
                let mut statements = Vec::new();
                for (end, at) in &unit.ends {
                    statements = std::mem::take(&mut ends[*end][*at].statements);
                }
                all.push((unit.at, place, statements));
            }
            for (end, _) in &first.ends {
                if let (Some(place), at) = (place, ends[*end].len()) {
                    ends[*end].push(Unit { at, statements: vec![Statement::Set(place, yes())], known: None });
                }
            }
        }
        crate::sorted::sort_by_key(&mut all, |(at, ..)| *at);
        let mut statements: Vec<Statement<'m>> = Vec::new();
        for (_, place, block) in all {
            match (place, statements.last_mut()) {
                (None, _) => statements.extend(block),
                (Some(place), Some(Statement::If(Expr::Place(other), then, _))) if *other == place => {
                    then.extend(block);
                }
                (Some(place), _) => statements.push(Statement::If(Expr::Place(place), block, Vec::new())),
            }
        }
        Shared { goes, statements }
    }
}

/// All units.
fn units(ends: &[Vec<Unit<'_>>]) -> Set<usize> {
    let mut all = Set::new();
    all.extend(ends.iter().flatten().filter(|unit| !unit.statements.is_empty()).map(|unit| unit.at));
    all
}

/// In statements: how much less there is to do where groups are done after the ways.
fn saved(groups: &[Vec<Chosen>]) -> usize {
    let mut all = 0;
    for group in groups {
        let Some(first) = group.first() else { continue };
        let weight: usize = group.iter().map(|unit| unit.weight).sum();
        all += (first.ends.len() - 1) * weight;
    }
    all
}

/// The units that may stand after the ways, the last ones first: after a unit that stays at the end of its way nothing is left that it would have to
/// come after. But for those that stand `alone`; of `led` ones a single end may leave them.
fn chosen(ends: &[Vec<Unit<'_>>], (alone, led): (&Set<usize>, &Set<usize>), moves: PlaceId) -> Vec<Chosen> {
    let mut keys = units(ends);
    keys.retain(|unit| !alone.contains(unit));
    // By end, the units that stay.
    let mut stays: Vec<Vec<bool>> = ends.iter().map(|units| vec![true; units.len()]).collect();
    let mut all = Vec::new();
    for key in keys.iter().rev() {
        let mut places = Vec::new();
        for (end, units) in ends.iter().enumerate() {
            let Some(at) = units.iter().position(|unit| unit.at == *key) else { continue };
            if !units[at].statements.is_empty() && is_last(units, &stays[end], at, moves) {
                places.push((end, at));
            }
        }
        let least = if led.contains(key) { 1 } else { 2 };
        if let Some(chosen) = most(ends, *key, &places, least) {
            for (end, at) in &chosen.ends {
                stays[*end][*at] = false;
            }
            all.push(chosen);
        }
    }
    all
}

/// Whether it may be done after those after it that stay at the end of the way. That something moves all of them may tell.
fn is_last(units: &[Unit<'_>], stays: &[bool], at: usize, moves: PlaceId) -> bool {
    let effects = |unit: &Unit<'_>| {
        let mut effects = Effects::of_all(&unit.statements);
        effects.reads.remove(&moves);
        effects.writes.remove(&moves);
        effects
    };
    let own = effects(&units[at]);
    let after = units.iter().zip(stays).skip(at + 1);
    let mut left = after.filter(|(unit, stays)| **stays && !unit.statements.is_empty());
    left.all(|(unit, _)| own.may_swap(&effects(unit)))
}

/// What most of these do, if as many do.
fn most(ends: &[Vec<Unit<'_>>], key: usize, places: &[(usize, usize)], least: usize) -> Option<Chosen> {
    let block = |(end, at): (usize, usize)| &ends[end][at].statements;
    let mut best: Option<Chosen> = None;
    for place in places {
        let weight = weight(block(*place));
        let is_better = |count: usize| best.as_ref().is_none_or(|best| count * weight > best.ends.len() * best.weight);
        if places.len() < least || !is_better(places.len()) {
            continue;
        }
        let same = places.iter().copied().filter(|other| same_block(block(*other), block(*place)));
        let same: Vec<(usize, usize)> = same.collect();
        if same.len() >= least && is_better(same.len()) {
            best = Some(Chosen { at: key, ends: same, weight });
        }
    }
    best
}

/// Those that the same ends leave to what stands after them.
fn groups(chosen: Vec<Chosen>) -> Vec<Vec<Chosen>> {
    let mut groups: Vec<Vec<Chosen>> = Vec::new();
    for unit in chosen.into_iter().rev() {
        let of = |unit: &Chosen| unit.ends.iter().map(|(end, _)| *end).collect::<Vec<_>>();
        match groups.iter_mut().find(|group| group.first().is_some_and(|first| of(first) == of(&unit))) {
            Some(group) => group.push(unit),
            None => groups.push(vec![unit]),
        }
    }
    groups
}
