//! Steps that wait for the same share an arm, and a table says which step each of them leads to.
//!
//! ```text
//! match state                              match state
//!   Fill:                                    Fill:
//!     if full: state = Heat                    if full:
//!     else if 10s: state = Alarm                 state = Heat
//!   Rest:                                        since = now
//!     if 1s: state = Turn                      else if 10s: goes = true
//!   Ramp:                        ->          Rest|Ramp: goes = 1s
//!     if 1s: state = Spin                  if goes:
//! if was != state: since = now               state = table(state)
//! match state                                since = now
//!   …                                      match state
//!                                            …
//! ```
//!
//! After a state from a table LLVM cannot go on by itself to what that state does: there is one dispatch more, and what is done after the ways
//! is there once. A step with several ways has the last one in the table, as those before it are taken more often; or the one to the step that is declared after it,
//! where more steps share an arm then, as those of a sequence with watchdogs.
//!
//! In the search of a `grafcet` the ways that do not go on leave the loop. Needs: each way through it ends in one state at most.

use super::super::build::{compare, no, not, yes};
use super::super::{Arm, Comparison, Expr, PlaceId, PlaceInfo, Program, Statement, Value};
use super::edits::blocks_mut;
use super::many::complete;
use super::share::merged;
use super::store::writes_state;
use super::uses::{is_pure, is_read_in, is_written_in, same, writes_to};
use crate::list::List;
use crate::model::Id;

pub(super) fn pass(program: &mut Program<'_>) {
    let is_search = |one: &Statement<'_>| matches!(one, Statement::Loop { rounds: 2.., .. });
    match program.cycle.iter().position(is_search) {
        Some(at) => search(program, at),
        None => scan(program),
    }
}

/// Whether one evolution goes on by such a table.
pub(super) fn applies(program: &Program<'_>) -> bool {
    let mut tried = program.clone();
    scan(&mut tried);
    tried.places.len() > program.places.len()
}

/// The same in the search of a `grafcet`, whose ways leave the loop where nothing goes on.
fn search(program: &mut Program<'_>, at: usize) {
    let goes = PlaceId(program.places.len());
    let Statement::Loop { body, .. } = &mut program.cycle[at] else { return };
    let Some(Statement::Match(state, arms, otherwise)) = body.first() else { return };
    let (state, before) = (*state, arms.len());
    let Some((next, mut new)) = Next::fewest((state, goes), &[], arms) else { return };
    if before < LONG || next.table.is_empty() || !is_smaller(before, new.len()) {
        return;
    }
    let onward = Statement::Set(state, Expr::Table(state, next.table));
    // Where each way takes what is next from the table, or leaves the loop, nothing has to tell that.
    if !new.iter().all(|(_, body)| all_go(body, goes)) {
        let otherwise = otherwise.clone();
        let reset = Statement::Set(goes, no());
        let goes_on = Statement::If(Expr::Place(goes), vec![onward], Vec::new());
        body.splice(..1, [reset, Statement::Match(state, new, otherwise), goes_on]);
        program.places.push(PlaceInfo::truth("goes".to_owned()));
        return;
    }
    for (_, arm) in &mut new {
        without_set(arm, goes);
    }
    body.splice(..1, [Statement::Match(state, new, otherwise.clone()), onward]);
}

