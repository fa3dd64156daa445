//! What statements do to each other, and whether two of them are the same: what all passes ask.

use super::super::{Arm, Expr, PlaceId, Statement, User, Write};
use crate::sorted::Set;

pub(super) use super::super::uses::{
    each_asked, each_read, each_written, is_read_in, is_written_in, mentions, reads_from, sum, writes_to,
};

/// Whether it can be asked once more, once less or at another time: no call in it answers differently each time.
pub(super) fn is_pure(expr: &Expr<'_>) -> bool {
    match expr {
        Expr::Value(_)
        | Expr::Initial(_)
        | Expr::Input(_)
        | Expr::Now
        | Expr::Place(_)
        | Expr::Is(..)
        | Expr::Table(..)
        | Expr::Next(_) => true,
        Expr::Not(inner) => is_pure(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().all(is_pure),
        Expr::Compare(_, a, b) | Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) | Expr::Period(a, b, _) => {
            is_pure(a) && is_pure(b)
        }
        Expr::Choose(parts) => parts.iter().all(is_pure),
        Expr::User(user) => !user.tree.may_differ() && user.binds.iter().all(|(_, value)| is_pure(value)),
    }
}

/// Whether nothing of the user's is in it, which could panic.
pub(super) fn is_plain(expr: &Expr<'_>) -> bool {
    match expr {
        Expr::User(_) => false,
        Expr::Not(inner) => is_plain(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().all(is_plain),
        Expr::Compare(_, a, b) | Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) | Expr::Period(a, b, _) => {
            is_plain(a) && is_plain(b)
        }
        Expr::Choose(parts) => parts.iter().all(is_plain),
        _ => true,
    }
}

