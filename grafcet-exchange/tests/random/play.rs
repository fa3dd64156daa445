//! One chart and its program.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Effect, Id, Model, Name, Qualifier, Ty, VarId};
use grafcet_exchange::st::{Form, Order, StructuredText};
use grafcet_sim::interp::{self, Cycle, Interpreter};

use crate::machine::{Dialect, Machine, Real, Value};
use crate::reader::{Kind, Line};
use crate::shifted::Shifted;

/// After so many cycles or scans with the same inputs nothing changes any more.
const MOST: usize = 300;

/// So long a timer counts.
const LONGEST_MS: u64 = (1 << 31) - 1;

/// How many cycles were compared: none where the chart shows nothing that can be.
pub(crate) fn compare(
    model: &Model,
    (form, order): (Form, Option<Order>),
    (program, dialect): (&StructuredText, Dialect),
    lines: &[Line],
) -> Result<usize, String> {
    let mut machine = Machine::of(&program.text, dialect).map_err(|error| format!("not understood: {error}"))?;
    machine.world = written;
    let Ok(oracle) = Interpreter::new(model) else { return Ok(0) };
    let names = program.renamed.iter().cloned().collect();
    let mut pair = Pair { names, model, oracle, machine, init: false, fresh: true, last: None, ms: 0 };
    let ends =
        ["What blinks stands still", "that is stored or told ends"].iter().any(|note| program.text.contains(note));
    let mut shifted = Shifted::of(model);
    if form == Form::Case && order.is_none() && !model.is_grafcet() && !shifted.can_be_compared() {
        return Ok(0);
    }
    let mut compared = 0;
    for line in lines {
        let at = |error: String| format!("line {}, {}: {error}", line.number, line.text());
        match &line.kind {
            Kind::Init => {
                pair.oracle.init().map_err(|error| at(error.to_string()))?;
                (pair.init, pair.fresh) = (true, true);
            }
            Kind::Params(changed) => pair.params(changed).map_err(at)?,
            Kind::Cycle { inputs, now, .. } | Kind::Force { inputs, now, .. } => {
                pair.inputs(inputs, *now).map_err(at)?;
                // A TON counts no further, as the program says.
                if ends && pair.ms > LONGEST_MS {
                    return Ok(compared);
                }
                let values = values(model, inputs);
                let cycle = match (form, model.is_grafcet()) {
                    (form, false) if form == Form::FlipFlops || order.is_some() => pair.exactly(&values, *now, form),
                    (_, false) => pair.shifted(&values, *now, &mut shifted),
                    (_, true) => pair.settled(&values, *now, form),
                };
                // The chart's arithmetic has failed, or it has not become stable.
                if !cycle.map_err(at)? {
                    return Ok(compared);
                }
                compared += 1;
            }
            Kind::Shows(_) | Kind::Wakes(_) | Kind::Refuses(_) => {}
        }
    }
    Ok(compared)
}

/// What a person would write for the functions of these charts.
fn written(name: &str, arguments: &[Value]) -> Value {
    match (name, arguments) {
        ("abs_diff", [Value::Int(a), Value::Int(b)]) => Value::Int((a - b).abs()),
        _ => unreachable!("no chart of the comparison calls {name} with {arguments:?}"),
    }
}

pub(crate) struct Pair<'m> {
    pub(crate) model: &'m Model,
    pub(crate) oracle: Interpreter<'m>,
    pub(crate) machine: Machine,
    /// What has another name in the program.
    names: BTreeMap<String, String>,
    /// The next scan has `Init`.
    pub(crate) init: bool,
    /// The next cycle is a first one.
    pub(crate) fresh: bool,
    last: Option<u32>,
    ms: u64,
}

