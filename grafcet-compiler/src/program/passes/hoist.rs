//! What all arms of a match do first is done before it.
//!
//! ```text
//! match state                       time = time + elapsed
//!   start: state = A                match state
//!   A:                        ->      start:
//!     time = time + elapsed             time = 0s
//!     …                                 state = A
//! ```
//!
//! The arm of the first cycle may have what is left of it with the initial values of the fields. It need not do it, either: then fields are given these back. Needs: in each
//! other arm what stands in front may be done after it; it does not write what is matched on. A match in which each state leads to one of them, or is that one, is no question.

use super::super::{Arm, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::edits::blocks_mut;
use super::fold::{Known, initial};
use super::many::values;
use super::share::{is_first, take_first};
use super::uses::{Effects, is_plain, is_pure};
use crate::model::StepId;
use crate::sorted::Set;

pub(super) fn pass(program: &mut Program<'_>) {
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, &mut cycle, false, &Set::new());
    lead(program, &mut cycle);
    program.cycle = cycle;
}

/// A match that leads to one state from all others is no question.
fn lead(program: &Program<'_>, statements: &mut [Statement<'_>]) {
    for statement in statements {
        let to = match statement {
            Statement::Match(place, arms, otherwise) if otherwise.is_empty() => one_way(program, *place, arms),
            _ => None,
        };
        if let (Some(to), Statement::Match(place, ..)) = (to, &*statement) {
            *statement = Statement::Set(*place, Expr::Value(to));
        }
        for block in blocks_mut(statement) {
            lead(program, block);
        }
    }
}

/// `before`: what may have been written since the cycle began.
fn block<'m>(program: &Program<'m>, statements: &mut Vec<Statement<'m>>, in_loop: bool, before: &Set<PlaceId>) {
    let (mut all, mut written) = (Vec::with_capacity(statements.len()), before.clone());
    for mut statement in statements.drain(..) {
        match &mut statement {
            Statement::Part(_, body) => block(program, body, in_loop, &written),
            Statement::Loop { body, .. } => block(program, body, true, &written),
            Statement::Match(place, arms, otherwise) if otherwise.is_empty() => {
                if let (Role::State(region), true) = (program.places[place.0].role, are_single(arms)) {
                    let count = usize::from(starts(arms));
                    let (start, others) = arms.split_at_mut(count);
                    if others.len() > 1 && are_all(program, region, others) && (in_loop || !start.is_empty()) {
                        let start = start.first_mut().map(|(_, body)| body);
                        all.append(&mut out_of(&program.places, *place, start, others, &written));
                    }
                }
            }
            _ => {}
        }
        written.extend(Effects::of(&statement).writes.iter().copied());
        all.push(statement);
    }
    *statements = all;
}

/// The state that a match leads to from each state, those included that it does not name.
fn one_way(program: &Program<'_>, place: PlaceId, arms: &[Arm<'_>]) -> Option<Value> {
    let Role::State(region) = program.places[place.0].role else { return None };
    let Initial::Value(Value::Step(_)) = program.places[place.0].initial else { return None };
    let [Statement::Set(set, Expr::Value(to))] = &arms.first()?.1[..] else { return None };
    let leads = |(_, body): &Arm<'_>| matches!(&body[..], [Statement::Set(other, Expr::Value(value))] if other == set && value == to);
    let values = values(arms);
    let named = |step: Option<StepId>| Value::Step(step) == *to || values.binary_search(&Value::Step(step)).is_ok();
    let all = program.regions[region].iter().all(|step| named(Some(*step))) && named(None);
    (*set == place && arms.iter().all(leads) && all).then_some(*to)
}

/// Whether there are no other states for which nothing is done: an arm for each step, and, where a region may be without one, for none.
fn are_all(program: &Program<'_>, region: usize, arms: &[Arm<'_>]) -> bool {
    let values = values(arms);
    let has = |step: Option<StepId>| values.binary_search(&Value::Step(step)).is_ok();
    program.regions[region].iter().all(|step| has(Some(*step))) && (program.regions.len() == 1 || has(None))
}

