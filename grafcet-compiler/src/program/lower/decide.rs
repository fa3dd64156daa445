//! Which transitions clear: "a transition is cleared if all its source steps are active and its condition holds", decided on the
//! situation before the evolution, all before the first of them clears.

use super::Lower;
use super::view::Moment;
use crate::list::List;
use crate::model::{AnyId, Id, StepId, Transition, TransitionId};
use crate::program::build::{all, any, not, yes};
use crate::program::{Expr, PlaceId, Statement};
use crate::sorted::Set;
use crate::visit::without_parens;

impl<'m> Lower<'_, 'm> {
    /// All transitions in source order, those of `any` first.
    pub(super) fn decide(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for id in self.model.anys.ids() {
            body.push(Statement::Set(self.anys[id.index()], self.clears_any(id)));
        }
        for (id, transition) in self.model.transitions.iter() {
            let clears = match transition.any {
                // Those of the active steps clear together.
                Some(any) => all(vec![Expr::Place(self.anys[any.index()]), self.all_active(transition)]),
                None => self.clears_one(id, transition),
            };
            body.push(Statement::Set(self.clears[id.index()], clears));
        }
        body
    }

    /// "They come before all other transitions of the net, several `any` in source order."
    fn clears_any(&self, id: AnyId) -> Expr<'m> {
        let one = &self.model.anys[id];
        let mut parts = vec![self.is_free(one.partial)];
        for (other, earlier) in self.model.anys.iter() {
            if other < id && earlier.partial == one.partial {
                parts.push(not(Expr::Place(self.anys[other.index()])));
            }
        }
        parts.push(self.one_active(&one.sources));
        parts.push(self.own_condition(&self.model.transitions[one.first]));
        all(parts)
    }

    fn clears_one(&self, id: TransitionId, transition: &'m Transition) -> Expr<'m> {
        let mut parts = vec![self.is_free(transition.partial), self.all_active(transition)];
        for (other, one) in self.model.anys.iter() {
            if one.partial == transition.partial {
                parts.push(not(Expr::Place(self.anys[other.index()])));
            }
        }
        for other in self.before(id, transition) {
            parts.push(not(Expr::Place(self.clears[other.index()])));
        }
        // `else`: where none of the others does, which may be held back.
        if transition.otherwise.is_none() || transition.held.is_some() {
            parts.push(self.own_condition(transition));
        }
        all(parts)
    }

    /// A28: "none of its source steps is already left by an earlier one of this cycle". In a `grafcet` only an `else` comes last.
    fn before(&self, id: TransitionId, transition: &Transition) -> Vec<TransitionId> {
        if self.model.is_grafcet() {
            return transition.otherwise.clone().unwrap_or_default();
        }
        let mut earlier = Set::new();
        for step in &transition.sources {
            for other in &self.model.leaving[step.index()] {
                // That of an `any` is asked for by name.
                if *other < id && self.model.transitions[*other].any.is_none() {
                    earlier.insert(*other);
                }
            }
        }
        earlier.into_iter().list()
    }

    fn all_active(&self, transition: &Transition) -> Expr<'m> {
        all(transition.sources.iter().map(|step| self.was(*step)).list())
    }

    /// Whether one of some steps was active before the evolution.
    fn one_active(&self, steps: &[StepId]) -> Expr<'m> {
        Self::by_region(steps.iter().map(|step| self.was(*step)).list())
    }

    /// Whether one of some steps is active, region by region.
    pub(super) fn by_region(steps: Vec<Expr<'m>>) -> Expr<'m> {
        let mut regions: Vec<Expr<'m>> = Vec::new();
        for asked in steps {
            let known = regions.iter_mut().find_map(|region| match (region, &asked) {
                (Expr::Is(place, steps), Expr::Is(other, more)) if place == other => Some((steps, more)),
                _ => None,
            });
            match known {
                Some((steps, more)) => steps.extend(more),
                None => regions.push(asked),
            }
        }
        any(regions)
    }

    /// The condition that is written there, without what an `any` puts in front of it.
    fn own_condition(&self, transition: &'m Transition) -> Expr<'m> {
        let mut tokens = &transition.condition.tokens;
        for _ in &transition.guards {
            if let syn::Expr::Binary(guarded) = without_parens(tokens) {
                tokens = &guarded.left;
            }
        }
        self.part_of(tokens, transition.own_condition(), Moment::Before)
    }

    /// What leaves a step.
    pub(super) fn leaving(&self, step: StepId) -> Vec<Expr<'m>> {
        self.model.leaving[step.index()].iter().map(|id| Expr::Place(self.clears[id.index()])).list()
    }

    /// What leads to a step: an `any` as a whole, since one of the steps that it leaves is active where it clears.
    pub(super) fn entering(&self, step: StepId) -> Vec<Expr<'m>> {
        let mut truths: Vec<PlaceId> = Vec::new();
        for id in &self.model.entering[step.index()] {
            let of_any = self.model.transitions[*id].any.map(|any| self.anys[any.index()]);
            let truth = of_any.unwrap_or(self.clears[id.index()]);
            if !truths.contains(&truth) {
                truths.push(truth);
            }
        }
        truths.into_iter().map(Expr::Place).list()
    }

    /// Whether nothing above keeps a partial grafcet from clearing (A13, A17).
    fn is_free(&self, partial: crate::model::PartialId) -> Expr<'m> {
        self.free[partial.index()].map_or_else(yes, Expr::Place)
    }

    /// Whether an `any` has really cleared: the hierarchy may be against it.
    pub(super) fn any_cleared(&self, id: AnyId) -> Expr<'m> {
        let of = self.model.transitions.iter().filter(|(_, transition)| transition.any == Some(id));
        any(of.map(|(transition, _)| Expr::Place(self.clears[transition.index()])).list())
    }
}
