//! Few outputs are one constant in each state.
//!
//! ```text
//! match after                       match after
//!   A: lamp = true                    A: lamp = true, bell = false
//!   B:                        ->      B:
//!     lamp = true                       lamp = true, bell = false
//!     bell = hot                        bell = hot
//!                                     else: lamp = false, bell = false
//! ```
//!
//! As many as a register holds are returned in it: put together of constants they are a constant, of parts they are three instructions each.
//!
//! Needs: all outputs are truths that begin each cycle as false; the last statement alone writes them, and in each state at most one that is
//! not known, which is set after the others.

use super::super::build::{no, yes};
use super::super::{Expr, PlaceId, Program, Role, Statement, Type, Value};
use super::fold::initial;
use super::uses::Effects;

/// So many bytes are returned in a register.
const REGISTER: usize = 4;

pub(super) fn pass(program: &mut Program<'_>) {
    let Some(outputs) = outputs(program) else { return };
    let Some((Statement::Match(_, arms, otherwise), before)) = program.cycle.split_last_mut() else { return };
    let written = |statements: &[Statement<'_>]| {
        let effects = Effects::of_all(statements);
        outputs.iter().any(|output| effects.writes.contains(output) || effects.reads.contains(output))
    };
    if written(before) || !otherwise.is_empty() {
        return;
    }
    let mut new = Vec::with_capacity(arms.len());
    for (values, body) in arms.iter() {
        let Some(body) = whole(body, &outputs) else { return };
        new.push((values.clone(), body));
    }
    *arms = new;
    *otherwise = record(&outputs, &[]);
}

/// All outputs, where they are few.
fn outputs(program: &Program<'_>) -> Option<Vec<PlaceId>> {
    let mut outputs = Vec::new();
    for (index, place) in program.places.iter().enumerate() {
        if matches!(place.role, Role::Output(_)) {
            let begins_false = initial(place) == Some(Value::Bool(false));
            if place.is_field || !matches!(place.ty, Type::Bool) || !begins_false {
                return None;
            }
            outputs.push(PlaceId(index));
        }
    }
    let all = outputs.len() == program.model.outputs.len();
    (all && (2..=REGISTER).contains(&outputs.len())).then_some(outputs)
}

/// The same with a value for each output.
fn whole<'m>(body: &[Statement<'m>], outputs: &[PlaceId]) -> Option<Vec<Statement<'m>>> {
    let (mut set, mut open) = (Vec::new(), None);
    for statement in body {
        match statement {
            Statement::Set(place, Expr::Value(Value::Bool(value))) if outputs.contains(place) => {
                if set.iter().any(|(other, _)| other == place) {
                    return None;
                }
                set.push((*place, *value));
            }
            Statement::Set(place, value)
                if outputs.contains(place)
                    && open.is_none()
                    && Effects::of(statement).reads.is_disjoint(&outputs.iter().copied().collect()) =>
            {
                open = Some((*place, value));
            }
            _ => return None,
        }
    }
    let Some((place, value)) = open else { return Some(record(outputs, &set)) };
    if set.iter().any(|(other, _)| *other == place) {
        return None;
    }
    let mut whole = record(outputs, &set);
    whole.push(Statement::Set(place, value.clone()));
    Some(whole)
}

/// A constant for each output.
fn record<'m>(outputs: &[PlaceId], set: &[(PlaceId, bool)]) -> Vec<Statement<'m>> {
    let mut record = Vec::with_capacity(outputs.len());
    for output in outputs {
        let holds = set.iter().any(|(place, value)| place == output && *value);
        record.push(Statement::Set(*output, if holds { yes() } else { no() }));
    }
    record
}
