//! The form of flip-flops: each step is one, set by the transitions that lead to it, reset by those that leave it.
//!
//! - here: transitions, times, and the program as a whole
//! - `situation`: which steps are active, and what has become of them
//! - `hierarchy`: what enclosing steps and forcing orders do to it
//! - `control`: continuous and stored actions of booleans, the standard's `ACTION_CONTROL`
//! - `runs`: what runs: assignments, blocks, calls
//! - `shared`: calls of one action by several associations of an `sfc`
//! - `sees`: what actions see of steps, times and values
//! - `remembers`: edges and delays of what the chart itself changes

mod control;
mod hierarchy;
mod remembers;
mod runs;
mod sees;
mod shared;
mod situation;

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::analysis::combinational::in_order;
use grafcet_compiler::analysis::hierarchy::initial_situation;
use grafcet_compiler::model::{Effect, Id, Model, PartialId, Place, StepId, TransitionId};
use grafcet_compiler::sorted::Set;

use super::action::{Role, Written, places, reads, role, written};
use super::expr::{At, Kind, Remembers, Scope, plain};
use super::frame::{self, Frame};
use super::names::Names;
use super::syntax::{Program, Statement, Variable};
use super::text::{Text, all, any, not};
use super::time::LONGEST;
use super::{Options, header};
use crate::Refused;

/// The program of a chart: of one net, or of partial grafcets beside each other.
pub(super) fn program(model: &Model, options: &Options) -> Result<Program, Vec<Refused>> {
    let written = written(model)?;
    let mut refused = Vec::new();
    control::refused(model, &written, &mut refused);
    if !refused.is_empty() {
        return Err(refused);
    }
    Flags::new(model, options).program(&written).map_err(|error| vec![error])
}

/// Whether one step is active at a time, and each activation is that of a transition.
fn is_single(model: &Model) -> bool {
    if hierarchy::is_there(model) {
        return false;
    }
    let facts = Facts::of(model);
    let steps: Vec<StepId> = model.steps.ids().collect();
    let together = |(index, a): (usize, &StepId)| steps[index + 1..].iter().any(|b| facts.concurrency.together(*a, *b));
    let loose = model.transitions.values().any(|transition| transition.sources.is_empty());
    facts.initial.len() == 1 && !loose && !steps.iter().enumerate().any(together)
}

struct Flags<'m> {
    model: &'m Model,
    scope: Scope<'m>,
    frame: Frame,
    /// By step.
    steps: Vec<String>,
    /// By transition.
    transitions: Vec<String>,
    /// There has been a scan before.
    started: String,
    /// The input that begins anew.
    init: String,
    initial: Set<StepId>,
    /// By step, that it was active before the scan.
    was_names: Vec<String>,
    /// The steps of which somebody asks that.
    was: BTreeSet<StepId>,
    /// That edges have been looked at before, and that the scan before has left everything as it was, where a `grafcet` asks for them.
    looked: Option<String>,
    settled: Option<String>,
    /// By partial grafcet, that an order holds it.
    frozen: BTreeMap<PartialId, String>,
    /// By step, that it is activated in this scan, where somebody asks.
    activated: BTreeMap<StepId, String>,
    deactivated: BTreeMap<StepId, String>,
    /// Under which names actions read what was there before the scan.
    before: BTreeMap<Place, String>,
    single: bool,
    /// `sfc`: what is asked before the first action runs.
    conditions: Vec<Statement>,
    /// `sfc`: the variables that actions write.
    changed: BTreeSet<Place>,
}

impl<'m> Flags<'m> {
    fn new(model: &'m Model, options: &Options) -> Self {
        let mut names = Names::new();
        let init = names.own(&options.init);
        let mut scope = Scope::new(model, names);
        let steps = model.steps.values().map(|step| scope.names.own(&format!("SR_{}", plain(&step.name)))).collect();
        let transitions =
            (1..=model.transitions.len()).map(|number| scope.names.own(&format!("Tr_{number}"))).collect();
        let was_names =
            model.steps.values().map(|step| scope.names.own(&format!("Was_{}", plain(&step.name)))).collect();
        let started = scope.names.own("Started");
        scope.remembers = Remembers::All;
        Self {
            model,
            scope,
            frame: Frame::default(),
            steps,
            transitions,
            started,
            init,
            initial: initial_situation(model),
            was_names,
            was: BTreeSet::new(),
            looked: None,
            settled: None,
            frozen: BTreeMap::new(),
            activated: BTreeMap::new(),
            deactivated: BTreeMap::new(),
            before: BTreeMap::new(),
            single: is_single(model),
            conditions: Vec::new(),
            changed: model
                .associations
                .values()
                .flat_map(|one| one.effect.writes())
                .copied()
                .filter(|place| !model.is_grafcet() && matches!(place, Place::Var(_)))
                .collect(),
        }
    }

