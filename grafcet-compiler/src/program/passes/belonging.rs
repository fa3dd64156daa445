//! Regions of which one looks at the state of another, and that are parts of their own all the same.
//!
//! ```text
//! clears.A1→A2 = state.A1 is A1 && a                           clears.B1→B2 = state.B1 is B1 && !(state.A1 is A1)
//! clears.B1→B2 = state.B1 is B1 && !(state.A1 is A1)           if clears.B1→B2: state.B1 = B2
//! if clears.A1→A2: state.A1 = A2                         ->    ----
//! if clears.B1→B2: state.B1 = B2                               clears.A1→A2 = state.A1 is A1 && a
//!                                                              if clears.A1→A2: state.A1 = A2
//! ```
//!
//! Whoever looks at another region stands in front of it. Where two look at each other, they look at copies of the states.

use super::super::build::no;
use super::super::{Expr, PlaceId, PlaceInfo, Statement};
use super::edits::rename;
use super::excluding::Situations;
use super::parts::{Looked, Part, cut, gathers, region_of, written};
use super::uses::{Effects, each_written, is_pure, mentions, same_block, writes_to};
use crate::list::List;
use crate::sorted::Set;

/// Where the state of a region stands, and where its state before may be kept.
pub(super) struct Kept {
    pub(super) state: PlaceId,
    pub(super) copy: Option<PlaceId>,
    /// It is kept there already.
    pub(super) is_made: bool,
}

/// Each group of regions that statements decide about together is a part of its own, if that is another way to cut the list than by what depends on what, and each region
/// moves in one part. `off` tells which truths are false where the list begins.
pub(super) fn finer<'m>(
    (places, situations): (&[PlaceInfo<'m>], &Situations<'_>),
    looked: &Looked<'m>,
    off: &dyn Fn(PlaceId) -> bool,
    copies: &[Kept],
) -> Option<Vec<Part<'m>>> {
    let deciding = Deciding::of(places, looked);
    if (0..places.len()).all(|region| deciding.groups.find(region) == looked.dependent.find(region)) {
        return None;
    }
    let looked = Looked::at(places, deciding.with_copies(gathered(places, &looked.list, off), copies)?);
    let deciding = Deciding::of(places, &looked);
    let regions = deciding.belonging(places, &looked, copies);
    let keys = regions.iter().map(|regions| deciding.groups.key(regions)).list();
    let parts = cut((places, situations), looked.list, &looked.effects, &regions, &keys);
    let mut moved = Set::new();
    let once = parts.iter().all(|part| written(places, &part.statements).iter().all(|region| moved.insert(*region)));
    once.then_some(parts)
}

/// What statements decide about.
pub(super) struct Deciding {
    /// By statement, the regions whose next state it has a part in, also by way of locals.
    pub(super) regions: Vec<Set<usize>>,
    /// The same by place.
    places: Vec<Set<usize>>,
    /// Regions that one statement decides about belong together.
    groups: Groups,
}

