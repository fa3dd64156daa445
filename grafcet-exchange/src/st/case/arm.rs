//! The arm of a step: its actions, and its transitions.

use grafcet_compiler::model::{
    Association, Blinker, Effect, Id, Model, Place, Qualifier, Read, StepId, Transition, TransitionId,
};

use super::Case;
use crate::Refused;
use crate::st::Order;
use crate::st::action::{Phase, Role, assigned, role, run};
use crate::st::expr::{At, Kind, Moment, Remembers};
use crate::st::frame;
use crate::st::syntax::Statement;
use crate::st::text::{Text, all, any};
use crate::st::time::LONGEST;

impl<'m> Case<'m> {
    /// First its actions, then its transitions.
    pub(super) fn arm(&mut self, step: StepId) -> Result<Vec<Statement>, Refused> {
        let mut body = Vec::new();
        let actions = self.actions(step, &|_| true)?;
        if !actions.is_empty() {
            body.push(Statement::comment("Actions"));
            body.extend(actions);
        }
        let (transitions, count) = self.transitions(step)?;
        if count > 0 {
            if !body.is_empty() {
                body.push(Statement::Gap);
            }
            body.push(Statement::comment(if count > 1 { "Transitions" } else { "Transition" }));
            body.push(transitions);
        }
        Ok(body)
    }

    /// Its transitions, after what happens on an event while it is active.
    pub(super) fn evolving(&mut self, step: StepId) -> Result<Vec<Statement>, Refused> {
        let mut body = self.actions(step, &|role| role == Role::Event)?;
        let (transitions, count) = self.transitions(step)?;
        if count > 0 {
            body.push(transitions);
        }
        Ok(body)
    }

    /// Its actions alone.
    pub(super) fn acting(&mut self, step: StepId) -> Result<Vec<Statement>, Refused> {
        self.actions(step, &|role| role != Role::Event)
    }

    /// One branch each, and how many these are.
    fn transitions(&mut self, step: StepId) -> Result<(Statement, usize), Refused> {
        let mut branches = Vec::new();
        for id in &self.model.leaving[step.index()] {
            let transition = &self.model.transitions[*id];
            let condition = self.condition(step, transition)?;
            branches.push((condition, self.leave(step, *id)?));
        }
        // One that leads to its own step does nothing, but comes before those after it.
        while branches.last().is_some_and(|(_, then)| then.is_empty()) {
            branches.pop();
        }
        for (_, then) in branches.iter_mut().filter(|(_, then)| then.is_empty()) {
            then.push(Statement::comment("it stays, and what follows does not clear"));
        }
        let count = branches.len();
        Ok((Statement::If(branches, Vec::new()), count))
    }

    fn condition(&mut self, step: StepId, transition: &Transition) -> Result<String, Refused> {
        let active = |other| Some(truth(other == step));
        let at = At { active: &active, before: &self.nothing, times: true, mark: transition.mark };
        self.scope.remembers = self.remembers();
        let condition = self.scope.expr(&transition.condition, &Kind::Bool, &at);
        self.scope.remembers = Remembers::Inputs;
        Ok(condition?.text)
    }

    /// Of what edges and delays of transitions can be: in an `sfc` that evolves first nothing has changed in the scan yet.
    pub(super) fn remembers(&self) -> Remembers {
        let all = self.order == Order::EvolveFirst && !self.model.is_grafcet();
        if all { Remembers::All } else { Remembers::Steps }
    }

    /// What the step does in a scan: first what is done once, then the rest, in the end what is continuous.
    fn actions(&mut self, step: StepId, wanted: &dyn Fn(Role) -> bool) -> Result<Vec<Statement>, Refused> {
        if !self.model.is_grafcet() {
            self.scope.moment = Moment::Begun(step);
        }
        // What acts first sees what the transitions of the scan before have left, as the edges of this scan do.
        if !self.model.is_grafcet() && self.order == Order::ActFirst {
            self.scope.remembers = Remembers::Steps;
        }
        let actions = self.done_in(step, wanted);
        self.scope.remembers = Remembers::Inputs;
        self.scope.moment = Moment::Called;
        actions
    }

