//! What a cycle does in one state: its statements with all that is known there, forked where the next state depends on a condition.

mod facts;
mod tree;

pub(super) use facts::{Among, Copies, Excluding, Fact, beginning, meet};
pub(super) use tree::{End, Leaf, Lost, Tree};

use super::super::{Expr, PlaceId, PlaceInfo, Run, Statement, Type, Value};
use super::fold::Known;
use super::sparse::{Index, States};
use super::uses::{each_written, leaves};
use crate::model::Read;

/// What follows a list of statements from state to state.
pub(super) struct Engine<'e, 'm> {
    pub(super) places: &'e [PlaceInfo<'m>],
    pub(super) list: &'e [Statement<'m>],
    pub(super) index: &'e Index,
    pub(super) state: PlaceId,
    pub(super) points: &'e States,
    /// The fields, in the order in which leaves know them.
    pub(super) fields: &'e [PlaceId],
    pub(super) env: Vec<Fact>,
    /// What was known before, to take back.
    pub(super) trail: Vec<(PlaceId, Fact)>,
    /// What conditions on the way have told.
    pub(super) learned: Vec<PlaceId>,
    /// What has been a copy of what so far.
    pub(super) copies: Copies,
    /// What [`Fact::Among`] stands for.
    pub(super) lists: Vec<Among>,
    /// The ends of ways know all places, and what is a copy of what, not the fields alone.
    pub(super) tells_all: bool,
    pub(super) excluding: Excluding<'e>,
    ways: usize,
}

/// How far the lists of the index are read.
#[derive(Clone, Copy, Default)]
struct Cursor {
    always: usize,
    before: usize,
    after: usize,
    /// The point of the next state, once it is known.
    next: Option<usize>,
}

