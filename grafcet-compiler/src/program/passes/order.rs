//! In which order the statements of a list may stand.
//!
//! What reads stays after what it reads, what writes after what reads or writes the same, what somebody outside sees in its order. Truths that are gathered
//! (`any = any || …`) may be gathered in any order, and so may what changes a place in states that exclude each other (`excluding`).

use super::super::{PlaceInfo, Statement};
use super::excluding::Excluding;
use super::parts::gathers;
use super::uses::Effects;
use crate::sorted::{Map, Set};

/// What has to stand before what.
pub(super) struct Order {
    /// By statement: those that come after it, and how many come before it.
    next: Vec<Vec<usize>>,
    open: Vec<usize>,
}

impl Order {
    pub(super) fn of(
        places: &[PlaceInfo<'_>],
        list: &[Statement<'_>],
        effects: &[Effects],
        excluding: &Excluding<'_>,
    ) -> Self {
        let count = list.len();
        let mut order = Self { next: vec![Vec::new(); count], open: vec![0; count] };
        let mut all = vec![Accesses::default(); places.len()];
        // Who tells somebody outside something, and who leaves the list.
        let (mut outside, mut left) = (Accesses::default(), None);
        for (at, (statement, effects)) in list.iter().zip(effects).enumerate() {
            let adds = gathers(statement);
            let mut before = Set::new();
            before.extend(left);
            for place in effects.reads.iter().filter(|place| Some(**place) != adds) {
                // Who changes what it reads in some states alone is one of those that change it.
                if !(excluding.is_bound(at) && effects.writes.contains(place)) {
                    all[place.0].read(at, &mut before);
                }
            }
            for place in &*effects.writes {
                if Some(*place) == adds {
                    all[place.0].add(at, &mut before);
                } else {
                    all[place.0].write(at, excluding, &mut before);
                }
            }
            if effects.outside {
                outside.write(at, excluding, &mut before);
            }
            if effects.leaves {
                before.extend(0..at);
                left = Some(at);
            }
            before.remove(&at);
            for earlier in &*before {
                order.next[*earlier].push(at);
                order.open[at] += 1;
            }
        }
        order
    }

    /// In an order in which those of one key stand together as far as that is possible.
    pub(super) fn scheduled(mut self, keys: &[Option<usize>]) -> Vec<usize> {
        let mut order = Vec::with_capacity(keys.len());
        let (mut ready, mut left): (Ready, Map<Option<usize>, usize>) = (Ready::default(), Map::new());
        for (at, key) in keys.iter().enumerate() {
            *left.or_default(*key) += 1;
            if self.open[at] == 0 {
                ready.insert(at, *key);
            }
        }
        let mut current = None;
        while let Some(first) = ready.all.first().copied() {
            let at = match ready.first_of(current) {
                Some(at) => at,
                None => ready.first_of(None).or_else(|| self.whole(&ready, keys, &left)).unwrap_or(first),
            };
            current = keys[at];
            ready.remove(at, current);
            *left.or_default(current) -= 1;
            order.push(at);
            for next in std::mem::take(&mut self.next[at]) {
                self.open[next] -= 1;
                if self.open[next] == 0 {
                    ready.insert(next, keys[next]);
                }
            }
        }
        order
    }

    /// The first statement of a key of which nothing waits for another key. `left` tells how many statements of a key are left.
    fn whole(&mut self, ready: &Ready, keys: &[Option<usize>], left: &Map<Option<usize>, usize>) -> Option<usize> {
        let mut tried: Set<Option<usize>> = Set::new();
        for at in &*ready.all {
            let key = keys[*at];
            if !tried.insert(key) {
                continue;
            }
            let mut stack = ready.by_key.get(&key).map(|all| all.to_vec()).unwrap_or_default();
            // What does not wait any more, to be taken back.
            let (mut reached, mut passed) = (0, Vec::new());
            while let Some(one) = stack.pop() {
                reached += 1;
                for next in &self.next[one] {
                    self.open[*next] -= 1;
                    passed.push(*next);
                    if self.open[*next] == 0 && keys[*next] == key {
                        stack.push(*next);
                    }
                }
            }
            for next in passed {
                self.open[next] += 1;
            }
            if left.get(&key) == Some(&reached) {
                return Some(*at);
            }
        }
        None
    }
}

/// Which statements have had to do with a place since one has written it in any case.
#[derive(Clone, Default)]
struct Accesses {
    written: Option<usize>,
    /// They have added to it.
    added: Vec<usize>,
    /// They change it in some states alone.
    changed: Vec<usize>,
    read: Vec<usize>,
}

impl Accesses {
    fn read(&mut self, at: usize, before: &mut Set<usize>) {
        before.extend(self.written);
        before.extend(self.added.iter().copied());
        before.extend(self.changed.iter().copied());
        self.read.push(at);
    }

    fn add(&mut self, at: usize, before: &mut Set<usize>) {
        before.extend(self.written);
        before.extend(self.read.iter().copied());
        before.extend(self.changed.iter().copied());
        self.added.push(at);
    }

    fn write(&mut self, at: usize, excluding: &Excluding<'_>, before: &mut Set<usize>) {
        before.extend(self.written);
        before.extend(self.read.iter().copied());
        before.extend(self.added.iter().copied());
        if excluding.is_bound(at) {
            before.extend(self.changed.iter().copied().filter(|other| !excluding.excludes(*other, at)));
            self.changed.push(at);
        } else {
            before.extend(self.changed.iter().copied());
            *self = Self { written: Some(at), ..Self::default() };
        }
    }
}

/// The statements that wait for none, all of them and by key.
#[derive(Default)]
struct Ready {
    all: Set<usize>,
    by_key: Map<Option<usize>, Set<usize>>,
}

impl Ready {
    fn insert(&mut self, at: usize, key: Option<usize>) {
        self.all.insert(at);
        self.by_key.or_default(key).insert(at);
    }

    fn remove(&mut self, at: usize, key: Option<usize>) {
        self.all.remove(&at);
        self.by_key.or_default(key).remove(&at);
    }

    fn first_of(&self, key: Option<usize>) -> Option<usize> {
        self.by_key.get(&key)?.first().copied()
    }
}
