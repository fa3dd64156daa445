//! Of several regions, a stored value that changes only where something moves is not compared, and in a search has no next value beside it.
//!
//! ```text
//! loop                                               loop
//!   moves = false                                      moves = false
//!   next.clamp = clamp                                 match state
//!   match state                                          Feed:
//!     Feed:                                                if part:
//!       if part:                               ->            state = Close
//!         state = Close                                      clamp = true
//!         next.clamp = true                                  moves = true
//!         moves = true                                 if !moves: break
//!   moves = moves || clamp != next.clamp
//!   clamp = next.clamp
//!   if !moves: break
//! ```
//!
//! Needs: each way that sets the next value, or without a search the value itself, tells that something moves. For the second, nothing reads the value in the round before it
//! takes place, and nothing leaves the round.

use super::super::{Comparison, Expr, PlaceId, PlaceInfo, Program, Statement, Value};
use super::edits::{blocks_mut, rename};
use super::uses::{Effects, is_written_in, writes_to};
use crate::list::List;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 {
        return;
    }
    unasked(&mut program.cycle, &mut Vec::new());
    for at in 0..program.cycle.len() {
        if !matches!(program.cycle[at], Statement::Loop { .. }) {
            continue;
        }
        let after = Effects::of_all(&program.cycle[at + 1..]);
        let Statement::Loop { body, .. } = &mut program.cycle[at] else { continue };
        in_place(&program.places, body, &after);
    }
}

/// Does not ask for changes that tell no more than is known, in whichever block that is done. `same` are places that hold the same in front of it.
fn unasked(block: &mut Vec<Statement<'_>>, same: &mut Vec<(PlaceId, PlaceId)>) {
    let begins = same.clone();
    for statement in block.iter_mut() {
        let is_loop = matches!(statement, Statement::Loop { .. });
        for inner in blocks_mut(statement) {
            unasked(inner, &mut if is_loop { Vec::new() } else { same.clone() });
        }
        let writes = Effects::of(statement).writes;
        same.retain(|(one, other)| !writes.contains(one) && !writes.contains(other));
        if let Statement::Set(to, Expr::Place(from)) = statement {
            same.push((*to, *from));
        }
    }
    let mut at = 0;
    while at < block.len() {
        let told = gathers(&block[at]).map(|(moves, parts)| {
            let told = |part: &Expr<'_>| match part {
                Expr::Compare(Comparison::Differs, a, b) => match (&**a, &**b) {
                    (Expr::Place(a), Expr::Place(b)) => {
                        let begins = begins.contains(&(*a, *b)) || begins.contains(&(*b, *a));
                        [(*a, *b), (*b, *a)].iter().any(|places| is_told(&block[..at], begins, moves, *places))
                    }
                    _ => false,
                },
                _ => false,
            };
            parts.iter().map(told).list()
        });
        if let (Some(told), Statement::Set(_, Expr::Any(parts))) = (told, &mut block[at]) {
            let mut told = std::iter::once(false).chain(told);
            parts.retain(|_| !told.next().unwrap_or_default());
            if parts.len() < 2 {
                block.remove(at);
                continue;
            }
        }
        at += 1;
    }
}

