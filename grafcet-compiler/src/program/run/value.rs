//! The user's arithmetic on values: what Rust does in a debug build, a panic being an [`Error`].

use std::fmt;

use super::{Type, Value};
use crate::model::{Binary, Ty, Unary};

/// Why a program cannot go on.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Error {
    /// Arithmetic that leaves its type, or divides by zero: Rust would panic.
    Arithmetic(String),
    /// Rust that nobody runs; its text.
    NotUnderstood(String),
    /// Operands that do not belong together.
    Type(String),
    /// A loop went on for more rounds than it can.
    Bound(u32),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Arithmetic(what) => write!(f, "arithmetic: {what}"),
            Self::NotUnderstood(text) => write!(f, "not understood: {text}"),
            Self::Type(what) => write!(f, "type: {what}"),
            Self::Bound(rounds) => write!(f, "a loop of {rounds} rounds has not ended"),
        }
    }
}

impl std::error::Error for Error {}

/// The range of an integer type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Width {
    signed: bool,
    bits: u32,
}

/// A value in an expression. A literal has no type of its own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Term {
    Int(i128, Option<Width>),
    Value(Value),
}

impl Width {
    fn of(ty: &Ty) -> Option<Self> {
        match ty {
            Ty::Int { signed, bits, .. } => Some(Self { signed: *signed, bits: *bits }),
            _ => None,
        }
    }

    fn has(self, value: i128) -> bool {
        // Values of 128 bits are only known as far as `i128` goes.
        let magnitude = if self.signed { self.bits.saturating_sub(1) } else { self.bits };
        let above = if magnitude >= 127 { i128::MAX } else { (1_i128 << magnitude) - 1 };
        let under = if self.signed { -above - 1 } else { 0 };
        (under..=above).contains(&value)
    }
}

impl Term {
    pub(super) fn of(value: Value, ty: Option<&Ty>) -> Self {
        match value {
            Value::Int(number) => Self::Int(number, ty.and_then(Width::of)),
            other => Self::Value(other),
        }
    }

    pub(super) fn plain(self) -> Value {
        match self {
            Self::Int(number, _) => Value::Int(number),
            Self::Value(value) => value,
        }
    }

    pub(super) fn bool(self) -> Result<bool, Error> {
        match self {
            Self::Value(Value::Bool(value)) => Ok(value),
            other => Err(Error::Type(format!("{other:?} for a boolean"))),
        }
    }

    pub(super) fn ticks(self) -> Result<u32, Error> {
        match self {
            Self::Value(Value::Ticks(ticks)) => Ok(ticks),
            other => Err(Error::Type(format!("{other:?} for a time"))),
        }
    }

    /// The value that a place of the type takes.
    pub(super) fn into_value(self, ty: Type<'_>) -> Result<Value, Error> {
        match (self, ty) {
            (Self::Value(value @ Value::Bool(_)), Type::Bool)
            | (Self::Value(value @ Value::Ticks(_)), Type::Ticks)
            | (Self::Value(value @ (Value::Step(_) | Value::Start(_))), Type::State(_)) => Ok(value),
            (Self::Int(number, _), Type::Number | Type::Kind { .. }) => Ok(Value::Int(number)),
            (term, Type::User(ty)) => term.into_declared(ty),
            (term, _) => Err(Error::Type(format!("{term:?}"))),
        }
    }

    /// The value that something of a declared type takes.
    pub(super) fn into_declared(self, ty: &Ty) -> Result<Value, Error> {
        match (self, ty) {
            (Self::Value(value @ Value::Bool(_)), Ty::Bool(_))
            | (Self::Value(value @ Value::Ticks(_)), Ty::Time(_))
            | (Self::Value(value), Ty::Other(_)) => Ok(value),
            (Self::Int(number, _), Ty::Other(_)) => Ok(Value::Int(number)),
            (Self::Int(number, _), Ty::Int { .. }) if Width::of(ty).is_some_and(|width| width.has(number)) => {
                Ok(Value::Int(number))
            }
            (Self::Int(number, _), Ty::Int { .. }) => Err(Error::Arithmetic(format!("{number} does not fit"))),
            (term, _) => Err(Error::Type(format!("{term:?}"))),
        }
    }

