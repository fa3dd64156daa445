//! What the generated types derive: on their own, and because the chart asks for it.

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};
use syn::Path;

use crate::model::{Model, Ty};

/// The traits that a type derives on its own.
pub(super) struct Derives(Vec<&'static str>);

/// Of a struct with fields of these types. Of a user's own type only what a chart needs is asked for.
pub(super) fn of<'t>(types: impl Iterator<Item = &'t Ty>) -> Derives {
    let types: Vec<_> = types.collect();
    let mut derives = vec!["Clone", "Copy"];
    if types.iter().all(|ty| !matches!(ty, Ty::Other(_)) || ty.is_float()) {
        derives.extend(["Debug", "PartialEq"]);
        if !types.iter().any(|ty| ty.is_float()) {
            derives.push("Eq");
        }
    }
    Derives(derives)
}

/// Of an enum of names.
pub(super) fn of_names() -> Derives {
    Derives(vec!["Clone", "Copy", "PartialEq", "Eq", "PartialOrd", "Ord", "Hash", "Debug"])
}

/// Of a private enum of states.
pub(super) fn of_states() -> Derives {
    Derives(vec!["Clone", "Copy", "PartialEq", "Eq", "Debug"])
}

impl Derives {
    /// With another one.
    pub(super) fn and(mut self, name: &'static str) -> Self {
        self.0.push(name);
        self
    }

    /// The attributes, with what the chart derives beside. A type has its `Default` by itself, or none.
    pub(super) fn attributes(&self, model: &Model, p: &TokenStream) -> TokenStream {
        let own = self.0.iter().map(|name| {
            let (module, name) = (format_ident!("{}", module(name)), format_ident!("{name}"));
            quote!(#p::core::#module::#name)
        });
        let users = self.users(model, &["Default"]);
        quote!(#[derive(#(#own),*)] #users)
    }

    /// What the chart derives beside these and others that the type has already.
    pub(super) fn users(&self, model: &Model, others: &[&str]) -> TokenStream {
        let has =
            |path: &&Path| !standard(path).is_some_and(|name| self.0.iter().chain(others).any(|own| name == *own));
        let attributes = model.derives.iter().map(|derive| {
            let traits: Vec<&Path> = derive.traits.iter().filter(has).collect();
            match &derive.when {
                _ if traits.is_empty() => TokenStream::new(),
                None => quote!(#[derive(#(#traits),*)]),
                Some(when) => quote!(#[cfg_attr(#when, derive(#(#traits),*))]),
            }
        });
        attributes.collect()
    }
}

/// The name of a trait of the standard library: `Debug` for `Debug`, `core::fmt::Debug`, `std::fmt::Debug`.
fn standard(path: &Path) -> Option<String> {
    let first = path.segments.first()?.ident.to_string();
    let is_standard = path.segments.len() == 1 || ["core", "std"].contains(&first.as_str());
    is_standard.then(|| path.segments.last().to_token_stream().to_string())
}

/// Where the standard library has the trait.
fn module(name: &str) -> &'static str {
    match name {
        "Clone" => "clone",
        "Copy" => "marker",
        "Debug" => "fmt",
        "Default" => "default",
        "Hash" => "hash",
        _ => "cmp",
    }
}
