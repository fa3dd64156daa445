//! How passes change statements.

use super::super::{Expr, PlaceId, Statement, User};
use crate::model::Read;

/// Each expression of some statements, given anew.
pub(super) fn rewrite<'m>(statements: &mut [Statement<'m>], new: &mut dyn FnMut(&Expr<'m>) -> Expr<'m>) {
    for statement in statements {
        match statement {
            Statement::Part(_, body) | Statement::Loop { body, .. } => rewrite(body, new),
            Statement::Set(_, value) => *value = new(value),
            Statement::If(condition, then, otherwise) => {
                *condition = new(condition);
                rewrite(then, new);
                rewrite(otherwise, new);
            }
            Statement::Match(_, arms, otherwise) => {
                for (_, body) in arms {
                    rewrite(body, new);
                }
                rewrite(otherwise, new);
            }
            Statement::Run(run) => {
                let run = &mut **run;
                for (read, value) in &mut run.binds {
                    // What it writes stands for itself.
                    let written = run.writes.iter().any(|write| Read::Name(write.name.into()) == *read);
                    if !written {
                        *value = new(value);
                    }
                }
            }
            Statement::Call(_, phase, args) => {
                *phase = new(phase);
                for arg in args {
                    *arg = new(arg);
                }
            }
            Statement::Mark(_) | Statement::Break | Statement::Fence(_) => {}
        }
    }
}

/// An expression with some of its leaves replaced.
pub(super) fn replaced<'m>(expr: &Expr<'m>, leaf: &dyn Fn(&Expr<'m>) -> Option<Expr<'m>>) -> Expr<'m> {
    if let Some(new) = leaf(expr) {
        return new;
    }
    let one = |expr: &Expr<'m>| Box::new(replaced(expr, leaf));
    let list = |parts: &[Expr<'m>]| {
        let mut all = Vec::with_capacity(parts.len());
        for part in parts {
            all.push(replaced(part, leaf));
        }
        all
    };
    match expr {
        Expr::Not(inner) => Expr::Not(one(inner)),
        Expr::All(parts) => Expr::All(list(parts)),
        Expr::Any(parts) => Expr::Any(list(parts)),
        Expr::Compare(comparison, a, b) => Expr::Compare(*comparison, one(a), one(b)),
        Expr::Choose(parts) => {
            Expr::Choose(Box::new([replaced(&parts[0], leaf), replaced(&parts[1], leaf), replaced(&parts[2], leaf)]))
        }
        Expr::Add(a, b) => Expr::Add(one(a), one(b)),
        Expr::Sub(a, b) => Expr::Sub(one(a), one(b)),
        Expr::Since(a, b) => Expr::Since(one(a), one(b)),
        Expr::Period(a, b, period) => Expr::Period(one(a), one(b), *period),
        Expr::User(user) => {
            let mut binds = Vec::with_capacity(user.binds.len());
            for (read, value) in &user.binds {
                binds.push((*read, replaced(value, leaf)));
            }
            Expr::User(Box::new(User { tokens: user.tokens, tree: user.tree, binds }))
        }
        other => other.clone(),
    }
}

/// Drops such statements, wherever they stand.
pub(super) fn remove(statements: &mut Vec<Statement<'_>>, is_such: &dyn Fn(&Statement<'_>) -> bool) {
    statements.retain_mut(|one| {
        for block in blocks_mut(one) {
            remove(block, is_such);
        }
        !is_such(one)
    });
}

/// Nothing sets a place any more.
pub(super) fn unset(statements: &mut Vec<Statement<'_>>, place: PlaceId) {
    remove(statements, &|one| matches!(one, Statement::Set(set, _) if *set == place));
}

/// One place in place of another.
pub(super) fn rename<'m>(statements: &mut [Statement<'m>], from: PlaceId, to: PlaceId) {
    let leaf = |expr: &Expr<'m>| match expr {
        Expr::Place(place) if *place == from => Some(Expr::Place(to)),
        Expr::Is(place, steps) if *place == from => Some(Expr::Is(to, steps.clone())),
        Expr::Table(place, table) if *place == from => Some(Expr::Table(to, table.clone())),
        _ => None,
    };
    rewrite(statements, &mut |expr| replaced(expr, &leaf));
    targets(statements, from, to);
}

fn targets(statements: &mut [Statement<'_>], from: PlaceId, to: PlaceId) {
    for statement in statements {
        match statement {
            Statement::Set(place, _) | Statement::Match(place, ..) if *place == from => *place = to,
            _ => {}
        }
        for block in blocks_mut(statement) {
            targets(block, from, to);
        }
    }
}

/// The blocks within a statement.
pub(super) fn blocks_mut<'s, 'm>(statement: &'s mut Statement<'m>) -> Vec<&'s mut Vec<Statement<'m>>> {
    match statement {
        Statement::Part(_, body) | Statement::Loop { body, .. } => vec![body],
        Statement::If(_, then, otherwise) => vec![then, otherwise],
        Statement::Match(_, arms, otherwise) => {
            let mut all: Vec<&mut Vec<Statement<'m>>> = Vec::with_capacity(arms.len() + 1);
            for (_, body) in arms {
                all.push(body);
            }
            all.push(otherwise);
            all
        }
        _ => Vec::new(),
    }
}