/// Whether each way takes what is next from the table or leaves the loop: none sets another state, or goes on in its own.
fn all_go(body: &[Statement<'_>], goes: PlaceId) -> bool {
    match body.last() {
        Some(Statement::If(_, then, otherwise)) => all_go(then, goes) && all_go(otherwise, goes),
        Some(Statement::Set(place, Expr::Value(Value::Bool(true)))) => *place == goes,
        last => matches!(last, Some(Statement::Break)),
    }
}

/// Without what tells that a way goes on.
fn without_set(statements: &mut Vec<Statement<'_>>, goes: PlaceId) {
    statements.retain(|one| !matches!(one, Statement::Set(place, _) if *place == goes));
    for statement in statements {
        for block in blocks_mut(statement) {
            without_set(block, goes);
        }
        if let Statement::If(condition, then, otherwise) = statement {
            if then.is_empty() {
                let stays = not(condition.clone());
                *statement = Statement::If(stays, std::mem::take(otherwise), Vec::new());
            }
        }
    }
}

fn scan(program: &mut Program<'_>) {
    let Some(at) = program.cycle.iter().position(|statement| writes_state(program, statement)) else { return };
    let [Statement::Match(state, arms, _), after @ ..] = &program.cycle[at..] else { return };
    let (state, goes) = (*state, PlaceId(program.places.len()));
    let (was, begins) = match begins(after, state) {
        Some((was, begins)) => (Some(was), begins.to_vec()),
        None => (None, Vec::new()),
    };
    let before = arms.len();
    let Some((next, new)) = Next::fewest((state, goes), &begins, arms) else { return };
    let new = timed(new, state, goes);
    if !is_smaller(before, new.len()) {
        return;
    }
    let mut then = vec![Statement::Set(state, Expr::Table(state, next.table))];
    then.extend(next.begins);
    let new = [Statement::Match(state, new, Vec::new()), Statement::If(Expr::Place(goes), then, Vec::new())];
    program.cycle.splice(at..=at + usize::from(was.is_some()), new);
    program.places.push(PlaceInfo::truth("goes".to_owned()));
    if let Some(was) = was {
        without(&mut program.cycle, was);
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    for statement in &mut cycle {
        // LLVM looks whether a state is in range of a match that does not name it.
        complete(program, state, statement);
    }
    program.cycle = cycle;
}

/// What is done after the ways where the state differs from what it was: the local that says what it was, and what is done.
fn begins<'s, 'm>(after: &'s [Statement<'m>], state: PlaceId) -> Option<(PlaceId, &'s [Statement<'m>])> {
    let Some(Statement::If(Expr::Compare(Comparison::Differs, was, now), begins, otherwise)) = after.first() else {
        return None;
    };
    match (&**was, &**now) {
        (Expr::Place(was), Expr::Place(now)) if *now == state && otherwise.is_empty() => {
            (!is_written_in(begins, state)).then_some((*was, begins))
        }
        _ => None,
    }
}

/// Which of several ways of a step takes what is next from the table.
#[derive(Clone, Copy)]
enum Chosen {
    Last,
    /// That to the step declared after it; without one the last.
    Onward,
}

/// What the ways become.
struct Next<'m> {
    chosen: Chosen,
    state: PlaceId,
    /// Whether the table says what is next.
    goes: PlaceId,
    /// What each way to another state does.
    begins: Vec<Statement<'m>>,
    table: Vec<(Value, Value)>,
}

