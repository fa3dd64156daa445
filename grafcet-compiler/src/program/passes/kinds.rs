//! In a long chart a byte a state says what there is to do in it, so that what many states do stands once.
//!
//! ```text
//! match state                        kind = kinds(state)
//!   S1|S3|S5: if !a: leave     ->    match kind
//!   S2|S4: if !b: leave                0: if !a: leave
//!                                      1: if !b: leave
//! ```
//!
//! LLVM makes a jump table of such a match, with two or four bytes a state, or copies what a state does that shares it with none to the way there.
//! Where states that share what they wait for share what they do, one table is enough for both.
//!
//! Needs: each arm stands for many states, of two matches that tell nearly the same apart, or of 256 states and more, under `optimize size;`; else what a table of next states stands after, where a few states have
//! an arm of their own.

use super::super::{Arm, Expr, Initial, PlaceId, PlaceInfo, Program, Statement, Type, Value};
use super::share::merged;
use super::uses::has;
use crate::list::List;
use crate::sorted::{Map, Set};

/// From so many states on.
const LONG: usize = 20;

/// From about so many states on a jump table has more than a byte for each.
const BYTE: usize = 256;

/// One state of so many may have an arm of its own: the table costs a byte a state and four instructions a cycle. With one in five it saved an
/// eighth of the flash (Seq64), with one in four half of that, with nearly each other one none.
const ALONE: usize = 5;

pub(super) fn pass(program: &mut Program<'_>) {
    let mut small = program.model.optimize_size;
    let mut found = Vec::new();
    find(program, small, &program.cycle, &mut found);
    let mut common = Kinds::common(program, &found);
    // A table beside a jump table of bytes pays where it stands for two of these; of many states a jump table has two bytes each.
    let is_short = program.regions.iter().all(|steps| steps.len() < BYTE);
    if small && is_short && common.as_ref().is_none_or(|kinds| !kinds.are_few()) {
        small = false;
        found.clear();
        find(program, small, &program.cycle, &mut found);
        common = Kinds::common(program, &found);
    }
    if found.is_empty() {
        return;
    }
    let mut cycle = std::mem::take(&mut program.cycle);
    block(program, small, &mut cycle, common.as_ref());
    program.cycle = cycle;
}

/// A number for each state: those of one number do the same.
struct Kinds {
    of: Map<Value, i128>,
    count: i128,
}

impl Kinds {
    /// What one match tells apart.
    fn of(program: &Program<'_>, region: usize, arms: &[Vec<Value>]) -> Self {
        let (mut of, mut count) = (Map::new(), 0);
        for values in arms {
            of.extend(values.iter().map(|value| (*value, count)));
            count += 1;
        }
        // All other states are one more kind, the last one.
        let mut others = false;
        for state in states(program, region) {
            if !of.contains_key(&state) {
                of.insert(state, count);
                others = true;
            }
        }
        Self { of, count: count + i128::from(others) }
    }

    /// Half as many as there are states.
    fn are_few(&self) -> bool {
        i128::try_from(self.of.len()).is_ok_and(|states| 2 * self.count <= states)
    }

    /// What all matches tell apart, if that is hardly more than one of them does.
    fn common(program: &Program<'_>, matches: &[(usize, Vec<Vec<Value>>)]) -> Option<Self> {
        let [(region, first), rest @ ..] = matches else { return None };
        if rest.is_empty() || rest.iter().any(|(other, _)| other != region) {
            return None;
        }
        let all = matches.iter().map(|(_, arms)| Self::of(program, *region, arms)).list();
        let (mut numbers, mut of) = (Map::new(), Map::new());
        for (state, _) in &Self::of(program, *region, first).of {
            let told = all.iter().map(|kinds| kinds.of.get(state).copied().unwrap_or(kinds.count)).list();
            let next = i128::try_from(numbers.len()).unwrap_or(i128::MAX);
            of.insert(*state, *numbers.or_insert_with(told, || next));
        }
        let count = i128::try_from(numbers.len()).unwrap_or(i128::MAX);
        let most = all.iter().map(|kinds| kinds.count).max().unwrap_or_default();
        (4 * count <= 5 * most).then_some(Self { of, count })
    }
}

