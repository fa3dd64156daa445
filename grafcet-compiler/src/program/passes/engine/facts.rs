//! What is known on a way: of each place, of copies, and of truths that exclude each other.

use super::super::super::{PlaceId, PlaceInfo, Type, Value};
use super::super::fold::initial;
use crate::model::StepId;

/// What is known of a place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in super::super) enum Fact {
    Nothing,
    /// What it began with.
    Initial,
    Is(Value),
    /// Each round writes it before it is read, so it may be taken for what it is declared with. What it holds is not known.
    Assumed(Value),
    /// The same as another place, which has not been written since.
    Copy(PlaceId),
    /// The state of a region: one of the list with this number.
    Among(usize),
    /// The reading of the clock in this cycle.
    Now,
}

/// States of which a region has one.
pub(in super::super) type Among = Vec<Option<StepId>>;

/// What is known where a cycle or a round begins: some places begin as they are declared, or in a loop may be taken for it, as nothing has
/// written them.
pub(in super::super) fn beginning(places: &[PlaceInfo<'_>], assumed: &[bool], in_loop: bool) -> Vec<Fact> {
    let mut env = vec![Fact::Nothing; places.len()];
    for ((place, assumed), fact) in places.iter().zip(assumed).zip(&mut env) {
        if !assumed {
            continue;
        }
        *fact = match initial(place).filter(|_| !matches!(place.ty, Type::User(_))) {
            Some(value) if in_loop => Fact::Assumed(value),
            Some(value) => Fact::Is(value),
            None if in_loop => Fact::Nothing,
            None => Fact::Initial,
        };
    }
    env
}

/// What has been a copy of what so far, also if it is none any more.
#[derive(Default)]
pub(in super::super) struct Copies {
    /// The copy, and of what it is one, in the order in which they were made.
    pub(super) all: Vec<(PlaceId, PlaceId)>,
    /// The copies of each place, as far as there are any.
    pub(super) of: Vec<Vec<PlaceId>>,
}

impl Copies {
    pub(in super::super) fn add(&mut self, copy: PlaceId, of: PlaceId) {
        if self.of.len() <= of.0 {
            self.of.resize_with(of.0 + 1, Vec::new);
        }
        let known = &mut self.of[of.0];
        if !known.contains(&copy) {
            known.push(copy);
            self.all.push((copy, of));
        }
    }

    /// Only the first so many are left.
    pub(super) fn back(&mut self, to: usize) {
        while self.all.len() > to {
            if let Some((_, of)) = self.all.pop() {
                self.of[of.0].pop();
            }
        }
    }
}

/// Groups of truths of which one at most becomes true.
#[derive(Default)]
pub(in super::super) struct Excluding<'e> {
    groups: &'e [Vec<PlaceId>],
    /// By place.
    group_of: Vec<Option<usize>>,
    /// By group: which of them was true when somebody asked last. It still is, as a rule.
    last: Vec<PlaceId>,
}

impl<'e> Excluding<'e> {
    pub(in super::super) fn of(groups: &'e [Vec<PlaceId>], places: usize) -> Self {
        let (mut group_of, mut last) = (vec![None; places], Vec::with_capacity(groups.len()));
        for (number, group) in groups.iter().enumerate() {
            last.extend(group.first());
            for truth in group {
                group_of[truth.0] = Some(number);
            }
        }
        Self { groups, group_of, last }
    }

    /// Whether another one of its group is true.
    pub(super) fn excludes(&mut self, place: PlaceId, env: &[Fact]) -> bool {
        let Some(number) = self.group_of.get(place.0).copied().flatten() else { return false };
        let is_true = |other: PlaceId| other != place && env[other.0] == Fact::Is(Value::Bool(true));
        if is_true(self.last[number]) {
            return true;
        }
        let found = self.groups[number].iter().copied().find(|other| is_true(*other));
        if let Some(found) = found {
            self.last[number] = found;
        }
        found.is_some()
    }
}

/// What is known on both of two ways. Whether that is less than before.
pub(in super::super) fn meet(known: &mut Option<Vec<Fact>>, facts: Vec<Fact>) -> bool {
    let Some(known) = known else {
        *known = Some(facts);
        return true;
    };
    let mut less = false;
    for (one, other) in known.iter_mut().zip(facts) {
        if *one != other && *one != Fact::Nothing {
            *one = Fact::Nothing;
            less = true;
        }
    }
    less
}
