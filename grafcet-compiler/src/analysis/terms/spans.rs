//! From what is known of some terms to what follows for others: spans grow narrower, from operands to results and back.

use super::build::{limits, meet, usual};
use super::{Demands, Fit, Operation, Span, Terms, What};
use crate::analysis::differences::{Differences, FAR};
use crate::list::List;
use crate::model::Integer;

/// How often all terms are gone through before other means are tried.
const ROUNDS: usize = 6;

/// Terms and what is demanded of them.
pub(super) struct Question<'t> {
    pub(super) terms: &'t Terms,
    pub(super) demands: &'t Demands,
    /// The terms that the demands are about, and those that these are computed of.
    pub(super) used: Vec<bool>,
    /// Results fit into their types, and the types are as small as on any machine.
    pub(super) usual: bool,
    /// What it may still cost.
    pub(super) left: u64,
}

/// It costs too much.
pub(super) struct Spent;

impl<'t> Question<'t> {
    pub(super) fn new(terms: &'t Terms, demands: &'t Demands, usual: bool, left: u64) -> Self {
        let mut used = vec![false; terms.nodes.len()];
        for (term, _) in &demands.spans {
            used[*term] = true;
        }
        for (a, b, _) in &demands.differences {
            (used[*a], used[*b]) = (true, true);
        }
        for term in (0..used.len()).rev() {
            if used[term] {
                for operand in terms.operands(term) {
                    used[operand] = true;
                }
            }
        }
        Self { terms, demands, used, usual, left }
    }

    /// What is known before anything is tried; none where that is not possible.
    pub(super) fn first(&self) -> Option<Vec<Span>> {
        let range = |node: &super::Node| if self.usual { node.usual } else { node.range };
        let mut spans: Vec<Span> = self.terms.nodes.iter().map(range).list();
        for (term, span) in &self.demands.spans {
            spans[*term] = meet(spans[*term], *span);
        }
        spans.iter().zip(&self.used).all(|(span, used)| !used || span.0 <= span.1).then_some(spans)
    }

    pub(super) fn pay(&mut self, units: usize) -> Result<(), Spent> {
        self.left = self.left.checked_sub(units as u64).ok_or(Spent)?;
        Ok(())
    }

    /// Draws the conclusions; whether anything is left.
    pub(super) fn narrow(&mut self, spans: &mut [Span]) -> Result<bool, Spent> {
        for _ in 0..ROUNDS {
            let mut changed = false;
            for backwards in [false, true] {
                self.pay(spans.len())?;
                for at in 0..spans.len() {
                    let term = if backwards { spans.len() - 1 - at } else { at };
                    if self.used[term] {
                        changed |= self.follow(term, spans, backwards);
                    }
                }
                if spans.iter().zip(&self.used).any(|(span, used)| *used && span.0 > span.1) {
                    return Ok(false);
                }
            }
            if self.has_bits() {
                match self.mask(spans)? {
                    None => return Ok(false),
                    Some(more) => changed |= more,
                }
            }
            match self.compare(spans)? {
                None => return Ok(false),
                Some(more) if changed || more => {}
                Some(_) => break,
            }
        }
        Ok(true)
    }

    /// How far terms lie apart; none where that is not possible, else whether anything has become known.
    fn compare(&mut self, spans: &mut [Span]) -> Result<Option<bool>, Spent> {
        let mut differences = Differences::new(spans.len());
        for (a, b, span) in &self.demands.differences {
            differences.within(a + 1, b + 1, *span);
        }
        for (term, node) in self.terms.nodes.iter().enumerate().filter(|(term, _)| self.used[*term]) {
            match node.what {
                What::Exact(Operation::Add, a, b) => {
                    differences.within(term + 1, a + 1, spans[b]);
                    differences.within(term + 1, b + 1, spans[a]);
                }
                What::Exact(Operation::Sub, a, b) => {
                    differences.within(a + 1, term + 1, spans[b]);
                    differences.within(a + 1, b + 1, spans[term]);
                }
                What::Exact(Operation::Min, a, b) => {
                    differences.at_most(term + 1, a + 1, 0);
                    differences.at_most(term + 1, b + 1, 0);
                }
                What::Exact(Operation::Max, a, b) => {
                    differences.at_most(a + 1, term + 1, 0);
                    differences.at_most(b + 1, term + 1, 0);
                }
                What::Exact(..) | What::Constant | What::Leaf => {}
                What::Fit(of, fit) => {
                    if let Some(by) = self.offset(fit, spans[of]) {
                        differences.within(of + 1, term + 1, (by, by));
                    }
                }
            }
        }
        if differences.len() == 0 {
            return Ok(Some(false));
        }
        for (term, span) in spans.iter().enumerate().filter(|(term, _)| self.used[*term]) {
            differences.within(term + 1, 0, *span);
        }
        self.pay(differences.len() * 3)?;
        if !differences.is_possible() {
            return Ok(None);
        }
        let mut changed = false;
        for (term, (low, high)) in differences.ranges().into_iter().skip(1).enumerate() {
            let before = spans[term];
            spans[term] = meet(before, (low.unwrap_or(before.0), high.unwrap_or(before.1)));
            changed |= spans[term] != before;
        }
        Ok(Some(changed))
    }

