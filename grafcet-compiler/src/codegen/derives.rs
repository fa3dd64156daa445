//! What the generated types derive: on their own, and because the chart asks for it.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident};
use syn::{Path, Type};

use super::requirements;
use crate::ast::is_of;
use crate::list::{List, PushAll};
use crate::model::{Model, Ty};
use crate::place::quote;

/// The traits that a type derives on its own.
pub(super) struct Derives {
    names: Vec<&'static str>,
    /// Written by hand beside the type: rustc takes long, and much memory, for a derived `Debug` of thousands of names.
    by_hand: Option<&'static str>,
    /// Types of fields of which nobody knows whether they are `Copy`. A derive would report that at the whole chart, so `Clone`
    /// and `Copy` are written out under the condition that they are; [`requirements`](super::requirements) asks for it.
    foreign: Vec<Type>,
    /// Whether it is the chart itself.
    is_chart: bool,
}

/// Of a struct with fields of these types. Of a user's own type only what a chart needs is asked for.
pub(super) fn of<'t>(types: impl Iterator<Item = &'t Ty>) -> Derives {
    let types: Vec<_> = types.list();
    let foreign = requirements::distinct(types.iter().copied(), requirements::is_copy);
    let mut derives = vec!["Clone", "Copy"];
    if types.iter().all(|ty| !matches!(ty, Ty::Other(_)) || ty.is_float()) {
        derives.push_all(["Debug", "PartialEq"]);
        if !types.iter().any(|ty| ty.is_float()) {
            derives.push("Eq");
        }
    }
    Derives { names: derives, by_hand: None, foreign, is_chart: false }
}

/// Of an enum of names, which writes its `Debug`.
pub(super) fn of_names() -> Derives {
    plain(vec!["Clone", "Copy", "PartialEq", "Eq", "PartialOrd", "Ord", "Hash"])
}

/// Of a private enum of states, which writes its `Debug`.
pub(super) fn of_states() -> Derives {
    plain(vec!["Clone", "Copy", "PartialEq", "Eq"])
}

fn plain(names: Vec<&'static str>) -> Derives {
    Derives { names, by_hand: Some("Debug"), foreign: Vec::new(), is_chart: false }
}

impl Derives {
    /// The chart itself and what it is made of, which nobody makes of anything but `new` and a checked snapshot: only what [`observes`] reaches it.
    pub(super) fn of_chart(mut self) -> Self {
        self.is_chart = true;
        self
    }

    /// With another one.
    pub(super) fn and(mut self, name: &'static str) -> Self {
        self.by_hand = self.by_hand.filter(|written| *written != name);
        self.names.push(name);
        self
    }

    /// The attributes, with what the chart derives beside. A type has its `Default` by itself, or none.
    pub(super) fn attributes(&self, model: &Model, p: &TokenStream) -> TokenStream {
        let written: &[&str] = if self.foreign.is_empty() { &["Eq"] } else { &["Clone", "Copy", "Eq"] };
        let derived = self.names.iter().filter(|name| !written.contains(name));
        let own = derived.map(|name| {
            let (module, name) = (format_ident!("{}", module(name)), format_ident!("{name}"));
            quote!(#p::core::#module::#name)
        });
        let own: Vec<_> = own.list();
        let own = (!own.is_empty()).then(|| quote!(#[derive(#(#own),*)]));
        let users = self.users(model, &["Default"]);
        quote!(#own #users)
    }

    /// What is not derived, for the type `name`.
    pub(super) fn written_out(&self, name: &Ident, p: &TokenStream) -> TokenStream {
        let foreign = &self.foreign;
        // A condition without anything that can vary is checked on the spot, one over a lifetime is not.
        let copy = quote!(where #(for<'chart> #foreign: #p::core::marker::Copy),*);
        let copied = (!foreign.is_empty()).then(|| {
            quote! {
                impl #p::core::marker::Copy for #name #copy {}
                // As the derived one, which lints leave alone.
                #[automatically_derived]
                impl #p::core::clone::Clone for #name #copy {
                    fn clone(&self) -> Self {
                        *self
                    }
                }
            }
        });
        // A derived one has a function that asks of each field once more what `of` knows of all.
        let equal = self.names.contains(&"Eq").then(|| {
            quote! {
                #[automatically_derived]
                impl #p::core::cmp::Eq for #name {}
            }
        });
        quote!(#copied #equal)
    }

    /// What the chart derives beside these and others that the type has already.
    pub(super) fn users(&self, model: &Model, others: &[&str]) -> TokenStream {
        let has = |path: &&Path| {
            !standard(path).is_some_and(|name| self.names.iter().and(&self.by_hand).and(others).any(|own| name == *own))
        };
        let reaches = |path: &&Path| has(path) && (!self.is_chart || observes(path));
        let attributes = model.derives.iter().map(|derive| {
            let traits: Vec<&Path> = derive.traits.iter().filter(reaches).list();
            match &derive.when {
                _ if traits.is_empty() => TokenStream::new(),
                None => quote!(#[derive(#(#traits),*)]),
                Some(when) => quote!(#[cfg_attr(#when, derive(#(#traits),*))]),
            }
        });
        attributes.tokens()
    }
}

/// Whether a derive is known to look at a value and to make none. Of all others nobody can tell it, under whatever name they have been imported: `Deserialize`, `Decode`
/// and `Arbitrary` make charts that no cycle has led to.
fn observes(path: &Path) -> bool {
    const STANDARD: [&str; 9] = ["Clone", "Copy", "Debug", "Default", "Hash", "PartialEq", "Eq", "PartialOrd", "Ord"];
    standard(path).is_some_and(|name| STANDARD.contains(&name.as_str()))
        || [("serde", "Serialize"), ("defmt", "Format"), ("ufmt", "uDebug")]
            .into_iter()
            .any(|(module, name)| is_of(path, module, name))
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
