//! Which times are counted, and which are readings of the clock.
//!
//! A time that is compared with literals alone is the reading at which it began: what has passed is `now - began`, which is exact as long as
//! two cycles lie less than 2^31 ticks apart. It cannot wrap, however long a step stays active: what can go on beyond the longest of its
//! literals is kept there (`bound_times`), and what blinks goes on by whole periods (`periods`). That of a delay with literals, and that of the timer of an action with one literal, is the reading at which its input changed; a stage tells whether anybody asks for it. Every other time is counted, and saturates.

use super::changes::{Change, Changes, changes, is_time_of_step, of_one_timer};
use super::places::{Phases, time, truth};
use super::{Clocks, Lower};
use crate::analysis::{Condition, Facts, Logic};
use crate::list::List;
use crate::model::{
    AssociationId, Blink, Blinker, Delay, Effect, ForceOrder, Id, MacroId, Model, Read, StepId, TimeRef, Tree,
};
use crate::program::build::{add, ticks};
use crate::program::{Expr, PlaceId, Role, Statement, Type};
use crate::raw::plain;

/// The highest time that a reading of the clock can be compared with.
pub(super) const HIGHEST: u32 = 1 << 31;

/// A time as it is stored.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Clock {
    /// What has passed.
    Counted(PlaceId),
    /// When it began.
    Began(PlaceId),
}

impl Clock {
    pub(super) fn place(self) -> PlaceId {
        match self {
            Self::Counted(place) | Self::Began(place) => place,
        }
    }

    /// What has passed at a reading of the clock.
    pub(super) fn passed(self, at: Expr<'_>) -> Expr<'_> {
        match self {
            Self::Counted(place) => Expr::Place(place),
            Self::Began(place) => Expr::Since(Box::new(at), Box::new(Expr::Place(place))),
        }
    }

    /// It begins anew.
    pub(super) fn begin<'m>(self) -> Statement<'m> {
        match self {
            Self::Counted(place) => Statement::Set(place, ticks(0)),
            Self::Began(place) => Statement::Set(place, Expr::Now),
        }
    }
}

impl<'m> Lower<'_, 'm> {
    /// Times that something asks for.
    pub(super) fn clocks(&mut self, facts: &Facts<'_>) {
        let model = self.model;
        self.time = vec![None; self.state.len()];
        self.reached = vec![None; self.state.len()];
        self.macro_time = vec![None; model.macros.len()];
        self.macro_reached = vec![None; model.macros.len()];
        let asked = self.asked();
        if !model.uses_time() && !asked.iter().any(|read| read.about().is_some()) {
            return;
        }
        self.reading = Some(self.field("reading".to_owned(), Role::Reading, Type::Ticks, time()));
        self.settled = Some(self.field("settled".to_owned(), Role::Settled, Type::Bool, truth(false)));
        let own = |association: &crate::model::Association| {
            !matches!(association.effect, Effect::Control(_) | Effect::Call(..))
        };
        if !model.is_grafcet() && model.associations.values().any(own) {
            self.turned = Some(self.truth("turned".to_owned()));
        }
        let opaque = |effect: &&Effect| match effect {
            Effect::Block(code) => self.is_opaque(code),
            Effect::Call(..) => true,
            Effect::Assign(place, _) => self.is_untold(*place),
            Effect::Control(_) => false,
        };
        if model.effects().iter().any(opaque) {
            self.opaque_ran = Some(self.truth("opaque_ran".to_owned()));
        }
        let changes = changes(model, self.regions);
        self.common_phase = self.common_phases(&changes);
        for read in asked {
            match read {
                Read::Since(step) | Read::Elapsed(_, step) => self.count(step, &changes),
                Read::MacroSince(id) | Read::MacroElapsed(_, id) => self.count_macro(id, &changes),
                Read::Blink(blink) => self.count_blink(blink, &changes),
                _ => {}
            }
        }
        for (id, association) in model.associations.iter() {
            if association.time.is_some() && is_time_of_step(model, self.regions, id) {
                self.count(association.step, &changes);
            }
        }
        if self.counts() {
            self.elapsed = Some(self.local("elapsed".to_owned(), Type::Ticks));
        }
        self.find_bounds(&changes, facts);
    }

    /// What asks for times. A program that has a clock knows nothing of properties.
    fn asked(&self) -> Vec<Read> {
        let mut all = self.model.expressions().concat();
        if self.clocks == Clocks::Counted {
            for property in &self.model.properties {
                all.extend(property.claim.expressions().iter().flat(|expr| &expr.reads));
            }
        }
        all.retain(|read| !matches!(read, Read::Active(_) | Read::MacroActive(_)));
        all
    }

    /// Whether something has to know how long it is since the cycle before.
    fn counts(&self) -> bool {
        let model = self.model;
        let counted = |clock: &Clock| matches!(clock, Clock::Counted(_));
        let has_timer = |(id, association): (AssociationId, &crate::model::Association)| {
            association.time.is_some() && !is_time_of_step(model, self.regions, id) && !self.reads_timer(id)
        };
        self.time.iter().and(&self.macro_time).flatten().any(counted)
            || !self.phases.is_empty()
            || model.delays.values().any(|delay| !self.reads(delay))
            || model.associations.iter().any(has_timer)
    }

