//! A way is shown only where the interpreter of the model goes it, too.

use grafcet_compiler::model::{Model, Ty};
use grafcet_compiler::program::{Program, Role};
use grafcet_sim::interp::{ClosedLoop, Value};

use crate::around::{Around, Told};
use crate::circuit::{Circuit, Source, Wire};
use crate::goal::{Goal, Watch};
use crate::play::number;
use crate::task::Way;

/// What one cycle of a way was given, and what it showed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Shown {
    /// The reading of the clock.
    pub now: u32,
    /// In the order of declaration.
    pub inputs: Vec<Value>,
    pub params: Vec<Value>,
    pub outputs: Vec<Value>,
    /// None for a combinational one.
    pub vars: Vec<Value>,
    /// What the program around the chart was asked for, by its text, and said.
    pub told: Vec<(String, Value)>,
    pub active: Vec<String>,
    pub cleared: Vec<String>,
    /// In source order.
    pub plants: Vec<Beside>,
}

/// The same of a plant.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Beside {
    /// In the order of declaration.
    pub inputs: Vec<Value>,
    pub outputs: Vec<Value>,
    pub active: Vec<String>,
}

/// Why a way is not shown.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Why {
    /// The interpreter does not understand something in the chart.
    NotUnderstood(String),
    /// It does something else: a mistake of the circuit, of the engine or of the interpreter.
    Differs(String),
}

/// The way as the interpreter goes it.
///
/// # Errors
/// It does not lead to where the property is broken.
pub(crate) fn replay(program: &Program<'_>, circuit: &Circuit, goal: &Goal<'_>, way: &Way) -> Result<Vec<Shown>, Why> {
    let mut watch = Watch::new(program.model, goal);
    let orders = goal.assumed(program.model);
    let mut orders: Vec<Watch<'_>> = orders.iter().map(|order| Watch::new(program.model, order)).collect();
    let shown = goes(program, circuit, (&mut watch, &mut orders), way, 0..way.inputs.len())?;
    if watch.is_broken() {
        Ok(shown)
    } else {
        Err(Why::Differs("the interpreter does not come to where it is broken".to_owned()))
    }
}

/// So many times the interpreter goes the cycles that come again and again, waiting in all of them.
const AGAIN: usize = 16;

/// The way, as the interpreter goes it, whose cycles from `again` on come again and again.
///
/// # Errors
/// What is waited for comes in them, or they show the last time what they have not shown before.
pub(crate) fn endless(
    program: &Program<'_>,
    circuit: &Circuit,
    goal: &Goal<'_>,
    way: &Way,
    again: usize,
) -> Result<Vec<Shown>, Why> {
    let (mut watch, length) = (Watch::new(program.model, goal), way.inputs.len());
    let orders = goal.assumed(program.model);
    let mut orders: Vec<Watch<'_>> = orders.iter().map(|order| Watch::new(program.model, order)).collect();
    let turns = (1..AGAIN).flat_map(|_| again..length);
    let mut shown = goes(program, circuit, (&mut watch, &mut orders), way, (0..length).chain(turns))?;
    let turn = length - again;
    // Whatever else is waited for has come in each of the turns.
    if orders.iter().any(|order| order.waits_since_before(shown.len() - 2 * turn)) {
        return Err(Why::Differs("what is assumed to come some time never does".to_owned()));
    }
    let same = |one: &Shown, other: &Shown| {
        (&one.active, &one.cleared, &one.outputs, &one.plants)
            == (&other.active, &other.cleared, &other.outputs, &other.plants)
    };
    // What does not decide about the property may still settle, or turn at another pace.
    let last = shown.len() - turn;
    let is_last = |start: usize| (0..turn).all(|cycle| same(&shown[start + cycle], &shown[last + cycle]));
    let repeats = (again..last).step_by(turn).any(is_last);
    if !repeats || !watch.waits_since_before(again) {
        return Err(Why::Differs("cycles that do not come again and again for the interpreter".to_owned()));
    }
    shown.truncate(length);
    Ok(shown)
}

