//! The CASE form: in each step first its actions, then its transitions; or one CASE for the transitions, and another one after it for the actions.

mod arm;
mod fits;
mod order;

use std::collections::BTreeMap;

use grafcet_compiler::model::{Id, Model, Place, StepId};

use super::action::{Written, written};
use super::expr::{Moment, Scope, plain};
use super::frame::{self, Frame};
use super::memory::{Look, in_a_row, is_of_inputs};
use super::names::Names;
use super::syntax::{Arm, Program, Statement, Variable};
use super::text::{Text, strength};
use super::time::LONGEST;
use super::{Options, Order, header};
use crate::Refused;

/// The program of a chart of which one step is active at a time.
pub(super) fn program(model: &Model, options: &Options) -> Result<Program, Vec<Refused>> {
    let written = written(model)?;
    let mut refused = fits::refused(model, &written);
    if refused.is_empty() && options.order == Some(Order::EvolveFirst) {
        order::evolving(model, &mut refused);
    }
    let steps = u64::try_from(model.steps.len()).unwrap_or(u64::MAX);
    if u64::from(options.numbers.0).saturating_add(steps.saturating_mul(options.numbers.1.into())) > 1 << 31 {
        refused.push(Refused::whole("the numbers of the steps do not fit into 32 bits: choose smaller ones"));
    }
    if !refused.is_empty() {
        return Err(refused);
    }
    Case::new(model, options, written).program().map_err(|error| vec![error])
}

struct Case<'m> {
    model: &'m Model,
    scope: Scope<'m>,
    written: BTreeMap<Place, Written>,
    numbers: (u32, u32),
    step: String,
    /// The input that begins anew.
    init: String,
    /// That the step is in its first scan.
    entered: String,
    uses_entered: bool,
    nothing: BTreeMap<Place, String>,
    order: Order,
}

impl<'m> Case<'m> {
    fn new(model: &'m Model, options: &Options, written: BTreeMap<Place, Written>) -> Self {
        let mut names = Names::new();
        let (step, init) = (names.own(&options.step), names.own(&options.init));
        let mut scope = Scope::new(model, names);
        let entered = scope.names.own("Entered");
        Self {
            model,
            scope,
            written,
            numbers: options.numbers,
            step,
            init,
            entered,
            uses_entered: false,
            nothing: BTreeMap::new(),
            order: options.order.unwrap_or(Order::ActFirst),
        }
    }

    fn number(&self, step: StepId) -> u32 {
        let index = u32::try_from(step.index()).unwrap_or(u32::MAX);
        self.numbers.0.saturating_add(self.numbers.1.saturating_mul(index))
    }

    /// An arm for each step.
    fn arms(
        &mut self,
        body: impl Fn(&mut Self, StepId) -> Result<Vec<Statement>, Refused>,
    ) -> Result<Vec<Arm>, Refused> {
        let mut arms = Vec::new();
        for (id, step) in self.model.steps.iter() {
            let kind = if step.initial { ", initial" } else { "" };
            let (number, title) = (self.number(id), format!("{}{kind}", plain(&step.name)));
            arms.push(Arm { number, title, body: body(self, id)? });
        }
        Ok(arms)
    }

