//! One round: its parts from above downwards. At the ends of the ways of what forces or encloses the parts led are looked at with what is
//! known there; where most ways leave them the same to do, that is done once after them.

use std::cell::Cell;

use super::super::edits::unset;
use super::super::engine::{End, Fact, Tree};
use super::super::parts::{Part, cut};
use super::super::search::settle;
use super::super::several::{Env, Several, Tie, weight};
use super::super::share::merged;
use super::super::uses::{Effects, first_of, is_pure, reads_from, same_block};
use super::after::{After, FEW, Unit};
use super::leading::Order;
use super::owners::owners;
use super::touched::Touched;
use crate::list::List;
use crate::model::StepId;
use crate::program::build::no;
use crate::program::{Expr, PlaceId, Statement, Type, Value};
use crate::sorted::Set;

/// More ends of ways than this are too many.
const ENDS: usize = 500;

/// From so many states on a truth is told in front of the match on them.
const TOLD: usize = 4;

/// Places that a round uses.
pub(super) struct Free {
    /// Whether something has moved.
    pub(super) moves: PlaceId,
    /// Of no use yet.
    pub(super) goes: Vec<PlaceId>,
}

pub(super) struct Turn<'t, 'p, 'm> {
    pub(super) several: &'t Several<'p, 'm>,
    pub(super) parts: Vec<Part<'m>>,
    /// By part: what is read after it, in this round.
    later: Vec<Set<PlaceId>>,
    /// By part: what it does to the others.
    pub(super) effects: Vec<Touched>,
    /// By part: the regions whose states it writes.
    pub(super) written: Vec<Vec<usize>>,
    /// By part: where it decides on a region (the second) by the state of another one.
    pub(super) asking: Vec<Set<(usize, usize)>>,
    free: &'t Free,
    shared: After<'t>,
    left: Cell<usize>,
}

