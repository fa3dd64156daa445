//! The cycle of `grafcet`, IEC 60848: the search for stability.

use std::collections::{BTreeMap, BTreeSet};

use super::any;
use super::continuous::{self, asserts};
use super::hierarchy;
use super::modes;
use super::state::State;
use super::stored::{self, Outcome};
use super::value::{Error, Value};
use super::view::{Edges, Situation, Times, View};
use super::world::Given;
use super::{Call, Evolution, Phase, arguments};
use grafcet_compiler::model::{ActionId, AssociationId, Effect, Id, Model, Place, TransitionId};

/// What `grafcet` remembers beside the state: whether the continuous calls were active on the last stable situation.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Grafcet {
    pub(super) calls: BTreeMap<ActionId, Continuous>,
}

#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Continuous {
    pub(super) active: bool,
    /// A31: the association active last.
    pub(super) last: Option<AssociationId>,
}

/// Where a search is stopped at the latest.
#[derive(Clone, Copy)]
pub(super) enum Until {
    /// A30: after so many evolutions.
    Bound(u32),
    /// Where it has turned once, or after so many evolutions.
    Turned(u32),
}

/// How a search ended.
pub(super) struct Search {
    pub(super) calls: Vec<Call>,
    /// The stored associations that ran, in their order.
    pub(super) ran: Vec<AssociationId>,
    pub(super) stable: bool,
    /// The evolutions that changed something; the activation of the initial situation is before the search and not counted.
    pub(super) evolutions: u32,
    /// Every evolution that was looked at. With the last one the search is over: it changed nothing, or the bound stopped it.
    pub(super) seen: Vec<Evolution>,
    /// How many evolutions there are in a turn, where it has turned: the last ones.
    pub(super) turn: Option<usize>,
}

impl Grafcet {
    /// One cycle, `elapsed` ticks after the one before.
    pub(super) fn cycle(
        &mut self,
        model: &Model,
        state: &mut State,
        given: Given<'_>,
        elapsed: u32,
        until: Until,
    ) -> Result<Search, Error> {
        let delays = state.sample_delays(model, given, elapsed)?;
        let mut search =
            Search { calls: Vec::new(), ran: Vec::new(), stable: false, evolutions: 0, seen: Vec::new(), turn: None };
        let (Until::Bound(most) | Until::Turned(most)) = until;
        let mut known = Vec::new();
        if state.first {
            let outcome = activate(&state.view(model, given, &delays))?;
            search.calls.extend(outcome.calls);
            search.ran.extend(outcome.ran);
            state.commit(outcome.writes);
        }
        // A24: one search over the whole chart.
        loop {
            let (before, now) = {
                let view = state.view(model, given, &delays);
                (state.edges.clone(), view.sample_edges()?)
            };
            let view = View { edges: Edges { before: &before, now: Some(&now) }, ..state.view(model, given, &delays) };
            let (evolution, outcome, asked) = evolve(&view)?;
            search.stable = is_stable(&evolution, &outcome, &view);
            // What the bound stops has not taken place: the next cycle asks its conditions again.
            if search.stable || search.evolutions < most {
                for id in asked {
                    view.given.world.asked(id, &|part| view.holds(part));
                }
            }
            search.seen.push(evolution.clone());
            if search.stable || search.evolutions == most {
                let (calls, outputs) =
                    (self.continuous_calls(&view)?, continuous_outputs(&view, &state.initial_outputs)?);
                search.calls.extend(calls);
                state.commit(outputs);
                // An evolution that the bound stopped has not taken place: its edges are still to be seen.
                if search.stable {
                    state.edges = now;
                }
                return Ok(search);
            }
            search.evolutions += 1;
            search.calls.extend(outcome.calls);
            search.ran.extend(outcome.ran);
            state.commit(outcome.writes);
            state.times.enter(model, &evolution.after);
            state.situation = evolution.after;
            state.edges = now;
            if let Until::Turned(_) = until {
                search.turn = known.iter().position(|other| other == state).map(|first| known.len() - first);
                if search.turn.is_some() {
                    return Ok(search);
                }
                known.push(state.clone());
            }
        }
    }

    /// A38: one evolution, which leads into the given situation; no transition clears. What its edges say is seen by the continuous actions, and by the
    /// next cycle once more.
    pub(super) fn force(
        &mut self,
        model: &Model,
        state: &mut State,
        given: Given<'_>,
        elapsed: u32,
        situation: &Situation,
    ) -> Result<Search, Error> {
        let delays = state.sample_delays(model, given, elapsed)?;
        let mut search =
            Search { calls: Vec::new(), ran: Vec::new(), stable: true, evolutions: 0, seen: Vec::new(), turn: None };
        if state.first {
            let outcome = activate(&state.view(model, given, &delays))?;
            search.calls.extend(outcome.calls);
            search.ran.extend(outcome.ran);
            state.commit(outcome.writes);
        }
        let (before, now) = {
            let view = state.view(model, given, &delays);
            (state.edges.clone(), view.sample_edges()?)
        };
        let view = View { edges: Edges { before: &before, now: Some(&now) }, ..state.view(model, given, &delays) };
        let outcome = stored::actions(&view, situation, &BTreeSet::new())?;
        let moved = Evolution { before: state.situation.clone(), after: situation.clone(), ..Evolution::default() };
        search.evolutions = u32::from(moved.before != moved.after);
        search.seen.push(moved);
        search.calls.extend(outcome.calls);
        search.ran.extend(outcome.ran);
        state.commit(outcome.writes);
        state.times.enter(model, situation);
        state.situation.clone_from(situation);
        state.edges = now;
        let look = state.view(model, given, &delays).sample_edges()?;
        let before = state.edges.clone();
        let view = View { edges: Edges { before: &before, now: Some(&look) }, ..state.view(model, given, &delays) };
        let (calls, outputs) = (self.continuous_calls(&view)?, continuous_outputs(&view, &state.initial_outputs)?);
        search.calls.extend(calls);
        state.commit(outputs);
        Ok(search)
    }

