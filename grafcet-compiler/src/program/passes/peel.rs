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
//! What is set from the situation there, as what an edge of a step compares with, is known in the first round of the first cycle.
//!
//! Needs: it can change places with all that stands in front of it in the round. What each round does alike reads nothing that a round writes; what is done in the first
//! one asks for the number of evolutions, which every round raises that another one follows.

use super::super::build::all;
use super::super::{Comparison, Expr, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::fold::{Known, initial};
use super::search::opened;
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
                *body = opened(body);
                let counters = counters(&program.places, body, before);
                all.append(&mut begun(&program.places, body, &counters, before));
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

/// What the first round of the first cycle alone does, where it is known what fields hold by then: the edge of a step, say, has the initial situation to
/// look at.
fn begun<'m>(
    places: &[PlaceInfo<'m>],
    body: &mut Vec<Statement<'m>>,
    counters: &[PlaceId],
    before: &Effects,
) -> Vec<Statement<'m>> {
    let mut held: Vec<Option<Value>> = Vec::with_capacity(places.len());
    for (at, place) in places.iter().enumerate() {
        // A recipe may have been given before.
        let is_own = place.is_field && !matches!(place.role, Role::Param(_));
        held.push(initial(place).filter(|_| is_own && !before.writes.contains(&PlaceId(at))));
    }
    let (mut out, mut passed, mut at) = (Vec::new(), Effects::default(), 0);
    while at < body.len() && !passed.leaves {
        let value = |place: PlaceId| held[place.0];
        let known = Known { places, value: &value, copy: &|_| None, among: &|_| None, now: &|_| false };
        match in_first(&body[at], counters) {
            Some(Statement::If(first @ Expr::Place(place), then, _)) if places[place.0].role == Role::First => {
                let given = given(&then, &known, &passed);
                if let Some(given) = given {
                    body.remove(at);
                    let mut changed = Vec::new();
                    for (to, value) in given {
                        // What stands after it looks at what it has set: an edge in an edge.
                        if held[to.0].replace(value) != Some(value) {
                            changed.push(Statement::Set(to, Expr::Value(value)));
                        }
                    }
                    if !changed.is_empty() {
                        out.push(Statement::If(first, changed, Vec::new()));
                    }
                    continue;
                }
            }
            _ => {}
        }
        let found = match &body[at] {
            Statement::Set(place, value) => match known.fold(value) {
                Expr::Value(value) => Some((*place, value)),
                _ => None,
            },
            _ => None,
        };
        each_written(std::slice::from_ref(&body[at]), &mut |place| held[place.0] = None);
        if let Some((place, value)) = found {
            held[place.0] = Some(value);
        }
        passed.add(&body[at]);
        at += 1;
    }
    out
}

/// What fields are set to, if that is known and nothing in front of it has to do with them.
fn given<'m>(then: &[Statement<'m>], known: &Known<'_, 'm>, passed: &Effects) -> Option<Vec<(PlaceId, Value)>> {
    let mut given = Vec::new();
    for one in then {
        let Statement::Set(to, value) = one else { return None };
        let Expr::Value(value) = known.fold(value) else { return None };
        if passed.reads.contains(to) || passed.writes.contains(to) || matches!(known.places[to.0].ty, Type::User(_)) {
            return None;
        }
        given.push((*to, value));
    }
    Some(given)
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
    // Who looks at a situation looks for copies of all its states.
    if fixed.iter().any(|place| matches!(places[place.0].ty, Type::State(_))) {
        return false;
    }
    let mut stays = true;
    for others in [&body[..at], &body[at + 1..]] {
        each_written(others, &mut |written| stays &= !fixed.contains(&written));
    }
    stays
}
