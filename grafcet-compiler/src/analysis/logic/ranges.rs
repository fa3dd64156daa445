//! Sets of whole numbers.
use crate::list::List;

/// The values that something can still have: disjoint intervals, ascending, both ends included.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Ranges(Vec<(i128, i128)>);

impl Ranges {
    /// From `low` to `high`.
    pub(super) fn from_to(low: i128, high: i128) -> Self {
        Self(if low <= high { vec![(low, high)] } else { Vec::new() })
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many intervals there are: what it costs to look at them.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// The least and the greatest value.
    pub(super) fn hull(&self) -> Option<(i128, i128)> {
        Some((self.0.first()?.0, self.0.last()?.1))
    }

    /// Each interval by itself.
    pub(super) fn parts(&self) -> Vec<Self> {
        self.0.iter().map(|part| Self(vec![*part])).list()
    }

    /// Whether all values (true) or none of them (false) lie between `low` and `high`.
    pub(super) fn within(&self, low: i128, high: i128) -> Option<bool> {
        let (first, last) = (self.0.first()?.0, self.0.last()?.1);
        if low <= first && last <= high {
            return Some(true);
        }
        let none = self.0.iter().all(|(from, to)| *to < low || high < *from);
        none.then_some(false)
    }

    /// Keeps the values between `low` and `high`, or those that are not; tells whether any is gone.
    pub(super) fn keep(&mut self, low: i128, high: i128, inside: bool) -> bool {
        let mut kept = Vec::with_capacity(self.0.len() + 1);
        for (from, to) in &self.0 {
            let mut add = |from: i128, to: i128| {
                if from <= to {
                    kept.push((from, to));
                }
            };
            if inside {
                add(low.max(*from), high.min(*to));
            } else if *to < low || high < *from {
                add(*from, *to);
            } else {
                add(*from, low.saturating_sub(1));
                add(high.saturating_add(1), *to);
            }
        }
        let changed = kept != self.0;
        self.0 = kept;
        changed
    }

    /// The value nearest to zero.
    pub(super) fn example(&self) -> Option<i128> {
        self.0.iter().map(|(from, to)| 0.clamp(*from, *to)).min_by_key(|value| value.unsigned_abs())
    }
}