impl<'t, 'p, 'm> Turn<'t, 'p, 'm> {
    pub(super) fn of(several: &'t Several<'p, 'm>, list: &[Statement<'m>], free: &'t Free) -> Self {
        let (regions, keys) = owners(several.places, list, &several.states, &several.read_after);
        let effects = list.iter().map(Effects::of).list();
        let parts = cut((several.places, &several.situations()), list.to_vec(), &effects, &regions, &keys);
        let mut later = vec![Set::new()];
        for part in parts.iter().rev() {
            let mut reads = later.last().cloned().unwrap_or_default();
            reads.extend(Effects::of_all(&part.statements).reads.iter().copied());
            later.push(reads);
        }
        later.pop();
        later.reverse();
        let effects = parts.iter().map(|part| Touched::by(&part.statements)).collect();
        let written = parts.iter().map(|part| written(several, &part.statements)).collect();
        let asking = parts.iter().map(|part| asking(several, &part.statements)).collect();
        let shared = After::of(free);
        Self { several, parts, later, effects, written, asking, free, shared, left: Cell::new(ENDS) }
    }

    /// What a state tells of what it leads, whatever it was before: after a round, and so before the next one.
    pub(super) fn ties(&self, env: &Env, begin: &[Option<StepId>]) -> Vec<Tie> {
        let states = &self.several.states;
        let mut ties = Vec::new();
        for at in 0..self.parts.len() {
            let after: Vec<usize> = (at + 1..self.parts.len()).collect();
            let ([region], false) = (&self.written[at][..], self.order(at, &after).led.is_empty()) else { continue };
            for step in self.several.possible(*region) {
                let mut env = env.clone();
                for fact in &mut env.facts {
                    *fact = Fact::Nothing;
                }
                env.facts[states[*region].0] = Fact::Is(Value::Step(step));
                for part in &self.parts[at + 1..] {
                    self.after(&part.statements, &mut env);
                }
                for (other, state) in states.iter().enumerate().filter(|(other, _)| other != region) {
                    let Fact::Is(Value::Step(told)) = env.facts[state.0] else { continue };
                    if begin[*region] != step || begin[other] == told {
                        ties.push(Tie { leading: (*region, step), led: (other, told) });
                    }
                }
            }
        }
        ties
    }

    /// None where a region moves in several parts: what stands between them would be looked at in the middle of its way.
    pub(super) fn statements(&self, env: &Env) -> Option<Vec<Statement<'m>>> {
        let mut moved = Set::new();
        for region in self.written.iter().flatten() {
            if !moved.insert(*region) {
                return None;
            }
        }
        let all: Vec<usize> = (0..self.parts.len()).collect();
        let mut statements = Vec::new();
        for unit in self.from(&all, env.clone())? {
            statements.extend(unit.statements);
        }
        Some(statements)
    }

    /// Some parts, in their order.
    fn from(&self, parts: &[usize], mut env: Env) -> Option<Vec<Unit<'m>>> {
        let mut done = Vec::new();
        let mut left = parts.to_vec();
        left.reverse();
        while let Some(at) = left.pop() {
            let part = &self.parts[at];
            env.later.clone_from(&self.later[at]);
            let next: Vec<usize> = left.iter().rev().copied().collect();
            let Order { before, led, beside } = self.order(at, &next);
            if let ([region], false) = (&self.written[at][..], led.is_empty()) {
                // Where the others say alone what becomes of it, it does not lead.
                let state = self.several.states[*region];
                let given = self.several.folded(&part.statements, &env).1[state.0];
                if !matches!(given, Fact::Is(_)) || matches!(env.facts[state.0], Fact::Is(_)) {
                    if let Some(statements) = self.before_nested((at, &before, &led), *region, &env) {
                        done.push(Unit { at, statements, known: None });
                        for part in before.iter().chain(&[at]).chain(&led) {
                            self.after(&self.parts[*part].statements, &mut env);
                        }
                        left = beside;
                        left.reverse();
                        continue;
                    }
                }
            }
            let statements = self.part(at, &env)?;
            let known = (weight(&statements) > FEW).then(|| env.clone());
            done.push(Unit { at, statements, known });
            self.after(&part.statements, &mut env);
        }
        Some(done)
    }

    /// One part by itself.
    fn part(&self, at: usize, env: &Env) -> Option<Vec<Statement<'m>>> {
        self.part_of(&self.parts[at], &self.written[at], env)
    }

    pub(super) fn part_of(&self, part: &Part<'m>, written: &[usize], env: &Env) -> Option<Vec<Statement<'m>>> {
        let region = match *written {
            [region] => region,
            [] if part.regions.len() == 1 => part.regions[0],
            [] => return Some(self.several.swept(self.several.folded(&part.statements, env).0, env)),
            _ => return Some(self.several.spec(&part.statements, env)),
        };
        let state = self.several.states[region];
        let (folded, after) = self.several.folded(&part.statements, env);
        // What the others say alone is done without asking for the own state.
        let is_given = !written.is_empty() && matches!(after[state.0], Fact::Is(_));
        match env.facts[state.0] {
            Fact::Among(list) if !is_given => {
                let (mut done, rest) = self.in_front(&part.statements, env.lists[list].len());
                let part = Part { statements: rest, regions: part.regions.clone() };
                let arms = tidy(self.several.single(region, part, env));
                done.extend(whole(arms, state, env.lists[list].len()));
                Some(done)
            }
            Fact::Is(Value::Step(step)) if !written.is_empty() => {
                let (mut ways, _) = self.several.ways(region, &vec![step], &part.statements, env, false)?;
                let (value, mut tree) = ways.pop()?;
                settle(&mut tree, state, value);
                Some(tidy(tree.statements()))
            }
            _ => Some(tidy(self.several.swept(folded, env))),
        }
    }

    /// What asks for the state, and of which nothing in its part makes use, as whether another region may have seen its step rise: said once, in front of the match, where
    /// each of its arms would say it. And the rest.
    #[allow(clippy::type_complexity, reason = "two lists")]
    fn in_front(&self, list: &[Statement<'m>], states: usize) -> (Vec<Statement<'m>>, Vec<Statement<'m>>) {
        first_of(list, &|at, statement| match statement {
            Statement::Set(place, Expr::Is(..)) if states >= TOLD => {
                let is_own = !self.is_kept(*place);
                is_own && !list[at + 1..].iter().any(|other| reads_from(other, *place))
            }
            _ => false,
        })
    }

    /// Whether a place holds its value whoever reads it.
    pub(super) fn is_kept(&self, place: PlaceId) -> bool {
        let info = &self.several.places[place.0];
        info.is_field || matches!(info.ty, Type::State(_))
    }

    /// What is known after some statements.
    fn after(&self, list: &[Statement<'m>], env: &mut Env) {
        let (_, after) = self.several.folded(list, env);
        for (place, fact) in after.into_iter().enumerate() {
            env.facts[place] = match fact {
                Fact::Among(list) if list >= env.lists.len() => Fact::Nothing,
                // At the ends of the ways it is known which places are read after them: of locals it has to be the place itself.
                Fact::Copy(of) if !self.is_kept(of) => Fact::Nothing,
                fact => fact,
            };
        }
    }

    /// The same after what it does not lead, and what those that it leads come after.
    fn before_nested(
        &self,
        (at, before, led): (usize, &[usize], &[usize]),
        region: usize,
        env: &Env,
    ) -> Option<Vec<Statement<'m>>> {
        let mut env = env.clone();
        let mut all = Vec::new();
        for unit in self.from(before, env.clone())? {
            all.extend(unit.statements);
        }
        for part in before {
            self.after(&self.parts[*part].statements, &mut env);
        }
        env.later.clone_from(&self.later[at]);
        all.extend(self.nested((at, led), region, &env)?);
        Some(all)
    }

    /// A part that leads, and at the ends of its ways those that it leads.
    fn nested(&self, (at, led): (usize, &[usize]), region: usize, env: &Env) -> Option<Vec<Statement<'m>>> {
        let state = self.several.states[region];
        let states = match env.facts[state.0] {
            Fact::Among(list) => env.lists[list].clone(),
            Fact::Is(Value::Step(step)) => vec![step],
            _ => return None,
        };
        let (mut ways, lists) = self.several.ways(region, &states, &self.parts[at].statements, env, true)?;
        let mut ends = Vec::new();
        for (_, tree) in &ways {
            self.ends(led, tree, &lists, &mut ends)?;
        }
        for (value, tree) in &mut ways {
            settle(tree, state, *value);
        }
        self.alike(&mut ends);
        let after = self.shared.share(region, &mut ends);
        let mut rest = ends.into_iter();
        for (_, tree) in &mut ways {
            tree.each_leaf_mut(&mut |leaf| {
                let has_moved = leaf.facts[self.free.moves.0] == Fact::Is(Value::Bool(true));
                for mut unit in rest.next().into_iter().flatten() {
                    if has_moved {
                        unset(&mut unit.statements, self.free.moves);
                    }
                    leaf.body.extend(unit.statements);
                }
            });
        }
        let mut all: Vec<_> = after.goes.iter().map(|goes| Statement::Set(*goes, no())).collect();
        if let [(_, _)] = ways[..] {
            all.extend(ways.pop()?.1.statements());
        } else {
            let mut arms = Vec::new();
            for (value, tree) in ways {
                let body = tree.statements();
                if !body.is_empty() {
                    arms.push((vec![value], body));
                }
            }
            all.push(Statement::Match(state, merged(arms), Vec::new()));
        }
        all.extend(after.statements);
        Some(whole(tidy(all), state, states.len()))
    }

    /// What is led is done at each end of a way.
    fn ends(
        &self,
        led: &[usize],
        tree: &Tree<'m>,
        lists: &[Vec<Option<StepId>>],
        ends: &mut Vec<Vec<Unit<'m>>>,
    ) -> Option<()> {
        match &tree.end {
            End::Leaf(leaf) => {
                self.left.set(self.left.get().checked_sub(1)?);
                let mut env =
                    Env { facts: leaf.facts.clone(), lists: lists.to_vec(), later: Set::new(), only: Vec::new() };
                // By what else is known ends would differ that do the same.
                env.facts[self.free.moves.0] = Fact::Nothing;
                ends.push(self.from(led, env)?);
            }
            End::Fork(_, ways) => {
                for way in &**ways {
                    self.ends(led, way, lists, ends)?;
                }
            }
        }
        Some(())
    }
}

