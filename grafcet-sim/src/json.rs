//! A chart's names, and what a cycle shows, for pages that run in a browser.
//!
//! The playground and the live view of `cargo grafcet watch` draw the same of the same fields.

use serde_json::{Number, Value as Json, json};

use crate::value::short;
use crate::{Blocked, Cycle, Evolution, Kind, Names, Signal, Value, happened};

/// The names of everything, and what kind of value each has. `signals` are the inputs, and after them what else the program contributes.
#[must_use]
pub fn names(names: &Names, signals_in: &[Signal]) -> Json {
    json!({
        "chart": names.chart,
        "isGrafcet": names.is_grafcet,
        "nanosPerTick": names.nanos_per_tick,
        "steps": names.steps.iter().map(|step| &step.name).collect::<Vec<_>>(),
        "transitions": names.transitions.iter().map(|one| json!({ "name": one.name, "condition": one.condition })).collect::<Vec<_>>(),
        "inputs": names.inputs.len(),
        "signals": signals(signals_in),
        "outputs": signals(&names.outputs),
        "variables": signals(&names.variables),
        "params": signals(&names.params),
    })
}

/// Names with the kinds of their values.
#[must_use]
pub fn signals(signals: &[Signal]) -> Vec<Json> {
    let kind = |kind: &Kind| match kind {
        Kind::Bool => json!({ "is": "bool" }),
        Kind::Int { signed, bits } => json!({ "is": "int", "signed": signed, "bits": bits }),
        Kind::Float(_) => json!({ "is": "float" }),
        Kind::Time => json!({ "is": "time" }),
        Kind::Listed(_, list) => json!({ "is": "listed", "list": list }),
        Kind::Other(ty) => json!({ "is": "other", "type": ty }),
    };
    signals.iter().map(|signal| json!({ "name": signal.name, "kind": kind(&signal.kind) })).collect()
}

/// Values as JavaScript has them; what it cannot hold exactly is a text.
#[must_use]
pub fn values(values: &[Value]) -> Vec<Json> {
    values.iter().map(value).collect()
}

fn value(value: &Value) -> Json {
    /// Up to here JavaScript has every number.
    const EXACT: i128 = 1 << 53;
    match value {
        Value::Bool(value) => json!(value),
        Value::Int(value) if value.abs() <= EXACT => json!(i64::try_from(*value).unwrap_or_default()),
        Value::Float(number) => Number::from_f64(short(*number)).map_or_else(|| json!(value.to_string()), Json::Number),
        Value::Ticks(value) => json!(value),
        value => json!(value.to_string()),
    }
}

/// What happened in a cycle, in words.
#[must_use]
pub fn did(names: &Names, cycle: &Cycle) -> Vec<String> {
    let mut did = happened(names, cycle);
    did.extend(cycle.ran.iter().map(|ran| format!("{}: {}", names.steps[ran.step].name, ran.text)));
    did
}

/// The evolutions of a cycle.
#[must_use]
pub fn evolutions(cycle: &Cycle) -> Vec<Json> {
    let evolution = |one: &Evolution| {
        json!({
            "cleared": one.cleared, "left": one.deactivated, "entered": one.activated, "steps": one.steps,
        })
    };
    cycle.evolutions.iter().map(evolution).collect()
}

/// The transitions that are enabled, each with what it waits for.
#[must_use]
pub fn waits(blocked: &Blocked) -> Vec<Json> {
    blocked.waiting.iter().map(|one| json!([one.transition, one.to_string()])).collect()
}

/// The same in lines.
#[must_use]
pub fn said(blocked: &Blocked) -> Vec<String> {
    blocked.to_string().lines().map(str::to_owned).collect()
}
