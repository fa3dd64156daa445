//! A stored output that each state tells is no field: each way ends with giving it the value that it has there.
//!
//! ```text
//! fields                                   Asked:
//!   wait = false                             if 5s are over: state = Yellow
//! Green:                                   …
//!   if request: state = Asked       ->   match state
//!               wait = true                Asked|Yellow: wait = true
//! …
//! Clear:
//!   if 2s are over: state = Walk
//!                   wait = false
//! ```
//!
//! Needs: what the output holds in each state is known, by `split` or here, where a search goes through them; and nothing asks for it.

use super::super::{Arm, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::engine::{End, Fact, Tree};
use super::fold::initial;
use super::sparse::States;
use super::split::each_leaf;
use super::uses::{Effects, blocks_mut, mentions};
use crate::sorted::Map;

/// The trees know at the end of each way what the fields hold.
pub(super) fn pass<'m>(program: &mut Program<'m>, fields: &[PlaceId], trees: &mut [Option<Tree<'m>>]) {
    for (at, field) in fields.iter().enumerate() {
        let info = &program.places[field.0];
        if matches!(info.role, Role::Output(_))
            && matches!(info.ty, Type::Bool)
            && !is_asked(program, *field)
            && trees.iter().flatten().all(|tree| is_told(tree, *field, at))
        {
            let mut values = Vec::new();
            for tree in trees.iter().flatten() {
                each_leaf(tree, &mut |leaf| {
                    if let Some(Fact::Is(Value::Bool(value))) = leaf.facts.get(at) {
                        values.push(*value);
                    }
                });
            }
            let begins = is_mostly(&values);
            no_fields(&mut program.places, vec![(*field, begins)]);
            for tree in trees.iter_mut().flatten() {
                tell(tree, *field, at, begins);
            }
        }
    }
}

/// What most states say is that with which each cycle begins, so that the fewer others alone have to give it.
fn is_mostly(values: &[bool]) -> bool {
    2 * values.iter().filter(|value| **value).count() > values.len()
}

/// Outputs that each state tells, and with what each cycle begins.
pub(super) type Told = Vec<(PlaceId, bool)>;

pub(super) fn no_fields(places: &mut [PlaceInfo<'_>], told: Told) {
    for (place, begins) in told {
        let info = &mut places[place.0];
        (info.is_field, info.initial) = (false, Initial::Value(Value::Bool(begins)));
    }
}

fn is_asked(program: &Program<'_>, field: PlaceId) -> bool {
    let Some(deadline) = &program.deadline else { return false };
    let waits = deadline.waits.iter().any(|(condition, time)| mentions(condition, field) || mentions(time, field));
    waits || mentions(&deadline.at_once, field) || deadline.late.iter().any(|(_, over)| mentions(over, field))
}

/// Whether each way ends with a value that is known, and what stands on it does no more than to set it.
fn is_told(tree: &Tree<'_>, field: PlaceId, at: usize) -> bool {
    let sets = |body: &[Statement<'_>]| {
        body.iter().all(|one| {
            let effects = Effects::of(one);
            let is_set = matches!(one, Statement::Set(place, _) if *place == field);
            !effects.reads.contains(&field) && (is_set || !effects.writes.contains(&field))
        })
    };
    sets(&tree.body)
        && match &tree.end {
            End::Leaf(leaf) => sets(&leaf.body) && matches!(leaf.facts.get(at), Some(Fact::Is(_))),
            End::Fork(condition, ways) => !mentions(condition, field) && ways.iter().all(|way| is_told(way, field, at)),
        }
}

/// With what each cycle begins needs no giving.
fn tell(tree: &mut Tree<'_>, field: PlaceId, at: usize, begins: bool) {
    let other = |one: &Statement<'_>| !matches!(one, Statement::Set(place, _) if *place == field);
    tree.body.retain(other);
    match &mut tree.end {
        End::Leaf(leaf) => {
            leaf.body.retain(other);
            match leaf.facts.get(at) {
                Some(Fact::Is(value)) if *value != Value::Bool(begins) => {
                    leaf.body.push(Statement::Set(field, Expr::Value(*value)));
                }
                _ => {}
            }
        }
        End::Fork(_, ways) => ways.iter_mut().for_each(|way| tell(way, field, at, begins)),
    }
}

/// The search of a `grafcet`: what is done in front of it, in each state of it, and after it in each state in which it rests.
pub(super) struct Around<'a, 'm> {
    pub(super) points: &'a States,
    /// With which the first search begins.
    pub(super) begin: usize,
    pub(super) before: &'a mut Vec<Statement<'m>>,
    pub(super) trees: &'a mut [Option<Tree<'m>>],
    /// By state in which the search rests.
    pub(super) acts: &'a mut [Arm<'m>],
    pub(super) rest: &'a [Statement<'m>],
}