impl Deciding {
    pub(super) fn of(places: &[PlaceInfo<'_>], looked: &Looked<'_>) -> Self {
        let list = &looked.list;
        let mut groups = Groups::new(places.len());
        let mut decides: Vec<Set<usize>> = vec![Set::new(); places.len()];
        let mut by_statement = vec![Set::new(); list.len()];
        for (at, statement) in list.iter().enumerate().rev() {
            // A copy of a state is everybody's, and so is what has nothing to do with states.
            if looked.regions[at].is_empty() || is_copy(places, statement) {
                continue;
            }
            let effects = &looked.effects[at];
            let mut own: Set<usize> = effects.writes.iter().filter_map(|place| region_of(places, *place)).collect();
            for place in effects.writes.iter().filter(|place| !places[place.0].is_field) {
                own.extend(decides[place.0].iter().copied());
            }
            if let [first, rest @ ..] = &own[..] {
                for other in rest {
                    groups.join(*first, *other);
                }
            }
            for place in effects.reads.iter().filter(|place| !places[place.0].is_field) {
                decides[place.0].extend(own.iter().copied());
            }
            by_statement[at] = own;
        }
        Self { regions: by_statement, places: decides, groups }
    }

    /// The regions whose next state a place has a part in.
    pub(super) fn about(&self, place: PlaceId) -> &Set<usize> {
        &self.places[place.0]
    }

    /// By statement, the regions that it decides about, or else those whose states, or what decides about them, it asks for.
    fn belonging(&self, places: &[PlaceInfo<'_>], looked: &Looked<'_>, copies: &[Kept]) -> Vec<Set<usize>> {
        let (mut all, mut asked) = (self.regions.clone(), self.places.clone());
        for (region, Kept { copy, .. }) in copies.iter().enumerate() {
            if let Some(copy) = copy {
                asked[copy.0] = Set::new();
                asked[copy.0].insert(region);
            }
        }
        let statements = looked.list.iter().zip(&looked.effects);
        for (own, (statement, effects)) in all.iter_mut().zip(statements).filter(|(own, _)| own.is_empty()) {
            if is_copy(places, statement) {
                continue;
            }
            let adds = gathers(statement);
            for place in effects.reads.iter().filter(|place| Some(**place) != adds) {
                own.extend(region_of(places, *place));
                own.extend(asked[place.0].iter().copied());
            }
            for place in effects.writes.iter().filter(|place| !places[place.0].is_field) {
                asked[place.0].extend(own.iter().copied());
            }
        }
        all
    }

    /// Where groups look at each other's states, they look at copies of them, made in front of all if they are not there. None, where one may not be made.
    fn with_copies<'m>(&self, mut list: Vec<Statement<'m>>, copies: &[Kept]) -> Option<Vec<Statement<'m>>> {
        let reads = list.iter().map(|one| Effects::of(one).reads).list();
        let mut looks: Vec<(usize, usize)> = Vec::new();
        for (own, reads) in self.regions.iter().zip(&reads) {
            let Some(own) = own.first() else { continue };
            for (region, _) in copies.iter().enumerate().filter(|(_, kept)| reads.contains(&kept.state)) {
                let (group, other) = (self.groups.find(*own), self.groups.find(region));
                looks.extend((group != other).then_some((group, other)));
            }
        }
        // Only those in a circle are left.
        loop {
            let before = looks.clone();
            looks.retain(|(group, other)| {
                before.iter().any(|(_, of)| of == group) && before.iter().any(|(of, _)| of == other)
            });
            if looks.len() == before.len() {
                break;
            }
        }
        let mut front = Vec::new();
        for (region, Kept { state, copy, is_made }) in copies.iter().enumerate() {
            let moved = list.iter().position(|one| writes_to(one, *state)).unwrap_or(list.len());
            let mut is_copied = false;
            for at in 0..list.len() {
                let Some(own) = self.regions[at].first() else { continue };
                let is_circle = looks.contains(&(self.groups.find(*own), self.groups.find(region)));
                if is_circle && reads[at].contains(state) {
                    rename(&mut list[at..=at], *state, (*copy).filter(|_| at < moved)?);
                    is_copied = !is_made;
                }
            }
            if let (Some(copy), true) = (copy, is_copied) {
                front.push(Statement::Set(*copy, Expr::Place(*state)));
            }
        }
        let made = |one: &Statement<'m>| {
            front.iter().any(|copy| same_block(std::slice::from_ref(copy), std::slice::from_ref(one)))
        };
        list.retain(|one| !made(one));
        front.extend(list);
        Some(front)
    }
}

/// Whether a statement makes a copy of a state.
fn is_copy(places: &[PlaceInfo<'_>], statement: &Statement<'_>) -> bool {
    matches!(statement, Statement::Set(_, Expr::Place(of)) if region_of(places, *of).is_some())
}

/// What is first put into a truth that is gathered is gathered, too: it need not stand in front of the rest.
fn gathered<'m>(places: &[PlaceInfo<'m>], list: &[Statement<'m>], off: &dyn Fn(PlaceId) -> bool) -> Vec<Statement<'m>> {
    let adds: Set<PlaceId> = list.iter().filter_map(gathers).collect();
    let mut written: Set<PlaceId> = Set::new();
    let mut new = list.to_vec();
    for statement in &mut new {
        if let Statement::Set(place, value) = statement {
            let is_first = off(*place) && adds.contains(place) && !written.contains(place) && !places[place.0].is_field;
            if is_first && is_pure(value) && !mentions(value, *place) {
                let asked = match std::mem::replace(value, no()) {
                    Expr::Any(parts) => parts,
                    one => vec![one],
                };
                *value = Expr::Any(std::iter::once(Expr::Place(*place)).chain(asked).collect());
            }
        }
        each_written(std::slice::from_ref(statement), &mut |place| _ = written.insert(place));
    }
    new
}

/// By region: another one of the same group, or itself.
pub(super) struct Groups(Vec<usize>);

impl Groups {
    /// Each region by itself.
    pub(super) fn new(regions: usize) -> Self {
        Self((0..regions).collect())
    }

    pub(super) fn find(&self, mut region: usize) -> usize {
        while self.0[region] != region {
            region = self.0[region];
        }
        region
    }

    pub(super) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b)] = a.min(b);
    }

    /// None, where there are no regions.
    pub(super) fn key(&self, regions: &Set<usize>) -> Option<usize> {
        let mut own = Set::new();
        own.extend(regions.iter().map(|region| self.find(*region)));
        match own[..] {
            [] => None,
            [one] => Some(one),
            // It looks at several that do not depend on each other.
            _ => Some(usize::MAX),
        }
    }
}
