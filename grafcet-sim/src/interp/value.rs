//! Values and their arithmetic: what Rust does in a debug build, a panic being an [`Error`].

use std::fmt;

use super::real::{Real, Symbol};
use super::variant;
use grafcet_compiler::model::{Binary, Ty, Unary};

/// A value of a declared name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Value {
    /// `bool`
    Bool(bool),
    /// Any primitive integer; the declared type says which values it can have.
    Int(i128),
    /// `time`, in the unit of the chart's clock.
    Ticks(u32),
    /// `f32` or `f64`.
    Real(Real),
    /// A variant of an enum. Where the chart lists it, what the chart stores is an `Int`: the place in the list.
    Name(Symbol),
    /// What `Default` gives for a type of the program: nobody here knows it.
    Unknown,
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(value) => value.fmt(f),
            Self::Int(value) => value.fmt(f),
            Self::Ticks(value) => write!(f, "{value}t"),
            Self::Real(value) => value.0.fmt(f),
            Self::Name(value) => value.fmt(f),
            Self::Unknown => f.write_str("?"),
        }
    }
}

/// Why a chart, or one cycle of it, cannot be interpreted.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Error {
    /// An arithmetic operation left its type: debug Rust would panic.
    Overflow(String),
    /// A division by zero: Rust would panic.
    DivisionByZero,
    /// Rust that the interpreter does not look into; its text.
    NotUnderstood(String),
    /// A declared type that the interpreter has no values for, or operands that do not belong together.
    Type(String),
    /// Not as many values as declared names.
    Count {
        /// How many there are names.
        expected: usize,
        /// How many values were given.
        found: usize,
    },
    /// A param that is not in the range which the chart states: the name and the range.
    OutOfRange(String, String),
    /// Combinational variables, partial grafcets or enclosures that depend on themselves (A14, A22).
    Circle(String),
    /// A combination of qualifier and target that the dialect does not have (A32).
    WrongTarget(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow(what) => write!(f, "overflow: {what}"),
            Self::DivisionByZero => f.write_str("division by zero"),
            Self::NotUnderstood(text) => write!(f, "not understood: {text}"),
            Self::Type(what) => write!(f, "type: {what}"),
            Self::Count { expected, found } => write!(f, "{found} values for {expected} names"),
            Self::OutOfRange(param, range) => write!(f, "`{param}` is not in `{range}`"),
            Self::Circle(name) => write!(f, "{name} depends on itself"),
            Self::WrongTarget(what) => write!(f, "wrong target: {what}"),
        }
    }
}

impl std::error::Error for Error {}

/// Whether Rust that has no node of its own is a literal, or the path of a variant.
pub(crate) fn is_literal(text: &str) -> bool {
    Term::literal(text).is_some()
}

/// The range of an integer type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Width {
    pub(super) signed: bool,
    pub(super) bits: u32,
}

impl Width {
    pub(super) fn holds(self, value: i128) -> bool {
        match (self.signed, self.bits) {
            (true, 128) => true,
            (false, 127..) => value >= 0,
            (true, bits) => (-(1_i128 << (bits - 1))..1_i128 << (bits - 1)).contains(&value),
            (false, bits) => (0..1_i128 << bits).contains(&value),
        }
    }
}

/// A value inside an expression. The type of a literal is not known before it meets a typed operand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Term {
    Bool(bool),
    Int(i128, Option<Width>),
    Ticks(u32),
    /// With whether it is an `f32`.
    Real(Real, Option<bool>),
    /// A variant, with its place where the chart lists it.
    Name(Symbol, Option<i128>),
}

impl Term {
    pub(super) fn bool(self) -> Result<bool, Error> {
        match self {
            Self::Bool(value) => Ok(value),
            other => Err(Error::Type(format!("{other:?} where a boolean is expected"))),
        }
    }

    /// The term of a declared name's value.
    pub(super) fn of(value: Value, ty: &Ty) -> Result<Self, Error> {
        Ok(match (accept(value, ty)?, ty) {
            (Value::Bool(value), _) => Self::Bool(value),
            (Value::Int(value), Ty::Int { signed, bits, .. }) => {
                Self::Int(value, Some(Width { signed: *signed, bits: *bits }))
            }
            (Value::Int(value), _) => Self::Int(value, None),
            (Value::Ticks(value), _) => Self::Ticks(value),
            (Value::Real(value), ty) => Self::Real(value, Some(is_single(ty))),
            (Value::Name(value), _) => Self::Name(value, None),
            (Value::Unknown, ty) => return Err(Error::NotUnderstood(format!("the default of {}", name(ty)))),
        })
    }

    /// The term of a value of which nobody says the type.
    pub(super) fn from_outside(value: Value, text: &str) -> Result<Self, Error> {
        Ok(match value {
            Value::Bool(value) => Self::Bool(value),
            Value::Int(value) => Self::Int(value, None),
            Value::Ticks(value) => Self::Ticks(value),
            Value::Real(value) => Self::Real(value, None),
            Value::Name(value) => Self::Name(value, None),
            Value::Unknown => return Err(Error::NotUnderstood(text.to_owned())),
        })
    }

