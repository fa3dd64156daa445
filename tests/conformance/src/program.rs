//! The program of a chart, naive or after some passes, beside the interpreter of the model, without rustc.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::analysis::{Facts, combinational};
use grafcet_compiler::model::{Id, Model, OutputId, StepId, TransitionId, Ty, VarId};
use grafcet_compiler::program::passes::{Pass, optimise};
use grafcet_compiler::program::run::{Call, Cycle, Machine, Nothing};
use grafcet_compiler::program::{Mark, Phase, PlaceId, Program, Role, Value, naive};

use crate::oracle::Interpreted;
use crate::reader::{Kind, Line};
use crate::{Shown, Subject, Values, asleep, play};
use grafcet_sim::interp::{self, Interpreter};

/// A program as a chart that runs.
pub struct Programmed<'p, 'm> {
    program: &'p Program<'m>,
    machine: Machine<'p, 'm>,
    outputs: Vec<PlaceId>,
    vars: Vec<PlaceId>,
    stable: Option<PlaceId>,
    names: Names,
    /// What outputs show between `init` and the next cycle, where no field keeps them: a cycle returns them, and begins with what is best for it.
    initial: Option<BTreeMap<String, i128>>,
}

/// The names of a chart as text, which is asked for in every cycle.
struct Names {
    inputs: Vec<String>,
    outputs: Vec<String>,
    steps: Vec<String>,
}

impl<'p, 'm> Programmed<'p, 'm> {
    /// In its initial situation.
    ///
    /// # Errors
    /// An initial value is not understood.
    pub fn new(program: &'p Program<'m>) -> Result<Self, String> {
        let machine = Machine::new(program, &mut Nothing).map_err(|error| error.to_string())?;
        let (mut outputs, mut vars) = (Vec::new(), Vec::new());
        for (index, place) in program.places.iter().enumerate() {
            match place.role {
                Role::Output(_) => outputs.push(PlaceId(index)),
                Role::Var(_) => vars.push(PlaceId(index)),
                _ => {}
            }
        }
        let model = program.model;
        let names = Names {
            inputs: model.inputs.values().map(|input| plain(&input.name)).collect(),
            outputs: model.outputs.values().map(|output| plain(&output.name)).collect(),
            steps: model.steps.values().map(|step| plain(&step.name)).collect(),
        };
        Ok(Self { program, machine, outputs, vars, stable: program.place(Role::Stable), names, initial: None })
    }

    fn step(&mut self, inputs: &Values, now: u32) -> Result<Cycle, String> {
        let model = self.program.model;
        let inputs = model.inputs.values().zip(&self.names.inputs).map(|(i, name)| value(given(inputs, name), &i.ty));
        let inputs: Vec<Value> = inputs.collect();
        self.initial = None;
        self.machine.cycle(&inputs, now, &mut Nothing).map_err(|error| error.to_string())
    }

    fn is_stable(&self) -> bool {
        self.stable.is_none_or(|place| self.machine.value(place) == Value::Bool(true))
    }

    /// In the order of declaration.
    fn output(&self, id: OutputId) -> Value {
        self.machine.value(self.outputs[id.index()])
    }

    fn var(&self, id: VarId) -> Value {
        self.machine.value(self.vars[id.index()])
    }
}

impl Subject for Programmed<'_, '_> {
    fn cycle(&mut self, inputs: &Values, now: u32) -> Result<Shown, String> {
        let cycle = self.step(inputs, now)?;
        let calls = cycle.calls.iter().map(|call| written(self.program.model, call)).collect();
        Ok(Shown { calls, stable: self.is_stable(), ..self.shown() })
    }

    fn init(&mut self) -> Result<(), String> {
        self.machine.init();
        self.initial = Interpreted::new(self.program.model).ok().map(|fresh| fresh.shown().outputs);
        Ok(())
    }

    fn set_params(&mut self, changed: &Values) -> Result<(), String> {
        for (id, param) in self.program.model.params.iter() {
            if let (Some(new), Some(place)) = (changed.get(&plain(&param.name)), self.program.place(Role::Param(id))) {
                self.machine.set(place, value(*new, &param.ty));
            }
        }
        Ok(())
    }

    fn shown(&self) -> Shown {
        let mut outputs = BTreeMap::new();
        for (id, name) in self.program.model.outputs.ids().zip(&self.names.outputs) {
            let kept = self.program.places[self.outputs[id.index()].0].is_field;
            let value = match &self.initial {
                Some(initial) if !kept => initial.get(name).copied().unwrap_or_default(),
                _ => number(self.output(id)),
            };
            if value != 0 {
                outputs.insert(name.clone(), value);
            }
        }
        for step in self.machine.late_steps(&mut Nothing).unwrap_or_default() {
            outputs.insert(format!("late({})", self.names.steps[step.index()]), 1);
        }
        let steps = self.machine.active().iter().map(|step| self.names.steps[step.index()].clone()).collect();
        Shown { steps, stable: true, outputs, calls: Vec::new() }
    }

