//! What steps do, as actions and boolean variables with qualifiers.
//!
//! A boolean that steps drive without conditions is named by itself. What depends on conditions and values is done by one action that the initial step
//! sets (S) and nothing resets, so that it runs in each scan: it asks which step is active. The standard lets a PLC do without the final call of an action,
//! which would have to switch off; and where a step ends while another with the same boolean is active, Beremiz lets the one
//! decide that stands after.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::diagnostic::Mark;
use grafcet_compiler::model::{Association, Effect, Expr, Id, Model, Place, Qualifier, Read, StepId, Transition};

use super::{Action, Block};
use crate::Refused;
use crate::st::action::{Phase, assigned, places, run};
use crate::st::expr::{At, Kind, Scope};
use crate::st::frame;
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, any};

/// How a place gets what continuous and stored actions give it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Style {
    /// It is itself the action of its steps.
    Boolean,
    /// N under conditions.
    Conditions,
    /// S and R under conditions, or of a place that begins as true.
    Stored,
    /// N of values.
    Values,
}

pub(super) struct Actions<'m, 's> {
    model: &'m Model,
    scope: &'s mut Scope<'m>,
    pub(super) all: Vec<Action>,
    /// By step.
    pub(super) blocks: Vec<Vec<Block>>,
    /// What is done in each scan.
    pub(super) always: Vec<Statement>,
    /// The places that it drives.
    driven: BTreeSet<Place>,
}

impl<'m, 's> Actions<'m, 's> {
    pub(super) fn new(model: &'m Model, scope: &'s mut Scope<'m>) -> Self {
        let blocks = vec![Vec::new(); model.steps.len()];
        Self { model, scope, all: Vec::new(), blocks, always: Vec::new(), driven: BTreeSet::new() }
    }

    /// All associations, in the order of the chart.
    pub(super) fn make(&mut self) -> Result<(), Vec<Refused>> {
        let mut refused = Vec::new();
        for association in self.model.associations.values() {
            if let Err(error) = self.association(association) {
                // What is wrong with a place is found at each of its steps.
                if !refused.iter().any(|other: &Refused| other.message == error.message) {
                    refused.push(error);
                }
            }
        }
        if refused.is_empty() { Ok(()) } else { Err(refused) }
    }

    fn association(&mut self, association: &'m Association) -> Result<(), Refused> {
        use Qualifier::{D, L, N, P, P0, P1};
        let (step, qualifier) = (association.step, association.qualifier);
        if let Some(place) = controlled(association) {
            return self.control(association, place);
        }
        match qualifier {
            P1 | P0 => {}
            N | P | L | D if association.condition.is_none() => {}
            N | P | L | D => {
                let message = format!(
                    "what runs under a condition has a final call of its own, which no action of IEC 61131-3 has: ask for the condition inside of it, as in `{} {{ if … {{ … }} }}`",
                    qualifier.word()
                );
                return Err(Refused::at(association.mark, message));
            }
            _ => {
                let message = format!(
                    "`{}` of what runs has no translation into SFC of IEC 61131-3: set a boolean and ask for it",
                    qualifier.word()
                );
                return Err(Refused::at(association.mark, message));
            }
        }
        let mut body = self.body(association)?;
        if let Some(condition) = &association.condition {
            let condition = self.condition(condition, step)?;
            body = vec![Statement::when(condition.text, body)];
        }
        let name = self.scope.names.own(&format!("{}_{}", self.step(step), qualifier.word()));
        self.all.push(Action { name: name.clone(), body });
        self.block(association, name)
    }

    fn step(&self, step: StepId) -> &str {
        self.scope.steps.as_ref().map_or("", |steps| &steps.names[step.index()])
    }

    fn block(&mut self, association: &Association, action: String) -> Result<(), Refused> {
        let time = association.time.map(|time| self.scope.time(time, association.mark)).transpose()?;
        let block = Block { qualifier: association.qualifier.word(), time, action };
        self.blocks[association.step.index()].push(block);
        Ok(())
    }

