//! What is known where some statements begin.

use super::super::engine::{Among, Fact};
use super::super::fold::initial;
use crate::list::List;
use crate::model::StepId;
use crate::program::{PlaceId, PlaceInfo, Type, Value};
use crate::sorted::Set;

/// The facts of all places, what of the states stands for several, and what is read later.
#[derive(Clone)]
pub(in super::super) struct Env {
    pub(in super::super) facts: Vec<Fact>,
    pub(in super::super) lists: Vec<Among>,
    /// What is read after them.
    pub(in super::super) later: Set<PlaceId>,
    /// Truths that hold in some states of a region alone: the truth, the place of the state, the steps.
    pub(in super::super) only: Vec<(PlaceId, PlaceId, Vec<StepId>)>,
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
        Self { facts, lists: Vec::new(), later: Set::new(), only: Vec::new() }
    }

    pub(super) fn among(&mut self, states: Among) -> Fact {
        if let [state] = states[..] {
            return Fact::Is(Value::Step(state));
        }
        self.lists.push(states);
        Fact::Among(self.lists.len() - 1)
    }

    /// Knows no more than another one does, too. Of which places that is less than before.
    pub(in super::super) fn join(&mut self, other: &Self) -> Vec<PlaceId> {
        let mut less = Vec::new();
        for place in 0..self.facts.len() {
            let (own, others) = (self.facts[place], other.facts[place]);
            if own == others && !matches!(own, Fact::Among(_)) {
                continue;
            }
            self.facts[place] = match (self.states(own), other.states(others)) {
                (Some(own), Some(others)) if own == others => continue,
                (Some(mut own), Some(others)) => {
                    own.extend(others.iter().filter(|state| !own.contains(state)).copied().list());
                    self.among(own)
                }
                _ => Fact::Nothing,
            };
            less.push(PlaceId(place));
        }
        less
    }

    /// The states that a place has one of, as far as a fact tells.
    fn states(&self, fact: Fact) -> Option<Among> {
        match fact {
            Fact::Is(Value::Step(state)) => Some(vec![state]),
            Fact::Among(list) => self.lists.get(list).cloned(),
            Fact::Copy(of) => self.states(self.facts[of.0]),
            _ => None,
        }
    }
}
