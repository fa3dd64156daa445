//! Which calls of methods leave the value as it is that they are called on.
//!
//! The compiler sees no types but the declared ones. Of those that it knows (numbers, times, arrays, texts, options) a method
//! of the standard library by `self` or `&self` is found before any other of its name; of a type that nobody can know only
//! what has one meaning all over Rust is taken for a read. Whatever else is called may write.

use proc_macro2::Ident;
use syn::{Expr, ExprMethodCall, Member, Type};

use crate::list::List;
use crate::model::Ty;

/// The name that a place is a part of: `a` of `a.b[1]`.
pub(crate) fn root(expr: &Expr) -> Option<&Ident> {
    match expr {
        Expr::Field(field) => root(&field.base),
        Expr::Index(index) => root(&index.expr),
        Expr::Paren(paren) => root(&paren.expr),
        Expr::Path(path) if path.qself.is_none() => path.path.get_ident(),
        _ => None,
    }
}

/// The names whose places an assignment to `left` writes: `a` and `b` of `(a, b.c) = …`.
pub(crate) fn targets(left: &Expr) -> Vec<&Ident> {
    match left {
        Expr::Tuple(tuple) => tuple.elems.iter().flat_map(targets).list(),
        Expr::Array(array) => array.elems.iter().flat_map(targets).list(),
        Expr::Call(call) => call.args.iter().flat_map(targets).list(),
        Expr::Struct(fields) => fields.fields.iter().flat_map(|field| targets(&field.expr)).list(),
        Expr::Paren(paren) => targets(&paren.expr),
        place => root(place).into_iter().list(),
    }
}

/// Whether the call, on a place that is or belongs to a name of type `ty`, certainly only reads it.
pub(crate) fn only_reads(call: &ExprMethodCall, ty: &Ty) -> bool {
    let name = call.method.to_string();
    OF_ALL.contains(&&*name) || reads(&kind(&call.receiver, ty), &name)
}

/// Whether the standard library has a method of this name that reads such a value and has no other effect.
pub(crate) fn reads(kind: &Kind<'_>, name: &str) -> bool {
    let is_in = |list: &[&str]| list.contains(&name);
    match kind {
        Kind::Number => is_in(OF_ALL) || is_in(OF_NUMBERS) || is_checked(name),
        Kind::Time => is_in(OF_ALL) || is_in(&["get", "since", "after", "min", "max", "clamp", "add", "sub"]),
        Kind::List(_) => is_in(OF_LISTS),
        Kind::Option => is_in(OF_OPTIONS),
        Kind::Duration => is_in(OF_ALL) || is_in(OF_DURATIONS) || is_checked(name),
        Kind::Tuple(_) | Kind::Unknown => false,
    }
}

pub(crate) fn is_primitive(name: &str) -> bool {
    PRIMITIVE.contains(&name)
}

/// A type as far as it is known.
pub(crate) enum Kind<'t> {
    Number,
    Time,
    /// An array, a slice or a text.
    List(Option<&'t Type>),
    Option,
    Tuple(&'t syn::TypeTuple),
    Duration,
    Unknown,
}

/// What a place is whose name has the type `ty`.
pub(crate) fn kind<'t>(place: &Expr, ty: &'t Ty) -> Kind<'t> {
    match place {
        Expr::Paren(paren) => kind(&paren.expr, ty),
        Expr::Path(_) => match ty {
            Ty::Bool(_) | Ty::Int { .. } => Kind::Number,
            Ty::Time(_) => Kind::Time,
            Ty::Other(rust) => kind_of(rust),
        },
        Expr::Index(index) => match kind(&index.expr, ty) {
            list @ Kind::List(_) if matches!(&*index.index, Expr::Range(_)) => list,
            Kind::List(Some(element)) => kind_of(element),
            _ => Kind::Unknown,
        },
        Expr::Field(field) => match (kind(&field.base, ty), &field.member) {
            (Kind::Tuple(tuple), Member::Unnamed(at)) => {
                tuple.elems.iter().nth(at.index as usize).map_or(Kind::Unknown, kind_of)
            }
            _ => Kind::Unknown,
        },
        _ => Kind::Unknown,
    }
}

