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

use std::cell::{Cell, RefCell};

use super::super::{Expr, Initial, PlaceId, Program, Role, Statement, Type, Value};
use super::edits::blocks_mut;
use super::fold::{Known, initial};
use super::uses::{each_written, has};
use super::without_empty;
use crate::list::List;
use crate::sorted::Map;

/// So many statements are looked at for each region.
const EFFORT: usize = 50_000;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.regions.len() < 2 {
        return;
    }
    for region in 0..program.regions.len() {
        let Some(found) = Anew::of(program, region).and_then(Anew::found) else { continue };
        let mut cycle = std::mem::take(&mut program.cycle);
        sweep(&mut cycle, &found);
        without_empty(&mut cycle);
        program.cycle = cycle;
    }
}

/// Takes away the statements that store what is there; of others what they store is told.
fn sweep(statements: &mut Vec<Statement<'_>>, found: &Map<usize, Stored>) {
    let stored: Vec<Option<&Stored>> = statements.iter().map(|one| found.get(&address(one))).list();
    let kept: Vec<bool> = stored.iter().map(|one| one.is_none_or(|one| !one.is_there)).list();
    for (statement, stored) in statements.iter_mut().zip(stored) {
        if let (Statement::Set(_, value), Some(Stored { value: Some(known), .. })) = (&mut *statement, stored) {
            *value = Expr::Value(*known);
        }
        for block in blocks_mut(statement) {
            sweep(block, found);
        }
    }
    let mut kept = kept.into_iter();
    statements.retain(|_| kept.next().unwrap_or(true));
}

/// Which statement of a cycle it is.
fn address(statement: &Statement<'_>) -> usize {
    std::ptr::from_ref(statement).addr()
}

/// What a statement stores, on each way.
struct Stored {
    is_there: bool,
    /// `None` where it is not known, or not the same.
    value: Option<Value>,
}

/// What is known somewhere in a cycle.
#[derive(Clone)]
struct Reached {
    /// The state of the region, and copies of it.
    states: Vec<(PlaceId, Value)>,
    /// By field, `None` where it may hold anything.
    holds: Vec<Option<Value>>,
}

impl Reached {
    fn state(&self, place: PlaceId) -> Option<Value> {
        self.states.iter().find(|(of, _)| *of == place).map(|(_, value)| *value)
    }

    fn put(&mut self, place: PlaceId, value: Option<Value>) {
        self.states.retain(|(of, _)| *of != place);
        if let Some(value) = value {
            let at = self.states.partition_point(|(of, _)| *of < place);
            self.states.insert(at, (place, value));
        }
    }

    /// Holds as well where another one does. Whether it does so less than before.
    fn join(&mut self, other: &Self) -> bool {
        let mut less = false;
        for (one, other) in self.holds.iter_mut().zip(&other.holds) {
            if one.is_some() && one != other {
                *one = None;
                less = true;
            }
        }
        less
    }
}

struct Anew<'p, 'm> {
    program: &'p Program<'m>,
    region: usize,
    state: PlaceId,
    /// And outputs that show fields, which begin anew in each cycle.
    fields: Vec<PlaceId>,
    /// By statement that stores a constant or a field. Empty until all is known.
    found: RefCell<Map<usize, Stored>>,
    is_noted: Cell<bool>,
    /// What leaves each loop around.
    left: RefCell<Vec<Vec<Reached>>>,
    effort: Cell<usize>,
}

impl<'p, 'm> Anew<'p, 'm> {
    fn of(program: &'p Program<'m>, region: usize) -> Option<Self> {
        let state = program.place(Role::State(region))?;
        let mut fields = Vec::new();
        for (index, place) in program.places.iter().enumerate() {
            let is_stored = |one: &Statement<'_>| matches!(one, Statement::Set(to, Expr::Value(_)) if to.0 == index);
            let is_shown = |one: &Statement<'_>| matches!(one, Statement::Set(to, Expr::Place(_)) if to.0 == index);
            let is_asked = match place.role {
                Role::Output(_) if !place.is_field => has(&program.cycle, &is_shown),
                role => place.is_field && is_own(role) && has(&program.cycle, &is_stored),
            };
            if is_asked {
                fields.push(PlaceId(index));
            }
        }
        let (found, left) = (RefCell::default(), RefCell::default());
        let (is_noted, effort) = (Cell::new(false), Cell::new(EFFORT));
        (!fields.is_empty()).then_some(Self { program, region, state, fields, found, is_noted, left, effort })
    }

