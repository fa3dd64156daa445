//! The search of a `grafcet` for stability: in the loop one match on the state, after it one for what is done in the state that was
//! found.
//!
//! ```text
//! loop                                          loop
//!   was.state = state                             match state
//!   clears.A→B = was.state is A && on               A:
//!   …                                                 if on:
//!   if !(was.state != state):             ->            if evolutions == 6: …
//!     stable = true                                     state = B
//!     break                                           else:
//!   …                                                   stable = true
//! lamp = was.state is B                                 break
//!                                               match state
//!                                                 B: lamp = true
//! ```
//!
//! Needs: the situation is the state of one region; one loop, nothing in front of it writes the state; on each way through it the state is
//! known.

use super::super::{Arm, Comparison, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::dead::{is_seen, read_after};
use super::early::Early;
use super::edits::{remove, replaced, rewrite};
use super::engine::meet;
use super::engine::{End, Engine, Excluding, Fact, Lost, Tree, beginning};
use super::flat::flat;
use super::live::{Live, Places};
use super::share;
use super::share::merged;
use super::sparse::{Index, States};
use super::told::{self, Told};
use super::uses::{Effects, is_written_in, writes_to};
use crate::sorted::Set;

/// More ways from one state than this are too many.
const WAYS: usize = 2_000;

/// A cycle with a loop in it.
struct Search<'m> {
    state: PlaceId,
    begin: Value,
    points: States,
    before: Vec<Statement<'m>>,
    rounds: u32,
    body: Vec<Statement<'m>>,
    after: Vec<Statement<'m>>,
    /// What stands at the end of each round.
    tail: Vec<Statement<'m>>,
}

pub(super) fn pass(program: &mut Program<'_>, tells: bool) {
    let count = program.places.len();
    let mut places = std::mem::take(&mut program.places);
    let search = Search::of(program, &mut places);
    program.places = places;
    let Some(search) = search else { return program.places.truncate(count) };
    let circle = search.circle(program);
    match circle.map_or(Err(Lost), |circle| circle.cycle(program, tells)).or_else(|Lost| search.cycle(program, tells)) {
        Ok((cycle, told)) => {
            program.cycle = cycle;
            told::no_fields(&mut program.places, told);
        }
        Err(Lost) => program.places.truncate(count),
    }
}

