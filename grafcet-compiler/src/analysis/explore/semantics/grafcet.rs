//! The cycle of `grafcet`: the search for stability.

use super::hierarchy;
use super::sfc::perform;
use super::trail::Trail;
use super::{Done, evolve, note_doubled, turn};
use crate::analysis::explore::net::actions::{Action, StoredId};
use crate::analysis::explore::net::slots::{Bit, SlotId};
use crate::analysis::explore::search::reduction;
use crate::analysis::explore::valuation::{State, Valuation, When};
use crate::analysis::explore::verdicts::rivals;
use crate::list::{List, PushAll};
use crate::model::{Dialect, Id, StepId, TransitionId, Trigger};
use crate::sorted::sort_unstable;

/// What the stored actions of one evolution do together.
struct Outcome {
    writes: Vec<(SlotId, Bit)>,
    /// A call is due, or a value changes that is not followed (A25).
    more: bool,
}

pub(crate) fn cycle(valuation: &mut Valuation<'_>, state: &State, enabled: &[TransitionId], trail: &mut Trail) -> When {
    if state.first {
        activate(valuation);
    }
    search(valuation, state, enabled, trail)
}

/// From the evolution on that comes next.
pub(super) fn search(
    valuation: &mut Valuation<'_>,
    state: &State,
    enabled: &[TransitionId],
    trail: &mut Trail,
) -> When {
    let net = valuation.net;
    // What is asked keeps a search from coming back to where it was before, so where a run is taken up there are none.
    let mut anchors = None;
    let bound = if valuation.to_the_turn { net.max_evolutions.saturating_mul(turn::FAR) } else { net.max_evolutions };
    loop {
        let fireable = fireable(valuation, enabled, trail);
        let Trail { done, evolutions, .. } = &mut *trail;
        // An order of the initial situation takes hold with the first evolution.
        let settled = !state.first || *evolutions > 0;
        let (after, cleared) = step(valuation, fireable, settled, done);
        if *evolutions == 0 {
            done.at_first = cleared.len();
        }
        let outcome = actions(valuation, &after, &cleared);
        trail.unmark(valuation);
        let Trail { done, evolutions, .. } = &mut *trail;
        let changes = outcome.more
            || after != valuation.now.active
            || outcome.writes.iter().any(|(slot, bit)| valuation.now.slots[slot.index()] != *bit);
        if !changes {
            done.cleared.push_all(cleared);
            done.too_long = *evolutions > net.max_evolutions;
            return When::Sample;
        }
        if *evolutions >= bound {
            done.unstable = true;
            return When::Before;
        }
        *evolutions += 1;
        done.evolves = true;
        if writes_more(valuation, &after, &cleared) {
            valuation.forget_volatile();
        } else if !net.calls.is_empty() {
            valuation.forget_calls();
        }
        done.cleared.push_all(cleared);
        commit(valuation, after, outcome.writes);
        if !valuation.to_the_turn {
            done.transient.push(valuation.now.active.clone());
            *evolutions = turn::skip(valuation, *evolutions, done, &mut anchors);
        } else if let Some(turn) = turn::of(valuation, *evolutions, done, &mut anchors) {
            done.turn = Some(turn);
            done.unstable = true;
            return When::Before;
        }
    }
}

/// The enabled transitions whose conditions hold.
fn fireable(valuation: &mut Valuation<'_>, enabled: &[TransitionId], trail: &mut Trail) -> Vec<TransitionId> {
    let net = valuation.net;
    let lengths = trail.done.lengths();
    let mut tried = if trail.evolutions == 0 {
        super::tried(valuation, enabled)
    } else {
        let enabled = super::enabled(net, valuation.unit, &valuation.now.active);
        if !valuation.to_the_turn {
            trail.done.enabled_later.extend_from_slice(&enabled);
        }
        if valuation.lazy { reduction::later(valuation, &enabled) } else { enabled }
    };
    if trail.is_marked(valuation) && tried.iter().any(|transition| valuation.is_open(&net.arcs[*transition].atoms)) {
        trail.mark(valuation, lengths);
    }
    tried.retain(|transition| valuation.decide(&net.arcs[*transition].condition, When::Now));
    if !valuation.to_the_turn {
        trail.done.able.extend_from_slice(&tried);
    }
    tried
}

/// A37: the activation of the initial situation is an evolution of its own, before which no step is active.
fn activate(valuation: &mut Valuation<'_>) {
    let after = std::mem::take(&mut valuation.now.active);
    let outcome = actions(valuation, &after, &[]);
    valuation.now.active = after;
    for (slot, bit) in outcome.writes {
        valuation.now.slots[slot.index()] = bit;
    }
}

