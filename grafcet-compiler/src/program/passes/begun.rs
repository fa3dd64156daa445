//! Of several regions, a time begins only where a step becomes active that asks for it.
//!
//! ```text
//! A1:                               A1:
//!   if x:                             if x: state = A2
//!     state = A2                    A2:
//!     since = now             ->      if y:
//! A2:                                   state = A3
//!   if y:                               since = now
//!     state = A3                    A3:
//!     since = now                     if since(now, since) >= 2s: …
//! A3:
//!   if since(now, since) >= 2s: …
//! ```
//!
//! Needs: whoever reads the time knows from the state of the region that a step is active that asks for it. Each way sets the state to one step, and begins the time there
//! where it asks for one.

use std::ops::Range;

use super::super::{Comparison, Expr, Initial, PlaceId, Program, Role, Statement, Value};
use super::edits::blocks_mut;
use super::uses::{blocks, has, is_written_in, mentions, reads_from, writes_to};
use crate::list::List;
use crate::sorted::Set;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 || program.forced.is_some() {
        return;
    }
    for number in 0..program.regions.len() {
        let (Some(state), Some(since)) = (program.place(Role::State(number)), program.place(Role::Began(number)))
        else {
            continue;
        };
        let mut copies = Vec::new();
        copied(&program.cycle, state, false, &mut copies);
        let region = Region { state, since, first: program.place(Role::First), copies };
        let Some(asked) = region.asked(program) else { continue };
        if region.begins(&program.cycle, &asked) {
            let begin = match program.places[state.0].initial {
                Initial::Value(Value::Step(step) | Value::Start(step)) => Value::Step(step),
                _ => continue,
            };
            region.thin(&mut program.cycle, &asked, (!asked.contains(&begin)).then_some(begin));
        }
    }
}

struct Region {
    state: PlaceId,
    since: PlaceId,
    /// Whether this is the first cycle.
    first: Option<PlaceId>,
    /// What each evolution copies the state to before it moves.
    copies: Vec<PlaceId>,
}

/// What the state of a region can be; nothing is known without one.
type Known = Option<Set<Value>>;

impl Region {
    /// The states in which the time is read.
    fn asked(&self, program: &Program<'_>) -> Option<Set<Value>> {
        let mut asked = Set::new();
        self.block(&program.cycle, None, &mut asked)?;
        let deadline = program.deadline.as_ref()?;
        for wait in &deadline.waits {
            let known = self.narrowed(&wait.condition, None, &mut asked)?;
            if wait.from == self.since || mentions(&wait.time, self.since) {
                asked.extend(known?);
            }
        }
        // Before the first cycle it holds what it begins with.
        if mentions(&deadline.reading, self.since) && !is_first(&deadline.at_once)
            || mentions(&deadline.at_once, self.since)
            || deadline.late.iter().any(|(_, over)| mentions(over, self.since))
        {
            return None;
        }
        Some(asked)
    }

