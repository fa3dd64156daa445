//! A part of one region: for each state what is done in it, and whether the ways to a state act on their own.

use super::super::engine::{Among, Fact, Tree};
use super::super::fold::initial;
use super::super::live::{Live, Places};
use super::super::parts::Part;
use super::super::share;
use super::super::share::merged;
use super::super::sparse::{Index, deciding};
use super::super::split::collect;
use super::super::uses::{Effects, each_asked, each_read, each_written, first_of, sum, writes_to};
use super::{Env, Several, Tie};
use crate::list::List;
use crate::model::{Id, StepId};
use crate::program::{Arm, Expr, PlaceId, Statement, Type, Value};
use crate::sorted::Set;

/// More ways from one state than this are too many.
const WAYS: usize = 64;

/// For fewer states it is not worth while to find out which statements matter in which one.
const FEW: usize = 6;

/// What takes so many times its length by state stays as it is.
const MANY: usize = 3;

/// In statements, what a second match costs.
const DISPATCH: usize = 2;

impl<'m> Several<'_, 'm> {
    /// A part of one region: an arm for each of its states.
    pub(in super::super) fn single(&self, region: usize, part: Part<'m>, env: &Env) -> Vec<Statement<'m>> {
        if let Some((before, rest)) = self.of_state_before(region, &part, env) {
            let mut known = env.clone();
            each_asked(&rest, &mut |place| _ = known.later.insert(place));
            let mut done = self.by_state_before(region, &before, &known);
            if !rest.is_empty() {
                let mut env = env.clone();
                self.after(&before, &mut env);
                done.extend(self.single(region, Part { statements: rest, regions: part.regions }, &env));
            }
            return done;
        }
        let Fact::Among(list) = env.facts[self.states[region].0] else { return part.statements };
        let states = env.lists[list].clone();
        let (mut done, rest) = self.of_others(region, &part.statements, env);
        let env_before = env;
        let mut env = env.clone();
        self.after(&done, &mut env);
        let Some(mut arms) = self.arms(region, &states, &rest, &env) else { return part.statements };
        let state = self.states[region];
        let plain = evolution(state, arms.iter().map(|(value, tree)| (*value, tree.copy())).collect());
        let joined = self.joined(region, &mut arms);
        let whole = weight(&joined) + if joined.len() > 1 { DISPATCH } else { 0 };
        let own = weight(&part.statements);
        if MANY * own < whole.min(weight(&plain)) && !self.decides(&part.statements) {
            // Each state does nearly all of it.
            return self.swept(self.folded(&part.statements, env_before).0, env_before);
        }
        done.extend(if weight(&plain) <= whole { plain } else { joined });
        done
    }

    /// What does not ask for the region and is told to others, as whether a step rises for which it waits: it is the same in all its states. And the rest.
    #[allow(clippy::type_complexity, reason = "two lists")]
    fn of_others(&self, region: usize, list: &[Statement<'m>], env: &Env) -> (Vec<Statement<'m>>, Vec<Statement<'m>>) {
        let later = self.later(env);
        first_of(list, &|_, statement| match statement {
            Statement::Set(place, Expr::Is(of, _)) => {
                let is_own = *of == self.states[region] || Some(*of) == self.was[region];
                let kept = |one: &Statement<'m>| matches!(one, Statement::Set(_, Expr::Place(of)) if of == place);
                let is_told = later.contains(*place) || list.iter().any(kept);
                !is_own && is_told && !self.places[place.0].is_field
            }
            _ => false,
        })
    }

    /// What asks for the state before, as what is done when a step is left, and the rest of a part in which nothing evolves, if the first can be done first.
    #[allow(clippy::type_complexity, reason = "two lists")]
    fn of_state_before(
        &self,
        region: usize,
        part: &Part<'m>,
        env: &Env,
    ) -> Option<(Vec<Statement<'m>>, Vec<Statement<'m>>)> {
        let was = self.was[region]?;
        if self.decides(&part.statements) {
            return None;
        }
        let later = self.later(env);
        let (mut before, mut rest) = (Vec::new(), Vec::new());
        let (mut truths, mut passed): (Set<PlaceId>, Effects) = (Set::new(), Effects::default());
        for one in &part.statements {
            let (truth, condition) = match one {
                Statement::Set(truth, value) if !later.contains(*truth) => (Some(*truth), Some(value)),
                Statement::If(condition, _, otherwise) if otherwise.is_empty() => (None, Some(condition)),
                _ => (None, None),
            };
            let parts = match condition {
                Some(Expr::All(parts)) => &parts[..],
                Some(one) => std::slice::from_ref(one),
                None => &[],
            };
            let asks = |part: &Expr<'m>| match part {
                Expr::Is(place, _) => *place == was,
                Expr::Place(place) => truths.contains(place),
                _ => false,
            };
            if parts.iter().any(asks) && Effects::of(one).may_swap(&passed) {
                truths.extend(truth);
                before.push(one.clone());
            } else {
                passed.add(one);
                rest.push(one.clone());
            }
        }
        // Who asks for a truth later has to find it set.
        let is_left = truths.iter().all(|truth| !passed.reads.contains(truth));
        (before.len() > 1 && is_left).then_some((before, rest))
    }

    /// For each state before what is done.
    fn by_state_before(&self, region: usize, list: &[Statement<'m>], env: &Env) -> Vec<Statement<'m>> {
        let Some(was) = self.was[region] else { return list.to_vec() };
        let mut arms = Vec::new();
        for step in self.possible(region) {
            let mut env = env.clone();
            env.facts[was.0] = Fact::Is(Value::Step(step));
            let (body, _) = self.folded(list, &env);
            let body = self.swept(body, &env);
            if !body.is_empty() {
                arms.push((vec![Value::Step(step)], body));
            }
        }
        vec![Statement::Match(was, merged(arms), Vec::new())]
    }

    /// What is done on all ways from some states of a region.
    pub(super) fn arms(
        &self,
        region: usize,
        states: &Among,
        list: &[Statement<'m>],
        env: &Env,
    ) -> Option<Vec<(Value, Tree<'m>)>> {
        Some(self.ways(region, states, list, env, false)?.0)
    }

    /// The same, if it is wanted with all that is known at the ends of the ways.
    #[allow(clippy::type_complexity, reason = "the ways, and what their facts stand for")]
    pub(in super::super) fn ways(
        &self,
        region: usize,
        states: &Among,
        list: &[Statement<'m>],
        env: &Env,
        tells_all: bool,
    ) -> Option<(Vec<(Value, Tree<'m>)>, Vec<Among>)> {
        let (points, state) = (&self.points[region], self.states[region]);
        let writes = |one: &Statement<'m>| self.decides(std::slice::from_ref(one));
        let end = list.iter().rposition(writes);
        let later = self.later(env);
        let own = self.own_truths(list, &later, env);
        let mut index = if states.len() < FEW {
            Index::whole(self.places.len(), list.len(), points)
        } else {
            let is_false = |fact: &Fact| *fact == Fact::Is(Value::Bool(false));
            let mut assumed = env.facts.iter().map(is_false).list();
            for truth in &own {
                assumed[truth.0] = true;
            }
            let copies = env.facts.iter().map(|fact| *fact == Fact::Copy(state)).list();
            Index::of_region(self.places, list, (state, copies), &assumed, points, end.unwrap_or(0))
        };
        if let Some(end) = end {
            index.last = end;
            index.forks = deciding(self.places, &list[..=end], &self.states);
            for (place, forks) in self.places.iter().zip(&mut index.forks) {
                *forks &= matches!(place.ty, Type::Bool);
            }
            self.ask_late(region, &list[..=end], &mut index.forks);
        }
        let mut engine = self.engine(list, &index, region, env);
        engine.tells_all = tells_all;
        for truth in own {
            engine.env[truth.0] = Fact::Assumed(Value::Bool(false));
        }
        let mut arms = Vec::new();
        for step in states {
            let mut known = vec![(state, Fact::Is(Value::Step(*step)))];
            for other in (0..self.states.len()).filter(|other| *other != region) {
                let tie = |tie: &&Tie| tie.leading == (region, *step) && tie.led.0 == other;
                let tied =
                    self.ties.iter().find(tie).filter(|_| matches!(env.facts[self.states[other].0], Fact::Among(_)));
                if let Some(tie) = tied {
                    known.push((self.states[other], Fact::Is(Value::Step(tie.led.1))));
                } else if let Some(fact) = self.narrowed(other, *step, env) {
                    known.push((self.states[other], fact));
                } else if let Some(states) = self.with_a_step(other, (region, *step), env) {
                    known.push((self.states[other], engine.among(states)));
                }
            }
            for (truth, of, steps) in &env.only {
                let is_state = *of == state || env.facts[of.0] == Fact::Copy(state);
                if is_state && env.facts[truth.0] == Fact::Nothing && !step.is_some_and(|step| steps.contains(&step)) {
                    known.push((*truth, Fact::Is(Value::Bool(false))));
                }
            }
            let point = points.point(Value::Step(*step))?;
            let mut tree = engine.from(point, &known, WAYS).ok()?;
            tree.each_leaf_mut(&mut |leaf| Live::with(&self.read_after, later.clone()).sweep(&mut leaf.body));
            arms.push((Value::Step(*step), tree));
        }
        Some((arms, engine.lists))
    }

    /// What does not depend on the region, as whether an input or the step of another one rises, is asked where a truth is set that does: it is no matter in
    /// all other states.
    fn ask_late(&self, region: usize, list: &[Statement<'m>], forks: &mut [bool]) {
        let of_region = |place: PlaceId| place == self.states[region] || Some(place) == self.was[region];
        let mut late: Set<PlaceId> = Set::new();
        for statement in list {
            if let Statement::Set(place, value) = statement {
                let mut is_free = forks[place.0];
                each_read(value, &mut |read| is_free &= !of_region(read) && !forks[read.0]);
                if is_free {
                    late.insert(*place);
                }
            }
        }
        for statement in list {
            let decides = matches!(statement, Statement::Set(place, _) if forks[place.0] && !late.contains(place));
            if !decides {
                each_asked(std::slice::from_ref(statement), &mut |place| _ = late.remove(&place));
            }
        }
        for place in &*late {
            forks[place.0] = false;
        }
    }

    /// Truths that are set before they are read, and that nobody reads afterwards: what they hold in front of the statements is of no matter, so they
    /// may be taken for false there, and a state is not looked at with what sets them in others.
    fn own_truths(&self, list: &[Statement<'m>], later: &Places, env: &Env) -> Vec<PlaceId> {
        let mut seen = vec![false; self.places.len()];
        let mut own = Vec::new();
        for statement in list {
            each_asked(std::slice::from_ref(statement), &mut |place| seen[place.0] = true);
            if let Statement::Set(place, _) = statement {
                let info = &self.places[place.0];
                let is_free = !seen[place.0] && !info.is_field && !later.contains(*place);
                if is_free && env.facts[place.0] == Fact::Nothing && initial(info) == Some(Value::Bool(false)) {
                    own.push(*place);
                }
            }
            each_written(std::slice::from_ref(statement), &mut |place| seen[place.0] = true);
        }
        own
    }

    /// What is known of a region beside a step of another one, where that is a single state.
    pub(super) fn narrowed(&self, region: usize, step: Option<StepId>, env: &Env) -> Option<Fact> {
        let Fact::Among(list) = env.facts[self.states[region].0] else { return None };
        let mut left = env.lists[list].iter().filter(|other| self.may_meet(step, **other));
        match (left.next(), left.next()) {
            (Some(one), None) => Some(Fact::Is(Value::Step(*one))),
            _ => None,
        }
    }

    /// The states of a region beside that of another one, if it is known that it has a step there and was not before.
    fn with_a_step(&self, region: usize, (above, step): (usize, Option<StepId>), env: &Env) -> Option<Among> {
        let Fact::Among(list) = env.facts[self.states[region].0] else { return None };
        let mut states = env.lists[list].clone();
        let has = self.meetings.iter().any(|meeting| !meeting.allows((above, step), (region, None)));
        if !states.contains(&None) || !has {
            return None;
        }
        states.retain(Option::is_some);
        Some(states)
    }

    pub(super) fn may_meet(&self, one: Option<StepId>, other: Option<StepId>) -> bool {
        let (Some(one), Some(other)) = (one, other) else { return true };
        self.beside.contains(one.index(), other.index())
    }

    /// What ways to one state have in common is done after them, by that state.
    fn joined(&self, region: usize, arms: &mut [(Value, Tree<'m>)]) -> Vec<Statement<'m>> {
        let (points, state) = (&self.points[region], self.states[region]);
        let mut leaves: Vec<Vec<&mut Vec<Statement<'m>>>> = Vec::new();
        leaves.resize_with(points.all.len(), Vec::new);
        let mut kept = Vec::with_capacity(arms.len());
        for (value, tree) in arms.iter_mut() {
            collect(tree, points, &mut leaves);
            kept.push(*value);
        }
        let may = |one: &Statement<'m>| !matches!(one, Statement::Mark(_)) && !writes_to(one, state);
        let mut acts: Vec<Arm<'m>> = Vec::new();
        for (point, mut ends) in points.all.iter().zip(leaves) {
            if !ends.is_empty() {
                acts.push((vec![*point], share::ends(&mut ends, &may)));
            }
        }
        let mut bodies = Vec::with_capacity(acts.len());
        for (_, body) in &mut acts {
            bodies.push(body);
        }
        let rest = share::ends(&mut bodies, &may);
        acts.retain(|(_, body)| !body.is_empty());
        let mut all = Vec::new();
        let evolving = evolution(state, arms.iter().map(|(value, tree)| (*value, tree.copy())).collect());
        if weight(&evolving) > 0 {
            all.extend(evolving);
        }
        if !acts.is_empty() {
            all.push(Statement::Match(state, merged(acts), Vec::new()));
        }
        all.extend(rest);
        all
    }
}

/// A match on the state; what all states do needs none.
fn evolution(state: PlaceId, arms: Vec<(Value, Tree<'_>)>) -> Vec<Statement<'_>> {
    let states = arms.len();
    let mut all = Vec::new();
    for (value, tree) in arms {
        let body = tree.statements();
        if !body.is_empty() {
            all.push((vec![value], body));
        }
    }
    let mut arms = merged(all);
    match &mut arms[..] {
        [(values, body)] if values.len() == states => std::mem::take(body),
        _ => vec![Statement::Match(state, arms, Vec::new())],
    }
}

/// How many statements there are.
pub(in super::super) fn weight(statements: &[Statement<'_>]) -> usize {
    sum(statements, &|statement| match statement {
        Statement::Part(..) | Statement::Loop { .. } | Statement::Match(..) => 0,
        _ => 1,
    })
}
