//! Declared types, with an ear for those of IEC 61131-3.

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::Parse;
use syn::{Lifetime, Type};

use super::{Error, Input, Result};
use crate::ast::Ty;
use crate::diagnostic::{Mark, Sink};
use crate::methods;

/// What IEC 61131-3 and other languages call a type, and what it is here.
const ELSEWHERE: &[(&str, &str)] = &[
    ("BOOL", "bool"),
    ("SINT", "i8"),
    ("INT", "i16"),
    ("DINT", "i32"),
    ("LINT", "i64"),
    ("USINT", "u8"),
    ("UINT", "u16"),
    ("UDINT", "u32"),
    ("ULINT", "u64"),
    ("REAL", "f32"),
    ("LREAL", "f64"),
    ("TIME", "time"),
    ("LTIME", "time"),
    ("BYTE", "u8"),
    ("WORD", "u16"),
    ("DWORD", "u32"),
    ("LWORD", "u64"),
    ("CHAR", "char"),
    ("WCHAR", "char"),
    ("STRING", "&'static str"),
    ("WSTRING", "&'static str"),
    ("int", "i32"),
    ("uint", "u32"),
    ("float", "f32"),
    ("double", "f64"),
    ("boolean", "bool"),
];

/// The type that the word is wherever it stands; that of Rust, where another notation has it.
pub(super) fn known(word: &str) -> Option<&str> {
    let ours = ELSEWHERE.iter().find(|(name, _)| *name == word).map(|(_, ours)| *ours);
    ours.or_else(|| (word == "time" || methods::is_primitive(word)).then_some(word))
}

/// A type; the word `time` alone is ours.
pub(super) fn parse(input: &mut Input, sink: &mut Sink) -> Result<Ty> {
    let next = input.next();
    let alone = !next.at("::") && !next.at("<") && !next.at("!");
    if input.at_word("time") && alone {
        input.bump();
        return Ok(Ty::Time(input.last()));
    }
    if input.is_empty() || [";", "=", ",", ":"].iter().any(|sign| input.at(sign)) && !input.at("::") {
        return Err(input.error(format!("expected a type, such as `bool`, found {}", input.found())));
    }
    if input.at_word("ARRAY") && next.at_group(Delimiter::Bracket) {
        return Err(input.error("an array is written with its element and its length: `[i16; 4]`"));
    }
    let span = input.span();
    let word = input.word().filter(|_| alone);
    if let Some((theirs, ours)) = word.and_then(|word| ELSEWHERE.iter().find(|(name, _)| *name == word)) {
        sink.notation(
            span,
            format!(
                "`{theirs}` is no type of Rust: write `{ours}`; a type of your own of that name is `self::{theirs}`"
            ),
        );
        input.bump();
        // `STRING[80]`
        input.enter(Delimiter::Bracket);
        return Ok(meant(ours, span));
    }
    let ty = input.rust(Type::parse)?;
    match self_in(ty.to_token_stream()) {
        Some(word) => {
            Err(Error::new(word, "`Self` is no type here, as a chart stands in no `impl`; write the name of the type"))
        }
        None => Ok(Ty::Rust(ty)),
    }
}

/// Where a type says `Self`.
fn self_in(tokens: TokenStream) -> Option<Span> {
    tokens.into_iter().find_map(|token| match token {
        TokenTree::Ident(word) => (word == "Self").then(|| word.span()),
        TokenTree::Group(group) => self_in(group.stream()),
        _ => None,
    })
}

/// The type of a declaration: what a chart keeps has a size, and lives as long as it does.
pub(super) fn kept(mut ty: Ty, sink: &mut Sink) -> Result<Ty> {
    match &mut ty {
        Ty::Rust(Type::Reference(reference)) if reference.lifetime.is_none() => {
            let message = "a reference that a chart keeps says how long it is valid: write `&'static …`";
            sink.notation(reference.and_token.span, message);
            reference.lifetime = Some(Lifetime::new("'static", reference.and_token.span));
        }
        Ty::Rust(Type::Slice(slice)) => {
            return Err(Error::new(Mark::of(slice), "an array is written with its length: `[u8; 4]`"));
        }
        Ty::Rust(Type::Path(path)) if path.path.is_ident("str") => {
            return Err(Error::new(Mark::of(path), "a text has no size that is known; write `&'static str`"));
        }
        _ => {}
    }
    Ok(ty)
}

/// The type that was meant, so that nothing follows from the mistake.
fn meant(ours: &str, span: Span) -> Ty {
    match ours {
        "time" => Ty::Time(span),
        "&'static str" => Ty::Rust(syn::parse_quote_spanned!(span=> &'static str)),
        ours => {
            let name = Ident::new(ours, span);
            Ty::Rust(syn::parse_quote!(#name))
        }
    }
}
