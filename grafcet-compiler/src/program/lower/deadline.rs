//! `next_deadline`: "the reading of the clock before which nothing changes unless an input does".

use super::Lower;
use super::changes::{Change, changes};
use super::clocks::{Clock, literal};
use super::periods::phase;
use super::places::Followed;
use super::timers::Timer;
use crate::list::{List, PushAll};
use crate::model::{Blinker, Expr as Written, Qualifier, StepId};
use crate::program::build::{all, any, at_least, choose, less, not, sub, ticks};
use crate::program::{Deadline, Expr, Initial, PlaceId, Role, Type, Value, Wait};

/// With more regions, what each of them keeps takes more than the reading of the last cycle.
const FEW_REGIONS: usize = 4;

impl<'m> Lower<'_, 'm> {
    /// Of a chart that uses time.
    pub(super) fn deadline(&self) -> Option<Deadline<'m>> {
        let settled = self.settled?;
        let mut waits = Vec::new();
        let reading = self.reading?;
        for (of, change) in &changes(self.model, self.regions) {
            self.wait(*of, *change, &mut waits);
        }
        let only_readings = !self.counts_some();
        for Timer { is_waiting, clock, time } in self.timers_of_delays().into_iter().and(self.timers.iter().cloned()) {
            let (from, time) = match clock {
                Clock::Began(began) if only_readings => (began, time),
                clock => (reading, sub(time, clock.passed(Expr::Place(reading)))),
            };
            waits.push(Wait { condition: is_waiting, from, time });
        }
        let mut at_once = self.restless();
        at_once.insert(0, not(Expr::Place(settled)));
        Some(Deadline { at_once: any(at_once), reading: Expr::Place(reading), waits, late: self.late() })
    }

    /// What tells at the reading of the last cycle that a step is late.
    fn late(&self) -> Vec<(StepId, Expr<'m>)> {
        let mut late = Vec::new();
        for (id, step) in self.model.steps.iter() {
            let (Some(time), Some(clock), Some(reading)) = (step.within(), self.clock(Blinker::Step(id)), self.reading)
            else {
                continue;
            };
            late.push((id, at_least(clock.passed(Expr::Place(reading)), self.time_of(time))));
        }
        late
    }

    /// Where each cycle asks for a call that may have another value each time.
    fn restless(&self) -> Vec<Expr<'m>> {
        let model = self.model;
        let mut found = Vec::new();
        for transition in model.transitions.values() {
            if transition.condition.tree.may_differ() {
                found.push(all(transition.sources.iter().map(|step| self.is(*step)).list()));
            }
        }
        for association in model.associations.values() {
            let mut asked: Vec<&Written> = association.condition.iter().and(&association.event).list();
            if association.qualifier == Qualifier::N {
                asked.push_all(association.effect.expressions());
            }
            if asked.iter().any(|expr| expr.tree.may_differ()) {
                found.push(self.is(association.step));
            }
        }
        // Edges and delays are sampled in every cycle.
        let sampled = model.edges.values().map(|edge| &edge.of).and(model.delays.values().map(|delay| &delay.of));
        for of in sampled {
            if of.tree.may_differ() {
                found.push(Expr::Value(Value::Bool(true)));
            }
        }
        found
    }

    /// What something changes after, from the reading of the last cycle or, where that is known, from the beginning of the time.
    fn wait(&self, of: Blinker, change: Change, waits: &mut Vec<Wait<'m>>) {
        let Some(reading) = self.reading else { return };
        let mut wait = |condition: Expr<'m>, from: PlaceId, time: Expr<'m>| waits.push(Wait { condition, from, time });
        let active = match of {
            Blinker::Step(step) => self.is(step),
            Blinker::Macro(id) => any(self.model.macros[id].steps.iter().map(|step| self.is(*step)).list()),
        };
        match change {
            Change::At(_) | Change::After(_) => {
                let (Some(clock), Some(end)) = (self.clock(of), self.end_of(change)) else { return };
                if !self.counts_from_beginning() {
                    let passed = clock.passed(Expr::Place(reading));
                    wait(all(vec![active, less(passed.clone(), end.clone())]), reading, sub(end, passed));
                    return;
                }
                let is_outlasted = literal(change).is_some_and(|end| self.outlasted.contains(&(of, end)));
                let open = self.passed_of(of).filter(|_| is_outlasted).map(|passed| not(Expr::Place(passed)));
                // What takes no time is never waited for.
                if literal(change) != Some(0) {
                    wait(all([active].into_iter().and(open).list()), clock.place(), end);
                }
            }
            Change::Always => wait(active, reading, ticks(1)),
            Change::Blink(on, period) => {
                let until =
                    |phase: Expr<'m>| sub(choose(less(phase.clone(), ticks(on)), ticks(on), ticks(period)), phase);
                let Some(clock) = self.clock_of_periods(of) else {
                    let role = self.phase_role(crate::model::Blink { of, on, off: period.saturating_sub(on) });
                    let Some(phases) = self.phases.iter().find(|phases| phases.role == role) else { return };
                    wait(active, reading, until(Expr::Place(phases.phase)));
                    return;
                };
                if !self.counts_from_beginning() {
                    wait(active, reading, until(phase(clock.passed(Expr::Place(reading)), period)));
                    return;
                }
                let first = self.passed_of(of).map(|passed| not(Expr::Place(passed)));
                wait(all([active.clone()].into_iter().and(first).list()), clock.place(), ticks(on));
                wait(active, clock.place(), ticks(period));
            }
        }
    }

    fn clock_of_periods(&self, of: Blinker) -> Option<Clock> {
        let Blinker::Step(step) = of else { return None };
        self.periods_of(step).and_then(|_| self.clock(of))
    }

    /// Whether some time is counted. Such a time can end more than 2^31 ticks after the last cycle, where it cannot be compared with a reading, so all are told from that
    /// cycle then.
    fn counts_some(&self) -> bool {
        let is_counted = |clock: &Clock| matches!(clock, Clock::Counted(_));
        self.time.iter().and(&self.macro_time).flatten().any(is_counted)
            || self.delays.iter().any(|delay| matches!(delay.followed, Followed::Counted { .. }))
            || self.timers.iter().any(|timer| is_counted(&timer.clock))
            || !self.phases.is_empty()
    }

    /// Whether all that is waited for counts from the beginning of a step's time, so that nobody asks for the reading of the last cycle: with one region, and with
    /// few. Of each step one time at most can be over while it stays active.
    fn counts_from_beginning(&self) -> bool {
        let others = self.counts_some() || self.macro_time.iter().any(Option::is_some);
        let mut steps = Vec::new();
        for (of, _) in &self.outlasted {
            steps.push(*of);
        }
        let twice = steps.windows(2).any(|two| two[0] == two[1]);
        let few = match self.state.len() {
            1 => self.time[0].is_some(),
            regions => !self.model.forceable && regions <= FEW_REGIONS && self.late().is_empty(),
        };
        few && !others && !twice && self.periods.iter().all(|periods| periods.only().is_some())
    }

    /// Whether a time of the active step of a region is over has to be remembered where the reading of the last cycle does not tell.
    pub(super) fn remember_passed(&mut self) {
        self.passed = vec![None; self.state.len()];
        if self.settled.is_none() || !self.counts_from_beginning() {
            return;
        }
        for region in 0..self.state.len() {
            let is_outlasted = self.outlasted.iter().any(|(of, _)| self.region_of(*of) == Some(region));
            if is_outlasted {
                let name = if self.state.len() == 1 { "passed".to_owned() } else { self.region_name("passed", region) };
                let no = Initial::Value(Value::Bool(false));
                self.passed[region] = Some(self.field(name, Role::Passed(region), Type::Bool, no));
            }
        }
    }

    fn passed_of(&self, of: Blinker) -> Option<PlaceId> {
        self.region_of(of).and_then(|region| self.passed[region])
    }

    pub(super) fn region_of(&self, of: Blinker) -> Option<usize> {
        match of {
            Blinker::Step(step) => Some(self.regions.of_step(step)),
            Blinker::Macro(_) => None,
        }
    }
}
