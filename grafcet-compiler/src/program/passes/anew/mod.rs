//! What a field is known to hold is not stored in it once more, nor shown by an output that begins with it.
//!
//! ```text
//! match state                                     match state
//!   Wait:                                           Wait:
//!     if go:                                          if go:
//!       state = Run                                     state = Run
//!       belt = true                        ->           belt = true
//!   Run:                                            Run:
//!     if 300ms are over: state = Out                  if 300ms are over: state = Out
//!     else: belt = true
//! ```
//!
//! For each region: what the fields hold where a cycle begins in one of its states, from the first cycle on, whatever the other regions do.
//!
//! Needs: several regions (of one, `split` knows that); states are entered by the ways of the cycle alone.

mod index;
mod reached;

use std::cell::{Cell, RefCell};

use self::index::Index;
use self::reached::{Reached, merged};
use super::super::{Arm, Expr, Initial, PlaceId, Program, Role, Statement, Type, Value};
use super::edits::blocks_mut;
use super::fold::{Known, initial};
use super::uses::{each_read, each_written};
use super::without_empty;
use crate::list::{List, PushAll};
use crate::sorted::Map;

/// So many statements are looked at for each region.
const EFFORT: usize = 20_000;

/// And for all of them.
const IN_ALL: usize = 60_000;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 {
        return;
    }
    let mut stored = found(program).into_iter();
    let mut cycle = std::mem::take(&mut program.cycle);
    sweep(&mut cycle, &mut stored);
    without_empty(&mut cycle);
    program.cycle = cycle;
}

/// By statement: what it stores, as far as one of the regions tells.
fn found(program: &Program<'_>) -> Vec<Option<Stored>> {
    let index = Index::of(program);
    let stored = vec![None; index.sizes.len()];
    let mut all = Whole { program, index, stored, left: IN_ALL };
    let mut fails = vec![false; program.regions.len()];
    let mut is_followed = vec![false; program.places.len()];
    for region in 0..program.regions.len() {
        let fields = all.index.fields(program, region, (&fails, &is_followed));
        let Some(anew) = Anew::of(&all, region, &fields) else { continue };
        let found = anew.found();
        all.left -= EFFORT.min(all.left) - anew.effort.get();
        let Some(found) = found else {
            fails[region] = true;
            continue;
        };
        for field in fields {
            is_followed[field.0] = true;
        }
        all.add(found);
    }
    all.stored
}

/// Takes away the statements that store what is there; of others what they store is told.
fn sweep(statements: &mut Vec<Statement<'_>>, stored: &mut std::vec::IntoIter<Option<Stored>>) {
    let mut kept = Vec::with_capacity(statements.len());
    for mut statement in std::mem::take(statements) {
        let stored_here = stored.next().flatten();
        if let (Statement::Set(_, value), Some(Stored { value: Some(known), .. })) = (&mut statement, stored_here) {
            *value = Expr::Value(known);
        }
        for block in blocks_mut(&mut statement) {
            sweep(block, stored);
        }
        if stored_here.is_none_or(|one| !one.is_there) {
            kept.push(statement);
        }
    }
    *statements = kept;
}

/// What a statement stores, on each way.
#[derive(Clone, Copy)]
struct Stored {
    is_there: bool,
    /// `None` where it is not known, or not the same.
    value: Option<Value>,
}

/// The program, and what the regions looked at so far have told.
struct Whole<'p, 'm> {
    program: &'p Program<'m>,
    index: Index,
    /// By statement. What stores nothing new counts as taken away.
    stored: Vec<Option<Stored>>,
    /// So many statements may still be looked at.
    left: usize,
}

impl Whole<'_, '_> {
    /// What a region tells holds whatever the others do.
    fn add(&mut self, found: Vec<Option<Stored>>) {
        for (all, found) in self.stored.iter_mut().zip(found) {
            let Some(found) = found else { continue };
            let known = all.get_or_insert(found);
            known.is_there |= found.is_there;
            known.value = known.value.or(found.value);
        }
    }
}

/// What is followed for one region.
struct Anew<'w, 'p, 'm> {
    whole: &'w Whole<'p, 'm>,
    region: usize,
    state: PlaceId,
    /// And outputs that show fields, which begin anew in each cycle.
    fields: &'w [PlaceId],
    /// By place: which of the fields it is.
    numbers: Vec<Option<usize>>,
    /// By statement: whether it, or one within it, writes what is followed.
    matters: Vec<bool>,
    /// By statement that stores a constant or a field. Nothing until all is known.
    found: RefCell<Vec<Option<Stored>>>,
    is_noted: Cell<bool>,
    /// What leaves each loop around.
    left: RefCell<Vec<Vec<Reached>>>,
    /// So many statements may still be looked at.
    effort: Cell<usize>,
}

