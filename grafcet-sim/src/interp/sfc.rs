//! The cycle of `sfc`, IEC 61131-3: one evolution, then the actions.

use std::collections::{BTreeMap, BTreeSet};

use super::any;
use super::control::{ActionControl, Change, Target, Verdict, inputs, target_of};
use super::modes;
use super::state::State;
use super::value::{Error, Value};
use super::view::{Edges, Situation, Times, View};
use super::world::Given;
use super::{Call, Evolution, Phase, arguments};
use grafcet_compiler::model::{AssociationId, Effect, Id, Model, OutputId, Place};

/// The action controls of a chart.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Sfc {
    pub(super) controls: BTreeMap<Target, ActionControl>,
}

/// What a cycle did.
pub(super) struct Done {
    /// In the order in which they were made.
    pub(super) calls: Vec<Call>,
    /// A block ran, or an assignment found another value than it wrote.
    pub(super) stirred: bool,
    /// The associations that ran, in their order.
    pub(super) ran: Vec<AssociationId>,
    /// The evolution; a first cycle has none.
    pub(super) evolution: Option<Evolution>,
}

impl Sfc {
    /// All flip-flops and timers at rest.
    pub(super) fn new(model: &Model, state: &State) -> Self {
        let mut targets = BTreeMap::<Target, Vec<AssociationId>>::new();
        for id in model.associations.ids() {
            targets.entry(target_of(model, id)).or_default().push(id);
        }
        let controls = targets.into_iter().map(|(target, associations)| {
            let set = starts_set(model, target, &associations, state);
            (target, ActionControl::new(associations, set))
        });
        Self { controls: controls.collect() }
    }

    /// One cycle, `elapsed` ticks after the one before; in a forced one the situation that follows is given (A38).
    pub(super) fn cycle(
        &mut self,
        model: &Model,
        state: &mut State,
        given: Given<'_>,
        elapsed: u32,
        forced: Option<&Situation>,
    ) -> Result<Done, Error> {
        let delays = state.sample_delays(model, given, elapsed)?;
        // Rule 8: what the evolution sees is compared with what that of the cycle before saw.
        let edges = state.view(model, given, &delays).sample_edges()?;
        let before = std::mem::replace(&mut state.edges, edges.clone());
        let edges = Edges { before: &before, now: Some(&edges) };

        let (change, evolution) = if let Some(after) = forced {
            let (change, evolution) = force(&state.situation, state.first, after);
            (change, Some(evolution))
        } else if state.first {
            (first(&state.situation), None)
        } else {
            let (change, evolution) = evolve(&View { edges, ..state.view(model, given, &delays) })?;
            (change, Some(evolution))
        };
        state.situation.clone_from(&change.after);
        let outputs = state.outputs.clone();
        let acting = acting_times(&change, &state.times);
        // Rule 8: what the actions see is compared with what they saw in the cycle before. Sampled once, before the first
        // of them runs: the edges keep their values meanwhile.
        let after = View {
            times: &acting,
            edges: Edges { before: &state.action_edges, now: None },
            ..state.view(model, given, &delays)
        };
        let edges = after.sample_edges()?;
        let before = std::mem::replace(&mut state.action_edges, edges.clone());
        let edges = Edges { before: &before, now: Some(&edges) };
        let mut scan = Scan {
            leaving: state.times.clone(),
            acting,
            change,
            base: View {
                outputs: &outputs,
                vars: &[],
                situation: &Situation::new(),
                times: &Times::default(),
                edges,
                ..state.view(model, given, &delays)
            },
            vars: state.vars.clone(),
            next: outputs.clone(),
            calls: Vec::new(),
            ran: Vec::new(),
            stirred: false,
        };
        self.act(&mut scan, elapsed, state)?;
        let Scan { vars, next, calls, ran, stirred, change, acting, .. } = scan;
        (state.vars, state.outputs, state.times) = (vars, next, acting);
        state.times.enter(model, &change.after);
        Ok(Done { calls, stirred, ran, evolution })
    }

    /// Timers are no longer than this.
    pub(super) fn settle(&mut self, longest: u32) {
        self.controls.values_mut().for_each(|control| control.settle(longest));
    }

    /// Rule 4 and 5: every action control is scanned, then the actions run in their order (A29).
    fn act(&mut self, scan: &mut Scan<'_>, elapsed: u32, state: &State) -> Result<(), Error> {
        let mut runs = Vec::new();
        let (leaving, view) = (scan.view(Moment::Leaving), scan.view(Moment::Rest));
        let on = inputs(&scan.change, &leaving, &view)?;
        for (target, control) in &mut self.controls {
            let verdict = control.scan(&on, &scan.change, elapsed, &view)?;
            match target {
                Target::Place(place) => runs.push(set(*place, control, verdict, &on, view.model)),
                Target::Action(_) | Target::Own(_) => runs.extend(calls(control, verdict)),
            }
        }
        runs.sort_by_key(|run| (run.moment, run.position));
        runs.iter().try_for_each(|run| scan.perform(run, &state.initial_outputs))
    }
}

