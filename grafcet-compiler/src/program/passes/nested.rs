//! What is done for one region stands with those states of another one beside which there is something to do.
//!
//! ```text
//! match state.Safety                                 match state.Safety
//!   Stopped: alarm = true                              Stopped: alarm = true
//! match state.Modes                                    else:
//!   Manual: manual = true                      ->        match state.Modes
//! belt = belt || state.Modes is Manual && jog              Manual:
//!                                                            manual = true
//!                                                            belt = belt || jog
//! ```
//!
//! An emergency stop leaves no mode, so nothing of a mode is asked for in it.
//!
//! Needs: no state is written any more, so that those are active together that the analysis has found; one block has all states beside which there
//! is something to do.

use super::super::{Arm, Expr, PlaceId, Program, Role, Statement, Value};
use super::edits::blocks_mut;
use super::engine::Among;
use super::fold::Known;
use super::uses::{Effects, is_pure};
use crate::model::{Id, StepId};

/// So many statements are worth a test of their own.
const FEW: usize = 3;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 || program.beside.is_empty() {
        return;
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    let moves = |statement: &Statement<'_>| {
        let is_state = |place: &PlaceId| matches!(program.places[place.0].role, Role::State(_));
        Effects::of(statement).writes.iter().any(is_state)
    };
    let after = cycle.iter().rposition(moves).map_or(0, |last| last + 1);
    let mut acting = cycle.split_off(after);
    nest(program, &mut acting);
    cycle.append(&mut acting);
    program.cycle = cycle;
}

fn nest<'m>(program: &Program<'m>, statements: &mut Vec<Statement<'m>>) {
    sort(program, statements);
    let mut all: Vec<Statement<'m>> = Vec::with_capacity(statements.len());
    for statement in statements.drain(..) {
        match all.last_mut().and_then(|above| home(program, above, &statement)) {
            Some((block, known)) => block.push(known.map_or(statement.clone(), |beside| beside.folded(statement))),
            None => all.push(statement),
        }
    }
    for statement in &mut all {
        for block in blocks_mut(statement) {
            nest(program, block);
        }
    }
    gather(program, &mut all);
    *statements = all;
}

/// Several statements after a match that do nothing beside the same of its states stand in an arm with all others:
///
/// ```text
/// match state.Main                                   match state.Main
///   Idle: ready = true                                 Idle: ready = true
///   A: a = true                                        else:
///   B: b = true                                          match state.Main
/// match state.Left …                         ->            A: a = true
/// match state.Right …                                      B: b = true
/// match state.Top …                                      match state.Left …
///                                                        match state.Right …
///                                                        match state.Top …
/// ```
fn gather<'m>(program: &Program<'m>, statements: &mut Vec<Statement<'m>>) {
    let mut at = 0;
    while at < statements.len() {
        if let Some((resting, count)) = followers(program, &statements[at..]) {
            let mut inner = statements.split_off(at);
            statements.extend(inner.split_off(count + 1));
            let outer = set_aside(&mut inner, &resting);
            statements.insert(at, outer);
        }
        at += 1;
    }
}

/// The states of the match in front beside which so many statements after it do nothing, where these are several.
fn followers(program: &Program<'_>, statements: &[Statement<'_>]) -> Option<(Vec<Option<StepId>>, usize)> {
    let [Statement::Match(place, ..), after @ ..] = statements else { return None };
    let Role::State(region) = program.places[place.0].role else { return None };
    let resting = |statement: &Statement<'_>| {
        let mut states = states(program, region);
        states.retain(|state| Beside { program, place: *place, region, state: *state }.rests(statement));
        states
    };
    let mut common = resting(after.first()?);
    let mut count = 0;
    for statement in after {
        let Statement::Match(..) = statement else { break };
        let others = resting(statement);
        if !common.iter().all(|state| others.contains(state)) {
            break;
        }
        count += 1;
    }
    common.retain(Option::is_some);
    (!common.is_empty() && count >= FEW).then_some((common, count))
}

/// The match in front with the arms of some states, and all else in one for the others.
fn set_aside<'m>(statements: &mut Vec<Statement<'m>>, resting: &[Option<StepId>]) -> Statement<'m> {
    let Statement::Match(place, arms, otherwise) = statements.remove(0) else { return Statement::Break };
    let (mut outer, mut inner) = (Vec::new(), Vec::new());
    for (values, body) in arms {
        let rests = |value: &Value| resting.iter().any(|state| *value == Value::Step(*state));
        let (here, there): (Vec<Value>, Vec<Value>) = values.iter().partition(|value| rests(value));
        if !there.is_empty() {
            inner.push((there, body.clone()));
        }
        if !here.is_empty() {
            outer.push((here, body));
        }
    }
    let named = |state: &&Option<StepId>| outer.iter().any(|(values, _)| values.contains(&Value::Step(**state)));
    let mut left = Vec::new();
    for state in resting.iter().filter(|state| !named(state)) {
        left.push(Value::Step(*state));
    }
    if !left.is_empty() {
        outer.push((left, otherwise.clone()));
    }
    if !(inner.is_empty() && otherwise.is_empty()) {
        statements.insert(0, Statement::Match(place, inner, otherwise));
    }
    Statement::Match(place, outer, std::mem::take(statements))
}