    /// What is asked in some statements; what is known after them.
    fn block(&self, statements: &[Statement<'_>], mut known: Known, asked: &mut Set<Value>) -> Option<Known> {
        for statement in statements {
            known = match statement {
                Statement::Set(place, Expr::Value(value)) if *place == self.state => Some(set(&[*value])),
                Statement::Set(place, value) => {
                    self.narrowed(value, known.clone(), asked)?;
                    known.filter(|_| *place != self.state)
                }
                Statement::If(condition, then, otherwise) => {
                    let inner = self.narrowed(condition, known.clone(), asked)?;
                    either(self.block(then, inner, asked)?, self.block(otherwise, known, asked)?)
                }
                Statement::Match(place, arms, otherwise) => {
                    let mut after = self.block(otherwise, known.clone(), asked)?;
                    for (values, body) in arms {
                        let inner = if *place == self.state { Some(set(values)) } else { known.clone() };
                        after = either(after, self.block(body, inner, asked)?);
                    }
                    after
                }
                Statement::Loop { body, .. } => {
                    self.block(body, None, asked)?;
                    known.filter(|_| !is_written_in(body, self.state))
                }
                Statement::Part(_, body) => self.block(body, known, asked)?,
                other => {
                    if reads_from(other, self.since) {
                        asked.extend(known.clone()?);
                    }
                    known.filter(|_| !writes_to(other, self.state))
                }
            };
        }
        Some(known)
    }

    /// What is known where an expression holds. Where it reads the time, something has to be known of the state.
    fn narrowed(&self, expr: &Expr<'_>, known: Known, asked: &mut Set<Value>) -> Option<Known> {
        match expr {
            Expr::All(parts) => {
                let mut inner = known;
                for part in parts {
                    inner = self.narrowed(part, inner, asked)?;
                }
                Some(inner)
            }
            Expr::Is(place, steps) if *place == self.state => {
                let mut values = steps.iter().map(|step| Value::Step(Some(*step))).list();
                if let Some(known) = known {
                    values.retain(|value| known.contains(value));
                }
                Some(Some(set(&values)))
            }
            other => {
                if mentions(other, self.since) {
                    asked.extend(known.clone()?);
                }
                Some(known)
            }
        }
    }

    /// Whether each way to a step that asks for the time begins it, and each way leads to one that is known.
    fn begins(&self, statements: &[Statement<'_>], asked: &Set<Value>) -> bool {
        let begun = self.begun_after(statements);
        for (at, statement) in statements.iter().enumerate() {
            if begun.contains(&at) {
                continue;
            }
            let fits = match statement {
                Statement::Set(place, value) if *place == self.state => match value {
                    Expr::Value(value) if asked.contains(value) => {
                        let mut others = statements.iter().enumerate().filter(|(other, _)| *other != at);
                        others.any(|(_, one)| self.begins_here(one, Some(*value)))
                    }
                    value => matches!(value, Expr::Value(_)),
                },
                other => blocks(other).into_iter().all(|block| self.begins(block, asked)),
            };
            if !fits {
                return false;
            }
        }
        true
    }

    /// After which of some statements the time begins wherever the state differs from that before the evolution, which is copied before them.
    fn begun_after(&self, statements: &[Statement<'_>]) -> Range<usize> {
        let Some(end) = statements.iter().rposition(|one| self.begins_where_it_differs(one)) else { return 0..0 };
        let is_in_between = |one: &Statement<'_>| {
            has(std::slice::from_ref(one), &|inner| matches!(inner, Statement::Break))
                || self.copies.iter().any(|was| is_written_in(std::slice::from_ref(one), *was))
        };
        let from = statements[..end].iter().rposition(is_in_between).map_or(0, |at| at + 1);
        from..end
    }

    fn begins_where_it_differs(&self, statement: &Statement<'_>) -> bool {
        let Statement::If(Expr::Compare(Comparison::Differs, _, state), ..) = statement else { return false };
        matches!(**state, Expr::Place(state) if state == self.state) && self.begins_here(statement, None)
    }

    /// Whether it is the beginning of the time, be it only where the step was not active before.
    fn begins_here(&self, statement: &Statement<'_>, to: Option<Value>) -> bool {
        match statement {
            Statement::Set(place, Expr::Now) => *place == self.since,
            Statement::If(Expr::Compare(Comparison::Differs, was, other), then, otherwise) => {
                let is_step = to.is_none_or(|to| matches!(**other, Expr::Value(value) if value == to));
                let is_before = matches!(**was, Expr::Place(was) if self.copies.contains(&was));
                let begins = matches!(&then[..], [Statement::Set(place, Expr::Now)] if *place == self.since);
                is_step && is_before && begins && otherwise.is_empty()
            }
            _ => false,
        }
    }

    /// Nothing begins where the step that becomes active does not ask. `begin` is the initial one if it does not. Returned is whether the state is written.
    fn thin(&self, statements: &mut Vec<Statement<'_>>, asked: &Set<Value>, begin: Option<Value>) -> bool {
        let (mut leads, mut writes_within) = (Vec::new(), false);
        for statement in statements.iter_mut() {
            match statement {
                Statement::Set(place, Expr::Value(value)) if *place == self.state => leads.push(*value),
                other => writes_within |= self.thin_within(other, asked, begin),
            }
        }
        if !writes_within && matches!(leads[..], [to] if !asked.contains(&to)) {
            statements.retain(|one| !self.begins_here(one, None));
        }
        let does_nothing = |one: &Statement<'_>| matches!(one, Statement::If(Expr::Place(_), then, otherwise) if then.is_empty() && otherwise.is_empty());
        statements.retain(|one| !does_nothing(one));
        writes_within || !leads.is_empty()
    }

    fn thin_within(&self, statement: &mut Statement<'_>, asked: &Set<Value>, begin: Option<Value>) -> bool {
        if let (Statement::If(Expr::Place(place), then, _), Some(_)) = (&mut *statement, begin) {
            if Some(*place) == self.first && !is_written_in(then, self.state) {
                then.retain(|one| !self.begins_here(one, None));
            }
        }
        if let (Statement::Match(_, arms, _), Some(_)) = (&mut *statement, begin) {
            for (values, body) in arms {
                let is_first = values.iter().all(|value| matches!(value, Value::Start(_)));
                if is_first && !is_written_in(body, self.state) {
                    body.retain(|one| !self.begins_here(one, None));
                }
            }
        }
        let blocks = blocks_mut(statement);
        if blocks.is_empty() {
            return writes_to(statement, self.state);
        }
        let mut writes = false;
        for block in blocks {
            writes |= self.thin(block, asked, begin);
        }
        writes
    }
}

/// What is known where two ways come together.
fn either(one: Known, other: Known) -> Known {
    let (mut all, other) = (one?, other?);
    all.extend(other.iter().copied());
    Some(all)
}

fn set(values: &[Value]) -> Set<Value> {
    let mut all = Set::new();
    all.extend(values.iter().copied());
    all
}

/// The locals to which a state is copied once in each evolution: in the loop, if there is one.
fn copied(statements: &[Statement<'_>], state: PlaceId, in_loop: bool, into: &mut Vec<PlaceId>) {
    let has_loop = statements.iter().any(|one| matches!(one, Statement::Loop { .. }));
    for statement in statements {
        match statement {
            Statement::Set(place, Expr::Place(of)) if *of == state && (in_loop || !has_loop) => into.push(*place),
            Statement::Loop { body, .. } => copied(body, state, true, into),
            _ => {}
        }
    }
}

/// Whether it asks for nothing but whether the first cycle is still to come.
fn is_first(expr: &Expr<'_>) -> bool {
    match expr {
        Expr::Not(inner) => is_first(inner),
        Expr::Compare(Comparison::Equal, _, other) => matches!(**other, Expr::Value(Value::Start(_))),
        _ => false,
    }
}
