//! Expressions put together. What is trivial is left away, so that a person can read the rest.

use super::{Comparison, Expr, PlaceId, Statement, Value};
use crate::list::PushAll;

pub(super) fn yes<'m>() -> Expr<'m> {
    Expr::Value(Value::Bool(true))
}

pub(super) fn no<'m>() -> Expr<'m> {
    Expr::Value(Value::Bool(false))
}

pub(super) fn zero<'m>() -> Expr<'m> {
    ticks(0)
}

pub(super) fn ticks<'m>(ticks: u32) -> Expr<'m> {
    Expr::Value(Value::Ticks(ticks))
}

fn known(expr: &Expr<'_>) -> Option<bool> {
    match expr {
        Expr::Value(Value::Bool(value)) => Some(*value),
        _ => None,
    }
}

pub(super) fn not(expr: Expr<'_>) -> Expr<'_> {
    match expr {
        Expr::Not(inner) => *inner,
        Expr::Value(Value::Bool(value)) => Expr::Value(Value::Bool(!value)),
        other => Expr::Not(Box::new(other)),
    }
}

pub(super) fn all(parts: Vec<Expr<'_>>) -> Expr<'_> {
    let mut rest = Vec::new();
    for part in parts {
        match (known(&part), part) {
            (Some(true), _) => {}
            (Some(false), _) => return no(),
            (None, Expr::All(inner)) => rest.push_all(inner),
            (None, part) => rest.push(part),
        }
    }
    match (rest.pop(), rest.is_empty()) {
        (None, _) => yes(),
        (Some(one), true) => one,
        (Some(last), false) => {
            rest.push(last);
            Expr::All(rest)
        }
    }
}

pub(super) fn any(parts: Vec<Expr<'_>>) -> Expr<'_> {
    let mut rest = Vec::new();
    for part in parts {
        match (known(&part), part) {
            (Some(false), _) => {}
            (Some(true), _) => return yes(),
            (None, Expr::Any(inner)) => rest.push_all(inner),
            (None, part) => rest.push(part),
        }
    }
    match (rest.pop(), rest.is_empty()) {
        (None, _) => no(),
        (Some(one), true) => one,
        (Some(last), false) => {
            rest.push(last);
            Expr::Any(rest)
        }
    }
}

pub(super) fn compare<'m>(comparison: Comparison, a: Expr<'m>, b: Expr<'m>) -> Expr<'m> {
    Expr::Compare(comparison, Box::new(a), Box::new(b))
}

pub(super) fn at_least<'m>(a: Expr<'m>, b: Expr<'m>) -> Expr<'m> {
    compare(Comparison::AtLeast, a, b)
}

pub(super) fn less<'m>(a: Expr<'m>, b: Expr<'m>) -> Expr<'m> {
    compare(Comparison::Less, a, b)
}

pub(super) fn differ<'m>(a: PlaceId, b: PlaceId) -> Expr<'m> {
    compare(Comparison::Differs, Expr::Place(a), Expr::Place(b))
}

pub(super) fn choose<'m>(condition: Expr<'m>, then: Expr<'m>, otherwise: Expr<'m>) -> Expr<'m> {
    match known(&condition) {
        Some(true) => then,
        Some(false) => otherwise,
        None => Expr::Choose(Box::new([condition, then, otherwise])),
    }
}

pub(super) fn add<'m>(a: Expr<'m>, b: Expr<'m>) -> Expr<'m> {
    Expr::Add(Box::new(a), Box::new(b))
}

pub(super) fn sub<'m>(a: Expr<'m>, b: Expr<'m>) -> Expr<'m> {
    Expr::Sub(Box::new(a), Box::new(b))
}

pub(super) fn number<'m>(index: usize) -> Expr<'m> {
    Expr::Value(Value::Int(i128::try_from(index).unwrap_or(i128::MAX)))
}

/// `if condition: …`; nothing where there is nothing to do, no question where there is none.
pub(super) fn when<'m>(into: &mut Vec<Statement<'m>>, condition: Expr<'m>, body: Vec<Statement<'m>>) {
    match known(&condition) {
        Some(true) => into.push_all(body),
        Some(false) => {}
        None if body.is_empty() => {}
        None => into.push(Statement::If(condition, body, Vec::new())),
    }
}

/// A paragraph, unless it is empty.
pub(super) fn part<'m>(into: &mut Vec<Statement<'m>>, name: &'static str, body: Vec<Statement<'m>>) {
    if !body.is_empty() {
        into.push(Statement::Part(name, body));
    }
}