    fn flag(&self, step: StepId) -> Text {
        Text::word(&*self.steps[step.index()])
    }

    fn transition(&self, id: TransitionId) -> Text {
        Text::word(&*self.transitions[id.index()])
    }

    fn program(mut self, written: &BTreeMap<Place, Written>) -> Result<Program, Refused> {
        let model = self.model;
        self.scope.shared = shared(model);
        if !model.is_grafcet() {
            self.scope.reentered = model.steps.ids().filter(|step| self.may_reenter(*step)).collect();
        }
        let name = self.scope.names.of_chart(&plain(&model.name));
        self.copies(written);
        for id in model.steps.ids() {
            let init = if self.initial.contains(&id) { "TRUE" } else { "FALSE" };
            self.frame.remember(Variable::new(&*self.steps[id.index()], "BOOL").init(init));
        }
        self.frame.remember(Variable::new(&*self.started, "BOOL").init("FALSE").note("there has been a scan before"));
        let following = self.following()?;
        let mut transitions = self.frozen();
        transitions.extend(self.transitions()?);
        let [instants, actions] = self.actions(written)?;
        let situation = self.situation();
        let (acting, own) = self.memory()?;
        let ended = self.ended();
        let restarts = self.restarts();
        let (changes, moved) = (self.changes(), self.moved_changes());
        let was = self.remembered();
        let mut before = self.frame.edges(&mut self.scope, &self.started)?;
        before.extend(self.frame.delays(&mut self.scope)?);
        let timers = self.timers();
        let follows: BTreeSet<Place> = in_order(model).into_iter().map(Place::Var).collect();
        let mut copies: Vec<Statement> = Vec::new();
        for (place, copy) in &self.before {
            let mut value = Text::word(self.scope.place(*place));
            // Before the initial situation is activated, no step is.
            if follows.contains(place) {
                value = all(vec![Text::word(&*self.started), value]);
            }
            copies.push(Statement::assign(&**copy, value.text));
        }
        let mut program = Program { name, ..Program::default() };
        program.inputs.push(Variable::new(&*self.init, "BOOL").note("back into the initial situation"));
        let mut frame = std::mem::take(&mut self.frame);
        frame::declare(&mut self.scope, &mut program, &mut frame, |place| written.contains_key(&place))?;
        program.variables.append(&mut self.scope.copies);
        for (instance, block) in self.scope.instances.values() {
            program.variables.push(Variable::new(instance, block));
        }
        program.variables.extend(frame.variables);
        let body = &mut program.body;
        body.extend([
            Statement::comment("Back to the beginning"),
            Statement::when(&*self.init, frame.init),
            Statement::Gap,
        ]);
        part(body, "Edges and delays of inputs", before);
        part(body, "The times of steps, to be read", timers.clone());
        for (heading, statements) in self.looked_at(following, own) {
            part(body, heading, statements);
        }
        part(body, "What actions read as it was before the scan", copies);
        part(body, "Transitions: predecessor and condition", transitions);
        part(body, "What is activated and deactivated", changes);
        part(body, "Steps before the scan", was);
        part(body, "Steps: set by what leads to them, reset by what leaves them", situation);
        part(body, "What has been activated and deactivated by transitions, orders and enclosing steps", moved);
        part(body, "A step that is entered anew begins its time anew", restarts);
        part(body, "Edges that actions ask for, of what there is after the evolution", acting);
        acting_parts(body, model, timers, [instants, actions]);
        body.extend(ended);
        program.header = header::flags(model, &self.scope);
        program.renamed = self.scope.names.renamed.into_iter().collect();
        program.stubs = self.scope.stubs;
        Ok(program)
    }

    /// What actions read, and others write in the same moment.
    fn copies(&mut self, written: &BTreeMap<Place, Written>) {
        let mut read = BTreeSet::new();
        for association in self.model.associations.values() {
            let stored = !matches!(role(self.model, association), Ok(Role::Continuous(_)));
            if self.model.is_grafcet() && !stored {
                continue;
            }
            read.extend(reads(&association.effect));
            let conditions = association.condition.iter().chain(&association.event);
            read.extend(conditions.flat_map(|condition| places(&condition.tree)));
        }
        for effect in self.model.transitions.values().flat_map(|transition| &transition.clearing) {
            read.extend(reads(effect));
        }
        // What is stored tells whether a scan has left everything as it was.
        if self.samples_once() {
            read.extend(written.iter().filter(|(_, how)| !how.continuous).map(|(place, _)| *place));
        }
        // In an `sfc` a variable that one action writes the next one sees.
        read.retain(|place| {
            written.contains_key(place) && (self.model.is_grafcet() || matches!(place, Place::Output(_)))
        });
        for place in read {
            let name = self.scope.names.own(&format!("{}_before", self.scope.place(place)));
            let ty = super::expr::kind_of(self.model, place.into()).map_or("DINT", |kind| kind.name());
            self.frame.variables.push(Variable::new(&*name, ty));
            self.before.insert(place, name);
        }
    }

