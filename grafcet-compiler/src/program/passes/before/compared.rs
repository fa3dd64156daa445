//! Whether the cycle has moved is found at its end, by the states that it began with, and not stored on each way.
//!
//! ```text
//! match state.A                       was.A = state.A
//!   A1:                               was.B = state.B
//!     if x:                           match state.A
//!       state.A = A2           ->       A1:
//!       any = true                        if x: state.A = A2
//!   …                                   …
//! settled = !any                      settled = !(was.A != state.A || was.B != state.B)
//! ```
//!
//! Of two regions `next_deadline` compares, and the cycle keeps the states that it began with.
//!
//! Needs: each way tells rightly whether it has moved (`entries`), and many ways do for each region.

use super::super::super::build::{any, compare, not};
use super::super::super::{Comparison, Expr, Initial, PlaceId, PlaceInfo, Program, Role, Statement, Value};
use super::super::edits::{replaced, unset};
use super::super::uses::Effects;
use super::entries::{Entries, Watched, WatchedRegion};

/// For each region that is compared so many statements that tell have to go.
const TELLS: usize = 5;

/// Of so many regions `next_deadline` compares the states, which takes as many bytes of RAM.
const FEW: usize = 2;

pub(super) fn pass(program: &mut Program<'_>) {
    let Some(settled) = program.place(Role::Settled).filter(|_| program.regions.len() > 1) else { return };
    if Effects::of_all(&program.cycle).reads.contains(&settled) {
        return;
    }
    let mut regions = Vec::new();
    for region in 0..program.regions.len() {
        let Some(state) = program.place(Role::State(region)) else { return };
        regions.push(WatchedRegion { state, since: None });
    }
    let watched = Watched { settled, regions };
    if Entries::of(program, &watched).is_none_or(|entries| entries.tells < TELLS * watched.regions.len()) {
        return;
    }
    unset(&mut program.cycle, settled);
    let starts =
        |region: &WatchedRegion| matches!(program.places[region.state.0].initial, Initial::Value(Value::Start(_)));
    let kept = watched.regions.len() <= FEW && watched.regions.iter().any(starts);
    let (mut copies, mut moved) = (Vec::new(), Vec::new());
    for (number, WatchedRegion { state, .. }) in watched.regions.into_iter().enumerate() {
        let place = PlaceId(program.places.len());
        let copy = copy_of(program, number, state, kept);
        program.places.push(copy);
        copies.push(Statement::Set(place, Expr::Place(state)));
        moved.push(compare(Comparison::Differs, Expr::Place(place), Expr::Place(state)));
    }
    program.cycle.splice(0..0, copies);
    let settles = not(any(moved));
    match &mut program.deadline {
        Some(deadline) if kept => {
            let leaf = |expr: &Expr<'_>| matches!(expr, Expr::Place(place) if *place == settled);
            deadline.at_once = replaced(&deadline.at_once, &|expr| leaf(expr).then(|| settles.clone()));
        }
        _ => program.cycle.push(Statement::Set(settled, settles)),
    }
}

/// What holds the state that the cycle began with: a field, where the deadline compares with it.
fn copy_of<'m>(program: &Program<'m>, number: usize, state: PlaceId, kept: bool) -> PlaceInfo<'m> {
    let info = &program.places[state.0];
    if !kept {
        return PlaceInfo::local(format!("was.{}", info.name), info.ty, info.initial);
    }
    // Before the first cycle something has moved.
    let initial = match info.initial {
        Initial::Value(Value::Start(_)) => Initial::Value(Value::Step(program.regions[number].first().copied())),
        other => other,
    };
    PlaceInfo { name: format!("before.{}", info.name), role: Role::Before, ty: info.ty, initial, is_field: true }
}
