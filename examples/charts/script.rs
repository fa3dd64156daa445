//! Scripted input for the example charts, the same on the host and on the controller.
//!
//! A script has one line per cycle. A line names the inputs that are true in that cycle, separated by blanks, and gives
//! numbers as `level=300`; an input that is not named is false or zero. `@1500` says what the clock reads in that cycle
//! and from then on. An empty line or `-` means nothing of all that; a line that starts with `#` is a comment, not a
//! cycle.
//!
//! The answer is one plain line per cycle, `0 Off | - | red`: the number of the cycle, the active steps joined by `+`,
//! the inputs and the outputs that are neither false nor zero. After these, where there is
//! any, what else there is to tell, such as calls of code actions: `3 Heat | @1500 full | pump | first heat(80)`.

use core::error::Error;
use core::fmt::{self, Debug, Display, Write};

use grafcet::{Phase, heapless};

/// The value of a signal.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// Of a boolean signal.
    Flag(bool),
    /// Of any other.
    Number(i32),
}

impl Value {
    /// Whether it is worth showing: neither false nor zero.
    #[must_use]
    pub fn is_raised(self) -> bool {
        !matches!(self, Self::Flag(false) | Self::Number(0))
    }

    /// What `name` or `name=80` in a script gives to the signal; `None` where it is no number.
    fn read(text: Option<&str>) -> Option<Self> {
        text.map_or(Some(Self::Flag(true)), |text| text.parse().ok().map(Self::Number))
    }
}

/// A signal as it is written, `name` or `name=80`.
pub struct Named<'n>(pub &'n str, pub Value);

impl Display for Named<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.1 {
            Value::Flag(_) => f.write_str(self.0),
            Value::Number(number) => write!(f, "{}={number}", self.0),
        }
    }
}

impl From<bool> for Value {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl TryFrom<Value> for bool {
    type Error = Refusal;
    fn try_from(value: Value) -> Result<Self, Refusal> {
        if let Value::Flag(flag) = value { Ok(flag) } else { Err(Refusal::Value) }
    }
}

/// The types of numbers that the charts use.
macro_rules! numbers {
    ($($type:ty),+) => {$(
        impl From<$type> for Value {
            fn from(number: $type) -> Self {
                Self::Number(number.into())
            }
        }

        impl TryFrom<Value> for $type {
            type Error = Refusal;
            fn try_from(value: Value) -> Result<Self, Refusal> {
                let Value::Number(number) = value else { return Err(Refusal::Value) };
                Self::try_from(number).map_err(|_| Refusal::Value)
            }
        }
    )+};
}
numbers!(i16, u16);

/// Why a signal does not take a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Refusal {
    /// There is no signal of that name.
    Name,
    /// It has another type.
    Value,
}

/// A struct of inputs or outputs whose fields are known by name; `signals!` implements it.
pub trait Signals: Default {
    /// The names, in the order of declaration.
    const NAMES: &'static [&'static str];

    /// The values, in the order of [`Signals::NAMES`].
    fn values(&self) -> impl Iterator<Item = Value>;

    /// Gives the signal of this name a value.
    ///
    /// # Errors
    /// There is none, or it cannot have that value.
    fn set(&mut self, name: &str, value: Value) -> Result<(), Refusal>;
}

