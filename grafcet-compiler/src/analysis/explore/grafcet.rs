//! The cycle of `grafcet`: the search for stability.

use super::actions::Action;
use super::cycle::{self, Done, evolve, note_doubled};
use super::hierarchy;
use super::rivals;
use super::scene::{Scene, Snapshot, State, When};
use super::sfc::perform;
use super::slots::Bit;
use super::waiting;
use crate::model::{Dialect, Trigger};

/// What the stored actions of one evolution do together.
struct Outcome {
    writes: Vec<(usize, Bit)>,
    /// A call is due, or a value changes that is not followed (A25).
    more: bool,
}

pub(super) fn cycle(scene: &mut Scene<'_>, state: &State, enabled: &[usize], done: &mut Done) -> When {
    let net = scene.net;
    if state.first {
        activate(scene);
    }
    let mut fireable: Vec<usize> = Vec::new();
    let mut evolutions = 0;
    let mut anchor: Option<Anchor> = None;
    let bound = if scene.to_the_turn { net.max_evolutions.saturating_mul(FAR) } else { net.max_evolutions };
    loop {
        let tried = if evolutions == 0 {
            cycle::tried(scene, enabled)
        } else {
            let enabled = cycle::enabled(net, scene.unit, &scene.now.active);
            done.enabled_later.extend(&enabled);
            if scene.lazy { waiting::later(scene, &enabled) } else { enabled }
        };
        fireable.clear();
        for transition in tried {
            if scene.decide(&net.arcs[transition].condition, When::Now) {
                fireable.push(transition);
            }
        }
        done.able.extend(&fireable);
        // An order of the initial situation takes hold with the first evolution.
        let settled = !state.first || evolutions > 0;
        let (after, cleared) = step(scene, &fireable, settled, done);
        if evolutions == 0 {
            done.at_first = cleared.len();
        }
        let outcome = actions(scene, &after, &cleared);
        let changes = outcome.more
            || after != scene.now.active
            || outcome.writes.iter().any(|(slot, bit)| scene.now.slots[*slot] != *bit);
        if !changes {
            done.cleared.extend(cleared);
            done.too_long = evolutions > net.max_evolutions;
            return When::Sample;
        }
        if evolutions >= bound {
            done.unstable = true;
            return When::Before;
        }
        evolutions += 1;
        if writes_more(scene, &after, &cleared) {
            scene.forget_volatile();
        } else if !net.calls.is_empty() {
            scene.forget_calls();
        }
        done.cleared.extend(cleared);
        commit(scene, after, outcome.writes);
        done.transient.push(scene.now.active.clone());
        if !scene.to_the_turn {
            evolutions = skip(scene, evolutions, &mut anchor);
        } else if let Some(known) = turned(scene, evolutions, done.cleared.len(), &mut anchor) {
            done.turn = Some(done.cleared.split_off(known.cleared));
            done.unstable = true;
            return When::Before;
        }
    }
}

/// A37: the activation of the initial situation is an evolution of its own, before which no step is active.
fn activate(scene: &mut Scene<'_>) {
    let after = std::mem::take(&mut scene.now.active);
    let outcome = actions(scene, &after, &[]);
    scene.now.active = after;
    for (slot, bit) in outcome.writes {
        scene.now.slots[slot] = bit;
    }
}

/// The situation after the evolution, and the transitions cleared in it.
fn step(scene: &Scene<'_>, fireable: &[usize], settled: bool, done: &mut Done) -> (Vec<usize>, Vec<usize>) {
    let net = scene.net;
    if settled && fireable.is_empty() {
        return (scene.now.active.clone(), Vec::new());
    }
    if scene.unit.is_none() && !net.hierarchy.is_empty() && !(settled && hierarchy::is_free(net, fireable)) {
        return hierarchy::evolve(net, &scene.now.active, fireable, done);
    }
    let (mut left, mut targets) = (Vec::new(), Vec::new());
    for transition in fireable {
        left.extend(&net.arcs[*transition].sources);
        targets.extend(&net.arcs[*transition].targets);
    }
    note_doubled(net, &scene.now.active, &left, fireable, done);
    (evolve(&scene.now.active, &left, &targets), fireable.to_vec())
}

/// Whether the evolution may change values that are not followed.
fn writes_more(scene: &Scene<'_>, after: &[usize], cleared: &[usize]) -> bool {
    let (steps, transitions) = &scene.net.writes_more;
    scene.now.active.iter().chain(after).any(|step| steps[*step]) || cleared.iter().any(|id| transitions[*id])
}