    /// By how much a result lies above what its type makes of it, where that is known.
    pub(super) fn offset(&self, fit: Fit, exact: Span) -> Option<i128> {
        let (ty, wraps) = match fit {
            Fit::Checked(ty) if self.usual => (ty, false),
            Fit::Checked(ty) | Fit::Wrapping(ty) => (ty, !ty.is_size),
            Fit::Saturating(ty) => (ty, false),
        };
        let must = self.usual && (ty.is_size || matches!(fit, Fit::Checked(_)));
        let within = |(low, high): Span| low <= exact.0 && exact.1 <= high;
        if must || within(usual(ty)) {
            return Some(0);
        }
        let (first, last) = windows(ty, exact)?;
        (wraps && first == last).then_some(first << ty.bits)
    }

    /// What follows for a term from its operands, or for them from it; whether anything did.
    fn follow(&self, term: usize, spans: &mut [Span], backwards: bool) -> bool {
        let is_empty = |at: usize| spans[at].0 > spans[at].1;
        if is_empty(term) || self.terms.operands(term).into_iter().any(is_empty) {
            return false;
        }
        match self.terms.nodes[term].what {
            What::Constant | What::Leaf => false,
            What::Exact(operation, a, b) => {
                let [result, first, second] = [term, a, b].map(|at| spans[at]);
                if !backwards {
                    return keep(spans, term, forwards(operation, first, second));
                }
                let (left, right) = back(operation, result, first, second);
                keep(spans, a, left) | keep(spans, b, right)
            }
            What::Fit(of, fit) => {
                let [result, exact] = [term, of].map(|at| spans[at]);
                match (self.offset(fit, exact), fit) {
                    (Some(by), _) if backwards => keep(spans, of, Some((result.0 + by, result.1 + by))),
                    (Some(by), _) => keep(spans, term, Some((exact.0 - by, exact.1 - by))),
                    (None, Fit::Saturating(ty)) if backwards => keep(spans, of, Some(before_the_end(ty, result))),
                    (None, Fit::Saturating(ty)) => keep(spans, term, Some(at_the_end(ty, exact))),
                    _ => false,
                }
            }
        }
    }
}

/// Draws a span together; whether it becomes narrower.
fn keep(spans: &mut [Span], at: usize, span: Option<Span>) -> bool {
    let Some(span) = span else { return false };
    let known = spans[at];
    spans[at] = meet(known, span);
    spans[at] != known
}

/// What becomes of a result that stays at the ends of its type, which are others on a small machine.
fn at_the_end(ty: Integer, (low, high): Span) -> Span {
    let (small, large) = (usual(ty), limits(ty));
    let to = |number: i128| (number.clamp(small.0, small.1), number.clamp(large.0, large.1));
    let (first, last) = (to(low), to(high));
    (first.0.min(first.1), last.0.max(last.1))
}

/// Of what.
fn before_the_end(ty: Integer, (low, high): Span) -> Span {
    let (least, most) = usual(ty);
    (if low <= least { -FAR } else { low }, if high >= most { FAR } else { high })
}

/// In which of the ranges of a type that lie side by side the ends of a span are; the one around zero has the number zero.
pub(super) fn windows(ty: Integer, (low, high): Span) -> Option<(i128, i128)> {
    let least = limits(ty).0;
    let bounded = low > -FAR && high < FAR;
    bounded.then(|| ((low - least) >> ty.bits, (high - least) >> ty.bits))
}

/// The least and the greatest of some numbers.
fn hull(numbers: [i128; 4]) -> Span {
    let (mut low, mut high) = (numbers[0], numbers[0]);
    for number in numbers {
        (low, high) = (low.min(number), high.max(number));
    }
    (low.max(-FAR), high.min(FAR))
}

/// All corners of what two spans give.
fn corners((a, b): Span, (c, d): Span, of: impl Fn(i128, i128) -> i128) -> Span {
    hull([of(a, c), of(a, d), of(b, c), of(b, d)])
}

