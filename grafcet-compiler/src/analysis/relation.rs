//! A symmetric relation between things counted from 0.

use crate::list::List;
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
    pub fn common_beyond(&self, items: &[usize], to: usize) -> Vec<usize> {
        let mut words = vec![u64::MAX; self.words];
        for item in items {
            for (word, other) in words.iter_mut().zip(self.row(*item)) {
                *word &= other;
            }
        }
        for (word, known) in words.iter_mut().zip(self.row(to)) {
            *word &= !known;
        }
        set(&words).into_iter().take_while(|item| *item < self.size).list()
    }

    /// What is related to all of `items` or one of them, not yet to `to`, but to that in `within`; without what is left out. Ascending.
    #[must_use]
    pub fn new_beside(&self, items: &[usize], to: usize, within: &Self, but: &Row) -> Vec<usize> {
        let mut words = vec![u64::MAX; self.words];
        for item in items {
            for (word, other) in words.iter_mut().zip(self.row(*item)) {
                *word &= other;
            }
        }
        for item in items {
            words[item / 64] |= 1 << (item % 64);
        }
        let (known, allowed) = (self.row(to), within.row(to));
        for (place, word) in words.iter_mut().enumerate() {
            *word &= !known[place] & allowed[place] & !but.0[place];
        }
        set(&words)
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
        let mut rest = *word;
        while rest != 0 {
            found.push(place * 64 + rest.trailing_zeros() as usize);
            rest &= rest - 1;
        }
    }
    found
}
