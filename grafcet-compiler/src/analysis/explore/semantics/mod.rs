//! What one cycle does, in both dialects, as far as it matters to the situations.

pub(crate) mod grafcet;
pub(crate) mod hierarchy;
pub(crate) mod sfc;
pub(crate) mod trail;
pub(crate) mod turn;

use std::rc::Rc;

use self::trail::Trail;
use self::turn::Turn;
use crate::analysis::explore::net::Net;
use crate::analysis::explore::net::units::UnitId;
use crate::analysis::explore::search::reduction::arbitrate;
use crate::analysis::explore::valuation::{Snapshot, State, Valuation, When};
use crate::model::{Id, StepId, TransitionId};
use crate::sorted::sort_unstable;

/// What happened in one run of a cycle.
#[derive(Clone, Default, Debug)]
pub(crate) struct Done {
    /// The transitions cleared, evolution by evolution.
    pub(crate) cleared: Vec<TransitionId>,
    /// How many of them cleared in the first evolution.
    pub(crate) at_first: usize,
    /// `grafcet`: there was an evolution that changed something.
    pub(crate) evolves: bool,
    /// Transitions whose condition held while they were enabled. These and the next two are not noted where turns are looked for.
    pub(crate) able: Vec<TransitionId>,
    /// Transitions enabled in some evolution; in the first they can be seen from the situation.
    pub(crate) enabled_later: Vec<TransitionId>,
    /// Situations between the first and the last of the cycle.
    pub(crate) transient: Vec<Vec<StepId>>,
    /// A step activated while it was active and not left, and the transition that did it.
    pub(crate) doubled: Vec<(StepId, TransitionId)>,
    /// The search for stability was stopped by its bound.
    pub(crate) unstable: bool,
    /// Where it was followed until it turns.
    pub(crate) turn: Option<Rc<Turn>>,
    /// One that another search has made, of which this one was in the middle: until it was stopped by its bound it made that turn.
    pub(crate) passed: Option<Rc<Turn>>,
    /// It came to rest where the bound would have stopped it before.
    pub(crate) too_long: bool,
}

/// The transitions that are enabled in a situation, in source order.
pub(crate) fn enabled(net: &Net, unit: Option<UnitId>, active: &[StepId]) -> Vec<TransitionId> {
    let has = |step: &StepId| active.binary_search(step).is_ok();
    let mut enabled = Vec::new();
    for step in active {
        for transition in &net.leaving[*step] {
            let sources = &net.arcs[*transition].sources;
            if sources[0] == *step && sources.iter().all(has) {
                enabled.push(*transition);
            }
        }
    }
    for transition in &net.sourceless {
        let target = net.arcs[*transition].targets.first();
        if unit.is_none() || unit == target.map(|step| net.unit_of[*step]) {
            enabled.push(*transition);
        }
    }
    if unit.is_none() && !net.hierarchy.is_empty() {
        // A13, A17: frozen by an order, or inside an enclosing step that is not active.
        let ordered = net.orders_any(active);
        enabled.retain(|transition| {
            let part = net.arcs[*transition].partial;
            net.parts[part].enclosed_by.as_ref().is_none_or(has) && !(ordered && net.order(part, active).is_some())
        });
    }
    sort_unstable(&mut enabled);
    enabled
}

/// Runs one cycle from `state`, from where the runs on this trail have come that answer the same; also returns which snapshot the edges
/// of the next one compare with.
pub(crate) fn run(
    valuation: &mut Valuation<'_>,
    state: &State,
    enabled: &[TransitionId],
    trail: &mut Trail,
) -> (When, Done) {
    if trail.take_up(valuation) {
        (grafcet::search(valuation, state, enabled, trail), trail.done.clone())
    } else {
        valuation.begin(state);
        go_on(valuation, state, enabled, trail)
    }
}

/// The same, where something has been decided about its inputs before.
pub(crate) fn go_on(
    valuation: &mut Valuation<'_>,
    state: &State,
    enabled: &[TransitionId],
    trail: &mut Trail,
) -> (When, Done) {
    if valuation.net.grafcet {
        trail.begin(valuation);
        return (grafcet::cycle(valuation, state, enabled, trail), trail.done.clone());
    }
    let mut done = Done::default();
    (sfc::cycle(valuation, state, enabled, &mut done), done)
}

/// The state that a cycle leaves behind.
pub(crate) fn end(valuation: &Valuation<'_>, when: When) -> State {
    let before = valuation.sample(when).into_boxed_slice();
    let Snapshot { active, slots } = &valuation.now;
    let mut slots = slots.clone();
    for slot in &valuation.net.shown_slots {
        slots[slot.index()] = valuation.net.initial_slots[*slot];
    }
    let (active, slots) = (active.clone().into_boxed_slice(), slots.into_boxed_slice());
    State { first: false, active, slots, before, ages: Box::default() }
}

/// `(active − left) ∪ targets`, ascending.
pub(crate) fn evolve(active: &[StepId], left: &[StepId], targets: &[StepId]) -> Vec<StepId> {
    let mut after = Vec::with_capacity(active.len() + targets.len());
    for step in active {
        if !left.contains(step) {
            after.push(*step);
        }
    }
    after.extend_from_slice(targets);
    sort_unstable(&mut after);
    after.dedup();
    after
}

/// Notes the steps among the targets of the cleared transitions that are active and not left.
pub(crate) fn note_doubled(net: &Net, active: &[StepId], left: &[StepId], cleared: &[TransitionId], done: &mut Done) {
    // A target of an `any` that is active stays so.
    for transition in cleared.iter().filter(|transition| !net.arcs[**transition].is_any) {
        for target in &net.arcs[*transition].targets {
            if active.binary_search(target).is_ok() && !left.contains(target) {
                done.doubled.push((*target, *transition));
            }
        }
    }
}

/// The transitions whose conditions are to be looked at, of those enabled at the start of a cycle.
pub(crate) fn tried(valuation: &mut Valuation<'_>, enabled: &[TransitionId]) -> Vec<TransitionId> {
    match valuation.groups.clone() {
        Some(groups) if valuation.lazy => arbitrate(valuation, &groups, true),
        _ => enabled.to_vec(),
    }
}
