//! The search of a `grafcet` over several regions: in the loop what forces and encloses first, then what that leaves to the others, each
//! region with one match on its state.
//!
//! ```text
//! loop                                               loop
//!   was.state.R = state.R                              moves = false
//!   was.state.M = state.M                              match state.R
//!   clears.R→S = was.state.R is R && stop                R:
//!   clears.A→B = free.M && was.state.M is A && a           if stop:
//!   if clears.R→S: state.R = S                ->             state.R = S
//!   if state.R is S: state.M = none                          state.M = none
//!   else if clears.A→B: state.M = B                          moves = true
//!   if !(was.state.R != state.R || …): break               else:
//!                                                            match state.M
//!                                                              A: if a: …
//!                                                      if !moves: break
//! ```
//!
//! What is done after a round that has found the situation stable is done once for each state (`several`).
//!
//! Needs: one loop, which is left where no region has moved and nothing else has changed, with the situation taken back, or after an evolution; nothing around it writes
//! the situation; what moves a region can stand
//! together (`parts`).

mod after;
mod alike;
mod leading;
mod meetings;
mod owners;
mod touched;
mod turn;

use super::super::build::{differ, no, not};
use super::super::{Expr, Meeting, PlaceId, PlaceInfo, Program, Role, Statement, Value};
use super::dead::read_after;
use super::engine::Fact;
use super::flat::flat;
use super::fold::initial;
use super::live::{Live, Places};
use super::search::opened;
use super::several::{Env, Several};
use super::uses::{Effects, has, leaves, same};

use meetings::meetings;
use turn::{Free, Turn};

/// For each region so many truths tell at most what is done after the ways of others.
const GOES: usize = 3;

pub(super) fn pass(program: &mut Program<'_>) {
    if program.beside.is_empty() {
        return;
    }
    let count = program.places.len();
    let mut places = std::mem::take(&mut program.places);
    let found = Cycle::of(program, &mut places);
    program.places = places;
    match found.and_then(|found| found.cycle(program)) {
        Some((cycle, meetings)) => {
            program.cycle = cycle;
            program.meetings = meetings;
        }
        None => program.places.truncate(count),
    }
}

/// A cycle with a loop in it.
struct Cycle<'m> {
    before: Vec<Statement<'m>>,
    rounds: u32,
    /// Up to where it is known whether something moves.
    turn: Vec<Statement<'m>>,
    /// What leaves the loop, and what is done otherwise.
    end: Vec<Statement<'m>>,
    after: Vec<Statement<'m>>,
    free: Free,
}

