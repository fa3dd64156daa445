//! What the type of a value says about its comparisons: whether its values have an order, and where they end.

use super::differences::FAR;
use crate::model::{Binary, Model, Read, Tree, Ty, Unary, Variants};

/// How the values of a type are ordered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Sort {
    /// Of two values one is less, or they are equal: integers, times, booleans, characters.
    Total,
    /// Numbers, and what is no number (NaN).
    Float(Float),
    /// A type of the user, whose comparisons may mean anything.
    Own,
}

/// A floating-point type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Float {
    F32,
    F64,
}

/// How two values are ordered that are compared with each other; `None` where nothing is known. What is compared with a
/// value of a primitive type is taken to be one.
pub(super) fn common(model: &Model, a: &Tree, b: &Tree) -> Option<Sort> {
    match (sort(model, a), sort(model, b)) {
        (Some(Sort::Own), _) | (_, Some(Sort::Own)) => None,
        (a, b) => a.or(b),
    }
}

/// How the values of an expression are ordered; `None` where its type is not seen, as of a literal or a constant.
pub(super) fn sort(model: &Model, tree: &Tree) -> Option<Sort> {
    match tree {
        Tree::Read(Read::Name(name)) => Some(match model.ty(*name) {
            Ty::Bool(_) | Ty::Int { .. } | Ty::Time(_) => Sort::Total,
            Ty::Other(ty) => of_type(ty),
        }),
        Tree::Unary(_, inner) => sort(model, inner),
        Tree::Binary(operator, a, b) if is_arithmetic(*operator) => match (sort(model, a), sort(model, b)) {
            (Some(Sort::Own), _) | (_, Some(Sort::Own)) => Some(Sort::Own),
            (a, b) => a.or(b),
        },
        Tree::Bool(_) | Tree::Read(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) | Tree::Binary(..) => {
            Some(Sort::Total)
        }
        Tree::Opaque { whole: true, .. } => Some(Sort::Total),
        Tree::Int(_) | Tree::Opaque { .. } => None,
    }
}

fn of_type(ty: &syn::Type) -> Sort {
    const INTEGERS: [&str; 12] =
        ["u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128", "isize"];
    match ty {
        syn::Type::Reference(reference) => of_type(&reference.elem),
        syn::Type::Paren(inner) => of_type(&inner.elem),
        syn::Type::Group(inner) => of_type(&inner.elem),
        syn::Type::Path(path) => {
            let is = |name: &str| path.qself.is_none() && path.path.is_ident(name);
            match () {
                () if is("f32") => Sort::Float(Float::F32),
                () if is("f64") => Sort::Float(Float::F64),
                () if is("bool") || is("char") || is("str") || INTEGERS.iter().any(|name| is(name)) => Sort::Total,
                () => Sort::Own,
            }
        }
        _ => Sort::Own,
    }
}

/// The type of an expression that is a float.
pub(super) fn float(model: &Model, tree: &Tree) -> Option<Float> {
    match sort(model, tree) {
        Some(Sort::Float(float)) => Some(float),
        _ => None,
    }
}

/// The least and the greatest value of an integer expression or a time. Arithmetic that does not fit panics or goes on at
/// the other end, so that only its type bounds it; but for what makes numbers smaller.
pub(super) fn range(model: &Model, tree: &Tree) -> Option<(i128, i128)> {
    let narrowed = match tree {
        Tree::Binary(operator, a, b) => match (&**a, &**b, operator) {
            (a, Tree::Int(by), _) | (Tree::Int(by), a, Binary::BitAnd) => narrowed(*operator, range(model, a)?, *by),
            _ => None,
        },
        _ => None,
    };
    narrowed.or_else(|| of_type_of(model, tree))
}

/// The values that comparisons with constants are about: those of a number, or the places of an enum's variants in their list.
pub(super) fn domain(model: &Model, tree: &Tree) -> Option<(i128, i128)> {
    model.variants_of_tree(tree).map(Variants::range).or_else(|| range(model, tree))
}

