//! The search of a `grafcet` that ends with its first evolution is no loop: where that changed something, nothing follows.
//!
//! ```text
//! loop                                  was.state = state
//!   was.state = state                   clears.A→B = was.state is A && 5s are over
//!   clears.A→B = …                      …
//!   …                                   if was.state != state: since = now
//!   if !(was.state != state):     ->    stable = true
//!     stable = true
//!     break
//!   if evolutions == 6: …
//!   since = now
//! ```
//!
//! So the cycle is one as of an `sfc`, and what is made of that is made of it.
//!
//! Needs: one region, the chart's searches end with their first evolution; what another look would find anew is asked for by nothing that
//! stands after.

use super::super::{Expr, PlaceId, Program, Role, Statement};
use super::edits::{replaced, rewrite};
use super::search::opened;
use super::uses::{Effects, each_read, is_pure};
use crate::sorted::Set;

pub(super) fn pass(program: &mut Program<'_>) {
    let Some(state) = program.place(Role::State(0)) else { return };
    if !program.search.is_one_evolution || program.regions.len() != 1 {
        return;
    }
    let mut cycle = opened(&program.cycle);
    let Some(at) = cycle.iter().position(|one| matches!(one, Statement::Loop { .. })) else { return };
    let Statement::Loop { body, .. } = &cycle[at] else { return };
    let Some(round) = Round::of(body) else { return };
    let again =
        Again { program, state, written: Effects::of_all(body).writes, asked: Effects::of_all(&cycle[at + 1..]).reads };
    let Some(copies) = again.look(&round.look) else { return };
    let state_itself = |expr: &Expr<'_>| match expr {
        Expr::Place(place) if copies.contains(place) => Some(Expr::Place(state)),
        Expr::Is(place, steps) if copies.contains(place) => Some(Expr::Is(state, steps.clone())),
        _ => None,
    };
    rewrite(&mut cycle[at + 1..], &mut |expr| replaced(expr, &state_itself));
    let mut once = round.look;
    once.push(Statement::If(round.stays, Vec::new(), round.evolution));
    once.extend(round.stable);
    cycle.splice(at..=at, once);
    program.cycle = cycle;
}

/// A round of the search.
struct Round<'m> {
    /// What clears, and where that leads to.
    look: Vec<Statement<'m>>,
    /// Whether nothing does, and what is done then.
    stays: Expr<'m>,
    stable: Vec<Statement<'m>>,
    /// How it takes place.
    evolution: Vec<Statement<'m>>,
}

impl<'m> Round<'m> {
    fn of(body: &[Statement<'m>]) -> Option<Self> {
        let leaves = |one: &Statement<'_>| matches!(one, Statement::If(_, then, _) if matches!(then.last(), Some(Statement::Break)));
        let mut look = opened(body);
        let at = look.iter().position(leaves)?;
        let mut evolution = look.split_off(at + 1);
        let Some(Statement::If(stays, mut stable, _)) = look.pop() else { return None };
        stable.pop();
        // The bound is one at least.
        evolution.retain(|one| !leaves(one));
        Some(Self { look, stays, stable, evolution })
    }
}

/// Another look at what clears, after the evolution.
struct Again<'p, 'm> {
    program: &'p Program<'m>,
    state: PlaceId,
    /// What a round writes, and what is asked for after the search.
    written: Set<PlaceId>,
    asked: Set<PlaceId>,
}

impl<'m> Again<'_, 'm> {
    /// What it would change of all that is asked for later, if that is nothing but copies of the state.
    fn look(&self, look: &[Statement<'m>]) -> Option<Vec<PlaceId>> {
        let mut copies = Vec::new();
        for statement in look {
            let writes = Effects::of(statement).writes;
            if !writes.iter().any(|place| self.is_asked(*place)) || self.is_of_first(statement) {
                continue;
            }
            let Statement::Set(place, value) = statement else { return None };
            if matches!(value, Expr::Place(state) if *state == self.state) {
                copies.push(*place);
            } else if !self.is_same(value) {
                return None;
            }
        }
        Some(copies)
    }

    fn is_asked(&self, place: PlaceId) -> bool {
        place != self.state && (self.asked.contains(&place) || self.program.places[place.0].is_field)
    }

    /// It is done in the first evolution of all alone.
    fn is_of_first(&self, statement: &Statement<'m>) -> bool {
        let first = self.program.place(Role::First);
        let Statement::If(Expr::All(parts), _, otherwise) = statement else { return false };
        otherwise.is_empty() && parts.iter().any(|part| matches!(part, Expr::Place(place) if Some(*place) == first))
    }

    /// Whether the value is the one that it was.
    fn is_same(&self, value: &Expr<'m>) -> bool {
        let mut same = is_pure(value);
        each_read(value, &mut |read| same &= !self.written.contains(&read));
        same
    }
}