/// The regions whose states some statements write.
fn written(several: &Several<'_, '_>, list: &[Statement<'_>]) -> Vec<usize> {
    let writes = Effects::of_all(list).writes;
    (0..several.states.len()).filter(|region| writes.contains(&several.states[*region])).collect()
}

/// Where a statement decides on a region (the second) by the state of another one.
fn asking(several: &Several<'_, '_>, list: &[Statement<'_>]) -> Set<(usize, usize)> {
    let mut found = Set::new();
    for one in list {
        let led = written(several, std::slice::from_ref(one));
        if led.is_empty() {
            continue;
        }
        let reads = Effects::of(one).reads;
        for region in (0..several.states.len()).filter(|region| reads.contains(&several.states[*region])) {
            found.extend(led.iter().filter(|other| **other != region).map(|other| (region, *other)));
        }
    }
    found
}

/// Where both ways do the same, nothing is asked.
fn tidy(statements: Vec<Statement<'_>>) -> Vec<Statement<'_>> {
    let mut all = Vec::with_capacity(statements.len());
    for statement in statements {
        match statement {
            Statement::If(condition, then, otherwise) => {
                let (then, otherwise) = (tidy(then), tidy(otherwise));
                if is_pure(&condition) && same_block(&then, &otherwise) {
                    all.extend(then);
                } else {
                    all.push(Statement::If(condition, then, otherwise));
                }
            }
            Statement::Match(place, arms, otherwise) => {
                let arms = arms.into_iter().map(|(values, body)| (values, tidy(body))).collect();
                all.push(Statement::Match(place, merged(arms), tidy(otherwise)));
            }
            other => all.push(other),
        }
    }
    all
}

/// Where all states of a match do the same, it is not asked for.
fn whole(mut statements: Vec<Statement<'_>>, state: PlaceId, count: usize) -> Vec<Statement<'_>> {
    if let [Statement::Match(place, arms, otherwise)] = &mut statements[..] {
        if let ([(values, body)], [], true) = (&mut arms[..], &otherwise[..], *place == state) {
            if values.len() == count {
                return std::mem::take(body);
            }
        }
    }
    statements
}
