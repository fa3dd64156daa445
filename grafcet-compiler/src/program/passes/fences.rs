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
//! - In a search it would load all inputs beforehand, and copy what few steps do into the ways to them. Of several regions the inputs are found once in front of it, and a
//!   fence stands behind it: the packer takes 612 bytes so, and 688 without.
//! - Four neighbours that are written together become a call of `memset` on a processor without unaligned stores.

use super::super::{Expr, Fence, Program, Role, Statement, Type};
use super::tables::goes_by_table;

/// With fewer steps the code is smaller where the inputs are found once for all evolutions.
const FEW: usize = 3;

/// Up to so many steps LLVM copies what they do into the evolution in front of it.
const SHORT: usize = 24;

/// Neighbours that LLVM writes one by one.
const NEIGHBOURS: usize = 3;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 {
        return search(program);
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, &mut cycle);
    if let (Some(at), false) = (cycle.iter().position(is_search), program.model.inputs.is_empty()) {
        cycle.insert(at + 1, Statement::Fence(Fence::Memory));
        cycle.insert(at, Statement::Fence(Fence::Inputs));
    }
    program.cycle = cycle;
}

fn is_search(statement: &Statement<'_>) -> bool {
    matches!(statement, Statement::Loop { rounds: 2.., .. })
}

/// The search over the steps of one region.
fn search(program: &mut Program<'_>) {
    let steps = program.regions.iter().flatten().count();
    let Some(at) = program.cycle.iter().position(is_search) else { return };
    if program.model.inputs.is_empty() {
        return;
    }
    // Tests that a table finds keep their one register.
    let is_by_kind = program.places.iter().any(|place| matches!(place.ty, Type::Kind { .. }));
    let inputs = Statement::Fence(Fence::Inputs);
    if steps <= SHORT {
        program.cycle.insert(at + 1, Statement::Fence(Fence::Memory));
    }
    match &mut program.cycle[at] {
        Statement::Loop { body, .. } if steps >= FEW && (!goes_by_table(body) || is_by_kind) => body.insert(0, inputs),
        _ => program.cycle.insert(at, inputs),
    }
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
        // Their time, known in front of the second one, is found between them.
        let is_time = |one: &Statement<'m>| matches!(one, Statement::Set(_, Expr::Since(..)));
        let times = all.iter().rev().take_while(|one| is_time(one)).count();
        let front = all.len() - times;
        let dispatches = matches!((all[..front].last(), &statement), (Some(Statement::Match(one, ..)), Statement::Match(other, ..)) if one != other);
        if dispatches {
            all.insert(front, Statement::Fence(Fence::Memory));
        } else if neighbours > NEIGHBOURS {
            all.push(Statement::Fence(Fence::Memory));
            neighbours = 1;
        }
        all.push(statement);
    }
    *statements = all;
}