    fn transitions(&mut self) -> Result<Vec<Statement>, Refused> {
        let (model, nothing) = (self.model, BTreeMap::new());
        let mut statements = Vec::new();
        for (id, transition) in model.transitions.iter() {
            let steps = self.steps.clone();
            let active = |step: StepId| Some(Text::word(&*steps[step.index()]));
            let at = At { active: &active, before: &nothing, times: true, mark: transition.mark };
            let mut parts = vec![Text::word(&*self.started)];
            parts.extend(self.lets_clear(transition));
            parts.extend(transition.sources.iter().map(|step| self.flag(*step)));
            parts.push(self.scope.expr(&transition.condition, &Kind::Bool, &at)?);
            if !model.is_grafcet() {
                // The order in the source is the priority.
                let shares = |other: &TransitionId| {
                    *other < id
                        && model.transitions[*other].sources.iter().any(|step| transition.sources.contains(step))
                };
                parts.extend(model.transitions.ids().filter(shares).map(|other| not(self.transition(other))));
            }
            let names = |steps: &[StepId]| {
                let names: Vec<String> = steps.iter().map(|step| plain(&model.steps[*step].name)).collect();
                if names.is_empty() { "()".to_owned() } else { names.join(", ") }
            };
            let note = format!("{} to {}", names(&transition.sources), names(&transition.targets));
            let name = self.transitions[id.index()].clone();
            self.frame.variables.push(Variable::new(&*name, "BOOL").note(note));
            statements.push(Statement::assign(name, all(parts).text));
        }
        Ok(statements)
    }

    /// The timers of steps and of macro-steps, which run as long as these are active.
    fn timers(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        for (step, timer) in self.scope.timers.clone() {
            self.frame.timer(&timer, &format!("how long {} is active", plain(&self.model.steps[step].name)));
            let active = &self.steps[step.index()];
            statements.push(Statement::Call(format!("{timer}(IN := {active}, PT := {LONGEST})")));
        }
        for (id, timer) in self.scope.macro_timers.clone() {
            let of = &self.model.macros[id];
            self.frame.timer(&timer, &format!("how long {} is active", plain(&of.name)));
            let active = any(of.steps.iter().map(|step| self.flag(*step)).collect());
            statements.push(Statement::Call(format!("{timer}(IN := {}, PT := {LONGEST})", active.text)));
        }
        statements
    }

    /// A step that is left and entered anew begins its time anew; in a `grafcet` it stays.
    fn restarts(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        for (step, timer) in self.scope.timers.clone() {
            if self.scope.reentered.contains(&step) {
                if let Some(reached) = self.scope.reached.get(&step) {
                    let note = format!("the time that {} had reached", plain(&self.model.steps[step].name));
                    self.frame.variables.push(Variable::new(&**reached, "TIME").note(note));
                    statements.push(Statement::assign(&**reached, format!("{timer}.ET")));
                }
                let again = self.again(step);
                statements.push(Statement::when(
                    again.text,
                    vec![Statement::Call(format!("{timer}(IN := FALSE, PT := {LONGEST})"))],
                ));
            }
        }
        statements
    }

    fn again(&mut self, step: StepId) -> Text {
        all(vec![self.activated(step), self.deactivated(step)])
    }
}

/// The actions, and the times that begin with the steps.
fn acting_parts(
    body: &mut Vec<Statement>,
    model: &Model,
    timers: Vec<Statement>,
    [instants, actions]: [Vec<Statement>; 2],
) {
    // In a `grafcet` what lasts sees the times of the situation that has been reached.
    let begin = "The times of steps, which begin with the step";
    if model.is_grafcet() && !timers.is_empty() {
        part(body, "Actions at an instant", instants);
        part(body, begin, timers);
        part(body, "Actions", actions);
    } else {
        part(body, "Actions", instants.into_iter().chain(actions).collect());
        part(body, begin, timers);
    }
}

/// What several associations and transitions write.
fn shared(model: &Model) -> BTreeSet<Place> {
    let associations = model.associations.values().map(|association| association.effect.writes());
    let clearing = model.transitions.values().flat_map(|one| &one.clearing).map(Effect::writes);
    let (mut once, mut shared) = (BTreeSet::new(), BTreeSet::new());
    for place in associations.chain(clearing).flatten() {
        if !once.insert(*place) {
            shared.insert(*place);
        }
    }
    shared
}

/// A part of the program under a heading, where there is something.
fn part(body: &mut Vec<Statement>, heading: &str, statements: Vec<Statement>) {
    if !statements.is_empty() {
        body.push(Statement::comment(heading));
        body.extend(statements);
        body.push(Statement::Gap);
    }
}
