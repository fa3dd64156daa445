//! What comes to the same in several states is done once, also where some of them would not have to do all of it.
//!
//! ```text
//! if hot:                                        if hot:
//!   match state.Main                               state.Main = Overheat
//!     Idle: state.Main = Overheat                  state.Side = none
//!     Overheat:
//!     else:                               ->
//!       state.Main = Overheat
//!       match state.Side
//!         Weigh|Dose: state.Side = none
//! ```
//!
//! `Overheat` is left for itself then, and beside `Idle` nothing was active that becomes inactive.
//!
//! Needs: those states are stored that are there already, by the state that is asked for alone; on the way from where the evolution begins no state has been written, so that
//! those are active together that the analysis has found.

use super::super::build::not;
use super::super::{Arm, Expr, Initial, PlaceId, Program, Role, Statement, Value};
use super::engine::Among;
use super::fold::Known;
use super::nested::states;
use super::share::merged;
use super::uses::{each_written, same};
use crate::list::List;
use crate::model::{Id, StepId};

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 || program.beside.is_empty() {
        return;
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, &mut cycle, Way { is_begin: true, ..Way::default() });
    program.cycle = cycle;
}

/// What is known on the way to a block.
#[derive(Clone, Default)]
struct Way<'m> {
    /// No state has been written since the evolution began.
    is_begin: bool,
    /// What has been stored, constants and copies of states, if neither has been written since.
    held: Vec<(PlaceId, Expr<'m>)>,
    /// The states that a region has one of. None among them is also one of which nobody knows, as that before the first cycle.
    among: Vec<(PlaceId, Among)>,
}

impl<'m> Way<'m> {
    fn fold(&self, program: &Program<'m>, expr: &Expr<'m>) -> Expr<'m> {
        let held = |place: PlaceId| self.held.iter().find(|(of, _)| *of == place).map(|(_, held)| held);
        let value = |place: PlaceId| match held(place) {
            Some(Expr::Value(value)) => Some(*value),
            _ => None,
        };
        let copy = |place: PlaceId| match held(place) {
            Some(Expr::Place(of)) => Some(*of),
            _ => None,
        };
        let among = |place: PlaceId| self.among.iter().find(|(of, _)| *of == place).map(|(_, states)| states);
        Known { places: &program.places, value: &value, copy: &copy, among: &among, now: &|_| false }.fold(expr)
    }

    /// The arm of a match: which states there are in it.
    fn in_arm(&self, program: &Program<'m>, place: PlaceId, values: &[Value]) -> Self {
        let mut way = self.clone();
        if region_of(program, place).is_some() {
            let state = |value: &Value| if let Value::Step(step) = value { *step } else { None };
            way.note(place, values.iter().map(state).list());
        }
        way
    }

    /// Where none of the arms is taken.
    fn otherwise(&self, program: &Program<'m>, place: PlaceId, arms: &[Arm<'m>]) -> Self {
        let mut way = self.clone();
        if let Some(region) = region_of(program, place) {
            let is_asked = |step: &Option<StepId>| arms.iter().any(|(values, _)| values.contains(&Value::Step(*step)));
            let mut left = states(program, region);
            left.retain(|step| !is_asked(step));
            left.push(None);
            way.note(place, left);
        }
        way
    }

    fn note(&mut self, place: PlaceId, states: Among) {
        self.among.retain(|(of, _)| *of != place);
        self.among.push((place, states));
    }

    /// After a statement. Whoever reads a copy finds out what it was made of, as long as that has not been written.
    fn follow(&mut self, program: &Program<'m>, statement: &Statement<'m>) {
        each_written(std::slice::from_ref(statement), &mut |place| {
            self.is_begin &= region_of(program, place).is_none();
            for (copy, held) in &self.held {
                if matches!(held, Expr::Place(of) if *of == place) {
                    let states = self.among.iter().find(|(of, _)| *of == place).map(|(_, states)| states.clone());
                    self.among.extend(states.map(|states| (*copy, states)));
                }
            }
            self.held.retain(|(other, held)| *other != place && !matches!(held, Expr::Place(of) if *of == place));
            self.among.retain(|(of, _)| *of != place);
        });
        if let Statement::Set(place, value) = statement {
            let is_copy = |of: &PlaceId| *of != *place && region_of(program, *of).is_some();
            if matches!(value, Expr::Value(_) | Expr::Now) || matches!(value, Expr::Place(of) if is_copy(of)) {
                self.held.push((*place, value.clone()));
            }
        }
    }
}

fn block<'m>(program: &Program<'m>, statements: &mut Vec<Statement<'m>>, mut way: Way<'m>) {
    let mut at = 0;
    while at < statements.len() {
        match &mut statements[at] {
            Statement::Part(_, body) | Statement::Loop { rounds: 1, body } => block(program, body, way.clone()),
            // Each round is an evolution.
            Statement::Loop { body, .. } => block(program, body, Way { is_begin: true, ..Way::default() }),
            Statement::If(_, then, otherwise) => {
                block(program, then, way.clone());
                block(program, otherwise, way.clone());
            }
            Statement::Match(place, arms, otherwise) => {
                let rest = way.otherwise(program, *place, arms);
                for (values, body) in arms {
                    block(program, body, way.in_arm(program, *place, values));
                }
                block(program, otherwise, rest);
            }
            Statement::Set(place, value) => {
                let folded = way.fold(program, value);
                if matches!(folded, Expr::Value(_)) {
                    *value = folded;
                }
                if way.held.iter().any(|(other, held)| other == place && same(held, value)) {
                    statements.remove(at);
                    continue;
                }
            }
            _ => {}
        }
        let is_begin = way.is_begin;
        way.follow(program, &statements[at]);
        let new = stored(program, &statements[at]).or_else(|| joined(program, &statements[at]).filter(|_| is_begin));
        let count = new.as_ref().map_or(1, Vec::len);
        if let Some(new) = new {
            statements.splice(at..=at, new);
        }
        at += count;
    }
}

