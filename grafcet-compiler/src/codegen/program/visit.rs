//! A walk through the statements and expressions of a program.

use crate::program::{Expr, PlaceId, Statement, Value};

/// What is met.
#[derive(Clone, Copy)]
pub(super) enum Seen {
    Read(PlaceId),
    Written(PlaceId),
    /// A place becomes a constant.
    Set(PlaceId, Value),
    /// A place is looked at for a constant.
    Arm(PlaceId, Value),
    /// A table has a constant.
    Entry(Value),
    /// A constant elsewhere.
    Value(Value),
}

/// All that statements mention, in the order in which it happens.
pub(super) fn block(statements: &[Statement<'_>], note: &mut dyn FnMut(Seen)) {
    for statement in statements {
        self::statement(statement, note);
        for inner in blocks(statement) {
            block(inner, note);
        }
    }
}

/// The blocks within a statement.
pub(super) fn blocks<'s, 'm>(statement: &'s Statement<'m>) -> Vec<&'s [Statement<'m>]> {
    match statement {
        Statement::Part(_, body) | Statement::Loop { body, .. } => vec![body],
        Statement::If(_, then, otherwise) => vec![then, otherwise],
        Statement::Match(_, arms, otherwise) => {
            let mut all: Vec<&[Statement<'m>]> = Vec::new();
            for (_, body) in arms {
                all.push(body);
            }
            all.push(otherwise);
            all
        }
        _ => Vec::new(),
    }
}

/// What a statement mentions itself, without the blocks within it.
pub(super) fn statement(statement: &Statement<'_>, note: &mut dyn FnMut(Seen)) {
    match statement {
        Statement::Set(place, value) => {
            match value {
                Expr::Value(value) => note(Seen::Set(*place, *value)),
                value => expr(value, note),
            }
            note(Seen::Written(*place));
        }
        Statement::If(condition, ..) => expr(condition, note),
        Statement::Match(place, arms, _) => {
            note(Seen::Read(*place));
            for (values, _) in arms {
                for value in values {
                    note(Seen::Arm(*place, *value));
                }
            }
        }
        Statement::Run(run) => {
            for (_, value) in &run.binds {
                expr(value, note);
            }
            for write in &run.writes {
                // The block begins with what it is.
                note(Seen::Read(write.to));
                note(Seen::Written(write.to));
                write.noted.into_iter().for_each(|noted| note(Seen::Written(noted)));
            }
        }
        Statement::Call(_, phase, args) => {
            expr(phase, note);
            for arg in args {
                expr(arg, note);
            }
        }
        Statement::Part(..) | Statement::Loop { .. } | Statement::Break | Statement::Mark(_) | Statement::Fence(_) => {}
    }
}

pub(super) fn expr(expr: &Expr<'_>, note: &mut dyn FnMut(Seen)) {
    match expr {
        Expr::Value(value) => note(Seen::Value(*value)),
        Expr::Place(place) | Expr::Is(place, _) | Expr::Next(place) => note(Seen::Read(*place)),
        Expr::Table(place, table) => {
            note(Seen::Read(*place));
            for (_, value) in table {
                note(Seen::Entry(*value));
            }
        }
        Expr::Initial(_) | Expr::Input(_) | Expr::Now => {}
        Expr::Not(inner) => self::expr(inner, note),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().for_each(|part| self::expr(part, note)),
        Expr::Compare(_, a, b) | Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) | Expr::Period(a, b, _) => {
            self::expr(a, note);
            self::expr(b, note);
        }
        Expr::Choose(parts) => parts.iter().for_each(|part| self::expr(part, note)),
        Expr::User(user) => user.binds.iter().for_each(|(_, value)| self::expr(value, note)),
    }
}
