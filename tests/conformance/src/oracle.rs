//! The interpreter as a [`Subject`].

use std::collections::BTreeSet;

use grafcet_compiler::model::{Model, Ty};
use grafcet_sim::interp::{self, Call, Cycle, Interpreter, Phase, Recalled, Situation, Value};

use crate::{Rest, Shown, Subject, Values};

/// An interpreted chart.
pub struct Interpreted<'m> {
    model: &'m Model,
    machine: Interpreter<'m>,
    rest: Option<Rest>,
}

impl<'m> Interpreted<'m> {
    /// In its initial situation.
    ///
    /// # Errors
    /// The interpreter does not understand the chart.
    pub fn new(model: &'m Model) -> Result<Self, String> {
        let machine = Interpreter::new(model).map_err(|error| error.to_string())?;
        Ok(Self { model, machine, rest: None })
    }

    /// Goes on from what a compiled chart remembers.
    ///
    /// # Errors
    /// What that does not tell, in words.
    pub fn recall(&mut self, recalled: &Recalled) -> Result<(), String> {
        self.machine.recall(recalled)
    }

    /// A cycle, of which nobody asks what it leaves to the next one.
    ///
    /// # Errors
    /// As of [`Subject::cycle`].
    pub fn run(&mut self, inputs: &Values, now: u32) -> Result<Shown, String> {
        let inputs = self.inputs(inputs);
        let cycle = self.machine.cycle(&inputs, now).map_err(|error| error.to_string())?;
        Ok(self.told(&cycle))
    }

    fn inputs(&self, values: &Values) -> Vec<Value> {
        let given = |name: String| values.get(&name).copied().unwrap_or_default();
        self.model.inputs.values().map(|i| value(given(plain(&i.name)), &i.ty)).collect()
    }

    fn told(&self, cycle: &Cycle) -> Shown {
        let calls = cycle.calls.iter().map(|call| self.write(call)).collect();
        Shown { stable: cycle.stable, calls, ..self.show(&cycle.active, &cycle.outputs) }
    }

    fn show(&self, situation: &Situation, outputs: &[Value]) -> Shown {
        let names = self.model.outputs.values().map(|output| plain(&output.name));
        let outputs = names.zip(outputs.iter().copied().map(number));
        let late = self.machine.late_steps();
        let late = late.into_iter().map(|step| (format!("late({})", plain(&self.model.steps[step].name)), 1));
        Shown {
            steps: situation.iter().map(|step| plain(&self.model.steps[*step].name)).collect(),
            stable: true,
            outputs: outputs.filter(|(_, value)| *value != 0).chain(late).collect(),
            calls: Vec::new(),
        }
    }

    fn write(&self, call: &Call) -> String {
        let phase = match call.phase {
            Phase::First => "first",
            Phase::Repeated => "repeated",
            Phase::Final => "final",
        };
        let args: Vec<String> = call.args.iter().map(|arg| number(*arg).to_string()).collect();
        format!("{phase} {}({})", plain(&self.model.actions[call.action].name), args.join(","))
    }
}

impl Subject for Interpreted<'_> {
    fn cycle(&mut self, inputs: &Values, now: u32) -> Result<Shown, String> {
        let inputs = self.inputs(inputs);
        let before = self.machine.memory().clone();
        let cycle = self.machine.cycle(&inputs, now).map_err(|error| error.to_string())?;
        // Arithmetic that leaves its type in the next cycle is no mistake of this one.
        let rest = || self.machine.rest(&before, &cycle, &inputs, now).ok();
        self.rest = self.model.uses_time().then(rest).flatten().map(told);
        Ok(self.told(&cycle))
    }

    fn force(&mut self, steps: &BTreeSet<String>, inputs: &Values, now: u32) -> Result<Option<Shown>, String> {
        let inputs = self.inputs(inputs);
        let named = self.model.steps.iter().filter(|(_, step)| steps.contains(&plain(&step.name)));
        let situation: Situation = named.map(|(id, _)| id).collect();
        let cycle = self.machine.force_in(&interp::Nothing, &situation, &inputs, now);
        let cycle = cycle.map_err(|error| error.to_string())?;
        // A38: no condition has been asked.
        self.rest = self.model.uses_time().then_some(Rest::Goes);
        Ok(Some(self.told(&cycle)))
    }

    fn init(&mut self) -> Result<(), String> {
        self.machine.init().map_err(|error| error.to_string())
    }

    fn set_params(&mut self, changed: &Values) -> Result<(), String> {
        let params = self.model.params.values().zip(self.machine.params());
        let new = |(param, old): (&grafcet_compiler::model::Param, &Value)| {
            changed.get(&plain(&param.name)).map_or(*old, |new| value(*new, &param.ty))
        };
        let params: Vec<Value> = params.map(new).collect();
        self.machine.set_params(&params).map_err(|error| error.to_string())
    }

    fn shown(&self) -> Shown {
        self.show(self.machine.situation(), self.machine.outputs())
    }

    fn next_deadline(&self) -> Option<u32> {
        None
    }

    fn rest(&self) -> Option<Rest> {
        self.rest
    }
}

fn told(rest: interp::Rest) -> Rest {
    match rest {
        interp::Rest::Goes => Rest::Goes,
        interp::Rest::Looks => Rest::Looks,
        interp::Rest::Sleeps => Rest::Sleeps,
    }
}

fn plain(name: &proc_macro2::Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

fn value(number: i128, ty: &Ty) -> Value {
    match ty {
        Ty::Bool(_) => Value::Bool(number != 0),
        Ty::Time(_) => Value::Ticks(u32::try_from(number).unwrap_or(u32::MAX)),
        _ => Value::Int(number),
    }
}

fn number(value: Value) -> i128 {
    match value {
        Value::Bool(value) => i128::from(value),
        Value::Int(value) => value,
        Value::Ticks(value) => i128::from(value),
        other => unreachable!("no chart of the comparison has a {other:?}"),
    }
}
