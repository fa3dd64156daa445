//! What many states ask first, as whether somebody has pressed the emergency stop, is asked in front of the match.
//!
//! ```text
//! match state                          if stop && state is Fill|Heat|Drain: state = Stopped
//!   Fill:                              else:
//!     if stop: state = Stopped           match state
//!     else if full: state = Heat           Fill:
//!   Heat:                         ->         if full: state = Heat
//!     if stop: state = Stopped             Heat:
//!     else if hot: state = Drain             if hot: state = Drain
//!   Drain:                                 Drain:
//!     if stop: state = Stopped               if empty: state = Idle
//!     else if empty: state = Idle
//! ```
//!
//! Arms that do the same as a whole, as alarms that wait for the same button, are one arm, if that is much: of a state that stays LLVM knows in its own arm which one it is. If what follows asks
//! whether the state has changed, arms that change it stay apart: in an arm of its own LLVM knows the answer. Else the state before has to be known after the jump, for which a jump table on ARMv6-M
//! has a word for each step (a robot's cell of 40 steps takes 1368 bytes so, and 1180 apart).
//!
//! Needs: they do the same then. Other passes look for the match, so it comes after them.

use super::super::build::all;
use super::super::{Arm, Comparison, Expr, PlaceId, Program, Statement, Value};
use super::edits::blocks_mut;
use super::many::{groups, sum_of, sum_of_block};
use super::once::size;
use super::share::merged;
use super::uses::{is_plain, is_pure, is_written_in, same, same_block};
use crate::model::StepId;
use crate::sorted::sort;

/// So many states ask it at least.
const ARMS: usize = 4;

/// So many questions and statements less are worth telling these states.
const GAIN: usize = 12;

/// In front of a match in a search, where each evolution asks it.
const GAIN_IN_SEARCH: usize = 12;

pub(super) fn pass(program: &mut Program<'_>) {
    let mut compared = Vec::new();
    for statement in &program.cycle {
        if let Statement::If(Expr::Compare(Comparison::Differs, _, now), ..) = statement {
            compared.extend(if let Expr::Place(place) = **now { Some(place) } else { None });
        }
    }
    block(&mut program.cycle, &compared, GAIN);
}

/// `compared`: of these places what follows asks whether they have changed.
fn block(statements: &mut [Statement<'_>], compared: &[PlaceId], least: usize) {
    for statement in statements {
        let least = if matches!(statement, Statement::Loop { rounds: 2.., .. }) { GAIN_IN_SEARCH } else { least };
        for inner in blocks_mut(statement) {
            block(inner, compared, least);
        }
        if let Statement::Match(place, arms, _) = statement {
            merge(*place, arms, compared);
        }
        if let Some(new) = in_front(statement, compared, least) {
            *statement = new;
        }
    }
}

/// Arms that do the same, where that is worth not telling the states of those any more that stay.
fn merge(place: PlaceId, arms: &mut Vec<Arm<'_>>, compared: &[PlaceId]) {
    let mut sums = Vec::with_capacity(arms.len());
    for (_, body) in arms.iter() {
        sums.push(sum_of_block(body));
    }
    let same = groups(&sums, &|one, other| same_block(&arms[one].1, &arms[other].1));
    let mut members = vec![0; arms.len()];
    for group in &same {
        members[*group] += 1;
    }
    let mut groups = same.into_iter();
    *arms = joined(std::mem::take(arms), &mut |arm| {
        let is_much = groups.next().is_some_and(|group| (members[group] - 1) * size(&arm.1) > GAIN);
        is_much && !stays_apart(arm, place, compared)
    });
}

/// It changes what is compared later.
fn stays_apart(arm: &Arm<'_>, place: PlaceId, compared: &[PlaceId]) -> bool {
    compared.contains(&place) && is_written_in(&arm.1, place)
}

/// Those arms that may be one, where they do the same, behind the others.
fn joined<'m>(arms: Vec<Arm<'m>>, may: &mut dyn FnMut(&Arm<'m>) -> bool) -> Vec<Arm<'m>> {
    let (mut alike, mut others) = (Vec::new(), Vec::new());
    for arm in arms {
        if may(&arm) { alike.push(arm) } else { others.push(arm) }
    }
    others.extend(merged(alike));
    others
}

fn in_front<'m>(statement: &mut Statement<'m>, compared: &[PlaceId], least: usize) -> Option<Statement<'m>> {
    let Statement::Match(place, arms, otherwise) = statement else { return None };
    let group = best(arms, least)?;
    let Some([Statement::If(condition, then, _)]) = group.first().map(|at| &arms[*at].1[..]) else { return None };
    let (condition, then) = (condition.clone(), then.clone());
    let mut steps = Vec::new();
    for at in &group {
        let (values, body) = &mut arms[*at];
        steps.extend(values.iter().filter_map(step));
        if let Some(Statement::If(_, _, rest)) = body.pop() {
            *body = rest;
        }
    }
    let mut left = std::mem::take(arms);
    if otherwise.is_empty() {
        left.retain(|(_, body)| !body.is_empty());
    }
    sort(&mut steps);
    let is_one = Expr::Is(*place, steps);
    // Of what the user compares nobody knows that it cannot panic beside another step.
    let asked = if is_plain(&condition) { vec![condition, is_one] } else { vec![is_one, condition] };
    let left = joined(left, &mut |arm| !stays_apart(arm, *place, compared));
    let rest = Statement::Match(*place, left, std::mem::take(otherwise));
    Some(Statement::If(all(asked), then, vec![rest]))
}

