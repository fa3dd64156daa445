//! A local that is set and then read is replaced by what it was set from.
//!
//! ```text
//! on.On.0 = hot               lamp = hot
//! q.lamp = on.On.0      ->
//! lamp = q.lamp
//! ```
//!
//! A truth that nothing sets is what it begins with. Needs, for all others: it is read once after it, or costs nothing; nothing in between writes what it reads; it can be asked later as well. What is
//! then not read any more falls to `dead`.

use super::super::{Expr, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::dead::is_seen;
use super::edits::{replaced, rewrite};
use super::fold::{Known, initial};
use super::uses::{Effects, blocks, each_read, is_pure};

pub(super) fn pass(program: &mut Program<'_>) {
    initials(program);
    let closed = closed(program);
    block(&closed, &mut program.cycle);
}

/// A truth of the cycle that nothing sets any more is what it begins with, and so is the state of a region of one step that is always active.
fn initials(program: &mut Program<'_>) {
    let is_state = |info: &PlaceInfo<'_>| matches!(info.ty, Type::State(_));
    let written = Effects::of_all(&program.cycle).writes;
    rewritten(program, &|program, place| {
        let info = &program.places[place.0];
        let is_local = !info.is_field && !is_seen(info) && matches!(info.ty, Type::Bool);
        let is_fixed = program.forced.is_none() && is_state(info) && matches!(info.role, Role::State(_));
        initial(info).filter(|_| (is_local || is_fixed) && !written.contains(&place))
    });
    // What is nothing but a copy of it.
    rewritten(program, &|program, place| {
        let info = &program.places[place.0];
        let value = initial(info).filter(|_| !info.is_field && is_state(info))?;
        sets_only(&program.cycle, place, value).then_some(value)
    });
}

/// Places replaced by the values that they hold throughout.
fn rewritten<'m>(program: &mut Program<'m>, value: &dyn Fn(&Program<'m>, PlaceId) -> Option<Value>) {
    let mut held = Vec::with_capacity(program.places.len());
    for at in 0..program.places.len() {
        held.push(value(program, PlaceId(at)));
    }
    if held.iter().all(Option::is_none) {
        return;
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    let value = |place: PlaceId| held[place.0];
    let known = Known { places: &program.places, value: &value, copy: &|_| None, among: &|_| None, now: &|_| false };
    rewrite(&mut cycle, &mut |expr| known.fold(expr));
    program.cycle = cycle;
}

/// Whether a place is set to this value wherever it is set.
fn sets_only(statements: &[Statement<'_>], place: PlaceId, value: Value) -> bool {
    statements.iter().all(|statement| match statement {
        Statement::Set(to, set) if *to == place => matches!(set, Expr::Value(set) if *set == value),
        other => blocks(other).into_iter().all(|block| sets_only(block, place, value)),
    })
}

/// By place: a local, and all that reads it stands after a statement that has set it in the same cycle.
fn closed(program: &Program<'_>) -> Vec<bool> {
    let mut closed: Vec<bool> = program.places.iter().map(|place| !place.is_field && !is_seen(place)).collect();
    let mut set = vec![false; program.places.len()];
    walk(&program.cycle, &mut set, &mut closed);
    closed
}

fn walk(statements: &[Statement<'_>], set: &mut [bool], closed: &mut [bool]) {
    let mut here = Vec::new();
    for statement in statements {
        match statement {
            Statement::Part(_, body) => walk(body, set, closed),
            Statement::Set(place, value) => {
                each_read(value, &mut |read| closed[read.0] &= set[read.0]);
                if !std::mem::replace(&mut set[place.0], true) {
                    here.push(*place);
                }
            }
            Statement::If(condition, then, otherwise) => {
                each_read(condition, &mut |read| closed[read.0] &= set[read.0]);
                walk(then, set, closed);
                walk(otherwise, set, closed);
            }
            Statement::Match(place, arms, otherwise) => {
                closed[place.0] &= set[place.0];
                for (_, body) in arms {
                    walk(body, set, closed);
                }
                walk(otherwise, set, closed);
            }
            other => {
                let effects = Effects::of(other);
                for place in effects.reads.iter().chain(effects.writes.iter()) {
                    closed[place.0] &= set[place.0] && !effects.writes.contains(place);
                }
            }
        }
    }
    for place in here {
        set[place.0] = false;
    }
}

fn block(closed: &[bool], statements: &mut [Statement<'_>]) {
    // What statements do is told once for all that is carried past them.
    let mut effects = Vec::with_capacity(statements.len());
    for statement in &*statements {
        effects.push(Effects::of(statement));
    }
    for at in 0..statements.len() {
        match &mut statements[at] {
            Statement::Part(_, body) | Statement::Loop { body, .. } => block(closed, body),
            Statement::If(_, then, otherwise) => {
                block(closed, then);
                block(closed, otherwise);
            }
            Statement::Match(_, arms, otherwise) => {
                for (_, body) in arms {
                    block(closed, body);
                }
                block(closed, otherwise);
            }
            _ => {}
        }
        let (done, rest) = statements.split_at_mut(at + 1);
        if let Some(Statement::Set(place, value)) = done.last() {
            if closed[place.0] && is_pure(value) {
                carry(*place, value, rest, &mut effects[at + 1..]);
            }
        }
    }
}

/// Puts the value where the place is read, if that is possible everywhere up to the next time it is set.
fn carry<'m>(place: PlaceId, value: &Expr<'m>, rest: &mut [Statement<'m>], effects: &mut [Effects]) {
    let mut operands = Vec::new();
    each_read(value, &mut |read| operands.push(read));
    if operands.contains(&place) {
        return;
    }
    let is_cheap = matches!(value, Expr::Place(_) | Expr::Value(_) | Expr::Input(_) | Expr::Now);
    let (mut count, mut last, mut clean) = (0, 0, true);
    for (at, (statement, effects)) in rest.iter().zip(&*effects).enumerate() {
        let is_written = effects.writes.contains(&place);
        let writes = is_written || operands.iter().any(|operand| effects.writes.contains(operand));
        if effects.reads.contains(&place) {
            let Some(here) = occurrences(place, statement) else { return };
            // What it was set from is gone, or it is written where it is read.
            if here > 0 && (!clean || writes && !matches!(statement, Statement::Set(..))) {
                return;
            }
            count += here;
            if count > 1 && !is_cheap {
                return;
            }
            last = if here > 0 { at + 1 } else { last };
        }
        if is_written {
            if !matches!(statement, Statement::Set(..)) {
                return;
            }
            break;
        }
        clean &= !writes;
    }
    if count == 1 || is_cheap {
        let new = |expr: &Expr<'m>| {
            replaced(expr, &|leaf| match (leaf, value) {
                (Expr::Place(read), _) if *read == place => Some(value.clone()),
                (Expr::Is(read, steps), Expr::Place(other)) if *read == place => Some(Expr::Is(*other, steps.clone())),
                _ => None,
            })
        };
        for (statement, effects) in rest[..last].iter_mut().zip(effects) {
            if effects.reads.contains(&place) {
                rewrite(std::slice::from_mut(statement), &mut |expr| new(expr));
                *effects = Effects::of(statement);
            }
        }
    }
}

/// How often a place is read where an expression can stand for it; `None` where one cannot.
fn occurrences(place: PlaceId, statement: &Statement<'_>) -> Option<usize> {
    match statement {
        Statement::Part(_, body) => all_occurrences(place, body),
        Statement::Set(_, value) => in_expr(place, value),
        Statement::If(condition, then, otherwise) => {
            Some(in_expr(place, condition)? + all_occurrences(place, then)? + all_occurrences(place, otherwise)?)
        }
        Statement::Match(on, arms, otherwise) => {
            let mut sum = all_occurrences(place, otherwise)?;
            for (_, body) in arms {
                sum += all_occurrences(place, body)?;
            }
            (*on != place).then_some(sum)
        }
        Statement::Call(_, phase, args) => {
            let mut sum = in_expr(place, phase)?;
            for arg in args {
                sum += in_expr(place, arg)?;
            }
            Some(sum)
        }
        // Read again in each round.
        Statement::Loop { body, .. } => Some(2 * all_occurrences(place, body)?),
        other => {
            let effects = Effects::of(other);
            if effects.reads.contains(&place) && effects.writes.contains(&place) {
                return None;
            }
            let Statement::Run(run) = other else { return Some(0) };
            let mut sum = 0;
            for (_, value) in &run.binds {
                sum += in_expr(place, value)?;
            }
            Some(sum)
        }
    }
}

fn all_occurrences(place: PlaceId, statements: &[Statement<'_>]) -> Option<usize> {
    let mut sum = 0;
    for statement in statements {
        sum += occurrences(place, statement)?;
    }
    Some(sum)
}

fn in_expr(place: PlaceId, expr: &Expr<'_>) -> Option<usize> {
    let (mut count, mut whole) = (0, true);
    each_leaf(expr, &mut |leaf| match leaf {
        Expr::Place(read) => count += usize::from(*read == place),
        Expr::Is(read, _) | Expr::Table(read, _) | Expr::Next(read) => whole &= *read != place,
        _ => {}
    });
    whole.then_some(count)
}

fn each_leaf(expr: &Expr<'_>, each: &mut dyn FnMut(&Expr<'_>)) {
    match expr {
        Expr::Not(inner) => each_leaf(inner, each),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().for_each(|part| each_leaf(part, each)),
        Expr::Compare(_, a, b) | Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Since(a, b) | Expr::Period(a, b, _) => {
            each_leaf(a, each);
            each_leaf(b, each);
        }
        Expr::Choose(parts) => parts.iter().for_each(|part| each_leaf(part, each)),
        Expr::User(user) => user.binds.iter().for_each(|(_, value)| each_leaf(value, each)),
        leaf => each(leaf),
    }
}