impl<'w, 'p, 'm> Anew<'w, 'p, 'm> {
    fn of(whole: &'w Whole<'p, 'm>, region: usize, fields: &'w [PlaceId]) -> Option<Self> {
        let program = whole.program;
        let state = program.place(Role::State(region))?;
        let mut numbers = vec![None; program.places.len()];
        for (number, field) in fields.iter().enumerate() {
            numbers[field.0] = Some(number);
        }
        let is_gone = |statement: usize| whole.stored[statement].is_some_and(|stored| stored.is_there);
        let matters = whole.index.matters(program, region, fields, &is_gone);
        let (found, left) = (RefCell::new(vec![None; matters.len()]), RefCell::default());
        let (is_noted, effort) = (Cell::new(false), Cell::new(EFFORT.min(whole.left)));
        let is_any = !fields.is_empty();
        is_any.then_some(Self { whole, region, state, fields, numbers, matters, found, is_noted, left, effort })
    }

    /// What is known when a cycle begins, of what was known when the last one ended.
    fn begun(&self, mut way: Reached) -> Reached {
        for (field, holds) in self.fields.iter().zip(&mut way.holds) {
            let place = &self.whole.program.places[field.0];
            if !place.is_field {
                *holds = initial(place);
            }
        }
        way
    }

    /// What the statements store, if that can be found out.
    fn found(&self) -> Option<Vec<Option<Stored>>> {
        let Initial::Value(begins) = self.whole.program.places[self.state.0].initial else { return None };
        let holds = self.fields.iter().map(|field| initial(&self.whole.program.places[field.0])).list();
        let mut all = vec![Reached { states: vec![(self.state, begins)], holds }];
        let mut open = vec![0];
        while let Some(at) = open.pop() {
            for end in self.block(&self.whole.program.cycle, 0, vec![self.begun(all[at].clone())])? {
                let state = end.state(self.state)?;
                match all.iter().position(|way| way.state(self.state) == Some(state)) {
                    Some(at) => {
                        if all[at].join(&end) && !open.contains(&at) {
                            open.push(at);
                        }
                    }
                    None => {
                        open.push(all.len());
                        all.push(Reached { states: vec![(self.state, state)], holds: end.holds });
                    }
                }
            }
        }
        self.is_noted.set(true);
        for way in all {
            self.block(&self.whole.program.cycle, 0, vec![self.begun(way)])?;
        }
        Some(self.found.take())
    }

