//! The time that several arms of a match ask for is known in front of it.
//!
//! ```text
//! match state                                       passed = since(now, since)
//!   Heat:                                           match state
//!     if since(now, since) >= 20s: …      ->          Heat:
//!   Wash:                                               if passed >= 20s: …
//!     if since(now, since) >= 3s: …                   Wash:
//!                                                       if passed >= 3s: …
//! ```
//!
//! So the arms are shorter, by the load and the difference in each; a state without time takes these two instructions more.
//!
//! Needs: no arm asks for the time once it has begun it anew.

use super::super::build::at_least;
use super::super::{Arm, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::edits::{blocks_mut, remove, replaced, rewrite};
use super::uses::{Effects, blocks, is_read_in};
use super::without_empty;

/// From so many arms on it pays.
const ARMS: usize = 2;

/// From so many arms on in which it stands still it does so in front of them.
const BOUNDED: usize = 3;

/// What nothing can be longer than that is compared with a reading of the clock.
const LONGEST: u32 = 1 << 31;

/// From so many in a match that other ways pass by, and where what comes after its arms asks for it, too.
const INNER_ARMS: usize = 4;

pub(super) fn pass(program: &mut Program<'_>) {
    for index in 0..program.places.len() {
        if matches!(program.places[index].role, Role::Began(_)) {
            let (cycle, places) = (&mut program.cycle, &mut program.places);
            within(cycle, places, PlaceId(index));
            one(cycle, places, PlaceId(index), ARMS);
        }
    }
}

/// From the innermost blocks outwards; in a search in front of its matches alone, as it comes to them again and again.
fn within<'m>(block: &mut Vec<Statement<'m>>, places: &mut Vec<PlaceInfo<'m>>, since: PlaceId) {
    for statement in block.iter_mut() {
        if let Statement::Loop { body, .. } = statement {
            one(body, places, since, ARMS);
            continue;
        }
        for inner in blocks_mut(statement) {
            within(inner, places, since);
            one(inner, places, since, INNER_ARMS);
        }
    }
}

fn one<'m>(block: &mut Vec<Statement<'m>>, places: &mut Vec<PlaceInfo<'m>>, since: PlaceId, least: usize) {
    let asks = |statement: &Statement<'_>| match statement {
        Statement::Match(_, arms, otherwise) => {
            let asking = count(arms, since);
            asking >= least && (asking >= INNER_ARMS || !is_read_in(otherwise, since))
        }
        _ => false,
    };
    let Some(at) = block.iter().position(asks) else { return };
    if !asks_first(std::slice::from_ref(&block[at]), since) {
        return;
    }
    let passed = PlaceId(places.len());
    let time = |expr: &Expr<'_>| is_time(expr, since).then_some(Expr::Place(passed));
    let bounded = bounds(&block[at], since);
    for body in blocks_mut(&mut block[at]) {
        rewrite(body, &mut |expr| replaced(expr, &time));
        if bounded >= BOUNDED {
            remove(body, &|one| is_bound(one, since));
            without_empty(body);
        }
    }
    if bounded >= BOUNDED {
        let longest = || Expr::Value(Value::Ticks(LONGEST));
        let back = Statement::Set(since, Expr::Since(Box::new(Expr::Now), Box::new(longest())));
        block.insert(at, Statement::If(at_least(Expr::Place(passed), longest()), vec![back], Vec::new()));
    }
    let since = Expr::Since(Box::new(Expr::Now), Box::new(Expr::Place(since)));
    block.insert(at, Statement::Set(passed, since));
    places.push(PlaceInfo::local("passed".to_owned(), Type::Ticks, Initial::Value(Value::Ticks(0))));
}

/// It stands still at the longest time that a step asks for.
fn is_bound(statement: &Statement<'_>, since: PlaceId) -> bool {
    match statement {
        Statement::Set(place, Expr::Since(now, longest)) => {
            *place == since && matches!((&**now, &**longest), (Expr::Now, Expr::Value(Value::Ticks(_))))
        }
        _ => false,
    }
}

/// In how many places it does.
fn bounds(statement: &Statement<'_>, since: PlaceId) -> usize {
    let mut all = usize::from(is_bound(statement, since));
    for block in blocks(statement) {
        all += block.iter().map(|one| bounds(one, since)).sum::<usize>();
    }
    all
}

fn is_time(expr: &Expr<'_>, since: PlaceId) -> bool {
    match expr {
        Expr::Since(now, began) => {
            matches!((&**now, &**began), (Expr::Now, Expr::Place(place)) if *place == since)
        }
        _ => false,
    }
}

fn count(arms: &[Arm<'_>], since: PlaceId) -> usize {
    arms.iter().filter(|(_, body)| is_read_in(body, since)).count()
}

/// Whether nothing reads a time that some way has written before.
fn asks_first(body: &[Statement<'_>], since: PlaceId) -> bool {
    for (at, statement) in body.iter().enumerate() {
        let effects = Effects::of(statement);
        if effects.writes.contains(&since) && is_read_in(&body[at + 1..], since) {
            return false;
        }
        let inner = match statement {
            Statement::Set(..) => true,
            Statement::If(_, then, otherwise) => asks_first(then, since) && asks_first(otherwise, since),
            Statement::Match(_, arms, otherwise) => {
                arms.iter().all(|(_, body)| asks_first(body, since)) && asks_first(otherwise, since)
            }
            _ => !effects.writes.contains(&since),
        };
        if !inner {
            return false;
        }
    }
    true
}
