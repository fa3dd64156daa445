//! "The elapsed time since the previous cycle is a wrapping difference; step times add it up and saturate, or are the reading of the clock at
//! which they began. The first cycle has no elapsed time."

use super::Lower;
use super::clocks::Clock;
use super::view::Moment;
use crate::list::{List, PushAll};
use crate::model::{Blinker, Id, MacroId};
use crate::program::build::{add, all, any, at_least, choose, differ, no, not, ticks, when, zero};
use crate::program::{Expr, Role, Statement};

impl<'m> Lower<'_, 'm> {
    /// Time passes.
    pub(super) fn pass_time(&self) -> Vec<Statement<'m>> {
        let Some(reading) = self.reading else { return Vec::new() };
        let mut body = Vec::new();
        if let Some(elapsed) = self.elapsed {
            let since = Expr::Since(Box::new(Expr::Now), Box::new(Expr::Place(reading)));
            body.push(Statement::Set(elapsed, choose(Expr::Place(self.first), zero(), since)));
        }
        body.push(Statement::Set(reading, Expr::Now));
        let mut begun = Vec::new();
        for clock in self.time.iter().and(&self.macro_time).flatten() {
            match (*clock, self.elapsed) {
                (Clock::Counted(time), Some(elapsed)) => {
                    body.push(Statement::Set(time, add(Expr::Place(time), Expr::Place(elapsed))));
                }
                _ => begun.push(clock.begin()),
            }
        }
        // `new` does not know the clock.
        when(&mut body, Expr::Place(self.first), begun);
        let Some(elapsed) = self.elapsed else { return body };
        for phases in &self.phases {
            for (period, steps) in &phases.periods {
                let (phase, passed) = (Expr::Place(phases.phase), Expr::Place(elapsed));
                let on = Expr::Period(Box::new(phase), Box::new(passed), *period);
                let counts = Statement::Set(phases.phase, on);
                match phases.role {
                    Role::Phase { .. } => {
                        when(&mut body, any(steps.iter().map(|step| self.is(*step)).list()), vec![counts]);
                    }
                    _ => body.push(counts),
                }
            }
        }
        body
    }

    /// A34: what actions on leaving a step see.
    pub(super) fn keep_times(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        let steps = self.time.iter().zip(&self.reached);
        for (time, reached) in steps.and(self.macro_time.iter().zip(&self.macro_reached)) {
            if let (Some(time), Some(reached)) = (time, reached) {
                body.push(Statement::Set(*reached, time.passed(Expr::Now)));
            }
        }
        for phases in &self.phases {
            body.push(Statement::Set(phases.reached, Expr::Place(phases.phase)));
        }
        body
    }

    /// What has been entered begins its time; what stays goes on with it.
    pub(super) fn begin_times(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for region in 0..self.state.len() {
            if let Some(clock) = self.time[region] {
                when(&mut body, self.is_entered(region), vec![clock.begin()]);
            }
        }
        for id in self.model.macros.ids() {
            let mut all = self.macro_time[id.index()].into_iter().map(Clock::begin).list();
            for phases in self.phases.iter().filter(|one| matches!(one.role, Role::MacroPhase { of, .. } if of == id)) {
                all.push(Statement::Set(phases.phase, zero()));
            }
            if !all.is_empty() {
                when(&mut body, self.rises(id), all);
            }
        }
        for phases in &self.phases {
            let Role::Phase { region, period } = phases.role else { continue };
            let steps = phases.periods.iter().flat_map(|(_, steps)| steps);
            let is_entered = if period.is_none() {
                // As the time of the region, whatever is entered.
                self.is_entered(region)
            } else if self.model.is_grafcet() {
                all(vec![self.is_entered(region), any(steps.map(|step| self.is(*step)).list())])
            } else {
                any(steps.map(|step| Expr::Place(self.entered[step.index()])).list())
            };
            when(&mut body, is_entered, vec![Statement::Set(phases.phase, zero())]);
        }
        body
    }

    /// What goes on beyond the longest time that something compares with stands still there: nobody can tell. So it never wraps. Beside
    /// that, whether a time of the active step is over.
    pub(super) fn bound_times(&self) -> Vec<Statement<'m>> {
        let mut body = self.note_passed();
        for bound in self.longest.iter().filter(|bound| self.outlasted.contains(*bound)) {
            body.push_all(self.bound_time(bound));
        }
        body.push_all(self.move_periods());
        body
    }

    pub(super) fn note_passed(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for (region, passed) in self.passed.iter().enumerate() {
            let Some(passed) = passed else { continue };
            let (mut asked, mut over) = (Vec::new(), Vec::new());
            for (of, end) in self.outlasted.iter().filter(|(of, _)| self.region_of(*of) == Some(region)) {
                if let Blinker::Step(step) = of {
                    asked.push(self.is(*step));
                }
                over.push(self.second_part(*of, *end).unwrap_or_else(|| self.is_over(*of, *end)));
            }
            let note = Statement::Set(*passed, any(over));
            // Nobody asks for it beside other steps, so there it may be stale. Of one region it is told in each state, as `moved` puts the mark in its place.
            if self.state.len() == 1 { body.push(note) } else { when(&mut body, any(asked), vec![note]) }
        }
        body
    }

    pub(super) fn bound_time(&self, &(of, longest): &(Blinker, u32)) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        if let Some(clock) = self.clock(of) {
            let back = Expr::Since(Box::new(Expr::Now), Box::new(ticks(longest)));
            when(&mut body, self.is_over(of, longest), vec![Statement::Set(clock.place(), back)]);
        }
        body
    }

    /// It has been active before the cycle, still is, and a time is over.
    pub(super) fn is_over(&self, of: Blinker, time: u32) -> Expr<'m> {
        let Some(clock) = self.clock(of) else { return no() };
        let (was, is) = match of {
            Blinker::Step(step) => (self.was(step), self.is(step)),
            Blinker::Macro(id) => (self.macro_active(id, Moment::Before), self.macro_active(id, Moment::After)),
        };
        all(vec![was, is, at_least(clock.passed(Expr::Now), ticks(time))])
    }

    /// Whether another step of the region is active now, or (A4s) the same one again. A4g: in a `grafcet` that one stays active.
    fn is_entered(&self, region: usize) -> Expr<'m> {
        if self.model.is_grafcet() {
            return differ(self.was[region], self.state[region]);
        }
        let steps = &self.regions.all()[region].steps;
        any(steps.iter().map(|step| Expr::Place(self.entered[step.index()])).list())
    }

    /// Whether `M.X` has just become true.
    fn rises(&self, id: MacroId) -> Expr<'m> {
        let is = any(self.model.macros[id].steps.iter().map(|step| self.is(*step)).list());
        all(vec![is, not(self.macro_active(id, Moment::Before))])
    }
}
