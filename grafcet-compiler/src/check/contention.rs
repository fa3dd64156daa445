//! `conflicting_values`, `timed_contention`: steps that are active together and want different things.

use crate::analysis::{Concurrency, Condition, Logic, meeting};
use crate::diagnostic::{Rule, Sink, rules};
use crate::list::List;
use crate::model::{ActionId, Association, Effect, LevelAttr, Model, OutputId, Place, Qualifier, Read, TimeRef, Tree};
use crate::sorted::{Map, Set};

pub(super) fn check(model: &Model, concurrency: &Concurrency, never: &[&Tree], sink: &mut Sink) {
    let contention = Contention { model, concurrency, logic: Logic::within(model, concurrency, never) };
    contention.values(sink);
    if !model.is_grafcet() {
        contention.times(sink);
    }
}

struct Contention<'m> {
    model: &'m Model,
    concurrency: &'m Concurrency,
    logic: Logic<'m>,
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
            for (i, j) in self.meetings(&associations, differ) {
                let name = &self.model.outputs[output].name;
                let note = |one: &Association, other: &Association| {
                    let text = |association: &Association| match &association.effect {
                        Effect::Assign(_, value) => value.text.clone(),
                        _ => String::new(),
                    };
                    let message = format!(
                        "`{name}` is `{}` here, and `{}` {}; let the conditions exclude each other, or assign it in one \
                         place",
                        text(one),
                        text(other),
                        self.elsewhere(one, other)
                    );
                    (one.mark, message)
                };
                let (first, second) = (associations[i], associations[j]);
                let notes = vec![note(first, second), note(second, first)];
                let levels = &self.model.outputs[output].levels;
                self.report(&rules::CONFLICTING_VALUES, (first, second), levels, notes, sink);
            }
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
            for (i, j) in self.meetings(&all, |_, _| true) {
                let note = |one: &Association, other: &Association| {
                    let message = format!(
                        "`{name}` is timed here with {}, and with {} {}; an action has one timer: let only one of these act at \
                         a time, or use two actions",
                        self.time(one),
                        self.time(other),
                        self.elsewhere(one, other)
                    );
                    (one.mark, message)
                };
                let (first, second) = (all[i], all[j]);
                let notes = vec![note(first, second), note(second, first)];
                self.report(&rules::TIMED_CONTENTION, (first, second), levels, notes, sink);
            }
        }
    }

    /// The pairs of associations that can act at the same time; each is paired with the first one before it.
    fn meetings(&self, all: &[&Association], differ: impl Fn(usize, usize) -> bool) -> Vec<(usize, usize)> {
        let things: Vec<_> = all.iter().enumerate().map(|(i, association)| (i, Some(association.step))).list();
        let mut reported = Set::new();
        let pairs = meeting::pairs(self.concurrency, &things).into_iter();
        pairs.filter(|(i, j)| differ(*i, *j) && !self.exclude(all[*i], all[*j]) && reported.insert(*j)).list()
    }

    /// Whether the two never act at the same time.
    fn exclude(&self, a: &Association, b: &Association) -> bool {
        let of = |association: &Association| {
            let condition = association.condition.iter().map(|expr| self.logic.of_action(&expr.tree));
            let active = self.logic.condition(&Tree::Read(Read::Active(association.step)));
            condition.chain([active]).list()
        };
        let all: Vec<Condition> = of(a).into_iter().chain(of(b)).list();
        let goals: Vec<_> = all.iter().map(|condition| (condition, true)).list();
        self.logic.impossible(&goals)
    }

    fn elsewhere(&self, one: &Association, other: &Association) -> String {
        if one.step == other.step {
            return "once more in this step".to_owned();
        }
        format!("in step `{}`, which can be active at the same time", self.model.steps[other.step].name)
    }

    fn time(&self, association: &Association) -> String {
        match association.time {
            Some(TimeRef::Ticks(ticks)) => format!("`{}`", self.model.time_text(i128::from(ticks))),
            Some(TimeRef::Param(id)) => format!("`{}`", self.model.params[id].name),
            Some(TimeRef::Var(id)) => format!("`{}`", self.model.vars[id].name),
            None => "no time".to_owned(),
        }
    }

    fn report(
        &self,
        rule: &'static Rule,
        (first, second): (&Association, &Association),
        levels: &[LevelAttr],
        notes: Vec<(crate::diagnostic::Mark, String)>,
        sink: &mut Sink,
    ) {
        let (one, other) = (&self.model.steps[first.step], &self.model.steps[second.step]);
        let mut scopes: Vec<&[LevelAttr]> = vec![&one.levels, &other.levels, levels];
        scopes.push(&self.model.partials[one.partial].levels);
        scopes.extend(self.model.levels_of(other).split_off(1));
        sink.rule(rule, &scopes, notes);
    }
}
