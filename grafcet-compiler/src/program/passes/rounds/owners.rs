//! Whose a statement is: of the regions whose states it writes, or for whose sake something is computed.

use super::super::belonging::Groups;
use super::super::live::Places;
use super::super::parts::{gathers, regions};
use super::super::uses::{Effects, each_read, each_written, reads_from};
use crate::list::List;
use crate::program::{Expr, PlaceId, PlaceInfo, Role, Statement};
use crate::sorted::Set;

/// By statement: the regions on which it depends, and the key of those it belongs to; none where it belongs to all of them.
#[allow(clippy::type_complexity, reason = "both by statement")]
pub(super) fn owners(
    places: &[PlaceInfo<'_>],
    list: &[Statement<'_>],
    states: &[PlaceId],
    later: &Places,
) -> (Vec<Set<usize>>, Vec<Option<usize>>) {
    let mut owning = Owning { groups: Groups::new(states.len()), of: vec![None; places.len()], states, later };
    owning.unite(places, list);
    let regions = regions(places, list, &list.iter().map(Effects::of).list());
    let mut keys = vec![None; list.len()];
    for (at, statement) in list.iter().enumerate().rev() {
        keys[at] = owning.owner(places, (list, &keys), at, statement, &regions[at]);
    }
    (regions, keys)
}

struct Owning<'s> {
    groups: Groups,
    /// By place: a region that depends on this truth at once.
    of: Vec<Option<usize>>,
    states: &'s [PlaceId],
    /// What is read after the round.
    later: &'s Places,
}

impl Owning<'_> {
    fn written(&self, statement: &Statement<'_>) -> Set<usize> {
        let mut written = Set::new();
        each_written(std::slice::from_ref(statement), &mut |place| {
            written.extend(self.states.iter().position(|state| *state == place));
        });
        written
    }

    /// Regions that one statement writes, or that one truth decides, belong together.
    fn unite(&mut self, places: &[PlaceInfo<'_>], list: &[Statement<'_>]) {
        for statement in list {
            let written = self.written(statement);
            let [first, rest @ ..] = &written[..] else { continue };
            for other in rest {
                self.groups.join(*first, *other);
            }
            for truth in &*asked(statement) {
                let is_step = matches!(places[truth.0].role, Role::State(_)) || places[truth.0].is_field;
                if is_step || matches!(places[truth.0].ty, crate::program::Type::State(_)) {
                    continue;
                }
                match self.of[truth.0] {
                    Some(other) => self.groups.join(*first, other),
                    None => self.of[truth.0] = Some(*first),
                }
            }
        }
    }

    fn owner(
        &self,
        places: &[PlaceInfo<'_>],
        (list, keys): (&[Statement<'_>], &[Option<usize>]),
        at: usize,
        statement: &Statement<'_>,
        regions: &Set<usize>,
    ) -> Option<usize> {
        if let Some(region) = self.written(statement).first() {
            return Some(self.groups.find(*region));
        }
        // A copy is everybody's.
        if matches!(statement, Statement::Set(_, Expr::Place(place)) if self.states.contains(place)) {
            return None;
        }
        if let Statement::Set(place, _) = statement {
            if let Some(region) = self.of[place.0] {
                return Some(self.groups.find(region));
            }
            if !places[place.0].is_field && gathers(statement).is_none() {
                let mut readers = Set::new();
                for (other, key) in list.iter().zip(keys).skip(at + 1) {
                    if reads_from(other, *place) {
                        readers.insert(*key);
                    }
                }
                if let ([Some(one)], false) = (&readers[..], regions.is_empty()) {
                    // Whether another region's step rises is found in each round, whatever the reader's own state.
                    let is_own = regions.iter().any(|region| self.groups.find(*region) == *one);
                    if is_own || !self.later.contains(*place) {
                        return Some(*one);
                    }
                }
            }
        }
        self.groups.key(regions)
    }
}

/// What a statement asks before it writes.
fn asked(statement: &Statement<'_>) -> Set<PlaceId> {
    let mut found = Set::new();
    if let Statement::If(condition, then, otherwise) = statement {
        each_read(condition, &mut |place| _ = found.insert(place));
        for inner in then.iter().chain(otherwise) {
            found.extend(asked(inner).iter().copied());
        }
    }
    found
}
