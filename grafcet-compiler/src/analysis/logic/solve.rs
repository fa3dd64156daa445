//! Looks for values of the atoms that make functions true or false.
//!
//! What a function demands is taken apart as long as only one thing can follow; where several can, they are tried one
//! after the other. The cost is that of the functions asked about and does not grow with the number of constants.

use super::formula::{AtomId, Formula};
use super::ranges::Ranges;
use super::values::Values;
use crate::list::{List, PushAll};
use crate::sorted::Map;

/// A function and the value it shall have.
pub(super) type Goal<'f> = (&'f Formula, bool);

/// What each atom can be.
pub(super) type Domains = Map<AtomId, Ranges>;

/// How deep alternatives may lie in each other: the search is recursive.
const DEPTH: u32 = 100;

/// One question.
pub(super) struct Search<'v> {
    /// How many functions may still be looked at.
    pub(super) budget: u32,
    /// What atoms say of values that are compared with each other.
    pub(super) values: Option<&'v Values>,
    /// What is found has to be so for certain.
    pub(super) sure: bool,
}

/// The budget does not suffice.
pub(super) struct Undecided;

impl Search<'_> {
    /// Values with which all goals are reached, if there are any. Every choice from the result is one.
    pub(super) fn solve(&mut self, domains: Domains, goals: Vec<Goal<'_>>) -> Result<Option<Domains>, Undecided> {
        self.search(domains, goals, DEPTH)
    }

    fn search(
        &mut self,
        mut domains: Domains,
        mut goals: Vec<Goal<'_>>,
        depth: u32,
    ) -> Result<Option<Domains>, Undecided> {
        let mut open = Vec::new();
        loop {
            if !self.take_apart(&mut domains, &mut goals, &mut open)? {
                return Ok(None);
            }
            let mut rest = Vec::new();
            for goal in open {
                match self.value(goal.0, &domains)? {
                    Some(value) if value == goal.1 => {}
                    Some(_) => return Ok(None),
                    None => match self.only_way(goal, &domains)? {
                        Some(way) => goals.push(way),
                        None => rest.push(goal),
                    },
                }
            }
            open = rest;
            if goals.is_empty() {
                break;
            }
        }
        let Some(first) = open.pop() else { return self.settle(domains, depth) };
        let depth = depth.checked_sub(1).ok_or(Undecided)?;
        for way in self.ways(first, &domains)? {
            let goals = open.iter().copied().and(way).list();
            if let Some(found) = self.search(domains.clone(), goals, depth)? {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    /// Follows what has no alternative; what has some is left `open`. `false` if it cannot be.
    fn take_apart<'f>(
        &mut self,
        domains: &mut Domains,
        goals: &mut Vec<Goal<'f>>,
        open: &mut Vec<Goal<'f>>,
    ) -> Result<bool, Undecided> {
        while let Some((formula, wanted)) = goals.pop() {
            self.pay(1)?;
            match formula {
                Formula::Const(value) if *value == wanted => {}
                Formula::Const(_) => return Ok(false),
                Formula::Leaf { atom, low, high } => {
                    let Some(domain) = domains.get_mut(atom) else { continue };
                    self.pay(domain.len())?;
                    domain.keep(*low, *high, wanted);
                    if domain.is_empty() {
                        return Ok(false);
                    }
                }
                Formula::Not(inner) => goals.push((inner, !wanted)),
                Formula::All(parts) if wanted => goals.push_all(parts.iter().map(|part| (part, true))),
                Formula::Any(parts) if !wanted => goals.push_all(parts.iter().map(|part| (part, false))),
                _ => open.push((formula, wanted)),
            }
        }
        Ok(true)
    }

    /// What an open goal comes down to where all but one of its alternatives are excluded.
    fn only_way<'f>(&mut self, goal: Goal<'f>, domains: &Domains) -> Result<Option<Goal<'f>>, Undecided> {
        let (Formula::All(parts) | Formula::Any(parts), wanted) = goal else { return Ok(None) };
        let mut only = None;
        for part in parts {
            if self.value(part, domains)?.is_none() && only.replace((part, wanted)).is_some() {
                return Ok(None);
            }
        }
        Ok(only)
    }

    /// The alternatives of an open goal; no two of them can be taken together.
    fn ways<'f>(&mut self, goal: Goal<'f>, domains: &Domains) -> Result<Vec<Vec<Goal<'f>>>, Undecided> {
        let (parts, wanted) = match goal {
            (Formula::All(parts) | Formula::Any(parts), wanted) => (parts, wanted),
            (Formula::Same(a, b), wanted) => {
                return Ok(vec![vec![(&**a, true), (&**b, wanted)], vec![(&**a, false), (&**b, !wanted)]]);
            }
            goal => return Ok(vec![vec![goal]]),
        };
        let mut ways: Vec<Vec<Goal<'f>>> = Vec::new();
        let mut before = Vec::new();
        for part in parts {
            if self.value(part, domains)?.is_none() {
                self.pay(before.len())?;
                ways.push(before.iter().copied().and([(part, wanted)]).list());
                before.push((part, !wanted));
            }
        }
        Ok(ways)
    }

    /// The value of a function, where the atoms decide it already.
    fn value(&mut self, formula: &Formula, domains: &Domains) -> Result<Option<bool>, Undecided> {
        self.pay(1)?;
        Ok(match formula {
            Formula::Const(value) => Some(*value),
            Formula::Leaf { atom, low, high } => match domains.get(atom) {
                Some(domain) => {
                    self.pay(domain.len())?;
                    domain.within(*low, *high)
                }
                None => None,
            },
            Formula::Not(inner) => self.value(inner, domains)?.map(|value| !value),
            Formula::All(parts) => self.list(parts, false, domains)?,
            Formula::Any(parts) => self.list(parts, true, domains)?,
            Formula::Same(a, b) => match (self.value(a, domains)?, self.value(b, domains)?) {
                (Some(a), Some(b)) => Some(a == b),
                _ => None,
            },
        })
    }

    /// The value of a list which one part that is `deciding` decides.
    fn list(&mut self, parts: &[Formula], deciding: bool, domains: &Domains) -> Result<Option<bool>, Undecided> {
        let mut open = false;
        for part in parts {
            match self.value(part, domains)? {
                Some(value) if value == deciding => return Ok(Some(deciding)),
                Some(_) => {}
                None => open = true,
            }
        }
        Ok((!open).then_some(!deciding))
    }

    pub(super) fn pay(&mut self, units: usize) -> Result<(), Undecided> {
        let units = u32::try_from(units).map_err(|_| Undecided)?;
        self.budget = self.budget.checked_sub(units).ok_or(Undecided)?;
        Ok(())
    }
}
