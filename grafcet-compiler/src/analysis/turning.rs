//! The circles that turn without end in one cycle (A30), as one draws them.

use super::circles::{Circle, Circles};
use super::explore::Exploration;
use super::refuted::{self, Asked};
use super::{Facts, Logic};
use crate::list::{List, PushAll};
use crate::model::{Model, StepId, TransitionId};
use crate::sorted::Set;

/// Those that turn whenever they are entered; `None` where it is known that every search ends.
pub(crate) fn certain(
    model: &Model,
    facts: &Facts<'_>,
    exploration: &Exploration,
    asked: Asked<'_, '_>,
) -> Option<Vec<Circle>> {
    if exploration.settles() {
        return None;
    }
    let certain = match exploration.endless(model) {
        Some(all) => {
            let circle = |transitions| Circle { transitions, inputs: String::new() };
            all.into_iter().map(circle).list()
        }
        None => {
            let logic = Logic::within(model, facts.across(model), &facts.never);
            Circles::new(model, facts.across(model), &logic, &facts.initial).certain()
        }
    };
    // A circle that turns whenever it is entered may never be.
    (certain.is_empty() || !refuted::settles(model, asked)).then_some(certain)
}

/// Further ones, of other legs, that turn under some values.
pub(crate) fn possible(model: &Model, facts: &Facts<'_>, certain: &[Circle]) -> Vec<Circle> {
    // The many questions about single transitions are not at the expense of those about the certain ones.
    let logic = Logic::within(model, facts.across(model), &facts.never);
    let possible = Circles::new(model, facts.across(model), &logic, &facts.initial).possible(certain);
    by_legs(model, possible, certain)
}

/// Between which steps a transition leads.
pub(crate) type Leg<'m> = (&'m [StepId], &'m [StepId]);

/// The legs of a circle, each once: transitions between the same steps are one leg, whether they clear together or one in place of
/// the other.
pub(crate) fn legs<'m>(model: &'m Model, circle: &Circle) -> Vec<Leg<'m>> {
    let mut legs: Vec<Leg<'m>> = Vec::new();
    for id in &circle.transitions {
        let transition = &model.transitions[*id];
        let leg = (&transition.sources[..], &transition.targets[..]);
        if !legs.contains(&leg) {
            legs.push(leg);
        }
    }
    legs
}

/// The circles but those of `known` legs, all of the same legs as one.
pub(crate) fn by_legs(model: &Model, circles: Vec<Circle>, known: &[Circle]) -> Vec<Circle> {
    let set = |circle: &Circle| legs(model, circle).into_iter().collect::<Set<Leg<'_>>>();
    let known: Vec<_> = known.iter().map(set).list();
    let mut all: Vec<(Set<Leg<'_>>, Circle)> = Vec::new();
    for circle in circles {
        let legs = set(&circle);
        if known.contains(&legs) {
            continue;
        }
        match all.iter_mut().find(|(other, _)| *other == legs) {
            Some((_, same)) => {
                let new = circle.transitions.into_iter().filter(|id| !same.transitions.contains(id));
                let new: Vec<TransitionId> = new.list();
                same.transitions.push_all(new);
            }
            None => all.push((legs, circle)),
        }
    }
    all.into_iter().map(|(_, circle)| circle).list()
}