    /// What is known when a cycle begins, of what was known when the last one ended.
    fn begun(&self, mut way: Reached) -> Reached {
        for (field, holds) in self.fields.iter().zip(&mut way.holds) {
            let place = &self.program.places[field.0];
            if !place.is_field {
                *holds = initial(place);
            }
        }
        way
    }

    /// What the statements store, if that can be found out.
    fn found(self) -> Option<Map<usize, Stored>> {
        let Initial::Value(begins) = self.program.places[self.state.0].initial else { return None };
        let holds = self.fields.iter().map(|field| initial(&self.program.places[field.0])).list();
        let mut all = vec![Reached { states: vec![(self.state, begins)], holds }];
        let mut open = vec![0];
        while let Some(at) = open.pop() {
            for end in self.block(&self.program.cycle, vec![self.begun(all[at].clone())])? {
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
            self.block(&self.program.cycle, vec![self.begun(way)])?;
        }
        Some(self.found.take())
    }

    /// None where the state of the region is not known after it, or it takes too long.
    fn block(&self, statements: &[Statement<'m>], mut ways: Vec<Reached>) -> Option<Vec<Reached>> {
        for statement in statements {
            if ways.is_empty() {
                break;
            }
            self.effort.set(self.effort.get().checked_sub(ways.len())?);
            ways = self.after(statement, ways)?;
        }
        Some(ways)
    }

    fn after(&self, statement: &Statement<'m>, mut ways: Vec<Reached>) -> Option<Vec<Reached>> {
        match statement {
            Statement::Part(_, body) => return self.block(body, ways),
            Statement::Set(place, value) => {
                for way in &mut ways {
                    self.set(statement, (*place, value), way)?;
                }
            }
            Statement::If(condition, then, otherwise) => {
                let may_be = |truth: bool, way: &&Reached| self.holds(condition, way) != Some(!truth);
                let met = ways.iter().filter(|way| may_be(true, way)).cloned().list();
                let unmet = ways.iter().filter(|way| may_be(false, way)).cloned().list();
                return Some(merged(self.block(then, met)?, self.block(otherwise, unmet)?));
            }
            Statement::Match(place, arms, otherwise) => return self.arms(*place, arms, otherwise, &ways),
            Statement::Loop { body, .. } => return self.rounds(body, ways),
            Statement::Break => {
                let mut left = self.left.borrow_mut();
                let around = left.last_mut()?;
                *around = merged(std::mem::take(around), ways);
                return Some(Vec::new());
            }
            other => {
                for way in &mut ways {
                    each_written(std::slice::from_ref(other), &mut |place| self.forget(place, way));
                    way.state(self.state)?;
                }
            }
        }
        Some(merged(Vec::new(), ways))
    }

    fn set(&self, statement: &Statement<'m>, (place, value): (PlaceId, &Expr<'m>), way: &mut Reached) -> Option<()> {
        let known = match value {
            Expr::Value(value) => Some(*value),
            Expr::Place(from) => self.value(*from, way),
            _ => None,
        };
        if let Some(at) = self.fields.iter().position(|field| *field == place) {
            // A number of the user has a type, which it would lose.
            let is_user = matches!(self.program.places[place.0].ty, Type::User(_));
            let is_noted = matches!(value, Expr::Value(_)) || matches!(value, Expr::Place(_)) && !is_user;
            if self.is_noted.get() && is_noted {
                let is_there = known.is_some() && known == way.holds[at];
                let mut found = self.found.borrow_mut();
                let stored = found.or_insert_with(address(statement), || Stored { is_there: true, value: known });
                stored.is_there &= is_there;
                stored.value = stored.value.filter(|value| known == Some(*value));
            }
            way.holds[at] = known;
        } else if matches!(self.program.places[place.0].ty, Type::State(region) if region == self.region) {
            way.put(place, known);
        }
        way.state(self.state).map(|_| ())
    }

    fn arms(
        &self,
        place: PlaceId,
        arms: &[(Vec<Value>, Vec<Statement<'m>>)],
        otherwise: &[Statement<'m>],
        ways: &[Reached],
    ) -> Option<Vec<Reached>> {
        let is_state = matches!(self.program.places[place.0].ty, Type::State(region) if region == self.region);
        let mut all = Vec::new();
        for (values, body) in arms {
            let mut here = Vec::new();
            for way in ways {
                match self.value(place, way) {
                    Some(value) if values.contains(&value) => here.push(way.clone()),
                    Some(_) => {}
                    None => {
                        let mut way = way.clone();
                        if let (true, [value]) = (is_state, &values[..]) {
                            way.put(place, Some(*value));
                        }
                        here.push(way);
                    }
                }
            }
            all = merged(all, self.block(body, merged(Vec::new(), here))?);
        }
        let is_other = |way: &&Reached| {
            self.value(place, way).is_none_or(|value| !arms.iter().any(|(values, _)| values.contains(&value)))
        };
        let other = ways.iter().filter(is_other).cloned().list();
        Some(merged(all, self.block(otherwise, other)?))
    }

    /// Until another round brings nothing new.
    fn rounds(&self, body: &[Statement<'m>], ways: Vec<Reached>) -> Option<Vec<Reached>> {
        self.left.borrow_mut().push(Vec::new());
        let mut begins = ways;
        let mut all = begins.clone();
        while !begins.is_empty() {
            let mut new = Vec::new();
            for end in self.block(body, begins)? {
                match all.iter_mut().find(|way| way.states == end.states) {
                    Some(way) => {
                        if way.join(&end) {
                            new.push(way.clone());
                        }
                    }
                    None => {
                        all.push(end.clone());
                        new.push(end);
                    }
                }
            }
            begins = new;
        }
        let left = self.left.borrow_mut().pop().unwrap_or_default();
        Some(merged(all, left))
    }

    fn forget(&self, place: PlaceId, way: &mut Reached) {
        way.put(place, None);
        if let Some(at) = self.fields.iter().position(|field| *field == place) {
            way.holds[at] = None;
        }
    }

    fn value(&self, place: PlaceId, way: &Reached) -> Option<Value> {
        let at = self.fields.iter().position(|field| *field == place);
        at.and_then(|at| way.holds[at]).or_else(|| way.state(place))
    }

    /// Whether a condition holds, if that is known.
    fn holds(&self, condition: &Expr<'m>, way: &Reached) -> Option<bool> {
        let value = |place: PlaceId| self.value(place, way);
        let known =
            Known { places: &self.program.places, value: &value, copy: &|_| None, among: &|_| None, now: &|_| false };
        match known.fold(condition) {
            Expr::Value(Value::Bool(holds)) => Some(holds),
            _ => None,
        }
    }
}

/// What nobody but the cycle writes, and what somebody looks at other than the deadline.
fn is_own(role: Role) -> bool {
    matches!(
        role,
        Role::FlipFlop(..)
            | Role::Output(_)
            | Role::Var(_)
            | Role::SetBy(..)
            | Role::TimerInput(..)
            | Role::TimerStage(..)
            | Role::Active(_)
            | Role::Held(_)
            | Role::Acted(_)
            | Role::Edge(_)
            | Role::ActionEdge(_)
    )
}

/// Vec<Reached> with the same states are one, of which is known what is known of both.
fn merged(mut all: Vec<Reached>, ways: Vec<Reached>) -> Vec<Reached> {
    for way in ways {
        match all.iter_mut().find(|one| one.states == way.states) {
            Some(one) => _ = one.join(&way),
            None => all.push(way),
        }
    }
    all
}
