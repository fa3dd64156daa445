//! A cycle of several regions: what concerns one region alone in one match on its state.
//!
//! ```text
//! clears.B1→B2 = was.state.B1 is B1 && x1            match state.A1
//! …                                                    start: …
//! if clears.(A2,B2)→C: state.A1 = C          ->        C: if done: …
//! if clears.(A2,B2)→C: state.B1 = none                 others:
//! if clears.B1→B2: state.B1 = B2                         if state.A1 is A2 && state.B1 is B2 && x2: …
//! lamp = state.B1 is B2                                  else:
//!                                                          match state.A1 …
//!                                                          match state.B1
//!                                                            B1: if x1: …
//! ```
//!
//! Some statements are looked at with all that is known of the states, cut into parts (`parts`), and each part looked at by itself (`spec`):
//! - of one region: for each state that it may have, what is done in it (`engine`);
//! - of all regions: what a condition decides that looks at none of them and decides about several, as that of an `any` that leaves parallel branches, is done by what it says, if that is
//!   shorter; so is the part of such a condition that looks at none of them, if it is for many steps (`stop`);
//! - of regions that depend on each other: where one of them has states beside which no other step is active, those first; else where one
//!   condition looks at several regions, it is asked first, and the rest done by what it says; where several do, or none, each transition in one
//!   place (`clearing`), if that is shorter.
//!
//! Needs: several regions; no loop. What is not understood stays as it is.

mod apart;
mod clearing;
mod env;
mod joint;
mod prepared;
mod single;
mod spec;
mod stop;

pub(super) use apart::{Actions, pass as apart};
pub(super) use env::Env;
use prepared::direct;
pub(super) use single::weight;

use std::cell::Cell;

use super::super::{Deadline, Expr, Initial, Meeting, PlaceId, PlaceInfo, Program, Role, Statement, Type, Value};
use super::dead::read_after;
use super::engine::{Among, Engine, Fact};
use super::excluding::Situations;
use super::flat::flat;
use super::fold::initial;
use super::hoist;
use super::live::{Live, Places};
use super::share;
use super::sparse::{Index, States};
use super::starting;
use super::uses::{Effects, each_asked, each_written, is_read_in, mentions, writes_to};
use crate::analysis::Relation;
use crate::model::StepId;
use crate::sorted::Set;

pub(super) fn pass(program: &mut Program<'_>) {
    evolve(program, Actions::OnTheirWays);
}

/// Whether the cycle is another one now.
fn evolve(program: &mut Program<'_>, actions: Actions) -> bool {
    let count = program.places.len();
    let mut places = std::mem::take(&mut program.places);
    let list = program.beside.is_empty().then(Vec::new).unwrap_or_else(|| {
        let first = places.iter().position(|place| place.role == Role::First).map(PlaceId);
        let mut list = flat(&program.cycle, first, false, &mut places);
        direct(&places, &mut list);
        list
    });
    let was_first = PlaceId(places.len());
    if actions != Actions::OnTheirWays {
        places.push(PlaceInfo::truth("was.first".to_owned()));
    }
    program.places = places;
    match Several::of(program).and_then(|several| several.cycle(&list, (actions, was_first))) {
        // What has not been looked into may ask for the first cycle, which has no place of its own any more.
        Some((start, cycle)) if !asks_first(program, &cycle) => {
            if let (Some(first), Some(Value::Step(step))) =
                (program.place(Role::First), initial(&program.places[start.0]))
            {
                starting::as_state(program, start, first, step);
            }
            program.cycle = cycle;
            true
        }
        _ => {
            program.places.truncate(count);
            false
        }
    }
}

/// How often all statements and places of a program may be gone through, so to speak, for conditions of several regions that are asked first: each of
/// them doubles what is after it. Of the charts of this repository that profit from it none takes more than 48.
const EFFORT: usize = 64;

/// So many statements and places are enough: what a long program asks first beyond that makes most longer.
const ENOUGH: usize = 50_000;

/// So often a program is gone through however long it is.
const LEAST: usize = 4;

fn effort(program: &Program<'_>) -> usize {
    let once = weight(&program.cycle) + program.places.len();
    (EFFORT * once).min(ENOUGH.max(LEAST * once))
}

pub(super) struct Several<'p, 'm> {
    pub(super) places: &'p [PlaceInfo<'m>],
    beside: &'p Relation,
    /// By region: its place, and its states.
    pub(super) states: Vec<PlaceId>,
    /// By region: where its state before is kept.
    was: Vec<Option<PlaceId>>,
    points: Vec<States>,
    first: PlaceId,
    /// By place: whether it is read after the statements that are looked at.
    pub(super) read_after: Places,
    /// By region: it is never without a step.
    pub(super) full: Vec<bool>,
    /// What a state tells of another region.
    pub(super) ties: Vec<Tie>,
    pub(super) meetings: Vec<Meeting>,
    /// As of an `sfc`, in which no region encloses another one or forces it.
    is_flat: bool,
    /// So many statements and places may still be looked at for conditions that are asked first.
    effort: Cell<usize>,
    /// Whether part of a condition is asked first, too: not within what is compared with that.
    tries_stops: Cell<bool>,
}