    /// `!a`, `-a`
    pub(super) fn unary(self, operator: Unary) -> Result<Self, Error> {
        match (operator, self) {
            (Unary::Not, Self::Value(Value::Bool(value))) => Ok(Self::Value(Value::Bool(!value))),
            (Unary::Not, Self::Int(number, Some(width))) if !width.signed => {
                let all = if width.bits >= 127 { i128::MAX } else { (1_i128 << width.bits) - 1 };
                Ok(Self::Int(all - number, Some(width)))
            }
            (Unary::Not, Self::Int(number, width)) => Ok(Self::Int(!number, width)),
            (Unary::Neg, Self::Int(number, width)) => fitting(number.checked_neg(), width, "negation"),
            (_, term) => Err(Error::Type(format!("{operator:?} of {term:?}"))),
        }
    }

    /// All operators but the lazy ones.
    pub(super) fn binary(self, operator: Binary, other: Self) -> Result<Self, Error> {
        use Value::{Bool, Ticks};
        if let (Self::Int(a, left), Self::Int(b, right)) = (self, other) {
            return integers(operator, a, b, left, right);
        }
        let (a, b) = (self.plain(), other.plain());
        let comparable = std::mem::discriminant(&a) == std::mem::discriminant(&b);
        if let Some(holds) = compared(operator, a.cmp(&b)).filter(|_| comparable) {
            return Ok(Self::Value(Bool(holds)));
        }
        match (operator, a, b) {
            (Binary::BitAnd, Bool(a), Bool(b)) => Ok(Self::Value(Bool(a & b))),
            (Binary::BitOr, Bool(a), Bool(b)) => Ok(Self::Value(Bool(a | b))),
            (Binary::BitXor, Bool(a), Bool(b)) => Ok(Self::Value(Bool(a ^ b))),
            (Binary::Add, Ticks(a), Ticks(b)) => Ok(Self::Value(Ticks(a.saturating_add(b)))),
            (Binary::Sub, Ticks(a), Ticks(b)) => Ok(Self::Value(Ticks(a.saturating_sub(b)))),
            _ => Err(Error::Type(format!("{operator:?} of {a:?} and {b:?}"))),
        }
    }
}

fn compared(operator: Binary, order: std::cmp::Ordering) -> Option<bool> {
    match operator {
        Binary::Eq => Some(order.is_eq()),
        Binary::Ne => Some(order.is_ne()),
        Binary::Lt => Some(order.is_lt()),
        Binary::Le => Some(order.is_le()),
        Binary::Gt => Some(order.is_gt()),
        Binary::Ge => Some(order.is_ge()),
        _ => None,
    }
}

fn integers(operator: Binary, a: i128, b: i128, left: Option<Width>, right: Option<Width>) -> Result<Term, Error> {
    if let Some(holds) = compared(operator, a.cmp(&b)) {
        return Ok(Term::Value(Value::Bool(holds)));
    }
    let width = left.or(right);
    let sum = match operator {
        Binary::Add => a.checked_add(b),
        Binary::Sub => a.checked_sub(b),
        Binary::Mul => a.checked_mul(b),
        Binary::Div => a.checked_div(b),
        // The division after it overflows where it does.
        Binary::Rem => fitting(a.checked_div(b), width, "remainder").ok().and(a.checked_rem(b)),
        Binary::BitAnd => Some(a & b),
        Binary::BitOr => Some(a | b),
        Binary::BitXor => Some(a ^ b),
        Binary::Shl | Binary::Shr => return shifted(operator, a, b, left),
        _ => return Err(Error::Type(format!("{operator:?} of integers"))),
    };
    fitting(sum, width, &format!("{a} {operator:?} {b}"))
}

/// Bits shifted out are lost; too wide a shift panics.
fn shifted(operator: Binary, a: i128, b: i128, width: Option<Width>) -> Result<Term, Error> {
    let bits = width.map_or(32, |width| width.bits);
    let by = u32::try_from(b).ok().filter(|by| *by < bits);
    let Some(by) = by else { return Err(Error::Arithmetic(format!("{a} shifted by {b}"))) };
    if operator == Binary::Shr {
        return Ok(Term::Int(a >> by, width));
    }
    let unused = 128 - bits;
    // Up to the top and back again: what does not fit is gone, and the sign is that of the type.
    let top = a.wrapping_shl(by).wrapping_shl(unused);
    let signed = width.is_none_or(|width| width.signed);
    let kept = if unused == 0 { -1 } else { (1_i128 << bits.min(126)) - 1 };
    let back = if signed { top >> unused } else { (top >> unused) & kept };
    Ok(Term::Int(back, width))
}

fn fitting(result: Option<i128>, width: Option<Width>, what: &str) -> Result<Term, Error> {
    match result {
        Some(number) if width.is_none_or(|width| width.has(number)) => Ok(Term::Int(number, width)),
        _ => Err(Error::Arithmetic(what.to_owned())),
    }
}