/// Each match that becomes one by kinds: its region, and the states of each arm.
fn find(program: &Program<'_>, small: bool, statements: &[Statement<'_>], found: &mut Vec<(usize, Vec<Vec<Value>>)>) {
    for (at, statement) in statements.iter().enumerate() {
        match statement {
            Statement::Loop { body, .. } | Statement::Part(_, body) => find(program, small, body, found),
            Statement::Match(place, arms, _) => {
                if let Some((region, arms)) = by_kind(program, small, (*place, arms), statements.get(at + 1)) {
                    found.push((region, arms.into_iter().map(|(values, _)| values).list()));
                }
            }
            _ => {}
        }
    }
}

/// The region of a match that becomes one by kinds, and its arms, each different.
fn by_kind<'m>(
    program: &Program<'m>,
    small: bool,
    (place, arms): (PlaceId, &[Arm<'m>]),
    after: Option<&Statement<'m>>,
) -> Option<(usize, Vec<Arm<'m>>)> {
    let Type::State(region) = program.places[place.0].ty else { return None };
    let states: usize = arms.iter().map(|(values, _)| values.len()).sum();
    if states < LONG {
        return None;
    }
    let arms = merged(arms.to_vec());
    let alone = arms.iter().filter(|(values, body)| values.len() == 1 && !body.is_empty()).count();
    let is_test = matches!(after, Some(Statement::Set(_, Expr::Table(..))));
    let few = if small { 2 * arms.len() <= states } else { is_test && alone > 0 && alone * ALONE <= states };
    few.then_some((region, arms))
}

fn block<'m>(program: &mut Program<'m>, small: bool, statements: &mut Vec<Statement<'m>>, common: Option<&Kinds>) {
    let mut new = Vec::with_capacity(statements.len());
    let mut rest = std::mem::take(statements).into_iter().peekable();
    while let Some(mut statement) = rest.next() {
        match &mut statement {
            Statement::Loop { body, .. } | Statement::Part(_, body) => block(program, small, body, common),
            Statement::Match(place, arms, otherwise) => {
                if let Some((region, arms)) = by_kind(program, small, (*place, arms), rest.peek()) {
                    let (place, otherwise) = (*place, std::mem::take(otherwise));
                    let own = Kinds::of(program, region, &arms.iter().map(|(values, _)| values.clone()).list());
                    let kinds = common.unwrap_or(&own);
                    let kind = local(program, kinds.count);
                    let table = kinds.of.iter().map(|(state, kind)| (*state, Value::Int(*kind))).list();
                    let arms = arms.into_iter().map(|(values, body)| (of_states(kinds, &values), body)).list();
                    new.push(Statement::Set(kind, Expr::Table(place, table)));
                    statement = Statement::Match(kind, arms, otherwise);
                }
            }
            _ => {}
        }
        new.push(statement);
    }
    *statements = new;
}

fn of_states(kinds: &Kinds, states: &[Value]) -> Vec<Value> {
    let all: Set<i128> = states.iter().filter_map(|state| kinds.of.get(state).copied()).collect();
    all.iter().map(|kind| Value::Int(*kind)).list()
}

fn local(program: &mut Program<'_>, count: i128) -> PlaceId {
    let list = program.places.len();
    program.places.push(PlaceInfo::local("kind".to_owned(), Type::Kind { list, count }, Initial::Value(Value::Int(0))));
    PlaceId(list)
}

/// All states that a region can have.
fn states(program: &Program<'_>, region: usize) -> Vec<Value> {
    let mut all = program.regions[region].iter().map(|step| Value::Step(Some(*step))).list();
    for other in &program.places {
        if let (Type::State(of), Initial::Value(state)) = (other.ty, other.initial) {
            all.extend((of == region).then_some(state));
        }
    }
    if has(&program.cycle, &|one| matches!(one, Statement::Set(_, Expr::Value(Value::Step(None))))) {
        all.push(Value::Step(None));
    }
    all
}
