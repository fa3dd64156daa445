//! What the states of a chart say about its steps, transitions, joins and deadlocks.

use std::collections::BTreeSet;

use grafcet_compiler::model::{Model, PartialId, StepId, TransitionId};
use grafcet_sim::interp::{Evolution, Situation};

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
    /// Pairs of transitions with a common source whose conditions hold in one situation that enables both, if they do not lead
    /// to the same steps.
    pub overlapping: BTreeSet<(TransitionId, TransitionId)>,
    /// Steps that an evolution activates while they are active and does not leave.
    pub unsafe_steps: BTreeSet<StepId>,
    /// Pairs of different steps that some situation contains, transient ones included, the smaller first.
    pub together: BTreeSet<(StepId, StepId)>,
    /// Situations of a partial grafcet (of a connected part of it) in which it stays for ever; those without transitions, empty
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
        for piece in pieces(model) {
            verdicts.deadlocks.extend(deadlocks(&piece, model, graph));
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
        let targets = |id: &TransitionId| model.transitions[*id].targets.iter().collect::<BTreeSet<_>>();
        for a in &evolution.fireable {
            let beside = evolution.fireable.range(..a).filter(|b| sources(b).iter().any(|s| sources(a).contains(s)));
            let apart = beside.filter(|b| targets(a) != targets(b));
            self.overlapping.extend(apart.map(|b| (*b, *a)));
        }
    }

    fn done(&mut self, evolution: &Evolution, model: &Model) {
        self.seen(&evolution.after);
        self.cleared.extend(&evolution.cleared);
        self.unsafe_steps.extend(activated_while_active(evolution, model));
    }
}

/// The steps that an evolution activates while they are active and does not leave: those that are unsafe.
pub(super) fn activated_while_active(evolution: &Evolution, model: &Model) -> BTreeSet<StepId> {
    let left = |step: &StepId| evolution.cleared.iter().any(|id| model.transitions[*id].sources.contains(step));
    // An active target of an `any` stays active: that is what it says.
    let entering = evolution.cleared.iter().map(|id| &model.transitions[*id]).filter(|one| one.any.is_none());
    let entered = entering.flat_map(|transition| &transition.targets);
    entered.filter(|step| evolution.before.contains(step) && !left(step)).copied().collect()
}

/// Steps that transitions connect: a partial grafcet, or one of those that it consists of.
struct Piece {
    partial: PartialId,
    steps: BTreeSet<StepId>,
    transitions: BTreeSet<TransitionId>,
}

/// The pieces that have transitions.
fn pieces(model: &Model) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    for (id, transition) in model.transitions.iter() {
        let mut piece = Piece {
            partial: transition.partial,
            steps: transition.sources.iter().chain(&transition.targets).copied().collect(),
            transitions: BTreeSet::from([id]),
        };
        let (same, others): (Vec<Piece>, Vec<Piece>) =
            pieces.into_iter().partition(|other| !other.steps.is_disjoint(&piece.steps));
        for other in same {
            piece.steps.extend(other.steps);
            piece.transitions.extend(other.transitions);
        }
        pieces = others;
        pieces.push(piece);
    }
    pieces
}

/// The situations of a piece from which it has no way on.
fn deadlocks(piece: &Piece, model: &Model, graph: &Graph) -> BTreeSet<(PartialId, BTreeSet<StepId>)> {
    let moves = |edge: &Edge| {
        edge.done(model).iter().any(|evolution| {
            let changed = |step: &StepId| evolution.before.contains(step) != evolution.after.contains(step);
            !evolution.cleared.is_disjoint(&piece.transitions) || piece.steps.iter().any(changed)
        })
    };
    let ends = ends(piece, model, graph, graph.can_still(moves));
    let here = ends.map(|state| state.situation.intersection(&piece.steps).copied().collect::<BTreeSet<StepId>>());
    here.filter(|steps| !steps.is_empty()).map(|steps| (piece.partial, steps)).collect()
}

/// The ends of cycles after which something cannot come any more, where a piece is neither forced nor in a final step:
/// there it is meant to end.
fn ends<'g>(piece: &Piece, model: &Model, graph: &'g Graph, hope: Vec<bool>) -> impl Iterator<Item = &'g State> {
    let finals: Vec<StepId> = piece.steps.iter().copied().filter(|step| model.steps[*step].is_final).collect();
    let masters = model.forces.values().filter(|force| force.target == piece.partial).map(|force| force.step);
    let excused: Vec<StepId> = finals.into_iter().chain(masters).collect();
    let hopeless = graph.states.iter().zip(hope).skip(1).filter(|(_, hope)| !hope).map(|(state, _)| state);
    hopeless.filter(move |state| !excused.iter().any(|step| state.situation.contains(step)))
}

/// Whether a source of a convergence can come to wait for ever.
fn stuck(join: TransitionId, source: StepId, model: &Model, graph: &Graph) -> bool {
    let leaves = |evolution: &Evolution| {
        evolution.cleared.iter().any(|id| model.transitions[*id].sources.contains(&source))
            || evolution.before.contains(&source) && !evolution.after.contains(&source)
    };
    let enabled = |edge: &Edge| edge.evolutions.iter().any(|evolution| evolution.enabled.contains(&join));
    let hope = graph.can_still(|edge| enabled(edge) || edge.done(model).iter().any(leaves));
    let Some(piece) = pieces(model).into_iter().find(|piece| piece.transitions.contains(&join)) else { return false };
    ends(&piece, model, graph, hope).any(|state| state.situation.contains(&source))
}