    /// A literal that is no integer, or the path of a variant.
    pub(super) fn literal(text: &str) -> Option<Self> {
        let (digits, single) = match text.strip_suffix("f32") {
            Some(digits) => (digits, Some(true)),
            None => text.strip_suffix("f64").map_or((text, None), |digits| (digits, Some(false))),
        };
        let is_number = digits.starts_with(|c: char| c.is_ascii_digit());
        match digits.replace('_', "").parse::<f64>() {
            Ok(value) if is_number => Some(Self::Real(Real(value).rounded(single), single)),
            _ => Symbol::of_path(text).map(|variant| Self::Name(variant, None)),
        }
    }

    /// The value a name of this type takes from the term.
    pub(super) fn into_value(self, ty: &Ty) -> Result<Value, Error> {
        let value = match self {
            Self::Bool(value) => Value::Bool(value),
            Self::Int(value, _) => Value::Int(value),
            Self::Ticks(value) => Value::Ticks(value),
            Self::Real(value, _) => Value::Real(value.rounded(Some(is_single(ty)))),
            Self::Name(value, _) => Value::Name(value),
        };
        accept(value, ty)
    }
}

/// The value itself, if the type has it.
pub(super) fn accept(value: Value, ty: &Ty) -> Result<Value, Error> {
    match (value, ty) {
        (Value::Bool(_), Ty::Bool(_)) | (Value::Ticks(_), Ty::Time(_)) => Ok(value),
        (Value::Real(real), Ty::Other(_)) if ty.is_float() => Ok(Value::Real(real.rounded(Some(is_single(ty))))),
        // A variant is its place in the list where the chart lists it.
        (Value::Int(_) | Value::Name(_) | Value::Unknown, Ty::Other(_)) if !ty.is_float() => Ok(value),
        (Value::Int(int), Ty::Int { signed, bits, .. }) => {
            let width = Width { signed: *signed, bits: *bits };
            if width.holds(int) { Ok(value) } else { Err(Error::Overflow(format!("{int} in {bits} bits"))) }
        }
        (_, ty) => Err(Error::Type(format!("{value} for {}", name(ty)))),
    }
}

/// What `Default` gives for a type.
pub(super) fn default(ty: &Ty) -> Value {
    match ty {
        Ty::Bool(_) => Value::Bool(false),
        Ty::Int { .. } => Value::Int(0),
        Ty::Time(_) => Value::Ticks(0),
        Ty::Other(_) if ty.is_float() => Value::Real(Real(0.0)),
        Ty::Other(_) => Value::Unknown,
    }
}

