//! In a `grafcet` the first cycle is a state, of several regions that of the first one that begins with a step, and what tells that the next cycle would do the same is no field
//! where others tell it. What gives a field what it begins with is nothing to do in that cycle.
//!
//! ```text
//! fields                       fields
//!   first = true                 state = start
//!   state = A            ->
//! if first: since = now        first = state is start
//! …                            if first: state = A
//! settled = true               if first: since = now
//! first = false                …
//! at reading if !settled       at since if state is start
//! ```
//!
//! Needs: the deadline does not ask whether the first cycle is still to come.

use super::super::build::{all, compare, not, yes};
use super::super::{Comparison, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Value, Wait};
use super::dead::read_after;
use super::edits::{replaced, unset};
use super::fold::initial;
use super::live::Live;
use super::uses::{Effects, blocks, each_read, is_read_in, mentions, writes_to};
use crate::model::StepId;
use crate::sorted::Set;

pub(super) fn pass(program: &mut Program<'_>) {
    let Some(first) = program.place(Role::First).filter(|_| program.model.is_grafcet()) else { return };
    let is_alone = program.regions.len() == 1;
    let mut found = None;
    for region in 0..program.regions.len() {
        let Some(state) = program.place(Role::State(region)) else { return };
        match program.places[state.0].initial {
            Initial::Value(Value::Step(begin @ Some(_))) if found.is_none() => found = Some((state, begin)),
            // Without a loop it is one by now.
            Initial::Value(start @ Value::Start(_)) => {
                settle(program, &compare(Comparison::Equal, Expr::Place(state), Expr::Value(start)));
                return outlasted(program);
            }
            _ => {}
        }
    }
    let Some((state, begin)) = found else { return };
    changed(program, first);
    let ends =
        |one: &Statement<'_>| matches!(one, Statement::Set(place, Expr::Value(Value::Bool(false))) if *place == first);
    let rest = program.cycle.iter().filter(|one| !ends(one));
    let mut effects = Effects::default();
    rest.for_each(|one| effects.add(one));
    if effects.writes.contains(&first) || is_asked(program, first) {
        return;
    }
    if !effects.reads.contains(&first) && told(program).is_none() && program.forced.is_none() {
        return;
    }
    // In the loop no state is that of the first cycle.
    for statement in &mut program.cycle {
        let Statement::Loop { body, .. } = statement else { continue };
        for statement in body {
            match statement {
                Statement::Match(place, _, otherwise) if is_alone && *place == state && otherwise.is_empty() => {
                    otherwise.push(Statement::Break);
                }
                _ => {}
            }
        }
    }
    program.cycle.retain(|one| !ends(one));
    let start = Expr::Value(Value::Start(begin));
    let is_start = compare(Comparison::Equal, Expr::Place(state), start);
    let enters = Statement::Set(state, Expr::Value(Value::Step(begin)));
    let front = [Statement::Set(first, is_start.clone()), Statement::If(Expr::Place(first), vec![enters], Vec::new())];
    program.cycle.splice(0..0, front);
    as_state(program, state, first, begin);
    settle(program, &is_start);
    outlasted(program);
}

/// The first cycle is a state, which the cycle takes care of; the forced one finds out when it begins.
pub(super) fn as_state(program: &mut Program<'_>, state: PlaceId, first: PlaceId, begin: Option<StepId>) {
    let start = Value::Start(begin);
    program.places[state.0].initial = Initial::Value(start);
    program.places[first.0].is_field = false;
    if let Some(forced) = &mut program.forced {
        let is_start = compare(Comparison::Equal, Expr::Place(state), Expr::Value(start));
        let enters = Statement::Set(state, Expr::Value(Value::Step(begin)));
        let front = [Statement::Set(first, is_start), Statement::If(Expr::Place(first), vec![enters], Vec::new())];
        forced.splice(0..0, front);
    }
}

/// What gives a field what it begins with is nothing to do in the first cycle, nor is what that alone has asked for.
fn changed(program: &mut Program<'_>, first: PlaceId) {
    let base = read_after(program);
    let mut beginning = Beginning { places: &program.places, written: Set::new() };
    for at in 0..program.cycle.len() {
        let (front, rest) = program.cycle.split_at_mut(at + 1);
        if let Statement::If(Expr::Place(place), body, _) = &mut front[at] {
            if *place == first {
                beginning.thin(body);
                let mut live = Live::after(&base);
                live.sweep(&mut rest.to_vec());
                live.sweep(body);
            }
        }
        beginning.written.extend(Effects::of(&front[at]).writes.iter().copied());
    }
    let does_nothing = |one: &Statement<'_>| matches!(one, Statement::If(Expr::Place(place), then, otherwise) if *place == first && then.is_empty() && otherwise.is_empty());
    program.cycle.retain(|one| !does_nothing(one));
}

/// How far a first cycle has come.
struct Beginning<'p, 'm> {
    places: &'p [PlaceInfo<'m>],
    /// What may hold something else by now than it began with.
    written: Set<PlaceId>,
}

