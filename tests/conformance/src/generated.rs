//! What the modules of [`emit`](crate::emit) name.

pub use std::collections::BTreeSet;

pub use grafcet::{Chart, ForceError, Forceable, Phase, Ticks};

pub use crate::{Entry, Shown, Subject, Values};

/// A value of a chart as a number, and back.
pub trait Number: Copy {
    /// `true` is 1, a time is in ticks.
    fn number(self) -> i128;
    /// The value; a number that it cannot hold is a mistake of the timeline.
    fn from_number(number: i128) -> Option<Self>;
}

impl Number for bool {
    fn number(self) -> i128 {
        i128::from(self)
    }
    fn from_number(number: i128) -> Option<Self> {
        Some(number != 0)
    }
}

impl Number for Ticks {
    fn number(self) -> i128 {
        i128::from(self.get())
    }
    fn from_number(number: i128) -> Option<Self> {
        u32::try_from(number).ok().map(Self::new)
    }
}

/// The enum of random charts.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Mode {
    /// Its default.
    #[default]
    Off,
    /// The second.
    Auto,
    /// The last.
    Manual,
}

impl Number for Mode {
    fn number(self) -> i128 {
        self as i128
    }
    fn from_number(number: i128) -> Option<Self> {
        [Self::Off, Self::Auto, Self::Manual].into_iter().find(|mode| mode.number() == number)
    }
}

macro_rules! integers {
    ($($ty:ty)*) => {$(
        impl Number for $ty {
            fn number(self) -> i128 {
                i128::try_from(self).unwrap_or(i128::MAX)
            }
            fn from_number(number: i128) -> Option<Self> {
                Self::try_from(number).ok()
            }
        }
    )*};
}

integers!(u8 u16 u32 u64 u128 usize i8 i16 i32 i64 i128 isize);

/// Methods that a chart may have; one that it has comes first.
pub trait Fallback {
    /// A chart without time.
    fn next_deadline(&self) -> Option<Ticks> {
        None
    }
    /// An `sfc`.
    fn is_stable(&self) -> bool {
        true
    }
}

impl<C: Chart> Fallback for C {}

/// The value as a number.
pub fn number(value: impl Number) -> i128 {
    value.number()
}

/// The value of a name; false or zero where it is not given.
///
/// # Panics
/// The timeline gives it a number that its type does not have.
#[must_use]
pub fn take<T: Number>(values: &Values, name: &str) -> T {
    let number = values.get(name).copied().unwrap_or_default();
    T::from_number(number).unwrap_or_else(|| panic!("`{name}` cannot be {number}"))
}

/// Replaces the value of a name that is given.
pub fn replace<T: Number>(values: &Values, name: &str, value: &mut T) {
    if values.contains_key(name) {
        *value = take(values, name);
    }
}

/// `first heat(80)`
#[must_use]
pub fn call(phase: Phase, action: &str, args: &[i128]) -> String {
    let args: Vec<String> = args.iter().map(ToString::to_string).collect();
    format!("{} {action}({})", format!("{phase:?}").to_lowercase(), args.join(","))
}

/// The outputs that are not zero, and the steps that are late.
#[must_use]
pub fn outputs<const N: usize>(outputs: [(&str, i128); N], late: Vec<String>) -> Values {
    let outputs = outputs.into_iter().filter(|(_, value)| *value != 0);
    outputs.map(|(name, value)| (name.to_owned(), value)).chain(late.into_iter().map(|step| (step, 1))).collect()
}

/// What a chart says of late steps.
pub fn late<C: Chart>(_: &C, late: impl IntoIterator<Item = C::Step>) -> Vec<String> {
    late.into_iter().map(|step| format!("late({step:?})")).collect()
}

/// The steps of these names.
#[must_use]
pub fn named<C: Chart>(_: &C, names: &BTreeSet<String>) -> Vec<C::Step> {
    C::STEPS.iter().copied().filter(|step| names.contains(&format!("{step:?}"))).collect()
}

/// The active steps, by all ways the chart has to say it; where these disagree, a name says so.
pub fn steps<C: Chart>(chart: &C, active: &[C::Step]) -> BTreeSet<String> {
    let mut steps: BTreeSet<String> = active.iter().map(|step| format!("{step:?}")).collect();
    let asked: Vec<C::Step> = C::STEPS.iter().copied().filter(|step| chart.is_active(*step)).collect();
    // As each step is asked for once, equal counts leave no place for one that is listed twice.
    if asked.len() != active.len() || !asked.iter().all(|step| active.contains(step)) {
        steps.insert(format!("active_steps={active:?}!=is_active"));
    }
    compare_with(&format!("{:?}", chart.situation()), &mut steps);
    steps
}

/// Adds what a situation shows, where that is not exactly these steps. No part of [`steps`], which is built for each chart anew.
fn compare_with(situation: &str, steps: &mut BTreeSet<String>) {
    let words = situation.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    let shown: BTreeSet<&str> = words.collect();
    if !shown.iter().eq(steps.iter()) {
        steps.insert(format!("situation={situation}"));
    }
}
