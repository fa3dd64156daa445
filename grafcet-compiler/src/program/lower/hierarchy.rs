//! Partial grafcets from the top of the hierarchy to its bottom: forcing, enclosing (A11 to A19, A21).

use super::Lower;
use crate::list::{List, PushAll};
use crate::model::{ForceOrder, Id, PartialId, StepId};
use crate::program::Statement;
use crate::program::build::{all, any, no, not};

impl<'m> Lower<'_, 'm> {
    /// "Frozen are the partial grafcets forced by the active steps"; A17: an enclosure clears only while its enclosing step is active.
    pub(super) fn decide_free(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for (id, partial) in self.model.partials.iter() {
            let Some(free) = self.free[id.index()] else { continue };
            let mut parts = Vec::new();
            for force in self.model.orders_on(id) {
                parts.push(not(self.was(force.step)));
            }
            parts.push_all(partial.enclosed_by.map(|step| self.was(step)));
            body.push(Statement::Set(free, all(parts)));
        }
        body
    }

    /// "An enclosing step that was left empties its enclosures, one that was entered activates the linked steps; a forcing order of an
    /// active step overwrites its target."
    pub(super) fn descend(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for id in &self.partials {
            let mut changes = self.clear(*id);
            if let Some(step) = self.model.partials[*id].enclosed_by {
                let entered = self.overwrite(*id, &self.steps_where(*id, |step| step.linked));
                let here = vec![Statement::If(self.was(step), changes, entered)];
                // A19: the enclosing step that is left wins over what is inside.
                changes = vec![Statement::If(self.is(step), here, self.overwrite(*id, &[]))];
            }
            // A14 leaves at most one order; the last in the source otherwise.
            for force in self.model.orders_on(*id) {
                let forced = match &force.order {
                    ForceOrder::Steps(steps) => self.overwrite(*id, steps),
                    ForceOrder::Init => self.overwrite(*id, &self.steps_where(*id, |step| step.initial)),
                    ForceOrder::Hold => self.clears_nothing(*id),
                };
                changes = vec![Statement::If(self.is(force.step), forced, changes)];
            }
            body.push_all(changes);
        }
        body
    }

    /// Rule 5: `X' = (X − sources(F)) ∪ targets(F)`, activation wins.
    fn clear(&self, partial: PartialId) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for leaving in [true, false] {
            for step in &self.model.partials[partial].steps {
                let clearing = if leaving { self.leaving(*step) } else { self.entering(*step) };
                if !clearing.is_empty() {
                    body.push(Statement::If(any(clearing), vec![self.put(*step, !leaving)], Vec::new()));
                }
            }
        }
        body
    }

    /// The hierarchy above decides: nothing clears, and these steps are active.
    fn overwrite(&self, partial: PartialId, steps: &[StepId]) -> Vec<Statement<'m>> {
        let mut body = self.clears_nothing(partial);
        for region in 0..self.state.len() {
            if self.regions.all()[region].partial == partial {
                body.push(self.empty(region));
            }
        }
        body.push_all(steps.iter().map(|step| self.put(*step, true)));
        body
    }

    fn clears_nothing(&self, partial: PartialId) -> Vec<Statement<'m>> {
        let transitions = self.model.partials[partial].transitions.iter();
        transitions.map(|id| Statement::Set(self.clears[id.index()], no())).list()
    }

    fn steps_where(&self, partial: PartialId, wanted: fn(&crate::model::Step) -> bool) -> Vec<StepId> {
        let mut steps = self.model.partials[partial].steps.clone();
        steps.retain(|step| wanted(&self.model.steps[*step]));
        steps
    }
}
