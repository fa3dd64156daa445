//! What an expression of the user reads, at each moment of the cycle.

use super::Lower;
use super::periods::is_on;
use crate::list::List;
use crate::model::{Blink, Blinker, Expr as Written, Id, MacroId, Name, Read, StepId, TimeRef, Tree};
use crate::program::build::{all, any, at_least, choose, less, no, not, ticks, yes, zero};
use crate::program::{Expr, PlaceId, Statement, User, Value};

/// Which situation, times and values an expression sees.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Moment {
    /// All from before the evolution: samples, conditions, and in a `grafcet` what stored actions and the continuous ones see (A5).
    Before,
    /// An action of an `sfc`: the situation after the evolution, outputs of the cycle before (point 6), variables as they are.
    After,
    /// The same on leaving a step (A34).
    Leaving,
    /// A37: before the activation of the initial situation no step is active.
    Start,
}

impl<'m> Lower<'_, 'm> {
    /// The value of an expression.
    pub(super) fn user(&self, expr: &'m Written, moment: Moment) -> Expr<'m> {
        self.part_of(&expr.tokens, &expr.tree, moment)
    }

    /// The same of one whose tokens and tree are given.
    pub(super) fn part_of(&self, tokens: &'m syn::Expr, tree: &'m Tree, moment: Moment) -> Expr<'m> {
        if let Tree::Bool(value) = tree {
            return Expr::Value(Value::Bool(*value));
        }
        let mut binds: Vec<(Read, Expr<'m>)> = Vec::new();
        tree.each_read(&mut |read| {
            if !binds.iter().any(|(other, _)| *other == read) {
                binds.push((read, self.read(read, moment)));
            }
        });
        Expr::User(Box::new(User { tokens, tree, binds }))
    }

    /// The condition after `if`, if there is one.
    pub(super) fn condition(&self, condition: Option<&'m Written>, moment: Moment) -> Expr<'m> {
        condition.map_or_else(yes, |condition| self.user(condition, moment))
    }

    /// What a name or a placeholder stands for.
    pub(super) fn read(&self, read: Read, moment: Moment) -> Expr<'m> {
        match read {
            Read::Name(name) => self.named(name, moment),
            Read::Active(step) => self.active(step, moment),
            Read::Since(step) => self.since(step, moment),
            Read::MacroActive(id) => self.macro_active(id, moment),
            Read::MacroSince(id) => self.macro_since(id, moment),
            Read::Rising(_) | Read::Falling(_) if moment == Moment::Start => no(),
            // Only properties have it, of which a program knows nothing.
            Read::Memory(_) => no(),
            Read::Rising(id) => self.edge(id.index(), moment, true),
            Read::Falling(id) => self.edge(id.index(), moment, false),
            Read::Delay(id) => self.delayed(id),
            Read::Ticks(count) => ticks(count),
            Read::Elapsed(time, step) => {
                all(vec![self.active(step, moment), at_least(self.since_active(step, moment), self.time_of(time))])
            }
            Read::MacroElapsed(time, id) => {
                all(vec![self.macro_active(id, moment), at_least(self.macro_since(id, moment), self.time_of(time))])
            }
            Read::Blink(blink) => self.blink(blink, moment),
        }
    }

    fn named(&self, name: Name, moment: Moment) -> Expr<'m> {
        match name {
            Name::Input(id) => Expr::Input(id),
            Name::Param(id) => Expr::Place(self.params[id.index()]),
            Name::Var(id) => match (self.combinational[id.index()], moment) {
                (Some(_), Moment::Start) => no(),
                (Some(place), _) => Expr::Place(place),
                (None, _) => Expr::Place(self.vars[id.index()]),
            },
            Name::Output(id) => match (self.last_outputs[id.index()], moment) {
                (Some(last), Moment::After | Moment::Leaving) => Expr::Place(last),
                _ => Expr::Place(self.outputs[id.index()]),
            },
        }
    }

    /// A time in ticks.
    pub(super) fn time_of(&self, time: TimeRef) -> Expr<'m> {
        match time {
            TimeRef::Ticks(count) => ticks(count),
            TimeRef::Param(id) => Expr::Place(self.params[id.index()]),
            TimeRef::Var(id) => Expr::Place(self.vars[id.index()]),
        }
    }

    /// Whether a step was active before the evolution.
    pub(super) fn was(&self, step: StepId) -> Expr<'m> {
        self.in_step(&self.was, step)
    }

    /// Whether it is now.
    pub(super) fn is(&self, step: StepId) -> Expr<'m> {
        self.in_step(&self.state, step)
    }

    pub(super) fn in_step(&self, regions: &[PlaceId], step: StepId) -> Expr<'m> {
        Expr::Is(regions[self.regions.of_step(step)], vec![step])
    }

    pub(super) fn active(&self, step: StepId, moment: Moment) -> Expr<'m> {
        match moment {
            Moment::Before => self.was(step),
            Moment::After | Moment::Leaving => self.is(step),
            Moment::Start => no(),
        }
    }

    /// A20: while any step of the expansion is.
    pub(super) fn macro_active(&self, id: MacroId, moment: Moment) -> Expr<'m> {
        any(self.model.macros[id].steps.iter().map(|step| self.active(*step, moment)).list())
    }

    /// `Step.T`: zero for a step that is not active; A34: for one just left the time it had reached.
    fn since(&self, step: StepId, moment: Moment) -> Expr<'m> {
        let region = self.regions.of_step(step);
        let (Some(time), Some(reached)) = (self.time[region], self.reached[region]) else { return zero() };
        let time = time.passed(Expr::Now);
        match moment {
            Moment::Start => zero(),
            Moment::Before => choose(self.was(step), time, zero()),
            Moment::Leaving => choose(self.was(step), Expr::Place(reached), zero()),
            Moment::After => {
                let left = choose(self.was(step), Expr::Place(reached), zero());
                choose(self.is(step), time, left)
            }
        }
    }

    /// The same where the step is active at that moment.
    pub(super) fn since_active(&self, step: StepId, moment: Moment) -> Expr<'m> {
        match (moment, self.time[self.regions.of_step(step)]) {
            (Moment::Before | Moment::After, Some(time)) => time.passed(Expr::Now),
            _ => self.since(step, moment),
        }
    }

    /// A20: since `M.X` rose.
    fn macro_since(&self, id: MacroId, moment: Moment) -> Expr<'m> {
        let (Some(time), Some(reached)) = (self.macro_time[id.index()], self.macro_reached[id.index()]) else {
            return zero();
        };
        let (was, time) = (self.macro_active(id, Moment::Before), time.passed(Expr::Now));
        match moment {
            Moment::Start => zero(),
            Moment::Before => choose(was, time, zero()),
            Moment::Leaving => choose(was, Expr::Place(reached), zero()),
            Moment::After => {
                let left = choose(was, Expr::Place(reached), zero());
                choose(self.macro_active(id, moment), time, left)
            }
        }
    }

    /// In the first part of each period since the activation.
    fn blink(&self, blink: Blink, moment: Moment) -> Expr<'m> {
        if let Blinker::Step(step) = blink.of {
            if self.periods_of(step).is_some() {
                return all(vec![self.active(step, moment), is_on(self.since_active(step, moment), blink)]);
            }
        }
        let role = self.phase_role(blink);
        let Some(phases) = self.phases.iter().find(|phases| phases.role == role) else { return no() };
        let (was, is) = match blink.of {
            Blinker::Step(step) => (self.was(step), self.active(step, moment)),
            Blinker::Macro(id) => (self.macro_active(id, Moment::Before), self.macro_active(id, moment)),
        };
        let phase = match moment {
            Moment::Start => return no(),
            Moment::Before | Moment::After => Expr::Place(phases.phase),
            Moment::Leaving => choose(was, Expr::Place(phases.reached), zero()),
        };
        all(vec![is, less(phase, ticks(blink.on))])
    }

    fn edge(&self, index: usize, moment: Moment, rising: bool) -> Expr<'m> {
        let late = matches!(moment, Moment::After | Moment::Leaving);
        let edges = if late { self.action_edges[index] } else { self.edges[index] };
        let Some(edges) = edges else { return no() };
        let (before, now) = (Expr::Place(edges.before), Expr::Place(edges.now));
        if rising { all(vec![not(before), now]) } else { all(vec![before, not(now)]) }
    }

    /// Takes a step out of the situation, or puts it in.
    pub(super) fn put(&self, step: StepId, active: bool) -> Statement<'m> {
        let place = self.state[self.regions.of_step(step)];
        Statement::Set(place, Expr::Value(Value::Step(active.then_some(step))))
    }

    /// What a step of a partial grafcet, or of all, does not stand in any more.
    pub(super) fn empty(&self, region: usize) -> Statement<'m> {
        Statement::Set(self.state[region], Expr::Value(Value::Step(None)))
    }
}