/// The arms that begin with the same condition and do the same then, of which most is to be had.
fn best(arms: &[Arm<'_>], least: usize) -> Option<Vec<usize>> {
    let (mut heads, mut sums) = (Vec::new(), Vec::new());
    for (at, arm) in arms.iter().enumerate() {
        if let Some((condition, then)) = head(arm) {
            heads.push((at, condition, then));
            sums.push(sum_of(condition).wrapping_add(sum_of_block(then)));
        }
    }
    let is_same =
        |one: usize, other: usize| same(heads[one].1, heads[other].1) && same_block(heads[one].2, heads[other].2);
    let mut by_group: Vec<Vec<usize>> = Vec::new();
    let mut most: Option<(usize, usize)> = None;
    for ((at, condition, then), group) in heads.iter().zip(groups(&sums, &is_same)) {
        if group == by_group.len() {
            by_group.push(Vec::new());
        }
        let members = &mut by_group[group];
        members.push(*at);
        let gain = (members.len() - 1) * (loads(condition) + size(then));
        if members.len() >= ARMS && gain > least && most.is_none_or(|(best, _)| gain > best) {
            most = Some((gain, group));
        }
    }
    most.map(|(_, group)| by_group.swap_remove(group))
}

/// How many values a condition needs: `temp >= limit` two.
fn loads(condition: &Expr<'_>) -> usize {
    match condition {
        Expr::Not(inner) => loads(inner),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().map(loads).sum(),
        Expr::Compare(_, a, b) => (loads(a) + loads(b)).max(1),
        Expr::User(user) => user.binds.iter().map(|(_, value)| loads(value)).sum::<usize>().max(1),
        Expr::Value(_) => 0,
        _ => 1,
    }
}

/// What an arm asks before all else, and what it does then.
fn head<'s, 'm>((values, body): &'s Arm<'m>) -> Option<(&'s Expr<'m>, &'s [Statement<'m>])> {
    match &body[..] {
        [Statement::If(condition, then, _)]
            if is_pure(condition) && values.iter().all(|value| step(value).is_some()) =>
        {
            Some((condition, then))
        }
        _ => None,
    }
}

fn step(value: &Value) -> Option<StepId> {
    match value {
        Value::Step(step) => *step,
        _ => None,
    }
}
