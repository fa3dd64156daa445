//! A long sequence asks by condition, and a table says which step is next.
//!
//! ```text
//! match state                              after = state
//!   start: after = S1                      once
//!   S1:                                      match state
//!     if a: after = S2                         S1|S3:
//!     else: after = S1               ->          if !a: leave
//!   S2: …                                      S2: …
//! state = after                              after = table(after)
//!                                            state = after
//! ```
//!
//! Steps that wait for the same share an arm, and are a byte or two more. Needs: what `store` has left, in which each arm stays or goes on to one
//! step; by the bytes of each, the table is the smaller one.

use super::super::build::{not, yes};
use super::super::{Arm, Expr, PlaceId, Program, Role, Statement, Value};
use super::many::{groups, sum_of};
use super::uses::{is_pure, same, same_block};
use crate::list::List;

/// About so many bytes take an arm with a condition, the same in front of a table, and a table beside its bytes, in code for Thumb.
const ARM: usize = 7;
const TEST: usize = 6;
const TABLE: usize = 24;

/// From so many states on one takes two bytes.
const BYTE: usize = 256;

/// Some states, what they wait for, and where each goes then.
struct Wait<'m> {
    from: Vec<Value>,
    condition: Expr<'m>,
}

pub(super) fn pass(program: &mut Program<'_>) {
    for statement in &mut program.cycle {
        if let Statement::Loop { rounds: 2.., body } = statement {
            return search(body);
        }
    }
    scan(program);
}

/// Whether a search goes on by a table.
pub(super) fn goes_by_table(body: &[Statement<'_>]) -> bool {
    body.iter().any(|one| matches!(one, Statement::Set(_, Expr::Table(..))))
}

/// The same in the search of a `grafcet`: what a step waits for leaves the loop where it does not hold.
fn search(body: &mut Vec<Statement<'_>>) {
    let Some(Statement::Match(state, arms, otherwise)) = body.first() else { return };
    let state = *state;
    let (mut conditions, mut table, mut leaves) = (Vec::with_capacity(arms.len()), Vec::new(), None);
    for (values, arm) in arms {
        let Some((condition, to)) = onward(arm, state, &mut leaves) else { return };
        table.extend(values.iter().map(|value| (*value, to)));
        conditions.push((values.clone(), condition));
    }
    let waits = shared(conditions);
    if !otherwise.is_empty() || !is_smaller(waits.len(), table.len()) {
        return;
    }
    let leave = leaves.cloned().unwrap_or_default();
    let mut tests: Vec<Arm<'_>> = Vec::with_capacity(waits.len());
    for wait in waits {
        let test = match not(wait.condition) {
            Expr::Value(_) => Vec::new(),
            stays => vec![Statement::If(stays, leave.clone(), Vec::new())],
        };
        tests.push((wait.from, test));
    }
    let onward = Statement::Set(state, Expr::Table(state, table));
    body.splice(..1, [Statement::Match(state, tests, Vec::new()), onward]);
}

/// What an arm waits for, and the step that is next; all leave the loop alike.
fn onward<'s, 'm>(
    arm: &'s [Statement<'m>],
    state: PlaceId,
    leaves: &mut Option<&'s Vec<Statement<'m>>>,
) -> Option<(Expr<'m>, Value)> {
    match arm {
        [Statement::Set(place, Expr::Value(to))] if *place == state => Some((yes(), *to)),
        [Statement::If(condition, then, otherwise)] if is_pure(condition) => {
            let to = goes(then, state)?;
            let leave = leaves.get_or_insert(otherwise);
            let is_end = matches!(leave.last(), Some(Statement::Break));
            (is_end && same_block(leave, otherwise)).then(|| (condition.clone(), to))
        }
        _ => None,
    }
}

fn scan(program: &mut Program<'_>) {
    let found = program.cycle.windows(2).position(|pair| {
        let [Statement::Match(state, _, otherwise), Statement::Set(set, Expr::Place(after))] = pair else {
            return false;
        };
        let is_state = matches!(program.places[state.0].role, Role::State(_));
        is_state && state == set && after != state && otherwise.is_empty()
    });
    let Some(at) = found else { return };
    let [Statement::Match(state, arms, _), Statement::Set(_, Expr::Place(after)), ..] = &program.cycle[at..] else {
        return;
    };
    let (state, after) = (*state, *after);
    let Some((waits, table)) = waits(arms, after) else { return };
    if !is_smaller(waits.len(), table.len()) {
        return;
    }
    let mut tests: Vec<Arm<'_>> = Vec::with_capacity(waits.len());
    for wait in waits {
        let test = match not(wait.condition) {
            Expr::Value(_) => Vec::new(),
            stays => vec![Statement::If(stays, vec![Statement::Break], Vec::new())],
        };
        tests.push((wait.from, test));
    }
    let body = vec![
        Statement::Match(state, tests, Vec::new()),
        Statement::Set(after, Expr::Table(after, table)),
        Statement::Set(state, Expr::Place(after)),
        Statement::Break,
    ];
    let new = [Statement::Set(after, Expr::Place(state)), Statement::Loop { rounds: 1, body }];
    program.cycle.splice(at..=at + 1, new);
}

/// What the states wait for, and which one is next after each.
#[allow(clippy::type_complexity, reason = "two lists")]
fn waits<'m>(arms: &[Arm<'m>], after: PlaceId) -> Option<(Vec<Wait<'m>>, Vec<(Value, Value)>)> {
    let (mut conditions, mut table) = (Vec::with_capacity(arms.len()), Vec::with_capacity(arms.len()));
    for (values, body) in arms {
        let (condition, to) = match &body[..] {
            [Statement::Set(place, Expr::Value(to))] if *place == after => (yes(), *to),
            [Statement::If(condition, then, otherwise)] if is_pure(condition) => {
                let to = goes(then, after)?;
                if !stays(otherwise, after, values) {
                    return None;
                }
                (condition.clone(), to)
            }
            _ => return None,
        };
        for value in values {
            table.push((*value, to));
        }
        conditions.push((values.clone(), condition));
    }
    Some((shared(conditions), table))
}

/// States that wait for the same.
fn shared<'m>(conditions: Vec<(Vec<Value>, Expr<'m>)>) -> Vec<Wait<'m>> {
    let sums = conditions.iter().map(|(_, condition)| sum_of(condition)).list();
    let groups = groups(&sums, &|one, other| same(&conditions[one].1, &conditions[other].1));
    let mut waits: Vec<Wait<'m>> = Vec::new();
    for ((from, condition), group) in conditions.into_iter().zip(groups) {
        match waits.get_mut(group) {
            Some(wait) => wait.from.extend(from),
            None => waits.push(Wait { from, condition }),
        }
    }
    waits
}

/// The one state to which a way goes.
fn goes(body: &[Statement<'_>], after: PlaceId) -> Option<Value> {
    match body {
        [Statement::Set(place, Expr::Value(to))] if *place == after => Some(*to),
        _ => None,
    }
}

/// Whether a way stays where it is.
fn stays(body: &[Statement<'_>], after: PlaceId, values: &[Value]) -> bool {
    match (body, values) {
        ([Statement::Set(place, Expr::Value(to))], [own]) => *place == after && to == own,
        // Of several states: `store` leaves the place that it has matched on.
        ([Statement::Set(place, Expr::Place(_))], _) => *place == after,
        _ => false,
    }
}

fn is_smaller(conditions: usize, states: usize) -> bool {
    let bytes = if states > BYTE { 2 } else { 1 };
    bytes * states + TEST * conditions + TABLE < ARM * states
}