fn commit(scene: &mut Scene<'_>, after: Vec<usize>, writes: Vec<(usize, Bit)>) {
    let before = scene.now.clone();
    scene.fresh.retain(|step| after.binary_search(step).is_ok());
    let entered = after.iter().filter(|step| before.active.binary_search(step).is_err());
    scene.fresh.extend(entered);
    scene.now.active = after;
    for (slot, bit) in writes {
        scene.now.slots[slot] = bit;
    }
    scene.previous = Some(before);
    scene.edgeless = false;
}

/// So many times the bound a search is followed that may turn for ever.
const FAR: usize = 16;

/// An evolution with which a later one is compared.
struct Anchor {
    evolution: usize,
    /// How many transitions had cleared.
    cleared: usize,
    asked: usize,
    now: Snapshot,
    previous: Option<Snapshot>,
    /// Ascending.
    fresh: Vec<usize>,
}

/// Where the search turns in a circle without asking anything new, it turns until the bound: whole turns are left out.
fn skip(scene: &mut Scene<'_>, evolution: usize, anchor: &mut Option<Anchor>) -> usize {
    if evolution < 8 {
        return evolution;
    }
    match turned(scene, evolution, 0, anchor) {
        Some(known) => {
            let period = evolution - known.evolution;
            let bound = scene.net.max_evolutions.max(evolution);
            bound - (bound - evolution) % period
        }
        None => evolution,
    }
}

/// The evolution since which the search has turned once, without asking anything new.
fn turned<'a>(
    scene: &Scene<'_>,
    evolution: usize,
    cleared: usize,
    anchor: &'a mut Option<Anchor>,
) -> Option<&'a Anchor> {
    let mut fresh = scene.fresh.clone();
    fresh.sort_unstable();
    let same = anchor.as_ref().is_some_and(|known| {
        known.now == scene.now
            && known.previous == scene.previous
            && known.fresh == fresh
            && known.asked == scene.tape.asked()
    });
    if same {
        return anchor.as_ref();
    }
    if evolution.is_power_of_two() {
        let (now, previous) = (scene.now.clone(), scene.previous.clone());
        *anchor = Some(Anchor { evolution, cleared, asked: scene.tape.asked(), now, previous, fresh });
    }
    None
}

/// The stored actions of an evolution to `after`: all see the values from before it (A5).
fn actions(scene: &mut Scene<'_>, after: &[usize], cleared: &[usize]) -> Outcome {
    let mut outcome = Outcome { writes: Vec::new(), more: false };
    let net = scene.net;
    if net.actions.is_empty() {
        return outcome;
    }
    let before = scene.now.active.clone();
    rivals::note(scene, &before, after, cleared);
    let mut due: Vec<usize> = Vec::new();
    let steps = before.iter().chain(after.iter().filter(|step| before.binary_search(step).is_err()));
    for step in steps.filter_map(|step| net.actions.stored_of.get(step)) {
        due.extend(step);
    }
    due.sort_unstable();
    for number in due {
        let action = &net.actions.stored[number];
        if occurs(scene, action, &before, after) {
            run(scene, action, &mut outcome);
        }
    }
    for transition in cleared {
        for action in net.actions.clearing.get(transition).into_iter().flatten() {
            run(scene, action, &mut outcome);
        }
    }
    outcome
}

fn run(scene: &mut Scene<'_>, action: &Action, outcome: &mut Outcome) {
    scene.own.clear();
    perform(scene, &action.program);
    let written = std::mem::take(&mut scene.own);
    // The last in the source wins.
    outcome.writes.retain(|(slot, _)| written.iter().all(|(other, _)| other != slot));
    for (slot, bit) in written {
        outcome.writes.retain(|(other, _)| *other != slot);
        outcome.writes.push((slot, bit));
    }
    outcome.more |= action.more;
}

/// Whether the event of a stored action occurs in this evolution, and its condition holds.
fn occurs(scene: &mut Scene<'_>, action: &Action, before: &[usize], after: &[usize]) -> bool {
    let was = before.binary_search(&action.step).is_ok();
    let is = after.binary_search(&action.step).is_ok();
    let occurs = match action.qualifier.trigger(Dialect::Grafcet) {
        Trigger::Deactivation => was && !is,
        Trigger::Event => was,
        Trigger::Active | Trigger::Activation => !was && is,
    };
    if !occurs {
        return false;
    }
    scene.spoilt |= scene.is_waited() && (action.event.is_some() || action.condition.is_some());
    let event = action.event.as_ref().is_none_or(|event| scene.decide(event, When::Now));
    event && action.condition.as_ref().is_none_or(|condition| scene.decide(condition, When::Now))
}
