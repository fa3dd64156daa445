//! A list of statements put into another order and cut into parts: those that concern the same regions stand beside each other.
//!
//! ```text
//! clears.A1→A2 = state.A1 is A1 && x0            clears.A1→A2 = state.A1 is A1 && x0
//! clears.B1→B2 = state.B1 is B1 && x1            if clears.A1→A2: state.A1 = A2
//! if clears.A1→A2: state.A1 = A2           ->    ----
//! if clears.B1→B2: state.B1 = B2                 clears.B1→B2 = state.B1 is B1 && x1
//!                                                if clears.B1→B2: state.B1 = B2
//! ```
//!
//! In which order they may stand says `order`.

use super::super::build::no;
use super::super::{Expr, PlaceId, PlaceInfo, Role, Statement};
use super::belonging::Groups;
use super::excluding::{Excluding, Situations};
use super::order::Order;
use super::sparse::deciding;
use super::uses::{Effects, each_read, each_written, is_pure, mentions};
use crate::list::List;
use crate::sorted::Set;

/// Some statements, and the regions they concern.
#[derive(Clone)]
pub(super) struct Part<'m> {
    pub(super) statements: Vec<Statement<'m>>,
    pub(super) regions: Set<usize>,
}

/// What is so where one of several regions says it, asked of each region by a statement of its own. `off` tells which truths are false
/// where the list begins.
pub(super) fn spread<'m>(
    places: &[PlaceInfo<'m>],
    list: Vec<Statement<'m>>,
    off: &dyn Fn(PlaceId) -> bool,
) -> Vec<Statement<'m>> {
    let may_spread =
        |one: &Statement<'m>| matches!(one, Statement::Set(place, Expr::Any(_)) if !places[place.0].is_field);
    if !list.iter().any(may_spread) {
        return list;
    }
    let effects = list.iter().map(Effects::of).list();
    let all = regions(places, &list, &effects);
    let mut settable = vec![false; places.len()];
    for place in effects.iter().flat_map(|effects| &*effects.writes) {
        settable[place.0] = true;
    }
    let is_free = |part: &Expr<'m>| {
        let mut free = true;
        each_read(part, &mut |read| free &= !settable[read.0] && region_of(places, read).is_none());
        free
    };
    let mut written: Set<PlaceId> = Set::new();
    let mut out = Vec::with_capacity(list.len());
    for (statement, regions) in list.into_iter().zip(all) {
        let is_new = |place: PlaceId| off(place) && !written.contains(&place);
        match statement {
            Statement::Set(place, Expr::Any(asked))
                if regions.len() > 1
                    && !places[place.0].is_field
                    && asked.iter().all(|part| is_pure(part) && !mentions(part, place)) =>
            {
                if !is_new(place) {
                    out.push(Statement::Set(place, no()));
                }
                for part in asked {
                    add(&mut out, Statement::Set(place, Expr::Any(vec![Expr::Place(place), part])), &is_free);
                }
                written.insert(place);
            }
            other => {
                each_written(std::slice::from_ref(&other), &mut |place| _ = written.insert(place));
                add(&mut out, other, &is_free);
            }
        }
    }
    out
}

/// One more statement. What adds to the same truth as the one in front of it is done there, if both ask for no region, and for nothing that the list sets.
fn add<'m>(out: &mut Vec<Statement<'m>>, one: Statement<'m>, is_free: &dyn Fn(&Expr<'m>) -> bool) {
    let adds = gathers(&one).is_some() && out.last().and_then(gathers) == gathers(&one);
    if let (true, Some(Statement::Set(_, Expr::Any(asked))), Statement::Set(_, Expr::Any(more))) =
        (adds, out.last_mut(), &one)
    {
        if asked[1..].iter().chain(&more[1..]).all(is_free) {
            asked.extend(more[1..].iter().cloned());
            return;
        }
    }
    out.push(one);
}

/// Statements, with what is asked of them again and again.
pub(super) struct Looked<'m> {
    pub(super) list: Vec<Statement<'m>>,
    pub(super) effects: Vec<Effects>,
    /// By statement, the regions on whose states it depends or which it writes, also by way of locals.
    pub(super) regions: Vec<Set<usize>>,
    /// Regions whose states depend on each other belong together.
    pub(super) dependent: Groups,
}