fn region_of(program: &Program<'_>, place: PlaceId) -> Option<usize> {
    match program.places[place.0].role {
        Role::State(region) => Some(region),
        _ => None,
    }
}

/// A state that is stored in all states but itself.
fn stored<'m>(program: &Program<'m>, statement: &Statement<'m>) -> Option<Vec<Statement<'m>>> {
    let sets = |block: &[Statement<'m>], to: PlaceId| match block {
        [Statement::Set(place, Expr::Value(Value::Step(step)))] if *place == to => Some(*step),
        _ => None,
    };
    let (place, step, asked) = match statement {
        Statement::If(Expr::Is(place, steps), then, otherwise) if otherwise.is_empty() => {
            let asked = steps.iter().map(|step| Some(*step)).list();
            (*place, sets(then, *place)?, asked)
        }
        Statement::Match(place, arms, otherwise) if otherwise.is_empty() => {
            let step = sets(&arms.first()?.1, *place)?;
            let mut asked = Vec::new();
            for (values, body) in arms {
                if sets(body, *place) != Some(step) {
                    return None;
                }
                for value in values {
                    let Value::Step(step) = value else { return None };
                    asked.push(*step);
                }
            }
            (*place, step, asked)
        }
        _ => return None,
    };
    let region = region_of(program, place)?;
    if matches!(program.places[place.0].initial, Initial::Value(Value::Start(_))) {
        return None;
    }
    let all = states(program, region).iter().all(|state| *state == step || asked.contains(state));
    all.then(|| vec![Statement::Set(place, Expr::Value(Value::Step(step)))])
}

/// A match on a state of which some arms do no more than the others do.
fn joined<'m>(program: &Program<'m>, statement: &Statement<'m>) -> Option<Vec<Statement<'m>>> {
    let Statement::Match(place, arms, otherwise) = statement else { return None };
    let region = region_of(program, *place)?;
    let mut left: Vec<Arm<'m>> = Vec::new();
    let mut is_new = false;
    let mut all = arms.clone();
    let takes = |body: &[Statement<'m>], (values, small): &Arm<'m>| is_within(program, region, values, small, body);
    while let Some(arm) = all.pop() {
        if takes(otherwise, &arm) {
            is_new = true;
        } else if let Some((values, _)) = all.iter_mut().chain(&mut left).find(|other| takes(&other.1, &arm)) {
            values.extend(arm.0);
            is_new = true;
        } else {
            left.insert(0, arm);
        }
    }
    if !is_new {
        return None;
    }
    Some(match &left[..] {
        [] => otherwise.clone(),
        [(values, body)] if body.is_empty() => {
            let mut steps = Vec::new();
            for value in values {
                let Value::Step(Some(step)) = value else {
                    return Some(vec![Statement::Match(*place, left, otherwise.clone())]);
                };
                steps.push(*step);
            }
            vec![Statement::If(not(Expr::Is(*place, steps)), otherwise.clone(), Vec::new())]
        }
        _ => vec![Statement::Match(*place, merged(left), otherwise.clone())],
    })
}

/// Whether another body does the same in these states, as it stores what is there beside that.
fn is_within<'m>(
    program: &Program<'m>,
    region: usize,
    values: &[Value],
    small: &[Statement<'m>],
    large: &[Statement<'m>],
) -> bool {
    let (Some(few), Some(many)) = (constants(small), constants(large)) else { return false };
    let has = |list: &[(PlaceId, &Expr<'m>)], (place, value): (PlaceId, &Expr<'m>)| {
        list.iter().any(|(other, held)| *other == place && same(held, value))
    };
    let is_there = |(place, value): (PlaceId, &Expr<'m>)| match value {
        Expr::Value(Value::Step(step)) => {
            !few.iter().any(|(other, _)| *other == place) && holds(program, (region, values), place, *step)
        }
        _ => false,
    };
    few.len() < many.len()
        && few.iter().all(|one| has(&many, *one))
        && many.iter().all(|one| has(&few, *one) || is_there(*one))
}

/// Whether a region has a state wherever another one has one of these.
fn holds(program: &Program<'_>, (region, values): (usize, &[Value]), place: PlaceId, step: Option<StepId>) -> bool {
    let Some(other) = region_of(program, place) else { return false };
    values.iter().all(|value| {
        let Value::Step(Some(active)) = value else { return false };
        let may_be = |state: Option<StepId>| match state {
            Some(state) if other == region => state == *active,
            Some(state) => program.beside.contains(active.index(), state.index()),
            None => other != region,
        };
        let mut possible = states(program, other);
        possible.retain(|state| may_be(*state));
        possible == [step]
    })
}

/// What a body stores, if that is constants alone, each in another place.
fn constants<'s, 'm>(body: &'s [Statement<'m>]) -> Option<Vec<(PlaceId, &'s Expr<'m>)>> {
    let mut all: Vec<(PlaceId, &Expr<'m>)> = Vec::with_capacity(body.len());
    for one in body {
        let Statement::Set(place, value @ (Expr::Value(_) | Expr::Now)) = one else { return None };
        if all.iter().any(|(other, _)| other == place) {
            return None;
        }
        all.push((*place, value));
    }
    Some(all)
}
