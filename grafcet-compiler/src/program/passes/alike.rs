//! Ways to one state that do the same for different reasons.
//!
//! ```text
//! flag = true          flag = true
//! q = true       ->    q = flag
//! state = A            state = A
//! ---                  ---
//! q = flag             q = flag
//! ```
//!
//! On one way it is known what a field holds, on the other it is not: there the local is set from the field. So it can be set after them (`share`).
//!
//! Needs: the field holds that value at the end of the way, and is not written after the local is set.

use super::super::{Expr, PlaceId, Program, Statement, Value};
use super::engine::{Fact, Leaf, Tree};
use super::fold::initial;
use super::sparse::States;
use super::uses::{Effects, same_statement, writes_to};

/// A local that some way to a state sets from a field.
struct Copied<'m> {
    local: PlaceId,
    /// In the order in which leaves know the fields.
    at: usize,
    state: Value,
    /// What that way does after it.
    after: Vec<Statement<'m>>,
}

pub(super) fn pass(program: &Program<'_>, points: &States, fields: &[PlaceId], trees: &mut [Option<Tree<'_>>]) {
    let mut copied: Vec<Copied<'_>> = Vec::new();
    for tree in trees.iter().flatten() {
        tree.each_leaf(&mut |leaf| {
            for (place, statement) in leaf.body.iter().enumerate() {
                let Statement::Set(local, Expr::Place(field)) = statement else { continue };
                let Some(at) = fields.iter().position(|other| other == field) else { continue };
                let state = leaf.state;
                let known = copied.iter().any(|other| (other.local, other.at, other.state) == (*local, at, state));
                if !program.places[local.0].is_field && !known {
                    copied.push(Copied { local: *local, at, state, after: leaf.body[place + 1..].to_vec() });
                }
            }
        });
    }
    for one in &copied {
        let to = points.point(one.state);
        let (known, field) = (initial(&program.places[one.local.0]), fields[one.at]);
        for tree in trees.iter_mut().flatten() {
            tree.each_leaf_mut(&mut |leaf| {
                if points.point(leaf.state) == to {
                    copy(leaf, one, field, known);
                }
            });
        }
    }
}

fn copy<'m>(leaf: &mut Leaf<'m>, one: &Copied<'m>, field: PlaceId, initial: Option<Value>) {
    let Some(Fact::Is(held)) = leaf.facts.get(one.at) else { return };
    let sets = |statement: &Statement<'_>| writes_to(statement, one.local);
    let (at, is_set, value) = match leaf.body.iter().rposition(sets) {
        Some(at) => match leaf.body[at] {
            Statement::Set(_, Expr::Value(value)) => (at, true, Some(value)),
            _ => return,
        },
        None => {
            // In front of what stands after it on the other way: lists have in common what stands in one order.
            let follows = |statement: &Statement<'m>| one.after.iter().any(|other| same_statement(statement, other));
            (leaf.body.iter().position(follows).unwrap_or(leaf.body.len()), false, initial)
        }
    };
    let after = Effects::of_all(&leaf.body[at..]);
    if value != Some(*held) || after.writes.contains(&field) || !is_set && after.reads.contains(&one.local) {
        return;
    }
    let copy = Statement::Set(one.local, Expr::Place(field));
    if is_set {
        leaf.body[at] = copy;
    } else {
        leaf.body.insert(at, copy);
    }
}