impl<'m> Looked<'m> {
    pub(super) fn at(places: &[PlaceInfo<'m>], list: Vec<Statement<'m>>) -> Self {
        let effects = list.iter().map(Effects::of).list();
        let regions = regions(places, &list, &effects);
        let dependent = dependent(places, &effects, &regions);
        let mut looked = Self { list, effects, regions, dependent };
        looked.follow_readers(places);
        looked
    }

    /// What is gathered without asking for a state, and decides about one, belongs to whoever asks for the truth, if that is one part alone.
    fn follow_readers(&mut self, places: &[PlaceInfo<'m>]) {
        let is_free = |at: &usize| self.regions[*at].is_empty() && gathers(&self.list[*at]).is_some();
        let free = (0..self.list.len()).filter(is_free).list();
        if free.is_empty() {
            return;
        }
        let states = (0..places.len()).map(PlaceId).filter(|place| region_of(places, *place).is_some()).list();
        let deciding = deciding(places, &self.list, &states);
        for at in free {
            let Some(truth) = gathers(&self.list[at]).filter(|truth| deciding[truth.0]) else { continue };
            let mut asking = Set::new();
            for (other, effects) in self.effects.iter().enumerate() {
                if effects.reads.contains(&truth) && gathers(&self.list[other]) != Some(truth) {
                    asking.extend(self.regions[other].iter().copied());
                }
            }
            if self.dependent.key(&asking).is_some_and(|key| key != usize::MAX) {
                self.regions[at] = asking;
            }
        }
    }

    /// Those of regions that depend on each other stand together.
    pub(super) fn parts(self, places: &[PlaceInfo<'m>], situations: &Situations<'_>) -> Vec<Part<'m>> {
        let keys = self.regions.iter().map(|regions| self.dependent.key(regions)).list();
        cut((places, situations), self.list, &self.effects, &self.regions, &keys)
    }
}

/// The regions whose states statements write.
pub(super) fn written(places: &[PlaceInfo<'_>], statements: &[Statement<'_>]) -> Set<usize> {
    let mut regions = Set::new();
    each_written(statements, &mut |place| regions.extend(region_of(places, place)));
    regions
}

pub(super) fn region_of(places: &[PlaceInfo<'_>], place: PlaceId) -> Option<usize> {
    match places[place.0].role {
        Role::State(region) => Some(region),
        _ => None,
    }
}

/// By the keys of statements: those of one key stand together as far as that is possible.
pub(super) fn cut<'m>(
    (places, situations): (&[PlaceInfo<'m>], &Situations<'_>),
    list: Vec<Statement<'m>>,
    effects: &[Effects],
    regions: &[Set<usize>],
    keys: &[Option<usize>],
) -> Vec<Part<'m>> {
    let order = Order::of(places, &list, effects, &Excluding::of(situations, &list)).scheduled(keys);
    let mut statements: Vec<Option<Statement<'m>>> = list.into_iter().map(Some).collect();
    let mut parts: Vec<(Option<usize>, Part<'m>)> = Vec::new();
    for at in order {
        let Some(statement) = statements[at].take() else { continue };
        match parts.last_mut() {
            Some((key, part)) if *key == keys[at] => {
                part.regions.extend(regions[at].iter().copied());
                part.statements.push(statement);
            }
            _ => parts.push((keys[at], Part { statements: vec![statement], regions: regions[at].clone() })),
        }
    }
    parts.into_iter().map(|(_, part)| part).collect()
}

/// By statement, the regions on whose states it depends or which it writes, also by way of locals.
pub(super) fn regions(places: &[PlaceInfo<'_>], list: &[Statement<'_>], effects: &[Effects]) -> Vec<Set<usize>> {
    let mut of: Vec<Set<usize>> = vec![Set::new(); places.len()];
    for (place, of) in places.iter().zip(&mut of) {
        if let Role::State(region) = place.role {
            of.insert(region);
        }
    }
    let mut all = Vec::with_capacity(list.len());
    for (statement, effects) in list.iter().zip(effects) {
        let gathered = gathers(statement);
        let mut regions = Set::new();
        for place in &*effects.reads {
            if Some(*place) != gathered {
                regions.extend(of[place.0].iter().copied());
            }
        }
        for place in &*effects.writes {
            if matches!(places[place.0].role, Role::State(_)) {
                regions.extend(of[place.0].iter().copied());
            } else if !places[place.0].is_field {
                of[place.0].extend(regions.iter().copied());
            }
        }
        all.push(regions);
    }
    all
}

/// A truth to which one more is added: `any = any || …`.
pub(super) fn gathers(statement: &Statement<'_>) -> Option<PlaceId> {
    let Statement::Set(place, Expr::Any(parts)) = statement else { return None };
    let others = |part: &Expr<'_>| {
        let mut free = true;
        each_read(part, &mut |read| free &= read != *place);
        free
    };
    let [Expr::Place(first), rest @ ..] = &parts[..] else { return None };
    (first == place && rest.iter().all(others)).then_some(*place)
}

/// Regions whose states depend on each other belong together.
fn dependent(places: &[PlaceInfo<'_>], effects: &[Effects], regions: &[Set<usize>]) -> Groups {
    let mut groups = Groups::new(places.len());
    for (effects, regions) in effects.iter().zip(regions) {
        let [first, rest @ ..] = &regions[..] else { continue };
        if effects.writes.iter().any(|place| region_of(places, *place).is_some()) {
            for other in rest {
                groups.join(*first, *other);
            }
        }
    }
    groups
}