impl<'m> Around<'_, 'm> {
    /// The outputs that are no fields, and with what each cycle begins.
    pub(super) fn pass(&mut self, program: &Program<'m>) -> Told {
        let mut told = Vec::new();
        for (index, info) in program.places.iter().enumerate() {
            let field = PlaceId(index);
            let is_candidate = info.is_field && matches!(info.role, Role::Output(_)) && matches!(info.ty, Type::Bool);
            let Some(Value::Bool(begins)) = initial(info).filter(|_| is_candidate && !is_asked(program, field)) else {
                continue;
            };
            let first = program.place(Role::First);
            let Some(values) = self.begins(field, first, begins).and_then(|value| self.values(field, value)) else {
                continue;
            };
            let mut most = Vec::with_capacity(self.acts.len());
            for (state, _) in &*self.acts {
                most.extend(self.points.point(state[0]).and_then(|point| values[point]?.one()));
            }
            for ((_, body), value) in self.acts.iter_mut().zip(&most) {
                if *value != is_mostly(&most) {
                    body.push(Statement::Set(field, Expr::Value(Value::Bool(*value))));
                }
            }
            without(self.before, field);
            for tree in self.trees.iter_mut().flatten() {
                strip(tree, field);
            }
            told.push((field, is_mostly(&most)));
        }
        told
    }

    /// What the output holds when the first search begins.
    fn begins(&self, field: PlaceId, first: Option<PlaceId>, mut value: bool) -> Option<bool> {
        if touches(self.rest, field) || self.acts.iter().any(|(_, body)| touches(body, field)) {
            return None;
        }
        for statement in &*self.before {
            match statement {
                Statement::If(Expr::Place(place), then, otherwise) if Some(*place) == first && otherwise.is_empty() => {
                    value = entered(then, field, value)?;
                }
                other if touches(std::slice::from_ref(other), field) => return None,
                _ => {}
            }
        }
        Some(value)
    }

    /// What it holds in each state in which a round begins, if that is known wherever a search rests.
    fn values(&self, field: PlaceId, begins: bool) -> Option<Vec<Option<Holds>>> {
        let mut values: Vec<Option<Holds>> = vec![None; self.trees.len()];
        values[self.begin] = Some(Holds::One(begins));
        let mut open = vec![self.begin];
        while let Some(point) = open.pop() {
            let Some(tree) = &self.trees[point] else { return None };
            let mut ends = Vec::new();
            follow(tree, field, values[point]?, &mut ends)?;
            for (state, holds) in ends {
                let to = self.points.point(state)?;
                let joined = values[to].map_or(holds, |other| other.or(holds));
                if values[to].replace(joined) != Some(joined) {
                    open.push(to);
                }
            }
        }
        let is_known = |(state, _): &Arm<'_>| {
            let point = self.points.point(state[0])?;
            values[point]?.one()
        };
        self.acts.iter().all(|arm| is_known(arm).is_some()).then_some(values)
    }
}

/// What an output holds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Holds {
    One(bool),
    Either,
}

impl Holds {
    fn or(self, other: Self) -> Self {
        if self == other { self } else { Self::Either }
    }

    fn one(self) -> Option<bool> {
        match self {
            Self::One(value) => Some(value),
            Self::Either => None,
        }
    }
}

fn touches(statements: &[Statement<'_>], field: PlaceId) -> bool {
    let effects = Effects::of_all(statements);
    effects.reads.contains(&field) || effects.writes.contains(&field)
}

/// What it holds after some statements, which do no more than to set it.
fn set(body: &[Statement<'_>], field: PlaceId, mut holds: Holds) -> Option<Holds> {
    for statement in body {
        match statement {
            Statement::Set(place, Expr::Value(Value::Bool(value))) if *place == field => holds = Holds::One(*value),
            other if touches(std::slice::from_ref(other), field) => return None,
            _ => {}
        }
    }
    Some(holds)
}

/// The same of the activation of the initial situation, which works on copies.
fn entered(body: &[Statement<'_>], field: PlaceId, mut value: bool) -> Option<bool> {
    // What each copy holds; none where that is still the output's value.
    let mut copies: Map<PlaceId, Option<bool>> = Map::new();
    for statement in body {
        match statement {
            Statement::Set(place, Expr::Value(Value::Bool(new))) if *place == field => value = *new,
            Statement::Set(place, Expr::Place(copy)) if *place == field => {
                value = copies.get(copy)?.unwrap_or(value);
            }
            Statement::Set(copy, Expr::Place(place)) if *place == field => _ = copies.insert(*copy, None),
            Statement::Set(copy, Expr::Value(Value::Bool(new))) => _ = copies.insert(*copy, Some(*new)),
            other if touches(std::slice::from_ref(other), field) => return None,
            _ => {}
        }
    }
    copies.values().all(Option::is_some).then_some(value)
}

/// The states in which the ways end, with what it holds there.
fn follow(tree: &Tree<'_>, field: PlaceId, holds: Holds, ends: &mut Vec<(Value, Holds)>) -> Option<()> {
    let holds = set(&tree.body, field, holds)?;
    match &tree.end {
        End::Leaf(leaf) => ends.push((leaf.state, set(&leaf.body, field, holds)?)),
        End::Fork(condition, _) if mentions(condition, field) => return None,
        End::Fork(_, ways) => {
            for way in &**ways {
                follow(way, field, holds, ends)?;
            }
        }
    }
    Some(())
}

fn strip(tree: &mut Tree<'_>, field: PlaceId) {
    without(&mut tree.body, field);
    match &mut tree.end {
        End::Leaf(leaf) => without(&mut leaf.body, field),
        End::Fork(_, ways) => ways.iter_mut().for_each(|way| strip(way, field)),
    }
}

fn without(statements: &mut Vec<Statement<'_>>, field: PlaceId) {
    statements.retain(|one| !matches!(one, Statement::Set(place, _) if *place == field));
    for statement in statements {
        blocks_mut(statement).into_iter().for_each(|block| without(block, field));
    }
}