/// Implements [`Signals`] for a struct with these fields; `name in part` is the field `name` of its field `part`.
macro_rules! signals {
    ($type:ty: $($name:ident $(in $part:ident)?),+) => {
        impl super::script::Signals for $type {
            const NAMES: &'static [&'static str] = &[$(stringify!($name)),+];

            fn values(&self) -> impl Iterator<Item = super::script::Value> {
                [$(self.$($part.)?$name.into()),+].into_iter()
            }

            fn set(&mut self, name: &str, value: super::script::Value) -> Result<(), super::script::Refusal> {
                match name {
                    $(_ if name == stringify!($name) => self.$($part.)?$name = value.try_into()?,)+
                    _ => return Err(super::script::Refusal::Name),
                }
                Ok(())
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
    /// A line gives an input what it does not take, or the clock what is no time.
    WrongValue {
        /// The line of the script, counted from 1, comments included.
        line: usize,
        /// The input and its value as they stand there.
        word: &'s str,
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
            Self::WrongValue { line, word } => {
                write!(f, "line {line}: `{word}` is not of the type that is wanted there")
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

/// What else there is to tell about a cycle, above all what code actions are told in it: a chart's trait of actions is
/// implemented for it by [`Notes::call`].
#[derive(Default)]
pub struct Notes(heapless::String<96>);

impl Notes {
    /// Nothing to tell.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the call of the action `name`.
    pub fn call(&mut self, name: &str, phase: Phase, argument: impl Display) {
        let phase = match phase {
            Phase::First => "first",
            Phase::Repeated => "again",
            Phase::Final => "final",
        };
        self.add(format_args!("{phase} {name}({argument})"));
    }

    /// Adds a text.
    ///
    /// # Panics
    /// Where there is more to tell of a cycle than there is room for.
    pub fn add(&mut self, text: fmt::Arguments<'_>) {
        let separator = if self.0.is_empty() { "" } else { ", " };
        write!(self.0, "{separator}{text}").expect("the notes of a cycle fit");
    }
}

/// What a cycle of a chart answers: the outputs, the steps that are active then, and what else there is to tell.
pub type Answer<O, S> = (O, S, Notes);

/// Plays a script and writes one plain line per cycle. `cycle` runs one cycle of the chart on the inputs and the
/// reading of the clock.
///
/// # Errors
/// An unknown input or a wrong value, at its line (the cycles before it have run), or a failing `out`.
pub fn play<'s, I: Signals, O: Signals, S: IntoIterator<Item: Debug>>(
    script: &'s str,
    out: &mut dyn Write,
    mut cycle: impl FnMut(&I, u32) -> Answer<O, S>,
) -> Result<(), PlayError<'s>> {
    let (mut number, mut clock) = (0, 0);
    for (index, text) in script.lines().enumerate().filter(|(_, text)| !text.starts_with('#')) {
        let (inputs, now) = read::<I>(index + 1, text)?;
        clock = now.unwrap_or(clock);
        let (outputs, steps, notes) = cycle(&inputs, clock);
        write!(out, "{number} ")?;
        list(out, "+", steps, |out, step| write!(out, "{step:?}"))?;
        out.write_str(" | ")?;
        if let Some(now) = now {
            write!(out, "@{now} ")?;
        }
        raised(out, &inputs)?;
        out.write_str(" | ")?;
        raised(out, &outputs)?;
        if !notes.0.is_empty() {
            write!(out, " | {}", notes.0)?;
        }
        out.write_char('\n')?;
        number += 1;
    }
    Ok(())
}

/// The inputs of a line, and what the clock reads if it says so.
fn read<I: Signals>(line: usize, text: &str) -> Result<(I, Option<u32>), PlayError<'_>> {
    let (mut inputs, mut now) = (I::default(), None);
    for word in text.split_whitespace().filter(|&word| word != "-") {
        let wrong = PlayError::WrongValue { line, word };
        if let Some(time) = word.strip_prefix('@') {
            now = Some(time.parse().map_err(|_| wrong)?);
            continue;
        }
        let (name, value) = word.split_once('=').map_or((word, None), |(name, value)| (name, Some(value)));
        let value = Value::read(value).ok_or(wrong)?;
        inputs.set(name, value).map_err(|refusal| match refusal {
            Refusal::Name => PlayError::UnknownInput { line, name, known: I::NAMES },
            Refusal::Value => wrong,
        })?;
    }
    Ok((inputs, now))
}

fn raised<T: Signals>(out: &mut dyn Write, signals: &T) -> fmt::Result {
    let raised = T::NAMES.iter().zip(signals.values()).filter(|(_, value)| value.is_raised());
    list(out, " ", raised, |out, (name, value)| write!(out, "{}", Named(name, value)))
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