/// What a type is.
pub(crate) fn kind_of(rust: &Type) -> Kind<'_> {
    match rust {
        Type::Paren(paren) => kind_of(&paren.elem),
        Type::Array(array) => Kind::List(Some(&array.elem)),
        Type::Slice(slice) => Kind::List(Some(&slice.elem)),
        Type::Tuple(tuple) => Kind::Tuple(tuple),
        // What a shared reference leads to is not written through it.
        Type::Reference(reference) if reference.mutability.is_none() => match &*reference.elem {
            Type::Path(path) if path.path.is_ident("str") => Kind::List(None),
            list @ (Type::Array(_) | Type::Slice(_)) => kind_of(list),
            _ => Kind::Unknown,
        },
        Type::Path(path) if path.qself.is_none() => of_path(&path.path),
        _ => Kind::Unknown,
    }
}

fn of_path(path: &syn::Path) -> Kind<'_> {
    let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).list();
    let names: Vec<&str> = names.iter().map(String::as_str).list();
    match &names[..] {
        [number] if PRIMITIVE.contains(number) => Kind::Number,
        ["Option"] | ["core" | "std", "option", "Option"] => Kind::Option,
        ["Duration"] | ["core" | "std", "time", "Duration"] => Kind::Duration,
        _ => Kind::Unknown,
    }
}

const PRIMITIVE: &[&str] = &[
    "bool", "char", "u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128", "isize", "f32",
    "f64",
];

/// By `&self` in the prelude, whatever type has them.
const OF_ALL: &[&str] =
    &["clone", "eq", "ne", "cmp", "partial_cmp", "lt", "le", "gt", "ge", "to_owned", "to_string", "hash", "fmt"];

/// `wrapping_add` and its kin.
fn is_checked(name: &str) -> bool {
    const HOW: &[&str] =
        &["wrapping_", "checked_", "saturating_", "overflowing_", "strict_", "unbounded_", "unchecked_"];
    const WHAT: &[&str] = &[
        "add",
        "add_signed",
        "add_unsigned",
        "sub",
        "sub_signed",
        "sub_unsigned",
        "signed_diff",
        "mul",
        "div",
        "div_euclid",
        "div_exact",
        "rem",
        "rem_euclid",
        "neg",
        "abs",
        "pow",
        "shl",
        "shr",
        "isqrt",
        "ilog",
        "ilog2",
        "ilog10",
        "next_power_of_two",
        "next_multiple_of",
    ];
    HOW.iter().any(|how| name.strip_prefix(how).is_some_and(|what| WHAT.contains(&what)))
}

/// By `self` or `&self` on integers, floats, `bool` and `char`.
const OF_NUMBERS: &[&str] = &[
    // Of all.
    "min",
    "max",
    "clamp",
    "into",
    "try_into",
    "add",
    "sub",
    "mul",
    "div",
    "rem",
    "neg",
    "not",
    "bitand",
    "bitor",
    "bitxor",
    "shl",
    "shr",
    "abs",
    "abs_diff",
    "unsigned_abs",
    "signum",
    "pow",
    "midpoint",
    "is_positive",
    "is_negative",
    "div_euclid",
    "rem_euclid",
    "div_ceil",
    "div_floor",
    "next_multiple_of",
    "is_multiple_of",
    "isqrt",
    "ilog",
    "ilog2",
    "ilog10",
    "is_power_of_two",
    "next_power_of_two",
    "cast_signed",
    "cast_unsigned",
    // Bits and bytes.
    "count_ones",
    "count_zeros",
    "leading_zeros",
    "leading_ones",
    "trailing_zeros",
    "trailing_ones",
    "rotate_left",
    "rotate_right",
    "swap_bytes",
    "reverse_bits",
    "to_be",
    "to_le",
    "to_be_bytes",
    "to_le_bytes",
    "to_ne_bytes",
    "to_bits",
    "carrying_add",
    "borrowing_sub",
    "carrying_mul",
    "widening_mul",
    // `bool`.
    "then",
    "then_some",
    // Floats.
    "floor",
    "ceil",
    "round",
    "round_ties_even",
    "trunc",
    "fract",
    "copysign",
    "mul_add",
    "powi",
    "powf",
    "sqrt",
    "cbrt",
    "exp",
    "exp2",
    "exp_m1",
    "ln",
    "ln_1p",
    "log",
    "log2",
    "log10",
    "hypot",
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "sin_cos",
    "sinh",
    "cosh",
    "tanh",
    "asinh",
    "acosh",
    "atanh",
    "recip",
    "to_degrees",
    "to_radians",
    "minimum",
    "maximum",
    "total_cmp",
    "is_nan",
    "is_infinite",
    "is_finite",
    "is_subnormal",
    "is_normal",
    "classify",
    "is_sign_positive",
    "is_sign_negative",
    "next_up",
    "next_down",
    "to_int_unchecked",
    // `u8` and `char`.
    "is_ascii",
    "is_ascii_digit",
    "is_ascii_hexdigit",
    "is_ascii_alphabetic",
    "is_ascii_alphanumeric",
    "is_ascii_uppercase",
    "is_ascii_lowercase",
    "is_ascii_punctuation",
    "is_ascii_graphic",
    "is_ascii_whitespace",
    "is_ascii_control",
    "to_ascii_uppercase",
    "to_ascii_lowercase",
    "eq_ignore_ascii_case",
    "escape_ascii",
    "is_digit",
    "to_digit",
    "is_alphabetic",
    "is_numeric",
    "is_alphanumeric",
    "is_uppercase",
    "is_lowercase",
    "is_whitespace",
    "is_control",
    "len_utf8",
    "len_utf16",
    "to_uppercase",
    "to_lowercase",
];