/// All values that the type of an integer expression or a time has.
fn of_type_of(model: &Model, tree: &Tree) -> Option<(i128, i128)> {
    let ticks = (0, i128::from(u32::MAX));
    match tree {
        Tree::Read(Read::Since(_) | Read::MacroSince(_) | Read::Ticks(_)) => Some(ticks),
        Tree::Read(Read::Name(name)) => match model.ty(*name) {
            Ty::Time(_) => Some(ticks),
            Ty::Int { signed, bits, rust } => Some(of_integer(*signed, *bits, rust)),
            _ => None,
        },
        Tree::Unary(_, inner) => of_type_of(model, inner),
        Tree::Binary(Binary::Shl | Binary::Shr, a, _) => of_type_of(model, a),
        // In Rust, the operands of arithmetic have one type.
        Tree::Binary(operator, a, b) if is_arithmetic(*operator) => match common(model, a, b) {
            Some(Sort::Total) => of_type_of(model, a).or_else(|| of_type_of(model, b)),
            _ => None,
        },
        _ => None,
    }
}

fn of_integer(signed: bool, bits: u32, rust: &syn::Type) -> (i128, i128) {
    // On the host they have 64 bits, on the controller 32.
    let size = matches!(rust, syn::Type::Path(path) if path.path.is_ident("usize") || path.path.is_ident("isize"));
    match (signed, if size { 64 } else { bits }) {
        (true, bits @ 0..127) => (-(1 << (bits - 1)), (1 << (bits - 1)) - 1),
        (false, bits @ 0..126) => (0, (1 << bits) - 1),
        (true, _) => (-FAR, FAR),
        (false, _) => (0, FAR),
    }
}

/// What arithmetic with a constant leaves of the values between `low` and `high`.
fn narrowed(operator: Binary, (low, high): (i128, i128), by: i128) -> Option<(i128, i128)> {
    match operator {
        Binary::Rem if by != 0 => {
            let most = by.checked_abs()? - 1;
            Some((low.max(-most).min(0), high.min(most).max(0)))
        }
        Binary::BitAnd if by >= 0 && low >= 0 => Some((0, by.min(high))),
        Binary::BitAnd if by >= 0 => Some((0, by)),
        Binary::Div if by > 0 => Some((low / by, high / by)),
        // A shift by more bits than the type has may be another one.
        Binary::Shr if (0..8).contains(&by) => Some((low >> by, high >> by)),
        _ => None,
    }
}

pub(super) fn is_arithmetic(operator: Binary) -> bool {
    use Binary::{Add, BitAnd, BitOr, BitXor, Div, Mul, Rem, Shl, Shr, Sub};
    matches!(operator, Add | Sub | Mul | Div | Rem | BitAnd | BitOr | BitXor | Shl | Shr)
}

/// Whether it is the result of arithmetic and not a constant.
pub(super) fn is_computed(tree: &Tree) -> bool {
    let computes = match tree {
        Tree::Binary(operator, ..) => is_arithmetic(*operator),
        Tree::Unary(..) => true,
        Tree::Opaque { of, .. } => of.is_some(),
        _ => false,
    };
    computes && constant(tree).is_none()
}

/// The position of a float literal among all floats; both zeros have one.
pub(super) fn float_constant(tree: &Tree, float: Float) -> Option<i128> {
    match tree {
        Tree::Unary(Unary::Neg, inner) => float_constant(inner, float)?.checked_neg(),
        Tree::Opaque { text, reads, .. } if reads.is_empty() && text.starts_with(|c: char| c.is_ascii_digit()) => {
            let digits = text.replace('_', "");
            let digits = digits.trim_end_matches("f32").trim_end_matches("f64");
            // Of an `f32`, two literals may be one value.
            let value = match float {
                Float::F32 => f64::from(digits.parse::<f32>().ok()?),
                Float::F64 => digits.parse().ok()?,
            };
            value.is_finite().then(|| i128::from(value.to_bits()))
        }
        _ => None,
    }
}

/// The value of a constant expression.
pub(crate) fn constant(tree: &Tree) -> Option<i128> {
    match tree {
        Tree::Int(value) => Some(*value),
        Tree::Read(Read::Ticks(ticks)) => Some(i128::from(*ticks)),
        Tree::Unary(Unary::Neg, inner) => constant(inner)?.checked_neg(),
        Tree::Binary(operator, a, b) => {
            let (a, b) = (constant(a)?, constant(b)?);
            match operator {
                Binary::Add => a.checked_add(b),
                Binary::Sub => a.checked_sub(b),
                Binary::Mul => a.checked_mul(b),
                Binary::Div => a.checked_div(b),
                Binary::Rem => a.checked_rem(b),
                _ => None,
            }
        }
        _ => None,
    }
}
