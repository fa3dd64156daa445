//! Finds a state among those that are known. A search asks some ten times for each state that there is.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::analysis::explore::net::formula::AtomId;
use crate::analysis::explore::valuation::State;
use crate::analysis::explore::valuation::knowledge::Known;
use crate::model::Id;

/// The numbers of states, by what stands in their situations and values: to compare states with each other takes longer than to
/// compare two numbers.
#[derive(Default)]
pub(crate) struct Index(BTreeMap<u64, Vec<usize>>);

impl Index {
    pub(crate) fn insert(&mut self, state: &State, number: usize) {
        self.0.entry(hash(state, &state.before)).or_default().push(number);
    }

    /// The number of this state, if it remembers `past` of the cycle before.
    pub(crate) fn find(&self, states: &[Rc<State>], state: &State, past: &[(AtomId, Known)]) -> Option<usize> {
        let alike = self.0.get(&hash(state, past))?;
        let is_it = |number: &&usize| {
            let State { first, active, slots, before, ages } = &*states[**number];
            (*first, active, slots, ages) == (state.first, &state.active, &state.slots, &state.ages)
                && **before == *past
        };
        alike.iter().find(is_it).copied()
    }
}

/// FNV-1a, a number at a time.
fn hash(state: &State, past: &[(AtomId, Known)]) -> u64 {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    let mut add = |number: u64| hash = (hash ^ number).wrapping_mul(0x0100_0000_01b3);
    for step in &state.active {
        add(step.index() as u64);
    }
    for bit in &state.slots {
        add(*bit as u64);
    }
    for known in [past, &state.ages] {
        for (atom, known) in known {
            add(atom.index() as u64);
            match known {
                Known::Unknown => add(0),
                Known::Bool(value) => add(1 + u64::from(*value)),
                Known::Range(low, high) => {
                    for end in [low, high] {
                        add(u64::try_from(*end).unwrap_or(u64::MAX));
                    }
                }
            }
        }
    }
    hash
}