/// All states of a region.
pub(super) fn states(program: &Program<'_>, region: usize) -> Vec<Option<StepId>> {
    let mut states: Vec<Option<StepId>> = vec![];
    states.extend(program.regions[region].iter().map(|step| Some(*step)));
    if !program.full[region] {
        states.push(None);
    }
    states
}

/// Regions that are written first come first, as they are above others as a rule, where one of two neighbours can stand in the other one.
fn sort<'m>(program: &Program<'m>, statements: &mut [Statement<'m>]) {
    let region = |statement: &Statement<'m>| match statement {
        Statement::Match(place, ..) => match program.places[place.0].role {
            Role::State(region) => Some(region),
            _ => None,
        },
        _ => None,
    };
    for end in (1..statements.len()).rev() {
        for at in 0..end {
            let (left, right) = statements.split_at_mut(at + 1);
            let (one, other) = (&mut left[at], &mut right[0]);
            let (Some(first), Some(second)) = (region(one), region(other)) else { continue };
            if second < first && Effects::of(one).may_swap(&Effects::of(other)) && home(program, other, one).is_some() {
                std::mem::swap(one, other);
            }
        }
    }
}

/// The block of a match that has all states beside which a statement after it does something, if there are others, and what is known in it.
fn home<'s, 'p, 'm>(
    program: &'p Program<'m>,
    above: &'s mut Statement<'m>,
    statement: &Statement<'m>,
) -> Option<(&'s mut Vec<Statement<'m>>, Option<Beside<'p, 'm>>)> {
    let Statement::Match(place, arms, otherwise) = above else { return None };
    let Role::State(region) = program.places[place.0].role else { return None };
    let mut states = states(program, region);
    let count = states.len();
    states.retain(|state| !Beside { program, place: *place, region, state: *state }.rests(statement));
    let arm = |state: &Option<StepId>| arms.iter().position(|(values, _)| values.contains(&Value::Step(*state)));
    let home = arm(states.first()?);
    if states.len() == count || states.iter().any(|state| arm(state) != home) {
        return None;
    }
    let Some(home) = home else { return Some((otherwise, None)) };
    let known = (arms[home].0.len() == 1).then(|| Beside { program, place: *place, region, state: states[0] });
    Some((&mut arms[home].1, known))
}

/// What is known while a region is in one of its states.
struct Beside<'p, 'm> {
    program: &'p Program<'m>,
    place: PlaceId,
    region: usize,
    state: Option<StepId>,
}

impl<'m> Beside<'_, 'm> {
    /// Whether a statement does nothing then.
    fn rests(&self, statement: &Statement<'m>) -> bool {
        match statement {
            Statement::Match(place, arms, otherwise) => self
                .possible(*place)
                .is_some_and(|possible| possible.iter().all(|state| chosen(arms, otherwise, *state).is_empty())),
            Statement::Set(place, value @ Expr::Any(parts)) => {
                let is_kept = |part: &Expr<'m>| matches!(part, Expr::Place(of) if of == place);
                let (kept, others): (Vec<&Expr<'m>>, Vec<&Expr<'m>>) = parts.iter().partition(|part| is_kept(part));
                !kept.is_empty() && is_pure(value) && others.iter().all(|part| is_no(&self.fold(part)))
            }
            Statement::If(condition, _, otherwise) => {
                otherwise.is_empty() && is_pure(condition) && is_no(&self.fold(condition))
            }
            _ => false,
        }
    }

    /// The states that a region may be in. A copy may hold the one before.
    fn possible(&self, place: PlaceId) -> Option<Among> {
        let Role::State(region) = self.program.places[place.0].role else { return None };
        if place == self.place {
            return Some(vec![self.state]);
        }
        let mut possible = Vec::new();
        for step in &self.program.regions[region] {
            if self.state.is_none_or(|state| self.program.beside.contains(state.index(), step.index())) {
                possible.push(Some(*step));
            }
        }
        if !self.program.full[region] {
            possible.push(None);
        }
        let (meetings, here) = (&self.program.meetings, (self.region, self.state));
        possible.retain(|state| meetings.iter().all(|meeting| meeting.allows(here, (region, *state))));
        Some(possible)
    }

    fn folded(&self, statement: Statement<'m>) -> Statement<'m> {
        match statement {
            Statement::Set(place, value) => Statement::Set(place, self.fold(&value)),
            other => other,
        }
    }

    fn fold(&self, expr: &Expr<'m>) -> Expr<'m> {
        let mut lists = Vec::with_capacity(self.program.places.len());
        for place in 0..self.program.places.len() {
            lists.push(self.possible(PlaceId(place)));
        }
        let known = Known {
            places: &self.program.places,
            value: &|_| None,
            copy: &|_| None,
            among: &|place| lists[place.0].as_ref(),
            now: &|_| false,
        };
        known.fold(expr)
    }
}

fn is_no(expr: &Expr<'_>) -> bool {
    matches!(expr, Expr::Value(Value::Bool(false)))
}

fn chosen<'s, 'm>(arms: &'s [Arm<'m>], otherwise: &'s [Statement<'m>], state: Option<StepId>) -> &'s [Statement<'m>] {
    let arm = arms.iter().find(|(values, _)| values.contains(&Value::Step(state)));
    arm.map_or(otherwise, |(_, body)| body)
}
