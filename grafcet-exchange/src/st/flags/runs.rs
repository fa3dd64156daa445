//! What runs: assignments, blocks and calls, each in its place of the scan.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::analysis::combinational::in_order;
use grafcet_compiler::model::{Association, Effect, Model, Name, Place, Qualifier, Read};

use super::Flags;
use super::remembers::Asked;
use crate::Refused;
use crate::st::action::{Phase, Role, Written, places, role, run};
use crate::st::expr::{At, Kind, Moment, plain};
use crate::st::memory::in_a_row;
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, any, not};

impl Flags<'_> {
    /// All actions in their order: those of a `grafcet` that are done at an instant, and the rest; those of an `sfc`, what ends with its step, what
    /// begins, the rest.
    pub(super) fn actions(&mut self, written: &BTreeMap<Place, Written>) -> Result<[Vec<Statement>; 2], Refused> {
        if self.model.is_grafcet() { self.of_grafcet(written) } else { self.of_sfc().map(|all| [Vec::new(), all]) }
    }

    fn of_sfc(&mut self) -> Result<Vec<Statement>, Refused> {
        let model = self.model;
        let (mut left, mut entered, mut rest) = (Vec::new(), Vec::new(), Vec::new());
        let mut controlled = BTreeSet::new();
        for (id, association) in model.associations.iter() {
            if let Some((action, all_of)) = self.called_together(association) {
                // Where the action first stands.
                if all_of[0] == id {
                    self.of_action(action, &all_of, [&mut left, &mut entered, &mut rest])?;
                }
                continue;
            }
            match role(model, association)? {
                Role::Continuous(place) | Role::Set(place) | Role::Reset(place) => {
                    if controlled.insert(place) {
                        rest.extend(self.control(place)?);
                    }
                }
                Role::Deactivation => {
                    let event = self.deactivated(association.step);
                    left.push(self.once(association, event)?);
                }
                Role::Activation => {
                    let event = self.activated(association.step);
                    entered.push(self.once(association, event)?);
                }
                Role::Body => self.body(association, &mut left, &mut rest)?,
                Role::Event | Role::Nothing => {}
            }
        }
        let conditions = std::mem::take(&mut self.conditions);
        Ok(conditions.into_iter().chain(left).chain(entered).chain(rest).collect())
    }

    /// P1 and P0.
    fn once(&mut self, association: &Association, event: Text) -> Result<Statement, Refused> {
        let leaves = association.qualifier == Qualifier::P0;
        let moment = if leaves { Moment::Leaving } else { Moment::Moved(Some(association.step)) };
        let mut parts = vec![event];
        if let Some(condition) = &association.condition {
            let text = self.instant(moment, association.mark, |scope, at| scope.expr(condition, &Kind::Bool, at))?;
            parts.push(self.hoisted(text, association));
        }
        let done =
            self.instant(moment, association.mark, |scope, at| run(scope, &association.effect, Phase::First, at))?;
        Ok(Statement::when(all(parts).text, done))
    }

    /// A condition that reads what actions write is read before them; a `grafcet` has copies of what was there before.
    pub(super) fn hoisted(&mut self, condition: Text, association: &Association) -> Text {
        let reads = association.condition.iter().any(|condition| !places(&condition.tree).is_empty());
        if !reads || self.model.is_grafcet() {
            return condition;
        }
        let name = self.local("If_1");
        self.conditions.push(Statement::assign(&*name, condition.text));
        Text::word(name)
    }

    /// What runs: in each scan in which it is driven, and once more after that.
    fn body(
        &mut self,
        association: &Association,
        left: &mut Vec<Statement>,
        rest: &mut Vec<Statement>,
    ) -> Result<(), Refused> {
        let (runs, left_or_not) = self.driven(association)?;
        let ran = self.scope.names.own("Ran_1");
        self.frame.remember(Variable::new(&*ran, "BOOL").init("FALSE").note("it ran in the scan before"));
        let stable = self.model.is_grafcet();
        let mut phase = |phase, leaves: bool| {
            // A call of a `grafcet` sees what the evolution has led to.
            let nothing = BTreeMap::new();
            let sees = |scope: &mut _, at: &At<'_>| {
                let before = if stable { &nothing } else { at.before };
                run(scope, &association.effect, phase, &At { before, ..*at })
            };
            // Where the step is left its time is the one that it had reached.
            if leaves && !self.model.is_grafcet() {
                return self.instant(Moment::Leaving, association.mark, sees);
            }
            self.after(association, sees)
        };
        let [first, repeated, last] =
            [phase(Phase::First, false)?, phase(Phase::Repeated, false)?, phase(Phase::Final, false)?];
        // It ends with its step, or else among the rest.
        let mut ends = Some(vec![Text::word(&*ran)]);
        if let Some([is_left, stays]) = left_or_not {
            let mut over = vec![Text::word(&*ran), is_left];
            if association.qualifier == Qualifier::D {
                over.push(not(Text::word(&*runs)));
            }
            left.push(Statement::when(all(over).text, phase(Phase::Final, true)?));
            // Of N and D the condition alone ends it while the step is active.
            let alone = association.condition.is_some() || association.qualifier == Qualifier::L;
            ends = alone.then(|| vec![Text::word(&*ran), stays]);
        }
        let now = if first == repeated { first } else { vec![Statement::If(vec![(ran.clone(), repeated)], first)] };
        let mut branches = vec![(runs.clone(), now)];
        branches.extend(ends.filter(|_| may_end(association.qualifier)).map(|ends| (all(ends).text, last)));
        rest.push(Statement::If(branches, Vec::new()));
        rest.push(Statement::assign(ran, runs));
        Ok(())
    }

    /// What drives what runs; of what ends with its step, that this is left and that it is not.
    fn driven(&mut self, association: &Association) -> Result<(String, Option<[Text; 2]>), Refused> {
        let (flag, qualifier) = (self.flag(association.step), association.qualifier);
        let with_step = Some([not(flag.clone()), flag]);
        if qualifier == Qualifier::N {
            let input = self.input(association)?;
            return Ok((self.hoisted(input, association).text, with_step));
        }
        // Its action control is one of its own, asked before the first action runs.
        let name = self.stored("Q_1");
        let asked = self.controlled(name.clone(), &[association])?;
        self.conditions.extend(asked);
        let left_or_not = match qualifier {
            // A delay begins anew with a step that is entered anew.
            Qualifier::D if self.may_reenter(association.step) => {
                let is_left = self.deactivated(association.step);
                Some([is_left.clone(), not(is_left)])
            }
            qualifier if qualifier.is_continuous() => with_step,
            _ => None,
        };
        Ok((name, left_or_not))
    }

    /// A place that steps alone set and reset, one at a time: what happens on activation lasts as long as the step does.
    fn is_flip_flop(&self, place: Place, written: &BTreeMap<Place, Written>) -> bool {
        let bare =
            super::control::controls(self.model, place).iter().all(|association| association.condition.is_none());
        self.single && bare && !written[&place].otherwise
    }

    fn of_grafcet(&mut self, written: &BTreeMap<Place, Written>) -> Result<[Vec<Statement>; 2], Refused> {
        let model = self.model;
        let (mut stored, mut rest, mut calls) = (Vec::new(), in_a_row(self.following()?), Vec::new());
        let mut continuous: BTreeSet<Place> = in_order(model).into_iter().map(Place::Var).collect();
        for association in model.associations.values() {
            let role = role(model, association)?;
            match role {
                Role::Continuous(place) => {
                    if continuous.insert(place) {
                        rest.extend(self.control(place)?);
                    }
                }
                Role::Body if calls_together(model, association).len() > 1 => {
                    let together = calls_together(model, association);
                    // Where the action first stands.
                    if std::ptr::eq(together[0], association) {
                        calls.extend(self.together(&together)?);
                    }
                }
                Role::Body => {
                    let (mut left, mut now) = (Vec::new(), Vec::new());
                    self.body(association, &mut left, &mut now)?;
                    calls.extend(left.into_iter().chain(now));
                }
                Role::Nothing => {}
                Role::Event => stored.push(self.event(association)?),
                Role::Activation | Role::Deactivation => {
                    let event = if role == Role::Activation {
                        self.activated(association.step)
                    } else {
                        self.deactivated(association.step)
                    };
                    stored.push(self.once(association, event)?);
                }
                Role::Set(place) | Role::Reset(place) if self.is_flip_flop(place, written) => {
                    if continuous.insert(place) {
                        rest.extend(self.control(place)?);
                    }
                }
                Role::Set(place) | Role::Reset(place) => {
                    let mut parts = vec![self.activated(association.step)];
                    if let Some(condition) = &association.condition {
                        parts.push(self.instant(Moment::Called, association.mark, |scope, at| {
                            scope.expr(condition, &Kind::Bool, at)
                        })?);
                    }
                    let value = if association.qualifier == Qualifier::S { "TRUE" } else { "FALSE" };
                    stored.push(Statement::when(
                        all(parts).text,
                        vec![Statement::assign(self.scope.place(place), value)],
                    ));
                }
            }
        }
        stored.extend(self.clearing()?);
        rest.extend(calls);
        Ok([stored, rest])
    }

    /// One continuous call of an action by several associations: the last in the source of those that are active gives the arguments, and at the end
    /// the one that was active last.
    fn together(&mut self, all_of: &[&Association]) -> Result<Vec<Statement>, Refused> {
        let mut inputs = Vec::new();
        for association in all_of {
            inputs.push(self.input(association)?);
        }
        let Effect::Call(action, _) = all_of[0].effect else { return Ok(Vec::new()) };
        let name = plain(&self.model.actions[action].name);
        let [phase, by] = ["phase", "by"].map(|what| self.scope.names.own(&format!("{name}_{what}")));
        self.frame.variables.push(Variable::new(&*phase, "INT").note("0 first, 1 repeated, 2 final"));
        let (runs, ran) = (self.local("Q_1"), self.stored("Ran_1"));
        let mut calls = Vec::new();
        for association in all_of {
            let Effect::Call(_, arguments) = &association.effect else { continue };
            let told =
                (format!("phase := {phase}"), Variable::new("phase", "INT").note("0 first, 1 repeated, 2 final"));
            calls.push(self.after(association, |scope, at| {
                scope.call(action, arguments, told, &At { before: &BTreeMap::new(), ..*at })
            })?);
        }
        let [on, before] = [&runs, &ran].map(|name| Text::word(&**name));
        let mut done = vec![Statement::assign(&*runs, any(inputs.clone()).text)];
        let begins = all(vec![on.clone(), not(before.clone())]).text;
        let told = |number: &str| vec![Statement::assign(&*phase, number)];
        done.push(Statement::If(vec![(begins, told("0")), (runs.clone(), told("1"))], told("2")));
        let call = if calls.iter().all(|call| *call == calls[0]) {
            calls.swap_remove(0)
        } else {
            self.frame.remember(Variable::new(&*by, "INT").init("0").note("whose call it is"));
            let by_number = |number: usize| vec![Statement::assign(&*by, number.to_string())];
            let numbers = inputs.into_iter().enumerate().rev();
            done.push(Statement::If(
                numbers.map(|(number, input)| (input.text, by_number(number))).collect(),
                Vec::new(),
            ));
            let branches = calls.into_iter().enumerate();
            Statement::If(branches.map(|(number, call)| (format!("{by} = {number}"), vec![call])).collect(), Vec::new())
        };
        done.push(Statement::when(any(vec![on, before]).text, vec![call]));
        done.push(Statement::assign(ran, runs));
        Ok(done)
    }

    /// What transitions do when they clear, after what steps do in the same evolution.
    fn clearing(&mut self) -> Result<Vec<Statement>, Refused> {
        let model = self.model;
        let mut stored = Vec::new();
        for (id, transition) in model.transitions.iter() {
            if transition.any.is_some_and(|any| model.anys[any].first != id) {
                continue;
            }
            let mut done = Vec::new();
            for effect in &transition.clearing {
                done.extend(
                    self.instant(Moment::Called, transition.mark, |scope, at| run(scope, effect, Phase::First, at))?,
                );
            }
            if !done.is_empty() {
                // An `any` clears as a whole.
                let same = |other: &(_, &grafcet_compiler::model::Transition)| {
                    other.1.any.is_some() && other.1.any == transition.any
                };
                let mut all: Vec<Text> =
                    model.transitions.iter().filter(same).map(|(id, _)| self.transition(id)).collect();
                if all.is_empty() {
                    all.push(self.transition(id));
                }
                stored.push(Statement::when(any(all).text, done));
            }
        }
        Ok(stored)
    }

    /// What follows the situation, each after what it reads: asked by transitions on the situation before the evolution, and by continuous actions on
    /// that after it.
    pub(super) fn following(&mut self) -> Result<Vec<Asked>, Refused> {
        let mut following = Vec::new();
        for var in in_order(self.model) {
            following.push((Read::Name(Name::Var(var)), self.control(Place::Var(var))?));
        }
        Ok(following)
    }

    /// An action on an event runs if its step was active before the evolution.
    fn event(&mut self, association: &Association) -> Result<Statement, Refused> {
        // In the first scan no edge is seen, and an event asks for one.
        let mut parts = vec![if self.is_moved(association.step) {
            self.was(association.step)
        } else {
            // It is active before if it is now and has not been activated, or has been deactivated.
            let flag = self.flag(association.step);
            let was = all(vec![flag, not(self.activated(association.step))]);
            any(vec![was, self.deactivated(association.step)])
        }];
        for condition in association.event.iter().chain(&association.condition) {
            parts.push(
                self.instant(Moment::Called, association.mark, |scope, at| scope.expr(condition, &Kind::Bool, at))?,
            );
        }
        let done = self
            .instant(Moment::Called, association.mark, |scope, at| run(scope, &association.effect, Phase::First, at))?;
        Ok(Statement::when(all(parts).text, done))
    }
}

/// What is stored and not limited goes on for ever: nothing resets what runs.
fn may_end(qualifier: Qualifier) -> bool {
    !qualifier.has_flip_flop() || qualifier.limits()
}

/// The continuous calls of one action, in source order.
fn calls_together<'m>(model: &'m Model, association: &Association) -> Vec<&'m Association> {
    let Effect::Call(action, _) = association.effect else { return Vec::new() };
    let same = |other: &&Association| {
        other.qualifier == Qualifier::N && matches!(other.effect, Effect::Call(other, _) if other == action)
    };
    model.associations.values().filter(same).collect()
}
