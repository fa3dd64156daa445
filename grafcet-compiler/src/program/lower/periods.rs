//! What blinks by the reading of the clock at which its step became active. That is moved on by whole periods, so that it never wraps; what
//! else asks for the time finds as many periods as it needs.
//!
//! ```text
//! passed:   0 ──── first ──── first + period
//!                    └─────────────┘   here it stays, however long the step is active
//! ```

use super::changes::{Change, Changes};
use super::clocks::{Clock, HIGHEST, literal};
use super::{Clocks, Lower};
use crate::model::{Blink, Blinker, StepId};
use crate::program::build::{add, all, less, not, ticks, when, zero};
use crate::program::{Expr, Statement};

/// At most so many periods are looked through for the present one: where there is no division, each time they double is a round.
const MOST: u32 = 16;

/// The periods of a step that blinks, in ticks.
#[derive(Clone, Copy)]
pub(super) struct Periods {
    step: StepId,
    /// What all of them divide.
    period: u32,
    /// Whole periods, at the end of which no other time of the step is still to come.
    first: u32,
    /// The first part of the period, where nothing else is asked of the time.
    only: Option<u32>,
}

impl<'m> Lower<'_, 'm> {
    /// Notes the periods of a step whose time tells how far they are. Whether it does.
    pub(super) fn note_periods(&mut self, step: StepId, changes: &Changes) -> bool {
        if self.periods_of(step).is_none() && self.clocks == Clocks::Read {
            self.periods.extend(Periods::of(step, changes));
        }
        self.periods_of(step).is_some()
    }

    pub(super) fn periods_of(&self, step: StepId) -> Option<Periods> {
        self.periods.iter().find(|periods| periods.step == step).copied()
    }

    /// What goes on beyond its first periods is moved on by whole ones.
    pub(super) fn move_periods(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for periods in &self.periods {
            let of = Blinker::Step(periods.step);
            let Some(clock) = self.clock(of) else { continue };
            let phase = phase(clock.passed(Expr::Now), periods.period);
            let left = if periods.first == 0 { phase } else { add(ticks(periods.first), phase) };
            let anew = match clock {
                Clock::Began(_) => Expr::Since(Box::new(Expr::Now), Box::new(left)),
                Clock::Counted(_) => left,
            };
            let end = periods.first + periods.period;
            when(&mut body, self.is_over(of, end), vec![Statement::Set(clock.place(), anew)]);
        }
        body
    }

    /// Whether a step of which nothing but that is asked is in the second part of its period.
    pub(super) fn second_part(&self, of: Blinker, on: u32) -> Option<Expr<'m>> {
        let Blinker::Step(step) = of else { return None };
        let (periods, clock) = (self.periods_of(step).filter(|periods| periods.only == Some(on))?, self.clock(of)?);
        let is_on = less(phase(clock.passed(Expr::Now), periods.period), ticks(on));
        Some(all(vec![self.is(step), not(is_on)]))
    }
}

impl Periods {
    /// None where there are too many of them to look through, or something else is asked of the time than how it compares with literals.
    fn of(step: StepId, changes: &Changes) -> Option<Self> {
        let (mut longest, mut blinks) = (0, Vec::new());
        for (_, change) in changes.iter().filter(|(of, _)| *of == Blinker::Step(step)) {
            match change {
                Change::Blink(on, period) => blinks.push((*on, *period)),
                other => longest = literal(*other)?.max(longest),
            }
        }
        let shortest = blinks.iter().map(|(_, period)| *period).min()?;
        let mut period = 1;
        for (_, other) in &blinks {
            period = multiple(period, *other)?;
        }
        let first = longest.div_ceil(period).checked_mul(period)?;
        let end = first.checked_add(period)?;
        let only = blinks.first().filter(|_| blinks.len() == 1 && first == 0).map(|(on, _)| *on);
        (end <= HIGHEST && end / shortest <= MOST).then_some(Self { step, period, first, only })
    }

    /// The first part of its period, where nothing else is asked of the time.
    pub(super) fn only(self) -> Option<(Blinker, u32)> {
        self.only.map(|on| (Blinker::Step(self.step), on))
    }
}

/// What has passed of the present period.
pub(super) fn phase(passed: Expr<'_>, period: u32) -> Expr<'_> {
    Expr::Period(Box::new(zero()), Box::new(passed), period)
}

/// Whether a time is in the first part of a period.
pub(super) fn is_on(passed: Expr<'_>, blink: Blink) -> Expr<'_> {
    less(phase(passed, blink.period()), ticks(blink.on))
}

/// The least that both divide.
fn multiple(one: u32, other: u32) -> Option<u32> {
    let (mut divisor, mut rest) = (one, other);
    while rest != 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    (one / divisor).checked_mul(other)
}
