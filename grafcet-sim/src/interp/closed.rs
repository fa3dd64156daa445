//! A chart in a closed loop with the plants of its call: in each cycle it reads what they showed at the end of the cycle before, then they
//! evolve on its outputs.

use grafcet_compiler::model::{Model, Name, Seen, Tree, Wire};

use super::value::default;
use super::{Cycle, Error, Interpreter, Memory, Nothing, Value, World};

/// A chart and its plants, which have made their first cycle, on outputs that are off, before the chart makes its own.
#[derive(Clone)]
pub struct ClosedLoop<'m> {
    model: &'m Model,
    chart: Interpreter<'m>,
    plants: Vec<Interpreter<'m>>,
    /// By plant, by output: at the end of the last cycle.
    shown: Vec<Vec<Value>>,
}

/// What one cycle of a closed loop showed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Round {
    pub chart: Cycle,
    /// By plant.
    pub plants: Vec<Cycle>,
    /// By plant, by input: what it was given.
    pub given: Vec<Vec<Value>>,
}

impl<'m> ClosedLoop<'m> {
    /// A chart without plants is one, too.
    ///
    /// # Errors
    /// Those of [`Interpreter::new`] and of the plants' first cycle.
    pub fn new(model: &'m Model) -> Result<Self, Error> {
        let (mut plants, mut shown) = (Vec::new(), Vec::new());
        for plant in &model.plants.list {
            let mut machine = Interpreter::new(&plant.model)?;
            let inputs: Vec<Value> = plant.model.inputs.values().map(|input| default(&input.ty)).collect();
            shown.push(machine.cycle(&inputs, 0)?.outputs);
            plants.push(machine);
        }
        Ok(Self { model, chart: Interpreter::new(model)?, plants, shown })
    }

    #[must_use]
    pub fn chart(&self) -> &Interpreter<'m> {
        &self.chart
    }

    /// For what is exchanged from outside: params.
    pub fn chart_mut(&mut self) -> &mut Interpreter<'m> {
        &mut self.chart
    }

    #[must_use]
    pub fn plants(&self) -> &[Interpreter<'m>] {
        &self.plants
    }

    /// One cycle. Of `inputs` those that a plant drives are written, and at the end those that stand for something of one; of `free`, by
    /// plant and input, those are read that nobody drives.
    ///
    /// # Errors
    /// Those of [`Interpreter::cycle`].
    pub fn cycle(&mut self, inputs: &mut [Value], free: &[Vec<Value>], now: u32) -> Result<Round, Error> {
        self.cycle_in(&Nothing, inputs, free, now)
    }

    /// The same with what the program around the chart contributes; around the plants there is nothing.
    ///
    /// # Errors
    /// As of [`ClosedLoop::cycle`].
    pub fn cycle_in(
        &mut self,
        world: &dyn World,
        inputs: &mut [Value],
        free: &[Vec<Value>],
        now: u32,
    ) -> Result<Round, Error> {
        let all = &self.model.plants;
        for driven in &all.driven {
            inputs[index(driven.input)] = self.shown[driven.plant][index(driven.output)];
        }
        let chart = self.chart.cycle_in(world, inputs, now)?;
        let (mut plants, mut given) = (Vec::new(), Vec::new());
        for (number, plant) in all.list.iter().enumerate() {
            let mut values = Vec::new();
            for (input, wire) in plant.wires.iter().enumerate() {
                values.push(match *wire {
                    Wire::Output(id) => chart.outputs[index(id)],
                    Wire::Shown(other, id) => self.shown[other][index(id)],
                    Wire::Shared(id) => inputs[index(id)],
                    Wire::Free => free[number][input],
                });
            }
            plants.push(self.plants[number].cycle(&values, now)?);
            given.push(values);
        }
        self.shown = plants.iter().map(|cycle| cycle.outputs.clone()).collect();
        for watched in &all.watched {
            let (machine, values) = (&self.plants[watched.plant], &given[watched.plant]);
            let steps =
                |of: &[grafcet_compiler::model::StepId]| of.iter().any(|step| machine.situation().contains(step));
            inputs[index(watched.input)] = match watched.what {
                Seen::Step(step) => Value::Bool(steps(&[step])),
                Seen::Macro(id) => Value::Bool(steps(&all.list[watched.plant].model.macros[id].steps)),
                Seen::Value(name) => machine.look(&Nothing, values).name(name)?,
            };
        }
        Ok(Round { chart, plants, given })
    }

    /// What chart and plants remember, after [`Memory::settled`] and the same from here on: with equal memories they do the same for ever.
    pub fn settle(&mut self, longest: u32) -> Vec<Memory> {
        let all = std::iter::once(&mut self.chart).chain(&mut self.plants);
        let settled = |machine: &mut Interpreter<'m>| {
            let memory = machine.memory().settled(longest);
            machine.resume(memory.clone());
            memory
        };
        all.map(settled).collect()
    }

    /// Whether a condition of the chart holds at the end of the last cycle, whose inputs are given as it left them.
    ///
    /// # Errors
    /// It is not understood, or would panic in Rust.
    pub fn holds(&self, tree: &Tree, inputs: &[Value]) -> Result<bool, Error> {
        self.chart.holds(tree, inputs)
    }

    /// The values with which a cycle can be given nothing: what is false, and zero.
    #[must_use]
    pub fn nothing(&self) -> (Vec<Value>, Vec<Vec<Value>>) {
        let of = |model: &Model| model.inputs.ids().map(|id| default(model.ty(Name::Input(id)))).collect();
        (of(self.model), self.model.plants.list.iter().map(|plant| of(&plant.model)).collect())
    }
}

fn index(id: impl grafcet_compiler::model::Id) -> usize {
    id.index()
}
