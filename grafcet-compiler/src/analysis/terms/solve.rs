//! Looking for values: what follows is drawn, some values are tried, and the spans of what is open are halved.

use super::build::{limits, usual};
use super::spans::{Question, Spent, windows};
use super::{Demands, Fit, Node, Operation, Span, Terms, Told, What};
use crate::analysis::differences::FAR;
use crate::list::{List, PushAll};

/// So many values are tried one by one.
const FEW: u128 = 1024;

/// What a search has led to.
enum Found {
    Nothing,
    Values(Vec<i128>),
    /// There may be some, only not without something out of the common.
    Odd,
}

impl Terms {
    /// Whether there are values of which all this is true; `left` is what it may cost.
    pub(in crate::analysis) fn told(&self, demands: &Demands, left: &mut u64) -> Told {
        let (part, at) = self.part(demands);
        let demands = Demands {
            spans: demands.spans.iter().map(|(term, span)| (at[*term], *span)).list(),
            differences: demands.differences.iter().map(|(a, b, span)| (at[*a], at[*b], *span)).list(),
        };
        match part.told_of_all(&demands, left) {
            // What nothing is demanded of has any value.
            Told::Possible(found) => {
                let any = |term: usize| 0.clamp(self.nodes[term].usual.0, self.nodes[term].usual.1);
                let value = |term: usize| found.get(at[term]).copied().unwrap_or_else(|| any(term));
                Told::Possible((0..self.nodes.len()).map(value).list())
            }
            told => told,
        }
    }

    /// The terms that demands are about with those that these are computed of; and by term its number among them.
    fn part(&self, demands: &Demands) -> (Self, Vec<usize>) {
        let mut used = vec![false; self.nodes.len()];
        for (term, _) in &demands.spans {
            used[*term] = true;
        }
        for (a, b, _) in &demands.differences {
            (used[*a], used[*b]) = (true, true);
        }
        for term in (0..used.len()).rev() {
            if used[term] {
                for operand in self.operands(term) {
                    used[operand] = true;
                }
            }
        }
        let (mut part, mut at) = (Self::default(), vec![usize::MAX; used.len()]);
        for term in (0..used.len()).filter(|term| used[*term]) {
            at[term] = part.nodes.len();
            let what = match self.nodes[term].what {
                What::Exact(operation, a, b) => What::Exact(operation, at[a], at[b]),
                What::Fit(of, fit) => What::Fit(at[of], fit),
                other => other,
            };
            part.nodes.push(Node { what, ..self.nodes[term] });
        }
        (part, at)
    }

    fn told_of_all(&self, demands: &Demands, left: &mut u64) -> Told {
        let mut question = Question::new(self, demands, true, *left);
        let found = question.search();
        *left = question.left;
        let is_unusual = |term: usize| question.used[term] && self.is_unusual(term);
        match found {
            Ok(Found::Values(values)) => return Told::Possible(values),
            Ok(Found::Odd) | Err(Spent) => return Told::Unclear,
            Ok(Found::Nothing) if !(0..self.nodes.len()).any(is_unusual) => return Told::Impossible,
            Ok(Found::Nothing) => {}
        }
        let mut question = Question::new(self, demands, false, *left);
        let found = question.search();
        *left = question.left;
        if matches!(found, Ok(Found::Nothing)) { Told::Impossible } else { Told::Unclear }
    }

    /// Whether a term may have values that it should not have.
    fn is_unusual(&self, term: usize) -> bool {
        let node = &self.nodes[term];
        match node.what {
            What::Constant => false,
            What::Leaf => node.usual != node.range,
            What::Exact(operation, ..) => matches!(
                operation,
                Operation::Div | Operation::Rem | Operation::DivEuclid | Operation::RemEuclid | Operation::Mul
            ),
            What::Fit(_, fit) => match fit {
                Fit::Checked(_) => true,
                Fit::Wrapping(ty) | Fit::Saturating(ty) => ty.is_size,
            },
        }
    }
}