/// Whether its evaluation may panic.
pub(super) fn may_panic(expr: &Expr<'_>) -> bool {
    match expr {
        Expr::User(user) => user.tree.may_panic() || user.binds.iter().any(|(_, value)| may_panic(value)),
        Expr::Not(inner) => may_panic(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().any(may_panic),
        Expr::Compare(_, a, b) => may_panic(a) || may_panic(b),
        other => !is_plain(other),
    }
}

/// Whether a statement may end the block it stands in. A loop takes in what leaves it.
pub(super) fn leaves(statement: &Statement<'_>) -> bool {
    match statement {
        Statement::Break => true,
        Statement::Part(_, body) => body.iter().any(leaves),
        Statement::If(_, then, otherwise) => then.iter().chain(otherwise).any(leaves),
        Statement::Match(_, arms, otherwise) => {
            arms.iter().any(|(_, body)| body.iter().any(leaves)) || otherwise.iter().any(leaves)
        }
        _ => false,
    }
}

/// Whether a statement tells somebody outside something, or asks somebody who may answer differently each time.
fn is_outside(statement: &Statement<'_>) -> bool {
    match statement {
        Statement::Part(_, body) | Statement::Loop { body, .. } => body.iter().any(is_outside),
        Statement::Set(_, value) => !is_pure(value),
        Statement::If(condition, then, otherwise) => {
            !is_pure(condition) || then.iter().chain(otherwise).any(is_outside)
        }
        Statement::Match(_, arms, otherwise) => {
            arms.iter().any(|(_, body)| body.iter().any(is_outside)) || otherwise.iter().any(is_outside)
        }
        Statement::Run(run) => run.code.statements.is_none() || run.binds.iter().any(|(_, value)| !is_pure(value)),
        Statement::Call(..) | Statement::Mark(_) | Statement::Fence(_) => true,
        Statement::Break => false,
    }
}

/// What a statement does to the rest.
#[derive(Default)]
pub(super) struct Effects {
    pub(super) reads: Set<PlaceId>,
    pub(super) writes: Set<PlaceId>,
    /// It tells somebody outside something, or asks somebody who may answer differently each time.
    pub(super) outside: bool,
    /// It may end the block it stands in.
    pub(super) leaves: bool,
}

impl Effects {
    pub(super) fn of(statement: &Statement<'_>) -> Self {
        let mut effects = Self::default();
        effects.add(statement);
        effects
    }

    pub(super) fn of_all(statements: &[Statement<'_>]) -> Self {
        let mut effects = Self::default();
        effects.add_all(statements);
        effects
    }

    pub(super) fn add_all(&mut self, statements: &[Statement<'_>]) {
        for statement in statements {
            self.add(statement);
        }
    }

    pub(super) fn add(&mut self, statement: &Statement<'_>) {
        let one = std::slice::from_ref(statement);
        each_asked(one, &mut |place| _ = self.reads.insert(place));
        each_written(one, &mut |place| _ = self.writes.insert(place));
        self.outside |= is_outside(statement);
        self.leaves |= leaves(statement);
    }

    /// What another statement does, too.
    pub(super) fn join(&mut self, other: &Self) {
        self.reads.extend(other.reads.iter().copied());
        self.writes.extend(other.writes.iter().copied());
        self.outside |= other.outside;
        self.leaves |= other.leaves;
    }

    /// Whether two statements that follow each other may change places.
    pub(super) fn may_swap(&self, other: &Self) -> bool {
        !(self.leaves || other.leaves || self.outside && other.outside)
            && self.writes.is_disjoint(&other.writes)
            && self.writes.is_disjoint(&other.reads)
            && self.reads.is_disjoint(&other.writes)
    }
}

/// Statements that are wanted first, if nothing that stays behind is in their way, and the rest.
#[allow(clippy::type_complexity, reason = "two lists")]
pub(super) fn first_of<'m>(
    list: &[Statement<'m>],
    is_wanted: &dyn Fn(usize, &Statement<'m>) -> bool,
) -> (Vec<Statement<'m>>, Vec<Statement<'m>>) {
    let (mut first, mut rest, mut passed) = (Vec::new(), Vec::new(), Effects::default());
    for (at, statement) in list.iter().enumerate() {
        let effects = Effects::of(statement);
        if is_wanted(at, statement) && effects.may_swap(&passed) {
            first.push(statement.clone());
        } else {
            passed.join(&effects);
            rest.push(statement.clone());
        }
    }
    (first, rest)
}

/// Whether two expressions have the same value at the same moment, and can stand for each other in what is printed.
pub(super) fn same(a: &Expr<'_>, b: &Expr<'_>) -> bool {
    match (a, b) {
        (Expr::Value(a), Expr::Value(b)) => a == b,
        (Expr::Place(a), Expr::Place(b)) | (Expr::Initial(a), Expr::Initial(b)) | (Expr::Next(a), Expr::Next(b)) => {
            a == b
        }
        (Expr::Input(a), Expr::Input(b)) => a == b,
        (Expr::Now, Expr::Now) => true,
        (Expr::Table(a, table), Expr::Table(b, other)) => a == b && table == other,
        (Expr::Is(a, steps), Expr::Is(b, others)) => a == b && steps == others,
        (Expr::Not(a), Expr::Not(b)) => same(a, b),
        (Expr::All(a), Expr::All(b)) | (Expr::Any(a), Expr::Any(b)) => all_same(a, b),
        (Expr::Compare(one, a, b), Expr::Compare(other, c, d)) => one == other && same(a, c) && same(b, d),
        (Expr::Add(a, b), Expr::Add(c, d))
        | (Expr::Sub(a, b), Expr::Sub(c, d))
        | (Expr::Since(a, b), Expr::Since(c, d)) => same(a, c) && same(b, d),
        (Expr::Period(a, b, one), Expr::Period(c, d, other)) => one == other && same(a, c) && same(b, d),
        (Expr::Choose(a), Expr::Choose(b)) => all_same(&**a, &**b),
        (Expr::User(a), Expr::User(b)) => same_user(a, b),
        _ => false,
    }
}

fn all_same(a: &[Expr<'_>], b: &[Expr<'_>]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
}

fn same_user(a: &User<'_>, b: &User<'_>) -> bool {
    let bound = || a.binds.iter().zip(&b.binds).all(|((one, a), (other, b))| one == other && same(a, b));
    (std::ptr::eq(a.tree, b.tree) || a.tree == b.tree) && a.binds.len() == b.binds.len() && bound()
}

/// Whether two statements do the same.
pub(super) fn same_statement(a: &Statement<'_>, b: &Statement<'_>) -> bool {
    match (a, b) {
        (Statement::Part(_, a), Statement::Part(_, b)) => same_block(a, b),
        (Statement::Set(a, value), Statement::Set(b, other)) => a == b && same(value, other),
        (Statement::If(condition, then, otherwise), Statement::If(same_condition, same_then, same_otherwise)) => {
            same(condition, same_condition) && same_block(then, same_then) && same_block(otherwise, same_otherwise)
        }
        (Statement::Match(a, arms, rest), Statement::Match(b, others, other)) => {
            let arm = |((values, a), (others, b)): (&Arm<'_>, &Arm<'_>)| values == others && same_block(a, b);
            a == b && arms.len() == others.len() && arms.iter().zip(others).all(arm) && same_block(rest, other)
        }
        (Statement::Loop { rounds: a, body }, Statement::Loop { rounds: b, body: other }) => {
            a == b && same_block(body, other)
        }
        (Statement::Break, Statement::Break) => true,
        (Statement::Fence(a), Statement::Fence(b)) => a == b,
        (Statement::Run(a), Statement::Run(b)) => {
            let write = |(a, b): (&Write, &Write)| (a.name, a.to, a.noted) == (b.name, b.to, b.noted);
            let bound = || a.binds.iter().zip(&b.binds).all(|((one, a), (other, b))| one == other && same(a, b));
            std::ptr::eq(a.code, b.code)
                && a.binds.len() == b.binds.len()
                && a.writes.len() == b.writes.len()
                && a.writes.iter().zip(&b.writes).all(write)
                && bound()
        }
        (Statement::Call(a, phase, args), Statement::Call(b, other, others)) => {
            a == b && same(phase, other) && all_same(args, others)
        }
        (Statement::Mark(a), Statement::Mark(b)) => a == b,
        _ => false,
    }
}

pub(super) fn same_block(a: &[Statement<'_>], b: &[Statement<'_>]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same_statement(a, b))
}

/// Whether there is such a statement, wherever it stands.
pub(super) fn has(statements: &[Statement<'_>], is_such: &dyn Fn(&Statement<'_>) -> bool) -> bool {
    statements.iter().any(|one| is_such(one) || blocks(one).into_iter().any(|block| has(block, is_such)))
}

/// The blocks within a statement.
pub(super) fn blocks<'s, 'm>(statement: &'s Statement<'m>) -> Vec<&'s Vec<Statement<'m>>> {
    match statement {
        Statement::Part(_, body) | Statement::Loop { body, .. } => vec![body],
        Statement::If(_, then, otherwise) => vec![then, otherwise],
        Statement::Match(_, arms, otherwise) => {
            let mut all: Vec<&Vec<Statement<'m>>> = vec![otherwise];
            for (_, body) in arms {
                all.push(body);
            }
            all
        }
        _ => Vec::new(),
    }
}
