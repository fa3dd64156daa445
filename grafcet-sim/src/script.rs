//! Cycles as lines of text.

use std::fmt;

use crate::names::{Kind, Names, Signal};
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
    script_of(&names.inputs, text)
}

/// The same of other signals, as the inputs and after them what the program contributes ([`Chart::outside`](crate::Chart::outside)). A
/// name that is no word stands in backquotes: `` `near(x, 3)` ``, `` `LIMIT`=80 ``.
///
/// # Errors
/// A word is no signal, or has a value that the signal cannot have.
pub fn script_of(signals: &[Signal], text: &str) -> Result<Vec<Scripted>, BadLine> {
    let mut now = 0;
    let mut cycles = Vec::new();
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.starts_with('#')) {
        let mut values: Vec<Value> = signals.iter().map(|signal| rest(&signal.kind)).collect();
        for word in script_words(line).into_iter().filter(|word| *word != "-") {
            let bad = || BadLine { line: index + 1, word: word.to_owned() };
            if let Some(time) = word.strip_prefix('@') {
                now = time.parse().map_err(|_| bad())?;
                continue;
            }
            let (name, value) = name_and_value(word);
            let place = signals.iter().position(|signal| signal.name == name).ok_or_else(bad)?;
            values[place] = read(&signals[place].kind, value).ok_or_else(bad)?;
        }
        cycles.push((now, values));
    }
    Ok(cycles)
}

/// The line of a script that [`script_of`] reads as these values, without a time; `-` where nothing is to be said.
#[must_use]
pub fn script_line(signals: &[Signal], values: &[Value]) -> String {
    let said = signals.iter().zip(values).filter(|(signal, value)| **value != rest(&signal.kind));
    let words: Vec<String> = said
        .map(|(signal, value)| {
            let is_word = signal.name.chars().all(|c| c.is_alphanumeric() || c == '_');
            let name = if is_word { signal.name.clone() } else { format!("`{}`", signal.name) };
            if value.is_true() { name } else { format!("{name}={value}") }
        })
        .collect();
    if words.is_empty() { "-".to_owned() } else { words.join(" ") }
}

/// The words of a line of a script: what stands between blanks that are not in backquotes.
#[must_use]
pub fn script_words(line: &str) -> Vec<&str> {
    let mut quoted = false;
    let words = line.split(|c: char| {
        quoted ^= c == '`';
        c.is_whitespace() && !quoted
    });
    words.filter(|word| !word.is_empty()).collect()
}

/// `level=300`, `` `LIMIT`=80 ``
fn name_and_value(word: &str) -> (&str, Option<&str>) {
    let quoted = word.strip_prefix('`').and_then(|rest| rest.split_once('`'));
    match quoted {
        Some((name, "")) => (name, None),
        // What else stands after the name is no value.
        Some((name, rest)) => (name, Some(rest.strip_prefix('=').unwrap_or(""))),
        None => word.split_once('=').map_or((word, None), |(name, value)| (name, Some(value))),
    }
}

/// What a signal is that nobody names.
pub(crate) fn rest(kind: &Kind) -> Value {
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

#[cfg(test)]
mod tests {
    use super::{script_line, script_of};
    use crate::{Kind, Signal, Value};

    #[test]
    fn what_is_written_is_read_again() {
        let signal = |name: &str, kind| Signal { name: name.to_owned(), kind };
        let signals = [
            signal("on", Kind::Bool),
            signal("level", Kind::Int { signed: true, bits: 16 }),
            signal("near(x, 3)", Kind::Bool),
            signal("LIMIT", Kind::Other(String::new())),
        ];
        let line = "on level=-3 `near(x, 3)` LIMIT=?";
        let cycles = script_of(&signals, &format!("@5 {line}\n-\n")).expect("a script");
        let [(5, values), (5, rest)] = &cycles[..] else { panic!("{cycles:?}") };
        assert_eq!(*values, [true.into(), Value::Int(-3), true.into(), "?".into()]);
        assert_eq!((script_line(&signals, values).as_str(), script_line(&signals, rest).as_str()), (line, "-"));
        for bad in ["`near(x, 4)`", "`near(x, 3)`x", "`near(x, 3)", "level", "`level`", "`level`="] {
            let error = script_of(&signals, bad).expect_err(bad);
            assert_eq!((error.line, error.word.as_str()), (1, bad));
        }
        assert_eq!(script_of(&signals, "`level`=7").map(|cycles| cycles[0].1[1].clone()), Ok(Value::Int(7)));
    }
}
