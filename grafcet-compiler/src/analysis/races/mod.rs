//! Which stored actions can write one place in the same evolution (A7).
//!
//! In an `sfc` the order of the source decides (A29), but between parallel branches nobody reads it off the chart.

mod causes;

use super::explore::{Limits, Rival, rivals_meeting};
use super::{Concurrency, Condition, Facts, Logic, Unlisted, meeting, unlisted};
use crate::list::{List, PushAll};
use crate::model::{
    Association, AssociationId, Effect, Expr, Id, Model, Name, Place, Qualifier, Read, StepId, TransitionId, Tree,
    Trigger, Unary,
};
use crate::sorted::{Map, Set};
use causes::{Cause, When};

/// A stored action, by what it stands at.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Writer {
    /// An action of a step.
    Action(AssociationId),
    /// Actions on the clearing of a transition.
    Clearing(TransitionId),
}

/// The stored actions of a chart of which the order in the source decides who wins.
#[derive(Clone, Debug, Default)]
pub struct Races {
    /// One for each two actions that meet; in source order.
    pub all: Vec<Meet>,
}

/// Two stored actions that can write one place in the same evolution.
#[derive(Clone, Copy, Debug)]
pub struct Meet {
    /// What they write.
    pub place: Place,
    /// The first in the source.
    pub first: Writer,
    /// The other one.
    pub second: Writer,
    /// Where they would not, if the variants of this value were listed.
    pub unlisted: Option<Name>,
}

impl Races {
    /// Finds them. `concurrency` tells which steps can be active together; inputs that the chart excludes do not count.
    pub(crate) fn of(model: &Model, facts: &Facts<'_>, concurrency: &Concurrency, limits: &Limits) -> Self {
        let race = Race::new(model, concurrency, Logic::within(model, concurrency, &facts.never));
        let mut pairs: Vec<(Place, Write<'_>, Write<'_>)> = Vec::new();
        for (place, writes) in race.collect() {
            let causes: Vec<Set<Cause>> = writes.iter().map(|write| race.causes(write.when, 0)).list();
            let things: Vec<_> = writes
                .iter()
                .zip(&causes)
                .enumerate()
                .flat(|(i, (write, causes))| race.steps_of(write, causes).into_iter().map(move |step| (i, step)))
                .list();
            for (i, j) in meeting::pairs(concurrency, &things) {
                let (first, second) = (&writes[i], &writes[j]);
                if race.can_meet((first, &causes[i]), (second, &causes[j])) {
                    pairs.push((place, first.clone(), second.clone()));
                }
            }
        }
        // What holds pair by pair may never come about in the course of the chart.
        if model.is_grafcet() && !pairs.is_empty() {
            let rivals: Vec<(Rival<'_>, Rival<'_>)> =
                pairs.iter().map(|(_, first, second)| (first.rival(model), second.rival(model))).list();
            let mut met = rivals_meeting(model, facts, limits, &rivals).into_iter();
            pairs.retain(|_| met.next() != Some(false));
        }
        let mut reported = Set::new();
        let all = pairs.into_iter().filter(|(place, a, b)| {
            reported.insert((*place, drawn(model, a.writer), a.number, drawn(model, b.writer), b.number))
        });
        let unlisted = unlisted(model, &race.logic);
        let meet = |(place, first, second): (Place, Write<'_>, Write<'_>)| Meet {
            place,
            first: first.writer,
            second: second.writer,
            unlisted: unlisted.iter().find(|one| race.would_part(&first, &second, one)).map(|one| one.name),
        };
        Self { all: all.map(meet).list() }
    }
}

/// One stored action that writes a place.
#[derive(Clone)]
struct Write<'m> {
    /// What it writes, where that is known before.
    value: Option<Tree>,
    when: When,
    conditions: Vec<&'m Expr>,
    writer: Writer,
    /// Of the actions on one clearing, which.
    number: usize,
}

