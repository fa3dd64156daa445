//! What is the same in all states of a sequence, and long: it stands after the match on the state, once, and not in each of its ways.
//!
//! ```text
//! match state                                  match state
//!   A:                                           A:
//!     if a:                                        if a:
//!       state = B                                    state = B
//!       q.log = true                                 q.log = true
//!       if was.q.log: match acted.log …    ->      else: q.log = x
//!     else:                                      …
//!       q.log = x                              if was.q.log: match acted.log …
//!       if was.q.log: match acted.log …
//!   …
//! ```
//!
//! So runs stored actions (S, SD, SL with more than a boolean), and calls that many associations hold up: as many statements as there are such associations, which each way of each
//! state would have. What they leave in fields is not followed from state to state.

use super::super::{Expr, PlaceId, PlaceInfo, Role, Statement, Type};
use super::several::weight;
use super::sparse::Index;
use super::uses::{Effects, blocks, mentions};
use crate::list::List;
use crate::sorted::Set;

/// So many statements at least are worth it,
const LONG: usize = 16;

/// and so many in all states.
const MANY: usize = 150;

/// So many statements of one time are worth to be one.
const SCATTERED: usize = 4;

/// By statement: whether it stands after the match. `runs` tells of which times of actions.
pub(super) fn tail(
    (places, list): (&[PlaceInfo<'_>], &[Statement<'_>]),
    index: &Index,
    points: usize,
    runs: &dyn Fn(PlaceId) -> bool,
) -> Vec<bool> {
    let mut is_tail = vec![false; list.len()];
    let mut length = 0;
    for at in index.always.iter().copied().filter(|at| *at > index.last) {
        if matches!(list[at], Statement::If(..)) && acts(places, &list[at]) {
            is_tail[at] = true;
            length += weight(std::slice::from_ref(&list[at]));
        }
    }
    if length < LONG || length * points < MANY {
        is_tail.fill(false);
    }
    for at in index.always.iter().copied().filter(|at| *at > index.last) {
        is_tail[at] |= runs_on(places, &list[at]).is_some_and(runs);
    }
    if !is_tail.contains(&true) {
        return is_tail;
    }
    let effects = list.iter().map(Effects::of).list();
    let mut passed = Effects::default();
    for at in 0..list.len() {
        is_tail[at] |= at > index.last && !effects[at].may_swap(&passed);
        if is_tail[at] {
            passed.join(&effects[at]);
        }
    }
    // What only they ask for is found there.
    let (mut kept, mut wanted) = (Effects::default(), Set::new());
    for at in (index.last + 1..list.len()).rev() {
        let is_own = effects[at].writes.iter().all(|place| !places[place.0].is_field && wanted.contains(place));
        let is_anywhere = matches!(list[at], Statement::Set(..)) && index.always.binary_search(&at).is_ok();
        is_tail[at] |= is_own && is_anywhere && effects[at].may_swap(&kept);
        if is_tail[at] {
            wanted.extend(effects[at].reads.iter().copied());
        } else {
            kept.join(&effects[at]);
        }
    }
    is_tail
}

/// The time of an action that runs on, whatever step is active.
fn runs_on(places: &[PlaceInfo<'_>], statement: &Statement<'_>) -> Option<PlaceId> {
    match statement {
        Statement::Set(place, value @ Expr::Choose(_)) => {
            let is_time =
                places[place.0].is_field && matches!(places[place.0].ty, Type::Ticks) && mentions(value, *place);
            is_time.then_some(*place)
        }
        Statement::If(..) => {
            let effects = Effects::of(statement);
            let is_own = |place: &PlaceId| matches!(places[place.0].role, Role::TimerBegan(..) | Role::TimerStage(..));
            let began = |place: &&PlaceId| matches!(places[place.0].role, Role::TimerBegan(..));
            effects.reads.iter().find(began).copied().filter(|_| effects.writes.iter().all(is_own))
        }
        _ => None,
    }
}

/// The times that run on in several states of which each has a statement of its own.
pub(super) fn scattered(places: &[PlaceInfo<'_>], cycle: &[Statement<'_>]) -> Vec<PlaceId> {
    let mut counts = vec![0; places.len()];
    count(places, cycle, &mut counts);
    places.iter().enumerate().map(|(index, _)| PlaceId(index)).filter(|place| counts[place.0] >= SCATTERED).list()
}

fn count(places: &[PlaceInfo<'_>], statements: &[Statement<'_>], counts: &mut [usize]) {
    for statement in statements {
        if let Some(place) = runs_on(places, statement) {
            counts[place.0] += 1;
        }
        for block in blocks(statement) {
            count(places, block, counts);
        }
    }
}

/// Whether it runs something of the user's, or sets a variable.
fn acts(places: &[PlaceInfo<'_>], statement: &Statement<'_>) -> bool {
    match statement {
        Statement::Run(_) | Statement::Call(..) => true,
        Statement::Set(place, _) => matches!(places[place.0].role, Role::Var(_)),
        other => blocks(other).into_iter().flatten().any(|one| acts(places, one)),
    }
}
