//! "The elapsed time since the previous cycle is a wrapping difference; step times add it up and saturate. The first cycle has no
//! elapsed time."

use super::Lower;
use super::view::Moment;
use crate::model::{Id, MacroId};
use crate::program::build::{add, all, any, choose, differ, not, when, zero};
use crate::program::{Expr, PlaceId, Role, Statement};

impl<'m> Lower<'_, 'm> {
    /// Time passes.
    pub(super) fn pass_time(&self) -> Vec<Statement<'m>> {
        let (Some(elapsed), Some(reading)) = (self.elapsed, self.reading) else { return Vec::new() };
        let since = Expr::Since(Box::new(Expr::Now), Box::new(Expr::Place(reading)));
        let mut body = vec![
            Statement::Set(elapsed, choose(Expr::Place(self.first), zero(), since)),
            Statement::Set(reading, Expr::Now),
        ];
        for time in self.time.iter().chain(&self.macro_time).flatten() {
            body.push(Statement::Set(*time, add(Expr::Place(*time), Expr::Place(elapsed))));
        }
        for phases in &self.phases {
            let (phase, passed) = (Expr::Place(phases.phase), Expr::Place(elapsed));
            let on = Expr::Period(Box::new(phase), Box::new(passed), phases.period);
            body.push(Statement::Set(phases.phase, on));
        }
        body
    }

    /// A34: what actions on leaving a step see.
    pub(super) fn keep_times(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        let steps = self.time.iter().zip(&self.reached);
        for (time, reached) in steps.chain(self.macro_time.iter().zip(&self.macro_reached)) {
            if let (Some(time), Some(reached)) = (time, reached) {
                body.push(Statement::Set(*reached, Expr::Place(*time)));
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
            let counters = self.counters(Role::Time(region), self.time[region]);
            when(&mut body, self.is_entered(region), counters);
        }
        for id in self.model.macros.ids() {
            let counters = self.counters(Role::MacroTime(id), self.macro_time[id.index()]);
            if !counters.is_empty() {
                when(&mut body, self.rises(id), counters);
            }
        }
        body
    }

    /// The time and the phases of a region or macro-step, set to zero.
    fn counters(&self, of: Role, time: Option<PlaceId>) -> Vec<Statement<'m>> {
        let mut all: Vec<PlaceId> = time.into_iter().collect();
        for phases in &self.phases {
            let same = match (of, phases.role) {
                (Role::Time(region), Role::Phase { region: other, .. }) => region == other,
                (Role::MacroTime(id), Role::MacroPhase { of: other, .. }) => id == other,
                _ => false,
            };
            if same {
                all.push(phases.phase);
            }
        }
        all.into_iter().map(|place| Statement::Set(place, zero())).collect()
    }

    /// Whether another step of the region is active now, or (A4s) the same one again. A4g: in a `grafcet` that one stays active.
    fn is_entered(&self, region: usize) -> Expr<'m> {
        if self.model.is_grafcet() {
            let changed = differ(self.was[region], self.state[region]);
            return if self.regions.are_flags() {
                all(vec![Expr::Place(self.state[region]), not(Expr::Place(self.was[region]))])
            } else {
                changed
            };
        }
        let steps = &self.regions.all()[region].steps;
        any(steps.iter().map(|step| Expr::Place(self.entered[step.index()])).collect())
    }

    /// Whether `M.X` has just become true.
    fn rises(&self, id: MacroId) -> Expr<'m> {
        let is = any(self.model.macros[id].steps.iter().map(|step| self.is(*step)).collect());
        all(vec![is, not(self.macro_active(id, Moment::Before))])
    }
}
