//! Where a region may be without a step: beside some states of what forces or encloses it, and no others. Found by going through the round with the
//! states of two regions, from those in which the chart begins, until no others come.

use super::super::several::{Emptied, Several};
use crate::model::StepId;
use crate::program::{Arm, Expr, PlaceId, Statement, Value};
use crate::sorted::Set;

/// For each region that may be without a step: the others of which not all states allow it.
pub(super) fn emptied(several: &Several<'_, '_>, round: &[Statement<'_>], begin: &[Option<StepId>]) -> Vec<Emptied> {
    let mut found = Vec::new();
    for (region, state) in several.states.iter().enumerate().filter(|(region, _)| !several.full[*region]) {
        for (above, leads) in several.states.iter().enumerate().filter(|(above, _)| *above != region) {
            let possible = several.possible(above);
            let two = Two { above: *leads, region: *state, possible: &possible };
            let mut beside = Set::new();
            beside.extend(
                two.reached((begin[above], begin[region].is_none()), round)
                    .iter()
                    .filter(|pair| pair.1)
                    .map(|pair| pair.0),
            );
            if beside.len() < possible.len() {
                found.push(Emptied { region, above, beside });
            }
        }
    }
    found
}

/// The state of the region above, and whether the other one is without a step.
type Pair = (Option<StepId>, bool);

struct Two<'p> {
    above: PlaceId,
    region: PlaceId,
    /// The states of the region above.
    possible: &'p [Option<StepId>],
}

impl Two<'_> {
    /// What comes in any number of rounds.
    fn reached(&self, begin: Pair, round: &[Statement<'_>]) -> Set<Pair> {
        let mut all = Set::new();
        all.insert(begin);
        loop {
            let after = self.after(round, all.clone());
            let before = all.len();
            all.extend(after.iter().copied());
            if all.len() == before {
                return all;
            }
        }
    }

    fn after(&self, statements: &[Statement<'_>], mut pairs: Set<Pair>) -> Set<Pair> {
        for statement in statements {
            pairs = match statement {
                Statement::Part(_, body) => self.after(body, pairs),
                Statement::Set(place, value) => self.set(*place, value, pairs),
                Statement::If(condition, then, otherwise) => {
                    let where_it = |holds: bool| only(&pairs, &|pair| self.may(condition, holds, pair));
                    let mut met = self.after(then, where_it(true));
                    met.extend(self.after(otherwise, where_it(false)).iter().copied());
                    met
                }
                Statement::Match(place, arms, otherwise) => self.matched(*place, arms, otherwise, &pairs),
                Statement::Loop { .. } => self.anything(),
                _ => pairs,
            };
        }
        pairs
    }

    fn anything(&self) -> Set<Pair> {
        let mut all = Set::new();
        for step in self.possible {
            all.extend([(*step, false), (*step, true)]);
        }
        all
    }

    fn set(&self, place: PlaceId, value: &Expr<'_>, pairs: Set<Pair>) -> Set<Pair> {
        match value {
            _ if place != self.above && place != self.region => pairs,
            Expr::Value(Value::Step(step)) if place == self.above => pairs.iter().map(|pair| (*step, pair.1)).collect(),
            Expr::Value(Value::Step(step)) => pairs.iter().map(|pair| (pair.0, step.is_none())).collect(),
            _ => self.anything(),
        }
    }

    fn matched(&self, place: PlaceId, arms: &[Arm<'_>], otherwise: &[Statement<'_>], pairs: &Set<Pair>) -> Set<Pair> {
        // Whether the place may hold a value, and whether it holds it for certain.
        let may = |value: &Value, pair: &Pair| match value {
            Value::Step(step) if place == self.above => *step == pair.0,
            Value::Step(step) if place == self.region => step.is_none() == pair.1,
            _ => place != self.above && place != self.region,
        };
        let must = |value: &Value, pair: &Pair| match value {
            Value::Step(step) if place == self.above => *step == pair.0,
            Value::Step(None) if place == self.region => pair.1,
            _ => false,
        };
        let mut met = Set::new();
        for (values, body) in arms {
            let inner = only(pairs, &|pair| values.iter().any(|value| may(value, pair)));
            met.extend(self.after(body, inner).iter().copied());
        }
        let named = |pair: &Pair| arms.iter().any(|(values, _)| values.iter().any(|value| must(value, pair)));
        met.extend(self.after(otherwise, only(pairs, &|pair| !named(pair))).iter().copied());
        met
    }

    /// Whether a condition may be so.
    fn may(&self, condition: &Expr<'_>, holds: bool, pair: &Pair) -> bool {
        match condition {
            Expr::Value(Value::Bool(value)) => *value == holds,
            Expr::Is(place, steps) if *place == self.above => pair.0.is_some_and(|step| steps.contains(&step)) == holds,
            Expr::Is(place, _) if *place == self.region => !(pair.1 && holds),
            Expr::Not(inner) => self.may(inner, !holds, pair),
            Expr::All(parts) if holds => parts.iter().all(|part| self.may(part, true, pair)),
            Expr::All(parts) => parts.iter().any(|part| self.may(part, false, pair)),
            Expr::Any(parts) if holds => parts.iter().any(|part| self.may(part, true, pair)),
            Expr::Any(parts) => parts.iter().all(|part| self.may(part, false, pair)),
            _ => true,
        }
    }
}

fn only(pairs: &Set<Pair>, which: &dyn Fn(&Pair) -> bool) -> Set<Pair> {
    let mut left = Set::new();
    left.extend(pairs.iter().filter(|pair| which(pair)).copied());
    left
}