/// A boolean that only S and R control starts with its initial value.
fn starts_set(model: &Model, target: Target, associations: &[AssociationId], state: &State) -> bool {
    let Target::Place(place) = target else { return false };
    let stored = |id: &AssociationId| model.associations[*id].qualifier.sets_or_resets();
    let value = match place {
        Place::Output(id) => state.outputs[id.index()],
        Place::Var(id) => state.vars[id.index()],
    };
    associations.iter().all(stored) && value == Value::Bool(true)
}

/// Rule 1: the initial situation is entered, no transition is evaluated (A27).
fn first(initial: &Situation) -> Change {
    Change { left: Situation::new(), entered: initial.clone(), after: initial.clone() }
}

/// A38: no transition is evaluated; steps that are not in the given situation are left, steps that are new in it entered. In a first cycle no step
/// is active yet.
fn force(before: &Situation, is_first: bool, after: &Situation) -> (Change, Evolution) {
    let nothing = Situation::new();
    let active = if is_first { &nothing } else { before };
    let change = Change {
        left: active.difference(after).copied().collect(),
        entered: after.difference(active).copied().collect(),
        after: after.clone(),
    };
    let evolution = Evolution { before: before.clone(), after: after.clone(), ..Evolution::default() };
    (change, evolution)
}

/// Rule 2: transitions in source order; one is cleared if all its source steps are active, its condition holds, and none
/// of its source steps is already left by an earlier one of this cycle (A28). Rule 3, A4s: a step left and re-entered is
/// in both sets.
fn evolve(view: &View<'_>) -> Result<(Change, Evolution), Error> {
    let mut left = Situation::new();
    let mut targets = Situation::new();
    let mut evolution = Evolution { before: view.situation.clone(), ..Evolution::default() };
    let anys = any::clearing(view, |_| true)?;
    for (id, transition) in view.model.transitions.iter() {
        if !transition.sources.iter().all(|step| view.situation.contains(step)) {
            continue;
        }
        evolution.enabled.insert(id);
        // Priority is not what makes a condition hold: an `any` that clears goes before, as an earlier branch does.
        let lets = any::lets(&anys, id, view.model);
        if !lets && !any::leaves(&anys, id, view.model) {
            // No priority: the `any` does not leave its steps, and stops it all the same.
            continue;
        }
        let free = lets && transition.sources.iter().all(|step| !left.contains(step));
        if free && modes::asks(id, view) {
            view.given.world.asked(id, &|part| view.holds(part));
        }
        match modes::holds(id, view) {
            Ok(true) => evolution.fireable.insert(id),
            Err(error) if free => return Err(error),
            // An error of a condition that nobody needs, since an earlier branch has decided, is none.
            Ok(false) | Err(_) => continue,
        };
        if free {
            evolution.cleared.insert(id);
            left.extend(&transition.sources);
            targets.extend(&transition.targets);
        }
    }
    for any in anys.into_values() {
        left.extend(any::sources(any, view.model));
        targets.extend(any::targets(any, view.model));
    }
    left.retain(|step| view.situation.contains(step));
    let stayed: Situation = view.situation.difference(&left).copied().collect();
    let entered = targets.difference(&stayed).copied().collect();
    let after: Situation = stayed.union(&targets).copied().collect();
    evolution.after.clone_from(&after);
    Ok((Change { left, entered, after }, evolution))
}

/// A34: the time a step left had reached, zero for a step entered.
fn acting_times(change: &Change, before: &Times) -> Times {
    let mut times = before.clone();
    times.steps.extend(change.entered.iter().map(|step| (*step, 0)));
    times
}

/// A29: where in the cycle an action runs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Moment {
    /// P0, and the final calls of the steps left.
    Leaving,
    /// P1.
    Entering,
    /// The rest.
    Rest,
}

/// One run of an action.
struct Run {
    moment: Moment,
    /// Where its target first stands in the source.
    position: AssociationId,
    what: What,
}

enum What {
    /// A boolean takes its Q.
    Control(Place, bool),
    /// A35: an assigned output has its initial value while no association is active.
    Initial(OutputId),
    /// An action, a block or an assignment runs.
    Run(AssociationId, Phase),
}

