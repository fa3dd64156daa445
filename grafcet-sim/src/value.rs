//! Values as a person names them.

use std::fmt;

use grafcet_compiler::model::{Model, Name, Ty};

use crate::interp::{self, Real, Symbol};

/// A value of an input, an output, a variable or a parameter.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// `bool`
    Bool(bool),
    /// Any primitive integer.
    Int(i128),
    /// `f32` or `f64`.
    Float(f64),
    /// `time`, in the unit of the chart's clock.
    Ticks(u32),
    /// A variant of an enum, without its type: `Auto`.
    Name(String),
    /// What `Default` gives for a type of the program, which the chart's source does not tell.
    Unknown,
}

impl Value {
    /// Whether it is `true`.
    #[must_use]
    pub fn is_true(&self) -> bool {
        *self == Self::Bool(true)
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(value) => value.fmt(f),
            Self::Int(value) => value.fmt(f),
            Self::Float(value) => {
                let text = format!("{:?}", short(*value));
                f.write_str(text.strip_suffix(".0").unwrap_or(&text))
            }
            Self::Ticks(value) => value.fmt(f),
            Self::Name(value) => value.fmt(f),
            Self::Unknown => f.write_str("?"),
        }
    }
}

/// With as few digits as tell it: what an `f32` holds has more of them as an `f64` than anybody has written, `0.1` is `0.10000000149011612`.
#[allow(clippy::cast_possible_truncation, reason = "whether anything is lost is asked")]
pub(crate) fn short(value: f64) -> f64 {
    let single = value as f32;
    if f64::from(single).to_bits() == value.to_bits() { single.to_string().parse().unwrap_or(value) } else { value }
}

impl From<bool> for Value {
    fn from(value: bool) -> Self {
        Self::Bool(value)
    }
}

impl From<&str> for Value {
    fn from(name: &str) -> Self {
        Self::Name(name.rsplit("::").next().unwrap_or(name).to_owned())
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::Float(value)
    }
}

impl From<f32> for Value {
    fn from(value: f32) -> Self {
        Self::Float(value.into())
    }
}

/// From primitive integers.
macro_rules! from_integers {
    ($($ty:ty),*) => {$(
        impl From<$ty> for Value {
            fn from(value: $ty) -> Self {
                Self::Int(value.into())
            }
        }
    )*};
}

from_integers!(u8, u16, u32, u64, i8, i16, i32, i64, i128);

/// The value as the interpreter has it, of a name of this type.
pub(crate) fn inside(value: &Value, ty: &Ty) -> interp::Value {
    match (value, ty) {
        (Value::Bool(value), _) => interp::Value::Bool(*value),
        // A number is a time where a time is wanted, as in a script.
        (Value::Int(value), Ty::Time(_)) => interp::Value::Ticks(u32::try_from(*value).unwrap_or(u32::MAX)),
        (Value::Int(value), _) => interp::Value::Int(*value),
        (Value::Float(value), _) => interp::Value::Real(Real(*value)),
        (Value::Ticks(value), _) => interp::Value::Ticks(*value),
        (Value::Name(name), _) => interp::Value::Name(Symbol::of(name)),
        (Value::Unknown, _) => interp::Value::Unknown,
    }
}

/// The value of a name, as a person has it: a variant by its name also where the chart lists it.
pub(crate) fn outside(value: interp::Value, name: Name, model: &Model) -> Value {
    match value {
        interp::Value::Int(place) => {
            let listed = model.variants_of(name).and_then(|listed| listed.list.get(usize::try_from(place).ok()?));
            listed.map_or(Value::Int(place), |variant| Value::Name(variant.name.to_string()))
        }
        other => plain(other),
    }
}

/// The value of nothing that has a name of its own.
pub(crate) fn plain(value: interp::Value) -> Value {
    match value {
        interp::Value::Bool(value) => Value::Bool(value),
        interp::Value::Int(value) => Value::Int(value),
        interp::Value::Ticks(value) => Value::Ticks(value),
        interp::Value::Real(value) => Value::Float(value.0),
        interp::Value::Name(name) => Value::Name(name.to_string()),
        interp::Value::Unknown => Value::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::Value;

    #[test]
    fn floats_have_as_few_digits_as_tell_them() {
        let text = |value: Value| value.to_string();
        let singles = [0.1_f32, 20.0, -0.0, 1.25, 8.507_059e37, 1e-40, f32::NAN, f32::NEG_INFINITY];
        let said = ["0.1", "20", "-0", "1.25", "8.507059e37", "1e-40", "NaN", "-inf"];
        assert_eq!(singles.map(|value| text(value.into())), said);
        assert_eq!([0.1_f64, 1.0 / 3.0, 1e300].map(|value| text(value.into())), ["0.1", "0.3333333333333333", "1e300"]);
    }
}
