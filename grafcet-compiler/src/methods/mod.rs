//! Which calls of methods leave the value as it is that they are called on.
//!
//! The compiler sees no types but the declared ones. Of those that it knows (numbers, times, arrays, texts, options) a method
//! of the standard library by `self` or `&self` is found before any other of its name; of a type that nobody can know only
//! what has one meaning all over Rust is taken for a read. Whatever else is called may write.

mod names;

use proc_macro2::Ident;
use syn::{Expr, ExprMethodCall, Member, Type};

use crate::list::List;
use crate::model::Ty;
use names::{OF_ALL, OF_DURATIONS, OF_LISTS, OF_NUMBERS, OF_OPTIONS, PRIMITIVE, is_checked};

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
        Expr::Tuple(tuple) => tuple.elems.iter().flat(targets).list(),
        Expr::Array(array) => array.elems.iter().flat(targets).list(),
        Expr::Call(call) => call.args.iter().flat(targets).list(),
        Expr::Struct(fields) => fields.fields.iter().flat(|field| targets(&field.expr)).list(),
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