/// The situation after the evolution, and the transitions cleared in it.
fn step(
    valuation: &Valuation<'_>,
    fireable: Vec<TransitionId>,
    settled: bool,
    done: &mut Done,
) -> (Vec<StepId>, Vec<TransitionId>) {
    let net = valuation.net;
    if settled && fireable.is_empty() {
        return (valuation.now.active.clone(), fireable);
    }
    if valuation.unit.is_none() && !net.hierarchy.is_empty() && !(settled && hierarchy::is_free(net, &fireable)) {
        return hierarchy::evolve(net, &valuation.now.active, &fireable, done);
    }
    let active = &valuation.now.active;
    if let [only] = fireable[..] {
        let arc = &net.arcs[only];
        note_doubled(net, active, &arc.sources, &fireable, done);
        return (evolve(active, &arc.sources, &arc.targets), fireable);
    }
    let (mut left, mut targets) = (Vec::new(), Vec::new());
    for transition in &fireable {
        left.extend_from_slice(&net.arcs[*transition].sources);
        targets.extend_from_slice(&net.arcs[*transition].targets);
    }
    note_doubled(net, active, &left, &fireable, done);
    (evolve(active, &left, &targets), fireable)
}

/// Whether the evolution may change values that are not followed.
fn writes_more(valuation: &Valuation<'_>, after: &[StepId], cleared: &[TransitionId]) -> bool {
    let (steps, transitions) = &valuation.net.writes_more;
    valuation.now.active.iter().and(after).any(|step| steps[*step]) || cleared.iter().any(|id| transitions[*id])
}

fn commit(valuation: &mut Valuation<'_>, after: Vec<StepId>, writes: Vec<(SlotId, Bit)>) {
    // The memory of the snapshot before is used again: a search may make thousands of evolutions.
    let mut before = valuation.previous.take().unwrap_or_default();
    before.slots.clone_from(&valuation.now.slots);
    before.active = std::mem::replace(&mut valuation.now.active, after);
    let after = &valuation.now.active;
    valuation.just_entered.retain(|step| after.binary_search(step).is_ok());
    for step in after {
        if before.active.binary_search(step).is_err() {
            valuation.just_entered.push(*step);
        }
    }
    for (slot, bit) in writes {
        valuation.now.slots[slot.index()] = bit;
    }
    valuation.previous = Some(before);
    valuation.edgeless = false;
}

/// The stored actions of an evolution to `after`: all see the values from before it (A5).
fn actions(valuation: &mut Valuation<'_>, after: &[StepId], cleared: &[TransitionId]) -> Outcome {
    let mut outcome = Outcome { writes: Vec::new(), more: false };
    let net = valuation.net;
    if net.actions.is_empty() {
        return outcome;
    }
    let before = valuation.now.active.clone();
    rivals::note(valuation, &before, after, cleared);
    let mut due: Vec<StoredId> = Vec::new();
    let steps = before.iter().and(after.iter().filter(|step| before.binary_search(step).is_err()));
    for step in steps.filter_map(|step| net.actions.stored_of.get(step)) {
        due.extend(step);
    }
    sort_unstable(&mut due);
    for number in due {
        let action = &net.actions.stored[number];
        if occurs(valuation, action, &before, after) {
            run(valuation, action, &mut outcome);
        }
    }
    for transition in cleared {
        for action in net.actions.clearing.get(transition).into_iter().flatten() {
            run(valuation, action, &mut outcome);
        }
    }
    outcome
}

fn run(valuation: &mut Valuation<'_>, action: &Action, outcome: &mut Outcome) {
    valuation.own.clear();
    perform(valuation, &action.program);
    let written = std::mem::take(&mut valuation.own);
    // The last in the source wins.
    outcome.writes.retain(|(slot, _)| written.iter().all(|(other, _)| other != slot));
    for (slot, bit) in written {
        outcome.writes.retain(|(other, _)| *other != slot);
        outcome.writes.push((slot, bit));
    }
    outcome.more |= action.more;
}

/// Whether the event of a stored action occurs in this evolution, and its condition holds.
fn occurs(valuation: &mut Valuation<'_>, action: &Action, before: &[StepId], after: &[StepId]) -> bool {
    let (was, is) = (action.is_of(before), action.is_of(after));
    let occurs = match action.qualifier.trigger(Dialect::Grafcet) {
        Trigger::Deactivation => was && !is,
        Trigger::Event => was,
        Trigger::Active | Trigger::Activation => !was && is,
    };
    if !occurs {
        return false;
    }
    valuation.spoilt |= valuation.is_waited() && (action.event.is_some() || action.condition.is_some());
    let event = action.event.as_ref().is_none_or(|event| valuation.decide(event, When::Now));
    event && action.condition.as_ref().is_none_or(|condition| valuation.decide(condition, When::Now))
}