fn name(ty: &Ty) -> String {
    match ty {
        Ty::Bool(_) => "bool".to_owned(),
        Ty::Int { signed, bits, .. } => format!("{}{bits}", if *signed { 'i' } else { 'u' }),
        Ty::Time(_) => "time".to_owned(),
        Ty::Other(ty) => quote::quote!(#ty).to_string(),
    }
}

fn is_single(ty: &Ty) -> bool {
    name(ty) == "f32"
}

/// `!a`, `-a`
pub(super) fn unary(operator: Unary, operand: Term) -> Result<Term, Error> {
    match (operator, operand) {
        (Unary::Not, Term::Bool(value)) => Ok(Term::Bool(!value)),
        (Unary::Not, Term::Int(value, Some(width))) if !width.signed => {
            let all = if width.bits >= 127 { i128::MAX } else { (1_i128 << width.bits) - 1 };
            Ok(Term::Int(all - value, Some(width)))
        }
        (Unary::Not, Term::Int(value, width)) => Ok(Term::Int(!value, width)),
        (Unary::Neg, Term::Real(value, single)) => Ok(Term::Real(Real(-value.0), single)),
        (Unary::Neg, Term::Int(value, width)) => int(value.checked_neg(), width, "negation"),
        (operator, operand) => Err(Error::Type(format!("{operator:?} of {operand:?}"))),
    }
}

/// A strict operation; the lazy `&&` and `||` are the evaluation's business.
pub(super) fn binary(operator: Binary, left: Term, right: Term) -> Result<Term, Error> {
    let wrong = || Error::Type(format!("{operator:?} of {left:?} and {right:?}"));
    match (left, right) {
        (Term::Bool(a), Term::Bool(b)) => booleans(operator, a, b),
        (Term::Ticks(a), Term::Ticks(b)) => ticks(operator, a, b),
        (Term::Int(a, left), Term::Int(b, right)) => {
            if matches!(operator, Binary::Shl | Binary::Shr) {
                return shift(operator, a, b, left);
            }
            integers(operator, a, b, common(left, right)?)
        }
        (Term::Real(a, left), Term::Real(b, right)) => reals(operator, a.0, b.0, left.or(right)),
        (Term::Name(a, left_place), Term::Name(b, right_place)) => {
            variant::compared(operator, (a, left_place), (b, right_place)).ok_or_else(wrong)
        }
        // In a condition a variant is written as its place in the list of what it is compared with.
        (Term::Name(_, Some(a)), Term::Int(b, None)) | (Term::Int(a, None), Term::Name(_, Some(b))) => {
            compare(operator, &a, &b).ok_or_else(wrong)
        }
        _ => Err(wrong()),
    }
}

/// Rust has no arithmetic between two integer types.
fn common(left: Option<Width>, right: Option<Width>) -> Result<Option<Width>, Error> {
    match (left, right) {
        (Some(a), Some(b)) if a != b => Err(Error::Type(format!("{a:?} with {b:?}"))),
        (a, b) => Ok(a.or(b)),
    }
}

pub(super) fn compare<T: PartialOrd>(operator: Binary, a: &T, b: &T) -> Option<Term> {
    Some(Term::Bool(match operator {
        Binary::Eq => a == b,
        Binary::Ne => a != b,
        Binary::Lt => a < b,
        Binary::Le => a <= b,
        Binary::Gt => a > b,
        Binary::Ge => a >= b,
        _ => return None,
    }))
}

fn reals(operator: Binary, a: f64, b: f64, single: Option<bool>) -> Result<Term, Error> {
    let [a, b] = [a, b].map(|value| Real(value).rounded(single).0);
    if let Some(result) = compare(operator, &a, &b) {
        return Ok(result);
    }
    // The result of two numbers of `f32` in `f64`, rounded once, is that of `f32`.
    let result = match operator {
        Binary::Add => a + b,
        Binary::Sub => a - b,
        Binary::Mul => a * b,
        Binary::Div => a / b,
        Binary::Rem => a % b,
        _ => return Err(Error::Type(format!("{operator:?} of floats"))),
    };
    Ok(Term::Real(Real(result).rounded(single), single))
}

fn booleans(operator: Binary, a: bool, b: bool) -> Result<Term, Error> {
    match operator {
        Binary::And | Binary::BitAnd => Ok(Term::Bool(a & b)),
        Binary::Or | Binary::BitOr => Ok(Term::Bool(a | b)),
        Binary::BitXor => Ok(Term::Bool(a ^ b)),
        _ => compare(operator, &a, &b).ok_or_else(|| Error::Type(format!("{operator:?} of booleans"))),
    }
}

/// `Ticks` add and subtract saturating.
fn ticks(operator: Binary, a: u32, b: u32) -> Result<Term, Error> {
    match operator {
        Binary::Add => Ok(Term::Ticks(a.saturating_add(b))),
        Binary::Sub => Ok(Term::Ticks(a.saturating_sub(b))),
        _ => compare(operator, &a, &b).ok_or_else(|| Error::Type(format!("{operator:?} of times"))),
    }
}

fn integers(operator: Binary, a: i128, b: i128, width: Option<Width>) -> Result<Term, Error> {
    if let Some(result) = compare(operator, &a, &b) {
        return Ok(result);
    }
    if matches!(operator, Binary::Div | Binary::Rem) && b == 0 {
        return Err(Error::DivisionByZero);
    }
    let result = match operator {
        Binary::Add => a.checked_add(b),
        Binary::Sub => a.checked_sub(b),
        Binary::Mul => a.checked_mul(b),
        Binary::Div => a.checked_div(b),
        // Rust refuses MIN % -1 as well: the division after it overflows.
        Binary::Rem => int(a.checked_div(b), width, "Rem").ok().and(a.checked_rem(b)),
        Binary::BitAnd => Some(a & b),
        Binary::BitOr => Some(a | b),
        Binary::BitXor => Some(a ^ b),
        _ => return Err(Error::Type(format!("{operator:?} of integers"))),
    };
    int(result, width, &format!("{a} {operator:?} {b}"))
}

/// The shifted operand gives the type; bits shifted out are lost, too wide a shift is an overflow.
fn shift(operator: Binary, a: i128, b: i128, width: Option<Width>) -> Result<Term, Error> {
    let bits = width.map_or(32, |w| w.bits);
    let Some(by) = u32::try_from(b).ok().filter(|by| *by < bits) else {
        return Err(Error::Overflow(format!("shift of {a} by {b}")));
    };
    if operator == Binary::Shr {
        return Ok(Term::Int(a >> by, width));
    }
    let Some(width) = width.filter(|w| w.bits < 64) else {
        return int(a.checked_mul(1_i128 << by.min(126)), width, "shift");
    };
    let modulus = 1_i128 << width.bits;
    let low = (a << by).rem_euclid(modulus);
    let value = if width.signed && low >= modulus / 2 { low - modulus } else { low };
    Ok(Term::Int(value, Some(width)))
}

/// A result that has to fit its type.
pub(super) fn int(result: Option<i128>, width: Option<Width>, what: &str) -> Result<Term, Error> {
    match result {
        Some(value) if width.is_none_or(|w| w.holds(value)) => Ok(Term::Int(value, width)),
        _ => Err(Error::Overflow(what.to_owned())),
    }
}
