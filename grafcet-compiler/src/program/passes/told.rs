//! A stored output that each state tells is no field: each way ends with giving it the value that it has there.
//!
//! ```text
//! fields                                   Asked:
//!   wait = false                             if 5s are over: state = Yellow
//! Green:                                   …
//!   if request: state = Asked       ->   match state
//!               wait = true                Asked|Yellow: wait = true
//! …
//! Clear:
//!   if 2s are over: state = Walk
//!                   wait = false
//! ```
//!
//! Needs: what fields hold in each state is known (`split`), and nothing asks for the output.

use super::super::{Expr, PlaceId, Program, Role, Statement, Type, Value};
use super::engine::{End, Fact, Tree};
use super::fold::initial;
use super::uses::{Effects, mentions};

/// The trees know at the end of each way what the fields hold.
pub(super) fn pass<'m>(program: &mut Program<'m>, fields: &[PlaceId], trees: &mut [Option<Tree<'m>>]) {
    for (at, field) in fields.iter().enumerate() {
        let info = &program.places[field.0];
        if matches!(info.role, Role::Output(_))
            && matches!(info.ty, Type::Bool)
            && !is_asked(program, *field)
            && trees.iter().flatten().all(|tree| is_told(tree, *field, at))
        {
            let begins = initial(info);
            program.places[field.0].is_field = false;
            for tree in trees.iter_mut().flatten() {
                tell(tree, *field, at, begins);
            }
        }
    }
}

fn is_asked(program: &Program<'_>, field: PlaceId) -> bool {
    let Some(deadline) = &program.deadline else { return false };
    let waits = deadline.waits.iter().any(|(condition, time)| mentions(condition, field) || mentions(time, field));
    waits || mentions(&deadline.at_once, field) || deadline.late.iter().any(|(_, over)| mentions(over, field))
}

/// Whether each way ends with a value that is known, and what stands on it does no more than to set it.
fn is_told(tree: &Tree<'_>, field: PlaceId, at: usize) -> bool {
    let sets = |body: &[Statement<'_>]| {
        body.iter().all(|one| {
            let effects = Effects::of(one);
            let is_set = matches!(one, Statement::Set(place, _) if *place == field);
            !effects.reads.contains(&field) && (is_set || !effects.writes.contains(&field))
        })
    };
    sets(&tree.body)
        && match &tree.end {
            End::Leaf(leaf) => sets(&leaf.body) && matches!(leaf.facts.get(at), Some(Fact::Is(_))),
            End::Fork(condition, ways) => {
                !mentions(condition, field) && ways.iter().all(|way| is_told(way, field, at))
            }
        }
}

/// With what each cycle begins needs no giving.
fn tell(tree: &mut Tree<'_>, field: PlaceId, at: usize, begins: Option<Value>) {
    let other = |one: &Statement<'_>| !matches!(one, Statement::Set(place, _) if *place == field);
    tree.body.retain(other);
    match &mut tree.end {
        End::Leaf(leaf) => {
            leaf.body.retain(other);
            match leaf.facts.get(at) {
                Some(Fact::Is(value)) if begins != Some(*value) => {
                    leaf.body.push(Statement::Set(field, Expr::Value(*value)));
                }
                _ => {}
            }
        }
        End::Fork(_, ways) => ways.iter_mut().for_each(|way| tell(way, field, at, begins)),
    }
}