    /// A33: `N heat(80)` is called once per cycle, on the stable situation, after all others.
    fn continuous_calls(&mut self, view: &View<'_>) -> Result<Vec<Call>, Error> {
        let mut calls = Vec::new();
        for (action, associations) in targets(view.model) {
            let mut active = None;
            for id in associations {
                if asserts(&view.model.associations[id], view)? {
                    active = Some(id);
                }
            }
            let memory = self.calls.entry(action).or_default();
            let phase = match (memory.active, active.is_some()) {
                (false, false) => continue,
                (false, true) => Phase::First,
                (true, true) => Phase::Repeated,
                (true, false) => Phase::Final,
            };
            *memory = Continuous { active: active.is_some(), last: active.or(memory.last) };
            let association = memory.last.map(|id| &view.model.associations[id].effect);
            if let Some(Effect::Call(_, args)) = association {
                calls.push(Call { action, phase, args: arguments(action, args, view)? });
            }
        }
        Ok(calls)
    }
}

/// The actions called continuously, where they first stand in the source so, each with its associations in source order.
fn targets(model: &Model) -> Vec<(ActionId, Vec<AssociationId>)> {
    let mut targets: Vec<(ActionId, Vec<AssociationId>)> = Vec::new();
    for (id, association) in model.associations.iter().filter(|(_, a)| continuous::is_continuous(a)) {
        let Effect::Call(action, _) = &association.effect else { continue };
        match targets.iter_mut().find(|(target, _)| target == action) {
            Some((_, associations)) => associations.push(id),
            None => targets.push((*action, vec![id])),
        }
    }
    targets
}

/// A37: the activation of the initial situation is an evolution of its own. Before it no step is active; its stored actions
/// are done when the first conditions are evaluated.
fn activate(view: &View<'_>) -> Result<Outcome, Error> {
    let (nothing, no_times) = (Situation::new(), Times::default());
    let before = View { situation: &nothing, times: &no_times, ..*view };
    stored::actions(&before, view.situation, &BTreeSet::new())
}

/// One evolution: what clears on the snapshot, what the stored actions do, and which conditions decided.
fn evolve(view: &View<'_>) -> Result<(Evolution, Outcome, Vec<TransitionId>), Error> {
    let mut evolution = Evolution { before: view.situation.clone(), ..Evolution::default() };
    let mut asked = Vec::new();
    let anys = any::clearing(view, |partial| hierarchy::is_free(partial, view.situation, view.model))?;
    for id in view.model.transitions.ids() {
        if hierarchy::is_enabled(id, view.situation, view.model) {
            evolution.enabled.insert(id);
            if !any::lets(&anys, id, view.model) {
                continue;
            }
            if modes::asks(id, view) {
                asked.push(id);
            }
            if modes::holds(id, view)? {
                evolution.fireable.insert(id);
            }
        }
    }
    hierarchy::evolve(&mut evolution, &anys, view.model)?;
    let outcome = stored::actions(view, &evolution.after, &evolution.cleared)?;
    Ok((evolution, outcome, asked))
}

/// A25: stable is a fixed point: the situation stays, no stored action changes a value and no call is due.
fn is_stable(evolution: &Evolution, outcome: &Outcome, view: &View<'_>) -> bool {
    let old = |place: &Place| match place {
        Place::Output(id) => view.outputs[id.index()],
        Place::Var(id) => view.vars[id.index()],
    };
    evolution.after == *view.situation
        && outcome.writes.iter().all(|(place, value)| old(place) == *value)
        && outcome.calls.is_empty()
}

/// A9: the continuous outputs, once, on the stable situation (or the one at which the bound stopped the search).
fn continuous_outputs(view: &View<'_>, initial: &[Value]) -> Result<BTreeMap<Place, Value>, Error> {
    let mut outputs = BTreeMap::new();
    for id in view.model.outputs.ids() {
        if let Some(value) = continuous::output(id, initial[id.index()], view)? {
            outputs.insert(Place::Output(id), value);
        }
    }
    Ok(outputs)
}

impl State {
    /// A6: all values of one evolution together.
    fn commit(&mut self, writes: BTreeMap<Place, Value>) {
        for (place, value) in writes {
            match place {
                Place::Output(id) => self.outputs[id.index()] = value,
                Place::Var(id) => self.vars[id.index()] = value,
            }
        }
    }
}
