//! Which parts of a round may change places.

use super::super::parts::gathers;
use super::super::uses::Effects;
use crate::program::{PlaceId, Statement};
use crate::sorted::Set;

/// What a part does to the others: what several only gather they may gather in any order.
pub(super) struct Touched {
    /// All the rest.
    effects: Effects,
    gathered: Set<PlaceId>,
}

impl Touched {
    pub(super) fn by(statements: &[Statement<'_>]) -> Self {
        let (mut effects, mut gathered) = (Effects::default(), Set::new());
        for statement in statements {
            let mut one = Effects::of(statement);
            if let Some(place) = gathers(statement) {
                one.reads.remove(&place);
                one.writes.remove(&place);
                gathered.insert(place);
            }
            effects.reads.extend(one.reads.iter().copied());
            effects.writes.extend(one.writes.iter().copied());
            effects.outside |= one.outside;
            effects.leaves |= one.leaves;
        }
        Self { effects, gathered }
    }

    pub(super) fn may_swap(&self, other: &Self) -> bool {
        let is_free = |gathered: &Set<PlaceId>, effects: &Effects| {
            gathered.is_disjoint(&effects.reads) && gathered.is_disjoint(&effects.writes)
        };
        self.effects.may_swap(&other.effects)
            && is_free(&self.gathered, &other.effects)
            && is_free(&other.gathered, &self.effects)
    }
}
