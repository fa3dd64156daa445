//! What statements and expressions read and write.

use super::parser::{Expr, Label, Statement};
use super::source::same;

/// The names in an expression; of `a.b` both `a` and `a.b`.
pub(super) fn names(expr: &Expr, found: &mut Vec<String>) {
    match expr {
        Expr::Name(name) | Expr::Bit(name, _) => found.push(name.clone()),
        Expr::Member(of, member) => found.extend([of.clone(), format!("{of}.{member}")]),
        Expr::Call(_, arguments) => arguments.iter().for_each(|(_, value)| names(value, found)),
        Expr::Not(inner) | Expr::Minus(inner) => names(inner, found),
        Expr::Binary(_, a, b) => {
            names(a, found);
            names(b, found);
        }
        Expr::Bool(_) | Expr::Int(_) | Expr::Real(_) | Expr::Time(_) | Expr::Typed(..) => {}
    }
}

/// The expressions of a statement, without those of the bodies in it.
pub(super) fn expressions(statement: &Statement) -> Vec<&Expr> {
    match statement {
        Statement::Assign(_, value) => vec![value],
        Statement::Call(_, arguments) => arguments.iter().map(|(_, value)| value).collect(),
        Statement::If(branches, _) => branches.iter().map(|(condition, _)| condition).collect(),
        Statement::Case(of, arms, _) => {
            let labels = arms.iter().flat_map(|arm| &arm.labels).flat_map(|label| match label {
                Label::One(one) => vec![one],
                Label::Range(from, to) => vec![from, to],
            });
            [of].into_iter().chain(labels).collect()
        }
        Statement::For(_, [from, to], by, _) => [from, to].into_iter().chain(by).collect(),
        Statement::While(condition, _) | Statement::Repeat(_, condition) => vec![condition],
        Statement::Exit | Statement::Continue => Vec::new(),
    }
}

/// How often a name is read or written, with all that is in the statement.
pub(super) fn count(statement: &Statement, name: &str) -> usize {
    let written = match statement {
        Statement::Assign(target, _) | Statement::For(target, ..) => usize::from(same(target, name)),
        _ => 0,
    };
    let inner = statement.bodies().into_iter().flatten().map(|one| count(one, name)).sum::<usize>();
    written + inner + expressions(statement).into_iter().map(|expr| reads(expr, name)).sum::<usize>()
}

pub(super) fn reads(expr: &Expr, name: &str) -> usize {
    let mut found = Vec::new();
    names(expr, &mut found);
    found.iter().filter(|other| same(other, name)).count()
}

/// All statements, with those in them.
pub(super) fn each<'s>(body: &'s [Statement], see: &mut dyn FnMut(&'s Statement)) {
    for statement in body {
        see(statement);
        for inner in statement.bodies() {
            each(inner, see);
        }
    }
}