impl<'m> Search<'m> {
    fn of(program: &Program<'m>, places: &mut Vec<PlaceInfo<'m>>) -> Option<Self> {
        let is_situation = |role| matches!(role, Role::State(_));
        if places.iter().filter(|place| is_situation(place.role)).count() != 1 {
            return None;
        }
        let state = PlaceId(places.iter().position(|place| place.role == Role::State(0))?);
        let Initial::Value(begin @ Value::Step(step)) = places[state.0].initial else { return None };
        let mut list = opened(&program.cycle);
        let at = list.iter().position(|statement| matches!(statement, Statement::Loop { .. }))?;
        let after = list.split_off(at + 1);
        let Some(Statement::Loop { rounds, body }) = list.pop() else { return None };
        let writes = |list: &[Statement<'m>]| is_written_in(list, state);
        let loops = |list: &[Statement<'m>]| list.iter().any(|one| matches!(one, Statement::Loop { .. }));
        if writes(&list) || writes(&after) || loops(&after) || loops(&body) {
            return None;
        }
        let body = flat(&body, None, true, places);
        let points = States::of(step, program.regions.first()?);
        Some(Self { state, begin, points, before: list, rounds, body, after, tail: Vec::new() })
    }

    /// The same search where the bound is looked at after the evolutions instead of within them: what has come back to a step by then
    /// goes on for ever.
    fn circle(&self, program: &Program<'m>) -> Option<Self> {
        let is_count = |place: PlaceId| program.places[place.0].role == Role::Evolutions;
        let is_bound = |statement: &Statement<'m>| matches!(statement, Statement::If(Expr::Compare(Comparison::Equal, count, _), ..) if matches!(**count, Expr::Place(place) if is_count(place)));
        let at = self.body.iter().position(is_bound).filter(|_| program.search.comes_back)?;
        let mut body = self.body.clone();
        let Statement::If(at_bound, mut stop, _) = body.remove(at) else { return None };
        // The situation stays what it is, and no evolution is taken back.
        stop.retain(|one| !matches!(one, Statement::Set(place, _) if *place == self.state));
        let written = Effects::of_all(&body).writes;
        let seen = Effects::of_all(&self.after).reads;
        let mut copies = Vec::new();
        for place in seen.iter().filter(|place| written.contains(place)) {
            let info = &program.places[place.0];
            let is_copy = |one: &Statement<'m>| matches!(one, Statement::Set(to, Expr::Place(from)) if to == place && *from == self.state);
            match info.role {
                Role::Local if body.iter().any(is_copy) => copies.push(Statement::Set(*place, Expr::Place(self.state))),
                _ if info.is_field || is_seen(info) || is_count(*place) => {}
                _ => return None,
            }
        }
        stop.splice(0..0, copies);
        let tail = vec![Statement::If(at_bound, stop, Vec::new())];
        let (points, before, after) = (self.points.clone(), self.before.clone(), self.after.clone());
        Some(Self { points, before, body, after, tail, ..*self })
    }

    /// The cycle, and the outputs that are no fields in it.
    fn cycle(&self, program: &Program<'m>, tells: bool) -> Result<(Vec<Statement<'m>>, Told), Lost> {
        let mut round = self.body.clone();
        round.extend(self.tail.iter().cloned());
        let live = live(program, &round, &self.after);
        let mut assumed = Vec::with_capacity(program.places.len());
        let mut carried = Vec::new();
        for (index, place) in program.places.iter().enumerate() {
            let is_live = live.contains(PlaceId(index));
            assumed.push(!place.is_field && !is_seen(place) && !is_live);
            if !assumed[index] && index != self.state.0 {
                carried.push(PlaceId(index));
            }
        }
        let (mut trees, ends) = self.turns(program, &assumed, &carried)?;
        let mut acts = self.acts(program, &carried, &ends)?;
        for (tree, point) in trees.iter_mut().zip(&self.points.all) {
            if let Some(tree) = tree {
                settle(tree, self.state, *point);
            }
        }
        self.sweep(program, &mut trees, &acts);
        let mut before = self.before.clone();
        let told = if tells { self.told(program, &mut before, &mut trees, &mut acts) } else { Told::new() };
        let may = |_: &Statement<'m>| true;
        let mut bodies = Vec::with_capacity(acts.len());
        for (_, body) in &mut acts {
            bodies.push(body);
        }
        let rest = share::ends(&mut bodies, &may);
        acts.retain(|(_, body)| !body.is_empty());
        let mut after = Vec::new();
        if !acts.is_empty() {
            after.push(Statement::Match(self.state, merged(acts), Vec::new()));
        }
        after.extend(rest);
        let mut tail = self.tail.clone();
        if tail.is_empty() {
            let early =
                Early { state: self.state, points: &self.points, ends: &program.search.ends, assumed: &assumed };
            tail = early.apply(&mut trees);
        }
        let mut rounds = 1;
        for tree in trees.iter().flatten() {
            tree.each_leaf(&mut |leaf| rounds = if leaf.breaks { rounds } else { self.rounds });
        }
        let mut cycle = before;
        if rounds == 1 {
            cycle.extend(self.once(trees));
        } else {
            let mut body = self.round(trees);
            body.extend(tail);
            cycle.push(Statement::Loop { rounds, body });
        }
        cycle.extend(after);
        Ok((cycle, told))
    }

    /// What is of no use at the ends of the ways would keep them from being alike.
    fn sweep(&self, program: &Program<'m>, trees: &mut [Option<Tree<'m>>], acts: &[Arm<'m>]) {
        let mut round = vec![self.turn(trees.iter().map(|tree| tree.as_ref().map(Tree::copy)).collect())];
        round.extend(self.tail.iter().cloned());
        let live = live(program, &round, &[Statement::Match(self.state, acts.to_vec(), Vec::new())]);
        let after = read_after(program);
        for tree in trees.iter_mut().flatten() {
            tree.each_leaf_mut(&mut |leaf| Live::with(&after, live.clone()).sweep(&mut leaf.body));
        }
    }

    /// The outputs that each state tells.
    fn told(
        &self,
        program: &Program<'m>,
        before: &mut Vec<Statement<'m>>,
        trees: &mut [Option<Tree<'m>>],
        acts: &mut [Arm<'m>],
    ) -> Told {
        let Some(begin) = self.points.point(self.begin) else { return Vec::new() };
        let (points, rest) = (&self.points, &self.tail);
        told::Around { points, begin, before, trees, acts, rest }.pass(program)
    }

    /// One round of several.
    fn round(&self, mut trees: Vec<Option<Tree<'m>>>) -> Vec<Statement<'m>> {
        let mut going = Vec::new();
        for tree in trees.iter_mut().flatten() {
            collect(tree, &mut going);
        }
        let shared = share::ends(&mut going, &|one| self.may_follow(one));
        let mut body = vec![self.turn(trees)];
        body.extend(shared);
        body
    }

    /// The only round: each way ends it.
    fn once(&self, trees: Vec<Option<Tree<'m>>>) -> Vec<Statement<'m>> {
        let mut body = vec![self.turn(trees)];
        remove(&mut body, &|one| matches!(one, Statement::Break));
        body
    }

    fn may_follow(&self, statement: &Statement<'m>) -> bool {
        !matches!(statement, Statement::Mark(_)) && !writes_to(statement, self.state)
    }

    /// What a round does in each state, and what is known where the loop is left.
    #[allow(clippy::type_complexity, reason = "both by state")]
    fn turns(
        &self,
        program: &Program<'m>,
        assumed: &[bool],
        carried: &[PlaceId],
    ) -> Result<(Vec<Option<Tree<'m>>>, Vec<Option<Vec<Fact>>>), Lost> {
        let places = &program.places;
        let index = Index::of(places, &self.body, self.state, None, assumed, &self.points).ok_or(Lost)?;
        let env = beginning(places, assumed, true);
        let mut engine = Engine::new(places, (&self.body, &index), self.state, &self.points, carried, env);
        engine.excluding = Excluding::of(&program.search.excluding, places.len());
        let mut ends: Vec<Option<Vec<Fact>>> = vec![None; self.points.all.len()];
        let mut trees: Vec<Option<Tree<'m>>> = Vec::new();
        trees.resize_with(self.points.all.len(), || None);
        let mut open = Set::new();
        open.extend(self.points.point(self.begin));
        if program.forced.is_some() {
            open.extend(program.regions[0].iter().filter_map(|step| self.points.of_step(*step)));
        }
        while let Some(point) = open.first().copied() {
            open.remove(&point);
            let tree = engine.from(point, &[(self.state, Fact::Is(self.points.all[point]))], WAYS)?;
            let mut lost = false;
            tree.each_leaf(&mut |leaf| match self.points.point(leaf.state) {
                None => lost = true,
                Some(to) if leaf.breaks => _ = meet(&mut ends[to], leaf.facts.clone()),
                // What only looks as if it went on would not come back to a step.
                Some(to) if !self.tail.is_empty() && to == point => lost = true,
                Some(to) => {
                    if !self.tail.is_empty() {
                        _ = meet(&mut ends[to], self.at_bound(carried, &leaf.facts, to));
                    }
                    if trees[to].is_none() && to != point {
                        open.insert(to);
                    }
                }
            });
            if lost {
                return Err(Lost);
            }
            trees[point] = Some(tree);
        }
        // A cycle may begin wherever another one has ended.
        let begun = ends.iter().zip(&trees).all(|(end, tree)| end.is_none() || tree.is_some());
        if begun { Ok((trees, ends)) } else { Err(Lost) }
    }

    /// What is known where the bound stops the search in a state that an evolution has just led to.
    fn at_bound(&self, carried: &[PlaceId], facts: &[Fact], to: usize) -> Vec<Fact> {
        let mut facts = facts.to_vec();
        let Some(Statement::If(_, stop, _)) = self.tail.first() else { return facts };
        for statement in stop {
            let Statement::Set(place, value) = statement else { continue };
            let fact = match value {
                Expr::Value(value) => Fact::Is(*value),
                _ => Fact::Is(self.points.all[to]),
            };
            if let Some(at) = carried.iter().position(|one| one == place) {
                facts[at] = fact;
            }
        }
        facts
    }

    /// What is done after the loop, by the state in which it was left.
    fn acts(
        &self,
        program: &Program<'m>,
        carried: &[PlaceId],
        ends: &[Option<Vec<Fact>>],
    ) -> Result<Vec<Arm<'m>>, Lost> {
        let places = &program.places;
        // In each state it is asked of each of these conditions whether it holds there.
        let mut after = self.after.clone();
        rewrite(&mut after, &mut |expr| replaced(expr, &gathered));
        let none = vec![false; places.len()];
        let index = Index::of_region(places, &after, (self.state, none.clone()), &none, &self.points, 0);
        // Nothing is known of what the loop has written but what it is left with.
        let nothing = vec![Fact::Nothing; places.len()];
        let mut engine = Engine::new(places, (&after, &index), self.state, &self.points, &[], nothing);
        let mut touched = Effects::of_all(&self.before);
        touched.add_all(&self.body);
        for (index, place) in places.iter().enumerate() {
            let value = super::fold::initial(place).filter(|_| !matches!(place.ty, Type::User(_)));
            if !place.is_field && !touched.writes.contains(&PlaceId(index)) {
                engine.env[index] = value.map_or(Fact::Initial, Fact::Is);
            }
        }
        let mut acts = Vec::new();
        for (point, facts) in ends.iter().enumerate() {
            let Some(facts) = facts else { continue };
            let mut known = vec![(self.state, Fact::Is(self.points.all[point]))];
            known.extend(carried.iter().copied().zip(facts.iter().copied()).filter(|(_, fact)| *fact != Fact::Nothing));
            let tree = engine.from(point, &known, WAYS)?;
            let End::Leaf(leaf) = tree.end else { return Err(Lost) };
            acts.push((vec![self.points.all[point]], leaf.body));
        }
        Ok(acts)
    }

    fn turn(&self, trees: Vec<Option<Tree<'m>>>) -> Statement<'m> {
        let mut arms = Vec::new();
        for (point, tree) in self.points.all.iter().zip(trees) {
            if let Some(tree) = tree {
                arms.push((vec![*point], tree.statements()));
            }
        }
        Statement::Match(self.state, arms, Vec::new())
    }
}

/// One question whether a region is in one of many states, in place of one for each of them.
fn gathered<'m>(expr: &Expr<'m>) -> Option<Expr<'m>> {
    let Expr::Any(parts) = expr else { return None };
    let mut all: Vec<Expr<'m>> = Vec::new();
    for part in parts {
        match (all.last_mut(), part) {
            (Some(Expr::Is(place, steps)), Expr::Is(other, more)) if place == other => steps.extend(more),
            _ => all.push(replaced(part, &gathered)),
        }
    }
    Some(if all.len() == 1 { all.remove(0) } else { Expr::Any(all) })
}

/// Paragraphs opened.
pub(super) fn opened<'m>(statements: &[Statement<'m>]) -> Vec<Statement<'m>> {
    let mut list = Vec::new();
    for statement in statements {
        match statement {
            Statement::Part(_, body) => list.extend(opened(body)),
            other => list.push(other.clone()),
        }
    }
    list
}

/// What is live where a round begins or the loop is left.
fn live<'m>(program: &Program<'m>, body: &[Statement<'m>], after: &[Statement<'m>]) -> Places {
    let read = read_after(program);
    let mut live = Live::after(&read);
    live.sweep(&mut after.to_vec());
    live.rounds(&mut body.to_vec());
    live.now
}

/// The state is written once on each way, at its end, and only where it changes: what stands in between knows it.
pub(super) fn settle(tree: &mut Tree<'_>, state: PlaceId, from: Value) {
    let other = |statement: &Statement<'_>| !matches!(statement, Statement::Set(place, _) if *place == state);
    tree.body.retain(other);
    match &mut tree.end {
        End::Leaf(leaf) => {
            leaf.body.retain(other);
            if leaf.state != from {
                leaf.body.insert(0, Statement::Set(state, Expr::Value(leaf.state)));
            }
        }
        End::Fork(_, ways) => ways.iter_mut().for_each(|way| settle(way, state, from)),
    }
}

/// The ends of the ways that stay in the loop.
fn collect<'t, 'm>(tree: &'t mut Tree<'m>, going: &mut Vec<&'t mut Vec<Statement<'m>>>) {
    match &mut tree.end {
        End::Leaf(leaf) if leaf.breaks => {}
        End::Leaf(leaf) => going.push(&mut leaf.body),
        End::Fork(_, ways) => ways.iter_mut().for_each(|way| collect(way, going)),
    }
}
