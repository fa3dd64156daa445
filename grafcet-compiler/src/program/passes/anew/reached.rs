//! What is known on the ways through a cycle, by the states on them.

use super::super::super::{PlaceId, Value};
use crate::sorted;

/// What is known somewhere in a cycle.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Reached {
    /// The state of the region, and copies of it.
    pub(super) states: Vec<(PlaceId, Value)>,
    /// By field, `None` where it may hold anything.
    pub(super) holds: Vec<Option<Value>>,
}

impl Reached {
    pub(super) fn state(&self, place: PlaceId) -> Option<Value> {
        self.states.iter().find(|(of, _)| *of == place).map(|(_, value)| *value)
    }

    pub(super) fn put(&mut self, place: PlaceId, value: Option<Value>) {
        self.states.retain(|(of, _)| *of != place);
        if let Some(value) = value {
            let at = self.states.partition_point(|(of, _)| *of < place);
            self.states.insert(at, (place, value));
        }
    }

    /// Holds as well where another one does. Whether it does so less than before.
    pub(super) fn join(&mut self, other: &Self) -> bool {
        let mut less = false;
        for (one, other) in self.holds.iter_mut().zip(&other.holds) {
            if one.is_some() && one != other {
                *one = None;
                less = true;
            }
        }
        less
    }
}

/// In the order of their states. Those with the same are one, of which is known what is known of both.
pub(super) fn merged(mut ways: Vec<Reached>) -> Vec<Reached> {
    sorted::sort(&mut ways);
    let mut all: Vec<Reached> = Vec::with_capacity(ways.len());
    for way in ways {
        match all.last_mut() {
            Some(last) if last.states == way.states => _ = last.join(&way),
            _ => all.push(way),
        }
    }
    all
}
