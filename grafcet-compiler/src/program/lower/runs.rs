//! The actions of an `sfc` run: "deactivation (P0) and final calls of the steps left, then activation (P1), then the rest, each in
//! source order, a combined target where it first stands in the source" (point 5, A29).

use super::Lower;
use super::control::{Target, What};
use super::view::Moment;
use crate::list::{List, PushAll};
use crate::model::{ActionId, AssociationId, Code, Effect, Id, Place, Qualifier, Read, Ty};
use crate::program::build::{all, any, at_least, choose, differ, no, not, number, part, when};
use crate::program::{Expr, Phase, PlaceId, Run, Statement, Value, Write};

impl<'m> Lower<'_, 'm> {
    /// Point 4 and 5.
    pub(super) fn act(&mut self, cycle: &mut Vec<Statement<'m>>) {
        let targets = self.targets();
        let (flags, body) = self.flags();
        part(cycle, "flags of the actions, read before the first runs (point 5)", body);
        let mut control = Vec::new();
        for target in &targets {
            control.push_all(self.control(target, &flags));
        }
        part(cycle, "action control (point 4)", control);
        let (mut leaving, mut entering, mut rest) = (Vec::new(), Vec::new(), Vec::new());
        for target in &targets {
            if let What::Place(place) = target.what {
                self.set(place, target, &flags, &mut rest);
            } else {
                self.run_leaving(target, &flags, &mut leaving);
                self.run_entering(target, &flags, &mut entering);
                self.run_rest(target, &flags, &mut rest);
            }
        }
        self.note_turns(&targets, &mut rest);
        for target in &targets {
            rest.push_all(target.was.map(|was| Statement::Set(was, Expr::Place(target.q))));
        }
        part(cycle, "deactivations (A29)", leaving);
        part(cycle, "activations", entering);
        part(cycle, "the rest", rest);
    }

    /// A block or an assignment that begins or ends in this cycle writes other values in the next one.
    fn note_turns(&self, targets: &[Target], into: &mut Vec<Statement<'m>>) {
        let mut turns = Vec::new();
        for target in targets {
            if let (What::Own, Some(was)) = (target.what, target.was) {
                turns.push(differ(was, target.q));
            }
        }
        if let (Some(turned), false) = (self.turned, turns.is_empty()) {
            into.push(Statement::Set(turned, any(turns)));
        }
    }

    /// "A boolean target is Q." A35: an assigned output has that value while the step is active and its initial value otherwise;
    /// where several are active, the last in the source counts.
    fn set(&mut self, place: Place, target: &Target, flags: &[PlaceId], into: &mut Vec<Statement<'m>>) {
        let model = self.model;
        let to = self.place(place);
        let assigns = |id: &&AssociationId| matches!(model.associations[**id].effect, Effect::Assign(..));
        let assigning: Vec<AssociationId> = target.associations.iter().filter(assigns).copied().list();
        let mut otherwise = vec![match place {
            Place::Output(_) if !assigning.is_empty() => Statement::Set(to, Expr::Initial(to)),
            _ => Statement::Set(to, Expr::Place(target.q)),
        }];
        for id in assigning {
            let run = self.effect(&model.associations[id].effect, Moment::After, first());
            otherwise = vec![Statement::If(Expr::Place(flags[id.index()]), run, otherwise)];
        }
        into.push_all(otherwise);
    }

    /// P0, and the final call where leaving a step has ended the action. "P0 together with a final call is one run."
    fn run_leaving(&mut self, target: &Target, flags: &[PlaceId], into: &mut Vec<Statement<'m>>) {
        let fell = target.was.map_or_else(no, |was| all(vec![Expr::Place(was), not(Expr::Place(target.q))]));
        let mut runs = Vec::new();
        for id in self.under(target, Qualifier::P0) {
            let phase = choose_phase(fell.clone(), Phase::Final);
            let run = self.effect(&self.model.associations[id].effect, Moment::Leaving, phase);
            runs.push((flags[id.index()], run));
        }
        let mut body = Vec::new();
        if let Some(by_leaving) = target.by_leaving {
            let run = self.acted(target, Moment::Leaving, Expr::Value(Value::Phase(Phase::Final)));
            when(&mut body, Expr::Place(by_leaving), run);
        }
        into.push_all(in_turn(runs, body));
    }

    /// P1. "P1 together with an active Q is one run": with the arguments of the last in the source of those that act.
    fn run_entering(&mut self, target: &Target, flags: &[PlaceId], into: &mut Vec<Statement<'m>>) {
        let mut runs = Vec::new();
        for id in self.under(target, Qualifier::P1) {
            let own = self.effect(&self.model.associations[id].effect, Moment::After, first());
            let later = match (target.acted, &self.driving(target)[..]) {
                (Some(acted), _) => at_least_number(acted, id),
                (None, [one]) => Expr::Value(Value::Bool(*one > id)),
                (None, _) => no(),
            };
            let other = self.acted(target, Moment::After, first());
            let run = match all(vec![later, Expr::Place(target.q)]) {
                Expr::Value(_) => own,
                later => vec![Statement::If(later, other, own)],
            };
            runs.push((flags[id.index()], run));
        }
        into.push_all(in_turn(runs, Vec::new()));
    }

    /// Runs while Q holds, and the final call that leaving has not caused.
    fn run_rest(&mut self, target: &Target, flags: &[PlaceId], into: &mut Vec<Statement<'m>>) {
        let Some(was) = target.was else { return };
        let none_of = |lower: &Self, qualifier| -> Vec<Expr<'m>> {
            lower.under(target, qualifier).iter().map(|id| not(Expr::Place(flags[id.index()]))).list()
        };
        let (p1, p0) = (none_of(self, Qualifier::P1), none_of(self, Qualifier::P0));
        let phase = choose_phase(Expr::Place(was), Phase::Repeated);
        let run = self.acted(target, Moment::After, phase);
        when(into, all([vec![Expr::Place(target.q)], p1].concat()), run);
        let mut ends = vec![Expr::Place(was), not(Expr::Place(target.q))];
        ends.push_all(p0);
        ends.push_all(target.by_leaving.map(|by| not(Expr::Place(by))));
        let run = self.acted(target, Moment::After, Expr::Value(Value::Phase(Phase::Final)));
        when(into, all(ends), run);
    }

    fn driving(&self, target: &Target) -> Vec<AssociationId> {
        let mut all = target.associations.clone();
        all.retain(|id| self.model.associations[*id].qualifier.drives_q());
        all
    }

    /// A run of the association that acts, or acted last.
    fn acted(&mut self, target: &Target, moment: Moment, phase: Expr<'m>) -> Vec<Statement<'m>> {
        let driving = self.driving(target);
        let (Some(acted), [_, _, ..]) = (target.acted, &driving[..]) else {
            let Some(one) = driving.first() else { return Vec::new() };
            return self.effect(&self.model.associations[*one].effect, moment, phase);
        };
        let mut arms = Vec::new();
        for id in driving {
            let run = self.effect(&self.model.associations[id].effect, moment, phase.clone());
            arms.push((vec![Value::Int(i128::try_from(id.index()).unwrap_or(i128::MAX))], run));
        }
        vec![Statement::Match(acted, arms, Vec::new())]
    }

    /// What an action does.
    fn effect(&mut self, effect: &'m Effect, moment: Moment, phase: Expr<'m>) -> Vec<Statement<'m>> {
        match effect {
            Effect::Control(_) => Vec::new(),
            Effect::Assign(place, value) => {
                let mut body = vec![Statement::Set(self.place(*place), self.user(value, moment))];
                if self.is_untold(*place) {
                    body.push_all(self.note_opaque());
                }
                body
            }
            Effect::Call(action, args) => {
                let args = args.iter().map(|arg| self.user(arg, moment)).list();
                self.call(*action, phase, args)
            }
            Effect::Block(code) => {
                let mut body = Vec::new();
                self.block(code, moment, &mut body);
                body
            }
        }
    }

    /// A block writes variables at once ("a variable written by one action is seen by the next"). An output it has read as it was in
    /// the cycle before: it writes a copy, which is taken over where it really has written it.
    fn block(&mut self, code: &'m Code, moment: Moment, into: &mut Vec<Statement<'m>>) {
        let mut writes = Vec::new();
        let mut copies = Vec::new();
        for name in &code.writes {
            match name {
                Place::Var(id) => writes.push(Write { name: *name, to: self.vars[id.index()], noted: None }),
                Place::Output(_) => {
                    let to = self.place(*name);
                    let (own, noted) = self.own_copy(to);
                    let Expr::Place(last) = self.read(Read::Name((*name).into()), moment) else { continue };
                    into.push(Statement::Set(own, Expr::Place(last)));
                    into.push(Statement::Set(noted, no()));
                    writes.push(Write { name: *name, to: own, noted: Some(noted) });
                    copies.push((own, noted, to));
                }
            }
        }
        let run = self.run_block(code, writes, moment);
        into.push_all(run);
        for (own, noted, to) in copies {
            let take = vec![Statement::Set(to, Expr::Place(own))];
            into.push(Statement::If(Expr::Place(noted), take, Vec::new()));
        }
    }

    /// The block itself.
    pub(super) fn run_block(&self, code: &'m Code, writes: Vec<Write>, moment: Moment) -> Vec<Statement<'m>> {
        let mut binds = Vec::new();
        for read in &code.reads {
            let written = writes.iter().find(|write| Read::Name(write.name.into()) == *read);
            let value = written.map_or_else(|| self.read(*read, moment), |write| Expr::Place(write.to));
            binds.push((*read, value));
        }
        let mut body = vec![Statement::Run(Box::new(Run { code, binds, writes }))];
        if self.is_opaque(code) {
            body.push_all(self.note_opaque());
        }
        body
    }

    /// Whether nobody can tell if a block leaves something to the next cycle.
    pub(super) fn is_opaque(&self, code: &Code) -> bool {
        code.statements.is_none() || code.writes.iter().any(|place| self.is_untold(*place))
    }

    /// Whether nobody can tell if the next cycle reads another value: that of a type of the user, of which `==` may not see all.
    pub(super) fn is_untold(&self, place: Place) -> bool {
        let model = self.model;
        let ty = match place {
            Place::Var(id) => &model.vars[id].ty,
            Place::Output(id) => &model.outputs[id].ty,
        };
        let is_foreign = !model.is_grafcet() && matches!(ty, Ty::Other(_)) && !ty.is_float();
        is_foreign && model.expressions().concat().contains(&Read::Name(place.into()))
    }

    /// A call of a declared action.
    pub(super) fn call(&self, action: ActionId, phase: Expr<'m>, args: Vec<Expr<'m>>) -> Vec<Statement<'m>> {
        let mut body = vec![Statement::Call(action, phase, args)];
        body.push_all(self.note_opaque());
        body
    }

    fn note_opaque(&self) -> Option<Statement<'m>> {
        self.opaque_ran.map(|ran| Statement::Set(ran, Expr::Value(Value::Bool(true))))
    }

    /// What a block writes for a place, and whether it has.
    pub(super) fn own_copy(&mut self, place: PlaceId) -> (PlaceId, PlaceId) {
        if let Some((_, own, noted)) = self.own.iter().find(|(of, ..)| *of == place) {
            return (*own, *noted);
        }
        let name = self.name(place).to_owned();
        let (own, noted) = (self.like(format!("own.{name}"), place), self.truth(format!("written.{name}")));
        self.own.push((place, own, noted));
        (own, noted)
    }

    /// Where a declared output or variable is stored.
    pub(super) fn place(&self, place: Place) -> PlaceId {
        match place {
            Place::Output(id) => self.outputs[id.index()],
            Place::Var(id) => self.vars[id.index()],
        }
    }
}

fn first<'m>() -> Expr<'m> {
    Expr::Value(Value::Phase(Phase::First))
}

/// The phase where the condition holds, else *first*.
fn choose_phase(condition: Expr<'_>, phase: Phase) -> Expr<'_> {
    choose(condition, Expr::Value(Value::Phase(phase)), first())
}

fn at_least_number<'m>(place: PlaceId, id: AssociationId) -> Expr<'m> {
    at_least(Expr::Place(place), number(id.index()))
}

/// The run of the last flag that is set; where none is, the other statements.
fn in_turn<'m>(runs: Vec<(PlaceId, Vec<Statement<'m>>)>, otherwise: Vec<Statement<'m>>) -> Vec<Statement<'m>> {
    let mut body = otherwise;
    for (flag, run) in runs {
        body = vec![Statement::If(Expr::Place(flag), run, body)];
    }
    body
}
