//! Fences where LLVM would make more of the code than it has to.
//!
//! ```text
//! match state.A1        match state.A1
//!   …             ->      …
//! match state.B1        fence
//!   …                   match state.B1
//! ```
//!
//! - Without one between two dispatches it keeps what the first has found out in registers, and jumps from there into the second: par8 takes
//!   764 bytes and 64.6 instructions so, and 740 and 57.2 with fences.
//! - Four neighbours that are written together become a call of `memset` on a processor without unaligned stores.

use super::super::{Program, Role, Statement};

/// Neighbours that LLVM writes one by one.
const NEIGHBOURS: usize = 3;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 {
        return;
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, &mut cycle);
    program.cycle = cycle;
}

fn block<'m>(program: &Program<'m>, statements: &mut Vec<Statement<'m>>) {
    let mut all: Vec<Statement<'m>> = Vec::with_capacity(statements.len());
    let mut neighbours = 0;
    for mut statement in statements.drain(..) {
        match &mut statement {
            Statement::Part(_, body) | Statement::Loop { body, .. } => block(program, body),
            Statement::If(_, then, otherwise) => {
                block(program, then);
                block(program, otherwise);
            }
            Statement::Match(_, arms, otherwise) => {
                for (_, body) in arms {
                    block(program, body);
                }
                block(program, otherwise);
            }
            _ => {}
        }
        let is_state = |statement: &Statement<'m>| match statement {
            Statement::Set(place, _) => matches!(program.places[place.0].role, Role::State(_)),
            _ => false,
        };
        neighbours = if is_state(&statement) { neighbours + 1 } else { 0 };
        let dispatches = matches!((all.last(), &statement), (Some(Statement::Match(one, ..)), Statement::Match(other, ..)) if one != other);
        if dispatches || neighbours > NEIGHBOURS {
            all.push(Statement::Fence);
            neighbours = usize::from(neighbours > NEIGHBOURS);
        }
        all.push(statement);
    }
    *statements = all;
}