/// These cycles of a way.
fn goes(
    program: &Program<'_>,
    circuit: &Circuit,
    (watch, orders): (&mut Watch<'_>, &mut [Watch<'_>]),
    way: &Way,
    cycles: impl Iterator<Item = usize>,
) -> Result<Vec<Shown>, Why> {
    let model = program.model;
    let not_understood = |error: grafcet_sim::interp::Error| Why::NotUnderstood(error.to_string());
    begins(program, circuit)?;
    let mut machine = ClosedLoop::new(model).map_err(not_understood)?;
    let (mut now, mut shown, program_around) = (0_u32, Vec::new(), Around::default());
    for index in cycles {
        let mut given = Given::of(circuit, model, &way.inputs[index])?;
        if !given.params.is_empty() {
            machine.chart_mut().set_params(&given.params).map_err(not_understood)?;
        }
        let (cycle_number, world) = (shown.len() + 1, program_around.in_cycle(circuit, way, index));
        // Plants have been there before the chart.
        if cycle_number > 1 || !model.plants.is_empty() {
            now = now.wrapping_add(given.elapsed);
            if model.longest_cycle.is_some_and(|longest| given.elapsed > longest) {
                return Err(Why::Differs(format!("cycle {cycle_number} comes later than is assumed")));
            }
        }
        let round = match machine.cycle_in(&world, &mut given.inputs, &given.free, now) {
            Ok(round) => round,
            Err(grafcet_sim::interp::Error::Overflow(what)) => {
                return Err(Why::Differs(format!("overflow in cycle {cycle_number}: {what}")));
            }
            Err(error) => return Err(not_understood(error)),
        };
        if !is_assumed(&machine, model, (&world, &given.inputs), &round.given).map_err(not_understood)? {
            return Err(Why::Differs(format!("an assumption does not hold in cycle {cycle_number}")));
        }
        for order in &mut *orders {
            order.cycle(&machine, &world, &given.inputs, now).map_err(not_understood)?;
            if order.is_broken() {
                return Err(Why::Differs(format!(
                    "what is assumed to come one after the other does not in cycle {cycle_number}"
                )));
            }
        }
        watch.cycle(&machine, &world, &given.inputs, now).map_err(not_understood)?;
        let name = |ident: &dyn std::fmt::Display| ident.to_string().trim_start_matches("r#").to_owned();
        let cycle = round.chart;
        let mut plants = Vec::new();
        for ((plant, cycle), inputs) in model.plants.list.iter().zip(round.plants).zip(round.given) {
            let active = cycle.active.iter().map(|step| name(&plant.model.steps[*step].name)).collect();
            plants.push(Beside { inputs, outputs: cycle.outputs, active });
        }
        shown.push(Shown {
            now,
            params: given.params,
            outputs: cycle.outputs.clone(),
            vars: machine.chart().vars().to_vec(),
            told: world.asked(),
            active: cycle.active.iter().map(|step| name(&model.steps[*step].name)).collect(),
            cleared: cleared(model, &cycle),
            inputs: given.inputs,
            plants,
        });
    }
    Ok(shown)
}