    /// Whether a reading of the clock tells when a delay is over.
    pub(super) fn reads(&self, delay: &Delay) -> bool {
        let is_literal = |time: &TimeRef| literal(Change::At(*time)).is_some();
        self.clocks == Clocks::Read && [delay.on, delay.off].iter().all(is_literal)
    }

    /// The same of the timer of an association of an `sfc`.
    pub(super) fn reads_timer(&self, id: AssociationId) -> bool {
        let time = self.model.associations[id].time;
        self.clocks == Clocks::Read
            && time.is_some_and(|time| literal(Change::At(time)).is_some())
            && of_one_timer(self.model, id).iter().all(|one| one.time == time)
    }

    /// The time of a step is that of its region.
    fn count(&mut self, step: StepId, changes: &Changes) {
        let region = self.regions.of_step(step);
        if self.time[region].is_some() {
            return;
        }
        let name = self.region_name("time", region);
        let steps = &self.regions.all()[region].steps;
        let began = self.clocks == Clocks::Read
            && are_literals(changes, &|of| matches!(of, Blinker::Step(step) if steps.contains(step)));
        self.reached[region] = Some(self.local(format!("reached.{name}"), Type::Ticks));
        self.time[region] = Some(if began {
            let name = self.region_name("since", region);
            Clock::Began(self.field(name, Role::Began(region), Type::Ticks, time()))
        } else {
            Clock::Counted(self.field(name, Role::Time(region), Type::Ticks, time()))
        });
    }

    fn count_macro(&mut self, id: MacroId, changes: &Changes) {
        if self.macro_time[id.index()].is_some() {
            return;
        }
        let name = plain(&self.model.macros[id].name);
        let began = self.clocks == Clocks::Read && are_literals(changes, &|of| *of == Blinker::Macro(id));
        self.macro_reached[id.index()] = Some(self.local(format!("reached.{name}.T"), Type::Ticks));
        self.macro_time[id.index()] = Some(if began {
            Clock::Began(self.field(format!("{name}.since"), Role::MacroBegan(id), Type::Ticks, time()))
        } else {
            Clock::Counted(self.field(format!("{name}.T"), Role::MacroTime(id), Type::Ticks, time()))
        });
    }

    /// Of what blinks the time of its step tells how far the period is, where that is compared with literals alone.
    fn count_blink(&mut self, blink: Blink, changes: &Changes) {
        if let Blinker::Step(step) = blink.of {
            if self.note_periods(step, changes) {
                self.count(step, changes);
                return;
            }
        }
        self.count_phase(blink);
    }

    fn count_phase(&mut self, blink: Blink) {
        let (period, role) = (blink.period(), self.phase_role(blink));
        let step = if let Blinker::Step(step) = blink.of { Some(step) } else { None };
        if let Some(phases) = self.phases.iter_mut().find(|phases| phases.role == role) {
            match phases.periods.iter_mut().find(|(other, _)| *other == period) {
                Some((_, steps)) => steps.extend(step.filter(|step| !steps.contains(step))),
                None => phases.periods.push((period, step.into_iter().list())),
            }
            return;
        }
        let name = match role {
            Role::Phase { region, period: None } => self.region_name("phase", region),
            Role::Phase { region, .. } => format!("phase.{}.{period}", self.region_name("state", region)),
            Role::MacroPhase { of, .. } => format!("phase.{}.{period}", plain(&self.model.macros[of].name)),
            _ => return,
        };
        let phase = self.field(name.clone(), role, Type::Ticks, time());
        let reached = self.local(format!("reached.{name}"), Type::Ticks);
        self.phases.push(Phases { role, periods: vec![(period, step.into_iter().list())], phase, reached });
    }

    /// By region, whether none of its steps blinks in two ways.
    fn common_phases(&self, changes: &Changes) -> Vec<bool> {
        let mut all = vec![self.clocks == Clocks::Read; self.state.len()];
        let blinks = |(of, change): &(Blinker, Change)| match (of, change) {
            (Blinker::Step(step), Change::Blink(_, period)) => Some((*step, *period)),
            _ => None,
        };
        let blinking = changes.iter().filter_map(blinks).list();
        for (step, period) in &blinking {
            all[self.regions.of_step(*step)] &= !blinking.iter().any(|(one, other)| one == step && other != period);
        }
        all
    }

    pub(super) fn phase_role(&self, blink: Blink) -> Role {
        let period = blink.period();
        match blink.of {
            Blinker::Step(step) => {
                let region = self.regions.of_step(step);
                let is_common = self.common_phase.get(region).copied().unwrap_or_default();
                Role::Phase { region, period: (!is_common).then_some(period) }
            }
            Blinker::Macro(of) => Role::MacroPhase { of, period },
        }
    }