/// Whether two places have been made the same, here or (`begins`) in front of all this, only the first has been written since, and each way on which it was says that something moves.
fn is_told(front: &[Statement<'_>], begins: bool, moves: PlaceId, (value, kept): (PlaceId, PlaceId)) -> bool {
    let same = |one: &Statement<'_>| is_copy(one, kept, value) || is_copy(one, value, kept);
    let rest = match front.iter().rposition(same) {
        Some(copy) => &front[copy + 1..],
        None if begins => front,
        None => return false,
    };
    !is_written_in(rest, kept)
        && each_way(rest, vec![ChangeTold::default()], moves, value)
            .is_some_and(|ways| ways.iter().all(|way| way.says || !way.changes))
}

/// What has been done up to here on a way.
#[derive(Clone, Copy, Default, PartialEq)]
struct ChangeTold {
    changes: bool,
    says: bool,
}

/// What the ways through statements do. None, where one leaves them.
fn each_way(
    statements: &[Statement<'_>],
    mut all: Vec<ChangeTold>,
    moves: PlaceId,
    value: PlaceId,
) -> Option<Vec<ChangeTold>> {
    for statement in statements {
        let mut after = Vec::new();
        match statement {
            Statement::Set(place, set) => {
                let adds = gathers(statement).is_some();
                for way in &mut all {
                    way.changes |= *place == value;
                    if *place == moves {
                        way.says = matches!(set, Expr::Value(Value::Bool(true))) || adds && way.says;
                    }
                }
                after = all;
            }
            Statement::Part(_, body) => after = each_way(body, all, moves, value)?,
            Statement::If(_, then, otherwise) => {
                after = each_way(then, all.clone(), moves, value)?;
                after.extend(each_way(otherwise, all, moves, value)?);
            }
            Statement::Match(_, arms, otherwise) => {
                for (_, body) in arms {
                    after.extend(each_way(body, all.clone(), moves, value)?);
                }
                after.extend(each_way(otherwise, all, moves, value)?);
            }
            Statement::Loop { .. } | Statement::Break => return None,
            other => {
                for way in &mut all {
                    way.changes |= writes_to(other, value);
                    way.says &= !writes_to(other, moves);
                }
                after = all;
            }
        }
        all = Vec::new();
        for way in after {
            if !all.contains(&way) {
                all.push(way);
            }
        }
    }
    Some(all)
}

/// `moves = moves || …`
fn gathers<'s, 'm>(statement: &'s Statement<'m>) -> Option<(PlaceId, &'s [Expr<'m>])> {
    let Statement::Set(moves, Expr::Any(parts)) = statement else { return None };
    match parts.split_first() {
        Some((Expr::Place(first), rest)) if first == moves => Some((*moves, rest)),
        _ => None,
    }
}

fn is_copy(statement: &Statement<'_>, to: PlaceId, from: PlaceId) -> bool {
    matches!(statement, Statement::Set(place, Expr::Place(of)) if *place == to && *of == from)
}

/// Sets values where their next ones are set.
fn in_place(places: &[PlaceInfo<'_>], body: &mut Vec<Statement<'_>>, after: &Effects) {
    let mut at = 0;
    while at < body.len() {
        if let Some((next, value, end)) = copied(places, body, at, after) {
            body.remove(end);
            body.remove(at);
            rename(&mut body[at..end - 1], next, value);
        } else {
            at += 1;
        }
    }
}

/// The next value, the value and where this becomes that, if a statement makes the next one a copy and nobody reads either before then.
fn copied(
    places: &[PlaceInfo<'_>],
    body: &[Statement<'_>],
    at: usize,
    after: &Effects,
) -> Option<(PlaceId, PlaceId, usize)> {
    let Statement::Set(next, Expr::Place(value)) = body[at] else { return None };
    let end = body.iter().rposition(|one| is_copy(one, value, next)).filter(|end| *end > at)?;
    let (between, mut rest) = (Effects::of_all(&body[at + 1..end]), Effects::of_all(&body[..at]));
    rest.add_all(&body[end + 1..]);
    let used = |effects: &Effects| effects.reads.contains(&next) || effects.writes.contains(&next);
    let reads = between.reads.contains(&next) || between.reads.contains(&value) || between.writes.contains(&value);
    let is_next = !places[next.0].is_field && matches!(places[next.0].ty, ref ty if same_type(ty, &places[value.0].ty));
    (is_next && !reads && !between.leaves && !used(&rest) && !used(after)).then_some((next, value, end))
}

fn same_type(a: &super::super::Type<'_>, b: &super::super::Type<'_>) -> bool {
    use super::super::Type::{Bool, Number, Ticks, User};
    match (a, b) {
        (Bool, Bool) | (Ticks, Ticks) | (Number, Number) => true,
        (User(a), User(b)) => std::ptr::eq(*a, *b),
        _ => false,
    }
}