    fn program(mut self) -> Result<Program, Refused> {
        let model = self.model;
        let name = self.scope.names.of_chart(&plain(&model.name));
        let sequence = match self.order {
            Order::ActFirst => [self.arms(Self::arm)?, Vec::new()],
            Order::EvolveFirst => [self.arms(Self::evolving)?, self.arms(Self::acting)?],
        };
        let mut frame = Frame::default();
        let initial = model.steps.iter().find(|(_, step)| step.initial).map_or(0, |(id, _)| self.number(id));
        let last = model.steps.ids().next_back().map_or(0, |step| self.number(step));
        // 16 bits are enough for most.
        let ty = if last <= 32_767 { "INT" } else { "DINT" };
        frame.remember(Variable::new(&self.step, ty).init(initial.to_string()).note("the active step"));
        if self.uses_entered {
            frame.remember(Variable::new(&self.entered, "BOOL").init("TRUE").note("the step is in its first scan"));
        }
        let started = self.scope.names.own("Started");
        let own = self.memory(&mut frame, &started)?;
        let edges = frame.edges(&mut self.scope, &started)?;
        let evolves_first = self.order == Order::EvolveFirst;
        let remembers = !edges.is_empty() || !own.is_empty();
        if remembers || evolves_first {
            frame.remember(Variable::new(&started, "BOOL").init("FALSE").note("there has been a scan before"));
        }
        let mut before = edges;
        before.extend(frame.delays(&mut self.scope)?);
        let timers = self.timers(&mut frame);
        let mut program = Program { name, ..Program::default() };
        program.inputs.push(Variable::new(&self.init, "BOOL").note("back into the initial situation"));
        let written = &self.written;
        frame::declare(&mut self.scope, &mut program, &mut frame, |place| written.contains_key(&place))?;
        for (instance, block) in self.scope.instances.values() {
            program.variables.push(Variable::new(instance, block));
        }
        program.variables.extend(frame.variables);
        let body = &mut program.body;
        body.extend([
            Statement::comment("Back to the beginning"),
            Statement::when(self.init.clone(), frame.init),
            Statement::Gap,
        ]);
        part(body, "Edges and delays of inputs", before);
        part(body, "The times of steps, to be read", timers.clone());
        part(body, "Edges and delays of what the chart itself changes", own);
        let [first, second] = sequence;
        if evolves_first {
            let evolve = vec![Statement::Case(self.step.clone(), first)];
            part(body, "Transitions, but in the first scan", vec![Statement::when(&*started, evolve)]);
            part(body, "The times of steps, which begin with the step", timers);
            part(body, "Actions", vec![Statement::Case(self.step.clone(), second)]);
            body.push(Statement::assign(started, "TRUE"));
        } else {
            part(body, "The sequence", vec![Statement::Case(self.step.clone(), first)]);
            part(body, "The times of steps, which begin with the step", timers);
            if remembers {
                body.push(Statement::assign(started, "TRUE"));
            }
        }
        if body.last() == Some(&Statement::Gap) {
            body.pop();
        }
        program.header = header::case(model, &self.scope, self.order);
        program.renamed = self.scope.names.renamed.into_iter().collect();
        program.stubs = self.scope.stubs;
        Ok(program)
    }
}

impl Case<'_> {
    /// Edges and delays of steps, as these are before the scan.
    fn memory(&mut self, frame: &mut Frame, started: &str) -> Result<Vec<Statement>, Refused> {
        let numbers: Vec<String> =
            self.model.steps.ids().map(|step| format!("{} = {}", self.step, self.number(step))).collect();
        let active = |step: StepId| Some(Text { text: numbers[step.index()].clone(), strength: strength::EQUAL });
        self.scope.remembers = self.remembers();
        // In a `grafcet` a delay is looked at once in a cycle, and not on what the chart only passes.
        let once = self.model.is_grafcet() && self.scope.delays.keys().any(|id| !is_of_inputs(self.model, *id));
        let before = self.scope.names.own(&format!("{}_before", self.step));
        let settled = format!("{} = {before}", self.step);
        let look = Look { active: &active, again: started, settled: once.then_some(&*settled), moment: Moment::Called };
        let mut own = in_a_row(frame.own_memory(&mut self.scope, &look)?);
        if once {
            let initial = self.model.steps.iter().find(|(_, step)| step.initial).map_or(0, |(id, _)| self.number(id));
            let variable = Variable::new(&*before, "DINT").init(initial.to_string());
            frame.remember(variable.note("in the scan before"));
            own.push(Statement::assign(before, &*self.step));
        }
        Ok(own)
    }

    /// The timers of steps and of macro-steps, which run as long as these are active.
    fn timers(&self, frame: &mut Frame) -> Vec<Statement> {
        let model = self.model;
        let is = |step: &StepId| format!("{} = {}", self.step, self.number(*step));
        let mut timers = Vec::new();
        for (step, timer) in &self.scope.timers {
            frame.timer(timer, &format!("how long {} is active", plain(&model.steps[*step].name)));
            timers.push(Statement::Call(format!("{timer}(IN := {}, PT := {LONGEST})", is(step))));
        }
        for (id, timer) in &self.scope.macro_timers {
            frame.timer(timer, &format!("how long {} is active", plain(&model.macros[*id].name)));
            let active: Vec<String> = model.macros[*id].steps.iter().map(is).collect();
            timers.push(Statement::Call(format!("{timer}(IN := {}, PT := {LONGEST})", active.join(" OR "))));
        }
        timers
    }
}

/// A part of the program under a heading, where there is something.
fn part(body: &mut Vec<Statement>, heading: &str, statements: Vec<Statement>) {
    if !statements.is_empty() {
        body.push(Statement::comment(heading));
        body.extend(statements);
        body.push(Statement::Gap);
    }
}
