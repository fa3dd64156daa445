//! A circuit run on values, cycle by cycle.

use grafcet_compiler::program::{Program, Value};

use crate::aig::{Lit, value};
use crate::circuit::{Circuit, Field, Source, Wire};

/// A circuit that is being run.
pub struct Player<'c> {
    circuit: &'c Circuit,
    /// By latch.
    state: Vec<bool>,
    /// By node, in the last cycle.
    values: Vec<bool>,
}

impl<'c> Player<'c> {
    /// In its initial state; latches that begin with any value are false.
    #[must_use]
    pub fn new(circuit: &'c Circuit) -> Self {
        let state = circuit.latches.iter().map(|latch| latch.initial.unwrap_or(false)).collect();
        Self { circuit, state, values: Vec::new() }
    }

    /// The same, with what some latches begin with.
    pub(crate) fn beginning(circuit: &'c Circuit, initial: &[(usize, bool)]) -> Self {
        let mut player = Self::new(circuit);
        for (latch, value) in initial {
            player.state[*latch] = *value;
        }
        player
    }

    /// One cycle, the inputs by what drives them.
    pub fn cycle(&mut self, given: impl Fn(&Source) -> i128) {
        let mut on = Vec::new();
        for wire in &self.circuit.inputs {
            let number = given(&wire.source);
            let bits = wire.bits.iter().enumerate().filter(|(index, _)| number >> index.min(&127) & 1 == 1);
            on.extend(bits.map(|(_, bit)| bit.node()));
        }
        self.cycle_on(&on);
    }

    /// The same, with the nodes of the inputs that are on.
    pub(crate) fn cycle_on(&mut self, on: &[usize]) {
        let mut free = vec![false; self.circuit.aig.len()];
        for (latch, now) in self.circuit.latches.iter().zip(&self.state) {
            free[latch.now.node()] = *now;
        }
        for node in on {
            free[*node] = true;
        }
        self.values = self.circuit.aig.simulate(|node| free[node]);
        self.state = self.circuit.latches.iter().map(|latch| value(&self.values, latch.next)).collect();
    }

    /// The value of a wire in the last cycle.
    #[must_use]
    pub fn holds(&self, lit: Lit) -> bool {
        value(&self.values, lit)
    }

    /// What a field holds after the last cycle.
    #[must_use]
    pub fn field(&self, field: &Field) -> i128 {
        number(&self.state[field.first..field.first + field.width], field.signed)
    }
}

/// The number of some bits, the lowest first.
#[must_use]
pub fn number(bits: &[bool], signed: bool) -> i128 {
    let mut number = 0;
    for (index, bit) in bits.iter().enumerate() {
        if *bit {
            number += 1 << index;
        }
    }
    match bits.last() {
        Some(true) if signed => number - (1 << bits.len()),
        _ => number,
    }
}

/// A value as the circuit stores it.
#[must_use]
pub fn stored(program: &Program<'_>, value: Value, time_bits: usize) -> Option<i128> {
    Some(match value {
        Value::Bool(value) => i128::from(value),
        Value::Int(value) => value,
        Value::Ticks(ticks) => clipped(ticks, time_bits),
        Value::Step(None) => 0,
        Value::Step(Some(step)) => {
            let place = program.regions.iter().find_map(|steps| steps.iter().position(|other| *other == step))?;
            i128::try_from(place).ok()? + 1
        }
        Value::Start(_) | Value::Phase(_) | Value::Other(_) => return None,
    })
}

/// A time, or the highest value that stands for all that are longer.
#[must_use]
pub fn clipped(ticks: u32, time_bits: usize) -> i128 {
    i128::from(ticks).min((1 << time_bits) - 1)
}

/// What passes between two cycles, or what stands for all that is as far in each period.
#[must_use]
pub fn passed(ticks: u32, circuit: &Circuit) -> i128 {
    let (ticks, period, most) = (i128::from(ticks), i128::from(circuit.period), (1 << circuit.time_bits) - 1);
    if ticks <= most { ticks } else { most - (most - ticks).rem_euclid(period) }
}

/// The names of the bits of a wire.
#[must_use]
pub(crate) fn wire_name(program: &Program<'_>, wire: &Wire) -> String {
    match &wire.source {
        Source::Input(id) => program.model.inputs[*id].name.to_string(),
        Source::Param(id) => program.model.params[*id].name.to_string(),
        Source::Plant(plant, id) => {
            let plant = program.plants[*plant].model;
            format!("{}::{}", plant.name, plant.inputs[*id].name)
        }
        Source::Elapsed => "elapsed".to_owned(),
        Source::Rust(outside) => outside.text.clone(),
        Source::Again => "again".to_owned(),
    }
}
