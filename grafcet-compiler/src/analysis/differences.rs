//! Whole numbers whose differences have bounds.

use crate::list::List;

/// Beyond this, numbers of 128 bits leave no room to calculate: such a bound is none.
pub(super) const FAR: i128 = i128::MAX / 4;

/// Some numbers, the first of which is zero, and how far they lie apart.
#[derive(Debug)]
pub(super) struct Differences {
    count: usize,
    /// The first is at most so much greater than the second.
    bounds: Vec<(usize, usize, i128)>,
}

impl Differences {
    /// Zero, and `others` numbers after it.
    pub(super) fn new(others: usize) -> Self {
        Self { count: others + 1, bounds: Vec::new() }
    }

    /// How many bounds there are: what it costs to look at them once.
    pub(super) fn len(&self) -> usize {
        self.bounds.len()
    }

    /// `a - b <= most`
    pub(super) fn at_most(&mut self, a: usize, b: usize, most: i128) {
        if most < FAR {
            self.bounds.push((a, b, most.max(-FAR)));
        }
    }

    /// `low <= a - b <= high`
    pub(super) fn within(&mut self, a: usize, b: usize, (low, high): (i128, i128)) {
        self.at_most(a, b, high);
        self.at_most(b, a, low.checked_neg().unwrap_or(FAR));
    }

    /// Whether there are such numbers: no circle of bounds goes below zero.
    pub(super) fn is_possible(&self) -> bool {
        let mut least = vec![0; self.count];
        (0..self.count).any(|_| !self.lower(&mut least))
    }

    /// From where to where a number can lie, as far as it is bounded; where there are such numbers.
    pub(super) fn range(&self, of: usize) -> (Option<i128>, Option<i128>) {
        let high = self.distances(false)[of];
        let low = self.distances(true)[of];
        (low.map(|low| -low), high)
    }

    /// The same of all numbers, zero first.
    pub(super) fn ranges(&self) -> Vec<(Option<i128>, Option<i128>)> {
        let (highs, lows) = (self.distances(false), self.distances(true));
        lows.into_iter().map(|low| low.map(|low| -low)).zip(highs).list()
    }

    /// The greatest value that each number can have; `mirrored`, of its opposite.
    fn distances(&self, mirrored: bool) -> Vec<Option<i128>> {
        let mut far = vec![None; self.count];
        if let Some(zero) = far.first_mut() {
            *zero = Some(0);
        }
        for _ in 0..self.count {
            let mut changed = false;
            for (a, b, most) in &self.bounds {
                let (a, b) = if mirrored { (*b, *a) } else { (*a, *b) };
                let Some(by) = far[b].map(|from: i128| from.saturating_add(*most)) else { continue };
                if far[a].is_none_or(|known| by < known) {
                    far[a] = Some(by);
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
        far
    }

    /// Follows all bounds once; whether anything became less.
    fn lower(&self, least: &mut [i128]) -> bool {
        let mut changed = false;
        for (a, b, most) in &self.bounds {
            let by = least[*b].saturating_add(*most);
            if by < least[*a] {
                least[*a] = by;
                changed = true;
            }
        }
        changed
    }
}