impl Pair<'_> {
    fn params(&mut self, changed: &BTreeMap<String, i128>) -> Result<(), String> {
        let mut all = self.oracle.params().to_vec();
        for (id, param) in self.model.params.iter() {
            if let Some(new) = changed.get(&plain(&param.name)) {
                all[id.index()] = value(*new, &param.ty);
                let st = self.st(*new, &param.ty);
                self.machine.set(&self.named(&param.name), st)?;
            }
        }
        self.oracle.set_params(&all).map_err(|error| error.to_string())
    }

    fn inputs(&mut self, given: &BTreeMap<String, i128>, now: u32) -> Result<(), String> {
        let elapsed = self.last.map_or(0, |last| now.wrapping_sub(last));
        self.last = Some(now);
        self.ms += u64::from(elapsed) * self.model.clock_nanos / 1_000_000;
        self.machine.now = self.ms;
        for input in self.model.inputs.values() {
            let number = given.get(&plain(&input.name)).copied().unwrap_or_default();
            let st = self.st(number, &input.ty);
            self.machine.set(&self.named(&input.name), st)?;
        }
        Ok(())
    }

    fn st(&self, number: i128, ty: &Ty) -> Value {
        match ty {
            Ty::Bool(_) => Value::Bool(number != 0),
            Ty::Time(_) => Value::Time(u64::try_from(number).unwrap_or(0) * self.model.clock_nanos / 1_000_000),
            Ty::Other(_) if ty.is_float() => Value::Real(Real::new(whole(number), Some(is_single(ty)))),
            _ => Value::Int(number),
        }
    }

    /// In the program.
    fn named(&self, name: &proc_macro2::Ident) -> String {
        let name = plain(name);
        self.names.get(&name).cloned().unwrap_or(name)
    }

    pub(crate) fn scan(&mut self) -> Result<(), String> {
        self.machine.set("Init", Value::Bool(self.init))?;
        self.init = false;
        self.machine.scan()
    }

    /// Each scan shows what a cycle shows.
    fn exactly(&mut self, inputs: &[interp::Value], now: u32, form: Form) -> Result<bool, String> {
        let Ok(cycle) = self.oracle.cycle(inputs, now) else { return Ok(false) };
        self.scan()?;
        self.steps(form)?;
        self.places()?;
        self.same_calls(&cycle)?;
        Ok(true)
    }

    /// A scan is an evolution: both are run with the same inputs at the same time until nothing changes them, and then show the same. A cycle in which
    /// nothing evolves is one scan, which shows what it shows.
    fn settled(&mut self, inputs: &[interp::Value], now: u32, form: Form) -> Result<bool, String> {
        let mut calls = [Vec::new(), Vec::new()];
        let mut before = None;
        for number in 0..MOST {
            let Ok(cycle) = self.oracle.cycle(inputs, now) else { return Ok(false) };
            if !cycle.stable {
                return Ok(false);
            }
            if number == 0 && cycle.evolutions == 0 && !self.fresh && form == Form::FlipFlops {
                self.scan()?;
                self.steps(form)?;
                self.places()?;
                self.same_calls(&cycle)?;
                calls[1].extend(self.at_instants(self.called()));
            }
            calls[0].extend(self.at_instants(self.expected_calls(&cycle)));
            if before.as_ref() == Some(self.oracle.memory()) {
                break;
            }
            before = Some(self.oracle.memory().clone());
        }
        self.fresh = false;
        let mut before = String::new();
        for _ in 0..MOST {
            self.scan()?;
            calls[1].extend(self.at_instants(self.called()));
            let memory = self.machine.memory();
            if memory == before {
                self.steps(form)?;
                self.places()?;
                let [expected, found] = calls;
                let same = form == Form::Case || found == expected;
                return if same { Ok(true) } else { Err(format!("calls {found:?}, expected {expected:?}")) };
            }
            before = memory;
        }
        Err("the program does not settle".to_owned())
    }

    /// Of actions that nothing calls as long as something holds.
    fn at_instants(&self, calls: Vec<(String, Vec<i128>)>) -> Vec<(String, Vec<i128>)> {
        let lasts = |name: &str| {
            self.model.associations.values().any(|one| match &one.effect {
                Effect::Call(action, _) => {
                    let at_instant = matches!(one.qualifier, Qualifier::P1 | Qualifier::P0 | Qualifier::On);
                    !at_instant && self.named(&self.model.actions[*action].name).to_lowercase() == name
                }
                _ => false,
            })
        };
        calls.into_iter().filter(|(name, _)| !lasts(name)).collect()
    }

    /// Of the last scan.
    fn called(&self) -> Vec<(String, Vec<i128>)> {
        let called = self.machine.calls.iter().map(|call| {
            let arguments: Vec<i128> = call.arguments.iter().map(|value| self.in_ticks(*value)).collect();
            (call.instance.clone(), arguments)
        });
        called.collect()
    }

    fn expected_calls(&self, cycle: &Cycle) -> Vec<(String, Vec<i128>)> {
        let expected = cycle.calls.iter().map(|call| {
            let mut arguments = vec![call.phase as i128];
            arguments.extend(call.args.iter().map(|value| number(*value)));
            (self.named(&self.model.actions[call.action].name).to_lowercase(), arguments)
        });
        expected.collect()
    }

    fn same_calls(&self, cycle: &Cycle) -> Result<(), String> {
        let (called, expected) = (self.called(), self.expected_calls(cycle));
        if called == expected { Ok(()) } else { Err(format!("calls {called:?}, expected {expected:?}")) }
    }

    /// The same steps are active.
    pub(crate) fn steps(&self, form: Form) -> Result<(), String> {
        let number = if form == Form::Case { self.machine.get("StepNo")?.number() } else { 0 };
        for (id, step) in self.model.steps.iter() {
            let found = match form {
                Form::Case => number == 10 + 10 * i128::try_from(id.index()).unwrap_or(0),
                Form::FlipFlops => self.machine.get(&flag(&plain(&step.name)))? == Value::Bool(true),
            };
            let expected = self.oracle.situation().contains(&id);
            if found != expected {
                return Err(format!("{} is {found}, expected {expected}", step.name));
            }
        }
        Ok(())
    }

    /// The same values, of outputs and of variables.
    fn places(&self) -> Result<(), String> {
        for name in places(self.model) {
            let (found, expected) = (self.shown(name)?, self.expected(name));
            if found != expected {
                return Err(format!("{} = {found}, expected {expected}", self.model.value_name(name)));
            }
        }
        Ok(())
    }

    /// What the program shows, times in ticks.
    pub(crate) fn shown(&self, name: Name) -> Result<i128, String> {
        self.machine.get(&self.named(self.model.value_name(name))).map(|value| self.in_ticks(value))
    }

    fn in_ticks(&self, value: Value) -> i128 {
        match value {
            Value::Time(ms) => i128::from(ms * 1_000_000 / self.model.clock_nanos),
            other => other.number(),
        }
    }

    pub(crate) fn expected(&self, name: Name) -> i128 {
        match name {
            Name::Output(id) => number(self.oracle.outputs()[id.index()]),
            Name::Var(id) => number(self.oracle.vars()[id.index()]),
            Name::Input(_) | Name::Param(_) => 0,
        }
    }
}

