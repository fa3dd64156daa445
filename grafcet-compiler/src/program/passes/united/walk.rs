//! A cycle gone through with the states that several regions may have together at each place of it, and written anew for one place that tells all of them.

mod asked;
mod copied;

use super::super::super::{Arm, Comparison, Expr, PlaceId, Program, Statement, Value};
use super::super::edits::rewrite;
use super::super::uses::{Effects, is_pure, writes_to};
use super::{Group, Joint, Names};
use crate::sorted::Set;
use copied::Copied;
use std::cell::Cell;

pub(super) struct JointWalk<'w, 'm> {
    group: &'w Group,
    program: &'w Program<'m>,
    names: Option<&'w Names>,
    /// A truth that the states alone decide, as whether the cycle is the first one.
    truth: Option<PlaceId>,
    /// Those that the place holds at some time.
    met: Set<Joint>,
    /// With what each loop around is left.
    left: Vec<Set<Point>>,
    /// The copies of the states that have been made on every way to here.
    copied: Vec<Copied>,
    /// How often states have been written.
    writes: usize,
    /// How many blocks stand around this one.
    depth: usize,
    fails: Cell<bool>,
}

/// The states, and the truth that has been found of them.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Point {
    joint: Joint,
    truth: bool,
}

pub(super) struct Rewritten<'m> {
    pub(super) cycle: Vec<Statement<'m>>,
    pub(super) met: Set<Joint>,
}

impl<'w, 'm> JointWalk<'w, 'm> {
    pub(super) fn of(group: &'w Group, program: &'w Program<'m>, names: Option<&'w Names>) -> Self {
        let truth = truth(group, program);
        let (met, left, copied) = (Set::new(), Vec::new(), Vec::new());
        Self { group, program, names, truth, met, left, copied, writes: 0, depth: 0, fails: Cell::new(false) }
    }

