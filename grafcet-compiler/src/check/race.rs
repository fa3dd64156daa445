//! `write_race`: two stored actions that can write one place in the same evolution (A7).

use crate::analysis::{Races, Writer};
use crate::diagnostic::{Sink, rules};
use crate::model::{LevelAttr, Model, Place, StepId, TransitionId};
use crate::sorted::Set;

/// Leaves out what is `mixed` already.
pub(super) fn check(model: &Model, races: &Races, mixed: &Set<Place>, sink: &mut Sink) {
    for (place, first, second) in races.all.iter().filter(|(place, ..)| !mixed.contains(place)) {
        report(model, *place, *first, *second, sink);
    }
}

/// What an action stands at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Owner {
    Step(StepId),
    Transition(TransitionId),
}

fn report(model: &Model, place: Place, first: Writer, second: Writer, sink: &mut Sink) {
    let name = model.place_name(place);
    let owner = |writer: Writer| match writer {
        Writer::Action(id) => Owner::Step(model.associations[id].step),
        Writer::Clearing(id) => Owner::Transition(id),
    };
    let mark = |writer: Writer| match writer {
        Writer::Action(id) => model.associations[id].mark,
        Writer::Clearing(id) => model.transitions[id].mark,
    };
    let text = |writer: Writer| match owner(writer) {
        Owner::Step(step) => format!("step `{}`", model.steps[step].name),
        Owner::Transition(id) => model.transition_text(&model.transitions[id]),
    };
    let note = |writer: Writer, other: Writer| {
        let who = if owner(writer) == owner(other) { "again here".to_owned() } else { format!("by {}", text(other)) };
        let message = if model.is_grafcet() {
            format!(
                "`{name}` is also written {who} in the same evolution, and which one wins is open; write it in one place, \
                 or let the conditions exclude each other"
            )
        } else {
            format!(
                "`{name}` is also written {who}, which can run in the same cycle in a parallel branch, and only the order \
                 in the source decides which one wins; write it in one branch"
            )
        };
        (mark(writer), message)
    };
    let levels = |writer: Writer| match owner(writer) {
        Owner::Step(step) => &model.steps[step].levels[..],
        Owner::Transition(id) => &model.transitions[id].levels[..],
    };
    let partial = |writer: Writer| match owner(writer) {
        Owner::Step(step) => &model.partials[model.steps[step].partial].levels[..],
        Owner::Transition(id) => &model.partials[model.transitions[id].partial].levels[..],
    };
    let place = model.levels_of_place(place);
    let scopes: [&[LevelAttr]; 6] =
        [levels(first), levels(second), place, partial(first), partial(second), &model.levels];
    sink.rule_in(model.dialect, &rules::WRITE_RACE, &scopes, vec![note(first, second), note(second, first)]);
}
