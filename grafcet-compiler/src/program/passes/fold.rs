//! Expressions in which some places are known, put together anew from what is left of them.

use super::super::build::{choose, no, not, yes};
use super::super::{Comparison, Expr, Initial, PlaceId, PlaceInfo, Type, User, Value};
use super::engine::Among;
use super::uses::{is_pure, same};
use crate::model::{StepId, Tree};

/// What is known of places.
pub(super) struct Known<'k, 'm> {
    pub(super) places: &'k [PlaceInfo<'m>],
    pub(super) value: &'k dyn Fn(PlaceId) -> Option<Value>,
    /// Another place that holds the same.
    pub(super) copy: &'k dyn Fn(PlaceId) -> Option<PlaceId>,
    /// The states of which a region has one.
    pub(super) among: &'k dyn Fn(PlaceId) -> Option<&'k Among>,
    /// Whether it holds the reading of the clock.
    pub(super) now: &'k dyn Fn(PlaceId) -> bool,
}

/// The value that a place begins with. Of what the user declares otherwise only Rust knows it.
pub(super) fn initial(place: &PlaceInfo<'_>) -> Option<Value> {
    match (place.initial, place.ty) {
        (Initial::Value(value), _) => Some(value),
        (Initial::Default, Type::Bool) => Some(Value::Bool(false)),
        (Initial::Default, Type::Ticks) => Some(Value::Ticks(0)),
        (Initial::Constant(expr), Type::Bool) => match expr.tree {
            Tree::Bool(value) => Some(Value::Bool(value)),
            _ => None,
        },
        _ => None,
    }
}

impl Known<'_, '_> {
    fn get(&self, place: PlaceId) -> Option<Value> {
        // A number of the user has a type, which it would lose.
        (self.value)(place).filter(|_| !matches!(self.places[place.0].ty, Type::User(_)))
    }

    pub(super) fn fold<'m>(&self, expr: &Expr<'m>) -> Expr<'m> {
        let two = |a: &Expr<'m>, b: &Expr<'m>| (self.fold(a), self.fold(b));
        match expr {
            Expr::Value(_) | Expr::Input(_) | Expr::Now | Expr::Table(..) => expr.clone(),
            Expr::Place(place) => match (self.get(*place), (self.copy)(*place)) {
                (Some(value), _) => Expr::Value(value),
                (None, Some(other)) => self.get(other).map_or(Expr::Place(other), Expr::Value),
                (None, None) if (self.now)(*place) => Expr::Now,
                (None, None) => expr.clone(),
            },
            Expr::Initial(place) => match (initial(&self.places[place.0]), self.places[place.0].ty) {
                (Some(value), Type::Bool | Type::Ticks) => Expr::Value(value),
                _ => expr.clone(),
            },
            Expr::Next(place) => match self.get(*place) {
                Some(Value::Int(number)) => Expr::Value(Value::Int(number.saturating_add(1))),
                _ => expr.clone(),
            },
            Expr::Is(place, steps) => match self.get(*place) {
                Some(Value::Step(Some(step))) => truth(steps.contains(&step)),
                Some(_) => no(),
                None => self.is(*place, steps),
            },
            Expr::Not(inner) => negated(self.fold(inner)),
            Expr::All(parts) => self.list(parts, true),
            Expr::Any(parts) => self.list(parts, false),
            Expr::Compare(comparison, a, b) => {
                let (a, b) = two(a, b);
                match comparison {
                    Comparison::Differs if self.cannot_meet(&a, &b) => yes(),
                    Comparison::Equal if self.cannot_meet(&a, &b) => no(),
                    comparison => compared(*comparison, a, b),
                }
            }
            Expr::Choose(parts) => self.chosen(parts),
            Expr::Add(a, b) => match two(a, b) {
                (Expr::Value(Value::Ticks(a)), Expr::Value(Value::Ticks(b))) => ticks(a.saturating_add(b)),
                (Expr::Value(Value::Ticks(0)), other) | (other, Expr::Value(Value::Ticks(0))) => other,
                (a, b) => Expr::Add(Box::new(a), Box::new(b)),
            },
            Expr::Sub(a, b) => match two(a, b) {
                (Expr::Value(Value::Ticks(a)), Expr::Value(Value::Ticks(b))) => ticks(a.saturating_sub(b)),
                (other, Expr::Value(Value::Ticks(0))) => other,
                (a, b) => Expr::Sub(Box::new(a), Box::new(b)),
            },
            Expr::Since(a, b) => match two(a, b) {
                (Expr::Value(Value::Ticks(a)), Expr::Value(Value::Ticks(b))) => ticks(a.wrapping_sub(b)),
                (Expr::Now, Expr::Now) => ticks(0),
                (a, b) => Expr::Since(Box::new(a), Box::new(b)),
            },
            Expr::Period(a, b, period) => match two(a, b) {
                (Expr::Value(Value::Ticks(a)), Expr::Value(Value::Ticks(0))) if a < *period => ticks(a),
                (a, b) => Expr::Period(Box::new(a), Box::new(b), *period),
            },
            Expr::User(user) => {
                let mut binds = Vec::with_capacity(user.binds.len());
                for (read, value) in &user.binds {
                    binds.push((*read, self.fold(value)));
                }
                Expr::User(Box::new(User { tokens: user.tokens, tree: user.tree, binds }))
            }
        }
    }

    /// Whether a state that is not known is one of some.
    fn is<'m>(&self, place: PlaceId, steps: &[StepId]) -> Expr<'m> {
        let place = (self.copy)(place).unwrap_or(place);
        if let Some(Value::Step(step)) = self.get(place) {
            return truth(step.is_some_and(|step| steps.contains(&step)));
        }
        let Some(list) = (self.among)(place) else { return Expr::Is(place, steps.to_vec()) };
        let found = |state: &Option<StepId>| state.is_some_and(|step| steps.contains(&step));
        if list.iter().all(found) {
            return yes();
        }
        let mut left = steps.to_vec();
        left.retain(|step| list.contains(&Some(*step)));
        if left.is_empty() { no() } else { Expr::Is(place, left) }
    }

    /// Whether a state is none of those that another one can be.
    fn cannot_meet(&self, a: &Expr<'_>, b: &Expr<'_>) -> bool {
        let possible = |expr: &Expr<'_>| match expr {
            Expr::Value(Value::Step(step)) => Some(vec![*step]),
            Expr::Place(place) => (self.among)(*place).cloned(),
            _ => None,
        };
        let (Some(a), Some(b)) = (possible(a), possible(b)) else { return false };
        !a.iter().any(|step| b.contains(step))
    }

    /// `All` (`and`) or `Any` of some parts. What could answer differently each time is asked in any case.
    fn list<'m>(&self, parts: &[Expr<'m>], and: bool) -> Expr<'m> {
        let mut rest: Vec<Expr<'m>> = Vec::new();
        for part in parts {
            let part = self.fold(part);
            match part {
                Expr::Value(Value::Bool(value)) if value == and => {}
                Expr::Value(Value::Bool(_)) if rest.iter().all(is_pure) => return truth(!and),
                Expr::Value(Value::Bool(_)) => {
                    rest.push(part);
                    break;
                }
                Expr::All(inner) if and => rest.extend(inner),
                Expr::Any(inner) if !and => rest.extend(inner),
                part if rest.iter().any(|other| same(other, &part) && is_pure(&part)) => {}
                part if rest.iter().any(|other| excludes(other, &part)) && rest.iter().all(is_pure) => {
                    return truth(!and);
                }
                part => rest.push(part),
            }
        }
        match (rest.len(), and) {
            (0, _) => truth(and),
            (1, _) => rest.remove(0),
            (_, true) => Expr::All(rest),
            (_, false) => Expr::Any(rest),
        }
    }

    fn chosen<'m>(&self, parts: &[Expr<'m>; 3]) -> Expr<'m> {
        let condition = self.fold(&parts[0]);
        if let Expr::Value(Value::Bool(holds)) = condition {
            return self.fold(&parts[if holds { 1 } else { 2 }]);
        }
        let (then, otherwise) = (self.fold(&parts[1]), self.fold(&parts[2]));
        if same(&then, &otherwise) && is_pure(&condition) {
            return then;
        }
        choose(condition, then, otherwise)
    }
}

