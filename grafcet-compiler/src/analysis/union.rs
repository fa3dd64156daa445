//! Disjoint sets of numbers.
use crate::list::List;

/// Numbers, of which some belong together.
pub struct Union {
    parents: Vec<usize>,
}

impl Union {
    /// The numbers below `size`, each by itself.
    #[must_use]
    pub fn new(size: usize) -> Self {
        Self { parents: (0..size).list() }
    }

    /// The least number of those that an item belongs to.
    pub fn root(&mut self, mut item: usize) -> usize {
        while self.parents[item] != item {
            self.parents[item] = self.parents[self.parents[item]];
            item = self.parents[item];
        }
        item
    }

    /// From now on the two belong together.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b)] = a.min(b);
    }
}