/// Where one region has this state, another one has that.
pub(super) struct Tie {
    pub(super) leading: (usize, Option<StepId>),
    pub(super) led: (usize, Option<StepId>),
}

impl<'p, 'm> Several<'p, 'm> {
    fn of(program: &'p Program<'m>) -> Option<Self> {
        let first = program.place(Role::First)?;
        let asks = |deadline: &Deadline<'_>| deadline.asks().any(|expr| mentions(expr, first));
        let asked = program.deadline.as_ref().is_some_and(asks);
        let mut after = read_after(program);
        after.put(first, false);
        (!asked).then(|| Self::over(program, after)).flatten()
    }

    /// For statements after which these places are read.
    pub(super) fn over(program: &'p Program<'m>, read_after: Places) -> Option<Self> {
        let (mut states, mut points) = (Vec::new(), Vec::new());
        if program.regions.len() < 2 || program.beside.is_empty() {
            return None;
        }
        for (region, steps) in program.regions.iter().enumerate() {
            let state = program.place(Role::State(region))?;
            let Initial::Value(Value::Step(begin)) = program.places[state.0].initial else { return None };
            states.push(state);
            points.push(States::of(begin, steps));
        }
        let first = program.place(Role::First)?;
        Some(Self {
            places: &program.places,
            beside: &program.beside,
            was: states.iter().map(|state| copy(&program.cycle, *state)).collect(),
            states,
            points,
            first,
            read_after,
            full: program.full.clone(),
            ties: Vec::new(),
            meetings: Vec::new(),
            is_flat: !program.model.is_grafcet(),
            effort: Cell::new(effort(program)),
            tries_stops: Cell::new(true),
        })
    }

    /// Whatever has been looked at, as much may be looked at again.
    pub(super) fn renew(&self, program: &Program<'m>) {
        self.effort.set(effort(program));
    }