fn truth<'m>(value: bool) -> Expr<'m> {
    if value { yes() } else { no() }
}

fn ticks<'m>(ticks: u32) -> Expr<'m> {
    Expr::Value(Value::Ticks(ticks))
}

pub(super) fn negated(expr: Expr<'_>) -> Expr<'_> {
    match expr {
        Expr::Compare(Comparison::Less, a, b) => Expr::Compare(Comparison::AtLeast, a, b),
        Expr::Compare(Comparison::AtLeast, a, b) => Expr::Compare(Comparison::Less, a, b),
        Expr::Compare(Comparison::Equal, a, b) => Expr::Compare(Comparison::Differs, a, b),
        Expr::Compare(Comparison::Differs, a, b) => Expr::Compare(Comparison::Equal, a, b),
        other => not(other),
    }
}

fn compared<'m>(comparison: Comparison, a: Expr<'m>, b: Expr<'m>) -> Expr<'m> {
    let order = match (&a, &b) {
        (Expr::Value(a), Expr::Value(b)) => Some(a.cmp(b)),
        (a, b) if same(a, b) && is_pure(a) => Some(std::cmp::Ordering::Equal),
        _ => None,
    };
    match (comparison, order) {
        (Comparison::Equal, Some(order)) => truth(order.is_eq()),
        (Comparison::Differs, Some(order)) => truth(order.is_ne()),
        (Comparison::Less, Some(order)) => truth(order.is_lt()),
        (Comparison::AtLeast, Some(order)) => truth(order.is_ge()),
        // A truth compared with a known one.
        (Comparison::Equal | Comparison::Differs, None) => match (a, b) {
            (Expr::Value(Value::Bool(value)), other) | (other, Expr::Value(Value::Bool(value))) => {
                if value == (comparison == Comparison::Equal) { other } else { negated(other) }
            }
            (a, b) => Expr::Compare(comparison, Box::new(a), Box::new(b)),
        },
        (comparison, None) => match (&a, &b) {
            // No time is less than none.
            (_, Expr::Value(Value::Ticks(0))) if is_pure(&a) => truth(comparison == Comparison::AtLeast),
            _ => Expr::Compare(comparison, Box::new(a), Box::new(b)),
        },
    }
}

/// Whether one says the opposite of the other.
pub(super) fn excludes(a: &Expr<'_>, b: &Expr<'_>) -> bool {
    match (a, b) {
        (Expr::Not(inner), other) | (other, Expr::Not(inner)) => same(inner, other) && is_pure(inner),
        _ => false,
    }
}