    fn next_deadline(&self) -> Option<u32> {
        self.machine.next_deadline(&mut Nothing).unwrap_or_default()
    }
}

/// What is compared of one cycle.
#[derive(PartialEq, Eq, Debug)]
struct Seen {
    active: Vec<StepId>,
    late: Vec<StepId>,
    outputs: Vec<i128>,
    vars: Vec<i128>,
    calls: Vec<String>,
    stable: bool,
    /// What has cleared, evolution by evolution.
    evolutions: Vec<BTreeSet<TransitionId>>,
}

/// How a comparison ended.
pub enum Outcome {
    /// Without a difference.
    Same,
    /// The interpreter refuses the chart, or it has come to arithmetic that would panic: from there on nothing is compared.
    NotUnderstood(String),
}

/// The program of a chart after some passes.
///
/// # Errors
/// It has none.
pub fn program<'m>(model: &'m Model, passes: &[Pass]) -> Result<Program<'m>, String> {
    let mut program = naive(model, &Facts::of(model)).map_err(|refused| refused.to_string())?;
    optimise(&mut program, passes);
    Ok(program)
}

/// Plays a timeline on the program of a chart after some passes and on the interpreter.
///
/// # Errors
/// The first difference.
pub fn compare(model: &Model, lines: &[Line], passes: &[Pass]) -> Result<Outcome, String> {
    let mut oracle = match Interpreter::new(model) {
        Ok(oracle) => oracle,
        Err(error) => return Ok(Outcome::NotUnderstood(error.to_string())),
    };
    let program = program(model, passes)?;
    let tells = !passes.contains(&Pass::Marks);
    let mut subject = Programmed::new(&program)?;
    let held: Vec<VarId> = model.vars.ids().filter(|id| !combinational::in_order(model).contains(id)).collect();
    for line in lines {
        let at = |what: String| format!("line {}: {}\n  {what}", line.number, line.text());
        match &line.kind {
            Kind::Init => {
                oracle.init().map_err(|error| at(error.to_string()))?;
                subject.init()?;
            }
            Kind::Params(changed) => {
                let params = model.params.values().zip(oracle.params());
                let new = params.map(|(param, old)| match changed.get(&plain(&param.name)) {
                    Some(new) => other(value(*new, &param.ty)),
                    None => *old,
                });
                oracle.set_params(&new.collect::<Vec<_>>()).map_err(|error| at(error.to_string()))?;
                subject.set_params(changed)?;
            }
            Kind::Shows(_) | Kind::Wakes(_) | Kind::Refuses(_) => {}
            // As for `without_force`.
            Kind::Cycle { inputs, now, .. } | Kind::Force { inputs, now, .. } => {
                let values = model.inputs.values().map(|i| other(value(given(inputs, &plain(&i.name)), &i.ty)));
                let expected = match oracle.cycle(&values.collect::<Vec<_>>(), *now) {
                    Ok(cycle) => cycle,
                    Err(error) => return Ok(Outcome::NotUnderstood(error.to_string())),
                };
                let found = subject.step(inputs, *now).map_err(at)?;
                let mut expected = of_oracle(model, &expected, &held, &oracle);
                if !tells {
                    expected.evolutions.clear();
                }
                let found = of_program(&subject, &found, &held);
                if expected != found {
                    return Err(at(format!("interpreter {expected:?}\n  program     {found:?}")));
                }
            }
        }
    }
    Ok(Outcome::Same)
}

/// Plays a timeline on a program that is scanned at every tick, and on one that sleeps until its deadline.
///
/// # Errors
/// The first difference.
pub fn sleeps(model: &Model, lines: &[Line], passes: &[Pass]) -> Result<(), String> {
    let program = program(model, passes)?;
    if program.deadline.is_none() {
        return Ok(());
    }
    let (mut first, mut second) = (Programmed::new(&program)?, Programmed::new(&program)?);
    asleep::compare(&mut first, &mut second, &without_force(lines)).map_err(|difference| difference.to_string())
}

/// Plays a timeline on the program and on the interpreter, which also says whether a cycle leaves something to the next one.
///
/// # Errors
/// The first difference.
pub fn rests(model: &Model, lines: &[Line], passes: &[Pass]) -> Result<(), String> {
    let program = program(model, passes)?;
    let Ok(mut oracle) = Interpreted::new(model) else { return Ok(()) };
    match play::in_lockstep(&mut Programmed::new(&program)?, &mut oracle, &without_force(lines)) {
        // Arithmetic that leaves its type.
        Err(difference) if difference.expected.starts_with("no error") => Ok(()),
        other => other.map_err(|difference| difference.to_string()),
    }
}

