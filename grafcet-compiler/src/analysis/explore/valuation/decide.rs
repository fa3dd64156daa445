//! Asking for values: a formula is decided atom by atom, and what was decided stays so in the cycle.

use super::knowledge::Known;
use super::{Valuation, When};
use crate::analysis::explore::net::formula::{AtomId, Formula, Kind};
use crate::analysis::explore::net::slots::Bit;
use crate::model::{EdgeId, Id};

impl Valuation<'_> {
    /// Whether the formula holds; what is not decided yet is decided now.
    pub(crate) fn decide(&mut self, formula: &Formula, when: When) -> bool {
        if let Some(value) = self.known(formula, when) {
            return value;
        }
        match formula {
            Formula::Const(value) => *value,
            Formula::Is(atom) => self.ask(*atom, when),
            Formula::Below(atom, bound) => self.ask_below(*atom, *bound, when),
            Formula::Equals(atom, bound) => self.ask_equal(*atom, *bound, when),
            Formula::Not(inner) => !self.decide(inner, when),
            Formula::And(a, b) => self.decide(a, when) && self.decide(b, when),
            Formula::Or(a, b) => self.decide(a, when) || self.decide(b, when),
            Formula::Same(a, b) => self.decide(a, when) == self.decide(b, when),
            Formula::Rising(edge) => match &self.net.edges[*edge] {
                Some(of) => self.decide(of, When::Sample) && !self.decide(of, When::Before),
                None => false,
            },
            Formula::Falling(edge) => match &self.net.edges[*edge] {
                Some(of) => !self.decide(of, When::Sample) && self.decide(of, When::Before),
                None => false,
            },
            Formula::Shared(index) => self.decide(&self.net.shared[*index], when),
        }
    }

    /// Whether the formula holds, as far as that follows from what has been decided.
    fn known(&mut self, formula: &Formula, when: When) -> Option<bool> {
        self.work += 1;
        match formula {
            Formula::Const(value) => Some(*value),
            Formula::Is(atom) => match self.value(*atom, when) {
                Known::Bool(value) => Some(value),
                _ => None,
            },
            Formula::Below(atom, bound) => match self.value(*atom, when) {
                Known::Range(_, high) if high < *bound => Some(true),
                Known::Range(low, _) if low >= *bound => Some(false),
                _ => None,
            },
            Formula::Equals(atom, bound) => match self.value(*atom, when) {
                Known::Range(low, high) if low == *bound && high == *bound => Some(true),
                Known::Range(low, high) if *bound < low || *bound > high => Some(false),
                _ => None,
            },
            Formula::Not(inner) => self.known(inner, when).map(|value| !value),
            Formula::And(a, b) => match self.known(a, when) {
                Some(false) => Some(false),
                Some(true) => self.known(b, when),
                None => self.known(b, when).filter(|b| !b),
            },
            Formula::Or(a, b) => match self.known(a, when) {
                Some(true) => Some(true),
                Some(false) => self.known(b, when),
                None => self.known(b, when).filter(|b| *b),
            },
            Formula::Same(a, b) => Some(self.known(a, when)? == self.known(b, when)?),
            Formula::Rising(edge) => self.known_edge(*edge, true),
            Formula::Falling(edge) => self.known_edge(*edge, false),
            Formula::Shared(index) => self.known(&self.net.shared[*index], when),
        }
    }

    fn known_edge(&mut self, edge: EdgeId, to: bool) -> Option<bool> {
        if self.edgeless {
            return Some(false);
        }
        let net = self.net;
        let Some(of) = &net.edges[edge] else { return Some(false) };
        let now = self.known(of, When::Sample);
        if now == Some(!to) {
            return Some(false);
        }
        match self.known(of, When::Before) {
            Some(before) if before == to => Some(false),
            Some(_) => now.map(|now| now == to),
            None => None,
        }
    }

    fn ask(&mut self, atom: AtomId, when: When) -> bool {
        let value = self.can_hold(atom, when) && self.tape.choose(2) == 1;
        self.learn(atom, when, Known::Bool(value));
        value
    }

    /// Whether a boolean atom can be true: a step of another piece only beside the steps that are known to be active.
    fn can_hold(&self, atom: AtomId, when: When) -> bool {
        let net = self.net;
        let Kind::Step(step) = net.atoms[atom].kind else { return true };
        let is_excluded = |other: &AtomId| match net.atoms[*other].kind {
            Kind::Step(of) => of != step && self.given.get(*other) == Known::Bool(true) && !net.may_meet(step, of),
            _ => false,
        };
        when == When::Before
            || self.now.active.iter().all(|own| net.may_meet(step, *own))
                && !self.given.learnt().iter().any(is_excluded)
    }

    fn ask_below(&mut self, atom: AtomId, bound: i128, when: When) -> bool {
        let Known::Range(low, high) = self.value(atom, when) else { return false };
        match self.beside_zero(atom, when) {
            // `0 - b < bound` is `b > -bound`.
            Some((other, true)) => return !self.decide(&Formula::Below(other, bound.saturating_neg() + 1), when),
            Some((other, false)) => return self.decide(&Formula::Below(other, bound), when),
            None => {}
        }
        let below = self.tape.choose(2) == 1;
        let known = if below { Known::Range(low, bound - 1) } else { Known::Range(bound, high) };
        self.learn(atom, when, known);
        below
    }

    fn ask_equal(&mut self, atom: AtomId, bound: i128, when: When) -> bool {
        let Known::Range(low, high) = self.value(atom, when) else { return false };
        if let Some((other, is_less)) = self.beside_zero(atom, when) {
            let bound = if is_less { bound.saturating_neg() } else { bound };
            return self.decide(&Formula::Equals(other, bound), when);
        }
        let mut parts = vec![(bound, bound)];
        if low < bound {
            parts.push((low, bound - 1));
        }
        if high > bound {
            parts.push((bound + 1, high));
        }
        let part = self.tape.choose(parts.len());
        self.learn(atom, when, Known::Range(parts[part].0, parts[part].1));
        part == 0
    }

    /// Where an atom is the difference of a time that is zero at this moment and another number: that one, and whether the
    /// time stands first.
    fn beside_zero(&self, atom: AtomId, when: When) -> Option<(AtomId, bool)> {
        let (a, b) = self.net.links.times(atom)?;
        if self.is_zero(a, when) {
            return Some((b, true));
        }
        self.is_zero(b, when).then_some((a, false))
    }

    fn learn(&mut self, atom: AtomId, when: When, known: Known) {
        if self.net.unfollowed[atom] || matches!(self.net.atoms[atom].kind, Kind::Slot(_)) {
            self.late |= self.acted;
            self.granted.retain(|(other, _)| *other != atom);
            self.granted.push((atom, known));
        }
        if when == When::Before && self.previous.is_none() {
            self.recorded.learn(atom, known);
            return;
        }
        if let (Kind::Slot(slot), Known::Bool(value)) = (self.net.atoms[atom].kind, known) {
            // A value that could be either is one of the two from now on.
            let snapshot = match when {
                When::Now => &mut self.now,
                When::Sample => self.start.as_mut().unwrap_or(&mut self.now),
                When::Before => self.previous.as_mut().unwrap_or(&mut self.now),
            };
            snapshot.slots[slot.index()] = Bit::from(value);
            return;
        }
        self.given.learn(atom, known);
    }
}
