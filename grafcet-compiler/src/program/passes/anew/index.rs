//! The statements of a cycle by number, which fields they write, and what decides about that.

use super::super::super::uses::{each_block, each_own_written, each_read};
use super::super::super::{Arm, Expr, PlaceId, Program, Role, Statement, Type, Value};
use crate::list::List;
use crate::sorted::{Map, Set};

/// Statements have numbers in the order of the text; of what a statement has within it the first one has the next number.
pub(super) struct Index {
    /// By statement: it and all within it are so many.
    pub(super) sizes: Vec<usize>,
    /// By statement: the one that it stands in.
    around: Vec<Option<usize>>,
    /// By place: the statements that write it.
    writers: Vec<Vec<usize>>,
    /// Those that leave a loop.
    breaks: Vec<usize>,
    /// By match.
    pub(super) matches: Map<usize, Arms>,
    /// By place: stored constants are looked for, or fields that it shows.
    is_asked: Vec<bool>,
    /// By place: the fields that may hold something else by what it holds.
    decides: Vec<Set<PlaceId>>,
}

/// The arms of a match; the last one is that of all other values.
pub(super) struct Arms {
    pub(super) arms: Map<Value, usize>,
    /// By arm: the number of its first statement.
    pub(super) firsts: Vec<usize>,
}

impl Index {
    pub(super) fn of(program: &Program<'_>) -> Self {
        let count = program.places.len();
        let mut index = Self {
            sizes: Vec::new(),
            around: Vec::new(),
            writers: vec![Vec::new(); count],
            breaks: Vec::new(),
            matches: Map::new(),
            is_asked: vec![false; count],
            decides: vec![Set::new(); count],
        };
        index.number(program, &program.cycle, None);
        index.decide(program, &program.cycle, &mut Vec::new());
        index
    }

    fn number(&mut self, program: &Program<'_>, statements: &[Statement<'_>], around: Option<usize>) {
        for statement in statements {
            let number = self.sizes.len();
            self.sizes.push(1);
            self.around.push(around);
            each_own_written(statement, &mut |place| self.writers[place.0].push(number));
            if let Statement::Break = statement {
                self.breaks.push(number);
            }
            if let Statement::Set(to, value) = statement {
                let place = &program.places[to.0];
                self.is_asked[to.0] |= match place.role {
                    Role::Output(_) if !place.is_field => matches!(value, Expr::Place(_)),
                    role => matches!(value, Expr::Value(_)) && place.is_field && is_own(role),
                };
            }
            let mut firsts = Vec::new();
            each_block(statement, &mut |block| {
                firsts.push(self.sizes.len());
                self.number(program, block, Some(number));
            });
            self.sizes[number] = self.sizes.len() - number;
            if let Statement::Match(_, arms, _) = statement {
                self.matches.insert(number, Arms { arms: numbered(arms), firsts });
            }
        }
    }

    /// Notes what each field depends on, within statements about which some places decide.
    fn decide(&mut self, program: &Program<'_>, statements: &[Statement<'_>], by: &mut Vec<PlaceId>) {
        for statement in statements {
            let before = by.len();
            match statement {
                Statement::If(condition, ..) => each_read(condition, &mut |place| by.push(place)),
                Statement::Match(place, ..) => by.push(*place),
                // What leaves a loop decides about all that is in it.
                Statement::Loop { body, .. } => breaks(body, &mut Vec::new(), by),
                Statement::Set(to, Expr::Place(from)) => _ = self.decides[from.0].insert(*to),
                _ => {}
            }
            let is_followed =
                |place: &PlaceId| self.is_asked[place.0] || matches!(program.places[place.0].ty, Type::State(_));
            let followed = by.split_off(before).into_iter().filter(is_followed).list();
            by.extend(followed);
            each_own_written(statement, &mut |to| {
                for place in &*by {
                    self.decides[place.0].insert(to);
                }
            });
            each_block(statement, &mut |block| self.decide(program, block, by));
            by.truncate(before);
        }
    }

    /// The fields that may hold something by the state of a region, and those that nobody has followed yet, where no state decides about them or only those of regions of which
    /// nothing can be told.
    pub(super) fn fields(
        &self,
        program: &Program<'_>,
        region: usize,
        (fails, is_followed): (&[bool], &[bool]),
    ) -> Vec<PlaceId> {
        let by_own = self.reached(program, &|of| of == region);
        let by_any = self.reached(program, &|of| !fails[of]);
        let is_here = |place: &usize| by_own[*place] || !by_any[*place] && !is_followed[*place];
        (0..by_own.len()).filter(|place| self.is_asked[*place] && is_here(place)).map(PlaceId).list()
    }

    /// By place: whether the states of such regions decide about it.
    fn reached(&self, program: &Program<'_>, is_such: &dyn Fn(usize) -> bool) -> Vec<bool> {
        let mut reached = vec![false; self.decides.len()];
        let is_state = |place: &usize| matches!(program.places[*place].ty, Type::State(region) if is_such(region));
        let mut open = (0..reached.len()).filter(is_state).list();
        for place in &open {
            reached[*place] = true;
        }
        while let Some(place) = open.pop() {
            for next in &*self.decides[place] {
                if !std::mem::replace(&mut reached[next.0], true) && self.is_asked[next.0] {
                    open.push(next.0);
                }
            }
        }
        reached
    }

    /// By statement: whether it, or one within it, writes one of these fields or the state of the region, or leaves a loop.
    pub(super) fn matters(
        &self,
        program: &Program<'_>,
        region: usize,
        fields: &[PlaceId],
        is_gone: &dyn Fn(usize) -> bool,
    ) -> Vec<bool> {
        let mut matters = vec![false; self.sizes.len()];
        let mut matter = |statements: &[usize]| {
            for statement in statements {
                let mut next = Some(*statement).filter(|statement| !is_gone(*statement));
                while let Some(number) = next.filter(|number| !matters[*number]) {
                    matters[number] = true;
                    next = self.around[number];
                }
            }
        };
        matter(&self.breaks);
        for (place, writers) in self.writers.iter().enumerate() {
            let is_state = matches!(program.places[place].ty, Type::State(of) if of == region);
            if is_state || fields.binary_search(&PlaceId(place)).is_ok() {
                matter(writers);
            }
        }
        matters
    }

    /// How many statements a block has, of which the first one has this number.
    pub(super) fn size(&self, first: usize, block: &[Statement<'_>]) -> usize {
        block.iter().fold(first, |next, _| next + self.sizes[next]) - first
    }
}

/// By value: the arm for it.
fn numbered(arms: &[Arm<'_>]) -> Map<Value, usize> {
    let mut numbers = Map::new();
    for (arm, (values, _)) in arms.iter().enumerate() {
        for value in values {
            numbers.insert(*value, arm);
        }
    }
    numbers
}

/// What decides about leaving a loop, of places that are asked within it.
fn breaks(statements: &[Statement<'_>], by: &mut Vec<PlaceId>, all: &mut Vec<PlaceId>) {
    for statement in statements {
        let before = by.len();
        match statement {
            Statement::If(condition, ..) => each_read(condition, &mut |place| by.push(place)),
            Statement::Match(place, ..) => by.push(*place),
            Statement::Break => all.extend_from_slice(by),
            // Its own breaks leave that one.
            Statement::Loop { .. } => continue,
            _ => {}
        }
        each_block(statement, &mut |block| breaks(block, by, all));
        by.truncate(before);
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
