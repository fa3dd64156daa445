//! A cycle as JSON: what `simulate` and `replay` tell programs of it.

use grafcet_sim::{Cycle, Names, Signal, Value, happened};
use serde_json::{Map, Value as Json, json};

/// The cycle of a number, by names.
pub(crate) fn object(names: &Names, number: usize, cycle: &Cycle) -> Map<String, Json> {
    let steps: Vec<&str> = cycle.steps.iter().map(|step| names.steps[*step].name.as_str()).collect();
    let waits: Vec<String> = cycle.blocked.waiting.iter().map(ToString::to_string).collect();
    let fields = [
        ("cycle", json!(number)),
        ("now", json!(cycle.now)),
        ("inputs", values(&names.inputs, &cycle.inputs)),
        ("steps", json!(steps)),
        ("outputs", values(&names.outputs, &cycle.outputs)),
        ("variables", values(&names.variables, &cycle.variables)),
        ("happened", json!(happened(names, cycle))),
        ("stable", json!(cycle.is_stable)),
        ("waits", json!(waits)),
    ];
    fields.map(|(name, value)| (name.to_owned(), value)).into_iter().collect()
}

/// Values by their names.
pub(crate) fn values(signals: &[Signal], values: &[Value]) -> Json {
    let named = signals.iter().zip(values).map(|(signal, value)| (signal.name.clone(), json_of(value)));
    Json::Object(named.collect())
}

fn json_of(value: &Value) -> Json {
    match value {
        Value::Bool(value) => (*value).into(),
        Value::Int(value) => i64::try_from(*value).map_or_else(|_| value.to_string().into(), Into::into),
        Value::Float(value) => (*value).into(),
        Value::Ticks(value) => (*value).into(),
        Value::Name(name) => name.clone().into(),
        Value::Unknown => Json::Null,
    }
}
