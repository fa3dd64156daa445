//! Conditions: Rust expressions, with an ear for other notations.

use proc_macro2::{Delimiter, Ident, TokenTree};
use syn::parse::{ParseBuffer, ParseStream};
use syn::spanned::Spanned;
use syn::{BinOp, Expr};

use super::{Error, Input, Result};
use crate::diagnostic::Mark;

/// A condition, up to what cannot belong to it any more. `what` says what it is if it is missing.
pub(super) fn parse(input: &mut Input, what: &str) -> Result<Expr> {
    with(input, what, ParseBuffer::parse)
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
    if input.ident().is_some_and(|word| operator(&word).is_some()) || is_not(&expr) && starts_operand(input) {
        if let Some(error) = foreign(start) {
            return Err(error);
        }
    }
    let mut notes = Vec::new();
    assignments(&expr, &mut notes);
    match Error::several(notes) {
        Some(error) => Err(error),
        None => Ok(expr),
    }
}

/// What Rust calls an operator that is written as a word.
fn operator(word: &Ident) -> Option<&'static str> {
    match word.to_string().to_lowercase().as_str() {
        "and" => Some("&&"),
        "or" => Some("||"),
        "not" => Some("!"),
        "xor" => Some("^"),
        _ => None,
    }
}

fn is_not(expr: &Expr) -> bool {
    matches!(expr, Expr::Path(path) if path.path.get_ident().is_some_and(|word| operator(word) == Some("!")))
}

fn starts_operand(input: &Input) -> bool {
    input.ident().is_some_and(|word| word != "if") || input.literal().is_some()
}

/// The words and signs of other notations in an expression that Rust could not read.
fn foreign(mut input: Input) -> Option<Error> {
    let mut notes = Vec::new();
    collect_foreign(&mut input, &mut notes);
    Error::several(notes)
}

fn collect_foreign(input: &mut Input, notes: &mut Vec<(Mark, String)>) {
    let mut operand = false;
    while !input.is_empty() && !input.at(";") {
        if let Some((word, ours)) = input.ident().and_then(|word| Some((word.clone(), operator(&word)?))) {
            let behind = input.next();
            // A name like any other, unless an operand follows it.
            if starts_operand(&behind) || behind.at_group(Delimiter::Parenthesis) || behind.at("!") {
                notes.push((Mark::from(&word), format!("`{word}` is written `{ours}`")));
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
        match input.tree() {
            Some(TokenTree::Group(group)) => {
                if let Some(mut inside) = input.enter(group.delimiter()) {
                    collect_foreign(&mut inside, notes);
                }
            }
            _ => {
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
        Expr::Group(group) => assignments(&group.expr, notes),
        _ => {}
    }
}

/// `+=` and its kin.
fn changes(op: &BinOp) -> bool {
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
