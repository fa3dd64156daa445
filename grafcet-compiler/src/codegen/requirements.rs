//! What a chart needs of types that the compiler does not know, asked where the chart names them.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote_spanned};
use syn::spanned::Spanned as _;
use syn::{Expr, Lit, Type};

use crate::list::List;
use crate::model::{Model, Ty};
use crate::place::quote;
use crate::sorted::Set;

/// The statements that ask for it. They stand in every function that copies values, so that rustc says once what is missing and
/// looks no further there.
pub(super) fn copied(model: &Model, p: &TokenStream) -> TokenStream {
    let inputs = model.inputs.values().map(|input| &input.ty);
    let outputs = model.outputs.values().map(|output| &output.ty);
    let vars = model.vars.values().map(|var| &var.ty);
    let params = model.params.values().map(|param| &param.ty);
    let foreign = distinct(inputs.and(outputs).and(vars).and(params), is_copy);
    foreign.iter().map(|ty| call(ty, &quote!(copied), &TokenStream::new(), p)).map(|call| quote!(#call;)).tokens()
}

/// The default of a type.
pub(super) fn default_value(ty: &Type, p: &TokenStream) -> TokenStream {
    if has_default(ty) {
        return quote!(#p::core::default::Default::default());
    }
    match ty {
        // The standard library has defaults of short arrays only.
        Type::Array(syn::TypeArray { elem, len, .. }) => {
            let one = default_value(elem, p);
            quote!([#one; #len])
        }
        _ => call(ty, &quote!(default_value), &TokenStream::new(), p),
    }
}

/// Whether two values of a type are the same.
pub(super) fn is_same(ty: &Type, one: &TokenStream, other: &TokenStream, p: &TokenStream) -> TokenStream {
    call(ty, &quote!(is_same), &quote!(&#one, &#other), p)
}

/// `p::function::<Type>(arguments)`, where the chart names the type.
fn call(ty: &Type, function: &TokenStream, arguments: &TokenStream, p: &TokenStream) -> TokenStream {
    quote_spanned!(Span::call_site().located_at(ty.span())=> #p::#function::<#ty>(#arguments))
}

/// The types that fail the test, each once: of an array that of its elements.
pub(super) fn distinct<'t>(types: impl Iterator<Item = &'t Ty>, test: fn(&Type) -> bool) -> Vec<Type> {
    let mut seen = Set::new();
    let mut found = Vec::new();
    for ty in types {
        if let Ty::Other(rust) = ty {
            failing(rust, test, &mut |part| {
                if seen.insert(part.to_token_stream().to_string()) {
                    found.push(part.clone());
                }
            });
        }
    }
    found
}

fn failing(ty: &Type, test: fn(&Type) -> bool, found: &mut dyn FnMut(&Type)) {
    match ty {
        _ if test(ty) => {}
        Type::Group(group) => failing(&group.elem, test, found),
        Type::Paren(paren) => failing(&paren.elem, test, found),
        Type::Array(array) if !test(&array.elem) => failing(&array.elem, test, found),
        Type::Tuple(tuple) if tuple.elems.len() <= 12 => tuple.elems.iter().for_each(|part| failing(part, test, found)),
        _ => found(ty),
    }
}

/// Whether a type is certainly `Copy`.
pub(super) fn is_copy(ty: &Type) -> bool {
    match ty {
        Type::Reference(reference) => reference.mutability.is_none(),
        _ => is_known(ty, is_copy),
    }
}

/// Whether a type certainly has a `Default`.
pub(super) fn has_default(ty: &Type) -> bool {
    match ty {
        Type::Array(array) => has_default(&array.elem) && is_short(&array.len),
        Type::Reference(reference) => matches!(&*reference.elem, Type::Path(path) if path.path.is_ident("str")),
        _ => is_known(ty, has_default),
    }
}

/// Types of the language, of what passes the test.
fn is_known(ty: &Type, test: fn(&Type) -> bool) -> bool {
    const PRIMITIVE: &[&str] = &[
        "bool", "char", "u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128", "isize", "f32",
        "f64",
    ];
    match ty {
        Type::Group(group) => test(&group.elem),
        Type::Paren(paren) => test(&paren.elem),
        Type::Array(array) => test(&array.elem),
        Type::Tuple(tuple) => tuple.elems.len() <= 12 && tuple.elems.iter().all(test),
        Type::Path(path) => PRIMITIVE.iter().any(|name| path.path.is_ident(name)),
        _ => false,
    }
}

/// Whether an array of this length has a default.
fn is_short(len: &Expr) -> bool {
    matches!(len, Expr::Lit(lit) if matches!(&lit.lit, Lit::Int(len) if len.base10_parse::<u8>().is_ok_and(|len| len <= 32)))
}