impl Question<'_> {
    fn search(&mut self) -> Result<Found, Spent> {
        let Some(first) = self.first() else { return Ok(Found::Nothing) };
        let mut open = vec![first];
        let mut odd = false;
        let mut count = 0_u32;
        while let Some(mut spans) = open.pop() {
            if !self.narrow(&mut spans)? {
                continue;
            }
            if self.choices(&spans) <= FEW {
                match self.try_all(&spans)? {
                    Found::Nothing => {}
                    Found::Odd => odd = true,
                    found @ Found::Values(_) => return Ok(found),
                }
                continue;
            }
            if count < 4 || count % 8 == 0 {
                for high in [false, true] {
                    if let Some(found) = self.dive(&spans, high)? {
                        return Ok(found);
                    }
                }
            }
            count += 1;
            let Some((at, cut)) = self.cut(&spans) else { return Err(Spent) };
            let mut parts = [spans.clone(), spans];
            parts[0][at].1 = cut;
            parts[1][at].0 = cut + 1;
            // What is nearer to zero comes first.
            if cut >= 0 {
                parts.reverse();
            }
            open.push_all(parts);
        }
        Ok(if odd { Found::Odd } else { Found::Nothing })
    }

    fn leaves(&self) -> Vec<usize> {
        let is_leaf = |term: &usize| self.used[*term] && matches!(self.terms.nodes[*term].what, What::Leaf);
        (0..self.used.len()).filter(is_leaf).list()
    }

    /// How many combinations of values are left.
    fn choices(&self, spans: &[Span]) -> u128 {
        let width = |term: usize| (spans[term].1 - spans[term].0).unsigned_abs().saturating_add(1);
        self.leaves().into_iter().map(width).fold(1, u128::saturating_mul)
    }

    /// Tries all values that are left.
    fn try_all(&mut self, spans: &[Span]) -> Result<Found, Spent> {
        let leaves = self.leaves();
        let mut values: Vec<i128> = spans.iter().map(|span| span.0).list();
        let mut odd = false;
        loop {
            match self.at(&values)? {
                Found::Nothing => {}
                Found::Odd => odd = true,
                found @ Found::Values(_) => return Ok(found),
            }
            let next = leaves.iter().find(|leaf| {
                let more = values[**leaf] < spans[**leaf].1;
                values[**leaf] = if more { values[**leaf] + 1 } else { spans[**leaf].0 };
                more
            });
            if next.is_none() {
                return Ok(if odd { Found::Odd } else { Found::Nothing });
            }
        }
    }

    /// Gives the leaves values one after the other, at one end of what is left for them.
    fn dive(&mut self, spans: &[Span], high: bool) -> Result<Option<Found>, Spent> {
        let mut spans = spans.to_vec();
        for leaf in self.leaves() {
            let (low, end) = spans[leaf];
            let value = if high { end } else { 0.clamp(low, end) };
            spans[leaf] = (value, value);
            if low != end && !self.narrow(&mut spans)? {
                return Ok(None);
            }
        }
        let values: Vec<i128> = spans.iter().map(|span| span.0).list();
        let found = self.at(&values)?;
        Ok(matches!(found, Found::Values(_)).then_some(found))
    }

    /// Where to part what is left: at the end of a type, or in the middle of a leaf.
    fn cut(&self, spans: &[Span]) -> Option<(usize, i128)> {
        for (_, node) in self.terms.nodes.iter().enumerate().filter(|(term, _)| self.used[*term]) {
            let What::Fit(of, fit) = node.what else { continue };
            let exact = spans[of];
            if self.offset(fit, exact).is_some() {
                continue;
            }
            let (Fit::Checked(ty) | Fit::Wrapping(ty) | Fit::Saturating(ty)) = fit;
            // What stays at an end does so however far it is beyond.
            let near = |window: i128| if let Fit::Saturating(_) = fit { window.clamp(-1, 1) } else { window };
            let windows = windows(ty, exact).map(|(first, last)| (near(first), near(last)));
            let Some((first, last)) = windows.filter(|(first, last)| first < last) else { continue };
            // After the one that comes first, the one around zero if that is among them.
            let number = if first < 0 && last >= 0 { -1 } else { (first + last).div_euclid(2) };
            return Some((of, limits(ty).0 + ((number + 1) << ty.bits) - 1));
        }
        let width = |leaf: &usize| spans[*leaf].1 - spans[*leaf].0;
        let widest = self.leaves().into_iter().max_by_key(width).filter(|leaf| width(leaf) > 0)?;
        let (low, high) = spans[widest];
        // Zero belongs to what is not below it.
        let middle = if low < 0 && high >= 0 { -1 } else { low + (high - low) / 2 };
        Some((widest, middle))
    }

    /// Whether all demands are met where the leaves have these values; the other terms are computed.
    fn at(&mut self, leaves: &[i128]) -> Result<Found, Spent> {
        self.pay(leaves.len())?;
        let mut values: Vec<Option<i128>> = Vec::with_capacity(leaves.len());
        for (term, node) in self.terms.nodes.iter().enumerate() {
            let value = match node.what {
                _ if !self.used[term] => None,
                What::Constant => Some(node.range.0),
                What::Leaf => Some(leaves[term]),
                What::Exact(operation, a, b) => {
                    values[a].zip(values[b]).and_then(|(a, b)| result(operation, a, b, self.usual))
                }
                What::Fit(of, fit) => values[of].and_then(|exact| self.fitted(fit, exact)),
            };
            if value.is_none() && self.used[term] && self.usual {
                return Ok(Found::Nothing);
            }
            values.push(value);
        }
        let lies = |term: usize, (low, high): Span| values[term].is_none_or(|value| low <= value && value <= high);
        let differ_so = |(a, b, (low, high)): &(usize, usize, Span)| match (values[*a], values[*b]) {
            (Some(a), Some(b)) => *low <= a - b && a - b <= *high,
            _ => true,
        };
        let demands = self.demands;
        if !demands.spans.iter().all(|(term, span)| lies(*term, *span)) || !demands.differences.iter().all(differ_so) {
            return Ok(Found::Nothing);
        }
        if !self.usual {
            return Ok(Found::Odd);
        }
        Ok(Found::Values(values.into_iter().map(Option::unwrap_or_default).list()))
    }

    /// What a type makes of a result; none where that is not said.
    fn fitted(&self, fit: Fit, exact: i128) -> Option<i128> {
        let (Fit::Checked(ty) | Fit::Wrapping(ty) | Fit::Saturating(ty)) = fit;
        let (low, high) = usual(ty);
        if low <= exact && exact <= high {
            return Some(exact);
        }
        if ty.is_size || self.usual && matches!(fit, Fit::Checked(_)) {
            return None;
        }
        match fit {
            Fit::Saturating(_) => Some(exact.clamp(low, high)),
            _ => Some((exact - low).rem_euclid(1 << ty.bits) + low),
        }
    }
}

/// An exact result; none where there is none, or it is `usual` and Rust panics.
fn result(operation: Operation, a: i128, b: i128, usual: bool) -> Option<i128> {
    let of = match operation {
        Operation::Add => a.checked_add(b),
        Operation::Sub => a.checked_sub(b),
        Operation::Mul => a.checked_mul(b),
        // The least number of a type divided by -1 is none of its type.
        Operation::Rem | Operation::RemEuclid if usual && b == -1 => None,
        Operation::Div => a.checked_div(b),
        Operation::Rem => a.checked_rem(b),
        Operation::DivEuclid => a.checked_div_euclid(b),
        Operation::RemEuclid => a.checked_rem_euclid(b),
        Operation::And => Some(a & b),
        Operation::Or => Some(a | b),
        Operation::Xor => Some(a ^ b),
        Operation::Min => Some(a.min(b)),
        Operation::Max => Some(a.max(b)),
    };
    of.filter(|value| value.unsigned_abs() < FAR.unsigned_abs())
}
