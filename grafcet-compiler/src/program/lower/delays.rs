//! The delays of conditions (A36): "`t1/e/t2` becomes true once `e` has been true for t1 and false once `e` has been false for t2."

use super::Lower;
use super::clocks::Clock;
use super::places::Followed;
use super::timers::Timer;
use super::view::Moment;
use crate::model::{Delay, DelayId, TimeRef};
use crate::program::build::{add, all, at_least, choose, compare, not, number, zero};
use crate::program::{Comparison, Expr, PlaceId, Statement};

/// The stages of a delay that is followed by readings of the clock: what it says, and whether it waits to say the other.
const OFF: usize = 0;
const WAITS_FOR_ON: usize = 1;
const ON: usize = 2;
const WAITS_FOR_OFF: usize = 3;

impl<'m> Lower<'_, 'm> {
    /// What a delay says.
    pub(super) fn delayed(&self, id: DelayId) -> Expr<'m> {
        let delay = &self.model.delays[id];
        match self.delay(id).followed {
            Followed::Counted { output, .. } => Expr::Place(output),
            Followed::Read { stage, .. } if is_zero(delay.off) => is(stage, ON),
            Followed::Read { stage, .. } if is_zero(delay.on) => not(is(stage, OFF)),
            Followed::Read { stage, .. } => at_least(Expr::Place(stage), number(ON)),
        }
    }

    /// One cycle of it.
    pub(super) fn sample_delay(&self, id: DelayId) -> Vec<Statement<'m>> {
        let (delay, places) = (&self.model.delays[id], self.delay(id));
        let now = Expr::Place(places.now);
        let set = Statement::Set(places.now, self.user(&delay.of, Moment::Before));
        let (input, held, output) = match places.followed {
            Followed::Read { stage, began } => {
                let [on, off] = self.stages(delay, stage, began);
                return vec![set, Statement::If(now, on, off)];
            }
            Followed::Counted { input, held, output } => (input, held, output),
        };
        let Some(elapsed) = self.elapsed else { return Vec::new() };
        let same = compare(Comparison::Equal, now.clone(), Expr::Place(input));
        let time = choose(now.clone(), self.time_of(delay.on), self.time_of(delay.off));
        vec![
            set,
            Statement::Set(held, choose(same, add(Expr::Place(held), Expr::Place(elapsed)), zero())),
            Statement::Set(input, now.clone()),
            Statement::If(at_least(Expr::Place(held), time), vec![Statement::Set(output, now)], Vec::new()),
        ]
    }

    /// The same while its expression is true, and while it is false.
    fn stages(&self, delay: &Delay, stage: PlaceId, began: PlaceId) -> [Vec<Statement<'m>>; 2] {
        let clock = Clock::Began(began);
        let set = |to: usize| vec![Statement::Set(stage, number(to))];
        let follow = |from: usize, waits: usize, to: usize, back: usize, (time, other): (TimeRef, TimeRef)| {
            if is_zero(time) {
                return set(to);
            }
            let is_over = all(vec![is(stage, waits), at_least(clock.passed(Expr::Now), self.time_of(time))]);
            let go_on = vec![Statement::If(is_over, set(to), Vec::new())];
            let wait = [vec![clock.begin()], set(waits)].concat();
            let mut follow = vec![Statement::If(is(stage, from), wait, go_on)];
            if !is_zero(other) {
                follow = vec![Statement::If(is(stage, back), set(to), follow)];
            }
            follow
        };
        [
            follow(OFF, WAITS_FOR_ON, ON, WAITS_FOR_OFF, (delay.on, delay.off)),
            follow(ON, WAITS_FOR_OFF, OFF, WAITS_FOR_ON, (delay.off, delay.on)),
        ]
    }

    /// What delays wait for.
    pub(super) fn timers_of_delays(&self) -> Vec<Timer<'m>> {
        let mut all = Vec::new();
        for (id, delay) in self.model.delays.iter() {
            let (on, off) = (self.time_of(delay.on), self.time_of(delay.off));
            match self.delay(id).followed {
                Followed::Counted { input, held, output } => {
                    let is_waiting = compare(Comparison::Differs, Expr::Place(input), Expr::Place(output));
                    let time = choose(Expr::Place(input), on, off);
                    all.push(Timer { is_waiting, clock: Clock::Counted(held), time });
                }
                Followed::Read { stage, began } => {
                    for (waits, written, time) in [(WAITS_FOR_ON, delay.on, on), (WAITS_FOR_OFF, delay.off, off)] {
                        if !is_zero(written) {
                            all.push(Timer { is_waiting: is(stage, waits), clock: Clock::Began(began), time });
                        }
                    }
                }
            }
        }
        all
    }
}

fn is<'m>(stage: PlaceId, one: usize) -> Expr<'m> {
    compare(Comparison::Equal, Expr::Place(stage), number(one))
}

fn is_zero(time: TimeRef) -> bool {
    matches!(time, TimeRef::Ticks(0))
}
