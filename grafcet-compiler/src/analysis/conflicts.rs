//! Associations of steps that are active together and want different things of one place or action.

use super::{Concurrency, Condition, Logic, Unlisted, meeting, unlisted};
use crate::list::{List, PushAll};
use crate::model::{ActionId, Association, Effect, Model, Name, Place, Qualifier, Read, Tree};
use crate::sorted::Map;

/// What they are about.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Contended {
    Place(Place),
    Action(ActionId),
}

/// All associations of one kind with a subject, some of which can act at the same time.
pub(crate) struct Conflict<'m> {
    pub(crate) about: Contended,
    pub(crate) all: Vec<&'m Association>,
    /// Which of them meet, by their positions.
    pub(crate) meetings: Vec<(usize, usize)>,
}

/// Finds conflicts.
pub(crate) struct Conflicts<'m> {
    model: &'m Model,
    concurrency: &'m Concurrency,
    logic: Logic<'m>,
    unlisted: Vec<Unlisted>,
}

impl<'m> Conflicts<'m> {
    /// Of steps that can be active together; inputs for which one of `never` holds do not count.
    pub(crate) fn new(model: &'m Model, concurrency: &'m Concurrency, never: &'m [&'m Tree]) -> Self {
        let logic = Logic::within(model, concurrency, never);
        Self { model, concurrency, unlisted: unlisted(model, &logic), logic }
    }

    /// A35: an assigned output has the value of the step that assigns it; two steps cannot both be right.
    pub(crate) fn values(&self) -> Vec<Conflict<'m>> {
        let mut of_output: Map<Contended, Vec<&'m Association>> = Map::new();
        for association in self.model.associations.values() {
            if let (Effect::Assign(output @ Place::Output(_), _), Qualifier::N) =
                (&association.effect, association.qualifier)
            {
                of_output.or_default(Contended::Place(*output)).push(association);
            }
        }
        let value = |association: &'m Association| match &association.effect {
            Effect::Assign(_, value) => Some(&value.tree),
            _ => None,
        };
        let conflict = |(about, all): (Contended, Vec<&'m Association>)| {
            let meetings = self.meetings(&all, |a, b| value(a) != value(b));
            Conflict { about, all, meetings }
        };
        of_output.into_iter().map(conflict).list()
    }

    /// IEC 61131-3: an action has one time input, so at most one timed association of it is active at a time.
    pub(crate) fn times(&self) -> Vec<Conflict<'m>> {
        let mut of_each: Map<Contended, Vec<&'m Association>> = Map::new();
        for association in self.model.associations.values().filter(|association| association.time.is_some()) {
            let about = match association.effect {
                Effect::Control(place) => Contended::Place(place),
                Effect::Call(action, _) => Contended::Action(action),
                Effect::Assign(..) | Effect::Block(_) => continue,
            };
            of_each.or_default(about).push(association);
        }
        let conflict = |(about, all): (Contended, Vec<&'m Association>)| {
            let meetings = self.meetings(&all, |_, _| true);
            Conflict { about, all, meetings }
        };
        of_each.into_iter().map(conflict).list()
    }

    /// The value of which a list of variants would keep one apart from others.
    pub(crate) fn unlisted(&self, one: &Association, others: &[&Association]) -> Option<Name> {
        let decides =
            |value: &&Unlisted| others.iter().any(|other| value.decides(&self.logic, &self.conditions(&[one, other])));
        self.unlisted.iter().find(decides).map(|value| value.name)
    }

    /// The pairs that differ and can act at the same time.
    fn meetings(
        &self,
        all: &[&'m Association],
        differ: impl Fn(&'m Association, &'m Association) -> bool,
    ) -> Vec<(usize, usize)> {
        let things: Vec<_> = all.iter().enumerate().map(|(i, association)| (i, Some(association.step))).list();
        let pairs = meeting::pairs(self.concurrency, &things).into_iter();
        pairs.filter(|(i, j)| differ(all[*i], all[*j]) && !self.exclude(all[*i], all[*j])).list()
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
}
