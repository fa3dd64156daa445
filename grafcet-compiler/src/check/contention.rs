//! `conflicting_values`, `timed_contention`: steps that are active together and want different things.

use super::rivals::{self, Rivals};
use crate::analysis::{Concurrency, Condition, Logic, Unlisted, meeting, unlisted};
use crate::diagnostic::{Rule, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{ActionId, Association, Effect, LevelAttr, Model, OutputId, Place, Qualifier, Read, Tree};
use crate::sorted::Map;

pub(super) fn check(model: &Model, concurrency: &Concurrency, never: &[&Tree], sink: &mut Sink) {
    let logic = Logic::within(model, concurrency, never);
    let contention = Contention { model, concurrency, unlisted: unlisted(model, &logic), logic };
    contention.values(sink);
    if !model.is_grafcet() {
        contention.times(sink);
    }
}

struct Contention<'m> {
    model: &'m Model,
    concurrency: &'m Concurrency,
    logic: Logic<'m>,
    unlisted: Vec<Unlisted>,
}

/// What time-related qualifiers act on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Target {
    Place(Place),
    Action(ActionId),
}

impl Contention<'_> {
    /// A35: an assigned output has the value of the step that assigns it; two steps cannot both be right.
    fn values(&self, sink: &mut Sink) {
        let mut of_output: Map<OutputId, Vec<(&Association, &Tree)>> = Map::new();
        for association in self.model.associations.values() {
            if let (Effect::Assign(Place::Output(output), value), Qualifier::N) =
                (&association.effect, association.qualifier)
            {
                of_output.or_default(*output).push((association, &value.tree));
            }
        }
        for (output, all) in of_output {
            let associations: Vec<&Association> = all.iter().map(|(association, _)| *association).list();
            let differ = |i: usize, j: usize| all[i].1 != all[j].1;
            let output = &self.model.outputs[output];
            let value = |association: &Association| match &association.effect {
                Effect::Assign(_, value) => format!("`{}`", value.text),
                _ => String::new(),
            };
            let meetings = self.meetings(&associations, differ);
            self.report(&rules::CONFLICTING_VALUES, &associations, &meetings, &output.levels, sink, |one, others| {
                format!(
                    "`{}` is {} here, and {}; let the conditions exclude each other, or assign it in one place",
                    output.name,
                    value(one),
                    self.elsewhere(one, others, value)
                )
            });
        }
    }

    /// IEC 61131-3: an action has one time input, so at most one timed association of it is active at a time.
    fn times(&self, sink: &mut Sink) {
        let mut of_target: Map<Target, Vec<&Association>> = Map::new();
        for association in self.model.associations.values().filter(|association| association.time.is_some()) {
            let target = match association.effect {
                Effect::Control(place) => Target::Place(place),
                Effect::Call(action, _) => Target::Action(action),
                Effect::Assign(..) | Effect::Block(_) => continue,
            };
            of_target.or_default(target).push(association);
        }
        for (target, all) in of_target {
            let (name, levels) = match target {
                Target::Place(place) => (self.model.place_name(place), self.model.levels_of_place(place)),
                Target::Action(action) => (&self.model.actions[action].name, &self.model.actions[action].levels[..]),
            };
            let meetings = self.meetings(&all, |_, _| true);
            self.report(&rules::TIMED_CONTENTION, &all, &meetings, levels, sink, |one, others| {
                let time = |association: &Association| format!("with {}", self.time(association));
                format!(
                    "`{name}` is timed here {}, and {}; an action has one timer: let only one of these act at a time, or \
                     use two actions",
                    time(one),
                    self.elsewhere(one, others, time)
                )
            });
        }
    }

    /// The pairs of associations that can act at the same time.
    fn meetings(&self, all: &[&Association], differ: impl Fn(usize, usize) -> bool) -> Vec<(usize, usize)> {
        let things: Vec<_> = all.iter().enumerate().map(|(i, association)| (i, Some(association.step))).list();
        let pairs = meeting::pairs(self.concurrency, &things).into_iter();
        pairs.filter(|(i, j)| differ(*i, *j) && !self.exclude(all[*i], all[*j])).list()
    }

    /// Whether the two never act at the same time.
    fn exclude(&self, a: &Association, b: &Association) -> bool {
        let all = self.conditions(&[a, b]);
        let goals: Vec<_> = all.iter().map(|condition| (condition, true)).list();
        self.logic.impossible(&goals)
    }

    /// Under which they act together.
    fn conditions(&self, all: &[&Association]) -> Vec<Condition> {
        let mut conditions = Vec::new();
        for association in all {
            conditions.push_all(association.condition.iter().map(|expr| self.logic.of_action(&expr.tree)));
            conditions.push(self.logic.condition(&Tree::Read(Read::Active(association.step))));
        }
        conditions
    }

    /// What is said of a list of variants, where that would keep them apart.
    fn list_them(&self, one: &Association, others: &[&Association]) -> String {
        let decides =
            |value: &&Unlisted| others.iter().any(|other| value.decides(&self.logic, &self.conditions(&[one, other])));
        let unlisted = self.unlisted.iter().find(decides);
        unlisted.map_or_else(String::new, |value| rivals::list_them(self.model, value.name))
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

    fn report(
        &self,
        rule: &'static Rule,
        all: &[&Association],
        meetings: &[(usize, usize)],
        levels: &[LevelAttr],
        sink: &mut Sink,
        message: impl Fn(&Association, &[&Association]) -> String,
    ) {
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
            (all[one].mark, message(all[one], &others) + &self.list_them(all[one], &others))
        });
    }
}
