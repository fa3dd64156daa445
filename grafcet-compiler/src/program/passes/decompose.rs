//! Conditions of the user taken apart at `&&`, `||` and `!`, and names and step variables in them by what they stand for.
//!
//! ```text
//! clears = was.state is A && rust { 5s/A && on }      ->      clears = was.state is A && was.state is A && time >= 5s && on
//! ```
//!
//! What is left of the user's are the leaves, with their own tokens, and names that are no truths. Needs nothing: `&&` and `||` of the program are as lazy as those of
//! Rust.

use std::slice;

use syn::{BinOp, UnOp};

use super::super::build::{all, any, not};
use super::super::{Expr, Program, Statement, Type, User, Value};
use super::edits::rewrite;
use crate::model::{Binary, Model, Name, Read, Tree, Ty, Unary};

pub(super) fn pass(program: &mut Program<'_>) {
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, &mut cycle);
    program.cycle = cycle;
}

fn block<'m>(program: &Program<'m>, statements: &mut [Statement<'m>]) {
    let model = program.model;
    for statement in statements {
        match statement {
            Statement::Part(_, body) | Statement::Loop { body, .. } => block(program, body),
            Statement::If(condition, then, otherwise) => {
                *condition = decomposed(model, condition);
                block(program, then);
                block(program, otherwise);
            }
            Statement::Match(_, arms, otherwise) => {
                for (_, body) in arms {
                    block(program, body);
                }
                block(program, otherwise);
            }
            Statement::Set(place, new) if !matches!(program.places[place.0].ty, Type::User(_)) => {
                *new = decomposed(model, new);
            }
            other => rewrite(slice::from_mut(other), &mut |expr| value(model, expr)),
        }
    }
}

/// What is stored with a type of the user's, or handed on. A name alone keeps its token: whether it fits, rustc says there.
fn value<'m>(model: &Model, expr: &Expr<'m>) -> Expr<'m> {
    match expr {
        Expr::User(user) if matches!(user.tree, Tree::Read(Read::Name(_))) => expr.clone(),
        Expr::Choose(parts) => {
            Expr::Choose(Box::new([decomposed(model, &parts[0]), value(model, &parts[1]), value(model, &parts[2])]))
        }
        other => decomposed(model, other),
    }
}

fn decomposed<'m>(model: &Model, expr: &Expr<'m>) -> Expr<'m> {
    let list = |parts: &[Expr<'m>]| {
        let mut list = Vec::with_capacity(parts.len());
        for part in parts {
            list.push(decomposed(model, part));
        }
        list
    };
    match expr {
        Expr::Not(inner) => not(decomposed(model, inner)),
        Expr::All(parts) => all(list(parts)),
        Expr::Any(parts) => any(list(parts)),
        Expr::Choose(parts) => Expr::Choose(Box::new([
            decomposed(model, &parts[0]),
            decomposed(model, &parts[1]),
            decomposed(model, &parts[2]),
        ])),
        Expr::User(user) => of_user(model, user.tokens, user.tree, &user.binds),
        other => other.clone(),
    }
}

fn of_user<'m>(model: &Model, tokens: &'m syn::Expr, tree: &'m Tree, binds: &[(Read, Expr<'m>)]) -> Expr<'m> {
    let bound = |read: Read| binds.iter().find(|(other, _)| *other == read).map(|(_, value)| value.clone());
    let leaf = match tree {
        Tree::Bool(value) => Some(Expr::Value(Value::Bool(*value))),
        // What is no truth, rustc has to find at the user's token.
        Tree::Read(Read::Name(_)) if !is_truth(model, tree) => None,
        Tree::Read(read) => bound(*read),
        Tree::Elapsed(time, step) => bound(Read::Elapsed(*time, *step)),
        Tree::MacroElapsed(time, id) => bound(Read::MacroElapsed(*time, *id)),
        _ => None,
    };
    if let Some(value) = leaf {
        return value;
    }
    match (bare(tokens), tree) {
        // Of an integer it turns the bits.
        (syn::Expr::Unary(unary), Tree::Unary(Unary::Not, inner))
            if matches!(unary.op, UnOp::Not(_)) && is_truth(model, inner) =>
        {
            return not(of_user(model, &unary.expr, inner, binds));
        }
        (syn::Expr::Binary(binary), Tree::Binary(Binary::And, a, b)) if matches!(binary.op, BinOp::And(_)) => {
            return all(vec![of_user(model, &binary.left, a, binds), of_user(model, &binary.right, b, binds)]);
        }
        (syn::Expr::Binary(binary), Tree::Binary(Binary::Or, a, b)) if matches!(binary.op, BinOp::Or(_)) => {
            return any(vec![of_user(model, &binary.left, a, binds), of_user(model, &binary.right, b, binds)]);
        }
        _ => {}
    }
    let mut own: Vec<(Read, Expr<'m>)> = Vec::new();
    tree.each_read(&mut |read| {
        if !own.iter().any(|(other, _)| *other == read) {
            own.extend(bound(read).map(|value| (read, value)));
        }
    });
    Expr::User(Box::new(User { tokens, tree, binds: own }))
}

/// Whether it is certain that it is a truth and no number.
fn is_truth(model: &Model, tree: &Tree) -> bool {
    match tree {
        Tree::Bool(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => true,
        Tree::Read(Read::Name(name)) => {
            let ty = match *name {
                Name::Input(id) => &model.inputs[id].ty,
                Name::Output(id) => &model.outputs[id].ty,
                Name::Var(id) => &model.vars[id].ty,
                Name::Param(id) => &model.params[id].ty,
            };
            matches!(ty, Ty::Bool(_))
        }
        Tree::Read(read) => !matches!(read, Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)),
        Tree::Unary(Unary::Not, inner) => is_truth(model, inner),
        Tree::Binary(operator, ..) => {
            use Binary::{And, Eq, Ge, Gt, Le, Lt, Ne, Or};
            matches!(operator, And | Or | Eq | Ne | Lt | Le | Gt | Ge)
        }
        Tree::Int(_) | Tree::Unary(Unary::Neg, _) | Tree::Opaque { .. } => false,
    }
}

fn bare(expr: &syn::Expr) -> &syn::Expr {
    match expr {
        syn::Expr::Paren(inner) => bare(&inner.expr),
        syn::Expr::Group(inner) => bare(&inner.expr),
        other => other,
    }
}
