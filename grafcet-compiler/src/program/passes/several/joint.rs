//! A part of regions that depend on each other: first the states of one region beside which nothing else is active, or a condition that
//! looks at several regions.

use super::super::belonging::Deciding;
use super::super::engine::{Among, Fact};
use super::super::parts::{Looked, Part};
use super::super::share;
use super::super::share::merged;
use super::super::sparse::Index;
use super::super::uses::{Effects, each_asked, each_read, is_pure, mentions, writes_to};
use super::{Env, Several, weight};
use crate::list::List;
use crate::program::build::not;
use crate::program::{Expr, PlaceId, PlaceInfo, Statement, Type, Value};
use crate::sorted::Set;

/// Of so many conditions each is tried.
const FEW: usize = 3;

/// How many statements there are, and how often they ask for a place: a truth of many parts is no short statement.
pub(super) fn size(statements: &[Statement<'_>]) -> usize {
    let mut size = weight(statements);
    each_asked(statements, &mut |_| size += 1);
    size
}

/// What a truth of the cycle is set from, if that is done once, in front of a statement, and says the same there.
fn value_of<'s, 'm>(
    places: &[PlaceInfo<'m>],
    list: &'s [Statement<'m>],
    before: usize,
    truth: PlaceId,
) -> Option<&'s Expr<'m>> {
    let info = &places[truth.0];
    let mut writers = list.iter().enumerate().filter(|(_, one)| writes_to(one, truth));
    let (at, Statement::Set(_, value)) = writers.next()? else { return None };
    if writers.next().is_some() || at >= before || mentions(value, truth) {
        return None;
    }
    let mut lasts = is_pure(value);
    each_read(value, &mut |read| lasts &= !list[at..before].iter().any(|one| writes_to(one, read)));
    (lasts && !info.is_field && matches!(info.ty, Type::Bool)).then_some(value)
}

impl<'m> Several<'_, 'm> {
    /// A part of regions that depend on each other.
    pub(super) fn joint(&self, part: Part<'m>, env: &Env) -> Vec<Statement<'m>> {
        if let Some(done) = self.by_head(&part, env) {
            return done;
        }
        let synchronised = self.synchronised(&part);
        let by_clearing = if synchronised.len() == 1 { None } else { self.by_clearing(&part, env) };
        match by_clearing {
            Some(done) if synchronised.len() > FEW => done,
            Some(done) => {
                let by_condition = self.by_condition(part, &synchronised, env);
                // What is asked first is known wherever it matters, which its length does not show.
                if 7 * size(&done) < 5 * size(&by_condition) { done } else { by_condition }
            }
            None => self.by_condition(part, &synchronised, env),
        }
    }

    /// First the states of one region beside which nothing else is active.
    fn by_head(&self, part: &Part<'m>, env: &Env) -> Option<Vec<Statement<'m>>> {
        let mut best: Option<(usize, Among)> = None;
        for region in &*part.regions {
            let Fact::Among(list) = env.facts[self.states[*region].0] else { continue };
            let mut alone = Vec::new();
            for step in env.lists[list].iter().filter(|step| step.is_some()) {
                let known = |other: &usize| {
                    let unknown = matches!(env.facts[self.states[*other].0], Fact::Among(_));
                    other == region || !unknown || self.narrowed(*other, *step, env).is_some()
                };
                if part.regions.iter().all(known) {
                    alone.push(*step);
                }
            }
            if !alone.is_empty() && best.as_ref().is_none_or(|(_, before)| before.len() < alone.len()) {
                best = Some((*region, alone));
            }
        }
        let (region, alone) = best?;
        let state = self.states[region];
        let here = self.beside_all(region, &alone, part, env);
        let (list, _) = self.folded(&part.statements, &here);
        let trees = self.arms(region, &alone, &list, &here)?;
        let mut arms = Vec::new();
        for (value, tree) in trees {
            arms.push((vec![value], tree.statements()));
        }
        let mut env = env.clone();
        let Fact::Among(list) = env.facts[state.0] else { return None };
        let mut left = env.lists[list].clone();
        left.retain(|step| !alone.contains(step));
        for other in part.regions.iter().filter(|other| **other != region) {
            let Fact::Among(list) = env.facts[self.states[*other].0] else { continue };
            let mut beside = env.lists[list].clone();
            beside.retain(|step| left.iter().any(|one| self.may_meet(*one, *step)));
            env.facts[self.states[*other].0] = env.among(beside);
        }
        let is_left = !left.is_empty();
        env.facts[state.0] = env.among(left);
        let mut rest = if is_left { self.spec(&part.statements, &env) } else { Vec::new() };
        let may = |one: &Statement<'m>| !matches!(one, Statement::Mark(_)) && !writes_to(one, state);
        let mut bodies = Vec::new();
        bodies.extend(is_left.then_some(&mut rest));
        for (_, body) in &mut arms {
            bodies.push(body);
        }
        let after = share::ends(&mut bodies, &may);
        let mut all = vec![Statement::Match(state, merged(arms), rest)];
        all.extend(after);
        Some(all)
    }

    /// What is known where a region is in one of these states: of the others what all of these tell.
    fn beside_all(&self, region: usize, states: &Among, part: &Part<'m>, env: &Env) -> Env {
        let mut here = env.clone();
        here.facts[self.states[region].0] = here.among(states.clone());
        for other in part.regions.iter().filter(|other| **other != region) {
            let mut told = states.iter().map(|step| self.narrowed(*other, *step, env));
            let first = told.next().flatten();
            if let Some(fact) = first.filter(|_| told.all(|fact| fact == first)) {
                here.facts[self.states[*other].0] = fact;
            }
        }
        here
    }

    /// The conditions that look at several regions; those alone that also decide about several, if there are any: a region that only looks at another one is a part of
    /// its own after them.
    fn synchronised(&self, part: &Part<'m>) -> Vec<usize> {
        let mut found = Vec::new();
        for (at, statement) in part.statements.iter().enumerate() {
            let Statement::Set(place, value) = statement else { continue };
            let mut regions = Set::new();
            each_read(value, &mut |read| regions.extend(self.states.iter().position(|state| *state == read)));
            if regions.len() > 1 && matches!(self.places[place.0].ty, Type::Bool) && !self.places[place.0].is_field {
                found.push(at);
            }
        }
        let looked = Looked::at(self.places, part.statements.clone());
        let regions = Deciding::of(self.places, &looked).regions;
        let deciding = found.iter().copied().filter(|at| regions[*at].len() > 1).list();
        if deciding.is_empty() { found } else { deciding }
    }

    /// First such a condition: the one that leaves the least to do, where these are few.
    fn by_condition(&self, part: Part<'m>, found: &[usize], env: &Env) -> Vec<Statement<'m>> {
        let found = if found.len() > FEW { &found[..1] } else { found };
        let mut best: Option<(usize, Vec<Statement<'m>>)> = None;
        for at in found {
            if self.effort.get() == 0 {
                break;
            }
            // What the others ask stands there once more, which has to be worth it.
            let alone = self.without_others(&part, *at, env);
            let alone = alone.map(|(part, off)| (size(&part.statements), part, off));
            let plain = (usize::MAX, part.clone(), Vec::new());
            for (most, part, off) in [Some(plain), alone].into_iter().flatten() {
                let Some(asked) = self.asked_first(part.statements, *at, &off, env) else { continue };
                let size = size(&asked);
                if size <= most && best.as_ref().is_none_or(|(least, _)| size < *least) {
                    best = Some((size, asked));
                }
            }
        }
        best.map_or(part.statements, |(_, best)| best)
    }

    /// A condition that needs others not to hold, those that come before it in an `sfc`: with what they ask in place of their truths, so that these may be set where they belong.
    /// The truths are false where it holds.
    fn without_others(&self, part: &Part<'m>, at: usize, env: &Env) -> Option<(Part<'m>, Vec<PlaceId>)> {
        let Statement::Set(place, Expr::All(parts)) = &part.statements[at] else { return None };
        let index = Index::whole(self.places.len(), 0, &self.points[0]);
        let mut engine = self.engine(&[], &index, 0, env);
        // What is set in front of it is not what the part begins with.
        for written in &Effects::of_all(&part.statements[..at]).writes {
            engine.note(*written, Fact::Nothing);
        }
        let known = engine.trail.len();
        let (mut asks, mut off) = (Vec::with_capacity(parts.len()), Vec::new());
        for ask in parts {
            let other = match ask {
                Expr::Not(inner) => match **inner {
                    Expr::Place(truth) => {
                        value_of(self.places, &part.statements, at, truth).map(|value| (truth, value))
                    }
                    _ => None,
                },
                _ => None,
            };
            let ask = match other {
                Some((truth, value)) => {
                    off.push(truth);
                    engine.fold(&not(value.clone()))
                }
                None => engine.fold(ask),
            };
            engine.tell(&ask, true);
            asks.push(ask);
        }
        if off.is_empty() {
            return None;
        }
        engine.back(known);
        let condition = engine.fold(&Expr::All(asks));
        let mut part = part.clone();
        part.statements[at] = Statement::Set(*place, condition);
        Some((part, off))
    }

    /// The condition at a place is asked, and the rest done by what it says, if what stands in front of it may stand after it. Where it holds, the truths `off` are false.
    fn asked_first(
        &self,
        list: Vec<Statement<'m>>,
        at: usize,
        off: &[PlaceId],
        env: &Env,
    ) -> Option<Vec<Statement<'m>>> {
        self.asked_before(list, (at, None), off, env)
    }

    /// The same of a part of a condition: what is left of it is asked where that part holds.
    pub(super) fn asked_before(
        &self,
        mut list: Vec<Statement<'m>>,
        (at, left): (usize, Option<&Expr<'m>>),
        off: &[PlaceId],
        env: &Env,
    ) -> Option<Vec<Statement<'m>>> {
        let mut asking = Effects::of(&list[at]);
        if let Some(left) = left {
            each_read(left, &mut |place| _ = asking.reads.insert(place));
        }
        let after = list.split_off(at);
        let (before, mut rest) = needed(&list, asking.reads.clone())?;
        let swaps = |_: &&Statement<'m>| asking.may_swap(&Effects::of_all(&rest));
        let Some(Statement::Set(place, condition)) = after.first().filter(swaps) else { return None };
        let (place, condition) = (*place, condition.clone());
        rest.extend(after.into_iter().skip(1));
        let index = Index::whole(self.places.len(), 0, &self.points[0]);
        let mut engine = self.engine(&[], &index, 0, env);
        let mut body = Vec::new();
        engine.block(&before, &mut body);
        let unasked = engine.env.clone();
        let mut ways = Vec::new();
        for holds in [true, false] {
            let mark = engine.trail.len();
            engine.tell(&condition, holds);
            let mut rest = rest.clone();
            let mut known = Vec::new();
            if let Some(left) = left.filter(|_| holds) {
                rest.insert(0, Statement::Set(place, left.clone()));
            } else {
                engine.note(place, Fact::Is(Value::Bool(holds)));
                known.push((place, holds));
            }
            if holds {
                for truth in off {
                    engine.note(*truth, Fact::Is(Value::Bool(false)));
                    rest.retain(|one| !matches!(one, Statement::Set(place, _) if place == truth));
                    known.push((*truth, false));
                }
            }
            let (later, only) = (env.later.clone(), env.only.clone());
            let mut env = Env { facts: engine.env.clone(), lists: engine.lists.clone(), later, only };
            self.tell_only(&before, &mut env);
            self.narrow(&unasked, &mut env);
            let mut way = self.spec(&rest, &env);
            known.retain(|(place, _)| env.later.contains(place) || self.read_after.contains(*place));
            way.splice(
                0..0,
                known.iter().map(|(place, holds)| Statement::Set(*place, Expr::Value(Value::Bool(*holds)))),
            );
            ways.push(way);
            engine.back(mark);
        }
        let (Some(mut otherwise), Some(mut then)) = (ways.pop(), ways.pop()) else { return None };
        let may = |one: &Statement<'m>| !matches!(one, Statement::Mark(_));
        let after = share::ends(&mut [&mut then, &mut otherwise], &may);
        if then.is_empty() {
            body.push(Statement::If(not(condition), otherwise, then));
        } else {
            body.push(Statement::If(condition, then, otherwise));
        }
        body.extend(after);
        Some(body)
    }

    /// Where a condition has just told of regions, the states of the others that cannot be beside those it names are left out. In an `sfc` a region that has moved meets all
    /// states of those that have not yet; in a `grafcet` it does not, where it enclosed them.
    fn narrow(&self, unasked: &[Fact], env: &mut Env) {
        let told = |state: &PlaceId| env.facts[state.0] != unasked[state.0];
        let told: Vec<usize> = (0..self.states.len()).filter(|region| told(&self.states[*region])).collect();
        for region in (0..self.states.len()).filter(|region| self.is_flat && !told.contains(region)) {
            let state = self.states[region];
            let Fact::Among(list) = env.facts[state.0] else { continue };
            let mut left = env.lists[list].clone();
            for other in &told {
                match env.facts[self.states[*other].0] {
                    Fact::Is(Value::Step(step)) => left.retain(|one| self.may_meet(*one, step)),
                    Fact::Among(list) => {
                        left.retain(|one| env.lists[list].iter().any(|step| self.may_meet(*one, *step)));
                    }
                    _ => {}
                }
            }
            if !left.is_empty() && left.len() < env.lists[list].len() {
                env.facts[state.0] = env.among(left);
            }
        }
    }
}

/// The statements that set what is wanted, and the others, if the first can be done before these.
#[allow(clippy::type_complexity, reason = "two lists")]
fn needed<'m>(list: &[Statement<'m>], mut wanted: Set<PlaceId>) -> Option<(Vec<Statement<'m>>, Vec<Statement<'m>>)> {
    let effects = list.iter().map(Effects::of).list();
    let mut in_front = vec![false; list.len()];
    for (index, effects) in effects.iter().enumerate().rev() {
        if !effects.writes.is_disjoint(&wanted) {
            in_front[index] = true;
            wanted.extend(effects.reads.iter().copied());
        }
    }
    let (mut front, mut back, mut passed) = (Vec::new(), Vec::new(), Effects::default());
    for ((statement, effects), is_in_front) in list.iter().zip(&effects).zip(in_front) {
        if !is_in_front {
            passed.join(effects);
            back.push(statement.clone());
        } else if effects.may_swap(&passed) {
            front.push(statement.clone());
        } else {
            return None;
        }
    }
    Some((front, back))
}
