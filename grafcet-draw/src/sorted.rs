//! Sorting, maps and `collect` with little code for each type.
//!
//! Whoever uses the macro builds this crate without optimisation, and there each sort and each B-tree of the standard library is dozens
//! of functions for every type: they were a third of it.

use std::cmp::Ordering;

/// What comes one by one, put together.
pub(crate) trait List: Iterator + Sized {
    /// All of it, as a vector.
    fn list(self) -> Vec<Self::Item> {
        let mut all = Vec::new();
        for item in self {
            all.push(item);
        }
        all
    }
}

impl<I: Iterator> List for I {}

/// Sorts by a key; what has the same key stays in its order.
pub(crate) fn sort_by_key<T: Clone, K: Ord>(items: &mut Vec<T>, key: impl Fn(&T) -> K) {
    let order = order(items.len(), &|a, b| key(&items[a]).cmp(&key(&items[b])));
    let mut sorted = Vec::with_capacity(order.len());
    for number in order {
        sorted.push(items[number].clone());
    }
    *items = sorted;
}

/// Sorts what is its own key.
pub(crate) fn sort<T: Copy + Ord>(items: &mut Vec<T>) {
    sort_by_key(items, |item| *item);
}

/// The numbers of so many items in their order.
fn order(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order = (0..count).list();
    order.sort_by(|a, b| compare(*a, *b));
    order
}

/// A map: entries in the order of their keys.
pub(crate) struct Map<K, V>(Vec<(K, V)>);

impl<K: Ord + Copy, V> Map<K, V> {
    pub(crate) const fn new() -> Self {
        Self(Vec::new())
    }

    /// Where the entry of a key is, or where it would be.
    fn place(&self, key: K) -> Result<usize, usize> {
        let (mut from, mut to) = (0, self.0.len());
        while from < to {
            let middle = usize::midpoint(from, to);
            match self.0[middle].0.cmp(&key) {
                Ordering::Less => from = middle + 1,
                Ordering::Greater => to = middle,
                Ordering::Equal => return Ok(middle),
            }
        }
        Err(from)
    }

    pub(crate) fn get(&self, key: K) -> Option<&V> {
        match self.place(key) {
            Ok(place) => Some(&self.0[place].1),
            Err(_) => None,
        }
    }

    pub(crate) fn insert(&mut self, key: K, value: V) {
        match self.place(key) {
            Ok(place) => self.0[place].1 = value,
            Err(place) => self.0.insert(place, (key, value)),
        }
    }

    /// The value of a key, an empty one where it has none yet.
    pub(crate) fn entry(&mut self, key: K) -> &mut V
    where
        V: Default,
    {
        let place = match self.place(key) {
            Ok(place) => place,
            Err(place) => {
                self.0.insert(place, (key, V::default()));
                place
            }
        };
        &mut self.0[place].1
    }

    /// The first key.
    pub(crate) fn first(&self) -> Option<K> {
        self.0.first().map(|(key, _)| *key)
    }

    /// All entries in order.
    pub(crate) fn entries(self) -> Vec<(K, V)> {
        self.0
    }

    /// The values of all keys that are known, in the order in which these are asked for.
    pub(crate) fn of<'k>(&self, keys: impl IntoIterator<Item = &'k K>) -> Vec<V>
    where
        K: 'k,
        V: Copy,
    {
        let mut values = Vec::new();
        for key in keys {
            if let Some(value) = self.get(*key) {
                values.push(*value);
            }
        }
        values
    }
}

impl<K: Ord + Copy, V> Default for Map<K, V> {
    fn default() -> Self {
        Self::new()
    }
}