    fn done_in(&mut self, step: StepId, wanted: &dyn Fn(Role) -> bool) -> Result<Vec<Statement>, Refused> {
        let ids = &self.model.steps[step].associations;
        let (mut once, mut sets, mut resets, mut bodies, mut uses) = (vec![], vec![], vec![], vec![], false);
        let mut continuous: Vec<(Place, Vec<&'m Association>)> = Vec::new();
        for id in ids {
            let association = &self.model.associations[*id];
            let role = role(self.model, association)?;
            match role {
                _ if !wanted(role) => {}
                Role::Activation => {
                    let done = self.stored(step, association, Phase::First)?;
                    once.push(self.under(step, association, true, done)?);
                    uses = true;
                }
                Role::Event => {
                    self.scope.remembers = Remembers::Steps;
                    let done = self.stored(step, association, Phase::First)?;
                    bodies.push(self.under(step, association, false, done)?);
                    self.scope.remembers = Remembers::Inputs;
                }
                Role::Set(place) | Role::Reset(place) => {
                    let value = if association.qualifier == Qualifier::S { "TRUE" } else { "FALSE" };
                    let done = vec![Statement::assign(self.scope.place(place), value)];
                    // In a `grafcet` it happens once, which counts where something else can undo it.
                    let once =
                        self.model.is_grafcet() && (association.condition.is_some() || self.written[&place].otherwise);
                    uses |= once;
                    let done = self.under(step, association, once, done)?;
                    if association.qualifier == Qualifier::S { sets.push(done) } else { resets.push(done) }
                }
                Role::Body => {
                    let first = self.stored(step, association, Phase::First)?;
                    let again = self.stored(step, association, Phase::Repeated)?;
                    bodies.push(if first == again {
                        first
                    } else {
                        uses = true;
                        vec![Statement::If(vec![(self.entered.clone(), first)], again)]
                    });
                }
                Role::Continuous(place) => match continuous.iter_mut().find(|(at, _)| *at == place) {
                    Some((_, all)) => all.push(association),
                    None => continuous.push((place, vec![association])),
                },
                Role::Deactivation | Role::Nothing => {}
            }
        }
        let mut actions: Vec<Statement> = once.into_iter().chain(sets).chain(resets).chain(bodies).flatten().collect();
        for (place, associations) in continuous {
            uses |= associations.iter().any(|association| association.qualifier == Qualifier::P);
            actions.extend(self.continuous(step, place, &associations)?);
        }
        if uses {
            self.uses_entered = true;
            actions.push(Statement::assign(&*self.entered, "FALSE"));
        }
        Ok(actions)
    }

    /// What runs at an instant, as the step sees it.
    fn stored(&mut self, step: StepId, association: &Association, phase: Phase) -> Result<Vec<Statement>, Refused> {
        let sfc = !self.model.is_grafcet();
        let active = |other| sfc.then(|| truth(other == step));
        let at =
            At { active: &active, before: &self.nothing, times: sfc && phase != Phase::First, mark: association.mark };
        run(&mut self.scope, &association.effect, phase, &at)
    }

    /// Under its event and its condition, and in the first scan alone if it is done once.
    fn under(
        &mut self,
        step: StepId,
        association: &Association,
        once: bool,
        done: Vec<Statement>,
    ) -> Result<Vec<Statement>, Refused> {
        let sfc = !self.model.is_grafcet();
        let active = |other| sfc.then(|| truth(other == step));
        let at = At { active: &active, before: &self.nothing, times: sfc, mark: association.mark };
        let mut parts = Vec::new();
        if once {
            parts.push(Text::word(&*self.entered));
        }
        for condition in association.event.iter().chain(&association.condition) {
            parts.push(self.scope.expr(condition, &Kind::Bool, &at)?);
        }
        Ok(if parts.is_empty() { done } else { vec![Statement::when(all(parts).text, done)] })
    }

    /// A continuous action of one place, by all associations of the step.
    fn continuous(
        &mut self,
        step: StepId,
        place: Place,
        associations: &[&Association],
    ) -> Result<Vec<Statement>, Refused> {
        let name = self.scope.place(place).to_owned();
        let mut parts = Vec::new();
        for association in associations {
            let active = |other| Some(truth(other == step));
            let at = At { active: &active, before: &self.nothing, times: true, mark: association.mark };
            let mut part = Vec::new();
            if let Some(time) = association.time {
                let limit = self.scope.time(time, association.mark)?;
                let sign = if association.qualifier.limits() { "<" } else { ">=" };
                let timer = self.scope.timer(step);
                part.push(Text::order(format!("{timer}.ET {sign} {limit}")));
            }
            if association.qualifier == Qualifier::P {
                part.push(Text::word(&*self.entered));
            }
            if let Some(condition) = &association.condition {
                part.push(self.scope.expr(condition, &Kind::Bool, &at)?);
            }
            if let Effect::Assign(_, value) = &association.effect {
                let value = assigned(&mut self.scope, place, value, &at)?;
                let assign = vec![Statement::assign(&*name, value)];
                if part.is_empty() {
                    return Ok(assign);
                }
                let initial = frame::initial(&mut self.scope, place.into())?;
                return Ok(vec![Statement::If(vec![(all(part).text, assign)], vec![Statement::assign(name, initial)])]);
            }
            parts.push(all(part));
        }
        // One that is always true says it for all.
        let value = if parts.iter().any(|part| part.text == "TRUE") { Text::word("TRUE") } else { any(parts) };
        Ok(vec![Statement::assign(name, value.text)])
    }

    /// What a transition does: it ends what the step has done, and goes on.
    fn leave(&mut self, step: StepId, id: TransitionId) -> Result<Vec<Statement>, Refused> {
        let transition = &self.model.transitions[id];
        let (again, grafcet) = (transition.targets.contains(&step), self.model.is_grafcet());
        let (mut done, mut off) = (Vec::new(), Vec::new());
        // In a `grafcet` a step that is left and entered at once stays (A4g).
        if !(again && grafcet) {
            for id in &self.model.steps[step].associations {
                let association = &self.model.associations[*id];
                match role(self.model, association)? {
                    Role::Continuous(place) => {
                        let initial = frame::initial(&mut self.scope, place.into())?;
                        let statement = Statement::assign(self.scope.place(place), initial);
                        if !off.contains(&statement) {
                            off.push(statement);
                        }
                    }
                    Role::Deactivation => done.extend(self.last(association, Phase::First)?),
                    // The final scan; a step that is entered anew has none.
                    Role::Body if !again => done.extend(self.last(association, Phase::Final)?),
                    _ => {}
                }
            }
        }
        let nowhere = |_| None;
        for effect in &transition.clearing {
            let at = At { active: &nowhere, before: &self.nothing, times: false, mark: transition.mark };
            done.extend(run(&mut self.scope, effect, Phase::First, &at)?);
        }
        let mut all = off;
        all.extend(done);
        if again && grafcet {
            return Ok(all);
        }
        if again && timed(self.model, step) {
            let timer = self.scope.timer(step);
            all.push(Statement::Call(format!("{timer}(IN := FALSE, PT := {LONGEST})")));
        }
        if !again {
            let next = transition.targets.first().map_or(0, |target| self.number(*target));
            all.push(Statement::assign(&*self.step, next.to_string()));
        }
        let marks = self.entering(transition);
        if marks {
            self.uses_entered = true;
            all.push(Statement::assign(&*self.entered, "TRUE"));
        }
        Ok(all)
    }

    /// Whether the step that is entered asks whether it is in its first scan.
    fn entering(&self, transition: &Transition) -> bool {
        let asks = |association: &Association| match role(self.model, association) {
            Ok(Role::Activation) => true,
            Ok(Role::Set(place) | Role::Reset(place)) => {
                self.model.is_grafcet() && (association.condition.is_some() || self.written[&place].otherwise)
            }
            Ok(Role::Body) => matches!(association.effect, Effect::Call(..)),
            Ok(Role::Continuous(_)) => association.qualifier == Qualifier::P,
            _ => false,
        };
        let steps = transition.targets.iter().flat_map(|step| &self.model.steps[*step].associations);
        steps.into_iter().any(|id| asks(&self.model.associations[*id]))
    }

    /// What runs when the step is left.
    fn last(&mut self, association: &Association, phase: Phase) -> Result<Vec<Statement>, Refused> {
        let nowhere = |_| None;
        let at =
            At { active: &nowhere, before: &self.nothing, times: !self.model.is_grafcet(), mark: association.mark };
        let done = run(&mut self.scope, &association.effect, phase, &at)?;
        Ok(match &association.condition {
            Some(condition) => vec![Statement::when(self.scope.expr(condition, &Kind::Bool, &at)?.text, done)],
            None => done,
        })
    }
}

/// Whether something asks how long a step is active.
fn timed(model: &Model, step: StepId) -> bool {
    let asks = |read: &Read| match read {
        Read::Since(of) | Read::Elapsed(_, of) => *of == step,
        Read::Blink(blink) => blink.of == Blinker::Step(step),
        _ => false,
    };
    let conditions = model.transitions.values().map(|transition| &transition.condition.reads[..]);
    let actions = model.associations.values().flat_map(Association::reads);
    let limits = model.steps[step].associations.iter().any(|id| model.associations[*id].time.is_some());
    limits || conditions.chain(actions).flatten().any(asks)
}

fn truth(holds: bool) -> Text {
    Text::word(if holds { "TRUE" } else { "FALSE" })
}
