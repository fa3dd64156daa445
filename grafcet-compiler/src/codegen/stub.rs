//! What a chart with mistakes expands to: its types, so that the rest of the program gets no follow-up errors.

use proc_macro2::TokenStream;
use quote::quote;

use super::names::Names;
use super::types;
use crate::model::{Arena, Id, Model};
use syn::Ident;

/// The public items of a chart, with empty bodies.
pub(crate) fn stub(model: &Model, root: &TokenStream) -> TokenStream {
    let p = quote!(#root::__private);
    let names = Names::of(model);
    let Names { chart, inputs, outputs, step, transition, .. } = &names;
    let vis = &model.vis;
    let input_fields = fields(model.inputs.values().map(|input| (&input.name, &input.ty)), &p);
    let output_fields = fields(model.outputs.values().map(|output| (&output.name, &output.ty)), &p);
    let steps = first_of_each(model.steps.values().map(|step| &step.name));
    let transitions = variants(&model.transitions, |id| names.transition_variant(id));
    quote! {
        #[derive(Clone, Copy)]
        #[allow(missing_docs, dead_code)]
        #vis struct #chart;
        #[derive(Clone, Copy)]
        #[allow(missing_docs, dead_code)]
        #vis struct #inputs { #input_fields }
        #[derive(Clone, Copy)]
        #[allow(missing_docs, dead_code)]
        #vis struct #outputs { #output_fields }
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        #[allow(missing_docs, dead_code, non_camel_case_types)]
        #vis enum #step { #(#steps,)* }
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        #[allow(missing_docs, dead_code, non_camel_case_types)]
        #vis enum #transition { #transitions }

        impl #p::core::default::Default for #inputs { fn default() -> Self { loop {} } }
        impl #p::core::default::Default for #outputs { fn default() -> Self { loop {} } }
        impl #p::core::default::Default for #chart { fn default() -> Self { Self } }

        #[allow(missing_docs, dead_code, unused_variables, clippy::all)]
        impl #chart {
            #vis const fn new() -> Self { Self }
            #vis fn cycle(&mut self, inputs: &#inputs) -> #outputs { loop {} }
            #vis fn init(&mut self) {}
            #vis fn is_active(&self, step: #step) -> #p::bool { loop {} }
            #vis fn active_steps(&self) -> #p::heapless::Vec<#step, 1> { loop {} }
            #vis fn situation(&self) -> #step { loop {} }
            #vis fn is_stable(&self) -> #p::bool { loop {} }
        }
    }
}

fn fields<'m>(declared: impl Iterator<Item = (&'m Ident, &'m crate::model::Ty)>, p: &TokenStream) -> TokenStream {
    let mut seen = std::collections::BTreeSet::new();
    declared
        .filter(|(name, _)| seen.insert(name.to_string()))
        .map(|(name, ty)| {
            let ty = types::rust_type(ty, p);
            quote!(pub #name: #ty,)
        })
        .collect()
}

fn first_of_each<'m>(names: impl Iterator<Item = &'m Ident>) -> Vec<&'m Ident> {
    let mut seen = std::collections::BTreeSet::new();
    names.filter(|name| seen.insert(name.to_string())).collect()
}

fn variants<'m, I: Id, T>(arena: &Arena<I, T>, name: impl Fn(I) -> &'m Ident) -> TokenStream {
    let names = arena.ids().map(name);
    quote!(#(#names,)*)
}
