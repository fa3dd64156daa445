//! What goes on whatever step of a sequence is active: it stands in front of the match on the state, once, and not in each of its arms.
//!
//! ```text
//! match state                                        if !flame: …
//!   A:                                               else: delay.in = false
//!     if !flame: …                                   match state
//!     else: delay.in = false                           A: if a: state = B
//!     if a: state = B                      ->          …
//!   …
//! ```
//!
//! So count delays of conditions. What they leave in fields is not followed from state to state.

use super::super::{PlaceId, Statement};
use super::sparse::Index;
use super::uses::Effects;
use crate::list::List;

/// By statement: whether it stands in front. `own` are the state, and whether this is the first cycle.
pub(super) fn front(list: &[Statement<'_>], index: &Index, own: &[PlaceId]) -> Vec<bool> {
    let effects = list.iter().map(Effects::of).list();
    let is_free = |at: usize| {
        let touches = |place: &PlaceId| effects[at].reads.contains(place) || effects[at].writes.contains(place);
        index.always.binary_search(&at).is_ok() && !own.iter().any(touches)
    };
    let branches = |at: &usize| matches!(list[*at], Statement::If(..)) && is_free(*at);
    let mut front = vec![false; list.len()];
    for at in (0..list.len().min(index.last)).filter(branches) {
        let needed = needs(&effects, at);
        if needed.iter().all(|one| is_free(*one)) {
            for one in needed {
                front[one] = true;
            }
        }
    }
    // What cannot change places with all that stands before it stays there, and so does what needs it.
    let mut passed = Effects::default();
    for (one, is_front) in effects.iter().zip(&mut front) {
        *is_front &= one.may_swap(&passed);
        if !*is_front {
            passed.join(one);
        }
    }
    front
}

/// A statement, and what sets for it what it reads.
fn needs(effects: &[Effects], at: usize) -> Vec<usize> {
    let (mut all, mut wanted) = (vec![at], effects[at].reads.clone());
    for one in (0..at).rev() {
        if !effects[one].writes.is_disjoint(&wanted) {
            wanted.extend(effects[one].reads.iter().copied());
            all.push(one);
        }
    }
    all
}
