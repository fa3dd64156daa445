//! Which steps are active, and which are activated and deactivated in a scan.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Id, PartialId, StepId};

use super::Flags;
use crate::st::expr::plain;
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, any, not};

impl Flags<'_> {
    fn entering(&self, step: StepId) -> Vec<Text> {
        self.model.entering[step.index()].iter().map(|id| self.transition(*id)).collect()
    }

    fn leaving(&self, step: StepId) -> Vec<Text> {
        self.model.leaving[step.index()].iter().map(|id| self.transition(*id)).collect()
    }

    /// Whether it can be left and entered at once.
    pub(super) fn may_reenter(&self, step: StepId) -> bool {
        let leaving = &self.model.leaving[step.index()];
        let entering = &self.model.entering[step.index()];
        leaving.iter().any(|id| entering.contains(id)) || !self.single && !leaving.is_empty() && !entering.is_empty()
    }

    /// All steps after the evolution. What moves others stands before them.
    pub(super) fn situation(&mut self) -> Vec<Statement> {
        let model = self.model;
        if !super::hierarchy::is_there(model) {
            return model.steps.ids().map(|step| self.evolved(step)).collect();
        }
        let mut statements = Vec::new();
        for partial in super::hierarchy::top_down(model) {
            statements.extend(self.of_partial(partial));
        }
        statements
    }

    /// The steps of one partial grafcet, which nothing moves but its transitions.
    pub(super) fn free(&self, partial: PartialId) -> Vec<Statement> {
        self.model.partials[partial].steps.iter().map(|step| self.evolved(*step)).collect()
    }

    /// A step that transitions alone set and reset.
    fn evolved(&self, step: StepId) -> Statement {
        let (stays, entering, leaving) = (self.flag(step), self.entering(step), self.leaving(step));
        let value = if leaving.is_empty() {
            any([stays].into_iter().chain(entering).collect())
        } else if self.may_reenter(step) {
            // A step that is left and entered stays active.
            any([all(vec![stays, not(any(leaving))])].into_iter().chain(entering).collect())
        } else {
            all(vec![any([stays].into_iter().chain(entering).collect()), not(any(leaving))])
        };
        Statement::assign(&*self.steps[step.index()], value.text)
    }

    /// That a step is activated in this scan.
    pub(super) fn activated(&mut self, step: StepId) -> Text {
        if !self.activated.contains_key(&step) {
            let name = self.scope.names.own(&format!("Act_{}", plain(&self.model.steps[step].name)));
            self.activated.insert(step, name);
        }
        Text::word(&*self.activated[&step])
    }

    /// That it is left.
    pub(super) fn deactivated(&mut self, step: StepId) -> Text {
        if !self.deactivated.contains_key(&step) {
            let name = self.scope.names.own(&format!("Deact_{}", plain(&self.model.steps[step].name)));
            self.deactivated.insert(step, name);
        }
        Text::word(&*self.deactivated[&step])
    }

    /// The names that have been asked for, of steps that something above them moves or of the others.
    pub(super) fn asked(&self, names: &BTreeMap<StepId, String>, moved: bool) -> Vec<(StepId, String)> {
        let of = names.iter().filter(|(step, _)| self.is_moved(**step) == moved);
        of.map(|(step, name)| (*step, name.clone())).collect()
    }

    /// What [`Self::activated`] and [`Self::deactivated`] have asked for, seen before the steps change: of those that transitions alone move.
    pub(super) fn changes(&mut self) -> Vec<Statement> {
        let sfc = !self.model.is_grafcet();
        let mut statements = Vec::new();
        for (step, name) in self.asked(&self.activated, false) {
            let mut new = vec![not(self.flag(step))];
            if sfc && self.may_reenter(step) {
                new.extend(self.leaving(step));
            }
            let mut value = all(vec![any(self.entering(step)), any(new)]);
            if self.model.steps[step].initial {
                value = any(vec![value, not(Text::word(&*self.started))]);
            }
            self.frame.variables.push(Variable::new(&*name, "BOOL"));
            statements.push(Statement::assign(name, value.text));
        }
        for (step, name) in self.asked(&self.deactivated, false) {
            let mut parts = vec![any(self.leaving(step))];
            if !sfc && self.may_reenter(step) {
                parts.push(not(any(self.entering(step))));
            }
            self.frame.variables.push(Variable::new(&*name, "BOOL"));
            statements.push(Statement::assign(name, all(parts).text));
        }
        statements
    }
}