/// Outputs and variables.
pub(crate) fn places(model: &Model) -> Vec<Name> {
    let vars = model.vars.ids().filter(|id: &VarId| !model.is_grafcet() || !interp::is_combinational(model, *id));
    model.outputs.ids().map(Name::Output).chain(vars.map(Name::Var)).collect()
}

pub(crate) fn values(model: &Model, given: &BTreeMap<String, i128>) -> Vec<interp::Value> {
    let one = |input: &grafcet_compiler::model::Input| {
        value(given.get(&plain(&input.name)).copied().unwrap_or_default(), &input.ty)
    };
    model.inputs.values().map(one).collect()
}

pub(crate) fn value(number: i128, ty: &Ty) -> interp::Value {
    match ty {
        Ty::Bool(_) => interp::Value::Bool(number != 0),
        Ty::Time(_) => interp::Value::Ticks(u32::try_from(number).unwrap_or(u32::MAX)),
        Ty::Other(_) if ty.is_float() => interp::Value::Real(interp::Real(whole(number))),
        _ => interp::Value::Int(number),
    }
}

/// A float of a timeline.
fn whole(number: i128) -> f64 {
    f64::from(i32::try_from(number).unwrap_or(i32::MAX))
}

fn is_single(ty: &Ty) -> bool {
    matches!(ty, Ty::Other(syn::Type::Path(path)) if path.path.is_ident("f32"))
}

pub(crate) fn number(value: interp::Value) -> i128 {
    match value {
        interp::Value::Bool(value) => i128::from(value),
        interp::Value::Int(value) => value,
        interp::Value::Ticks(value) => i128::from(value),
        interp::Value::Real(real) => i128::from(real.0.to_bits()),
        other => unreachable!("no chart of the comparison has a {other:?}"),
    }
}

pub(crate) fn plain(name: &proc_macro2::Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

fn flag(step: &str) -> String {
    format!("SR_{step}")
}
