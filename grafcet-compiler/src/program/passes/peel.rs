//! What the search does in its first round alone, or in each round alike, is done before it.
//!
//! ```text
//! loop                                                     edge.now = x
//!   edge.now = x                                           if first: edge.before = edge.now
//!   if first && evolutions == 0: edge.before = edge.now    loop
//!   …                                                ->      …
//!   edge.before = edge.now                                   edge.before = edge.now
//!   evolutions = 1                                           evolutions = 1
//! ```
//!
//! Needs: it can change places with all that stands in front of it in the round. What each round does alike reads nothing that a round writes; what is done in the first
//! one asks for the number of evolutions, which every round raises that another one follows.

use super::super::build::all;
use super::super::{Comparison, Expr, PlaceId, PlaceInfo, Program, Statement, Value};
use super::fold::initial;
use super::uses::{Effects, each_read, each_written, is_pure, leaves, mentions, writes_to};

pub(super) fn pass(program: &mut Program<'_>) {
    let mut cycle = std::mem::take(&mut program.cycle);
    let mut before = Effects::default();
    block(program, &mut cycle, &mut before);
    program.cycle = cycle;
}

/// `before` is what the cycle has done in front of a statement.
fn block<'m>(program: &Program<'m>, statements: &mut Vec<Statement<'m>>, before: &mut Effects) {
    let mut all = Vec::with_capacity(statements.len());
    for mut statement in statements.drain(..) {
        match &mut statement {
            Statement::Part(_, body) => block(program, body, before),
            Statement::Loop { body, .. } => {
                let counters = counters(&program.places, body, before);
                all.append(&mut peeled(&program.places, body, &counters));
            }
            _ => {}
        }
        before.add(&statement);
        all.push(statement);
    }
    *statements = all;
}

/// What counts the rounds: 0 in the first one, and in no other.
fn counters(places: &[PlaceInfo<'_>], body: &[Statement<'_>], before: &Effects) -> Vec<PlaceId> {
    let mut counters = Vec::new();
    for (at, statement) in body.iter().enumerate() {
        let Statement::Set(place, value) = statement else { continue };
        let raises = match value {
            Expr::Next(of) => of == place,
            Expr::Value(Value::Int(number)) => *number > 0,
            _ => false,
        };
        let info = &places[place.0];
        let begins = !info.is_field && initial(info) == Some(Value::Int(0)) && !before.writes.contains(place);
        let others = || body.iter().enumerate().any(|(other, one)| other != at && writes_to(one, *place));
        if raises && begins && !others() {
            counters.push(*place);
        }
    }
    counters
}

/// What may stand in front of the loop, taken out of it.
fn peeled<'m>(places: &[PlaceInfo<'m>], body: &mut Vec<Statement<'m>>, counters: &[PlaceId]) -> Vec<Statement<'m>> {
    let (mut out, mut passed, mut at) = (Vec::new(), Effects::default(), 0);
    while at < body.len() && !passed.leaves {
        let statement = &body[at];
        let moves = if Effects::of(statement).may_swap(&passed) {
            in_first(statement, counters).or_else(|| is_alike(places, body, at).then(|| statement.clone()))
        } else {
            None
        };
        if let Some(statement) = moves {
            body.remove(at);
            out.push(statement);
        } else {
            passed.add(statement);
            at += 1;
        }
    }
    out
}

/// Without the question whether this is the first round.
fn in_first<'m>(statement: &Statement<'m>, counters: &[PlaceId]) -> Option<Statement<'m>> {
    let Statement::If(condition @ Expr::All(parts), then, otherwise) = statement else { return None };
    if !otherwise.is_empty() || !is_pure(condition) || then.iter().any(leaves) {
        return None;
    }
    let asks = |part: &Expr<'_>| match part {
        Expr::Compare(Comparison::Equal, a, b) => {
            matches!((&**a, &**b), (Expr::Place(place), Expr::Value(Value::Int(0))) if counters.contains(place))
        }
        _ => false,
    };
    let at = parts.iter().position(asks)?;
    let mut rest = parts.clone();
    rest.remove(at);
    Some(Statement::If(all(rest), then.clone(), Vec::new()))
}

/// Whether each round sets a local to the same.
fn is_alike(places: &[PlaceInfo<'_>], body: &[Statement<'_>], at: usize) -> bool {
    let Statement::Set(place, value) = &body[at] else { return false };
    if places[place.0].is_field || !is_pure(value) || mentions(value, *place) {
        return false;
    }
    let mut fixed = vec![*place];
    each_read(value, &mut |read| fixed.push(read));
    let mut stays = true;
    for others in [&body[..at], &body[at + 1..]] {
        each_written(others, &mut |written| stays &= !fixed.contains(&written));
    }
    stays
}
