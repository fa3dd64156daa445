//! A trace as a file for waveform viewers.

use std::io;

use vcd::{IdCode, TimescaleUnit, VarType, Writer};

use super::Axis;
use crate::names::{Kind, Signal};
use crate::trace::Trace;
use crate::value::Value;

/// A trace as a VCD file (IEEE 1364): a scope each for steps, transitions (events), inputs, outputs and variables. Where the chart's clock
/// stands still, a nanosecond is a cycle. What is in a gap is unknown (`x`).
///
/// # Errors
/// Those of the writer.
pub fn vcd(trace: &Trace, out: impl io::Write) -> io::Result<()> {
    let axis = Axis::of(trace);
    let mut writer = Writer::new(out);
    let (factor, size, unit) =
        if axis.is_time { timescale(trace.names.nanos_per_tick) } else { (1, 1, TimescaleUnit::NS) };
    writer.version(concat!("grafcet-sim ", env!("CARGO_PKG_VERSION")))?;
    if !axis.is_time {
        writer.comment("one nanosecond is one cycle")?;
    }
    for warning in &trace.warnings {
        writer.comment(&warning.replace("$end", "end"))?;
    }
    writer.timescale(size, unit)?;
    let lines = Lines::declare(trace, &mut writer)?;
    let mut shown = vec![None; lines.all.len()];
    for (index, cycle) in trace.cycles.iter().enumerate() {
        let now = axis.starts[index] * factor;
        // What was before it is not known up to here.
        let from = index.checked_sub(1).filter(|_| cycle.gap.is_some());
        if let Some(before) = from {
            writer.timestamp((axis.starts[before] + 1).min(axis.starts[index]) * factor)?;
            for (line, shown) in lines.all.iter().zip(&mut shown) {
                line.unknown(&mut writer)?;
                *shown = None;
            }
        }
        writer.timestamp(now)?;
        let steps = (0..trace.names.steps.len()).map(|step| Value::Bool(cycle.steps.contains(&step)));
        let values = cycle.inputs.iter().chain(&cycle.outputs).chain(&cycle.variables).cloned();
        let values: Vec<Value> = steps.chain(values).collect();
        for ((line, value), shown) in lines.all.iter().zip(values).zip(&mut shown) {
            if shown.as_ref() != Some(&value) {
                line.change(&value, &mut writer)?;
                *shown = Some(value);
            }
        }
        for transition in cycle.cleared() {
            writer.change_scalar(lines.transitions[transition], true)?;
        }
    }
    writer.timestamp(axis.end * factor)?;
    writer.flush()
}

/// So many units of a file in a tick, and the unit.
fn timescale(nanos: u64) -> (u64, u32, TimescaleUnit) {
    let units = [
        (1_000_000_000, TimescaleUnit::S),
        (1_000_000, TimescaleUnit::MS),
        (1_000, TimescaleUnit::US),
        (1, TimescaleUnit::NS),
    ];
    for (size, unit) in units {
        for step in [100_u32, 10, 1] {
            let whole = size * u64::from(step);
            if nanos % whole == 0 && nanos >= whole {
                return (nanos / whole, step, unit);
            }
        }
    }
    (nanos.max(1), 1, TimescaleUnit::NS)
}

struct Lines {
    /// Steps, inputs, outputs, variables.
    all: Vec<Line>,
    transitions: Vec<IdCode>,
}

struct Line {
    id: IdCode,
    kind: Kind,
}

impl Lines {
    fn declare<W: io::Write>(trace: &Trace, writer: &mut Writer<W>) -> io::Result<Self> {
        let names = &trace.names;
        writer.add_module(&word(&names.chart))?;
        let mut all = Vec::new();
        writer.add_module("steps")?;
        for step in &names.steps {
            all.push(Line { id: writer.add_wire(1, &word(&step.name))?, kind: Kind::Bool });
        }
        writer.upscope()?;
        writer.add_module("transitions")?;
        let mut transitions = Vec::new();
        for (index, transition) in names.transitions.iter().enumerate() {
            let name = format!("t{index}_{}", word(&transition.name));
            transitions.push(writer.add_var(VarType::Event, 1, &name, None)?);
        }
        writer.upscope()?;
        for (scope, signals) in
            [("inputs", &names.inputs), ("outputs", &names.outputs), ("variables", &names.variables)]
        {
            writer.add_module(scope)?;
            for Signal { name, kind } in signals {
                let (ty, bits) = match kind {
                    Kind::Bool => (VarType::Wire, 1),
                    Kind::Int { bits, .. } => (VarType::Wire, *bits),
                    Kind::Time => (VarType::Wire, 32),
                    Kind::Float(_) => (VarType::Real, 64),
                    Kind::Listed(..) | Kind::Other(_) => (VarType::String, 1),
                };
                all.push(Line { id: writer.add_var(ty, bits, &word(name), None)?, kind: kind.clone() });
            }
            writer.upscope()?;
        }
        writer.upscope()?;
        writer.enddefinitions()?;
        Ok(Self { all, transitions })
    }
}

impl Line {
    fn change<W: io::Write>(&self, value: &Value, writer: &mut Writer<W>) -> io::Result<()> {
        match (&self.kind, value) {
            (Kind::Bool, Value::Bool(value)) => writer.change_scalar(self.id, *value),
            (Kind::Int { bits, .. }, Value::Int(value)) => writer.change_vector(self.id, digits(*value, *bits)),
            (Kind::Time, Value::Ticks(value)) => writer.change_vector(self.id, digits((*value).into(), 32)),
            (Kind::Float(_), Value::Float(value)) => writer.change_real(self.id, *value),
            (Kind::Listed(..) | Kind::Other(_), value) => writer.change_string(self.id, &word(&value.to_string())),
            _ => self.unknown(writer),
        }
    }

    fn unknown<W: io::Write>(&self, writer: &mut Writer<W>) -> io::Result<()> {
        match &self.kind {
            Kind::Bool => writer.change_scalar(self.id, vcd::Value::X),
            Kind::Float(_) => writer.change_real(self.id, f64::NAN),
            Kind::Listed(..) | Kind::Other(_) => writer.change_string(self.id, "?"),
            Kind::Int { .. } | Kind::Time => writer.change_vector(self.id, [vcd::Value::X]),
        }
    }
}

/// In two's complement, the highest bit first.
fn digits(value: i128, bits: u32) -> Vec<vcd::Value> {
    (0..bits).rev().map(|bit| (value >> bit.min(127) & 1 != 0).into()).collect()
}

/// A name without blanks, and without what viewers take for structure.
fn word(name: &str) -> String {
    let plain = name.replace(" → ", "__").replace("::", "_");
    plain.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
}