/// By `self` (a copy) or `&self` on arrays, slices and texts.
const OF_LISTS: &[&str] = &[
    "len",
    "is_empty",
    "iter",
    "into_iter",
    "get",
    "first",
    "last",
    "split_first",
    "split_last",
    "split_at",
    "contains",
    "starts_with",
    "ends_with",
    "strip_prefix",
    "strip_suffix",
    "windows",
    "chunks",
    "chunks_exact",
    "rchunks",
    "rchunks_exact",
    "binary_search",
    "binary_search_by",
    "binary_search_by_key",
    "partition_point",
    "is_sorted",
    "is_sorted_by",
    "is_sorted_by_key",
    "map",
    "each_ref",
    "as_slice",
    "as_ref",
    "to_vec",
    "concat",
    "join",
    "repeat",
    "split",
    "splitn",
    "rsplit",
    "rsplitn",
    "is_ascii",
    "eq_ignore_ascii_case",
    "as_ptr",
    "first_chunk",
    "last_chunk",
    "as_str",
    "as_bytes",
    "chars",
    "char_indices",
    "bytes",
    "lines",
    "trim",
    "trim_start",
    "trim_end",
    "find",
    "rfind",
    "parse",
    "split_whitespace",
    "split_once",
    "rsplit_once",
    "is_char_boundary",
];

/// By `self` (a copy) or `&self` on an option.
const OF_OPTIONS: &[&str] = &[
    "is_some",
    "is_some_and",
    "is_none",
    "is_none_or",
    "as_ref",
    "as_deref",
    "as_slice",
    "expect",
    "unwrap",
    "unwrap_or",
    "unwrap_or_default",
    "unwrap_or_else",
    "map",
    "map_or",
    "map_or_else",
    "map_or_default",
    "inspect",
    "ok_or",
    "ok_or_else",
    "iter",
    "into_iter",
    "and",
    "and_then",
    "filter",
    "or",
    "or_else",
    "xor",
    "zip",
    "unzip",
    "copied",
    "cloned",
    "flatten",
    "transpose",
    "min",
    "max",
    "clamp",
];

const OF_DURATIONS: &[&str] = &[
    "is_zero",
    "as_secs",
    "as_millis",
    "as_micros",
    "as_nanos",
    "subsec_millis",
    "subsec_micros",
    "subsec_nanos",
    "as_secs_f32",
    "as_secs_f64",
    "as_millis_f32",
    "as_millis_f64",
    "mul_f32",
    "mul_f64",
    "div_f32",
    "div_f64",
    "div_duration_f32",
    "div_duration_f64",
    "abs_diff",
    "min",
    "max",
    "clamp",
    "add",
    "sub",
    "mul",
    "div",
];
