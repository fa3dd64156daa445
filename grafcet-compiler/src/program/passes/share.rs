//! What several lists of statements have in common at their ends, or would have if their statements stood in another order.
//!
//! ```text
//! state = On      green = true             state = On   |
//! lamp = true     lamp = true      ->      lamp = true  |      and      green = true
//! green = true                                          |
//! ```

use super::super::{Arm, Statement};
use super::many::{groups, sum_of_block};
use super::uses::{Effects, same_block, same_statement};
use crate::list::List;
use crate::sorted::sort_by_key;

/// Takes out of the lists what all of them can do at their ends.
pub(super) fn ends<'m>(
    lists: &mut [&mut Vec<Statement<'m>>],
    may: &dyn Fn(&Statement<'m>) -> bool,
) -> Vec<Statement<'m>> {
    let Some((leader, _)) = lists.split_first() else { return Vec::new() };
    let mut views = Vec::with_capacity(lists.len());
    for list in lists.iter() {
        views.push(View::of(list));
    }
    // What is not in the shortest is looked for in no other.
    let mut order = (0..lists.len()).list();
    sort_by_key(&mut order, |list| lists[*list].len());
    let mut taken = Vec::new();
    for at in (0..leader.len()).rev() {
        let statement = &lists[0][at];
        if !may(statement) {
            continue;
        }
        let mut places = Vec::with_capacity(lists.len());
        for list in &order {
            let Some(place) = views[*list].find(lists[*list], statement) else { break };
            places.push(place);
        }
        if places.len() == lists.len() {
            for (list, place) in order.iter().zip(&places) {
                views[*list].taken[*place] = true;
                views[*list].end = *place;
            }
            taken.push(at);
        }
    }
    let mut shared = Vec::with_capacity(taken.len());
    for at in taken.iter().rev() {
        shared.push(lists[0][*at].clone());
    }
    for (list, view) in lists.iter_mut().zip(&views) {
        let mut taken = view.taken.iter();
        list.retain(|_| !taken.next().copied().unwrap_or(false));
    }
    shared
}

/// A list on the way to its beginning.
struct View {
    effects: Vec<Effects>,
    taken: Vec<bool>,
    /// From here on everything is decided.
    end: usize,
}

impl View {
    fn of(list: &[Statement<'_>]) -> Self {
        let mut effects = Vec::with_capacity(list.len());
        for statement in list {
            effects.push(Effects::of(statement));
        }
        Self { effects, taken: vec![false; list.len()], end: list.len() }
    }

    /// The last place of a statement, if what stays after it can be done before it.
    fn find(&self, list: &[Statement<'_>], statement: &Statement<'_>) -> Option<usize> {
        let at = list[..self.end].iter().rposition(|other| same_statement(other, statement))?;
        let stays = |after: usize| self.taken[after] || self.effects[at].may_swap(&self.effects[after]);
        (at + 1..list.len()).all(stays).then_some(at)
    }
}

/// Where a statement stands that can be done before all others of the list.
fn first_place(list: &[Statement<'_>], statement: &Statement<'_>) -> Option<usize> {
    let at = list.iter().position(|other| same_statement(other, statement))?;
    let effects = Effects::of(statement);
    list[..at].iter().all(|other| effects.may_swap(&Effects::of(other))).then_some(at)
}

pub(super) fn is_first(list: &[Statement<'_>], statement: &Statement<'_>) -> bool {
    first_place(list, statement).is_some()
}

/// Whether it was there, and could be done before all others.
pub(super) fn take_first(list: &mut Vec<Statement<'_>>, statement: &Statement<'_>) -> bool {
    let place = first_place(list, statement);
    if let Some(at) = place {
        list.remove(at);
    }
    place.is_some()
}

/// Arms that do the same are one.
pub(super) fn merged(arms: Vec<Arm<'_>>) -> Vec<Arm<'_>> {
    let mut sums = Vec::with_capacity(arms.len());
    for (_, body) in &arms {
        sums.push(sum_of_block(body));
    }
    let groups = groups(&sums, &|one, other| same_block(&arms[one].1, &arms[other].1));
    let mut all: Vec<Arm<'_>> = Vec::new();
    for ((values, body), group) in arms.into_iter().zip(groups) {
        match all.get_mut(group) {
            Some((others, _)) => others.extend(values),
            None => all.push((values, body)),
        }
    }
    all
}