    /// None where the state of the region is not known after it, or it takes too long.
    fn block(&self, statements: &[Statement<'m>], mut next: usize, mut ways: Vec<Reached>) -> Option<Vec<Reached>> {
        for statement in statements {
            let number = next;
            next += self.whole.index.sizes[number];
            if ways.is_empty() {
                break;
            }
            if self.matters[number] {
                self.effort.set(self.effort.get().checked_sub(ways.len())?);
                ways = self.after(statement, number, ways)?;
            }
        }
        Some(ways)
    }

    /// After the statement of that number.
    fn after(&self, statement: &Statement<'m>, number: usize, mut ways: Vec<Reached>) -> Option<Vec<Reached>> {
        let within = number + 1;
        match statement {
            Statement::Part(_, body) => return self.block(body, within, ways),
            Statement::Set(place, value) => {
                for way in &mut ways {
                    self.set(number, (*place, value), way)?;
                }
                if !self.is_state(*place) {
                    return Some(ways);
                }
            }
            Statement::If(condition, then, otherwise) => {
                let may_be = |truth: bool, way: &&Reached| self.holds(condition, way) != Some(!truth);
                let met = ways.iter().filter(|way| may_be(true, way)).cloned().list();
                let unmet = ways.iter().filter(|way| may_be(false, way)).cloned().list();
                let other = within + self.whole.index.size(within, then);
                let mut ends = self.block(then, within, met)?;
                ends.push_all(self.block(otherwise, other, unmet)?);
                return Some(merged(ends));
            }
            Statement::Match(place, arms, otherwise) => return self.arms((*place, number), (arms, otherwise), &ways),
            Statement::Loop { body, .. } => return self.rounds(body, within, ways),
            Statement::Break => {
                let mut left = self.left.borrow_mut();
                let around = left.last_mut()?;
                around.push_all(ways);
                *around = merged(std::mem::take(around));
                return Some(Vec::new());
            }
            other => {
                for way in &mut ways {
                    each_written(std::slice::from_ref(other), &mut |place| self.forget(place, way));
                    way.state(self.state)?;
                }
            }
        }
        Some(merged(ways))
    }

    fn set(&self, number: usize, (place, value): (PlaceId, &Expr<'m>), way: &mut Reached) -> Option<()> {
        let by_others = self.whole.stored[number].and_then(|stored| stored.value);
        let known = match value {
            _ if by_others.is_some() => by_others,
            Expr::Value(value) => Some(*value),
            Expr::Place(from) => self.value(*from, way),
            _ => None,
        };
        if let Some(at) = self.numbers[place.0] {
            // A number of the user has a type, which it would lose.
            let is_user = matches!(self.whole.program.places[place.0].ty, Type::User(_));
            let is_noted = matches!(value, Expr::Value(_)) || matches!(value, Expr::Place(_)) && !is_user;
            if self.is_noted.get() && is_noted {
                let is_there = known.is_some() && known == way.holds[at];
                let mut found = self.found.borrow_mut();
                let stored = found[number].get_or_insert(Stored { is_there: true, value: known });
                stored.is_there &= is_there;
                stored.value = stored.value.filter(|value| known == Some(*value));
            }
            way.holds[at] = known;
        } else if self.is_state(place) {
            way.put(place, known);
        }
        way.state(self.state).map(|_| ())
    }

    fn arms(
        &self,
        (place, number): (PlaceId, usize),
        (arms, otherwise): (&[Arm<'m>], &[Statement<'m>]),
        ways: &[Reached],
    ) -> Option<Vec<Reached>> {
        let index = self.whole.index.matches.get(&number)?;
        let is_state = self.is_state(place);
        let mut here: Map<usize, Vec<Reached>> = Map::new();
        for way in ways {
            if let Some(value) = self.value(place, way) {
                let arm = index.arms.get(&value).copied().unwrap_or(arms.len());
                here.or_insert_with(arm, Vec::new).push(way.clone());
                continue;
            }
            for at in 0..=arms.len() {
                let mut way = way.clone();
                match arms.get(at) {
                    Some((values, _)) if is_state && values.len() == 1 => way.put(place, Some(values[0])),
                    _ => {}
                }
                here.or_insert_with(at, Vec::new).push(way);
            }
        }
        let mut ends = Vec::new();
        for (arm, here) in here {
            let body = arms.get(arm).map_or(otherwise, |(_, body)| body);
            ends.push_all(self.block(body, index.firsts[arm], merged(here))?);
        }
        Some(merged(ends))
    }

    /// Until another round brings nothing new.
    fn rounds(&self, body: &[Statement<'m>], within: usize, ways: Vec<Reached>) -> Option<Vec<Reached>> {
        self.left.borrow_mut().push(Vec::new());
        let mut begins = ways;
        let mut all = merged(begins.clone());
        while !begins.is_empty() {
            let mut new = Vec::new();
            for end in self.block(body, within, begins)? {
                match all.binary_search_by(|way| way.states.cmp(&end.states)) {
                    Ok(at) => {
                        if all[at].join(&end) {
                            new.push(all[at].clone());
                        }
                    }
                    Err(at) => {
                        all.insert(at, end.clone());
                        new.push(end);
                    }
                }
            }
            begins = new;
        }
        let left = self.left.borrow_mut().pop().unwrap_or_default();
        all.push_all(left);
        Some(merged(all))
    }

    /// It holds the state of the region, or a copy of it.
    fn is_state(&self, place: PlaceId) -> bool {
        matches!(self.whole.program.places[place.0].ty, Type::State(region) if region == self.region)
    }

    fn forget(&self, place: PlaceId, way: &mut Reached) {
        way.put(place, None);
        if let Some(at) = self.numbers[place.0] {
            way.holds[at] = None;
        }
    }

    fn value(&self, place: PlaceId, way: &Reached) -> Option<Value> {
        self.numbers[place.0].and_then(|at| way.holds[at]).or_else(|| way.state(place))
    }

    /// Whether a condition holds, if that is known.
    fn holds(&self, condition: &Expr<'m>, way: &Reached) -> Option<bool> {
        let mut is_told = false;
        each_read(condition, &mut |place| is_told |= self.value(place, way).is_some());
        if !is_told {
            return None;
        }
        let value = |place: PlaceId| self.value(place, way);
        let known = Known {
            places: &self.whole.program.places,
            value: &value,
            copy: &|_| None,
            among: &|_| None,
            now: &|_| false,
        };
        match known.fold(condition) {
            Expr::Value(Value::Bool(holds)) => Some(holds),
            _ => None,
        }
    }
}
