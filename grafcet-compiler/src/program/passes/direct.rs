//! A truth that an output ends with is put into the output at once.
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
//! Needs: nobody asks for the output within the cycle, and nothing else is put into it; both begin alike; nobody asks for the local behind that.

use super::super::{Expr, PlaceId, Program, Role, Statement, Type};
use super::dead::drop_places;
use super::fold::initial;
use super::uses::{Effects, blocks_mut, each_asked, each_written, replaced, rewrite, unset};

/// So many find registers of their own.
const FEW: usize = 4;

pub(super) fn pass(program: &mut Program<'_>) {
    // By hand the ends of a cycle are done behind another evolution, so they are written alike.
    if program.forced.is_some() {
        return;
    }
    let pairs: Vec<_> = (0..program.cycle.len()).filter_map(|at| put(program, &program.cycle, at)).collect();
    if pairs.len() < FEW {
        return;
    }
    for (output, local) in pairs {
        unset(&mut program.cycle, output);
        rename(&mut program.cycle, local, output);
    }
    drop_places(program);
}

/// The output and the local, where this statement puts one into the other.
fn put(program: &Program<'_>, cycle: &[Statement<'_>], at: usize) -> Option<(PlaceId, PlaceId)> {
    let Statement::Set(output, Expr::Place(local)) = &cycle[at] else { return None };
    let (to, from) = (&program.places[output.0], &program.places[local.0]);
    let is_output = matches!(to.role, Role::Output(_)) && !to.is_field;
    let is_local = from.role == Role::Local && !from.is_field && matches!(from.ty, Type::Bool);
    let begin = initial(to);
    if !is_output || !is_local || begin.is_none() || begin != initial(from) {
        return None;
    }
    let (mut reads, mut writes) = (0, 0);
    each_asked(cycle, &mut |place| reads += usize::from(place == *output));
    each_written(cycle, &mut |place| writes += usize::from(place == *output));
    let behind = Effects::of_all(&cycle[at + 1..]);
    let ends = !behind.reads.contains(local) && !behind.writes.contains(local);
    ((reads, writes) == (0, 1) && ends && !is_run(cycle, *local)).then_some((*output, *local))
}

/// Whether code of the user writes a place.
fn is_run(statements: &[Statement<'_>], place: PlaceId) -> bool {
    statements.iter().any(|statement| match statement {
        Statement::Run(run) => run.writes.iter().any(|write| write.to == place || write.noted == Some(place)),
        _ => super::uses::blocks(statement).into_iter().any(|block| is_run(block, place)),
    })
}

fn rename(statements: &mut [Statement<'_>], from: PlaceId, to: PlaceId) {
    rewrite(statements, &mut |expr| {
        replaced(expr, &|leaf| matches!(leaf, Expr::Place(place) if *place == from).then_some(Expr::Place(to)))
    });
    write_to(statements, from, to);
}

fn write_to(statements: &mut [Statement<'_>], from: PlaceId, to: PlaceId) {
    for statement in statements {
        match statement {
            Statement::Set(place, _) if *place == from => *place = to,
            _ => {}
        }
        for block in blocks_mut(statement) {
            write_to(block, from, to);
        }
    }
}
