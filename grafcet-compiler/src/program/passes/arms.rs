//! What is done in one state of a region, and then nothing else, stands in the arm of that state.
//!
//! ```text
//! if !auto && state.R is Wait:              once
//!   state.R = Manual                          match state.R
//! else:                                         Wait:
//!   match state.R                                 if !auto:
//!     Wait: if carton: state.R = Erect     ->       state.R = Manual
//!     Erect: …                                      break
//!   match state.S                                 else if carton: state.R = Erect
//!     …                                         Erect: …
//!                                             match state.S
//!                                               …
//! ```
//!
//! The state is asked for once.
//!
//! Needs: what else is asked can be asked later; nothing in it leaves a loop.

use super::super::build::all;
use super::super::{Arm, Expr, PlaceId, Program, Role, Statement, Value};
use super::edits::blocks_mut;
use super::once;
use super::uses::{blocks, each_read, is_pure, leaves};
use crate::model::StepId;

/// With fewer arms the states are compared one by one, and what is asked first costs as little where it stands: a chart of three regions of one step each takes 56 bytes less so
/// on ARMv6-M.
const FEW: usize = 4;

pub(super) fn pass(program: &mut Program<'_>) {
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, &mut cycle);
    program.cycle = cycle;
}

fn block<'m>(program: &Program<'m>, statements: &mut [Statement<'m>]) {
    for statement in statements {
        // A block within another one would leave that, too.
        if !moved(program, statement) {
            for inner in blocks_mut(statement) {
                block(program, inner);
            }
        }
    }
}

/// Whether a condition has found its arm. Of several, one after the other, the last one is looked at first.
fn moved<'m>(program: &Program<'m>, statement: &mut Statement<'m>) -> bool {
    let Statement::If(condition, then, otherwise) = statement else { return false };
    let within = match &mut otherwise[..] {
        [last] => moved(program, last),
        _ => false,
    };
    let new = in_arm(program, condition, then, otherwise);
    let is_new = new.is_some();
    if let Some(new) = new {
        *statement = new;
    }
    is_new || within
}

fn in_arm<'m>(
    program: &Program<'m>,
    condition: &Expr<'m>,
    then: &[Statement<'m>],
    otherwise: &[Statement<'m>],
) -> Option<Statement<'m>> {
    // There may be a block already, into which another one was put.
    let (body, is_block) = match otherwise {
        [Statement::Loop { rounds: 1, body }] => (body.split_last()?.1, true),
        _ => (otherwise, false),
    };
    let (Statement::Match(place, arms, rest), after) = body.split_first()? else { return None };
    let (step, others) = asked(condition, *place).filter(|_| matches!(program.places[place.0].role, Role::State(_)))?;
    let is_join = others.iter().any(|part| asks_state(program, part));
    if arms.len() < FEW
        || is_join
        || !others.iter().all(is_pure)
        || then.iter().any(leaves)
        || !is_block && otherwise.iter().any(leaves)
    {
        return None;
    }
    if body.iter().chain(then).any(has_block) {
        return None;
    }
    let mut then = then.to_vec();
    if !after.is_empty() {
        then.push(Statement::Break);
    }
    let arms = with_arm(arms, rest, step, |arm| {
        if others.is_empty() {
            then.clone()
        } else {
            let mut arm = vec![Statement::If(all(others.clone()), then.clone(), arm)];
            once::statements(program.model, &mut arm);
            arm
        }
    })?;
    let found = Statement::Match(*place, arms, rest.clone());
    if after.is_empty() {
        return Some(found);
    }
    let mut body = vec![found];
    body.extend_from_slice(after);
    body.push(Statement::Break);
    Some(Statement::Loop { rounds: 1, body })
}

/// The one state of a place in which a condition may hold, and what else it asks.
fn asked<'m>(condition: &Expr<'m>, place: PlaceId) -> Option<(StepId, Vec<Expr<'m>>)> {
    let parts = match condition {
        Expr::All(parts) => &parts[..],
        one => std::slice::from_ref(one),
    };
    let is_state = |part: &Expr<'m>| matches!(part, Expr::Is(of, steps) if *of == place && steps.len() == 1);
    let at = parts.iter().position(is_state)?;
    let Expr::Is(_, steps) = &parts[at] else { return None };
    let mut others = parts.to_vec();
    others.remove(at);
    Some((steps[0], others))
}

/// Whether a condition asks for the state of a region.
fn asks_state(program: &Program<'_>, condition: &Expr<'_>) -> bool {
    let mut found = false;
    each_read(condition, &mut |place| found |= matches!(program.places[place.0].role, Role::State(_)));
    found
}

/// Whether there is a block in a statement that can be left.
fn has_block(statement: &Statement<'_>) -> bool {
    matches!(statement, Statement::Loop { .. }) || blocks(statement).into_iter().flatten().any(has_block)
}

/// The arms with another one for a state, in front of what it did so far; none where it shared that with others.
fn with_arm<'m>(
    arms: &[Arm<'m>],
    rest: &[Statement<'m>],
    step: StepId,
    arm: impl FnOnce(Vec<Statement<'m>>) -> Vec<Statement<'m>>,
) -> Option<Vec<Arm<'m>>> {
    let state = Value::Step(Some(step));
    let mut arms = arms.to_vec();
    match arms.iter_mut().find(|(values, _)| values.contains(&state)) {
        Some((values, body)) if values.len() == 1 => *body = arm(std::mem::take(body)),
        None if rest.is_empty() => arms.push((vec![state], arm(Vec::new()))),
        _ => return None,
    }
    Some(arms)
}
