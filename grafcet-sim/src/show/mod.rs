//! What a trace looks like.

mod chronogram;
mod json;
mod page;
mod table;
mod wave;

pub use chronogram::chronogram;
pub use page::page;
pub use table::{happened, table};
pub use wave::vcd;

use crate::names::Signal;
use crate::trace::Trace;
use crate::value::Value;

/// What the way from left to right means.
pub(crate) struct Axis {
    /// Where each cycle begins: ticks since the first, or its number where the chart's clock stands still.
    pub(crate) starts: Vec<u64>,
    /// Where the last one ends.
    pub(crate) end: u64,
    pub(crate) is_time: bool,
}

impl Axis {
    pub(crate) fn of(trace: &Trace) -> Self {
        let times = trace.times();
        let last = times.last().copied().unwrap_or(0);
        if last == 0 {
            let cycles = trace.cycles.len() as u64;
            return Self { starts: (0..cycles).collect(), end: cycles.max(1), is_time: false };
        }
        // The last cycle lasts as long as one of the others.
        let mean = (last / (times.len() as u64 - 1)).max(1);
        Self { starts: times, end: last + mean, is_time: true }
    }

    /// A place on it in words.
    pub(crate) fn label(&self, trace: &Trace, at: u64) -> String {
        if self.is_time { trace.names.time(at) } else { at.to_string() }
    }
}

/// `auto part level=3`: what is neither false nor zero.
pub(crate) fn raised(signals: &[Signal], values: &[Value]) -> String {
    let is_at_rest = |value: &Value| match value {
        Value::Bool(value) => !value,
        Value::Int(value) => *value == 0,
        Value::Float(value) => *value == 0.0,
        Value::Ticks(value) => *value == 0,
        Value::Name(_) => false,
        Value::Unknown => true,
    };
    let raised = signals.iter().zip(values).filter(|(_, value)| !is_at_rest(value));
    let words: Vec<String> = raised
        .map(|(signal, value)| match value {
            Value::Bool(_) => signal.name.clone(),
            value => format!("{}={value}", signal.name),
        })
        .collect();
    if words.is_empty() { "-".to_owned() } else { words.join(" ") }
}

/// What XML and HTML read as this text.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
