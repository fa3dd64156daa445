//! The constants in the statements and expressions of a program.

use crate::program::uses::{each_block, each_expr, each_part};
use crate::program::{Expr, PlaceId, Statement, Value};

/// A constant, and where it stands.
#[derive(Clone, Copy)]
pub(super) enum Constant {
    /// A place becomes it.
    Set(PlaceId, Value),
    /// A place is looked at for it.
    Arm(PlaceId, Value),
    /// A table has it.
    Entry(Value),
    Elsewhere(Value),
}

/// Those of statements.
pub(super) fn each_in(statements: &[Statement<'_>], each: &mut dyn FnMut(Constant)) {
    for statement in statements {
        match statement {
            Statement::Set(place, Expr::Value(value)) => each(Constant::Set(*place, *value)),
            Statement::Match(place, arms, _) => {
                for value in arms.iter().flat_map(|(values, _)| values) {
                    each(Constant::Arm(*place, *value));
                }
            }
            other => each_expr(other, &mut |expr| each_of(expr, each)),
        }
        each_block(statement, &mut |block| each_in(block, each));
    }
}

/// Those of an expression.
pub(super) fn each_of(expr: &Expr<'_>, each: &mut dyn FnMut(Constant)) {
    match expr {
        Expr::Value(value) => each(Constant::Elsewhere(*value)),
        Expr::Table(_, table) => {
            for (_, value) in table {
                each(Constant::Entry(*value));
            }
        }
        other => each_part(other, &mut |part| each_of(part, each)),
    }
}