/// What a result can be.
fn forwards(operation: Operation, a: Span, b: Span) -> Option<Span> {
    match operation {
        Operation::Add => Some(hull([a.0 + b.0, a.1 + b.1, a.0 + b.0, a.1 + b.1])),
        Operation::Sub => Some(hull([a.0 - b.1, a.1 - b.0, a.0 - b.1, a.1 - b.0])),
        Operation::Mul => Some(corners(a, b, i128::saturating_mul)),
        Operation::Div if b.0 > 0 || b.1 < 0 => Some(corners(a, b, |a, b| a / b)),
        Operation::DivEuclid if b.0 > 0 => Some(corners(a, b, i128::div_euclid)),
        Operation::Rem if b.0 > 0 => {
            if let Some(by) = turns(a, b, false) {
                return Some((a.0 - by, a.1 - by));
            }
            let most = b.1 - 1;
            Some(((-most).max(a.0).min(0), most.min(a.1).max(0)))
        }
        Operation::RemEuclid if b.0 > 0 => {
            let by = turns(a, b, true);
            Some(by.map_or((0, b.1 - 1), |by| (a.0 - by, a.1 - by)))
        }
        Operation::And if a.0 == a.1 && b.0 == b.1 => Some((a.0 & b.0, a.0 & b.0)),
        Operation::Or if a.0 == a.1 && b.0 == b.1 => Some((a.0 | b.0, a.0 | b.0)),
        Operation::Xor if a.0 == a.1 && b.0 == b.1 => Some((a.0 ^ b.0, a.0 ^ b.0)),
        Operation::And if a.0 >= 0 && b.0 >= 0 => Some((0, a.1.min(b.1))),
        Operation::And if a.0 >= 0 => Some((0, a.1)),
        Operation::And if b.0 >= 0 => Some((0, b.1)),
        Operation::Or if a.0 >= 0 && b.0 >= 0 => Some((a.0.max(b.0), filled(a.1 | b.1))),
        Operation::Xor if a.0 >= 0 && b.0 >= 0 => Some((0, filled(a.1 | b.1))),
        Operation::Min => Some((a.0.min(b.0), a.1.min(b.1))),
        Operation::Max => Some((a.0.max(b.0), a.1.max(b.1))),
        _ => None,
    }
}

/// With all bits below its highest one.
pub(super) fn filled(number: i128) -> i128 {
    if number <= 0 { 0 } else { i128::MAX >> (number.leading_zeros() - 1) }
}

/// How much a rest lies below what is divided, where all of it has the same quotient by one divisor.
fn turns(a: Span, b: Span, down: bool) -> Option<i128> {
    let single = b.0 == b.1 && (down || a.0 >= 0);
    let (first, last) = (a.0.div_euclid(b.0), a.1.div_euclid(b.0));
    (single && first == last && a.0 > -FAR && a.1 < FAR).then(|| first.saturating_mul(b.0))
}

/// Both ends are known.
fn is_bounded((low, high): Span) -> bool {
    low > -FAR && high < FAR
}

/// What the operands can be.
fn back(operation: Operation, result: Span, a: Span, b: Span) -> (Option<Span>, Option<Span>) {
    if !is_bounded(result) && !matches!(operation, Operation::Min | Operation::Max) {
        return (None, None);
    }
    let (low, high) = result;
    match operation {
        Operation::Add => (Some((low - b.1, high - b.0)), Some((low - a.1, high - a.0))),
        Operation::Sub => (Some((low + b.0, high + b.1)), Some((a.0 - high, a.1 - low))),
        Operation::Mul => (factor(result, b), factor(result, a)),
        Operation::Div if b.0 == b.1 && b.0 > 0 => {
            let by = b.0;
            let first = if low > 0 { low.saturating_mul(by) } else { (low - 1).saturating_mul(by) + 1 };
            let last = if high >= 0 { high.saturating_mul(by).saturating_add(by - 1) } else { high.saturating_mul(by) };
            (Some((first, last)), None)
        }
        Operation::DivEuclid if b.0 == b.1 && b.0 > 0 => {
            (Some((low.saturating_mul(b.0), high.saturating_mul(b.0).saturating_add(b.0 - 1))), None)
        }
        Operation::Rem | Operation::RemEuclid if b.0 > 0 => {
            let by = turns(a, b, operation == Operation::RemEuclid);
            (by.map(|by| (low + by, high + by)), None)
        }
        Operation::Min => {
            let other = |one: Span| (low, if one.0 > high { high } else { FAR });
            (Some(other(b)), Some(other(a)))
        }
        Operation::Max => {
            let other = |one: Span| (if one.1 < low { low } else { -FAR }, high);
            (Some(other(b)), Some(other(a)))
        }
        _ => (None, None),
    }
}

/// What one factor can be, where the other one lies above or below zero.
fn factor((low, high): Span, other: Span) -> Option<Span> {
    if other.1 < 0 {
        let (first, last) = factor((-high, -low), (-other.1, -other.0))?;
        return Some((first, last));
    }
    if other.0 <= 0 {
        return None;
    }
    // As little as the product allows, and as much.
    let by = |end: i128, up: bool| if (end > 0) == up { other.0 } else { other.1 };
    let up = |a: i128, b: i128| -(-a).div_euclid(b);
    Some((up(low, if low > 0 { other.1 } else { other.0 }), high.div_euclid(by(high, true))))
}
