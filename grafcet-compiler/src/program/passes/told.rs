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
use super::edits::unset;
use super::engine::{End, Fact, Tree};
use super::fold::initial;
use super::sparse::States;
use super::uses::{Effects, blocks, each_read, mentions, reads_from};
use crate::sorted::{Map, Set};

/// The trees know at the end of each way what the fields hold; `outside` stands in front of them, and after them.
pub(super) fn pass<'m>(
    program: &mut Program<'m>,
    fields: &[PlaceId],
    trees: &mut [Option<Tree<'m>>],
    outside: [&[Statement<'m>]; 2],
) {
    let mut candidates = Vec::new();
    for (at, field) in fields.iter().enumerate() {
        if let Some(values) = is_candidate(program, *field).then(|| values_of(trees, at)).flatten() {
            candidates.push((at, *field, is_mostly(&values)));
        }
    }
    let mut other = Other::default();
    if !candidates.is_empty() {
        trees.iter().flatten().for_each(|tree| other.add(tree));
        for statements in outside {
            other.add_all(statements);
        }
    }
    for (at, field, begins) in candidates {
        if !other.0.contains(&field) {
            no_fields(&mut program.places, vec![(field, begins)]);
            for tree in trees.iter_mut().flatten() {
                tell(tree, field, at, begins);
            }
        }
    }
}

/// A stored truth that the deadline does not ask for.
fn is_candidate(program: &Program<'_>, field: PlaceId) -> bool {
    let info = &program.places[field.0];
    info.is_field && matches!(info.role, Role::Output(_)) && matches!(info.ty, Type::Bool) && !is_asked(program, field)
}

/// What a field holds at the end of each way, if that is known.
fn values_of(trees: &[Option<Tree<'_>>], at: usize) -> Option<Vec<bool>> {
    let (mut values, mut ways) = (Vec::new(), 0);
    for tree in trees.iter().flatten() {
        tree.each_leaf(&mut |leaf| {
            ways += 1;
            if let Some(Fact::Is(Value::Bool(value))) = leaf.facts.get(at) {
                values.push(*value);
            }
        });
    }
    (values.len() == ways).then_some(values)
}

/// The places that something asks for, or does more with than to set them to a truth.
#[derive(Default)]
struct Other(Set<PlaceId>);

impl Other {
    fn add(&mut self, tree: &Tree<'_>) {
        self.add_all(&tree.body);
        match &tree.end {
            End::Leaf(leaf) => self.add_all(&leaf.body),
            End::Fork(condition, ways) => {
                each_read(condition, &mut |place| _ = self.0.insert(place));
                ways.iter().for_each(|way| self.add(way));
            }
        }
    }

    fn add_all(&mut self, body: &[Statement<'_>]) {
        for statement in body {
            if !matches!(statement, Statement::Set(_, Expr::Value(Value::Bool(_)))) {
                let effects = Effects::of(statement);
                self.0.extend(effects.reads);
                self.0.extend(effects.writes);
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
    deadline.asks().any(|expr| mentions(expr, field)) || deadline.late.iter().any(|(_, over)| mentions(over, field))
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
        let mut other = Other::default();
        self.trees.iter().flatten().for_each(|tree| other.add(tree));
        other.add_all(self.rest);
        self.acts.iter().for_each(|(_, body)| other.add_all(body));
        let mut candidates = Vec::new();
        for (index, info) in program.places.iter().enumerate() {
            let field = PlaceId(index);
            if let (true, Some(Value::Bool(begins))) = (is_candidate(program, field), initial(info)) {
                let begins = (!other.0.contains(&field)).then(|| self.begins(program, field, begins, &other)).flatten();
                candidates.extend(begins.map(|begins| (field, begins)));
            }
        }
        let Some(ways) = (!candidates.is_empty()).then(|| self.ways()).flatten() else { return told };
        for (field, begins) in candidates {
            let Some(most) = self.values(&ways, field, begins) else { continue };
            let begins = is_mostly(&most);
            for ((_, body), value) in self.acts.iter_mut().zip(most) {
                if value != begins {
                    body.push(Statement::Set(field, Expr::Value(Value::Bool(value))));
                }
            }
            unset(self.before, field);
            for tree in self.trees.iter_mut().flatten() {
                strip(tree, field);
            }
            told.push((field, begins));
        }
        told
    }

    /// What the output holds when the first search begins.
    fn begins(&self, program: &Program<'m>, field: PlaceId, mut value: bool, other: &Other) -> Option<bool> {
        let first = program.place(Role::First);
        for statement in &*self.before {
            match statement {
                Statement::If(Expr::Place(place), then, otherwise) if Some(*place) == first && otherwise.is_empty() => {
                    let (after, copies) = entered(then, field, value)?;
                    value = after;
                    let is_free = |copy: &PlaceId| {
                        let info = &program.places[copy.0];
                        let is_local = !info.is_field && info.role == Role::Local;
                        is_local && !other.0.contains(copy) && !is_read(self.before, *copy, field)
                    };
                    if !copies.iter().all(is_free) {
                        return None;
                    }
                }
                one if touches(one, field) => return None,
                _ => {}
            }
        }
        Some(value)
    }

    /// By state: where the ways lead, and what they set.
    fn ways(&self) -> Option<Vec<Vec<Passage>>> {
        let mut all = Vec::with_capacity(self.trees.len());
        for tree in &*self.trees {
            let mut ways = Vec::new();
            if let Some(tree) = tree {
                self.follow(tree, &[], &mut ways)?;
            }
            all.push(ways);
        }
        Some(all)
    }

    fn follow(&self, tree: &Tree<'m>, before: &[(PlaceId, bool)], ways: &mut Vec<Passage>) -> Option<()> {
        let mut sets = before.to_vec();
        let mut add = |body: &[Statement<'m>]| {
            for statement in body {
                if let Statement::Set(place, Expr::Value(Value::Bool(value))) = statement {
                    sets.push((*place, *value));
                }
            }
        };
        add(&tree.body);
        match &tree.end {
            End::Leaf(leaf) => {
                add(&leaf.body);
                ways.push(Passage { to: self.points.point(leaf.state)?, sets });
            }
            End::Fork(_, both) => {
                for way in &**both {
                    self.follow(way, &sets, ways)?;
                }
            }
        }
        Some(())
    }

    /// What it holds in each state in which a search rests, if that is known.
    fn values(&self, ways: &[Vec<Passage>], field: PlaceId, begins: bool) -> Option<Vec<bool>> {
        let mut values: Vec<Option<Holds>> = vec![None; ways.len()];
        values[self.begin] = Some(Holds::One(begins));
        let mut open = vec![self.begin];
        while let Some(point) = open.pop() {
            let before = values[point]?;
            for way in &ways[point] {
                let set = way.sets.iter().rfind(|(place, _)| *place == field);
                let holds = set.map_or(before, |(_, value)| Holds::One(*value));
                let joined = values[way.to].map_or(holds, |other| other.or(holds));
                if values[way.to].replace(joined) != Some(joined) {
                    open.push(way.to);
                }
            }
        }
        let mut at_rest = Vec::with_capacity(self.acts.len());
        for (state, _) in &*self.acts {
            at_rest.push(values[self.points.point(state[0])?]?.one()?);
        }
        Some(at_rest)
    }
}

/// A way from one state to one.
struct Passage {
    to: usize,
    sets: Vec<(PlaceId, bool)>,
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

fn touches(statement: &Statement<'_>, field: PlaceId) -> bool {
    let effects = Effects::of(statement);
    effects.reads.contains(&field) || effects.writes.contains(&field)
}

/// What it holds after the activation of the initial situation, which works on copies; and the copies that are of no use without it.
fn entered(body: &[Statement<'_>], field: PlaceId, mut value: bool) -> Option<(bool, Vec<PlaceId>)> {
    // What each copy holds, and whether it is still what the output held.
    let mut copies: Map<PlaceId, (bool, bool)> = Map::new();
    for statement in body {
        match statement {
            Statement::Set(place, Expr::Value(Value::Bool(new))) if *place == field => value = *new,
            Statement::Set(place, Expr::Place(copy)) if *place == field => value = copies.get(copy)?.0,
            Statement::Set(copy, Expr::Place(place)) if *place == field => _ = copies.insert(*copy, (value, true)),
            Statement::Set(copy, Expr::Value(Value::Bool(new))) => _ = copies.insert(*copy, (*new, false)),
            other => {
                let effects = Effects::of(other);
                if effects.reads.contains(&field) || effects.writes.contains(&field) {
                    return None;
                }
                // Of these nobody knows what they hold.
                for place in &*effects.writes {
                    copies.remove(place);
                }
            }
        }
    }
    let mut left_alone = Vec::new();
    for (copy, (_, is_old)) in &copies {
        if *is_old {
            left_alone.push(*copy);
        }
    }
    Some((value, left_alone))
}

/// Whether a place is read but to give it back to the output.
fn is_read(body: &[Statement<'_>], place: PlaceId, field: PlaceId) -> bool {
    body.iter().any(|statement| match statement {
        Statement::Set(to, Expr::Place(_)) if *to == field => false,
        Statement::If(condition, ..) if mentions(condition, place) => true,
        Statement::If(..) | Statement::Part(..) => {
            blocks(statement).into_iter().any(|body| is_read(body, place, field))
        }
        other => reads_from(other, place),
    })
}

fn strip(tree: &mut Tree<'_>, field: PlaceId) {
    unset(&mut tree.body, field);
    match &mut tree.end {
        End::Leaf(leaf) => unset(&mut leaf.body, field),
        End::Fork(_, ways) => ways.iter_mut().for_each(|way| strip(way, field)),
    }
}