impl<'m> Write<'m> {
    fn rival(&self, model: &'m Model) -> Rival<'m> {
        match self.writer {
            Writer::Action(id) => Rival::Action(&model.associations[id]),
            Writer::Clearing(id) => Rival::Clearing(id),
        }
    }
}

struct Race<'m> {
    model: &'m Model,
    concurrency: &'m Concurrency,
    logic: Logic<'m>,
    entering: Vec<Vec<TransitionId>>,
    leaving: Vec<Vec<TransitionId>>,
}

impl<'m> Race<'m> {
    fn new(model: &'m Model, concurrency: &'m Concurrency, logic: Logic<'m>) -> Self {
        let mut entering = vec![Vec::new(); model.steps.len()];
        let mut leaving = vec![Vec::new(); model.steps.len()];
        for (id, transition) in model.transitions.iter() {
            // A4g: a step that is left and entered at once is neither; in an `sfc` it is both (A4s).
            let stays = |step: &&StepId| {
                model.is_grafcet() && transition.sources.contains(step) && transition.targets.contains(step)
            };
            transition.targets.iter().filter(|s| !stays(s)).for_each(|step| entering[step.index()].push(id));
            transition.sources.iter().filter(|s| !stays(s)).for_each(|step| leaving[step.index()].push(id));
        }
        Self { model, concurrency, logic, entering, leaving }
    }

