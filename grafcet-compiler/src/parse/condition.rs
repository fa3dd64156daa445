//! Conditions: Rust expressions, with an ear for other notations.

use syn::parse::{Parse, ParseStream};
use syn::spanned::Spanned;
use syn::{BinOp, Expr};

use super::{Error, Input, Result, foreign, rust};
use crate::diagnostic::Mark;

/// A condition, up to what cannot belong to it any more. `what` says what it is if it is missing.
pub(super) fn parse(input: &mut Input, what: &str) -> Result<Expr> {
    with(input, what, Expr::parse)
}

/// A condition after which a block may follow.
pub(super) fn before_block(input: &mut Input, what: &str) -> Result<Expr> {
    with(input, what, Expr::parse_without_eager_brace)
}

fn with(input: &mut Input, what: &str, parse: fn(ParseStream) -> syn::Result<Expr>) -> Result<Expr> {
    if input.is_empty() || input.at(";") || input.at("=>") {
        return Err(input.error(format!("expected {what}, found {}", input.found())));
    }
    let start = *input;
    let expr =
        input.rust(parse).map_err(|error| foreign::all(start).or_else(|| foreign::keyword(start)).unwrap_or(error))?;
    // `a AND b` ends, for Rust, in front of `AND`, `T#5s` in front of `#`.
    if foreign::starts_operand(input) || input.at("#") {
        foreign::all(start).map_or(Ok(()), Err)?;
    }
    rust::expr(&start, input, &expr)?;
    let mut notes = Vec::new();
    assignments(&expr, &mut notes);
    nothing_on_the_left(&expr, &mut notes);
    match Error::several(notes) {
        Some(error) => Err(error),
        None => Ok(expr),
    }
}

/// `|| a` and `a && || b`: to Rust a closure, which is no condition.
fn nothing_on_the_left(expr: &Expr, notes: &mut Vec<(Mark, String)>) {
    match expr {
        Expr::Closure(closure) if closure.inputs.is_empty() => {
            let mark = Mark { start: closure.inputs_begin.span(), end: closure.inputs_end.span() };
            notes.push((mark, "nothing stands on the left of this `||`; remove it, or write `a || b`".to_owned()));
            nothing_on_the_left(&closure.body, notes);
        }
        // `&& a`: to Rust a reference to a reference.
        Expr::Reference(outer) => {
            if let Expr::Reference(inner) = &*outer.expr {
                let mark = Mark { start: outer.and_token.span, end: inner.and_token.span };
                notes.push((mark, "nothing stands on the left of this `&&`; remove it, or write `a && b`".to_owned()));
            }
        }
        Expr::Binary(binary) if matches!(binary.op, BinOp::And(_) | BinOp::Or(_)) => {
            nothing_on_the_left(&binary.left, notes);
            nothing_on_the_left(&binary.right, notes);
        }
        Expr::Unary(unary) => nothing_on_the_left(&unary.expr, notes),
        Expr::Paren(paren) => nothing_on_the_left(&paren.expr, notes),
        _ => {}
    }
}

/// `a = b` where a condition compares.
fn assignments(expr: &Expr, notes: &mut Vec<(Mark, String)>) {
    match expr {
        Expr::Assign(assign) => {
            notes.push((assign.eq_token.span.into(), "`=` assigns; a condition compares with `==`".to_owned()));
            assignments(&assign.left, notes);
            assignments(&assign.right, notes);
        }
        Expr::Binary(binary) => {
            if changes(&binary.op) {
                notes.push((binary.op.span().into(), "a condition changes nothing; compare with `==`".to_owned()));
            }
            assignments(&binary.left, notes);
            assignments(&binary.right, notes);
        }
        Expr::Unary(unary) => assignments(&unary.expr, notes),
        Expr::Paren(paren) => assignments(&paren.expr, notes),
        _ => {}
    }
}

/// `+=` and its kin.
pub(super) fn changes(op: &BinOp) -> bool {
    matches!(
        op,
        BinOp::AddAssign(_)
            | BinOp::SubAssign(_)
            | BinOp::MulAssign(_)
            | BinOp::DivAssign(_)
            | BinOp::RemAssign(_)
            | BinOp::BitXorAssign(_)
            | BinOp::BitAndAssign(_)
            | BinOp::BitOrAssign(_)
            | BinOp::ShlAssign(_)
            | BinOp::ShrAssign(_)
    )
}
