//! What happens once in a cycle at most, or as often as something clears: transitions, events.

use super::is_constant_read;
use crate::analysis::Concurrency;
use crate::analysis::edges::{asks, is_edge_of, is_edge_of_inputs};
use crate::ast::Dialect;
use crate::model::{
    Association, Blink, Blinker, Model, Name, Place, Qualifier, Read, StepId, TimeRef, Transition, TransitionId, Tree,
    Unary,
};
use crate::qualifier::Trigger;

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

/// How often the events of actions can happen in a search.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Events {
    None,
    /// In the first evolution alone: edges of inputs.
    First,
    /// There, and after each evolution in which something clears: edges of steps, and of what is stored where steps are entered and left.
    AfterClearings,
}

/// `None` where events may follow each other without anything that clears.
pub(super) fn events(model: &Model) -> Option<Events> {
    let mut found = Events::None;
    for association in model.associations.values().filter(|one| one.qualifier == Qualifier::On) {
        let holds_with = |is_edge: &dyn Fn(&Read) -> bool| {
            let is_edge = |tree: &Tree| matches!(tree, Tree::Read(read) if is_edge(read));
            association.event.as_ref().is_some_and(|event| asks(&event.tree, &is_edge))
        };
        if holds_with(&|read| is_edge_of_inputs(model, read)) {
            found = if found == Events::None { Events::First } else { found };
        } else if holds_with(&|read| is_edge_of(model, read, &|of| changes_with_clearings(model, of))) {
            found = Events::AfterClearings;
        } else {
            return None;
        }
    }
    Some(found)
}

/// Whether within a search a read changes in evolutions in which something clears, if at all.
fn changes_with_clearings(model: &Model, read: &Read) -> bool {
    let place = match read {
        Read::Active(_) | Read::MacroActive(_) => return true,
        Read::Name(Name::Var(id)) => Place::Var(*id),
        Read::Name(Name::Output(id)) => Place::Output(*id),
        read => return is_constant_read(read),
    };
    let with_steps = |one: &Association| {
        matches!(one.qualifier.trigger(Dialect::Grafcet), Trigger::Activation | Trigger::Deactivation)
    };
    model.associations.values().all(|one| with_steps(one) || !one.effect.writes().contains(&place))
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