    /// What an action sees: the situation that the evolution has led to.
    fn see<T>(
        &mut self,
        step: StepId,
        mark: Mark,
        see: impl FnOnce(&mut Scope<'m>, &At<'_>) -> Result<T, Refused>,
    ) -> Result<T, Refused> {
        let names = self.scope.steps.as_mut().map(|steps| {
            steps.active = vec![step];
            steps.names.clone()
        });
        let names = names.unwrap_or_default();
        let active = |step: StepId| Some(Text::word(format!("{}.X", names[step.index()])));
        see(self.scope, &At { active: &active, before: &BTreeMap::new(), times: true, mark })
    }

    fn condition(&mut self, condition: &'m Expr, step: StepId) -> Result<Text, Refused> {
        no_edges(condition)?;
        self.see(step, condition.mark, |scope, at| scope.expr(condition, &Kind::Bool, at))
    }

    fn body(&mut self, association: &'m Association) -> Result<Vec<Statement>, Refused> {
        let step = association.step;
        let Effect::Call(action, arguments) = &association.effect else {
            return self.see(step, association.mark, |scope, at| run(scope, &association.effect, Phase::First, at));
        };
        let again = self
            .model
            .associations
            .values()
            .filter(|other| matches!(other.effect, Effect::Call(called, _) if called == *action));
        if again.count() > 1 {
            let name = &self.model.actions[*action].name;
            let message = format!(
                "`{name}` is called by several associations, and the chart makes one call of them: SFC of IEC 61131-3 has no arguments by step"
            );
            return Err(Refused::at(association.mark, message));
        }
        let running = match association.qualifier {
            Qualifier::P1 | Qualifier::P0 => "TRUE".to_owned(),
            _ => format!("{}.X", self.step(step)),
        };
        let told = (format!("run := {running}"), Variable::new("run", "BOOL").note("FALSE in the final call"));
        let call = self.see(step, association.mark, |scope, at| scope.call(*action, arguments, told, at))?;
        Ok(vec![call])
    }

    fn control(&mut self, association: &'m Association, place: Place) -> Result<(), Refused> {
        let style = style(self.model, place)?;
        if style == Style::Boolean {
            let name = self.scope.place(place).to_owned();
            return self.block(association, name);
        }
        if self.driven.insert(place) {
            let body = self.shared(place, style)?;
            self.always.extend(body);
        }
        Ok(())
    }

    /// What gives a place its value, whichever of its steps is active.
    fn shared(&mut self, place: Place, style: Style) -> Result<Vec<Statement>, Refused> {
        let target = self.scope.place(place).to_owned();
        let (mut terms, mut stored, mut reset, mut values) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for association in drivers(self.model, place) {
            let step = association.step;
            let mut parts = vec![Text::word(format!("{}.X", self.step(step)))];
            if let Some(condition) = &association.condition {
                parts.push(self.condition(condition, step)?);
            }
            let when = all(parts);
            match (&association.effect, association.qualifier) {
                (Effect::Assign(_, value), _) => {
                    no_edges(value)?;
                    let value = self.see(step, association.mark, |scope, at| assigned(scope, place, value, at))?;
                    values.push((when.text, vec![Statement::assign(&*target, value)]));
                }
                (_, Qualifier::S) => stored.push(Statement::when(when.text, vec![Statement::assign(&*target, "TRUE")])),
                (_, Qualifier::R) => reset.push(Statement::when(when.text, vec![Statement::assign(&*target, "FALSE")])),
                _ => terms.push(when),
            }
        }
        let body = match style {
            Style::Stored => stored.into_iter().chain(reset).collect(),
            Style::Values => {
                // The last one in the source counts.
                values.reverse();
                let initial = frame::initial(self.scope, place.into())?;
                vec![Statement::If(values, vec![Statement::assign(target, initial)])]
            }
            Style::Conditions | Style::Boolean => vec![Statement::assign(target, any(terms).text)],
        };
        Ok(body)
    }
}

/// The place that an association asserts, sets or resets, or gives a value as long as its step is active.
fn controlled(association: &Association) -> Option<Place> {
    match &association.effect {
        Effect::Control(place) => Some(*place),
        Effect::Assign(place @ Place::Output(_), _) if association.qualifier == Qualifier::N => Some(*place),
        _ => None,
    }
}