/// Whether the chart's assumptions and those of its plants hold of the last cycle.
fn is_assumed(
    machine: &ClosedLoop<'_>,
    model: &Model,
    (world, inputs): (&Told<'_>, &[Value]),
    of_plants: &[Vec<Value>],
) -> Result<bool, grafcet_sim::interp::Error> {
    for ((plant, machine), inputs) in model.plants.list.iter().zip(machine.plants()).zip(of_plants) {
        for assumption in &plant.model.assumptions {
            if machine.holds(&assumption.never.tree, inputs)? {
                return Ok(false);
            }
        }
    }
    for assumption in &model.assumptions {
        if machine.chart().look(world, inputs).holds(&assumption.never.tree)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// What is stored begins with values that the interpreter knows, too.
fn begins(program: &Program<'_>, circuit: &Circuit) -> Result<(), Why> {
    let open = circuit.fields.iter().any(|field| {
        let place = field.place.map(|place| field.program(program).places[place.0].role);
        let latches = &circuit.latches[field.first..field.first + field.width];
        latches.iter().any(|latch| latch.initial.is_none()) && matches!(place, Some(Role::Output(_) | Role::Var(_)))
    });
    if open { Err(Why::NotUnderstood("an initial value".to_owned())) } else { Ok(()) }
}

/// What a cycle is given.
struct Given {
    inputs: Vec<Value>,
    params: Vec<Value>,
    /// By plant, by input: what nobody drives.
    free: Vec<Vec<Value>>,
    elapsed: u32,
}

impl Given {
    /// By the nodes that are on.
    fn of(circuit: &Circuit, model: &Model, on: &[usize]) -> Result<Self, Why> {
        let given = |wire: &Wire, signed: bool| {
            let bits: Vec<bool> = wire.bits.iter().map(|bit| on.binary_search(&bit.node()).is_ok()).collect();
            number(&bits, signed)
        };
        let (mut inputs, mut params) = (Vec::new(), Vec::new());
        for (id, input) in model.inputs.iter() {
            // The plants write it.
            if !model.plants.leave_free(id) {
                inputs.push(zero(&input.ty));
                continue;
            }
            inputs.push(read(circuit, &Source::Input(id), &input.ty, &given)?);
        }
        for (id, param) in model.params.iter() {
            params.push(read(circuit, &Source::Param(id), &param.ty, &given)?);
        }
        let mut free = Vec::new();
        for (number, plant) in model.plants.list.iter().enumerate() {
            let mut values = Vec::new();
            for ((id, input), wire) in plant.model.inputs.iter().zip(&plant.wires) {
                values.push(match wire {
                    grafcet_compiler::model::Wire::Free => {
                        read(circuit, &Source::Plant(number, id), &input.ty, &given)?
                    }
                    _ => Value::Bool(false),
                });
            }
            free.push(values);
        }
        let elapsed = circuit.inputs.iter().find(|wire| wire.source == Source::Elapsed);
        let elapsed = elapsed.map_or(0, |wire| given(wire, false));
        Ok(Self { inputs, params, free, elapsed: u32::try_from(elapsed).unwrap_or(0) })
    }
}

fn zero(ty: &Ty) -> Value {
    match ty {
        Ty::Bool(_) => Value::Bool(false),
        Ty::Time(_) => Value::Ticks(0),
        Ty::Int { .. } | Ty::Other(_) => Value::Int(0),
    }
}

fn cleared(model: &Model, cycle: &grafcet_sim::interp::Cycle) -> Vec<String> {
    let mut all = Vec::new();
    for (index, evolution) in cycle.seen.iter().enumerate() {
        // Of a search the last one has not taken place.
        if model.is_grafcet() && index >= cycle.evolutions as usize {
            break;
        }
        for id in &evolution.cleared {
            let steps = |steps: &[grafcet_compiler::model::StepId]| {
                let names: Vec<String> = steps.iter().map(|step| model.steps[*step].name.to_string()).collect();
                if names.len() == 1 { names.concat() } else { format!("({})", names.join(", ")) }
            };
            let transition = &model.transitions[*id];
            all.push(format!("{} → {}", steps(&transition.sources), steps(&transition.targets)));
        }
    }
    all
}

fn read(circuit: &Circuit, source: &Source, ty: &Ty, given: &dyn Fn(&Wire, bool) -> i128) -> Result<Value, Why> {
    let Some(wire) = circuit.inputs.iter().find(|wire| wire.source == *source) else {
        return Err(Why::NotUnderstood("an input of a type that is not looked into".to_owned()));
    };
    let signed = matches!(ty, Ty::Int { signed: true, .. });
    let number = given(wire, signed);
    Ok(match ty {
        Ty::Bool(_) => Value::Bool(number != 0),
        Ty::Time(_) => Value::Ticks(u32::try_from(number).unwrap_or(u32::MAX)),
        Ty::Int { .. } | Ty::Other(_) => Value::Int(number),
    })
}
