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

use super::super::{Expr, PlaceInfo, Role, Statement, Type};
use super::several::weight;
use super::sparse::Index;
use super::uses::{Effects, blocks, mentions};
use crate::list::List;
use crate::sorted::Set;

/// So many statements at least are worth it,
const LONG: usize = 16;

/// and so many in all states.
const MANY: usize = 150;

/// By statement: whether it stands after the match.
pub(super) fn tail(places: &[PlaceInfo<'_>], list: &[Statement<'_>], index: &Index, points: usize) -> Vec<bool> {
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
        is_tail[at] |= runs_on(places, &list[at]);
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
fn runs_on(places: &[PlaceInfo<'_>], statement: &Statement<'_>) -> bool {
    let Statement::Set(place, value @ Expr::Choose(_)) = statement else { return false };
    places[place.0].is_field && matches!(places[place.0].ty, Type::Ticks) && mentions(value, *place)
}

/// Whether it runs something of the user's, or sets a variable.
fn acts(places: &[PlaceInfo<'_>], statement: &Statement<'_>) -> bool {
    match statement {
        Statement::Run(_) | Statement::Call(..) => true,
        Statement::Set(place, _) => matches!(places[place.0].role, Role::Var(_)),
        other => blocks(other).into_iter().flatten().any(|one| acts(places, one)),
    }
}