/// A program knows nothing of forcing: where a chart would be put into a situation by hand, it makes a cycle as any other.
fn without_force(lines: &[Line]) -> Vec<Line> {
    let mut lines = lines.to_vec();
    for line in &mut lines {
        if let Kind::Force { inputs, now, expected, .. } = &line.kind {
            line.kind = Kind::Cycle { inputs: inputs.clone(), now: *now, expected: expected.clone() };
        }
    }
    lines
}

fn of_oracle(model: &Model, cycle: &interp::Cycle, held: &[VarId], oracle: &Interpreter<'_>) -> Seen {
    let vars = oracle.vars();
    let mut evolutions: Vec<_> = cycle.seen.iter().map(|evolution| evolution.cleared.clone()).collect();
    // Of a search the last one has not taken place, of an `sfc` one that clears nothing.
    if model.is_grafcet() {
        evolutions.truncate(cycle.evolutions as usize);
    } else {
        evolutions.retain(|cleared| !cleared.is_empty());
    }
    let calls = cycle.calls.iter().map(|call| {
        let args = call.args.iter().map(|arg| back(*arg)).collect();
        let phase = match call.phase {
            interp::Phase::First => Phase::First,
            interp::Phase::Repeated => Phase::Repeated,
            interp::Phase::Final => Phase::Final,
        };
        written(model, &Call { action: call.action, phase, args })
    });
    Seen {
        active: cycle.active.iter().copied().collect(),
        late: oracle.late_steps(),
        outputs: cycle.outputs.iter().map(|value| number(back(*value))).collect(),
        vars: held.iter().map(|id| number(back(vars[id.index()]))).collect(),
        calls: calls.collect(),
        stable: cycle.stable,
        evolutions,
    }
}

fn of_program(subject: &Programmed<'_, '_>, cycle: &Cycle, held: &[VarId]) -> Seen {
    let (mut evolutions, mut cleared) = (Vec::new(), BTreeSet::new());
    for mark in &cycle.marks {
        match mark {
            Mark::Cleared(id) => _ = cleared.insert(*id),
            Mark::Evolved => evolutions.push(std::mem::take(&mut cleared)),
            Mark::Activated(_) | Mark::Deactivated(_) => {}
        }
    }
    let model = subject.program.model;
    Seen {
        active: subject.machine.active(),
        late: subject.machine.late_steps(&mut Nothing).unwrap_or_default(),
        outputs: model.outputs.ids().map(|id| number(subject.output(id))).collect(),
        vars: held.iter().map(|id| number(subject.var(*id))).collect(),
        calls: cycle.calls.iter().map(|call| written(model, call)).collect(),
        stable: subject.is_stable(),
        evolutions,
    }
}

fn written(model: &Model, call: &Call) -> String {
    let phase = match call.phase {
        Phase::First => "first",
        Phase::Repeated => "repeated",
        Phase::Final => "final",
    };
    let args: Vec<String> = call.args.iter().map(|arg| number(*arg).to_string()).collect();
    format!("{phase} {}({})", plain(&model.actions[call.action].name), args.join(","))
}

pub(crate) fn plain(name: &proc_macro2::Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

/// What a timeline does not name is false or zero.
pub(crate) fn given(values: &Values, name: &str) -> i128 {
    values.get(name).copied().unwrap_or_default()
}

pub(crate) fn value(number: i128, ty: &Ty) -> Value {
    match ty {
        Ty::Bool(_) => Value::Bool(number != 0),
        Ty::Time(_) => Value::Ticks(u32::try_from(number).unwrap_or(u32::MAX)),
        _ => Value::Int(number),
    }
}

/// The same value in the interpreter's words.
fn other(value: Value) -> interp::Value {
    match value {
        Value::Bool(value) => interp::Value::Bool(value),
        Value::Ticks(ticks) => interp::Value::Ticks(ticks),
        other => interp::Value::Int(number(other)),
    }
}

fn back(value: interp::Value) -> Value {
    match value {
        interp::Value::Bool(value) => Value::Bool(value),
        interp::Value::Ticks(ticks) => Value::Ticks(ticks),
        interp::Value::Int(number) => Value::Int(number),
        other => unreachable!("no chart of the comparison has a {other:?}"),
    }
}

fn number(value: Value) -> i128 {
    match value {
        Value::Bool(value) => i128::from(value),
        Value::Int(value) => value,
        Value::Ticks(ticks) => i128::from(ticks),
        Value::Step(_) | Value::Start(_) | Value::Phase(_) | Value::Other(_) => -1,
    }
}
