//! The connected pieces of partial grafcets: what evolves by itself.

use crate::model::{Id, Model};

/// The number of each step's piece, and how many there are.
pub(super) fn of(model: &Model) -> (Vec<usize>, usize) {
    let mut union = Union::new(model.steps.len());
    for transition in model.transitions.values() {
        let mut steps = transition.sources.iter().chain(&transition.targets).map(|step| step.index());
        let Some(first) = steps.next() else { continue };
        for other in steps {
            union.join(first, other);
        }
    }
    let mut numbers = vec![usize::MAX; model.steps.len()];
    let mut count = 0;
    let units = (0..model.steps.len())
        .map(|step| {
            let root = union.root(step);
            if numbers[root] == usize::MAX {
                numbers[root] = count;
                count += 1;
            }
            numbers[root]
        })
        .collect();
    (units, count)
}

/// Disjoint sets of numbers.
pub(super) struct Union {
    parents: Vec<usize>,
}

impl Union {
    pub(super) fn new(size: usize) -> Self {
        Self { parents: (0..size).collect() }
    }

    pub(super) fn root(&mut self, mut item: usize) -> usize {
        while self.parents[item] != item {
            self.parents[item] = self.parents[self.parents[item]];
            item = self.parents[item];
        }
        item
    }

    pub(super) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b)] = a.min(b);
    }
}