fn drivers(model: &Model, place: Place) -> impl Iterator<Item = &Association> {
    model.associations.values().filter(move |association| controlled(association) == Some(place))
}

/// How a place is driven; refused where the language has no such action.
fn style(model: &Model, place: Place) -> Result<Style, Refused> {
    let name = model.place_name(place);
    let refuse = |message: String| Err(Refused::at(name.into(), message));
    let all: Vec<&Association> = drivers(model, place).collect();
    let others = model.associations.values().filter(|association| controlled(association).is_none());
    if others.into_iter().any(|association| association.effect.writes().contains(&place)) {
        return refuse(format!(
            "`{name}` is controlled and assigned, too: an action of IEC 61131-3 would overwrite it in each scan"
        ));
    }
    let is_value = |association: &&Association| matches!(association.effect, Effect::Assign(..));
    let values = all.iter().copied().filter(|association| is_value(association)).count();
    if values > 0 {
        if values < all.len() {
            return refuse(format!("`{name}` is asserted and has values, too: give it values alone"));
        }
        return Ok(Style::Values);
    }
    for qualifier in Qualifier::ALL {
        let mut times = all.iter().filter(|association| association.qualifier == qualifier).map(|one| one.time);
        let first = times.next();
        if times.any(|time| Some(time) != first) {
            let word = qualifier.word();
            return refuse(format!("`{word}` of `{name}` has two times, which share a timer: give both the same one"));
        }
    }
    let is_of = |qualifiers: &[Qualifier]| all.iter().all(|association| qualifiers.contains(&association.qualifier));
    let stored = is_of(&[Qualifier::S, Qualifier::R]);
    let begins = model.may_start_true(place);
    let conditional = all.iter().find(|association| association.condition.is_some());
    match conditional {
        None if !begins && is_of(&[Qualifier::N]) && overlap(model, &all) => Ok(Style::Conditions),
        None if !begins => Ok(Style::Boolean),
        _ if stored => {
            let own = |condition: &Expr| places(&condition.tree).contains(&place);
            match all.iter().find(|association| association.condition.as_ref().is_some_and(own)) {
                Some(association) => {
                    let message = format!(
                        "whether `{name}` is set and reset depends on itself: IEC 61131-3 would ask one after the other"
                    );
                    Err(Refused::at(association.mark, message))
                }
                None => Ok(Style::Stored),
            }
        }
        _ if is_of(&[Qualifier::N]) => Ok(Style::Conditions),
        Some(association) => {
            let message = format!(
                "`if` beside other qualifiers of `{name}` has no translation into SFC of IEC 61131-3: ask for the condition in a transition, or let a variable hold one of both"
            );
            Err(Refused::at(association.mark, message))
        }
        None => refuse(format!(
            "`{name}` begins as true, and an action of IEC 61131-3 begins as false: set it in the initial step"
        )),
    }
}

/// Whether one of these steps can end in a scan in which another one is active.
fn overlap(model: &Model, all: &[&Association]) -> bool {
    let steps: Vec<StepId> = all.iter().map(|association| association.step).collect();
    let leads = |transition: &Transition| {
        let (from, to) = (&transition.sources, &transition.targets);
        from.iter().any(|one| steps.contains(one) && to.iter().any(|other| other != one && steps.contains(other)))
    };
    let facts = Facts::of(model);
    let beside = |(index, one): (usize, &StepId)| {
        steps[index + 1..].iter().any(|other| other != one && facts.concurrency.together(*one, *other))
    };
    model.transitions.values().any(leads) || steps.iter().enumerate().any(beside)
}

/// What was before is remembered by an action of its own, and which of two comes first nobody says.
fn no_edges(expr: &Expr) -> Result<(), Refused> {
    let mut edges = false;
    expr.tree.each_read(&mut |read| edges |= matches!(read, Read::Rising(_) | Read::Falling(_)));
    if edges {
        let message = "an edge in an action has no translation into SFC of IEC 61131-3, which does not say in which order actions run: ask for it in a transition";
        return Err(Refused::at(expr.mark, message));
    }
    Ok(())
}
