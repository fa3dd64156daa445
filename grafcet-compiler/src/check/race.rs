//! `write_race`: two stored actions that can write one place in the same evolution (A7).

use std::collections::BTreeMap;

use crate::analysis::{Concurrency, Logic};
use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{Effect, Expr, Model, Place, Qualifier, StepId, TransitionId, Tree};
use crate::plan::{is_stored, writes};

/// One stored action that writes a place.
struct Write<'m> {
    /// What it writes, where that is known before.
    value: Option<Tree>,
    when: When,
    conditions: Vec<&'m Expr>,
    mark: Mark,
    levels: Option<StepId>,
}

/// The change of the situation that an action belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum When {
    Entered(StepId),
    Left(StepId),
    /// An event while the step is active.
    Active(StepId),
    Cleared(TransitionId),
}

pub(super) fn check(model: &Model, concurrency: &Concurrency, sink: &mut Sink) {
    let race = Race { model, concurrency, logic: Logic::new(model) };
    for (place, writes) in collect(model) {
        for (i, first) in writes.iter().enumerate() {
            for second in &writes[i + 1..] {
                if race.can_meet(first, second) {
                    report(model, place, first, second, sink);
                }
            }
        }
    }
}

fn report(model: &Model, place: Place, first: &Write<'_>, second: &Write<'_>, sink: &mut Sink) {
    let name = model.place_name(place);
    let message = format!(
        "`{name}` is also written by another stored action in the same evolution, and which one wins is open; \
         write it in one place, or let the conditions exclude each other"
    );
    let mut scopes: Vec<&[crate::model::LevelAttr]> = Vec::new();
    for step in [first.levels, second.levels].into_iter().flatten() {
        scopes.push(&model.steps[step].levels);
    }
    scopes.push(&model.levels);
    sink.rule_in(
        model.dialect,
        &rules::WRITE_RACE,
        &scopes,
        vec![(first.mark, message.clone()), (second.mark, message)],
    );
}

/// The stored writes of each place.
fn collect(model: &Model) -> BTreeMap<Place, Vec<Write<'_>>> {
    let mut all: BTreeMap<Place, Vec<Write<'_>>> = BTreeMap::new();
    for association in model.associations.values().filter(|association| is_stored(association)) {
        let value = match (&association.effect, association.qualifier) {
            (Effect::Control(_), qualifier) => Some(Tree::Bool(qualifier == Qualifier::S)),
            (effect, _) => constant(effect),
        };
        let when = match association.qualifier {
            Qualifier::P0 => When::Left(association.step),
            Qualifier::On => When::Active(association.step),
            _ => When::Entered(association.step),
        };
        let conditions: Vec<_> = association.condition.iter().chain(&association.event).collect();
        for place in writes(&association.effect) {
            let (value, conditions) = (value.clone(), conditions.clone());
            let write = Write { value, when, conditions, mark: association.mark, levels: Some(association.step) };
            all.entry(place).or_default().push(write);
        }
    }
    for (id, transition) in model.transitions.iter() {
        for effect in &transition.clearing {
            for place in writes(effect) {
                let (value, when) = (constant(effect), When::Cleared(id));
                let write = Write { value, when, conditions: Vec::new(), mark: transition.mark, levels: None };
                all.entry(place).or_default().push(write);
            }
        }
    }
    all
}

fn constant(effect: &Effect) -> Option<Tree> {
    match effect {
        Effect::Assign(_, value) if matches!(value.tree, Tree::Bool(_) | Tree::Int(_)) => Some(value.tree.clone()),
        _ => None,
    }
}

struct Race<'m> {
    model: &'m Model,
    concurrency: &'m Concurrency,
    logic: Logic<'m>,
}

impl Race<'_> {
    /// Whether both can write in one evolution, and not just the same value.
    fn can_meet(&self, a: &Write<'_>, b: &Write<'_>) -> bool {
        if a.value.is_some() && a.value == b.value {
            return false;
        }
        match (a.when, b.when) {
            (When::Active(x), When::Active(y)) => {
                (x == y || self.concurrency.together(x, y)) && !self.exclude(a, None, b, None)
            }
            (When::Active(step), _) => self.meets_event(step, a, b),
            (_, When::Active(step)) => self.meets_event(step, b, a),
            (x, y) => {
                let (causes_x, causes_y) = (self.causes(x), self.causes(y));
                let meet = |x: TransitionId, y: TransitionId| {
                    (x == y || self.enabled_together(x, y)) && !self.exclude(a, Some(x), b, Some(y))
                };
                causes_x.iter().any(|x| causes_y.iter().any(|y| meet(*x, *y)))
            }
        }
    }

    /// Whether an action on an event and one that belongs to a transition can write in one evolution.
    fn meets_event(&self, step: StepId, event: &Write<'_>, other: &Write<'_>) -> bool {
        let causes = self.causes(other.when);
        causes.iter().any(|cause| self.active_before(*cause, step) && !self.exclude(event, None, other, Some(*cause)))
    }

    /// Whether the conditions under which both write exclude each other; all of them are read before the evolution.
    fn exclude(&self, a: &Write<'_>, by_a: Option<TransitionId>, b: &Write<'_>, by_b: Option<TransitionId>) -> bool {
        let of_actions = a.conditions.iter().chain(&b.conditions).map(|expr| self.logic.of_action(&expr.tree));
        let of_transitions = by_a.into_iter().chain(by_b).map(|id| &self.model.transitions[id].condition.tree);
        let all: Vec<_> = of_actions.chain(of_transitions.map(|tree| self.logic.condition(tree))).collect();
        let goals: Vec<_> = all.iter().map(|condition| (condition, true)).collect();
        self.logic.impossible(&goals)
    }

    /// The transitions by which a step is entered or left. What forcing orders and enclosing steps do is not among them:
    /// it follows from transitions of another partial grafcet.
    fn causes(&self, when: When) -> Vec<TransitionId> {
        let transitions = self.model.transitions.iter();
        match when {
            When::Cleared(id) => vec![id],
            When::Entered(step) | When::Active(step) => transitions
                .filter(|(_, t)| t.targets.contains(&step) && !t.sources.contains(&step))
                .map(|(id, _)| id)
                .collect(),
            When::Left(step) => transitions
                .filter(|(_, t)| t.sources.contains(&step) && !t.targets.contains(&step))
                .map(|(id, _)| id)
                .collect(),
        }
    }

    /// Whether the transition can clear while the step is active.
    fn active_before(&self, cause: TransitionId, step: StepId) -> bool {
        let sources = &self.model.transitions[cause].sources;
        sources.iter().all(|source| *source == step || self.concurrency.together(*source, step))
    }

    /// Whether the sources of two transitions can all be active together.
    fn enabled_together(&self, a: TransitionId, b: TransitionId) -> bool {
        let (first, second) = (&self.model.transitions[a], &self.model.transitions[b]);
        first.sources.iter().all(|x| second.sources.iter().all(|y| x == y || self.concurrency.together(*x, *y)))
    }
}