    /// The writes of each place.
    fn collect(&self) -> Map<Place, Vec<Write<'m>>> {
        let model = self.model;
        let mut all: Map<Place, Vec<Write<'m>>> = Map::new();
        for (id, association) in model.associations.iter().filter(|(_, association)| self.is_write(association)) {
            let value = match (&association.effect, association.qualifier) {
                (Effect::Control(_), qualifier) => Some(Tree::Bool(qualifier == Qualifier::S)),
                (effect, _) => constant(effect),
            };
            let when = match association.qualifier.trigger(model.dialect) {
                Trigger::Deactivation => When::Left(association.step),
                Trigger::Activation => When::Entered(association.step),
                Trigger::Active | Trigger::Event => When::Active(association.step),
            };
            let conditions: Vec<_> = association.condition.iter().and(&association.event).list();
            for place in association.effect.writes() {
                let (value, conditions) = (value.clone(), conditions.clone());
                all.or_default(*place).push(Write { value, when, conditions, writer: Writer::Action(id), number: 0 });
            }
        }
        for (id, transition) in model.transitions.iter() {
            for (number, effect) in transition.clearing.iter().enumerate() {
                for place in effect.writes() {
                    let (value, when, writer) = (constant(effect), When::Cleared(id), Writer::Clearing(id));
                    all.or_default(*place).push(Write { value, when, conditions: Vec::new(), writer, number });
                }
            }
        }
        all
    }

    /// In an `sfc` what is switched by qualifiers is combined by the action control, and R dominates.
    fn is_write(&self, association: &Association) -> bool {
        if self.model.is_grafcet() {
            return association.is_stored();
        }
        match &association.effect {
            Effect::Assign(Place::Output(_), _) => association.qualifier != Qualifier::N,
            Effect::Assign(..) | Effect::Block(_) => true,
            Effect::Control(_) | Effect::Call(..) => false,
        }
    }

    /// Whether both can write in one evolution, and not just the same value.
    fn can_meet(&self, (a, of_a): (&Write<'_>, &Set<Cause>), (b, of_b): (&Write<'_>, &Set<Cause>)) -> bool {
        if a.value.is_some() && a.value == b.value {
            return false;
        }
        if !self.model.is_grafcet() && !self.are_parallel(a.writer, b.writer) {
            return false;
        }
        if a.writer != b.writer && drawn(self.model, a.writer) == drawn(self.model, b.writer) {
            // What is done on the clearing of an `any` is done once.
            return false;
        }
        if let (When::Entered(x), When::Entered(y)) = (a.when, b.when) {
            if self.model.is_grafcet() && x != y && !self.concurrency.together(x, y) {
                return false;
            }
        }
        of_a.iter().any(|x| of_b.iter().any(|y| self.happen_together(*x, *y) && !self.exclude((a, *x), (b, *y))))
    }

    fn are_parallel(&self, a: Writer, b: Writer) -> bool {
        match (a, b) {
            (Writer::Action(a), Writer::Action(b)) => {
                let (a, b) = (self.model.associations[a].step, self.model.associations[b].step);
                a != b && self.concurrency.together(a, b)
            }
            _ => true,
        }
    }

    /// The conditions under which an action runs, and those of what it follows from.
    fn conditions(&self, write: &Write<'_>, cause: Cause) -> Vec<Condition> {
        let active = |step: &StepId| self.logic.condition(&Tree::Read(Read::Active(*step)));
        let mut all: Vec<Condition> = write.conditions.iter().map(|expr| self.logic.of_action(&expr.tree)).list();
        match cause {
            Cause::Transition(id) => {
                let transition = &self.model.transitions[id];
                all.push(self.logic.condition(&transition.condition.tree));
                all.push_all(transition.sources.iter().map(active));
            }
            Cause::While(step) if self.model.is_grafcet() => all.push(active(&step)),
            Cause::While(_) => {}
            // Before it no step is active.
            Cause::Start => return all,
        }
        // Whoever is left has been active, and whoever is entered has not.
        match write.when {
            When::Left(step) if self.model.is_grafcet() => all.push(active(&step)),
            When::Entered(step) if self.model.is_grafcet() => all.push(self.logic.condition(&inactive(step))),
            _ => {}
        }
        all
    }

    /// Whether the conditions under which both write exclude each other.
    fn exclude(&self, a: (&Write<'_>, Cause), b: (&Write<'_>, Cause)) -> bool {
        let all = self.conditions_of_both(a, b);
        let goals: Vec<_> = all.iter().map(|condition| (condition, true)).list();
        self.logic.impossible(&goals)
    }

    /// Whether they would never write in one evolution, if the variants of a value were listed.
    fn would_part(&self, a: &Write<'_>, b: &Write<'_>, unlisted: &Unlisted) -> bool {
        let (of_a, of_b) = (self.causes(a.when, 0), self.causes(b.when, 0));
        of_a.iter().all(|x| {
            of_b.iter().all(|y| {
                !self.happen_together(*x, *y)
                    || unlisted.decides(&self.logic, &self.conditions_of_both((a, *x), (b, *y)))
            })
        })
    }

    fn conditions_of_both(&self, a: (&Write<'_>, Cause), b: (&Write<'_>, Cause)) -> Vec<Condition> {
        // In an `sfc` those of actions are read after the evolution, those of transitions before it.
        if !self.model.is_grafcet() && (!a.0.conditions.is_empty() || !b.0.conditions.is_empty()) {
            let of = |write: &Write<'_>| write.conditions.iter().map(|expr| self.logic.of_action(&expr.tree)).list();
            return of(a.0).into_iter().and(of(b.0)).list();
        }
        self.conditions(a.0, a.1).into_iter().and(self.conditions(b.0, b.1)).list()
    }

    /// The steps by which writes meet: in a `grafcet` for each cause one that is active before, where there is one.
    fn steps_of(&self, write: &Write<'_>, causes: &Set<Cause>) -> Vec<Option<StepId>> {
        match write.writer {
            Writer::Action(id) if !self.model.is_grafcet() => vec![Some(self.model.associations[id].step)],
            _ => causes
                .iter()
                .map(|cause| match cause {
                    Cause::Start => None,
                    Cause::Transition(id) => self.model.transitions[*id].sources.first().copied(),
                    Cause::While(step) => Some(*step),
                })
                .list(),
        }
    }
}

/// Of the transitions for which an `any` stands, the first.
fn drawn(model: &Model, writer: Writer) -> Writer {
    match writer {
        Writer::Clearing(id) => Writer::Clearing(model.transitions[id].any.map_or(id, |any| model.anys[any].first)),
        Writer::Action(_) => writer,
    }
}

/// `!Step.X`
fn inactive(step: StepId) -> Tree {
    Tree::Unary(Unary::Not, Box::new(Tree::Read(Read::Active(step))))
}

fn constant(effect: &Effect) -> Option<Tree> {
    match effect {
        Effect::Assign(_, value) if matches!(value.tree, Tree::Bool(_) | Tree::Int(_)) => Some(value.tree.clone()),
        _ => None,
    }
}