    /// The region whose state tells that the first cycle is still to come, and the cycle.
    fn cycle(
        &self,
        list: &[Statement<'m>],
        (actions, was_first): (Actions, PlaceId),
    ) -> Option<(PlaceId, Vec<Statement<'m>>)> {
        let effects = Effects::of_all(list);
        let loops = list.iter().any(|statement| matches!(statement, Statement::Loop { .. }));
        if loops || !effects.writes.contains(&self.first) {
            return None;
        }
        let mut env = Env::of(self.places);
        let (list, acting) = match actions {
            Actions::OnTheirWays => (list.to_vec(), Vec::new()),
            _ => self.apart(list, &env, (actions, was_first))?,
        };
        each_asked(&acting, &mut |place| _ = env.later.insert(place));
        let mut start = self.first_cycle(&list, &env)?;
        env.facts[self.first.0] = Fact::Is(Value::Bool(false));
        self.any_situation(&mut env);
        let mut rest = self.spec(&list, &env);
        let mut head = self.states[0];
        if let Some(Statement::Match(place, ..)) =
            rest.iter().find(|one| matches!(one, Statement::Match(place, ..) if self.states.contains(place)))
        {
            head = *place;
        }
        let begin = initial(&self.places[head.0])?;
        start.insert(0, Statement::Set(head, Expr::Value(begin)));
        let Value::Step(begin) = begin else { return None };
        let mut others = vec![(Vec::new(), rest)];
        let mut cycle = hoist::out_of(self.places, head, Some(&mut start), &mut others, &Set::new());
        rest = others.pop()?.1;
        let may = |statement: &Statement<'m>| !matches!(statement, Statement::Mark(_)) && !writes_to(statement, head);
        let after = share::ends(&mut [&mut start, &mut rest], &may);
        let starting = (vec![Value::Start(begin)], start);
        cycle.push(match &mut rest[..] {
            [Statement::Match(place, arms, otherwise)] if *place == head => {
                arms.insert(0, starting);
                Statement::Match(head, std::mem::take(arms), std::mem::take(otherwise))
            }
            _ => Statement::Match(head, vec![starting], rest),
        });
        cycle.extend(after);
        cycle.extend(self.acting(&list, &acting));
        Some((head, cycle))
    }

    /// All is known in it.
    fn first_cycle(&self, list: &[Statement<'m>], env: &Env) -> Option<Vec<Statement<'m>>> {
        let mut env = env.clone();
        env.facts[self.first.0] = Fact::Is(Value::Bool(true));
        for (index, place) in self.places.iter().enumerate() {
            if index != self.first.0 && place.is_field && !matches!(place.role, Role::Param(_)) {
                env.facts[index] = match initial(place) {
                    Some(value) if !matches!(place.ty, Type::User(_)) => Fact::Is(value),
                    _ => Fact::Initial,
                };
            }
        }
        let (body, facts) = self.folded(list, &env);
        (facts[self.first.0] == Fact::Is(Value::Bool(false))).then(|| self.swept(body, &env))
    }

    /// The state of each region is one of all that it has.
    pub(super) fn any_situation(&self, env: &mut Env) {
        for (region, state) in self.states.iter().enumerate() {
            env.facts[state.0] = env.among(self.possible(region));
        }
    }

    pub(super) fn situations(&self) -> Situations<'_> {
        Situations { states: &self.states, was: &self.was, beside: self.beside }
    }

    /// The region that a step belongs to.
    pub(super) fn region_with(&self, step: StepId) -> Option<usize> {
        self.points.iter().position(|points| points.of_step(step).is_some())
    }

    /// All states of a region; there may be none.
    pub(super) fn possible(&self, region: usize) -> Among {
        let mut all = Vec::new();
        for value in &self.points[region].all {
            match value {
                Value::Step(None) if self.full[region] => {}
                Value::Step(step) => all.push(*step),
                _ => {}
            }
        }
        all
    }

    /// Statements with all that is known, and what is known after them.
    pub(super) fn folded(&self, list: &[Statement<'m>], env: &Env) -> (Vec<Statement<'m>>, Vec<Fact>) {
        let index = Index::whole(self.places.len(), 0, &self.points[0]);
        let mut engine = self.engine(list, &index, 0, env);
        let mut body = Vec::new();
        engine.block(list, &mut body);
        (body, engine.env)
    }

    /// What is known after statements that have been looked at with this.
    pub(super) fn after(&self, list: &[Statement<'m>], env: &mut Env) {
        let mut writes = Set::new();
        each_written(list, &mut |place| _ = writes.insert(place));
        let (_, after) = self.folded(list, env);
        for place in &*writes {
            env.facts[place.0] = match after[place.0] {
                Fact::Among(list) if list >= env.lists.len() => Fact::Nothing,
                // Another place is no better to read than this one.
                Fact::Copy(_) if !matches!(self.places[place.0].ty, Type::State(_)) => Fact::Nothing,
                fact => fact,
            };
        }
        for (at, (fact, after)) in env.facts.iter_mut().zip(after).enumerate() {
            if matches!(*fact, Fact::Copy(of) if writes.contains(&of)) && !writes.contains(&PlaceId(at)) {
                *fact = after;
            }
        }
        self.tell_only(list, env);
    }

    /// Which truths of some statements hold in some states of a region alone.
    pub(super) fn tell_only(&self, list: &[Statement<'m>], env: &mut Env) {
        let mut writes = vec![0_u32; self.places.len()];
        each_written(list, &mut |place| writes[place.0] += 1);
        env.only.retain(|(truth, state, _)| writes[truth.0] == 0 && writes[state.0] == 0);
        for statement in list {
            let Statement::Set(truth, value) = statement else { continue };
            let parts = if let Expr::All(parts) = value { &parts[..] } else { std::slice::from_ref(value) };
            if self.places[truth.0].is_field || writes[truth.0] > 1 {
                continue;
            }
            for part in parts {
                match part {
                    Expr::Is(state, steps) if writes[state.0] == 0 => {
                        env.only.push((*truth, *state, steps.clone()));
                    }
                    _ => {}
                }
            }
        }
    }

    fn engine<'e>(&'e self, list: &'e [Statement<'m>], index: &'e Index, region: usize, env: &Env) -> Engine<'e, 'm> {
        let (state, points) = (self.states[region], &self.points[region]);
        let mut engine = Engine::new(self.places, (list, index), state, points, &[], env.facts.clone());
        engine.lists.clone_from(&env.lists);
        for (place, fact) in env.facts.iter().enumerate() {
            if let Fact::Copy(of) = fact {
                engine.copies.add(PlaceId(place), *of);
            }
        }
        engine
    }

    /// What nobody looks at is left away.
    pub(super) fn swept(&self, mut body: Vec<Statement<'m>>, env: &Env) -> Vec<Statement<'m>> {
        Live::with(&self.read_after, self.later(env)).sweep(&mut body);
        body
    }

    /// What is read after some statements.
    fn later(&self, env: &Env) -> Places {
        let mut later = self.read_after.clone();
        for place in &*env.later {
            later.put(*place, true);
        }
        later
    }

    /// Whether statements write the state of a region.
    fn decides(&self, statements: &[Statement<'m>]) -> bool {
        let mut found = false;
        each_written(statements, &mut |place| found |= self.states.contains(&place));
        found
    }
}

/// Where the state of a region is kept before it changes.
fn copy(statements: &[Statement<'_>], state: PlaceId) -> Option<PlaceId> {
    statements.iter().find_map(|statement| match statement {
        Statement::Set(was, Expr::Place(of)) => (*of == state).then_some(*was),
        Statement::Part(_, body) | Statement::Loop { body, .. } => copy(body, state),
        _ => None,
    })
}

fn asks_first(program: &Program<'_>, cycle: &[Statement<'_>]) -> bool {
    let first = program.place(Role::First);
    first.is_some_and(|first| is_read_in(cycle, first))
}