impl<'m> Beginning<'_, 'm> {
    /// Of what is done in the first cycle alone, what changes nothing goes.
    fn thin(&mut self, body: &mut Vec<Statement<'m>>) {
        let mut held = Vec::new();
        body.retain(|one| self.changes(one, &mut held));
    }

    /// Whether a statement may change something; `held` is what places got before it.
    fn changes(&mut self, statement: &Statement<'m>, held: &mut Vec<(PlaceId, Expr<'m>)>) -> bool {
        let Statement::Set(to, value) = statement else {
            let writes = Effects::of(statement).writes;
            held.retain(|(place, _)| !writes.contains(place));
            self.written.extend(writes.iter().copied());
            return true;
        };
        let value = match value {
            Expr::Place(from) => held.iter().rev().find(|(place, _)| place == from).map_or(value, |(_, value)| value),
            value => value,
        };
        let value = value.clone();
        if self.begins_with(*to, &value) {
            return false;
        }
        self.written.insert(*to);
        held.push((*to, value));
        true
    }

    /// Whether a field still holds what it began with, and that is this value.
    fn begins_with(&self, field: PlaceId, value: &Expr<'m>) -> bool {
        let info = &self.places[field.0];
        let is_same = match value {
            Expr::Value(value) => initial(info) == Some(*value),
            Expr::Place(from) => *from == field,
            _ => false,
        };
        is_same && info.is_field && !self.written.contains(&field)
    }
}

/// Whether the deadline asks for a place.
fn is_asked(program: &Program<'_>, place: PlaceId) -> bool {
    let Some(deadline) = &program.deadline else { return false };
    deadline.asks().any(|expr| mentions(expr, place)) || deadline.late.iter().any(|(_, over)| mentions(over, place))
}

/// What is stored of whether the next cycle would do the same, if only fields tell that.
fn told<'m>(program: &Program<'m>) -> Option<(PlaceId, Expr<'m>)> {
    let settled = program.place(Role::Settled)?;
    if is_so_after_each(program, settled) {
        return Some((settled, yes()));
    }
    let mut told = None;
    for (at, statement) in program.cycle.iter().enumerate() {
        match statement {
            Statement::Set(place, value) if *place == settled && told.is_none() => told = Some((at, value.clone())),
            other if writes_to(other, settled) => return None,
            _ => {}
        }
    }
    let (at, value) = told?;
    let later = Effects::of_all(&program.cycle[at..]).writes;
    let mut lasts = true;
    each_read(&value, &mut |place| lasts &= program.places[place.0].is_field && !later.contains(&place));
    lasts.then_some((settled, value))
}

/// Whether it becomes true in the first cycle, and is never false again.
fn is_so_after_each(program: &Program<'_>, settled: PlaceId) -> bool {
    let (mut begins, mut stays) = (false, true);
    for statement in &program.cycle {
        if let Statement::Match(_, arms, _) = statement {
            for (values, body) in arms {
                let sets = body.iter().any(|one| matches!(one, Statement::Set(place, _) if *place == settled));
                begins |= sets && values.iter().any(|value| matches!(value, Value::Start(_)));
            }
        }
    }
    each_set(&program.cycle, &mut |place, value| {
        stays &= place != settled || matches!(value, Expr::Value(Value::Bool(true)));
    });
    begins && stays
}

fn each_set<'m>(statements: &[Statement<'m>], each: &mut dyn FnMut(PlaceId, &Expr<'m>)) {
    for statement in statements {
        match statement {
            Statement::Set(place, value) => each(*place, value),
            other => {
                for block in blocks(other) {
                    each_set(block, each);
                }
            }
        }
    }
}

/// Before the first cycle nothing is settled.
fn settle<'m>(program: &mut Program<'m>, is_start: &Expr<'m>) {
    // A forced cycle leaves it unsettled, whatever others tell.
    let Some((settled, value)) = told(program).filter(|_| program.forced.is_none()) else { return };
    let told = all(vec![not(is_start.clone()), value.clone()]);
    let leaf = |expr: &Expr<'m>| matches!(expr, Expr::Place(place) if *place == settled).then(|| told.clone());
    let Some(deadline) = &mut program.deadline else { return };
    let alone =
        matches!(&deadline.at_once, Expr::Not(inner) if matches!(**inner, Expr::Place(place) if place == settled));
    // Both begin with the same reading.
    if let (true, Expr::Value(Value::Bool(true)), Some(wait)) = (alone, &value, deadline.waits.first()) {
        deadline.reading = Expr::Place(wait.from);
    }
    deadline.at_once = replaced(&deadline.at_once, &leaf);
    for wait in &mut deadline.waits {
        wait.condition = replaced(&wait.condition, &leaf);
    }
    unset(&mut program.cycle, settled);
}

/// That a time of the active step is over is stored where the deadline asks for it.
fn outlasted(program: &mut Program<'_>) {
    for region in 0..program.regions.len() {
        let (Some(passed), Some(state)) = (program.place(Role::Passed(region)), program.place(Role::State(region)))
        else {
            continue;
        };
        let Some(asked) = asked(program, passed, state) else { continue };
        for statement in &mut program.cycle {
            let Statement::Match(place, arms, otherwise) = statement else { continue };
            if *place != state {
                continue;
            }
            let sets = |one: &Statement<'_>| matches!(one, Statement::Set(place, _) if *place == passed);
            for (values, body) in arms.iter_mut() {
                if !values.iter().any(|value| asked.contains(value)) {
                    body.retain(|one| !sets(one));
                }
            }
            arms.retain(|(_, body)| !body.is_empty() || !otherwise.is_empty());
        }
    }
}

/// The states in which the deadline asks whether a time is over, if nobody else does.
fn asked(program: &Program<'_>, passed: PlaceId, state: PlaceId) -> Option<Vec<Value>> {
    let deadline = program.deadline.as_ref()?;
    let mut asked = Vec::new();
    for Wait { condition, .. } in &deadline.waits {
        if !mentions(condition, passed) {
            continue;
        }
        let Expr::All(parts) = condition else { return None };
        let of = parts.iter().find_map(|part| match part {
            Expr::Is(place, steps) if *place == state => Some(steps),
            _ => None,
        });
        asked.extend(of?.iter().map(|step| Value::Step(Some(*step))));
    }
    let others = mentions(&deadline.at_once, passed) || is_read_in(&program.cycle, passed);
    (!others).then_some(asked)
}
