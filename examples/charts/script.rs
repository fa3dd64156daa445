//! Scripted input for the example charts, the same on the host and on the controller.
//!
//! A script has one line per cycle. A line names the inputs that are true in that cycle, separated by blanks; an empty
//! line or `-` means none. A line that starts with `#` is a comment, not a cycle.
//!
//! The answer is one plain line per cycle, `0 Off | - | red`: the number of the cycle, the active steps joined by `+`,
//! the inputs and the outputs that are true.

use core::error::Error;
use core::fmt::{self, Debug, Display, Write};

/// A struct of boolean inputs or outputs whose fields are known by name; [`signals!`] implements it.
pub trait Signals: Default {
    /// The names, in the order of declaration.
    const NAMES: &'static [&'static str];

    /// The values, in the order of [`Signals::NAMES`].
    fn values(&self) -> impl Iterator<Item = bool>;

    /// Makes the signal of this name true; answers whether there is one.
    fn raise(&mut self, name: &str) -> bool;
}

/// Implements [`Signals`] for a struct with these boolean fields.
macro_rules! signals {
    ($type:ty: $($name:ident),+) => {
        impl Signals for $type {
            const NAMES: &'static [&'static str] = &[$(stringify!($name)),+];

            fn values(&self) -> impl Iterator<Item = bool> {
                [$(self.$name),+].into_iter()
            }

            fn raise(&mut self, name: &str) -> bool {
                match name {
                    $(_ if name == stringify!($name) => self.$name = true,)+
                    _ => return false,
                }
                true
            }
        }
    };
}
pub(crate) use signals;

/// Why a script could not be played to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlayError<'s> {
    /// A line names an input that the chart does not have.
    UnknownInput {
        /// The line of the script, counted from 1, comments included.
        line: usize,
        /// The name as it stands there.
        name: &'s str,
        /// The inputs that the chart has.
        known: &'static [&'static str],
    },
    /// The plain lines could not be written.
    Write(fmt::Error),
}

impl Display for PlayError<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownInput { line, name, known } => {
                write!(f, "line {line}: there is no input `{name}`; the inputs are ")?;
                list(f, ", ", *known, |out, name| out.write_str(name))
            }
            Self::Write(error) => write!(f, "cannot write the lines of the cycles: {error}"),
        }
    }
}

impl Error for PlayError<'_> {}

impl From<fmt::Error> for PlayError<'_> {
    fn from(error: fmt::Error) -> Self {
        Self::Write(error)
    }
}

/// Plays a script and writes one plain line per cycle. `cycle` runs one cycle of the chart and answers with the outputs
/// and the steps that are active then.
///
/// # Errors
/// An unknown input, at its line (the cycles before it have run), or a failing `out`.
pub fn play<'s, I: Signals, O: Signals, S: IntoIterator<Item: Debug>>(
    script: &'s str,
    out: &mut dyn Write,
    mut cycle: impl FnMut(&I) -> (O, S),
) -> Result<(), PlayError<'s>> {
    for (number, inputs) in inputs::<I>(script).enumerate() {
        let inputs = inputs?;
        let (outputs, steps) = cycle(&inputs);
        write!(out, "{number} ")?;
        list(out, "+", steps, |out, step| write!(out, "{step:?}"))?;
        out.write_str(" | ")?;
        raised(out, &inputs)?;
        out.write_str(" | ")?;
        raised(out, &outputs)?;
        out.write_char('\n')?;
    }
    Ok(())
}

/// The inputs of every cycle of a script.
fn inputs<I: Signals>(script: &str) -> impl Iterator<Item = Result<I, PlayError<'_>>> {
    script.lines().enumerate().filter(|(_, text)| !text.starts_with('#')).map(|(index, text)| {
        let mut inputs = I::default();
        for name in text.split_whitespace().filter(|&name| name != "-") {
            if !inputs.raise(name) {
                return Err(PlayError::UnknownInput { line: index + 1, name, known: I::NAMES });
            }
        }
        Ok(inputs)
    })
}

fn raised<T: Signals>(out: &mut dyn Write, signals: &T) -> fmt::Result {
    let names = T::NAMES.iter().zip(signals.values()).filter_map(|(name, value)| value.then_some(name));
    list(out, " ", names, |out, name| out.write_str(name))
}

/// The items with separators between them, or `-` where there are none.
fn list<T>(
    out: &mut dyn Write,
    separator: &str,
    items: impl IntoIterator<Item = T>,
    show: impl Fn(&mut dyn Write, T) -> fmt::Result,
) -> fmt::Result {
    let mut items = items.into_iter();
    let Some(first) = items.next() else {
        return out.write_char('-');
    };
    show(out, first)?;
    items.try_for_each(|item| {
        out.write_str(separator)?;
        show(out, item)
    })
}
