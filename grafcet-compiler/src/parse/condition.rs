//! Conditions: Rust expressions, with an ear for other notations.

use proc_macro2::Delimiter;
use syn::parse::{Parse, ParseStream};
use syn::spanned::Spanned;
use syn::{BinOp, Expr};

use super::{Error, Input, Result, leaving};
use crate::diagnostic::Mark;

/// A condition, up to what cannot belong to it any more. `what` says what it is if it is missing.
pub(super) fn parse(input: &mut Input, what: &str) -> Result<Expr> {
    with(input, what, Expr::parse)
}

/// A condition behind which a block may follow.
pub(super) fn before_block(input: &mut Input, what: &str) -> Result<Expr> {
    with(input, what, Expr::parse_without_eager_brace)
}

fn with(input: &mut Input, what: &str, parse: fn(ParseStream) -> syn::Result<Expr>) -> Result<Expr> {
    if input.is_empty() || input.at(";") || input.at("=>") {
        return Err(input.error(format!("expected {what}, found {}", input.found())));
    }
    let start = *input;
    let expr = input.rust(parse).map_err(|error| foreign(start).unwrap_or(error))?;
    // `a AND b` ends, for Rust, in front of `AND`.
    if starts_operand(input) {
        foreign(start).map_or(Ok(()), Err)?;
    }
    leaving::expr(&start, input, &expr)?;
    let mut notes = Vec::new();
    assignments(&expr, &mut notes);
    match Error::several(notes) {
        Some(error) => Err(error),
        None => Ok(expr),
    }
}

/// What Rust calls an operator that is written as a word.
fn operator(word: &str) -> Option<&'static str> {
    match word.to_lowercase().as_str() {
        "and" => Some("&&"),
        "or" => Some("||"),
        "not" => Some("!"),
        "xor" => Some("^"),
        _ => None,
    }
}

fn starts_operand(input: &Input) -> bool {
    input.at_name() || input.literal().is_some()
}

/// The words and signs of other notations in an expression that Rust could not read.
fn foreign(mut input: Input) -> Option<Error> {
    let mut notes = Vec::new();
    collect_foreign(&mut input, &mut notes);
    Error::several(notes)
}

fn collect_foreign(input: &mut Input, notes: &mut Vec<(Mark, String)>) {
    let mut operand = false;
    // Where a `;` is missing, the rest of the chart is no part of this condition.
    for _ in 0..100 {
        if input.is_empty() || input.at(";") {
            return;
        }
        if let Some((word, ours)) = input.word().and_then(|word| Some((word, operator(word)?))) {
            let behind = input.next();
            // A name like any other, unless an operand follows it.
            if starts_operand(&behind) || behind.at_group(Delimiter::Parenthesis) || behind.at("!") {
                notes.push((input.span().into(), format!("`{word}` is written `{ours}`")));
            }
        } else if input.at("<>") {
            notes.push((input.span().into(), "`<>` is written `!=`".to_owned()));
            input.bump();
        } else if input.at(":=") {
            notes.push((input.span().into(), "a condition compares with `==`".to_owned()));
            input.bump();
        } else if input.at("/") && !operand {
            notes.push((input.span().into(), "a negation is written `!a`".to_owned()));
        }
        operand = input.punct().is_none();
        match input.delimiter().and_then(|delimiter| input.enter(delimiter)) {
            Some(mut inside) => collect_foreign(&mut inside, notes),
            None => {
                input.bump();
            }
        }
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
