//! The timers of `ACTION_CONTROL`: `TON`, as far as the time of a step does not say the same.

use super::Lower;
use super::changes::limits_by_step;
use super::clocks::Clock;
use super::control::Target;
use super::view::Moment;
use crate::list::{List, PushAll};
use crate::model::{AssociationId, Id, Qualifier, TimeRef};
use crate::program::build::{add, all, any, at_least, choose, compare, less, no, not, number, when, zero};
use crate::program::{Comparison, Expr, Initial, PlaceId, Role, Statement, Type, Value};

/// The stages of a timer that has begun at a reading of the clock.
const IDLE: usize = 0;
const RUNS: usize = 1;
const OVER: usize = 2;

/// What waits for a time: whether it does, and what counts the time.
#[derive(Clone)]
pub(super) struct Timer<'m> {
    pub(super) is_waiting: Expr<'m>,
    pub(super) clock: Clock,
    pub(super) time: Expr<'m>,
}

impl<'m> Lower<'_, 'm> {
    /// `TON`: true once its input has been true for a time. "A step re-entered by A4s starts L, D and DS again."
    pub(super) fn timer(
        &mut self,
        target: &Target,
        flags: &[PlaceId],
        qualifier: Qualifier,
        input: Expr<'m>,
        body: &mut Vec<Statement<'m>>,
    ) -> Expr<'m> {
        let under = self.under(target, qualifier);
        if under.iter().all(|id| limits_by_step(self.model, self.regions, *id)) {
            let is_over = |id: &AssociationId| {
                let association = &self.model.associations[*id];
                let time = association.time.map_or_else(zero, |time| self.time_of(time));
                at_least(self.since_active(association.step, Moment::After), time)
            };
            if let [id] = &under[..] {
                return all(vec![input, is_over(id)]);
            }
            let by_step = |id: &AssociationId| all(vec![Expr::Place(flags[id.index()]), is_over(id)]);
            return any(under.iter().map(by_step).list());
        }
        let again = self.again(target, flags, qualifier);
        let time = self.timer_time(target, flags, qualifier, body);
        if under.first().is_some_and(|id| self.reads_timer(*id)) {
            self.by_reading(target, qualifier, (input, again, time), body)
        } else {
            self.by_counting(target, qualifier, (input, again, time), body)
        }
    }

    fn by_counting(
        &mut self,
        target: &Target,
        qualifier: Qualifier,
        (input, again, time): (Expr<'m>, Expr<'m>, Expr<'m>),
        body: &mut Vec<Statement<'m>>,
    ) -> Expr<'m> {
        let (first, name) = (target.associations[0], format!("{qualifier:?}_TMR.{}", target.name));
        let no_time = Initial::Value(Value::Ticks(0));
        let held = self.field(format!("{name}.held"), Role::TimerHeld(first, qualifier), Type::Ticks, no_time);
        let off = Initial::Value(Value::Bool(false));
        let was = self.field(format!("{name}.in"), Role::TimerInput(first, qualifier), Type::Bool, off);
        let Some(elapsed) = self.elapsed else { return no() };
        let goes_on = all(vec![input.clone(), Expr::Place(was), not(again)]);
        let on = add(Expr::Place(held), Expr::Place(elapsed));
        body.push(Statement::Set(held, choose(goes_on, on, zero())));
        body.push(Statement::Set(was, input));
        let is_waiting = all(vec![Expr::Place(was), less(Expr::Place(held), time.clone())]);
        self.timers.push(Timer { is_waiting, clock: Clock::Counted(held), time: time.clone() });
        all(vec![Expr::Place(was), at_least(Expr::Place(held), time)])
    }

    /// By the reading at which its input became true. Once it is over, nobody asks for that.
    fn by_reading(
        &mut self,
        target: &Target,
        qualifier: Qualifier,
        (input, again, time): (Expr<'m>, Expr<'m>, Expr<'m>),
        body: &mut Vec<Statement<'m>>,
    ) -> Expr<'m> {
        let (first, name) = (target.associations[0], format!("{qualifier:?}_TMR.{}", target.name));
        let (no_time, idle) = (Initial::Value(Value::Ticks(0)), Initial::Value(Value::Int(0)));
        let began = self.field(format!("{name}.since"), Role::TimerBegan(first, qualifier), Type::Ticks, no_time);
        let stage = self.field(format!("{name}.stage"), Role::TimerStage(first, qualifier), Type::Number, idle);
        let clock = Clock::Began(began);
        let is = |one: usize| compare(Comparison::Equal, Expr::Place(stage), number(one));
        let set = |to: Expr<'m>| Statement::Set(stage, to);
        // A time of zero is over at once (A35).
        let run = vec![clock.begin(), set(choose(at_least(zero(), time.clone()), number(OVER), number(RUNS)))];
        let is_over = all(vec![is(RUNS), at_least(clock.passed(Expr::Now), time.clone())]);
        let follow = vec![Statement::If(is_over, vec![set(number(OVER))], Vec::new())];
        let on = vec![Statement::If(any(vec![is(IDLE), again]), run, follow)];
        body.push(Statement::If(input, on, vec![set(number(IDLE))]));
        self.timers.push(Timer { is_waiting: is(RUNS), clock, time });
        is(OVER)
    }

    /// "Associations with different times share the timer of their target; it takes the time of the one active last."
    fn timer_time(
        &mut self,
        target: &Target,
        flags: &[PlaceId],
        qualifier: Qualifier,
        body: &mut Vec<Statement<'m>>,
    ) -> Expr<'m> {
        let mut times: Vec<(AssociationId, TimeRef)> = Vec::new();
        for id in self.under(target, qualifier) {
            times.push_all(self.model.associations[id].time.map(|time| (id, time)));
        }
        let Some(((_, last), others)) = times.split_last() else { return zero() };
        if others.iter().all(|(_, time)| time == last) {
            return self.time_of(*last);
        }
        let role = Role::TimerOf(target.associations[0], qualifier);
        let begin = Initial::Value(Value::Int(0));
        let of = self.field(format!("{qualifier:?}_TMR.{}.of", target.name), role, Type::Number, begin);
        for (id, _) in &times {
            when(body, Expr::Place(flags[id.index()]), vec![Statement::Set(of, number(id.index()))]);
        }
        let mut time = self.time_of(*last);
        for (id, other) in others.iter().rev() {
            let is = compare(Comparison::Equal, Expr::Place(of), number(id.index()));
            time = choose(is, self.time_of(*other), time);
        }
        time
    }

    fn again(&self, target: &Target, flags: &[PlaceId], qualifier: Qualifier) -> Expr<'m> {
        if !qualifier.restarts_with_step() {
            return no();
        }
        let mut again = Vec::new();
        for id in self.under(target, qualifier) {
            let step = self.model.associations[id].step.index();
            let both = [self.left[step], self.entered[step], flags[id.index()]];
            again.push(all(both.map(Expr::Place).to_vec()));
        }
        any(again)
    }
}
