//! Single bits of terms: what masks, shifts and the ends of types leave of them.

use super::spans::{Question, Spent, filled};
use super::{Fit, Operation, Span, What};

/// The bits that are known of a number, as many as there are.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Bits {
    ones: i128,
    zeros: i128,
}

impl Bits {
    /// Those that all numbers of a span have in common.
    fn of((low, high): Span) -> Self {
        let same = if (low ^ high) < 0 { 0 } else { !filled(low ^ high) };
        Self { ones: low & same, zeros: !low & same }
    }

    fn and(self, other: Self) -> Self {
        Self { ones: self.ones & other.ones, zeros: self.zeros | other.zeros }
    }

    fn or(self, other: Self) -> Self {
        Self { ones: self.ones | other.ones, zeros: self.zeros & other.zeros }
    }

    fn xor(self, other: Self) -> Self {
        let ones = self.ones & other.zeros | self.zeros & other.ones;
        Self { ones, zeros: self.ones & other.ones | self.zeros & other.zeros }
    }

    /// Only these.
    fn within(self, mask: i128) -> Self {
        Self { ones: self.ones & mask, zeros: self.zeros & mask }
    }

    fn learn(&mut self, other: Self) {
        self.ones |= other.ones;
        self.zeros |= other.zeros;
    }

    fn allow(self, number: i128) -> bool {
        number & self.zeros == 0 && !number & self.ones == 0
    }

    /// The least number from `low` on, which is not below zero, that has these bits.
    fn from(self, low: i128) -> Option<i128> {
        if self.allow(low) {
            return Some(low);
        }
        (0..MOST).find_map(|at| {
            let (bit, lower) = (1 << at, (1 << at) - 1);
            let above = low & !(lower | bit);
            let number = above | bit | self.ones & lower;
            (low & bit == 0 && self.allow(number)).then_some(number)
        })
    }

    /// The greatest one up to `high`.
    fn up_to(self, high: i128) -> Option<i128> {
        if self.allow(high) {
            return Some(high);
        }
        (0..MOST).find_map(|at| {
            let (bit, lower) = (1 << at, (1 << at) - 1);
            let above = high & !(lower | bit);
            let number = above | !self.zeros & lower;
            (high & bit != 0 && self.allow(number)).then_some(number)
        })
    }
}

/// No type has more bits.
const MOST: u32 = 65;

impl Question<'_> {
    /// Whether any bits are looked at.
    pub(super) fn has_bits(&self) -> bool {
        let looks = |term: usize| {
            let what = &self.terms.nodes[term].what;
            self.used[term] && matches!(what, What::Exact(Operation::And | Operation::Or | Operation::Xor, ..))
        };
        (0..self.used.len()).any(looks)
    }

    /// What follows for spans from single bits; none where that is not possible, else whether anything has become known.
    pub(super) fn mask(&mut self, spans: &mut [Span]) -> Result<Option<bool>, Spent> {
        self.pay(4 * spans.len())?;
        let mut bits: Vec<Bits> = Vec::with_capacity(spans.len());
        for span in spans.iter() {
            bits.push(Bits::of(*span));
        }
        for backwards in [false, true, false] {
            for at in 0..spans.len() {
                let term = if backwards { spans.len() - 1 - at } else { at };
                if self.used[term] {
                    self.pass(term, spans, &mut bits);
                }
            }
        }
        let mut changed = false;
        for (term, bits) in bits.iter().enumerate().filter(|(term, _)| self.used[*term]) {
            if bits.ones & bits.zeros != 0 {
                return Ok(None);
            }
            let (low, high) = spans[term];
            if low < 0 || high >> (MOST - 1) != 0 {
                continue;
            }
            let (Some(first), Some(last)) = (bits.from(low), bits.up_to(high)) else { return Ok(None) };
            if first > high || last < low {
                return Ok(None);
            }
            changed |= (first, last) != (low, high);
            spans[term] = (first, last);
        }
        Ok(Some(changed))
    }

    /// From the operands to the result, and back.
    fn pass(&self, term: usize, spans: &[Span], bits: &mut [Bits]) {
        match self.terms.nodes[term].what {
            What::Constant | What::Leaf => {}
            What::Exact(operation, a, b) => {
                let (first, second) = (bits[a], bits[b]);
                let forwards = match operation {
                    Operation::And => first.and(second),
                    Operation::Or => first.or(second),
                    Operation::Xor => first.xor(second),
                    _ => return shift(operation, (term, a), spans[b], bits),
                };
                bits[term].learn(forwards);
                let result = bits[term];
                let back = |other: Bits| match operation {
                    // Where the other one is true it decides, and it has all that the result has.
                    Operation::And => Bits { ones: result.ones, zeros: result.zeros & other.ones },
                    Operation::Or => Bits { ones: result.ones & other.zeros, zeros: result.zeros },
                    _ => result.xor(other),
                };
                bits[a].learn(back(second));
                bits[b].learn(back(first));
            }
            What::Fit(of, fit) => {
                let low = match (self.offset(fit, spans[of]), fit) {
                    (Some(0), _) => -1,
                    // The lower bits stay.
                    (_, Fit::Checked(ty) | Fit::Wrapping(ty)) if !ty.is_size => (1 << ty.bits) - 1,
                    _ => return,
                };
                let (exact, result) = (bits[of].within(low), bits[term].within(low));
                bits[term].learn(exact);
                bits[of].learn(result);
            }
        }
    }
}

/// Multiplied or divided by a power of two.
fn shift(operation: Operation, (term, a): (usize, usize), by: Span, bits: &mut [Bits]) {
    if by.0 != by.1 || by.0 <= 0 || by.0 & (by.0 - 1) != 0 {
        return;
    }
    let (count, result, operand) = (by.0.trailing_zeros(), bits[term], bits[a]);
    match operation {
        Operation::Mul => {
            // What comes in from the right is zero.
            bits[term].learn(Bits { ones: operand.ones << count, zeros: !(!operand.zeros << count) });
            let back = Bits { ones: result.ones >> count, zeros: result.zeros >> count };
            bits[a].learn(back.within(i128::MAX >> MOST));
        }
        Operation::DivEuclid => {
            bits[term].learn(Bits { ones: operand.ones >> count, zeros: operand.zeros >> count });
            let back = Bits { ones: result.ones << count, zeros: result.zeros << count };
            bits[a].learn(back.within(i128::MAX >> count));
        }
        _ => {}
    }
}