impl<'m> Next<'m> {
    /// With the way in the table that lets more steps share an arm.
    fn fewest(
        (state, goes): (PlaceId, PlaceId),
        begins: &[Statement<'m>],
        arms: &[Arm<'m>],
    ) -> Option<(Self, Vec<Arm<'m>>)> {
        let of = |chosen| Self { chosen, state, goes, begins: begins.to_vec(), table: Vec::new() }.arms(arms);
        let (last, onward) = (of(Chosen::Last)?, of(Chosen::Onward)?);
        let alike = merged(arms.to_vec()).len();
        Some(if onward.1.len() + SHARED <= alike.min(last.1.len()) { onward } else { last })
    }

    fn arms(mut self, arms: &[Arm<'m>]) -> Option<(Self, Vec<Arm<'m>>)> {
        let mut new: Vec<Arm<'m>> = Vec::with_capacity(arms.len());
        for (values, body) in arms {
            let [own] = values[..] else { return None };
            new.push((values.clone(), self.arm(own, body)?));
        }
        Some((self, merged(new)))
    }

    fn arm(&mut self, own: Value, body: &[Statement<'m>]) -> Option<Vec<Statement<'m>>> {
        let mut ends = Vec::new();
        self.ends(body, &mut ends)?;
        let is_onward = |to: &Value| match (self.chosen, own, *to) {
            (Chosen::Onward, Value::Step(Some(own)), Value::Step(Some(to))) => own.index() + 1 == to.index(),
            _ => false,
        };
        let onward = ends.iter().copied().find(is_onward);
        let Some(to) = onward.or_else(|| ends.into_iter().rfind(|to| *to != own)) else {
            return Some(body.to_vec());
        };
        self.table.push((own, to));
        let mut body = body.to_vec();
        self.lead(&mut body, own, to);
        if let [Statement::If(condition, then, otherwise)] = &body[..] {
            let alone =
                matches!(&then[..], [Statement::Set(place, Expr::Value(Value::Bool(true)))] if *place == self.goes);
            if alone && otherwise.is_empty() && is_pure(condition) {
                body = vec![Statement::Set(self.goes, condition.clone())];
            }
        }
        Some(body)
    }

    /// The states in which the ways end that set one, in their order.
    fn ends(&self, body: &[Statement<'m>], ends: &mut Vec<Value>) -> Option<()> {
        let (before, last) = match body.split_last() {
            Some((Statement::If(_, then, otherwise), before)) => (before, Some([then, otherwise])),
            _ => (body, None),
        };
        let mut to = None;
        for statement in before {
            match statement {
                Statement::Set(place, Expr::Value(value)) if *place == self.state && to.is_none() => to = Some(*value),
                other if writes_to(other, self.state) => return None,
                _ => {}
            }
        }
        match (last, to) {
            (None, to) => ends.extend(to),
            (Some(ways), None) => {
                for way in ways {
                    self.ends(way, ends)?;
                }
            }
            (Some(_), Some(_)) => return None,
        }
        Some(())
    }

    /// Ways to one state take it from the table; all others to another one begin what begins there.
    fn lead(&self, body: &mut Vec<Statement<'m>>, own: Value, next: Value) {
        if let Some(Statement::If(_, then, otherwise)) = body.last_mut() {
            self.lead(then, own, next);
            self.lead(otherwise, own, next);
            return;
        }
        let is_end = |one: &Statement<'m>| matches!(one, Statement::Set(place, _) if *place == self.state);
        let Some(at) = body.iter().position(is_end) else { return };
        let Statement::Set(_, Expr::Value(to)) = body[at] else { return };
        if to == next {
            body.remove(at);
            body.push(Statement::Set(self.goes, yes()));
        } else if to != own {
            body.extend(self.begins.iter().cloned());
        }
    }
}

/// A local that nothing looks at any more.
fn without(cycle: &mut Vec<Statement<'_>>, was: PlaceId) {
    if !is_read_in(cycle, was) {
        cycle.retain(|statement| !matches!(statement, Statement::Set(place, _) if *place == was));
    }
}

/// In a search of fewer steps a table costs more than it saves (Selection 172 → 191 bytes, 89.4 → 100.8 instructions).
const LONG: usize = 20;

/// So many arms less there have to be so that steps are worth a table that share no arm as they are, nor with their last ways in it: of Picker one was less, which took
/// 35 bytes more, of a handling unit with a watchdog for each step three and five, which took 80 less.
const SHARED: usize = 3;

/// Where few arms become one, LLVM does better with states that it knows.
fn is_smaller(before: usize, arms: usize) -> bool {
    4 * arms <= 3 * before
}

/// About so many bytes takes an arm that waits for a time alone, and a table of times beside what is in it.
const ARM: usize = 10;
const TABLE: usize = 14;

/// Arms that wait for times alone are one, if a table of the times is smaller.
fn timed<'m>(arms: Vec<Arm<'m>>, state: PlaceId, goes: PlaceId) -> Vec<Arm<'m>> {
    let (mut rest, mut waits, mut times) = (Vec::with_capacity(arms.len()), Vec::new(), Vec::new());
    let states: usize = arms.iter().map(|(values, _)| values.len()).sum();
    let mut asked: Option<&Expr<'m>> = None;
    for (index, (values, body)) in arms.iter().enumerate() {
        let Some((passed, time)) = waits_for(body, goes) else { continue };
        if same(passed, asked.get_or_insert(passed)) {
            waits.push(index);
            times.extend(values.iter().map(|value| (*value, time)));
        }
    }
    let highest = times.iter().map(|(_, time)| *time).max().unwrap_or_default();
    let bytes = if u16::try_from(highest).is_ok() { 2 } else { 4 };
    let Some(passed) = asked.filter(|_| bytes * states + TABLE < ARM * waits.len()) else { return arms };
    let table = times.iter().map(|(value, time)| (*value, Value::Ticks(*time))).list();
    let over = compare(Comparison::AtLeast, passed.clone(), Expr::Table(state, table));
    let all = times.iter().map(|(value, _)| *value).list();
    let one = (all, vec![Statement::Set(goes, over)]);
    for (index, arm) in arms.into_iter().enumerate() {
        if waits.binary_search(&index).is_err() {
            rest.push(arm);
        }
    }
    rest.push(one);
    rest
}

/// The time that has passed and the one that it is compared with, where an arm waits for nothing else.
fn waits_for<'s, 'm>(body: &'s [Statement<'m>], goes: PlaceId) -> Option<(&'s Expr<'m>, u32)> {
    match body {
        [Statement::Set(place, Expr::Compare(Comparison::AtLeast, passed, time))] if *place == goes => match **time {
            Expr::Value(Value::Ticks(time)) => Some((passed, time)),
            _ => None,
        },
        _ => None,
    }
}
