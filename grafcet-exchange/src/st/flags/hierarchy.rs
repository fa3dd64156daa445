//! What partial grafcets do to each other: a step that encloses others, and orders that force them.
//!
//! The partial grafcets stand from the top of the hierarchy to its bottom, so that each one finds what is above it as it is after the evolution. What is moved
//! from above is compared with what it was before the scan: no transition tells that it is activated.

use grafcet_compiler::analysis::hierarchy;
use grafcet_compiler::model::{Force, ForceOrder, Id, Model, PartialId, StepId, Transition};

use super::Flags;
use crate::st::expr::plain;
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, any, not};

pub(super) use hierarchy::top_down;

/// Whether one partial grafcet acts on another.
pub(super) fn is_there(model: &Model) -> bool {
    !model.forces.is_empty() || model.partials.values().any(|partial| partial.enclosed_by.is_some())
}

/// The orders to a partial grafcet, each with those beside each other that give it, the last one in the source first: it holds where two are given,
/// to which an operator leads by hand or a plant that breaks an assumption.
fn orders(model: &Model, target: PartialId) -> Vec<(&ForceOrder, Vec<&Force>)> {
    let mut orders: Vec<(&ForceOrder, Vec<&Force>)> = Vec::new();
    let given: Vec<&Force> = model.orders_on(target).collect();
    for force in given.into_iter().rev() {
        match orders.last_mut() {
            Some((order, forces)) if **order == force.order => forces.insert(0, force),
            _ => orders.push((&force.order, vec![force])),
        }
    }
    orders
}

impl Flags<'_> {
    /// Whether something above it may move a step.
    pub(super) fn is_moved(&self, step: StepId) -> bool {
        !hierarchy::masters(self.model, self.model.steps[step].partial).is_empty()
    }

    /// Which partial grafcets an order holds: they clear nothing, also in the evolution in which it ends.
    pub(super) fn frozen(&mut self) -> Vec<Statement> {
        let model = self.model;
        let mut statements = Vec::new();
        for target in model.partials.ids() {
            let given: Vec<Text> = model
                .forces
                .values()
                .filter(|force| force.target == target)
                .map(|force| self.flag(force.step))
                .collect();
            if given.is_empty() {
                continue;
            }
            let called = self.called(target);
            let name = self.scope.names.own(&format!("Frozen_{called}"));
            let note = format!("an order holds {called}, which clears nothing");
            self.frame.variables.push(Variable::new(&*name, "BOOL").note(note));
            statements.push(Statement::assign(&*name, any(given).text));
            self.frozen.insert(target, name);
        }
        statements
    }

    /// What the hierarchy asks of a transition beside its steps: no order, and for one without steps the enclosing step. Where that is not
    /// active, no step is within it.
    pub(super) fn lets_clear(&self, transition: &Transition) -> Vec<Text> {
        let frozen = self.frozen.get(&transition.partial).map(|name| not(Text::word(&**name)));
        let enclosing = self.model.partials[transition.partial].enclosed_by.filter(|_| transition.sources.is_empty());
        frozen.into_iter().chain(enclosing.map(|step| self.flag(step))).collect()
    }

    /// The steps of a partial grafcet after the evolution.
    pub(super) fn of_partial(&mut self, id: PartialId) -> Vec<Statement> {
        let model = self.model;
        let steps = &model.partials[id].steps;
        let mut branches = Vec::new();
        for (order, forces) in orders(model, id) {
            let given: Vec<Text> = forces.iter().map(|force| self.flag(force.step)).collect();
            let (active, text) = match order {
                ForceOrder::Steps(active) => (Some(active.clone()), self.listed(active)),
                ForceOrder::Init => {
                    let initial = steps.iter().copied().filter(|step| model.steps[*step].initial);
                    (Some(initial.collect()), "INIT".to_owned())
                }
                ForceOrder::Hold => (None, "*".to_owned()),
            };
            let mut done = vec![Statement::comment(format!("{} {{{text}}}", self.called(id)))];
            if let Some(active) = active {
                let set = |step: &StepId| self.put(*step, active.contains(step));
                done.extend(steps.iter().map(set));
            }
            done.extend(self.stopped(id));
            branches.push((any(given).text, done));
        }
        if let Some(enclosing) = model.partials[id].enclosed_by {
            let name = plain(&model.steps[enclosing].name);
            let mut left = vec![Statement::comment(format!("{name} is not active: nothing within it is"))];
            left.extend(steps.iter().map(|step| self.put(*step, false)));
            left.extend(self.stopped(id));
            branches.push((not(self.flag(enclosing)).text, left));
            let mut entered = vec![Statement::comment(format!("{name} is activated: so is what is linked to it"))];
            let linked = steps.iter().filter(|step| model.steps[**step].linked);
            entered.extend(linked.map(|step| self.put(*step, true)));
            branches.push((not(self.was(enclosing)).text, entered));
        }
        let called = self.called(id);
        let mut statements = Vec::new();
        if !called.is_empty() {
            statements.push(Statement::comment(called));
        }
        let free = self.free(id);
        statements.extend(if branches.is_empty() { free } else { vec![Statement::If(branches, free)] });
        statements
    }

    fn put(&self, step: StepId, active: bool) -> Statement {
        Statement::assign(&*self.steps[step.index()], if active { "TRUE" } else { "FALSE" })
    }

    /// Transitions that do something when they clear do not clear.
    fn stopped(&self, id: PartialId) -> Vec<Statement> {
        let transitions = self.model.partials[id].transitions.iter();
        let does = transitions.filter(|id| !self.model.transitions[**id].clearing.is_empty());
        does.map(|id| Statement::assign(&*self.transitions[id.index()], "FALSE")).collect()
    }

    /// That a step was active before the scan.
    pub(super) fn was(&mut self, step: StepId) -> Text {
        self.was.insert(step);
        Text::word(&*self.was_names[step.index()])
    }

    /// What [`Self::was`] has been asked for.
    pub(super) fn remembered(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        for step in &self.was {
            let name = &self.was_names[step.index()];
            self.frame.variables.push(Variable::new(&**name, "BOOL"));
            statements.push(Statement::assign(&**name, &*self.steps[step.index()]));
        }
        statements
    }

    /// What has been activated and deactivated of the steps that something above them moves, told by what they were.
    pub(super) fn moved_changes(&mut self) -> Vec<Statement> {
        let (activated, deactivated) = (self.asked(&self.activated, true), self.asked(&self.deactivated, true));
        let mut statements = Vec::new();
        for (step, name) in activated {
            let mut was = vec![self.was(step)];
            // The steps of the beginning are activated in the first scan.
            if self.initial.contains(&step) {
                was.push(Text::word(&*self.started));
            }
            self.frame.variables.push(Variable::new(&*name, "BOOL"));
            statements.push(Statement::assign(name, all(vec![self.flag(step), not(all(was))]).text));
        }
        for (step, name) in deactivated {
            let was = self.was(step);
            self.frame.variables.push(Variable::new(&*name, "BOOL"));
            statements.push(Statement::assign(name, all(vec![was, not(self.flag(step))]).text));
        }
        statements
    }

    fn called(&self, id: PartialId) -> String {
        self.model.partials[id].name.as_ref().map(plain).unwrap_or_default()
    }

    fn listed(&self, steps: &[StepId]) -> String {
        steps.iter().map(|step| plain(&self.model.steps[*step].name)).collect::<Vec<_>>().join(", ")
    }
}
