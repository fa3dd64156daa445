//! What is known where some statements begin.

use super::super::engine::{Among, Fact};
use super::super::fold::initial;
use crate::program::{PlaceId, PlaceInfo, Type, Value};
use crate::sorted::Set;

/// The facts of all places, what of the states stands for several, and what is read later.
#[derive(Clone)]
pub(in super::super) struct Env {
    pub(in super::super) facts: Vec<Fact>,
    pub(in super::super) lists: Vec<Among>,
    /// What is read after them.
    pub(in super::super) later: Set<PlaceId>,
}

impl Env {
    /// Locals hold what they begin with.
    pub(in super::super) fn of(places: &[PlaceInfo<'_>]) -> Self {
        let mut facts = Vec::with_capacity(places.len());
        for place in places {
            facts.push(match initial(place) {
                _ if place.is_field => Fact::Nothing,
                Some(value) if !matches!(place.ty, Type::User(_)) => Fact::Is(value),
                _ => Fact::Initial,
            });
        }
        Self { facts, lists: Vec::new(), later: Set::new() }
    }

    pub(super) fn among(&mut self, states: Among) -> Fact {
        if let [state] = states[..] {
            return Fact::Is(Value::Step(state));
        }
        self.lists.push(states);
        Fact::Among(self.lists.len() - 1)
    }
}