/// What a controlled or assigned place gets; a variable gets it among "the rest", where its target first stands.
fn set(place: Place, control: &ActionControl, verdict: Verdict, on: &BTreeSet<AssociationId>, model: &Model) -> Run {
    let assigns = |id: &AssociationId| matches!(model.associations[*id].effect, Effect::Assign(..));
    let assigned = control.associations.iter().any(assigns);
    // The last in the source where several are active, as in A31.
    let active = control.associations.iter().copied().rfind(|id| assigns(id) && on.contains(id));
    let what = match (place, active) {
        (_, Some(id)) => What::Run(id, Phase::First),
        (Place::Output(id), None) if assigned => What::Initial(id),
        _ => What::Control(place, verdict.q),
    };
    Run { moment: Moment::Rest, position: control.associations[0], what }
}

/// Rule 4: `A = Q || falling(Q) || P1 || P0`, told as phases, and how these fall together.
fn calls(control: &ActionControl, verdict: Verdict) -> Vec<Run> {
    let Verdict { q, before, by_leaving, acts, p1, p0 } = verdict;
    let position = control.associations[0];
    let mut runs = Vec::new();
    let mut run = |moment, association: Option<AssociationId>, phase| {
        runs.extend(association.map(|id| Run { moment, position, what: What::Run(id, phase) }));
    };
    let fell = before && !q;
    // P0 together with a final call is one run. Readings chosen: it is the final one, stands with the steps left
    // whatever ended Q, and has the arguments of P0, which acted last.
    match (p0.is_some(), fell) {
        (true, true) => run(Moment::Leaving, p0, Phase::Final),
        (true, false) => run(Moment::Leaving, p0, Phase::First),
        (false, true) => {
            let moment = if by_leaving { Moment::Leaving } else { Moment::Rest };
            run(moment, control.acted_last, Phase::Final);
        }
        (false, false) => {}
    }
    // P1 together with an active Q is one run, with the arguments of the last in the source of those that act (rule 7).
    match (p1, q) {
        (Some(p1), _) => run(Moment::Entering, acts.max(Some(p1)), Phase::First),
        (None, true) => {
            let phase = if before { Phase::Repeated } else { Phase::First };
            run(Moment::Rest, acts, phase);
        }
        (None, false) => {}
    }
    runs
}

/// The actions of one cycle while they run.
struct Scan<'a> {
    change: Change,
    /// The times as P0 sees them.
    leaving: Times,
    /// The times as the other actions see them.
    acting: Times,
    /// Inputs, parameters, edges, delays and the outputs of the previous cycle (rule 6).
    base: View<'a>,
    /// A variable written by one action is seen by the next.
    vars: Vec<Value>,
    /// The outputs this cycle will return.
    next: Vec<Value>,
    calls: Vec<Call>,
    ran: Vec<AssociationId>,
    stirred: bool,
}

impl Scan<'_> {
    /// The situation after the evolution; A34: on a self-loop P0 sees the time reached, P1 zero.
    fn view(&self, moment: Moment) -> View<'_> {
        let times = if moment == Moment::Leaving { &self.leaving } else { &self.acting };
        View { vars: &self.vars, situation: &self.change.after, times, ..self.base }
    }

    fn write(&mut self, place: Place, value: Value) {
        match place {
            Place::Output(id) => self.next[id.index()] = value,
            Place::Var(id) => self.vars[id.index()] = value,
        }
    }

    fn perform(&mut self, run: &Run, initial_outputs: &[Value]) -> Result<(), Error> {
        let model = self.base.model;
        match &run.what {
            What::Control(place, q) => self.write(*place, Value::Bool(*q)),
            What::Initial(id) => self.next[id.index()] = initial_outputs[id.index()],
            What::Run(id, phase) => {
                self.ran.push(*id);
                self.run(&model.associations[*id].effect, run.moment, *phase)?;
            }
        }
        Ok(())
    }

    fn run(&mut self, effect: &Effect, moment: Moment, phase: Phase) -> Result<(), Error> {
        let view = self.view(moment);
        match effect {
            Effect::Control(_) => {}
            Effect::Assign(place, value) => {
                let value = view.value_for(*place, &value.tree)?;
                let found = match place {
                    Place::Output(id) => self.next[id.index()],
                    Place::Var(id) => self.vars[id.index()],
                };
                self.stirred |= found != value;
                self.write(*place, value);
            }
            Effect::Call(action, args) => {
                let args = arguments(*action, args, &view)?;
                self.calls.push(Call { action: *action, phase, args });
            }
            Effect::Block(code) => {
                let written = view.code(code)?;
                self.stirred = true;
                for (place, value) in written {
                    self.write(place, value);
                }
            }
        }
        Ok(())
    }
}
