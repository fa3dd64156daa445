//! Cycles as lines of text.

use std::fmt;

use crate::names::{Kind, Names};
use crate::value::Value;

/// One cycle of a script: its time, and a value for every input.
pub type Scripted = (u32, Vec<Value>);

/// A line of a script that is none.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BadLine {
    /// Counted from one.
    pub line: usize,
    /// The word that is wrong.
    pub word: String,
}

impl fmt::Display for BadLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: `{}` is no input of the chart with a value that it can have", self.line, self.word)
    }
}

impl std::error::Error for BadLine {}

/// Reads a script: one line per cycle with the inputs that are true, separated by blanks, and values as `level=300`, `mode=Auto`; what is
/// not named is false or zero. `@1500` is the time in ticks, in that cycle and from then on. `-` is a cycle of none of that; a line
/// that begins with `#` is no cycle.
///
/// # Errors
/// A word is no input, or has a value that the input cannot have.
pub fn script(names: &Names, text: &str) -> Result<Vec<Scripted>, BadLine> {
    let mut now = 0;
    let mut cycles = Vec::new();
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.starts_with('#')) {
        let mut inputs: Vec<Value> = names.inputs.iter().map(|input| rest(&input.kind)).collect();
        for word in line.split_whitespace().filter(|word| *word != "-") {
            let bad = || BadLine { line: index + 1, word: word.to_owned() };
            if let Some(time) = word.strip_prefix('@') {
                now = time.parse().map_err(|_| bad())?;
                continue;
            }
            let (name, value) = word.split_once('=').map_or((word, None), |(name, value)| (name, Some(value)));
            let place = names.inputs.iter().position(|input| input.name == name).ok_or_else(bad)?;
            inputs[place] = read(&names.inputs[place].kind, value).ok_or_else(bad)?;
        }
        cycles.push((now, inputs));
    }
    Ok(cycles)
}

/// What an input is that nobody names.
fn rest(kind: &Kind) -> Value {
    match kind {
        Kind::Bool => Value::Bool(false),
        Kind::Int { .. } => Value::Int(0),
        Kind::Float(_) => Value::Float(0.0),
        Kind::Time => Value::Ticks(0),
        Kind::Listed(_, names) => names.first().map_or(Value::Unknown, |first| Value::Name(first.clone())),
        Kind::Other(_) => Value::Unknown,
    }
}

fn read(kind: &Kind, text: Option<&str>) -> Option<Value> {
    match (kind, text) {
        (Kind::Bool, None | Some("true")) => Some(Value::Bool(true)),
        (Kind::Bool, Some("false")) => Some(Value::Bool(false)),
        (Kind::Int { .. }, Some(text)) => text.parse().ok().map(Value::Int),
        (Kind::Float(_), Some(text)) => text.parse().ok().map(Value::Float),
        (Kind::Time, Some(text)) => text.parse().ok().map(Value::Ticks),
        (Kind::Listed(_, names), Some(text)) => names.iter().find(|name| *name == text).cloned().map(Value::Name),
        (Kind::Other(_), Some(text)) => Some(text.into()),
        _ => None,
    }
}
