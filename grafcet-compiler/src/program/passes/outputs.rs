//! Outputs that each cycle gives a value before anything looks at them are no fields.
//!
//! Needs: the first mention in the cycle writes it, on all ways.

use super::super::{PlaceId, Program, Role, Statement};
use super::uses::{Effects, each_read};

pub(super) fn pass(program: &mut Program<'_>) {
    let mut found = given(program, &program.cycle);
    if let Some(forced) = &program.forced {
        let by_hand = given(program, forced);
        found.retain(|place| by_hand.contains(place));
    }
    let mut read_by_deadline = vec![false; program.places.len()];
    if let Some(deadline) = &program.deadline {
        let mut read = |place: PlaceId| read_by_deadline[place.0] = true;
        deadline.asks().for_each(|expr| each_read(expr, &mut read));
    }
    for place in found {
        program.places[place.0].is_field &= read_by_deadline[place.0];
    }
}

/// The outputs that a cycle gives a value first of all.
fn given(program: &Program<'_>, cycle: &[Statement<'_>]) -> Vec<PlaceId> {
    let mut open = Vec::with_capacity(program.places.len());
    for place in &program.places {
        open.push(place.is_field && matches!(place.role, Role::Output(_)));
    }
    let mut found = Vec::new();
    scan(cycle, &mut open, &mut found);
    found
}

fn scan(statements: &[Statement<'_>], open: &mut [bool], found: &mut Vec<PlaceId>) {
    for statement in statements {
        if let Statement::Part(_, body) = statement {
            scan(body, open, found);
            continue;
        }
        let effects = Effects::of(statement);
        for place in &*effects.reads {
            open[place.0] = false;
        }
        for place in &*effects.writes {
            if std::mem::replace(&mut open[place.0], false) && assigns(statement, *place) {
                found.push(*place);
            }
        }
    }
}

/// Whether a statement writes a place in any case.
fn assigns(statement: &Statement<'_>, place: PlaceId) -> bool {
    let any = |body: &[Statement<'_>]| body.iter().any(|statement| assigns(statement, place));
    match statement {
        Statement::Set(to, _) => *to == place,
        Statement::Part(_, body) => any(body),
        Statement::If(_, then, otherwise) => any(then) && any(otherwise),
        _ => false,
    }
}
