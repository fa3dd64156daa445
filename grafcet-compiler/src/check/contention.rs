//! `conflicting_values`, `timed_contention`: steps that are active together and want different things.

use super::rivals::{self, Rivals};
use crate::analysis::Concurrency;
use crate::analysis::conflicts::{Conflict, Conflicts, Contended};
use crate::diagnostic::{Rule, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{Association, Effect, LevelAttr, Model, Tree};

pub(super) fn check(model: &Model, concurrency: &Concurrency, never: &[&Tree], sink: &mut Sink) {
    let contention = Contention { model, conflicts: Conflicts::new(model, concurrency, never) };
    contention.values(sink);
    if !model.is_grafcet() {
        contention.times(sink);
    }
}

struct Contention<'m> {
    model: &'m Model,
    conflicts: Conflicts<'m>,
}

impl Contention<'_> {
    fn values(&self, sink: &mut Sink) {
        let value = |association: &Association| match &association.effect {
            Effect::Assign(_, value) => format!("`{}`", value.text),
            _ => String::new(),
        };
        for conflict in &self.conflicts.values() {
            self.report(&rules::CONFLICTING_VALUES, conflict, sink, |name, one, others| {
                format!(
                    "`{name}` is {} here, and {}; let the conditions exclude each other, or assign it in one place",
                    value(one),
                    self.elsewhere(one, others, value)
                )
            });
        }
    }

    fn times(&self, sink: &mut Sink) {
        let time = |association: &Association| format!("with {}", self.time(association));
        for conflict in &self.conflicts.times() {
            self.report(&rules::TIMED_CONTENTION, conflict, sink, |name, one, others| {
                format!(
                    "`{name}` is timed here {}, and {}; an action has one timer: let only one of these act at a time, or \
                     use two actions",
                    time(one),
                    self.elsewhere(one, others, time)
                )
            });
        }
    }

    /// What others say, and where.
    fn elsewhere(&self, one: &Association, others: &[&Association], what: impl Fn(&Association) -> String) -> String {
        let text = |other: &&Association| {
            if one.step == other.step {
                return format!("{} once more in this step", what(other));
            }
            format!("{} in step `{}`", what(other), self.model.steps[other.step].name)
        };
        let texts: Vec<String> = others.iter().map(text).list();
        let beside = others.iter().any(|other| one.step != other.step);
        let when = if beside { ", which can be active at the same time" } else { "" };
        format!("{}{when}", rivals::listed(&texts))
    }

    fn time(&self, association: &Association) -> String {
        let text = |time| format!("`{}`", self.model.time_ref_text(time));
        association.time.map_or_else(|| "no time".to_owned(), text)
    }

    /// What is said of a list of variants, where that would keep them apart.
    fn list_them(&self, one: &Association, others: &[&Association]) -> String {
        let unlisted = self.conflicts.unlisted(one, others);
        unlisted.map_or_else(String::new, |name| rivals::list_them(self.model, name))
    }

    fn report(
        &self,
        rule: &'static Rule,
        Conflict { about, all, meetings }: &Conflict<'_>,
        sink: &mut Sink,
        message: impl Fn(&syn::Ident, &Association, &[&Association]) -> String,
    ) {
        let (name, levels) = match *about {
            Contended::Place(place) => (self.model.place_name(place), self.model.levels_of_place(place)),
            Contended::Action(action) => (&self.model.actions[action].name, &self.model.actions[action].levels[..]),
        };
        let mut rivals = Rivals::new(rule, self.model.dialect);
        for (first, second) in meetings {
            let (one, other) = (&self.model.steps[all[*first].step], &self.model.steps[all[*second].step]);
            let mut scopes: Vec<&[LevelAttr]> = vec![&one.levels, &other.levels, levels];
            scopes.push(&self.model.partials[one.partial].levels);
            scopes.push_all(self.model.levels_of(other).split_off(1));
            rivals.add(*first, *second, &scopes);
        }
        rivals.report(sink, |one, others| {
            let others: Vec<&Association> = others.iter().map(|other| all[*other]).list();
            (all[one].mark, message(name, all[one], &others) + &self.list_them(all[one], &others))
        });
    }
}
