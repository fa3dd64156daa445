//! In which states a statement matters: so each state is looked at with the statements that concern it, and not with all of them.
//!
//! A truth that is false in front of a list, as what begins each cycle so, can be true after it only in some states, by what it is set from. What would only set such a truth to
//! false in all other states, or do nothing there, need not be looked at for them.

use super::super::{Expr, PlaceId, PlaceInfo, Statement, Value};
use super::fold::initial;
use super::uses::{each_written, is_pure, is_written_in, mentions, writes_to};
use crate::model::{Id, StepId};
use crate::sorted::Set;

/// The states that a region may have, the first cycle among them.
#[derive(Clone)]
pub(super) struct States {
    pub(super) all: Vec<Value>,
    by_step: Vec<Option<usize>>,
}

impl States {
    pub(super) fn of(begin: Option<StepId>, steps: &[StepId]) -> Self {
        let (mut all, mut by_step) = (vec![Value::Start(begin)], Vec::new());
        for step in steps {
            by_step.resize(by_step.len().max(step.index() + 1), None);
            by_step[step.index()] = Some(all.len());
            all.push(Value::Step(Some(*step)));
        }
        all.push(Value::Step(None));
        Self { all, by_step }
    }

    /// Which of them it is.
    pub(super) fn of_step(&self, step: StepId) -> Option<usize> {
        self.by_step.get(step.index()).copied().flatten()
    }

    /// Which of them a value between two cycles is.
    pub(super) fn point(&self, value: Value) -> Option<usize> {
        match value {
            Value::Step(Some(step)) => self.of_step(step),
            Value::Step(None) => Some(self.all.len() - 1),
            _ => None,
        }
    }
}

/// Some of the points: point 0 is the first cycle, the others are states.
#[derive(Clone, PartialEq, Eq)]
pub(super) enum Points {
    All,
    These(Set<usize>),
}

impl Points {
    fn and(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::All, other) | (other, Self::All) => other.clone(),
            (Self::These(a), Self::These(b)) => {
                let (few, many) = if a.len() < b.len() { (a, b) } else { (b, a) };
                let mut both = few.clone();
                both.retain(|point| many.contains(point));
                Self::These(both)
            }
        }
    }

    fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::All, _) | (_, Self::All) => Self::All,
            (Self::These(a), Self::These(b)) => {
                let (few, mut many) = if a.len() < b.len() { (a, b) } else { (b, a) };
                many.extend(few.iter().copied());
                Self::These(many)
            }
        }
    }
}

/// Where something matters: by the state before the evolution, and by that after it.
#[derive(Clone)]
pub(super) struct Support {
    pub(super) before: Points,
    pub(super) after: Points,
}

impl Support {
    fn all() -> Self {
        Self { before: Points::All, after: Points::All }
    }

    fn none() -> Self {
        Self { before: Points::These(Set::new()), after: Points::These(Set::new()) }
    }

    fn is_none(&self) -> bool {
        let empty = |points: &Points| matches!(points, Points::These(points) if points.is_empty());
        empty(&self.before) || empty(&self.after)
    }

    fn and(&self, other: &Self) -> Self {
        Self { before: self.before.and(&other.before), after: self.after.and(&other.after) }
    }

    fn or(self, other: Self) -> Self {
        if self.is_none() {
            return other;
        }
        if other.is_none() {
            return self;
        }
        Self { before: self.before.or(other.before), after: self.after.or(other.after) }
    }
}

/// The statements of a list by the states for which they matter, each list in order.
pub(super) struct Index {
    pub(super) always: Vec<usize>,
    pub(super) before: Vec<Vec<usize>>,
    pub(super) after: Vec<Vec<usize>>,
    /// The state is not written after this statement.
    pub(super) last: usize,
    /// By place: a truth that can only be true in some states, set on the way to the next state.
    pub(super) forks: Vec<bool>,
}

