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
//! Needs: each way tells rightly whether it has moved (`entries`), and many ways do for each region.

use super::super::super::build::{any, compare, not};
use super::super::super::{Comparison, Expr, PlaceId, PlaceInfo, Program, Role, Statement};
use super::super::edits::unset;
use super::super::uses::Effects;
use super::entries::{Entries, Watched, WatchedRegion};

/// For each region that is compared so many statements that tell have to go.
const TELLS: usize = 5;

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
    let (mut copies, mut moved) = (Vec::new(), Vec::new());
    for WatchedRegion { state, .. } in watched.regions {
        let info = &program.places[state.0];
        let was = PlaceInfo::local(format!("was.{}", info.name), info.ty, info.initial);
        let place = PlaceId(program.places.len());
        program.places.push(was);
        copies.push(Statement::Set(place, Expr::Place(state)));
        moved.push(compare(Comparison::Differs, Expr::Place(place), Expr::Place(state)));
    }
    program.cycle.splice(0..0, copies);
    program.cycle.push(Statement::Set(settled, not(any(moved))));
}
