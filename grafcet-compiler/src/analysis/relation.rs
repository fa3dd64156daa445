//! A symmetric relation between things counted from 0.

use std::vec;

/// Pairs of indices, one bit each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Relation {
    size: usize,
    words: usize,
    rows: Vec<u64>,
}

impl Relation {
    /// The empty relation on `size` things.
    #[must_use]
    pub fn new(size: usize) -> Self {
        let words = size.div_ceil(64);
        Self { size, words, rows: vec![0; size * words] }
    }

    /// Whether there is nothing that could be related.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.size == 0
    }

    /// Relates `a` and `b`; tells whether that is new.
    pub fn insert(&mut self, a: usize, b: usize) -> bool {
        if self.contains(a, b) {
            return false;
        }
        self.rows[a * self.words + b / 64] |= 1 << (b % 64);
        self.rows[b * self.words + a / 64] |= 1 << (a % 64);
        true
    }

    /// Whether `a` and `b` are related.
    #[must_use]
    pub fn contains(&self, a: usize, b: usize) -> bool {
        self.rows[a * self.words + b / 64] & (1 << (b % 64)) != 0
    }

    /// Everything related to `a`, ascending.
    #[must_use]
    pub fn of(&self, a: usize) -> vec::IntoIter<usize> {
        set(self.row(a)).into_iter()
    }

    /// Everything related to all of `items` (everything there is, if there are none) and not yet to `to`, ascending.
    #[must_use]
    pub(crate) fn common_beyond(&self, items: &[usize], to: usize) -> Vec<usize> {
        let mut found = Vec::new();
        for place in 0..self.words {
            each_bit(place, self.common(items, place) & !self.rows[to * self.words + place], &mut found);
        }
        found.truncate(found.partition_point(|item| *item < self.size));
        found
    }

    /// What is related to all of `items` or one of them, not yet to `to`, but to that in `within`; without what is left out. Ascending.
    #[must_use]
    pub(crate) fn new_beside(&self, items: &[usize], to: usize, within: &Self, but: &Row) -> Vec<usize> {
        let mut found = Vec::new();
        for place in 0..self.words {
            let mut word = self.common(items, place);
            for item in items.iter().filter(|item| **item / 64 == place) {
                word |= 1 << (item % 64);
            }
            let at = to * self.words + place;
            each_bit(place, word & within.rows[at] & !(self.rows[at] | but.0[place]), &mut found);
        }
        found
    }

    /// A word of what all of `items` are related to.
    fn common(&self, items: &[usize], place: usize) -> u64 {
        let mut word = u64::MAX;
        for item in items {
            word &= self.rows[item * self.words + place];
        }
        word
    }

    /// Whether `a` is related to one of these.
    #[must_use]
    pub fn meets(&self, a: usize, these: &Row) -> bool {
        self.row(a).iter().zip(&these.0).any(|(related, one)| related & one != 0)
    }

    /// Relates two things no more.
    pub fn remove(&mut self, a: usize, b: usize) {
        self.rows[a * self.words + b / 64] &= !(1 << (b % 64));
        self.rows[b * self.words + a / 64] &= !(1 << (a % 64));
    }

    fn row(&self, a: usize) -> &[u64] {
        &self.rows[a * self.words..(a + 1) * self.words]
    }
}

/// Some of the things of a relation.
pub struct Row(Vec<u64>);

impl Row {
    /// None of `size` things.
    #[must_use]
    pub fn new(size: usize) -> Self {
        Self(vec![0; size.div_ceil(64)])
    }

    /// Takes these in, too.
    pub fn add(&mut self, items: &[usize]) {
        for item in items {
            self.0[item / 64] |= 1 << (item % 64);
        }
    }
}

/// The positions of the set bits of a row, ascending.
fn set(row: &[u64]) -> Vec<usize> {
    let mut found = Vec::new();
    for (place, word) in row.iter().enumerate() {
        each_bit(place, *word, &mut found);
    }
    found
}

/// Adds the positions of the bits of one word of a row.
fn each_bit(place: usize, mut word: u64, found: &mut Vec<usize>) {
    while word != 0 {
        found.push(place * 64 + word.trailing_zeros() as usize);
        word &= word - 1;
    }
}

#[cfg(test)]
mod tests {
    use super::{Relation, Row};

    /// More than two words, and no whole number of them.
    const SIZE: usize = 131;

    /// A relation in which about one pair in `one_in` is.
    fn mixed(one_in: usize) -> Relation {
        let mut relation = Relation::new(SIZE);
        for a in 0..SIZE {
            for b in (0..a).filter(|b| (a * 7919 + b * 104_729) / 3 % one_in == 0) {
                relation.insert(a, b);
            }
        }
        relation
    }

    #[test]
    fn what_is_new_beside_some_is_what_pair_by_pair_says() {
        let (known, allowed) = (mixed(2), mixed(3));
        let left_out = [3, 64, 130];
        let mut but = Row::new(SIZE);
        but.add(&left_out);
        for items in [&[][..], &[5], &[70, 129], &[1, 2, 3]] {
            for to in 0..SIZE {
                let is_new = |one: &usize| {
                    (items.contains(one) || items.iter().all(|item| known.contains(*item, *one)))
                        && !known.contains(to, *one)
                        && allowed.contains(to, *one)
                        && !left_out.contains(one)
                };
                let expected: Vec<usize> = (0..SIZE).filter(is_new).collect();
                assert_eq!(known.new_beside(items, to, &allowed, &but), expected, "{items:?} {to}");
                let is_common =
                    |one: &usize| items.iter().all(|item| known.contains(*item, *one)) && !known.contains(to, *one);
                let common: Vec<usize> = (0..SIZE).filter(is_common).collect();
                assert_eq!(known.common_beyond(items, to), common, "{items:?} {to}");
            }
        }
    }

    #[test]
    fn what_is_removed_is_related_from_neither_side() {
        let mut relation = mixed(2);
        let (a, b) = (0..SIZE).find_map(|a| relation.of(a).next().map(|b| (a, b))).expect("a pair");
        let mut these = Row::new(SIZE);
        these.add(&[b]);
        assert!(relation.meets(a, &these));
        relation.remove(a, b);
        assert!(!relation.contains(a, b) && !relation.contains(b, a) && !relation.meets(a, &these));
    }
}