impl Index {
    pub(super) fn of(
        places: &[PlaceInfo<'_>],
        list: &[Statement<'_>],
        state: PlaceId,
        first: Option<PlaceId>,
        assumed: &[bool],
        points: &States,
    ) -> Option<Self> {
        let end = list.iter().rposition(|statement| writes(statement, state))?;
        let mut sparse = Sparse::new(places, state, first, assumed, points);
        let mut index = sparse.index(list, end);
        index.forks = deciding(places, &list[..=end], &[state]);
        for (place, forks) in index.forks.iter_mut().enumerate() {
            *forks &= matches!(&sparse.may[place], Some(Support { before: Points::These(_), .. }));
        }
        Some(index)
    }
}

impl Index {
    /// The same of one of several regions, whose states are written up to the statement `end`; the truths that are false in front of it are `assumed`, and the state
    /// is copied to some places.
    pub(super) fn of_region(
        places: &[PlaceInfo<'_>],
        list: &[Statement<'_>],
        (state, copies): (PlaceId, Vec<bool>),
        assumed: &[bool],
        points: &States,
        end: usize,
    ) -> Self {
        let mut sparse = Sparse::new(places, state, None, assumed, points);
        sparse.copies = copies;
        sparse.index(list, end)
    }

    /// All statements in all states.
    pub(super) fn whole(places: usize, list: usize, points: &States) -> Self {
        let none = vec![Vec::new(); points.all.len()];
        Self { always: (0..list).collect(), before: none.clone(), after: none, last: 0, forks: vec![false; places] }
    }
}

/// Whether it writes the place and goes on.
fn writes(statement: &Statement<'_>, place: PlaceId) -> bool {
    if let Statement::If(_, leaving, otherwise) = statement {
        if matches!(leaving.last(), Some(Statement::Break)) {
            return is_written_in(otherwise, place);
        }
    }
    writes_to(statement, place)
}

/// The locals on which the state that is written depends, the user's conditions not looked into.
pub(super) fn deciding(places: &[PlaceInfo<'_>], list: &[Statement<'_>], states: &[PlaceId]) -> Vec<bool> {
    let mut found = vec![false; places.len()];
    for state in states {
        found[state.0] = true;
    }
    for statement in list.iter().rev() {
        let mut asked = Vec::new();
        decides(statement, &mut asked, &mut found);
    }
    for (place, found) in places.iter().zip(&mut found) {
        *found &= !place.is_field;
    }
    found
}

fn decides<'s, 'm>(statement: &'s Statement<'m>, asked: &mut Vec<&'s Expr<'m>>, found: &mut [bool]) {
    match statement {
        Statement::Set(place, value) if found[place.0] => {
            for expr in asked.iter().copied().chain([value]) {
                plainly_read(expr, found);
            }
        }
        Statement::If(condition, then, otherwise) => {
            asked.push(condition);
            for statement in then.iter().chain(otherwise).rev() {
                decides(statement, asked, found);
            }
            asked.pop();
        }
        _ => {}
    }
}

fn plainly_read(expr: &Expr<'_>, found: &mut [bool]) {
    match expr {
        Expr::Place(place) => found[place.0] = true,
        Expr::Not(inner) => plainly_read(inner, found),
        Expr::All(parts) | Expr::Any(parts) => parts.iter().for_each(|part| plainly_read(part, found)),
        _ => {}
    }
}

struct Sparse<'s, 'm> {
    places: &'s [PlaceInfo<'m>],
    state: PlaceId,
    first: Option<PlaceId>,
    points: &'s States,
    /// The state of the first cycle.
    begin: Option<Value>,
    /// By place: it holds the state before the evolution.
    copies: Vec<bool>,
    /// By place: a truth that begins as false, and where it may be true so far.
    may: Vec<Option<Support>>,
    /// Nothing has written the state yet.
    is_before: bool,
    /// Nothing will write it any more.
    is_after: bool,
    /// How many conditions stand around the statement.
    depth: usize,
}

impl<'s, 'm> Sparse<'s, 'm> {
    fn new(
        places: &'s [PlaceInfo<'m>],
        state: PlaceId,
        first: Option<PlaceId>,
        assumed: &[bool],
        points: &'s States,
    ) -> Self {
        let mut may = Vec::with_capacity(places.len());
        for (place, assumed) in places.iter().zip(assumed) {
            let is_false = *assumed && initial(place) == Some(Value::Bool(false));
            may.push(is_false.then(Support::none));
        }
        Self {
            places,
            state,
            first,
            points,
            begin: initial(&places[state.0]),
            copies: vec![false; places.len()],
            may,
            is_before: true,
            is_after: false,
            depth: 0,
        }
    }

    /// The statements by where they matter; no state is written after the statement `end`.
    fn index(&mut self, list: &[Statement<'m>], end: usize) -> Index {
        let none = vec![Vec::new(); self.points.all.len()];
        let forks = vec![false; self.places.len()];
        let mut index = Index { always: Vec::new(), before: none.clone(), after: none, last: end, forks };
        let start = list.iter().position(|statement| writes(statement, self.state)).unwrap_or(list.len());
        for (at, statement) in list.iter().enumerate() {
            self.is_before = at < start;
            self.is_after = at > end;
            let support = self.visit(statement, &Support::all());
            match (support.before, support.after) {
                (Points::All, Points::All) => index.always.push(at),
                (Points::These(few), Points::These(many)) if few.len() > many.len() => {
                    many.iter().for_each(|point| index.after[*point].push(at));
                }
                (Points::These(points), _) => points.iter().for_each(|point| index.before[*point].push(at)),
                (Points::All, Points::These(points)) => points.iter().for_each(|point| index.after[*point].push(at)),
            }
        }
        index
    }

    /// Where the expression may be true.
    fn holds(&self, expr: &Expr<'m>) -> Support {
        match expr {
            Expr::Value(Value::Bool(false)) => Support::none(),
            Expr::Place(place) if Some(*place) == self.first => {
                let mut points = Set::new();
                points.insert(0);
                Support { before: Points::These(points), after: Points::All }
            }
            Expr::Place(place) => self.may[place.0].clone().unwrap_or_else(Support::all),
            Expr::Is(place, steps) => {
                let mut points = Set::new();
                for step in steps {
                    points.extend(self.points.of_step(*step));
                }
                let here = *place == self.state;
                if here && self.is_after {
                    return Support { before: Points::All, after: Points::These(points) };
                }
                if !(self.copies[place.0] || here && self.is_before) {
                    return Support::all();
                }
                let begins = |step| self.begin == Some(Value::Step(Some(step)));
                if steps.iter().copied().any(begins) {
                    points.insert(0);
                }
                Support { before: Points::These(points), after: Points::All }
            }
            Expr::All(parts) => {
                let mut all = Support::all();
                for part in parts {
                    all = all.and(&self.holds(part));
                    // What stands after does not keep it from being asked.
                    if !is_pure(part) {
                        break;
                    }
                }
                all
            }
            Expr::Any(parts) => parts.iter().fold(Support::none(), |any, part| any.or(self.holds(part))),
            _ => Support::all(),
        }
    }

    /// Where a place may get another value than its own by an expression that reads it.
    fn changes(&self, place: PlaceId, expr: &Expr<'m>) -> Support {
        match expr {
            Expr::Place(read) if *read == place => Support::none(),
            Expr::All(parts) => {
                let part = |any: Support, part: &Expr<'m>| match part {
                    Expr::Not(inner) if !mentions(inner, place) => any.or(self.holds(inner)),
                    part if mentions(part, place) => any.or(self.changes(place, part)),
                    _ => Support::all(),
                };
                parts.iter().fold(Support::none(), part)
            }
            Expr::Any(parts) => {
                let part = |any: Support, part: &Expr<'m>| match part {
                    part if mentions(part, place) => any.or(self.changes(place, part)),
                    part => any.or(self.holds(part)),
                };
                parts.iter().fold(Support::none(), part)
            }
            _ => Support::all(),
        }
    }

    /// Where a statement matters.
    fn visit(&mut self, statement: &Statement<'m>, guard: &Support) -> Support {
        match statement {
            Statement::Set(place, value) => {
                if self.is_before && matches!(value, Expr::Place(read) if *read == self.state) {
                    self.copies[place.0] = !self.places[place.0].is_field && self.depth == 0;
                } else {
                    self.copies[place.0] = false;
                }
                let adds = mentions(value, *place);
                let may = if adds { self.changes(*place, value) } else { self.holds(value) }.and(guard);
                let matters = match &self.may[place.0] {
                    _ if adds => may.clone(),
                    Some(before) => before.clone().or(may.clone()).and(guard),
                    None => guard.clone(),
                };
                if let Some(before) = self.may[place.0].take() {
                    self.may[place.0] = Some(before.or(may));
                }
                matters
            }
            Statement::If(condition, then, otherwise) => {
                let inside = self.holds(condition).and(guard);
                let mut matters = if is_pure(condition) { Support::none() } else { inside.clone() };
                self.depth += 1;
                for statement in then {
                    matters = matters.or(self.visit(statement, &inside));
                }
                for statement in otherwise {
                    matters = matters.or(self.visit(statement, guard));
                }
                self.depth -= 1;
                matters
            }
            other => {
                each_written(std::slice::from_ref(other), &mut |place| {
                    self.copies[place.0] = false;
                    self.may[place.0] = self.may[place.0].take().map(|_| Support::all());
                });
                guard.clone()
            }
        }
    }
}
