//! A value that an output ends with is put into the output at once.
//!
//! ```text
//! match state.Left                   match state.Left
//!   Lift: next.lamp = true             Lift: lamp = true
//! match state.Right            ->    match state.Right
//!   Push: next.lamp = true             Push: lamp = true
//! lamp = next.lamp
//! ```
//!
//! An output is memory of the caller, which is cleared anyway. LLVM keeps a local of that kind in a register, and each way says what it is: where many outputs are
//! put together from several regions, that is most of a cycle (Par8 `grafcet` on the Cortex-M3: 940 → 820 bytes, 240 → 190 instructions).
//!
//! Such an output that is no truth begins with its own value, and what would put that into it first has nothing to do (Reactor `grafcet` on the Cortex-M0: 616 → 580 bytes).
//!
//! Needs: nobody asks for the output within the cycle, and nothing else is put into it; nobody asks for the local after that; both begin alike.

use super::super::{Expr, Initial, PlaceId, Program, Role, Statement, Type, Value};
use super::dead::drop_places;
use super::edits::{blocks_mut, rename, unset};
use super::fold::initial;
use super::uses::{Effects, each_asked, each_written, has, is_written_in, writes_to};
use crate::model::{Tree, Ty};

pub(super) fn pass(program: &mut Program<'_>) {
    // By hand the ends of a cycle are done after another evolution, so they are written alike.
    if program.forced.is_some() {
        return;
    }
    let mut pairs = Vec::new();
    for at in 0..program.cycle.len() {
        pairs.extend(put(program, &program.cycle, at));
    }
    if pairs.is_empty() {
        return;
    }
    for (output, local) in pairs {
        unset(&mut program.cycle, output);
        rename(&mut program.cycle, local, output);
        if !matches!(program.places[output.0].ty, Type::Bool) {
            let begins = Begins { output, value: initial_of(program, output) };
            begins.strip(&mut program.cycle, false);
        }
    }
    drop_places(program);
}

/// The output and the local, where this statement puts one into the other.
fn put(program: &Program<'_>, cycle: &[Statement<'_>], at: usize) -> Option<(PlaceId, PlaceId)> {
    let Statement::Set(output, Expr::Place(local)) = &cycle[at] else { return None };
    let (to, from) = (&program.places[output.0], &program.places[local.0]);
    let is_output = matches!(to.role, Role::Output(_)) && !to.is_field;
    // A record of several outputs or a kind of a state is a local of another type.
    let is_alike = matches!(
        (to.ty, from.ty),
        (Type::Bool, Type::Bool) | (Type::Ticks, Type::Ticks) | (Type::User(_), Type::User(_))
    );
    let is_local = from.role == Role::Local && !from.is_field && is_alike;
    // Of a type for which nothing is said here no pass takes for granted what a local begins with: each way gives it its value.
    if !is_output || !is_local || initial(to) != initial(from) {
        return None;
    }
    let (mut reads, mut writes) = (0, 0);
    each_asked(cycle, &mut |place| reads += usize::from(place == *output));
    each_written(cycle, &mut |place| writes += usize::from(place == *output));
    let after = Effects::of_all(&cycle[at + 1..]);
    let ends = !after.reads.contains(local) && !after.writes.contains(local);
    // Code of the user writes what it has bound.
    let is_run = |one: &Statement<'_>| matches!(one, Statement::Run(_)) && writes_to(one, *local);
    ((reads, writes) == (0, 1) && ends && !has(cycle, &is_run)).then_some((*output, *local))
}

/// What an output begins with, where it is a constant.
fn initial_of(program: &Program<'_>, output: PlaceId) -> Option<Value> {
    let place = &program.places[output.0];
    match (place.initial, place.ty) {
        (Initial::Constant(expr), _) => tree_of(&expr.tree),
        (Initial::Value(value), _) => Some(value),
        (Initial::Default, Type::User(Ty::Int { .. })) => Some(Value::Int(0)),
        _ => None,
    }
}

fn tree_of(tree: &Tree) -> Option<Value> {
    match tree {
        Tree::Int(value) => Some(Value::Int(*value)),
        _ => None,
    }
}

/// An output, and what it begins with.
struct Begins {
    output: PlaceId,
    value: Option<Value>,
}

impl Begins {
    /// Leaves out what would put that into it first; whether something else has.
    fn strip(&self, statements: &mut Vec<Statement<'_>>, written: bool) -> bool {
        let mut now = written;
        statements.retain_mut(|statement| {
            match statement {
                Statement::Set(place, value) if *place == self.output => {
                    let begins = match value {
                        Expr::Initial(of) => *of == self.output,
                        Expr::Value(value) => Some(*value) == self.value,
                        Expr::User(user) => tree_of(user.tree).is_some_and(|value| Some(value) == self.value),
                        _ => false,
                    };
                    if begins && !now {
                        return false;
                    }
                    now = true;
                }
                // A round may begin where another one has ended.
                Statement::Loop { body, .. } => now |= is_written_in(body, self.output),
                other => {
                    let before = now;
                    for block in blocks_mut(other) {
                        now |= self.strip(block, before);
                    }
                    drop_empty(other);
                }
            }
            true
        });
        now
    }
}

/// Arms that do nothing, where nothing is done in other states, either.
fn drop_empty(statement: &mut Statement<'_>) {
    if let Statement::Match(_, arms, otherwise) = statement {
        arms.retain(|(_, body)| !(body.is_empty() && otherwise.is_empty()));
    }
}
