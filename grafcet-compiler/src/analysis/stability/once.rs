//! What happens once in a cycle at most: transitions that clear, events.

use crate::analysis::Concurrency;
use crate::analysis::edges::is_edge_of_inputs;
use crate::model::{
    Association, Binary, Blink, Blinker, Model, Read, StepId, TimeRef, Transition, TransitionId, Tree, Unary,
};

/// Whether a transition asks for an edge of inputs, which only the first evolution of a cycle sees (A2), or for a time of its
/// own source step, which begins anew with the step (A23).
pub(super) fn clears_once(model: &Model, concurrency: &Concurrency, id: TransitionId) -> bool {
    let transition = &model.transitions[id];
    let timed = |step: StepId| transition.sources.contains(&step) && is_left(model, concurrency, id, step);
    asks(&transition.condition.tree, &|tree| match tree {
        Tree::Read(read) => is_edge_of_inputs(model, read),
        Tree::Elapsed(TimeRef::Ticks(ticks), step) => *ticks > 0 && timed(*step),
        // A period begins with the part in which it is true.
        Tree::Unary(Unary::Not, of) => match **of {
            Tree::Read(Read::Blink(Blink { of: Blinker::Step(step), .. })) => timed(step),
            _ => false,
        },
        _ => false,
    })
}

/// Whether the event of an action is an edge of inputs.
pub(super) fn happens_once(model: &Model, association: &Association) -> bool {
    let is_edge = |tree: &Tree| matches!(tree, Tree::Read(read) if is_edge_of_inputs(model, read));
    association.event.as_ref().is_some_and(|event| asks(&event.tree, &is_edge))
}

/// Whether the condition holds only where one of these does.
fn asks(tree: &Tree, once: &dyn Fn(&Tree) -> bool) -> bool {
    match tree {
        Tree::Binary(Binary::And, a, b) => asks(a, once) || asks(b, once),
        Tree::Binary(Binary::Or, a, b) => asks(a, once) && asks(b, once),
        other => once(other),
    }
}

/// Whether clearing the transition leaves the step: none enters it in the same evolution, so that it would stay active (A4g).
fn is_left(model: &Model, concurrency: &Concurrency, id: TransitionId, step: StepId) -> bool {
    let beside =
        |other: &Transition| other.sources.iter().all(|source| *source == step || concurrency.together(*source, step));
    let enters = |(other, transition): (TransitionId, &Transition)| {
        transition.targets.contains(&step) && (other == id || beside(transition))
    };
    !model.transitions.iter().any(enters)
}
