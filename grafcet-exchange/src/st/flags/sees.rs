//! What actions see of steps, times and values at their moment.

use std::cell::RefCell;
use std::collections::BTreeMap;

use grafcet_compiler::diagnostic::Mark;
use grafcet_compiler::model::{Association, Id, StepId};

use super::Flags;
use crate::Refused;
use crate::st::expr::{At, Kind, Moment, Scope};
use crate::st::text::{Text, all};

impl<'m> Flags<'m> {
    /// What an action sees after the evolution.
    pub(super) fn after<T>(
        &mut self,
        association: &Association,
        see: impl FnOnce(&mut Scope<'m>, &At<'_>) -> Result<T, Refused>,
    ) -> Result<T, Refused> {
        let (steps, before) = (self.steps.clone(), self.before.clone());
        let active = |step: StepId| Some(Text::word(&*steps[step.index()]));
        // In a `grafcet` the timers have been called anew by then.
        if !self.model.is_grafcet() {
            // What is stored outlives its step.
            let stored = association.qualifier.has_flip_flop();
            self.scope.moment = Moment::Moved((!stored).then_some(association.step));
        }
        let seen = see(&mut self.scope, &At { active: &active, before: &before, times: true, mark: association.mark });
        self.scope.moment = Moment::Called;
        seen
    }

    /// What an action sees that runs at an instant: in an `sfc` what there is after the evolution, with these times, in a `grafcet` what there was
    /// before it.
    pub(super) fn instant<T>(
        &mut self,
        moment: Moment,
        mark: Mark,
        see: impl FnOnce(&mut Scope<'m>, &At<'_>) -> Result<T, Refused>,
    ) -> Result<T, Refused> {
        let before = self.before.clone();
        if !self.model.is_grafcet() {
            let steps = self.steps.clone();
            let active = |step: StepId| Some(Text::word(&*steps[step.index()]));
            self.scope.moment = moment;
            let seen = see(&mut self.scope, &At { active: &active, before: &before, times: true, mark });
            self.scope.moment = Moment::Called;
            return seen;
        }
        let asked = RefCell::new(std::mem::take(&mut self.was));
        let active = |step: StepId| {
            asked.borrow_mut().insert(step);
            let was = Text::word(&*self.was_names[step.index()]);
            // The activation of the initial situation begins from nothing.
            let begun = self.initial.contains(&step).then(|| Text::word(&*self.started));
            Some(all(begun.into_iter().chain([was]).collect()))
        };
        let seen = see(&mut self.scope, &At { active: &active, before: &before, times: true, mark });
        self.was = asked.into_inner();
        seen
    }

    /// The flag of an association: its step, and its condition.
    pub(super) fn input(&mut self, association: &Association) -> Result<Text, Refused> {
        let flag = self.flag(association.step);
        let Some(condition) = &association.condition else { return Ok(flag) };
        let stable = self.model.is_grafcet();
        let nothing = BTreeMap::new();
        let condition = self.after(association, |scope, at| {
            let before = if stable { &nothing } else { at.before };
            scope.expr(condition, &Kind::Bool, &At { before, ..*at })
        })?;
        Ok(all(vec![flag, condition]))
    }
}