impl<'e, 'm> Engine<'e, 'm> {
    pub(super) fn new(
        places: &'e [PlaceInfo<'m>],
        (list, index): (&'e [Statement<'m>], &'e Index),
        state: PlaceId,
        points: &'e States,
        fields: &'e [PlaceId],
        env: Vec<Fact>,
    ) -> Self {
        Self {
            places,
            list,
            index,
            state,
            points,
            fields,
            env,
            trail: Vec::new(),
            learned: Vec::new(),
            copies: Copies::default(),
            lists: Vec::new(),
            tells_all: false,
            excluding: Excluding::default(),
            ways: 0,
        }
    }

    /// A region has one of these states.
    pub(super) fn among(&mut self, states: Among) -> Fact {
        if let [state] = states[..] {
            return Fact::Is(Value::Step(state));
        }
        self.lists.push(states);
        Fact::Among(self.lists.len() - 1)
    }

    /// The ways from a point, with what is known there.
    pub(super) fn from(&mut self, point: usize, known: &[(PlaceId, Fact)], ways: usize) -> Result<Tree<'m>, Lost> {
        self.ways = ways;
        // What was a copy in front of it still is one.
        for (place, fact) in known {
            self.trail.push((*place, std::mem::replace(&mut self.env[place.0], *fact)));
        }
        let given = self.copies.all.len();
        let tree = self.go(point, Cursor::default());
        self.back(0);
        self.learned.clear();
        self.copies.back(given);
        tree
    }

    pub(super) fn note(&mut self, place: PlaceId, fact: Fact) {
        for copy in self.copies.of.get(place.0).into_iter().flatten() {
            if self.env[copy.0] == Fact::Copy(place) {
                self.trail.push((*copy, Fact::Copy(place)));
                self.env[copy.0] = match self.env[place.0] {
                    known @ (Fact::Is(_) | Fact::Among(_)) => known,
                    _ => Fact::Nothing,
                };
            }
        }
        if let Fact::Copy(of) = fact {
            self.copies.add(place, of);
        }
        let before = &mut self.env[place.0];
        if *before != fact {
            self.trail.push((place, *before));
            *before = fact;
        }
    }

    /// Takes back what has been noted since.
    pub(super) fn back(&mut self, to: usize) {
        while self.trail.len() > to {
            if let Some((place, fact)) = self.trail.pop() {
                self.env[place.0] = fact;
            }
        }
    }

    pub(super) fn fold(&self, expr: &Expr<'m>) -> Expr<'m> {
        let value = |place: PlaceId| match self.env[place.0] {
            Fact::Is(value) | Fact::Assumed(value) => Some(value),
            _ => None,
        };
        let copy = |place: PlaceId| match self.env[place.0] {
            Fact::Copy(other) => Some(other),
            _ => None,
        };
        let now = |place: PlaceId| self.env[place.0] == Fact::Now;
        let among = |place: PlaceId| match self.env[place.0] {
            Fact::Among(list) => Some(&self.lists[list]),
            _ => None,
        };
        Known { places: self.places, value: &value, copy: &copy, among: &among, now: &now }.fold(expr)
    }

    /// The next statement that matters.
    fn next(&mut self, point: usize, cursor: &mut Cursor) -> Result<Option<usize>, Lost> {
        let (index, end) = (self.index, usize::MAX);
        loop {
            let always = index.always.get(cursor.always).copied().unwrap_or(end);
            let before = index.before[point].get(cursor.before).copied().unwrap_or(end);
            let after = cursor.next.map_or(end, |next| index.after[next].get(cursor.after).copied().unwrap_or(end));
            let at = always.min(before).min(after);
            if cursor.next.is_none() && (at > index.last) {
                // The next state is known from here on; what the way has told is not, so that ways to one state go on alike.
                let Fact::Is(state) = self.env[self.state.0] else { return Err(Lost) };
                cursor.next = Some(self.points.point(state).ok_or(Lost)?);
                for place in std::mem::take(&mut self.learned) {
                    self.note(place, Fact::Nothing);
                }
                continue;
            }
            if at == end {
                return Ok(None);
            }
            cursor.always += usize::from(always == at);
            cursor.before += usize::from(before == at);
            cursor.after += usize::from(after == at);
            return Ok(Some(at));
        }
    }

    fn go(&mut self, point: usize, mut cursor: Cursor) -> Result<Tree<'m>, Lost> {
        let mut forks = Vec::new();
        let mut body = Vec::new();
        let list = self.list;
        while let Some(at) = self.next(point, &mut cursor)? {
            if let Some(condition) = self.may_leave(&list[at]) {
                // The loop is left there, or it goes on.
                let (mark, learned) = (self.trail.len(), self.learned.len());
                self.tell(&condition, true);
                let mut then = Vec::new();
                if let Statement::If(_, leaving, _) = &list[at] {
                    self.block(leaving, &mut then);
                }
                let tree = Tree { body: Vec::new(), end: End::Leaf(self.leaf(then)?) };
                self.back(mark);
                self.learned.truncate(learned);
                self.tell(&condition, false);
                forks.push((std::mem::take(&mut body), condition, tree));
                continue;
            }
            if let Some(place) = self.excluded(&list[at]) {
                self.set(place, Expr::Value(Value::Bool(false)), &mut body);
                continue;
            }
            let Some((place, condition)) = self.fork(&list[at]) else {
                self.statement(&list[at], &mut body);
                if matches!(body.last(), Some(Statement::Break)) {
                    break;
                }
                continue;
            };
            self.ways = self.ways.checked_sub(1).ok_or(Lost)?;
            let (mark, learned) = (self.trail.len(), self.learned.len());
            self.tell(&condition, true);
            let mut then = Vec::new();
            self.set(place, Expr::Value(Value::Bool(true)), &mut then);
            let mut tree = self.go(point, cursor)?;
            tree.body.splice(0..0, then);
            self.back(mark);
            self.learned.truncate(learned);
            forks.push((std::mem::take(&mut body), condition, tree));
            if let Some((_, condition, _)) = forks.last() {
                self.tell(&condition.clone(), false);
            }
            self.set(place, Expr::Value(Value::Bool(false)), &mut body);
        }
        let mut tree = Tree { body: Vec::new(), end: End::Leaf(self.leaf(body)?) };
        while let Some((body, condition, then)) = forks.pop() {
            tree = Tree { body, end: End::Fork(condition, Box::new([then, tree])) };
        }
        Ok(tree)
    }

    /// What is asked before the loop is left, where that is not known.
    fn may_leave(&self, statement: &Statement<'m>) -> Option<Expr<'m>> {
        let Statement::If(condition, leaving, otherwise) = statement else { return None };
        if !matches!(leaving.last(), Some(Statement::Break)) || !otherwise.is_empty() {
            return None;
        }
        match self.fold(condition) {
            Expr::Value(_) => None,
            condition => Some(condition),
        }
    }

    fn leaf(&self, mut body: Vec<Statement<'m>>) -> Result<Leaf<'m>, Lost> {
        let Fact::Is(state) = self.env[self.state.0] else { return Err(Lost) };
        let breaks = matches!(body.last(), Some(Statement::Break));
        if breaks {
            body.pop();
        }
        if body.iter().any(leaves) {
            return Err(Lost);
        }
        if self.tells_all {
            return Ok(Leaf { body, state, facts: self.env.clone(), breaks });
        }
        let mut facts = Vec::with_capacity(self.fields.len());
        for place in self.fields {
            facts.push(match self.env[place.0] {
                Fact::Copy(_) | Fact::Now => Fact::Nothing,
                fact => fact,
            });
        }
        Ok(Leaf { body, state, facts, breaks })
    }

    /// A truth that is set, and cannot become true any more.
    fn excluded(&mut self, statement: &Statement<'m>) -> Option<PlaceId> {
        let place = match statement {
            Statement::Set(place, _) => place,
            Statement::If(condition, then, otherwise) => {
                let ([Statement::Set(place, _)], []) = (&then[..], &otherwise[..]) else { return None };
                matches!(self.fold(condition), Expr::Value(Value::Bool(true))).then_some(place)?
            }
            _ => return None,
        };
        self.excluding.excludes(*place, &self.env).then_some(*place)
    }

    /// A truth on which the next state depends, and that is not known.
    fn fork(&mut self, statement: &Statement<'m>) -> Option<(PlaceId, Expr<'m>)> {
        match statement {
            Statement::If(condition, then, otherwise) => {
                let ([one], []) = (&then[..], &otherwise[..]) else { return None };
                matches!(self.fold(condition), Expr::Value(Value::Bool(true))).then(|| self.fork(one)).flatten()
            }
            Statement::Set(place, value) if self.index.forks[place.0] => match self.fold(value) {
                Expr::Value(_) => None,
                condition => Some((*place, condition)),
            },
            _ => None,
        }
    }

    /// What a condition tells that holds, or does not.
    pub(super) fn learn(&mut self, condition: &Expr<'m>, holds: bool) {
        match (condition, holds) {
            (Expr::Place(place), _) => {
                self.note(*place, Fact::Is(Value::Bool(holds)));
                self.learned.push(*place);
            }
            (Expr::Not(inner), _) => self.learn(inner, !holds),
            (Expr::All(parts), true) | (Expr::Any(parts), false) => {
                for part in parts {
                    self.learn(part, holds);
                }
            }
            _ => {}
        }
    }

    pub(super) fn block(&mut self, statements: &[Statement<'m>], out: &mut Vec<Statement<'m>>) {
        for statement in statements {
            self.statement(statement, out);
        }
    }

    fn statement(&mut self, statement: &Statement<'m>, out: &mut Vec<Statement<'m>>) {
        match statement {
            Statement::Part(_, body) => self.block(body, out),
            Statement::Set(place, value) => {
                let value = self.counted(*place, value).unwrap_or_else(|| self.fold(value));
                self.set(*place, value, out);
            }
            Statement::If(condition, then, otherwise) => match self.fold(condition) {
                Expr::Value(Value::Bool(true)) => self.block(then, out),
                Expr::Value(Value::Bool(false)) => self.block(otherwise, out),
                condition => self.unknown(condition, then, otherwise, out),
            },
            Statement::Match(place, arms, otherwise) => {
                if let Fact::Is(value) | Fact::Assumed(value) = self.env[place.0] {
                    let arm = arms.iter().find(|(values, _)| values.contains(&value));
                    return self.block(arm.map_or(otherwise, |(_, body)| body), out);
                }
                self.unknown_arm(*place, arms, otherwise, out);
            }
            Statement::Run(run) => {
                let run = self.run(run);
                for write in &run.writes {
                    self.hold(write.to, out);
                    if let Some(noted) = write.noted {
                        self.hold(noted, out);
                    }
                    self.note(write.to, Fact::Nothing);
                    if let Some(noted) = write.noted {
                        self.note(noted, Fact::Nothing);
                    }
                }
                out.push(Statement::Run(Box::new(run)));
            }
            Statement::Call(action, phase, args) => {
                let args = args.iter().map(|arg| self.fold(arg)).collect();
                out.push(Statement::Call(*action, self.fold(phase), args));
            }
            Statement::Loop { .. } => {
                each_written(std::slice::from_ref(statement), &mut |place| self.note(place, Fact::Nothing));
                out.push(statement.clone());
            }
            Statement::Break | Statement::Mark(_) | Statement::Fence(_) => out.push(statement.clone()),
        }
    }

    /// A time counts on from its field also where that is known to hold nothing yet: so it does in other states, with which this one has the statement in common.
    fn counted(&self, place: PlaceId, value: &Expr<'m>) -> Option<Expr<'m>> {
        let Expr::Add(of, more) = value else { return None };
        let is_own = matches!(**of, Expr::Place(of) if of == place);
        let begins = matches!(self.env[place.0], Fact::Is(Value::Ticks(0)));
        let more = Some(self.fold(more)).filter(|more| is_own && begins && !matches!(more, Expr::Value(_)))?;
        Some(Expr::Add(of.clone(), Box::new(more)))
    }

    /// What may be written, or not, has to hold what it was taken for.
    pub(super) fn hold(&mut self, place: PlaceId, out: &mut Vec<Statement<'m>>) {
        if let Fact::Assumed(value) = self.env[place.0] {
            out.push(Statement::Set(place, Expr::Value(value)));
            self.note(place, Fact::Is(value));
        }
    }

    fn run(&self, run: &Run<'m>) -> Run<'m> {
        let mut run = run.clone();
        for (read, value) in &mut run.binds {
            if !run.writes.iter().any(|write| Read::Name(write.name.into()) == *read) {
                *value = self.fold(value);
            }
        }
        run
    }

    fn set(&mut self, place: PlaceId, value: Expr<'m>, out: &mut Vec<Statement<'m>>) {
        let is_user = matches!(self.places[place.0].ty, Type::User(_));
        let fact = match &value {
            Expr::Place(other) if *other == place => return,
            Expr::Initial(other) if *other == place => Fact::Initial,
            Expr::Value(value) if !is_user => Fact::Is(*value),
            Expr::Place(other) => Fact::Copy(*other),
            Expr::Now => Fact::Now,
            _ => Fact::Nothing,
        };
        // A copy is made anew: other ways to the same state have to make it.
        if matches!(fact, Fact::Is(_) | Fact::Initial) && self.env[place.0] == fact {
            return;
        }
        self.note(place, fact);
        out.push(Statement::Set(place, value));
    }
}