    /// The clock of a step or macro-step.
    pub(super) fn clock(&self, of: Blinker) -> Option<Clock> {
        match of {
            Blinker::Step(step) => self.time[self.regions.of_step(step)],
            Blinker::Macro(id) => self.macro_time[id.index()],
        }
    }

    /// What can stay active when its longest time is over, and which times can be over while their step stays active.
    fn find_bounds(&mut self, changes: &Changes, facts: &Facts<'_>) {
        let mut longest: Vec<(Blinker, u32)> = Vec::new();
        let leaving = Leaving::of(self.model, facts);
        for (of, change) in changes {
            let (Some(Clock::Began(_)), Some(end)) = (self.clock(*of), literal(*change).filter(|end| *end > 0)) else {
                continue;
            };
            if !leaving.leaves(*of, end) {
                self.outlasted.insert((*of, end));
            }
            if matches!(of, Blinker::Step(step) if self.periods_of(*step).is_some()) {
                continue;
            }
            match longest.iter_mut().find(|(other, _)| other == of) {
                Some((_, longest)) => *longest = end.max(*longest),
                None => longest.push((*of, end)),
            }
        }
        self.longest = longest;
        // The second part of a period is what lies after the first.
        for periods in &self.periods {
            self.outlasted.extend(periods.only());
        }
    }

    /// The time that an expression of the deadline is about, from the reading at which it began.
    pub(super) fn end_of(&self, change: Change) -> Option<Expr<'m>> {
        match change {
            Change::At(time) => Some(self.time_of(time)),
            Change::After(time) => Some(match self.time_of(time) {
                Expr::Value(crate::program::Value::Ticks(time)) => ticks(time.saturating_add(1)),
                time => add(time, ticks(1)),
            }),
            _ => None,
        }
    }
}

/// Whether all that is asked of some times is how they compare with literals.
fn are_literals(changes: &Changes, these: &dyn Fn(&Blinker) -> bool) -> bool {
    let blinks = |change: &Change| matches!(change, Change::Blink(..));
    changes.iter().all(|(of, change)| !these(of) || blinks(change) || literal(*change).is_some())
}

/// When the truth of a comparison with a literal changes, where a reading of the clock can tell.
pub(super) fn literal(change: Change) -> Option<u32> {
    let end = match change {
        Change::At(TimeRef::Ticks(time)) => Some(time),
        Change::After(TimeRef::Ticks(time)) => time.checked_add(1),
        _ => None,
    };
    end.filter(|end| *end <= HIGHEST)
}

/// Which steps are left when some time is over.
struct Leaving<'f> {
    model: &'f Model,
    facts: &'f Facts<'f>,
    logic: Logic<'f>,
}

impl<'f> Leaving<'f> {
    fn of(model: &'f Model, facts: &'f Facts<'f>) -> Self {
        let logic = Logic::within(model, &facts.concurrency, &[]);
        Self { model, facts, logic }
    }

    /// Whether each cycle in which it has been active for so long leaves it. What the plant may do counts, and not what the chart assumes
    /// of it.
    fn leaves(&self, of: Blinker, time: u32) -> bool {
        let (Blinker::Step(step), model) = (of, self.model) else { return false };
        if self.is_stopped(step) || self.is_kept(step) || self.is_held(step) {
            return false;
        }
        let mut ways = Vec::new();
        for id in &model.leaving[step.index()] {
            let transition = &model.transitions[*id];
            if transition.sources == [step] {
                ways.push(self.logic.condition(&transition.condition.tree));
            }
        }
        let ways: Vec<&Condition> = ways.iter().list();
        let over = self.logic.condition(&Tree::Elapsed(TimeRef::Ticks(time), step));
        self.logic.implies(&over, &ways)
    }

    /// Whether an `any` may stop what leaves it, and not leave it itself.
    fn is_stopped(&self, step: StepId) -> bool {
        let beside = |source: &StepId| self.facts.concurrency.together(*source, step);
        let mut anys = self.model.anys.values().filter(|any| any.partial == self.model.steps[step].partial);
        anys.any(|any| !any.sources.contains(&step) && any.sources.iter().any(beside))
    }

    /// Whether something above may keep it active: an order that puts it or what encloses it into a situation (A13).
    fn is_held(&self, step: StepId) -> bool {
        let model = self.model;
        let (mut inside, mut held) = (step, false);
        loop {
            let partial = model.steps[inside].partial;
            held |= model.orders_on(partial).any(|force| match &force.order {
                ForceOrder::Hold => true,
                ForceOrder::Init => model.steps[inside].initial,
                ForceOrder::Steps(steps) => steps.contains(&inside),
            });
            let Some(above) = model.partials[partial].enclosed_by else { return held };
            inside = above;
        }
    }

    /// A4g: whether something that clears together with what leaves it may keep it active.
    fn is_kept(&self, step: StepId) -> bool {
        let may = |id: &crate::model::TransitionId| {
            let other = |source: &StepId| *source != step && !self.facts.concurrency.together(*source, step);
            !self.model.transitions[*id].sources.iter().any(other)
        };
        self.model.is_grafcet() && self.model.entering[step.index()].iter().any(may)
    }
}