impl<'m> Cycle<'m> {
    fn of(program: &Program<'m>, places: &mut Vec<PlaceInfo<'m>>) -> Option<Self> {
        let mut states = Vec::new();
        for (at, place) in places.iter().enumerate() {
            if matches!(place.role, Role::State(_)) {
                states.push(PlaceId(at));
            }
        }
        let mut before = opened(&program.cycle);
        let at = before.iter().position(|statement| matches!(statement, Statement::Loop { .. }))?;
        let mut after = before.split_off(at + 1);
        let Some(Statement::Loop { rounds, body }) = before.pop() else { return None };
        let touches = |list: &[Statement<'m>]| {
            let effects = Effects::of_all(list);
            effects.leaves || states.iter().any(|state| effects.writes.contains(state))
        };
        let loops = |list: &[Statement<'m>]| list.iter().any(|one| matches!(one, Statement::Loop { .. }));
        if touches(&before) || touches(&after) || loops(&after) {
            return None;
        }
        let mut head = opened(&body);
        let at = head.iter().position(leaves)?;
        let tail = head.split_off(at + 1);
        let Some(Statement::If(Expr::Not(changes), leaving, otherwise)) = head.pop() else { return None };
        let changes = match *changes {
            Expr::Any(parts) => parts,
            one => vec![one],
        };
        if loops(&head) || loops(&tail) || !otherwise.is_empty() || leaving.len() > 2 {
            return None;
        }
        let copies = copies(&states, &head, &changes)?;
        if !tail.iter().all(|one| !leaves(one) || takes_back(one, &copies) || stops(one, &copies)) {
            return None;
        }
        let moves = local(places, "moves");
        let mut turn = vec![Statement::Set(moves, no())];
        turn.extend(flat(&head, None, true, places));
        for part in &changes {
            turn.push(Statement::Set(moves, Expr::Any(vec![Expr::Place(moves), part.clone()])));
        }
        let mut end = vec![Statement::If(not(Expr::Place(moves)), leaving, Vec::new())];
        let bounded = tail.iter().any(|one| takes_back(one, &copies));
        for statement in tail {
            let ready = !bounded && is_nothing_where_all_rests(&statement, &changes);
            if ready && end.iter().skip(1).all(|other| Effects::of(other).may_swap(&Effects::of(&statement))) {
                turn.push(statement);
            } else {
                end.push(statement);
            }
        }
        // No region has moved where the loop was left.
        let rest = copies.iter().map(|(was, state)| Statement::Set(*was, Expr::Place(*state)));
        after.splice(0..0, rest);
        let goes = (0..GOES * states.len()).map(|_| local(places, "goes")).collect();
        Some(Self { before, rounds, turn, end, after, free: Free { moves, goes } })
    }

    fn cycle(&self, program: &Program<'m>) -> Option<(Vec<Statement<'m>>, Vec<Meeting>)> {
        let last = Several::over(program, read_after(program))?;
        let mut env = Env::of(&program.places);
        let mut touched = Effects::of_all(&self.before);
        touched.add_all(&self.turn);
        touched.add_all(&self.end);
        for place in &*touched.writes {
            env.facts[place.0] = Fact::Nothing;
        }
        let mut begin = Vec::with_capacity(last.states.len());
        for state in &last.states {
            let Some(Value::Step(step)) = initial(&program.places[state.0]) else { return None };
            begin.push(step);
        }
        // Taken for granted, and taken back where a way leads elsewhere.
        let mut full: Vec<bool> = begin.iter().map(Option::is_some).collect();
        let (mut body, after, meetings) = loop {
            let mut env = env.clone();
            let mut last = Several::over(program, last.read_after.clone())?;
            last.full.clone_from(&full);
            last.any_situation(&mut env);
            let after = last.spec(&self.after, &env);
            let mut several = Several::over(program, self.read_after_turn(&last.read_after, &after))?;
            several.full.clone_from(&full);
            // A situation that is asked for by hand is known by pairs of steps alone.
            let follows = program.forced.is_none();
            if follows {
                several.ties = Turn::of(&several, &self.turn, &self.free).ties(&env, &begin);
            }
            let mut turn = Turn::of(&several, &self.turn, &self.free).statements(&env)?;
            if follows {
                several.meetings = meetings(&several, &turn, &begin);
            }
            if several.meetings.iter().any(|meeting| several.keeps_a_step(meeting)) {
                several.renew(program);
                turn = Turn::of(&several, &self.turn, &self.free).statements(&env)?;
            }
            let mut again = false;
            for (full, state) in full.iter_mut().zip(&last.states) {
                if *full && has(&turn, &|one| empties(one, *state)) {
                    *full = false;
                    again = true;
                }
            }
            if !again {
                break (turn, after, several.meetings);
            }
        };
        body.extend(self.end.iter().cloned());
        let mut cycle = self.before.clone();
        cycle.push(Statement::Loop { rounds: self.rounds, body });
        cycle.extend(after);
        Some((cycle, meetings))
    }

    /// What is read after the turn.
    fn read_after_turn(&self, read: &Places, after: &[Statement<'m>]) -> Places {
        let mut live = Live::after(read);
        live.sweep(&mut after.to_vec());
        let left = live.now.clone();
        let mut body = [&self.turn[..], &self.end].concat();
        live.rounds(&mut body);
        live.left = left;
        live.sweep(&mut self.end.clone());
        live.now
    }
}

fn local(places: &mut Vec<PlaceInfo<'_>>, name: &str) -> PlaceId {
    let place = PlaceId(places.len());
    places.push(PlaceInfo::truth(format!("{name}.{}", place.0)));
    place
}

/// The state of each region at the beginning of a round, where the loop goes on if one of them has changed.
fn copies(states: &[PlaceId], head: &[Statement<'_>], changes: &[Expr<'_>]) -> Option<Vec<(PlaceId, PlaceId)>> {
    let mut copies = Vec::with_capacity(states.len());
    for state in states {
        let was = head.iter().find_map(|one| match one {
            Statement::Set(was, Expr::Place(place)) if place == state => Some(*was),
            _ => None,
        })?;
        let is_asked = changes.iter().any(|part| same(part, &differ(was, *state)));
        copies.push(is_asked.then_some((was, *state))?);
    }
    Some(copies)
}

/// Whether it leaves the loop with the situation taken back.
fn takes_back(statement: &Statement<'_>, copies: &[(PlaceId, PlaceId)]) -> bool {
    copies.iter().all(|(was, state)| leaves_with(statement, *state, *was))
}

/// Whether it leaves the loop with the situation that it has come to, as that after which nothing moves.
fn stops(statement: &Statement<'_>, copies: &[(PlaceId, PlaceId)]) -> bool {
    copies.iter().all(|(was, state)| leaves_with(statement, *was, *state))
}

/// Whether it makes one place another one where it leaves the loop.
fn leaves_with(statement: &Statement<'_>, to: PlaceId, from: PlaceId) -> bool {
    let Statement::If(_, leaving, otherwise) = statement else { return false };
    let is = |one: &Statement<'_>| matches!(one, Statement::Set(place, Expr::Place(value)) if *place == to && *value == from);
    otherwise.is_empty() && opened(leaving).iter().any(is)
}

/// Whether it does nothing in a round in which nothing moves: it may be done before that is asked.
fn is_nothing_where_all_rests(statement: &Statement<'_>, changes: &[Expr<'_>]) -> bool {
    let among = |expr: &Expr<'_>| changes.iter().any(|part| same(part, expr));
    match statement {
        Statement::Set(to, Expr::Place(from)) => among(&differ(*to, *from)),
        Statement::If(condition, _, otherwise) => among(condition) && otherwise.is_empty(),
        _ => false,
    }
}

/// Whether a region may be left without a step.
fn empties(statement: &Statement<'_>, state: PlaceId) -> bool {
    matches!(statement, Statement::Set(place, value) if *place == state && !matches!(value, Expr::Value(Value::Step(Some(_)))))
}
