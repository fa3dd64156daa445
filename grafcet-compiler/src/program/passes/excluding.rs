//! Which statements of a list never take place both, by the states they ask for: they may stand in any order.
//!
//! ```text
//! if state.A is A1: n = n + 1                             if state.A is A1: n = n + 1
//! if state.B is B1: n = n + 2      A1 excludes B2,   ->   if state.A is A2: n = n + 3
//! if state.A is A2: n = n + 3      A2 excludes B1         if state.B is B1: n = n + 2
//! if state.B is B2: n = n + 4                             if state.B is B2: n = n + 4
//! ```

use super::super::{Expr, PlaceId, Statement};
use super::uses::each_written;
use crate::analysis::Relation;
use crate::model::{Id, StepId};
use crate::sorted::Map;

/// The states of regions, copies of them from before the evolution, and which steps are active beside which.
pub(super) struct Situations<'s> {
    pub(super) states: &'s [PlaceId],
    pub(super) was: &'s [Option<PlaceId>],
    pub(super) beside: &'s Relation,
}

/// A state that a statement asks for.
#[derive(Clone, Copy)]
struct Asked<'e> {
    /// Before the evolution, or after it.
    before: bool,
    region: usize,
    steps: &'e [StepId],
}

/// What each statement of a list asks for.
pub(super) struct Excluding<'e> {
    situations: &'e Situations<'e>,
    asked: Vec<Vec<Asked<'e>>>,
}

impl<'e> Excluding<'e> {
    pub(super) fn of(situations: &'e Situations<'e>, list: &'e [Statement<'_>]) -> Self {
        let mut count: Map<PlaceId, usize> = Map::new();
        // In the middle of an evolution states are of two moments.
        let mut evolved = 0;
        for (at, statement) in list.iter().enumerate() {
            each_written(std::slice::from_ref(statement), &mut |place| {
                *count.or_default(place) += 1;
                if situations.states.contains(&place) {
                    evolved = at + 1;
                }
            });
        }
        // By truth that is set once: what it asks for.
        let mut truths: Map<PlaceId, Vec<Asked<'e>>> = Map::new();
        let mut all = Vec::with_capacity(list.len());
        for (at, statement) in list.iter().enumerate() {
            let asks = |condition: &'e Expr<'_>| situations.asked(condition, at >= evolved, &truths);
            match statement {
                Statement::If(condition, _, otherwise) if otherwise.is_empty() => all.push(asks(condition)),
                Statement::Set(truth, value) if count.get(truth) == Some(&1) => {
                    let asked = asks(value);
                    if !asked.is_empty() {
                        truths.insert(*truth, asked);
                    }
                    all.push(Vec::new());
                }
                _ => all.push(Vec::new()),
            }
        }
        Self { situations, asked: all }
    }

    /// It does something in some states alone.
    pub(super) fn is_bound(&self, at: usize) -> bool {
        !self.asked[at].is_empty()
    }

    pub(super) fn excludes(&self, one: usize, other: usize) -> bool {
        let differ = |a: &Asked<'_>, b: &Asked<'_>| a.before == b.before && self.situations.exclude(a, b);
        self.asked[one].iter().any(|a| self.asked[other].iter().any(|b| differ(a, b)))
    }
}

impl Situations<'_> {
    /// In which states alone a condition holds.
    fn asked<'e>(
        &self,
        condition: &'e Expr<'_>,
        has_evolved: bool,
        truths: &Map<PlaceId, Vec<Asked<'e>>>,
    ) -> Vec<Asked<'e>> {
        let parts = match condition {
            Expr::All(parts) => &parts[..],
            one => std::slice::from_ref(one),
        };
        let mut asked = Vec::new();
        for part in parts {
            match part {
                Expr::Place(truth) => asked.extend(truths.get(truth).into_iter().flatten().copied()),
                Expr::Is(place, steps) => {
                    let now = self.states.iter().position(|state| state == place).filter(|_| has_evolved);
                    let before = self.was.iter().position(|was| *was == Some(*place));
                    asked.extend(now.map(|region| Asked { before: false, region, steps }));
                    asked.extend(before.map(|region| Asked { before: true, region, steps }));
                }
                _ => {}
            }
        }
        asked
    }

    fn exclude(&self, a: &Asked<'_>, b: &Asked<'_>) -> bool {
        let may_be = |one: StepId, other: StepId| {
            if a.region == b.region { one == other } else { self.beside.contains(one.index(), other.index()) }
        };
        !a.steps.iter().any(|one| b.steps.iter().any(|other| may_be(*one, *other)))
    }
}
