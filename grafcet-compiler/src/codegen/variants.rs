//! Listed variants are all variants of their enum: `input mode: Mode in {Off, Auto, Manual};`
//!
//! A `match` that nobody runs: rustc finds the variant that is missing, and the one that does not exist, at its name. The type of what a
//! path in a comparison names is the same. Where a value is compared with `==`, a constant in a pattern asks for a
//! derived `PartialEq`, which tells variants apart.

use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote_spanned};
use syn::Path;

use super::Cx;
use super::types::rust_type;
use crate::list::List;
use crate::model::{Variant, Variants};
use crate::place::{self, quote};

pub(super) fn all(cx: &Cx<'_>) -> TokenStream {
    cx.model.variants.iter().map(|variants| check(cx, variants)).tokens()
}

fn check(cx: &Cx<'_>, variants: &Variants) -> TokenStream {
    let Some(name) = variants.names.first() else { return TokenStream::new() };
    let ty = ours(rust_type(cx.model.ty(*name), &cx.p));
    let paths = std::iter::once(&variants.path).and(&variants.others);
    let last = variants.list.last().map_or_else(place::mixed, |variant| located(variant.name.span()));
    let matches = paths.map(|path| {
        let patterns = variants.list.iter().map(|variant| {
            let (path, name) = (at(path.to_token_stream(), variant.name.span()), ours(variant.name.to_token_stream()));
            // A constant of the type has no fields, so that this is a variant.
            let fields = quote_spanned!(located(variant.name.span())=> { .. });
            quote!(#path::#name #fields)
        });
        let value = Ident::new("value_", place(&variants.path));
        let nothing = quote_spanned!(last=> => {});
        quote!(const _: fn(#ty) = |#value| match #value { #(#patterns)|* #nothing };)
    });
    let equality = variants.compared.map(|index| equality(variants, &variants.path, index, &ty));
    let matches: TokenStream = matches.tokens();
    quote!(#matches #equality)
}

/// A variant as a value and as a pattern, at its name in the list.
pub(super) fn value(variants: &Variants, variant: &Variant) -> TokenStream {
    let (path, name) = (at(variants.path.to_token_stream(), variant.name.span()), ours(variant.name.to_token_stream()));
    quote!(#path::#name)
}

fn equality(variants: &Variants, path: &Path, index: usize, ty: &TokenStream) -> TokenStream {
    let name = ours(variants.list[index].name.to_token_stream());
    let path = ours(path.to_token_stream());
    let rest = (variants.list.len() > 1).then(|| quote!(_ => {}));
    let constant = Ident::new("VARIANT", place(&variants.path));
    let item = quote_spanned!(place(&variants.path)=> const #constant: #ty = #path::#name;);
    quote!(const _: fn(#ty) = |value_| { #item match value_ { #constant => {} #rest } };)
}

/// Where the type stands, with the resolution of generated code.
fn place(path: &Path) -> Span {
    path.segments.last().map_or_else(place::mixed, |last| located(last.ident.span()))
}

fn located(span: Span) -> Span {
    place::mixed().located_at(span)
}

/// Tokens of the user, as if they stood elsewhere.
fn at(tokens: TokenStream, place: Span) -> TokenStream {
    let moved = |mut tree: TokenTree| {
        if !matches!(&tree, TokenTree::Ident(name) if name == "$crate") {
            tree.set_span(located(place));
        }
        tree
    };
    tokens.into_iter().map(moved).collect()
}

/// The user's tokens where they are, but generated: no lint is about them.
fn ours(tokens: TokenStream) -> TokenStream {
    let ours = |tree| match tree {
        TokenTree::Group(group) => {
            let mut inner = Group::new(group.delimiter(), ours(group.stream()));
            inner.set_span(group.span());
            TokenTree::Group(inner)
        }
        // What a macro of the user puts in for its own crate means nothing elsewhere.
        TokenTree::Ident(name) if name == "$crate" => TokenTree::Ident(name),
        mut tree => {
            tree.set_span(tree.span().resolved_at(place::mixed()));
            tree
        }
    };
    tokens.into_iter().map(ours).collect()
}