/// Whether the first arm is that of the first cycle.
fn starts(arms: &[Arm<'_>]) -> bool {
    matches!(arms.first().map(|(values, _)| &values[..]), Some([Value::Start(_)]))
}

/// Whether each arm is of one state.
fn are_single(arms: &[Arm<'_>]) -> bool {
    arms.len() > 1 && arms.iter().all(|(values, _)| values.len() == 1)
}

/// What is done in front of a match, before which something has written some places since the cycle began.
pub(super) fn out_of<'m>(
    places: &[PlaceInfo<'m>],
    state: PlaceId,
    mut start: Option<&mut Vec<Statement<'m>>>,
    others: &mut [Arm<'m>],
    written: &Set<PlaceId>,
) -> Vec<Statement<'m>> {
    let (mut shared, mut at) = (Vec::new(), 0);
    // What the first cycle does as well, and what it is given back.
    let (mut done, mut back) = (written.clone(), Set::new());
    while let Some(statement) = others.first().and_then(|(_, leader)| leader.get(at)).cloned() {
        let effects = Effects::of(&statement);
        let in_all = others.iter().all(|(_, body)| is_first(body, &statement));
        let may = effects.reads.is_disjoint(&back) && effects.writes.is_disjoint(&back);
        // What the first cycle has of it.
        let own = start.as_ref().filter(|_| may && in_all).and_then(|start| {
            let mut own = vec![statement.clone()];
            if !is_first(start, &statement) {
                own = beginning(places, state, &statement, &mut done.clone());
            }
            take_all(&mut Vec::clone(start), &own).then_some(own)
        });
        let along = may && (start.is_none() || own.is_some());
        let given = match &statement {
            Statement::Set(place, value) if is_plain(value) => {
                at_start(&places[place.0]).filter(|_| !done.contains(place))
            }
            _ => None,
        };
        if effects.writes.contains(&state) || effects.leaves || !in_all || !along && given.is_none() {
            at += 1;
            continue;
        }
        for (_, body) in others.iter_mut() {
            take_first(body, &statement);
        }
        if along {
            if let (Some(start), Some(own)) = (&mut start, own) {
                take_all(start, &own);
            }
            done.extend(effects.writes.iter().copied());
        } else {
            back.extend(effects.writes.iter().copied());
        }
        shared.push(statement);
    }
    for place in &*back {
        if let (Some(value), Some(start)) = (at_start(&places[place.0]), &mut start) {
            start.insert(0, Statement::Set(*place, Expr::Value(value)));
        }
    }
    shared
}

/// Takes each of them, in their order, where all of them could be done before all others.
fn take_all<'m>(list: &mut Vec<Statement<'m>>, statements: &[Statement<'m>]) -> bool {
    statements.iter().all(|one| take_first(list, one))
}

/// What is left of a statement in the first cycle, in which places hold what they begin with until something has written them, and the state
/// says that this cycle is to come.
fn beginning<'m>(
    places: &[PlaceInfo<'m>],
    state: PlaceId,
    statement: &Statement<'m>,
    written: &mut Set<PlaceId>,
) -> Vec<Statement<'m>> {
    let held = |written: &Set<PlaceId>, place: PlaceId| {
        let info = &places[place.0];
        let held = if info.is_field && !written.contains(&place) { at_start(info) } else { None };
        match held {
            Some(Value::Step(step)) if place == state => Some(Value::Start(step)),
            held => held,
        }
    };
    let fold = |written: &Set<PlaceId>, expr: &Expr<'m>| {
        let value = |place| held(written, place);
        Known { places, value: &value, copy: &|_| None, among: &|_| None, now: &|_| false }.fold(expr)
    };
    let all = |written: &mut Set<PlaceId>, block: &[Statement<'m>]| {
        let mut left = Vec::with_capacity(block.len());
        for one in block {
            left.append(&mut beginning(places, state, one, written));
        }
        left
    };
    match statement {
        Statement::Set(place, value) => {
            let value = fold(written, value);
            if matches!(value, Expr::Value(value) if held(written, *place) == Some(value)) {
                return Vec::new();
            }
            written.insert(*place);
            vec![Statement::Set(*place, value)]
        }
        Statement::If(condition, then, otherwise) => match fold(written, condition) {
            Expr::Value(Value::Bool(holds)) => all(written, if holds { then } else { otherwise }),
            condition => {
                let mut elsewhere = written.clone();
                let (then, otherwise) = (all(written, then), all(&mut elsewhere, otherwise));
                written.extend(elsewhere.iter().copied());
                if then.is_empty() && otherwise.is_empty() && is_pure(&condition) {
                    return Vec::new();
                }
                vec![Statement::If(condition, then, otherwise)]
            }
        },
        other => {
            written.extend(Effects::of(other).writes.iter().copied());
            vec![other.clone()]
        }
    }
}

/// What a place holds when the first cycle begins.
fn at_start(place: &PlaceInfo<'_>) -> Option<Value> {
    let given = matches!(place.role, Role::Param(_)) || matches!(place.ty, Type::User(_));
    initial(place).filter(|_| !given)
}