    /// The whole cycle, if it leads from what the states are between two cycles to the same.
    pub(super) fn through(
        group: &'w Group,
        program: &'w Program<'m>,
        names: Option<&'w Names>,
    ) -> Option<Rewritten<'m>> {
        let mut walk = Self::of(group, program, names);
        let begin = walk.anything();
        for point in &begin {
            walk.met.insert(point.joint.clone());
        }
        let (cycle, end) = walk.block(&program.cycle, begin);
        let returns = end.iter().all(|point| group.rest.contains(&point.joint));
        (returns && !walk.fails.get()).then_some(Rewritten { cycle, met: walk.met })
    }

    /// What the states are between two cycles.
    pub(super) fn anything(&self) -> Set<Point> {
        let mut all = Set::new();
        for joint in self.group.rest.iter().chain([&self.group.begin]) {
            all.insert(Point { joint: joint.clone(), truth: false });
        }
        all
    }

    fn side(&self, place: PlaceId) -> Option<usize> {
        self.group.places.iter().position(|one| *one == place)
    }

    fn fail(&self) {
        self.fails.set(true);
    }

    fn block(&mut self, statements: &[Statement<'m>], mut now: Set<Point>) -> (Vec<Statement<'m>>, Set<Point>) {
        let mut new = Vec::new();
        // Where the states have been written and are not yet stored: before which statement, and what they were.
        let mut open: Option<(usize, Set<Point>)> = None;
        let mut at = 0;
        while let Some(statement) = statements.get(at) {
            if now.is_empty() || self.fails.get() {
                break;
            }
            if let Some(back) = self.taken_back(&statements[at..]) {
                self.store(&mut open, &now, &mut new);
                self.writes += 1;
                now = back.now;
                new.push(back.statement);
                at += back.statements;
                continue;
            }
            at += 1;
            if let Statement::Set(place, value) = statement {
                if let Some(side) = self.side(*place) {
                    self.writes += 1;
                    let Expr::Value(value @ (Value::Step(_) | Value::Start(_))) = value else {
                        self.fail();
                        break;
                    };
                    let before = open.map_or_else(|| now.clone(), |(_, before)| before);
                    open = Some((new.len(), before));
                    now = with(&now, |point| point.joint[side] = *value);
                    continue;
                }
            }
            if open.is_some() && self.touches(statement) {
                self.store(&mut open, &now, &mut new);
            }
            now = self.statement(statement, now, &mut new);
        }
        self.store(&mut open, &now, &mut new);
        (new, now)
    }

    /// A block within the one that is gone through, of which those after it do not know whether it is on their way.
    fn within(&mut self, statements: &[Statement<'m>], now: Set<Point>) -> (Vec<Statement<'m>>, Set<Point>) {
        self.depth += 1;
        let found = self.block(statements, now);
        self.depth -= 1;
        self.copied.retain(|copied| copied.depth <= self.depth);
        found
    }

    /// Whether a statement has to know the states, or hands them on.
    fn touches(&self, statement: &Statement<'m>) -> bool {
        let effects = Effects::of(statement);
        let here = |places: &Set<PlaceId>| self.group.places.iter().any(|place| places.contains(place));
        effects.leaves || here(&effects.reads) || here(&effects.writes)
    }

    fn store(&mut self, open: &mut Option<(usize, Set<Point>)>, now: &Set<Point>, new: &mut Vec<Statement<'m>>) {
        let Some((at, before)) = open.take() else { return };
        let joints = |points: &Set<Point>| {
            let mut all = Set::new();
            all.extend(points.iter().map(|point| point.joint.clone()));
            all
        };
        let after = joints(now);
        let [one] = &after[..] else { return self.fail() };
        self.met.insert(one.clone());
        if joints(&before)[..] != after[..] {
            new.insert(at, Statement::Set(self.group.places[0], Expr::Value(self.name(one))));
        }
    }

    fn name(&self, joint: &Joint) -> Value {
        let found = self.names.map(|names| names.get(joint).copied());
        found.unwrap_or(Some(Value::Step(None))).unwrap_or_else(|| {
            self.fail();
            Value::Step(None)
        })
    }

    fn statement(&mut self, one: &Statement<'m>, now: Set<Point>, new: &mut Vec<Statement<'m>>) -> Set<Point> {
        match one {
            Statement::Part(name, body) => {
                let (body, after) = self.block(body, now);
                new.push(Statement::Part(name, body));
                after
            }
            Statement::Set(place, Expr::Place(of)) if self.group.copy(*place).is_some() && self.side(*of).is_some() => {
                new.push(Statement::Set(*place, Expr::Place(self.group.places[0])));
                self.copy(*place, &now);
                now
            }
            Statement::Set(place, value) => {
                self.forget(*place);
                new.push(Statement::Set(*place, self.expr(value, &now)));
                if self.truth != Some(*place) {
                    return now;
                }
                let holds = |point: &Point| self.may(value, true, point);
                let mut after = Set::new();
                after.extend(now.iter().map(|point| Point { joint: point.joint.clone(), truth: holds(point) }));
                after
            }
            Statement::If(condition, then, otherwise) => self.branches(condition, then, otherwise, &now, new),
            Statement::Match(place, arms, otherwise) => match self.side(*place) {
                Some(side) => self.states(side, arms, otherwise, &now, new),
                None => {
                    if self.group.copy(*place).is_some() {
                        self.fail();
                    }
                    let (mut kept, mut after) = (Vec::new(), Set::new());
                    for (values, body) in arms {
                        let (body, end) = self.within(body, now.clone());
                        kept.push((values.clone(), body));
                        after.extend(end);
                    }
                    let (otherwise, end) = self.within(otherwise, now);
                    after.extend(end);
                    new.push(Statement::Match(*place, kept, otherwise));
                    after
                }
            },
            Statement::Loop { rounds, body } => {
                let (body, after) = self.rounds(body, now);
                new.push(Statement::Loop { rounds: *rounds, body });
                after
            }
            Statement::Break => {
                if let Some(left) = self.left.last_mut() {
                    left.extend(now);
                }
                new.push(Statement::Break);
                Set::new()
            }
            Statement::Run(_) | Statement::Call(..) => {
                let mut one = [one.clone()];
                rewrite(&mut one, &mut |expr| self.expr(expr, &now));
                new.extend(one);
                now
            }
            Statement::Mark(_) | Statement::Fence(_) => {
                new.push(one.clone());
                now
            }
        }
    }

    fn branches(
        &mut self,
        condition: &Expr<'m>,
        then: &[Statement<'m>],
        otherwise: &[Statement<'m>],
        now: &Set<Point>,
        new: &mut Vec<Statement<'m>>,
    ) -> Set<Point> {
        let ways = [true, false].map(|holds| only(now, |point| self.may(condition, holds, point)));
        let told = is_pure(condition) && ways.iter().any(|way| way.is_empty());
        let asked = self.expr(condition, now);
        let [then, otherwise] =
            [(then, &ways[0]), (otherwise, &ways[1])].map(|(body, way)| self.within(body, way.clone()));
        let mut after = then.1;
        after.extend(otherwise.1);
        match (told, ways[0].is_empty()) {
            (true, true) => new.extend(otherwise.0),
            (true, false) => new.extend(then.0),
            _ => new.push(Statement::If(asked, then.0, otherwise.0)),
        }
        after
    }

    /// A match on the states of one of the regions.
    fn states(
        &mut self,
        side: usize,
        arms: &[Arm<'m>],
        otherwise: &[Statement<'m>],
        now: &Set<Point>,
        new: &mut Vec<Statement<'m>>,
    ) -> Set<Point> {
        let (mut kept, mut after, mut rest) = (Vec::new(), Set::new(), now.clone());
        for (values, body) in arms {
            let here = only(&rest, |point| values.contains(&point.joint[side]));
            rest.retain(|point| !values.contains(&point.joint[side]));
            if here.is_empty() {
                continue;
            }
            let mut names = Set::new();
            names.extend(here.iter().map(|point| self.name(&point.joint)));
            let (body, end) = self.within(body, here);
            after.extend(end);
            kept.push((names.into_iter().collect::<Vec<_>>(), body));
        }
        let is_told = rest.is_empty();
        let (mut otherwise, end) = self.within(otherwise, rest);
        after.extend(end);
        // What most of the states do needs no list of them.
        let most = (0..kept.len()).max_by_key(|at| kept[*at].0.len()).filter(|at| is_told && kept[*at].0.len() > 1);
        if let Some(most) = most {
            otherwise = kept.remove(most).1;
        }
        if let [Statement::Match(of, ..)] = &otherwise[..] {
            if *of == self.group.places[0] {
                if let Some(Statement::Match(_, mut within, rest)) = otherwise.pop() {
                    kept.append(&mut within);
                    otherwise = rest;
                }
            }
        }
        if kept.is_empty() {
            new.extend(otherwise);
        } else {
            new.push(Statement::Match(self.group.places[0], kept, otherwise));
        }
        after
    }

    /// A loop, entered in some states and gone through until no others come.
    fn rounds(&mut self, body: &[Statement<'m>], now: Set<Point>) -> (Vec<Statement<'m>>, Set<Point>) {
        let mut head = now;
        loop {
            self.left.push(Set::new());
            let (new, back) = self.within(body, head.clone());
            let left = self.left.pop().unwrap_or_default();
            let known = head.len();
            head.extend(back);
            if head.len() == known || self.fails.get() {
                return (new, left);
            }
        }
    }

    /// Whether a condition may be so.
    fn may(&self, condition: &Expr<'m>, holds: bool, point: &Point) -> bool {
        match condition {
            Expr::Value(Value::Bool(value)) => *value == holds,
            Expr::Place(place) if Some(*place) == self.truth => point.truth == holds,
            Expr::Not(inner) => self.may(inner, !holds, point),
            Expr::All(parts) if holds => parts.iter().all(|part| self.may(part, true, point)),
            Expr::All(parts) => parts.iter().any(|part| self.may(part, false, point)),
            Expr::Any(parts) if holds => parts.iter().any(|part| self.may(part, true, point)),
            Expr::Any(parts) => parts.iter().all(|part| self.may(part, false, point)),
            other => self.told(other, &point.joint).is_none_or(|value| value == holds),
        }
    }

    /// What the states say of a question about one of them.
    fn told(&self, expr: &Expr<'m>, joint: &Joint) -> Option<bool> {
        match expr {
            Expr::Is(place, steps) => {
                let state = joint[self.side(*place)?];
                Some(matches!(state, Value::Step(Some(step)) if steps.contains(&step)))
            }
            Expr::Compare(comparison @ (Comparison::Equal | Comparison::Differs), a, b) => {
                let (Expr::Place(place), Expr::Value(value)) = (&**a, &**b) else { return None };
                Some((joint[self.side(*place)?] == *value) == (*comparison == Comparison::Equal))
            }
            _ => None,
        }
    }
}

/// The truth that is found of the states of a group, once in a cycle.
fn truth(group: &Group, program: &Program<'_>) -> Option<PlaceId> {
    let is_asked = |expr: &Expr<'_>| match expr {
        Expr::Compare(Comparison::Equal, a, b) => {
            matches!((&**a, &**b), (Expr::Place(place), Expr::Value(_)) if group.places.contains(place))
        }
        _ => false,
    };
    let once = |place: PlaceId| program.cycle.iter().filter(|one| writes_to(one, place)).count() == 1;
    sets(&program.cycle).into_iter().find_map(|(place, value)| {
        (is_asked(value) && !program.places[place.0].is_field && once(place)).then_some(place)
    })
}

/// What is set on all ways.
fn sets<'s, 'm>(statements: &'s [Statement<'m>]) -> Vec<(PlaceId, &'s Expr<'m>)> {
    let mut all = Vec::new();
    for statement in statements {
        match statement {
            Statement::Part(_, body) => all.append(&mut sets(body)),
            Statement::Set(place, value) => all.push((*place, value)),
            _ => {}
        }
    }
    all
}

fn only(points: &Set<Point>, which: impl Fn(&Point) -> bool) -> Set<Point> {
    let mut left = Set::new();
    left.extend(points.iter().filter(|point| which(point)).cloned());
    left
}

/// Each with another state.
fn with(points: &Set<Point>, change: impl Fn(&mut Point)) -> Set<Point> {
    let mut new = Set::new();
    for point in points {
        let mut point = point.clone();
        change(&mut point);
        new.insert(point);
    }
    new
}
