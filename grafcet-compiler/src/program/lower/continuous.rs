//! The continuous actions of a `grafcet`, "once, on the stable situation" (A9, A10, A31 to A33, A35), and what makes a variable
//! combinational.

use super::Lower;
use super::view::Moment;
use crate::list::{List, PushAll};
use crate::model::{ActionId, AssociationId, Effect, Id, Place};
use crate::program::build::{all, any, choose, not, number, part, when, yes};
use crate::program::{Expr, Initial, Phase, PlaceId, Role, Statement, Type, Value};
use crate::raw::plain;

impl<'m> Lower<'_, 'm> {
    /// Whether an association is a continuous action: N, and L and D by A32.
    pub(super) fn is_continuous(&self, id: AssociationId) -> bool {
        self.model.is_grafcet() && self.model.associations[id].qualifier.is_continuous()
    }

    /// Its step is active and its condition holds. A32: `L t q` is `q if !(t/Step)`, `D t q` is `q if t/Step`.
    pub(super) fn asserts(&self, id: AssociationId) -> Expr<'m> {
        let association = &self.model.associations[id];
        let mut parts = vec![self.active(association.step, Moment::Before)];
        if let Some(time) = association.time {
            let elapsed = self.read(crate::model::Read::Elapsed(time, association.step), Moment::Before);
            parts.push(if association.qualifier.limits() { not(elapsed) } else { elapsed });
        }
        parts.push(self.condition(association.condition.as_ref(), Moment::Before));
        all(parts)
    }

    /// A33: calls come first; then the outputs, all together.
    pub(super) fn continuous(&mut self, cycle: &mut Vec<Statement<'m>>) {
        let mut calls = Vec::new();
        for (action, associations) in self.called() {
            self.continuous_call(action, &associations, &mut calls);
        }
        part(cycle, "continuous calls (A33)", calls);
        let (mut body, mut takes) = (Vec::new(), Vec::new());
        for id in self.model.outputs.ids() {
            self.continuous_output(Place::Output(id), &mut body, &mut takes);
        }
        body.push_all(takes);
        part(cycle, "continuous outputs (A9)", body);
    }

    /// The actions called continuously, where they first stand in the source.
    fn called(&self) -> Vec<(ActionId, Vec<AssociationId>)> {
        let mut called: Vec<(ActionId, Vec<AssociationId>)> = Vec::new();
        for (id, association) in self.model.associations.iter() {
            let Effect::Call(action, _) = &association.effect else { continue };
            if !self.is_continuous(id) {
                continue;
            }
            match called.iter_mut().find(|(other, _)| other == action) {
                Some((_, associations)) => associations.push(id),
                None => called.push((*action, vec![id])),
            }
        }
        called
    }

    /// "Called once per cycle with the phases first, repeated, final"; A31: with the arguments of the association that is active, the
    /// last in the source of several, the one active last for a final call.
    fn continuous_call(&mut self, action: ActionId, associations: &[AssociationId], body: &mut Vec<Statement<'m>>) {
        let model = self.model;
        let name = plain(&model.actions[action].name);
        let (first, off) = (associations[0], Initial::Value(Value::Bool(false)));
        let was = self.field(format!("was.q.{name}"), Role::Active(first), Type::Bool, off);
        let q = self.truth(format!("q.{name}"));
        let acted = (associations.len() > 1).then(|| {
            let begin = Initial::Value(Value::Int(0));
            self.field(format!("acted.{name}"), Role::Acted(first), Type::Number, begin)
        });
        body.push(Statement::Set(q, any(associations.iter().map(|id| self.asserts(*id)).list())));
        for id in associations {
            if let Some(acted) = acted {
                when(body, self.asserts(*id), vec![Statement::Set(acted, number(id.index()))]);
            }
        }
        let phase = |phase| Expr::Value(Value::Phase(phase));
        let active = choose(Expr::Place(was), phase(Phase::Repeated), phase(Phase::First));
        let phase = choose(Expr::Place(q), active, phase(Phase::Final));
        let mut arms = Vec::new();
        for id in associations {
            let Effect::Call(_, args) = &model.associations[*id].effect else { continue };
            let args = args.iter().map(|arg| self.user(arg, Moment::Before)).list();
            let call = self.call(action, phase.clone(), args);
            arms.push((vec![Value::Int(i128::try_from(id.index()).unwrap_or(i128::MAX))], call));
        }
        let run = match (acted, arms.pop()) {
            (Some(acted), Some(last)) => {
                arms.push(last);
                vec![Statement::Match(acted, arms, Vec::new())]
            }
            (None, Some((_, run))) => run,
            (_, None) => Vec::new(),
        };
        body.push(Statement::If(any(vec![Expr::Place(q), Expr::Place(was)]), run, Vec::new()));
        body.push(Statement::Set(was, Expr::Place(q)));
    }

    /// A10: the OR of its associations. A35: the value assigned while one is active, the last in the source of several, and the initial
    /// one otherwise.
    fn continuous_output(&mut self, place: Place, body: &mut Vec<Statement<'m>>, takes: &mut Vec<Statement<'m>>) {
        let model = self.model;
        let mut driving = Vec::new();
        for (id, association) in model.associations.iter() {
            if self.is_continuous(id) && association.effect.continuous_value(place).is_some() {
                driving.push(id);
            }
        }
        if driving.is_empty() {
            return;
        }
        let to = self.place(place);
        let next = self.next_copy(to);
        let asserted = |id: &AssociationId| matches!(model.associations[*id].effect, Effect::Control(_));
        if driving.iter().all(asserted) && matches!(self.places[to.0].initial, Initial::Default) {
            let value = any(driving.iter().map(|id| self.asserts(*id)).list());
            body.push(Statement::Set(next, value));
        } else {
            let mut otherwise = vec![Statement::Set(next, Expr::Initial(to))];
            for id in driving {
                let value = match &model.associations[id].effect {
                    Effect::Assign(_, value) => self.user(value, Moment::Before),
                    _ => yes(),
                };
                otherwise = vec![Statement::If(self.asserts(id), vec![Statement::Set(next, value)], otherwise)];
            }
            body.push_all(otherwise);
        }
        takes.push(Statement::Set(to, Expr::Place(next)));
    }

    /// The value that an output gets with all others.
    fn next_copy(&mut self, place: PlaceId) -> PlaceId {
        let name = format!("next.{}", self.name(place));
        self.like(name, place)
    }
}
