//! What expressions and statements read and write: what all passes ask, and who prints a program.

use super::{Expr, PlaceId, Statement};

/// Each expression that an expression is made of.
pub(crate) fn each_part<'s, 'm>(expr: &'s Expr<'m>, each: &mut dyn FnMut(&'s Expr<'m>)) {
    match expr {
        Expr::Value(_)
        | Expr::Place(_)
        | Expr::Initial(_)
        | Expr::Input(_)
        | Expr::Now
        | Expr::Is(..)
        | Expr::Table(..)
        | Expr::Next(_) => {}
        Expr::Not(inner) => each(inner),
        Expr::All(parts) | Expr::Any(parts) => {
            for part in parts {
                each(part);
            }
        }
        Expr::Compare(_, a, b) | Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) | Expr::Period(a, b, _) => {
            each(a);
            each(b);
        }
        Expr::Choose(parts) => {
            for part in &**parts {
                each(part);
            }
        }
        Expr::User(user) => {
            for (_, value) in &user.binds {
                each(value);
            }
        }
    }
}

/// Every place that an expression reads.
pub(crate) fn each_read(expr: &Expr<'_>, each: &mut dyn FnMut(PlaceId)) {
    if let Expr::Place(place) | Expr::Is(place, _) | Expr::Table(place, _) | Expr::Next(place) = expr {
        each(*place);
    }
    each_part(expr, &mut |part| each_read(part, each));
}

/// Whether an expression reads a place.
pub(crate) fn mentions(expr: &Expr<'_>, place: PlaceId) -> bool {
    let mut found = false;
    each_read(expr, &mut |read| found |= read == place);
    found
}

/// What is counted in each statement itself, of all of them.
pub(crate) fn sum(statements: &[Statement<'_>], own: &dyn Fn(&Statement<'_>) -> usize) -> usize {
    let mut all = 0;
    for statement in statements {
        all += own(statement);
        each_block(statement, &mut |block| all += sum(block, own));
    }
    all
}

/// Each expression that a statement has itself, without the blocks within it.
pub(crate) fn each_expr<'s, 'm>(statement: &'s Statement<'m>, each: &mut dyn FnMut(&'s Expr<'m>)) {
    match statement {
        Statement::Set(_, value) => each(value),
        Statement::If(condition, ..) => each(condition),
        Statement::Run(run) => {
            for (_, value) in &run.binds {
                each(value);
            }
        }
        Statement::Call(_, phase, args) => {
            each(phase);
            for arg in args {
                each(arg);
            }
        }
        Statement::Part(..)
        | Statement::Match(..)
        | Statement::Loop { .. }
        | Statement::Break
        | Statement::Mark(_)
        | Statement::Fence(_) => {}
    }
}

/// Each block within a statement, in the order of the text.
pub(crate) fn each_block<'s, 'm>(statement: &'s Statement<'m>, each: &mut dyn FnMut(&'s [Statement<'m>])) {
    match statement {
        Statement::Part(_, body) | Statement::Loop { body, .. } => each(body),
        Statement::If(_, then, otherwise) => {
            each(then);
            each(otherwise);
        }
        Statement::Match(_, arms, otherwise) => {
            for (_, body) in arms {
                each(body);
            }
            each(otherwise);
        }
        _ => {}
    }
}

/// Every place that a statement reads itself, without the blocks within it.
pub(crate) fn each_own_asked(statement: &Statement<'_>, each: &mut dyn FnMut(PlaceId)) {
    if let Statement::Match(place, ..) = statement {
        each(*place);
    }
    each_expr(statement, &mut |expr| each_read(expr, each));
    if let Statement::Run(_) = statement {
        // It may leave it as it is.
        each_own_written(statement, each);
    }
}

/// Every place that a statement writes itself, without the blocks within it.
pub(crate) fn each_own_written(statement: &Statement<'_>, each: &mut dyn FnMut(PlaceId)) {
    match statement {
        Statement::Set(place, _) => each(*place),
        Statement::Run(run) => {
            for write in &run.writes {
                each(write.to);
                write.noted.into_iter().for_each(&mut *each);
            }
        }
        _ => {}
    }
}

/// Every place that statements read, wherever they read it.
pub(crate) fn each_asked(statements: &[Statement<'_>], each: &mut dyn FnMut(PlaceId)) {
    for statement in statements {
        each_own_asked(statement, each);
        each_block(statement, &mut |block| each_asked(block, each));
    }
}

/// Every place that statements write, on whatever way.
pub(crate) fn each_written(statements: &[Statement<'_>], each: &mut dyn FnMut(PlaceId)) {
    for statement in statements {
        each_own_written(statement, each);
        each_block(statement, &mut |block| each_written(block, each));
    }
}

/// Whether statements read a place.
pub(crate) fn is_read_in(statements: &[Statement<'_>], place: PlaceId) -> bool {
    let mut found = false;
    each_asked(statements, &mut |read| found |= read == place);
    found
}

/// Whether statements write a place.
pub(crate) fn is_written_in(statements: &[Statement<'_>], place: PlaceId) -> bool {
    let mut found = false;
    each_written(statements, &mut |written| found |= written == place);
    found
}

/// Whether a statement writes a place.
pub(crate) fn writes_to(statement: &Statement<'_>, place: PlaceId) -> bool {
    is_written_in(std::slice::from_ref(statement), place)
}

/// Whether a statement reads a place.
pub(crate) fn reads_from(statement: &Statement<'_>, place: PlaceId) -> bool {
    is_read_in(std::slice::from_ref(statement), place)
}
