//! The stored actions of a `grafcet`: "conditions and right-hand sides see the values from before the evolution; all stored actions of
//! one evolution are committed together" (A5, A6, A12, A33, A36).

use super::Lower;
use super::view::Moment;
use crate::list::{List, PushAll};
use crate::model::{Association, Code, Dialect, Effect, Id, Place, Qualifier, Trigger};
use crate::program::build::{all, no, not, when, yes};
use crate::program::{Expr, Phase, PlaceId, Statement, Value, Write};
use crate::sorted::Set;

/// Where the stored actions of one evolution write.
pub(super) struct Stored<'m> {
    /// A place, and the value that it gets with all others.
    pub(super) next: Vec<(PlaceId, PlaceId)>,
    /// The calls that are due in this evolution: whether, and with what.
    pub(super) due: Vec<PlaceId>,
    calls: Vec<Statement<'m>>,
}

impl<'m> Lower<'_, 'm> {
    /// The places that stored actions write.
    pub(super) fn stored_places(&mut self) -> Stored<'m> {
        let model = self.model;
        let mut written: Set<Place> = Set::new();
        for association in model.associations.values().filter(|association| association.is_stored()) {
            written.extend(association.effect.writes().iter().copied());
        }
        for transition in model.transitions.values() {
            for effect in &transition.clearing {
                written.extend(effect.writes().iter().copied());
            }
        }
        let mut next = Vec::new();
        for place in &written {
            let place = self.place(*place);
            let name = format!("next.{}", self.name(place));
            next.push((place, self.like(name, place)));
        }
        Stored { next, due: Vec::new(), calls: Vec::new() }
    }

    /// What the stored actions write, and the calls after them; all in source order, those of transitions last.
    pub(super) fn stored_actions(&mut self, stored: &mut Stored<'m>) -> (Vec<Statement<'m>>, Vec<Statement<'m>>) {
        let model = self.model;
        let mut body = begin(stored);
        for (_, association) in model.associations.iter() {
            let occurs = self.occurs(association, Moment::Before);
            self.stored_action(association, occurs, Moment::Before, stored, &mut body);
        }
        for (id, transition) in model.transitions.iter() {
            // What an `any` does is done once, whatever it leaves.
            let cleared = match transition.any {
                Some(any) if model.anys[any].first == id => self.any_cleared(any),
                Some(_) => continue,
                None => Expr::Place(self.clears[id.index()]),
            };
            for effect in &transition.clearing {
                self.perform(effect, cleared.clone(), Moment::Before, stored, &mut body);
            }
        }
        (body, std::mem::take(&mut stored.calls))
    }

    /// A37: "the activation of the initial situation is an evolution of its own". Before it no step is active.
    pub(super) fn activate(&mut self, stored: &mut Stored<'m>) -> Vec<Statement<'m>> {
        let model = self.model;
        let mut body = Vec::new();
        for (_, association) in model.associations.iter() {
            let occurs = self.occurs(association, Moment::Start);
            self.stored_action(association, occurs, Moment::Start, stored, &mut body);
        }
        if body.is_empty() {
            return body;
        }
        body.splice(0..0, begin(stored));
        body.append(&mut stored.calls);
        body.push_all(stored.next.iter().map(|(place, next)| Statement::Set(*place, Expr::Place(*next))));
        stored.due.clear();
        body
    }

    /// Whether the event of a stored action occurs. A12: forcing raises the same events.
    fn occurs(&self, association: &'m Association, moment: Moment) -> Expr<'m> {
        let (was, is) = (self.active(association.step, moment), self.is(association.step));
        // At the start the situation is known.
        let is = match moment {
            Moment::Start if self.initial.contains(&association.step) => yes(),
            Moment::Start => no(),
            _ => is,
        };
        match (association.qualifier.trigger(Dialect::Grafcet), &association.event) {
            (Trigger::Activation, _) => all(vec![not(was), is]),
            (Trigger::Deactivation, _) => all(vec![was, not(is)]),
            // A36: an action on event runs if its step was active before the evolution.
            (Trigger::Event, Some(event)) => all(vec![was, self.user(event, moment)]),
            (Trigger::Event | Trigger::Active, _) => no(),
        }
    }

    fn stored_action(
        &mut self,
        association: &'m Association,
        occurs: Expr<'m>,
        moment: Moment,
        stored: &mut Stored<'m>,
        body: &mut Vec<Statement<'m>>,
    ) {
        let occurs = all(vec![occurs, self.condition(association.condition.as_ref(), moment)]);
        match (association.qualifier, &association.effect) {
            (qualifier, Effect::Control(place)) if qualifier.sets_or_resets() => {
                let value = Expr::Value(Value::Bool(association.qualifier == Qualifier::S));
                let next = self.next_of(*place, stored);
                when(body, occurs, vec![Statement::Set(next, value)]);
            }
            (_, effect) => self.perform(effect, occurs, moment, stored, body),
        }
    }

    fn perform(
        &mut self,
        effect: &'m Effect,
        occurs: Expr<'m>,
        moment: Moment,
        stored: &mut Stored<'m>,
        body: &mut Vec<Statement<'m>>,
    ) {
        if matches!(occurs, Expr::Value(Value::Bool(false))) {
            return;
        }
        match effect {
            Effect::Control(_) => {}
            Effect::Assign(place, value) => {
                let next = self.next_of(*place, stored);
                when(body, occurs, vec![Statement::Set(next, self.user(value, moment))]);
            }
            Effect::Call(action, args) => {
                let due = self.truth(format!("due{}.{}", self.places.len(), self.model.actions[*action].name));
                body.push(Statement::Set(due, occurs));
                let args = args.iter().map(|arg| self.user(arg, moment)).list();
                let call = self.call(*action, Expr::Value(Value::Phase(Phase::First)), args);
                stored.calls.push(Statement::If(Expr::Place(due), call, Vec::new()));
                stored.due.push(due);
            }
            Effect::Block(code) => {
                let block = self.stored_block(code, moment, stored);
                when(body, occurs, block);
            }
        }
    }

    /// A33: "a block sees its own writes and otherwise the values from before the evolution".
    fn stored_block(&mut self, code: &'m Code, moment: Moment, stored: &Stored<'m>) -> Vec<Statement<'m>> {
        let (mut body, mut writes, mut takes) = (Vec::new(), Vec::new(), Vec::new());
        for name in &code.writes {
            let place = self.place(*name);
            let (own, noted) = self.own_copy(place);
            body.push(Statement::Set(own, Expr::Place(place)));
            body.push(Statement::Set(noted, no()));
            let take = vec![Statement::Set(self.next_of(*name, stored), Expr::Place(own))];
            takes.push(Statement::If(Expr::Place(noted), take, Vec::new()));
            writes.push(Write { name: *name, to: own, noted: Some(noted) });
        }
        body.push_all(self.run_block(code, writes, moment));
        body.push_all(takes);
        body
    }

    /// Where a place gets its next value.
    fn next_of(&self, place: Place, stored: &Stored<'m>) -> PlaceId {
        let place = self.place(place);
        stored.next.iter().find(|(of, _)| *of == place).map_or(place, |(_, next)| *next)
    }
}

/// Each place keeps its value where nothing writes it.
fn begin<'m>(stored: &Stored<'m>) -> Vec<Statement<'m>> {
    stored.next.iter().map(|(place, next)| Statement::Set(*next, Expr::Place(*place))).list()
}
