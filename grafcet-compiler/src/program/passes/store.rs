//! The ways of a match end in the state after it, which is stored once after all of them.
//!
//! ```text
//! match state                       match state
//!   A:                                A:
//!     if on: state = B                  if on: after = B
//!   B:                        ->        else: after = A
//!     if off: state = A               B:
//!                                       if off: after = A
//!                                       else: after = B
//!                                   state = after
//! ```
//!
//! LLVM chooses between constants then, and goes on from each way to what its state does. Arms that differ in their own state alone are one.
//!
//! Needs: the match stands in no loop, and nothing after it writes the state; the ways do nothing but that. Where they do more they come together after it at a cost
//! (Laundry 792 -> 866 bytes, 24.5 -> 26.7 instructions). Where most states have several ways each of them brings a constant of its own, and the store costs more than it
//! saves: a sequence of 18 steps with watchdogs takes 442 bytes without it and 622 with it. Under `optimize size;` a table of the next states comes first (`next`).

use super::super::{Arm, Expr, PlaceId, PlaceInfo, Program, Role, Statement, Value};
use super::edits::rename;
use super::many::complete;
use super::next;
use super::share::merged;
use super::uses::{Effects, is_written_in, same, sum};

pub(super) fn pass(program: &mut Program<'_>) {
    let Some(at) = program.cycle.iter().position(|statement| writes_state(program, statement)) else { return };
    let mut decides = program.cycle[at].clone();
    let Statement::Match(state, ref arms, _) = decides else { return };
    if is_written_in(&program.cycle[at + 1..], state) || have_several_ways(arms, state) {
        return;
    }
    if program.model.optimize_size && next::applies(program) {
        return;
    }
    // A state from which no way leads may have no arm: what is stored after is the same for it.
    complete(program, state, &mut decides);
    let Statement::Match(_, arms, _) = &mut decides else { return };
    let after = PlaceId(program.places.len());
    let mut ended = Vec::with_capacity(arms.len());
    for (values, body) in arms.iter() {
        let mut body = body.clone();
        if !end(&mut body, state, after) {
            return;
        }
        ended.push((values.clone(), body));
    }
    *arms = merged(ended);
    for arm in arms.iter_mut() {
        own(arm, state, after);
    }
    // Statements after look at the local.
    rename(&mut program.cycle[at + 1..], state, after);
    program.cycle[at] = decides;
    program.cycle.insert(at + 1, Statement::Set(state, Expr::Place(after)));
    let PlaceInfo { ty, initial, .. } = program.places[state.0];
    program.places.push(PlaceInfo::local("after".to_owned(), ty, initial));
}

/// A match on the state of a region that decides which one is next.
pub(super) fn writes_state(program: &Program<'_>, statement: &Statement<'_>) -> bool {
    let Statement::Match(place, arms, otherwise) = statement else { return false };
    let is_state = matches!(program.places[place.0].role, Role::State(_));
    let mut effects = Effects::default();
    for (_, body) in arms {
        effects.add_all(body);
    }
    let complete = otherwise.is_empty() && arms.len() > 1;
    is_state && complete && effects.writes.contains(place) && !effects.reads.contains(place) && !effects.leaves
}

/// Whether all ways through a body could be made to end in the state after it.
fn end(body: &mut Vec<Statement<'_>>, state: PlaceId, after: PlaceId) -> bool {
    match &mut body[..] {
        [] => {
            body.push(Statement::Set(after, Expr::Place(state)));
            true
        }
        [Statement::Set(place, _)] if *place == state => {
            *place = after;
            true
        }
        [Statement::If(_, then, otherwise)] => end(then, state, after) && end(otherwise, state, after),
        _ => false,
    }
}

/// Whether most states have several ways that lead to a state, beside the one that most of them ask for first (`common`).
fn have_several_ways(arms: &[Arm<'_>], state: PlaceId) -> bool {
    let (mut most, mut votes) = (None, 0_usize);
    for condition in arms.iter().filter_map(first_condition) {
        match most {
            Some(one) if same(one, condition) => votes += 1,
            _ if votes > 0 => votes -= 1,
            _ => (most, votes) = (Some(condition), 1),
        }
    }
    let is_several = |arm: &&Arm<'_>| {
        let ways = sum(&arm.1, &|one| usize::from(matches!(one, Statement::Set(place, _) if *place == state)));
        let is_most = most.is_some_and(|most| first_condition(arm).is_some_and(|own| same(own, most)));
        ways > 1 + usize::from(is_most)
    };
    2 * arms.iter().filter(is_several).count() > arms.len()
}

fn first_condition<'a, 'm>((_, body): &'a Arm<'m>) -> Option<&'a Expr<'m>> {
    match body.first() {
        Some(Statement::If(condition, ..)) => Some(condition),
        _ => None,
    }
}

/// In an arm of one state, that state is meant where it stays.
fn own((values, body): &mut Arm<'_>, state: PlaceId, after: PlaceId) {
    let [value @ Value::Step(_)] = values[..] else { return };
    rewrite_sets(body, after, &|expr| matches!(expr, Expr::Place(place) if *place == state).then_some(value));
}

fn rewrite_sets(body: &mut [Statement<'_>], of: PlaceId, new: &dyn Fn(&Expr<'_>) -> Option<Value>) {
    for statement in body {
        match statement {
            Statement::Set(place, value) if *place == of => {
                if let Some(new) = new(value) {
                    *value = Expr::Value(new);
                }
            }
            Statement::If(_, then, otherwise) => {
                rewrite_sets(then, of, new);
                rewrite_sets(otherwise, of, new);
            }
            _ => {}
        }
    }
}
