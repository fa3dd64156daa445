//! A number that the active step tells comes from a table.
//!
//! ```text
//! match state                        phase = table(state)
//!   Fill:                            match state
//!     phase = 1                        Fill: inlet = true
//!     inlet = true            ->       Rinse: outlet = true
//!   Rinse:                             …
//!     phase = 2
//!     outlet = true
//!   …
//! ```
//!
//! In each arm the number takes two instructions. What arms do beside it is the same in more of them then.
//!
//! Needs: an output that is no field, of which nothing but that match writes, and literals alone; by their bytes, the table is the smaller one.

use super::super::{Arm, Expr, Initial, PlaceId, Program, Role, Statement, Type, Value};
use super::share;
use super::uses::{Effects, writes_to};
use crate::list::List;
use crate::model::{Tree, Ty, Unary};

/// About so many bytes take a literal in an arm, and a table beside its own, in code for Thumb.
const LITERAL: usize = 4;
const TABLE: usize = 16;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.forced.is_some() || program.model.flags {
        return;
    }
    let numbers = (0..program.places.len()).map(PlaceId).filter(|place| is_number(program, *place)).list();
    for number in numbers {
        by_table(program, number);
    }
}

/// An output of some integer type that each cycle begins with a literal.
fn is_number(program: &Program<'_>, place: PlaceId) -> bool {
    let info = &program.places[place.0];
    matches!(info.role, Role::Output(_)) && !info.is_field && matches!(info.ty, Type::User(Ty::Int { .. }))
}

fn by_table(program: &mut Program<'_>, number: PlaceId) {
    let Some(begins) = begins(program, number) else { return };
    let mut writers = program.cycle.iter().enumerate().filter(|(_, one)| writes_to(one, number)).map(|(at, _)| at);
    let (Some(at), None) = (writers.next(), writers.next()) else { return };
    let Statement::Match(state, arms, otherwise) = &program.cycle[at] else { return };
    let Type::State(region) = program.places[state.0].ty else { return };
    let is_read = program.cycle.iter().any(|one| Effects::of(one).reads.contains(&number));
    if is_read || otherwise.iter().any(|one| writes_to(one, number)) {
        return;
    }
    let Ok(literals) = arms.iter().map(|(_, body)| literal_of(body, number)).collect::<Result<Vec<_>, Other>>() else {
        return;
    };
    let written = literals.iter().flatten().count();
    let Type::User(Ty::Int { bits, .. }) = program.places[number.0].ty else { return };
    let size = (program.regions[region].len() + 1) * bits.div_ceil(8) as usize;
    if written * LITERAL < TABLE + size {
        return;
    }
    let mut table = Vec::new();
    for ((values, _), literal) in arms.iter().zip(&literals) {
        let value = Value::Int(literal.unwrap_or(begins));
        table.extend(values.iter().map(|state| (*state, value)));
    }
    for step in program.regions[region].iter().copied().map(Some).and([None]) {
        let state = Value::Step(step);
        if !table.iter().any(|(other, _)| *other == state) {
            table.push((state, Value::Int(begins)));
        }
    }
    let state = *state;
    let Statement::Match(_, arms, otherwise) = &mut program.cycle[at] else { return };
    let mut left: Vec<Arm<'_>> = std::mem::take(arms);
    for (_, body) in &mut left {
        body.retain(|one| !writes_to(one, number));
    }
    if otherwise.is_empty() {
        left.retain(|(_, body)| !body.is_empty());
    }
    *arms = share::merged(left);
    program.cycle.insert(at, Statement::Set(number, Expr::Table(state, table)));
}

/// An arm writes something else than a literal.
struct Other;

/// The literal that an arm writes, if it writes at all.
fn literal_of(body: &[Statement<'_>], number: PlaceId) -> Result<Option<i128>, Other> {
    let mut writes = body.iter().filter(|one| writes_to(one, number));
    match (writes.next(), writes.next()) {
        (None, _) => Ok(None),
        (Some(Statement::Set(_, value)), None) => literal(value).map(Some).ok_or(Other),
        _ => Err(Other),
    }
}

fn literal(value: &Expr<'_>) -> Option<i128> {
    match value {
        Expr::Value(Value::Int(number)) => Some(*number),
        Expr::User(user) => whole(user.tree),
        _ => None,
    }
}

fn whole(tree: &Tree) -> Option<i128> {
    match tree {
        Tree::Int(number) => Some(*number),
        Tree::Unary(Unary::Neg, inner) => whole(inner)?.checked_neg(),
        _ => None,
    }
}

/// What a cycle begins with.
fn begins(program: &Program<'_>, number: PlaceId) -> Option<i128> {
    match program.places[number.0].initial {
        Initial::Value(Value::Int(number)) => Some(number),
        Initial::Value(_) => None,
        Initial::Constant(written) => whole(&written.tree),
        Initial::Default => Some(0),
    }
}
