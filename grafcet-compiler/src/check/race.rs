//! `write_race`: two stored actions that can write one place in the same evolution (A7).

use super::rivals::{self, Rivals};
use crate::analysis::{Meet, Races, Writer};
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::List;
use crate::model::{LevelAttr, Model, Place, StepId, TransitionId};
use crate::sorted::{Map, Set};

/// Leaves out what is `mixed` already.
pub(super) fn check(model: &Model, races: &Races, mixed: &Set<Place>, sink: &mut Sink) {
    let mut of_place: Map<Place, Vec<Meet>> = Map::new();
    for meet in races.all.iter().filter(|meet| !mixed.contains(&meet.place)) {
        of_place.or_default(meet.place).push(*meet);
    }
    for (place, meets) in of_place {
        Race { model, place, meets: &meets }.report(sink);
    }
}

/// What an action stands at.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Owner {
    Step(StepId),
    Transition(TransitionId),
}

struct Race<'m> {
    model: &'m Model,
    place: Place,
    meets: &'m [Meet],
}

impl Race<'_> {
    fn report(&self, sink: &mut Sink) {
        let writers: Set<Writer> = self.meets.iter().flat(|meet| [meet.first, meet.second]).collect();
        let number = |writer: Writer| writers.iter().position(|other| *other == writer).unwrap_or_default();
        let mut rivals = Rivals::new(&rules::WRITE_RACE, self.model.dialect);
        // What races on activation and on deactivation is told once.
        let mut owners = Set::new();
        for meet in self.meets {
            let (a, b) = (self.owner(meet.first), self.owner(meet.second));
            if a == b || owners.insert((a, b)) {
                rivals.add(number(meet.first), number(meet.second), &self.scopes(a, b));
            }
        }
        rivals.report(sink, |one, others| {
            let others: Vec<Writer> = others.iter().map(|other| writers[*other]).list();
            self.note(writers[one], &others)
        });
    }

    fn owner(&self, writer: Writer) -> Owner {
        match writer {
            Writer::Action(id) => Owner::Step(self.model.associations[id].step),
            Writer::Clearing(id) => Owner::Transition(id),
        }
    }

    fn note(&self, writer: Writer, others: &[Writer]) -> (Mark, String) {
        let (model, name) = (self.model, self.model.place_name(self.place));
        let who = |other: &Writer| match self.owner(*other) {
            other if other == self.owner(writer) => "again here".to_owned(),
            Owner::Step(step) => format!("by step `{}`", model.steps[step].name),
            Owner::Transition(id) => format!("by {}", model.transition_text(&model.transitions[id])),
        };
        let about = |meet: &&Meet| {
            let is_one = |one: Writer, other: Writer| one == writer && others.contains(&other);
            is_one(meet.first, meet.second) || is_one(meet.second, meet.first)
        };
        let unlisted = self.meets.iter().filter(about).find_map(|meet| meet.unlisted);
        let list = unlisted.map_or_else(String::new, |name| rivals::list_them(model, name));
        let who = rivals::listed(&others.iter().map(who).list());
        let message = if model.is_grafcet() {
            format!(
                "`{name}` is also written {who} in the same evolution, and which one wins is open; write it in one place, \
                 or let the conditions exclude each other{list}"
            )
        } else {
            let branches = if others.len() == 1 { "a parallel branch" } else { "parallel branches" };
            format!(
                "`{name}` is also written {who}, which can run in the same cycle in {branches}, and only the order \
                 in the source decides which one wins; write it in one branch{list}"
            )
        };
        let mark = match writer {
            Writer::Action(id) => model.associations[id].mark,
            Writer::Clearing(id) => model.transitions[id].mark,
        };
        (mark, message)
    }

    fn scopes(&self, first: Owner, second: Owner) -> [&[LevelAttr]; 6] {
        let model = self.model;
        let levels = |owner: Owner| match owner {
            Owner::Step(step) => &model.steps[step].levels[..],
            Owner::Transition(id) => &model.transitions[id].levels[..],
        };
        let partial = |owner: Owner| match owner {
            Owner::Step(step) => &model.partials[model.steps[step].partial].levels[..],
            Owner::Transition(id) => &model.partials[model.transitions[id].partial].levels[..],
        };
        let place = model.levels_of_place(self.place);
        [levels(first), levels(second), place, partial(first), partial(second), &model.levels]
    }
}
