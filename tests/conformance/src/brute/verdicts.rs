//! What the states of a chart say about its steps, transitions, joins and deadlocks.

use std::collections::BTreeSet;

use grafcet_compiler::interp::{Evolution, Situation};
use grafcet_compiler::model::{Model, PartialId, StepId, TransitionId};

use super::graph::{Edge, Graph, State};

/// The verdicts of the naive exploration.
#[derive(Default, PartialEq, Eq, Debug)]
pub struct Verdicts {
    /// Steps that some situation contains, transient ones included.
    pub reachable: BTreeSet<StepId>,
    /// Transitions that some situation enables.
    pub enabled: BTreeSet<TransitionId>,
    /// Transitions whose condition holds in some situation that enables them.
    pub fireable: BTreeSet<TransitionId>,
    /// Transitions that clear.
    pub cleared: BTreeSet<TransitionId>,
    /// Pairs of transitions with a common source whose conditions hold in one situation that enables both.
    pub overlapping: BTreeSet<(TransitionId, TransitionId)>,
    /// Steps that an evolution activates while they are active and does not leave.
    pub unsafe_steps: BTreeSet<StepId>,
    /// Pairs of different steps that some situation contains, transient ones included, the smaller first.
    pub together: BTreeSet<(StepId, StepId)>,
    /// Situations of a partial grafcet in which it stays for ever; those of one without any transition, empty
    /// ones, forced ones and those with a final step are none.
    pub deadlocks: BTreeSet<(PartialId, BTreeSet<StepId>)>,
    /// AND-convergences with an active source that is never left any more while the convergence is never enabled.
    pub stuck: BTreeSet<(TransitionId, StepId)>,
}

impl Verdicts {
    /// The verdicts on an explored chart.
    #[must_use]
    pub fn of(model: &Model, graph: &Graph) -> Self {
        let mut verdicts = Self::default();
        for state in &graph.states {
            verdicts.seen(&state.situation);
        }
        for (_, edge) in graph.cycles() {
            edge.evolutions.iter().for_each(|evolution| verdicts.evaluated(evolution, model));
            edge.done(model).iter().for_each(|evolution| verdicts.done(evolution, model));
        }
        for partial in model.partials.ids().filter(|id| !model.partials[*id].transitions.is_empty()) {
            let ends = deadlocks(partial, model, graph).into_iter().map(|steps| (partial, steps));
            verdicts.deadlocks.extend(ends);
        }
        for (id, transition) in model.transitions.iter().filter(|(_, t)| t.sources.len() > 1) {
            let stuck = transition.sources.iter().filter(|source| stuck(id, **source, model, graph));
            verdicts.stuck.extend(stuck.map(|source| (id, *source)));
        }
        verdicts
    }

    fn seen(&mut self, situation: &Situation) {
        self.reachable.extend(situation);
        for step in situation {
            self.together.extend(situation.range(..step).map(|other| (*other, *step)));
        }
    }

    fn evaluated(&mut self, evolution: &Evolution, model: &Model) {
        self.enabled.extend(&evolution.enabled);
        self.fireable.extend(&evolution.fireable);
        let sources = |id: &TransitionId| &model.transitions[*id].sources;
        for a in &evolution.fireable {
            let beside = evolution.fireable.range(..a).filter(|b| sources(b).iter().any(|s| sources(a).contains(s)));
            self.overlapping.extend(beside.map(|b| (*b, *a)));
        }
    }

    fn done(&mut self, evolution: &Evolution, model: &Model) {
        self.seen(&evolution.after);
        self.cleared.extend(&evolution.cleared);
        let left = |step: &StepId| evolution.cleared.iter().any(|id| model.transitions[*id].sources.contains(step));
        let entered = evolution.cleared.iter().flat_map(|id| &model.transitions[*id].targets);
        self.unsafe_steps.extend(entered.filter(|step| evolution.before.contains(step) && !left(step)));
    }
}

/// The situations of a partial grafcet from which it has no way on.
fn deadlocks(id: PartialId, model: &Model, graph: &Graph) -> BTreeSet<BTreeSet<StepId>> {
    let partial = &model.partials[id];
    let moves = |edge: &Edge| {
        edge.done(model).iter().any(|evolution| {
            let changed = |step: &StepId| evolution.before.contains(step) != evolution.after.contains(step);
            let cleared = |transition: &TransitionId| evolution.cleared.contains(transition);
            partial.transitions.iter().any(cleared) || partial.steps.iter().any(changed)
        })
    };
    let mut found = BTreeSet::new();
    for state in ends(id, model, graph, &graph.can_still(moves)) {
        let here = partial.steps.iter().copied().filter(|step| state.situation.contains(step));
        found.insert(here.collect::<BTreeSet<StepId>>());
    }
    found.remove(&BTreeSet::new());
    found
}

/// The ends of cycles behind which something cannot come any more, where a partial grafcet is neither forced nor in a final
/// step: there it is meant to end.
fn ends<'g>(id: PartialId, model: &'g Model, graph: &'g Graph, hope: &'g [bool]) -> impl Iterator<Item = &'g State> {
    let steps = &model.partials[id].steps;
    let finals: Vec<StepId> = steps.iter().copied().filter(|step| model.steps[*step].is_final).collect();
    graph.states.iter().zip(hope).skip(1).filter(|(_, hope)| !**hope).map(|(state, _)| state).filter(move |state| {
        let forced = model.forces.values().any(|force| force.target == id && state.situation.contains(&force.step));
        !forced && !finals.iter().any(|step| state.situation.contains(step))
    })
}

/// Whether a source of a convergence can come to wait for ever.
fn stuck(join: TransitionId, source: StepId, model: &Model, graph: &Graph) -> bool {
    let leaves = |evolution: &Evolution| {
        // A self-loop leaves the step, too.
        evolution.cleared.iter().any(|id| model.transitions[*id].sources.contains(&source))
            || evolution.before.contains(&source) && !evolution.after.contains(&source)
    };
    let enabled = |edge: &Edge| edge.evolutions.iter().any(|evolution| evolution.enabled.contains(&join));
    let hope = graph.can_still(|edge| enabled(edge) || edge.done(model).iter().any(leaves));
    let id = model.transitions[join].partial;
    ends(id, model, graph, &hope).any(|state| state.situation.contains(&source))
}
