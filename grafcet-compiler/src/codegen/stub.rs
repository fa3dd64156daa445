//! What a chart with mistakes expands to: its types, so that the rest of the program gets no follow-up errors.

use proc_macro2::TokenStream;
use quote::quote;

use super::names::Names;
use super::{derives, types};
use crate::model::{Model, Ty};
use syn::Ident;

/// The public items of a chart, with empty bodies.
pub(crate) fn stub(model: &Model, root: &TokenStream) -> TokenStream {
    let p = quote!(#root::__private);
    let names = Names::of(model);
    let records = records(model, &names, &p);
    let enums = enums(model, &names, &p);
    let methods = methods(model, &names, &p);
    let uniform = uniform(model, &names, &p);
    quote!(#records #enums #methods #uniform)
}

/// The chart, its inputs, outputs and recipe.
fn records(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let Names { chart, inputs, outputs, params, .. } = names;
    let record = |name: &Ident, declared: Vec<(&Ident, &Ty)>| {
        let vis = &model.vis;
        let derives = derives::of(declared.iter().map(|(_, ty)| *ty)).attributes(model, p);
        let fields = fields(declared.into_iter(), p);
        quote! {
            #derives
            #[allow(missing_docs, dead_code, clippy::all, clippy::pedantic)]
            #vis struct #name { #fields }
            impl #p::core::default::Default for #name { fn default() -> Self { loop {} } }
        }
    };
    let chart = record(chart, Vec::new());
    let inputs = record(inputs, model.inputs.values().map(|input| (&input.name, &input.ty)).collect());
    let outputs = record(outputs, model.outputs.values().map(|output| (&output.name, &output.ty)).collect());
    let params = (!model.params.is_empty()).then(|| {
        let vis = &model.vis;
        let record = record(params, model.params.values().map(|param| (&param.name, &param.ty)).collect());
        quote!(#record #[allow(missing_docs, dead_code)] impl #params { #vis const fn new() -> Self { loop {} } })
    });
    quote!(#chart #inputs #outputs #params)
}

/// The names of steps and transitions.
fn enums(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let list = |name: &Ident, variants: Vec<&Ident>| {
        let vis = &model.vis;
        let derives = derives::of_names().attributes(model, p);
        quote! {
            #derives
            #[allow(missing_docs, dead_code, non_camel_case_types, clippy::all, clippy::pedantic)]
            #vis enum #name { #(#variants,)* }
        }
    };
    let steps = list(&names.step, first_of_each(model.steps.values().map(|step| &step.name)));
    let transitions = model.transitions.ids().map(|id| names.transition_variant(id)).collect();
    let transitions = list(&names.transition, transitions);
    quote!(#steps #transitions)
}

/// The methods, with the arguments they would have; and the trait of the code actions, whose methods need not be there.
fn methods(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let Names { chart, inputs, outputs, step, params, actions, .. } = names;
    let vis = &model.vis;
    let now = model.uses_time().then(|| quote!(, now: impl #p::core::convert::Into<#p::Ticks>));
    let recipe = (!model.params.is_empty()).then(|| {
        quote! {
            #vis const fn with_params(params: #params) -> Self { Self {} }
            #vis fn params(&self) -> &#params { loop {} }
            #vis fn set_params(&mut self, params: #params) {}
        }
    });
    let calls = (!model.actions.is_empty()).then(|| quote!(, actions: &mut (impl #actions + ?#p::core::marker::Sized)));
    let methods = model.actions.values().map(|action| {
        let name = &action.name;
        let params = action.params.iter().map(|(name, ty)| {
            let ty = types::rust_type(ty, p);
            quote!(#name: #ty)
        });
        quote!(fn #name(&mut self, phase: #p::Phase, #(#params),*) {})
    });
    let trait_item = (!model.actions.is_empty())
        .then(|| quote!(#[allow(missing_docs, dead_code, unused_variables)] #vis trait #actions { #(#methods)* }));
    quote! {
        #trait_item

        #[allow(missing_docs, dead_code, unused_variables, clippy::all)]
        impl #chart {
            #vis const CHART: #p::description::Description<'static> = #p::description::Description {
                name: "", dialect: #p::description::Dialect::Sfc, partials: &[], macros: &[], steps: &[], transitions: &[],
            };
            #vis const fn new() -> Self { Self {} }
            #recipe
            #vis fn cycle(&mut self, inputs: &#inputs #now #calls) -> #outputs { loop {} }
            #vis fn init(&mut self) {}
            #vis fn is_active(&self, step: #step) -> #p::bool { loop {} }
            #vis fn active_steps(&self) -> #p::heapless::Vec<#step, 1> { loop {} }
            #vis fn situation(&self) -> #step { loop {} }
            #vis fn is_stable(&self) -> #p::bool { loop {} }
            #vis fn next_deadline(&self) -> #p::Option<#p::Ticks> { loop {} }
            #vis fn assumptions_hold(inputs: &#inputs) -> #p::bool { loop {} }
            #vis fn ticks(duration: #p::core::time::Duration) -> #p::Ticks { loop {} }
        }
    }
}

/// The trait `Chart`.
fn uniform(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let Names { chart, inputs, outputs, step, transition, actions, .. } = names;
    let name = model.name.to_string();
    let actions = if model.actions.is_empty() { quote!(()) } else { quote!(dyn #actions + 'a) };
    quote! {
        impl #p::ActiveSteps for #step { fn is_active_at(&self, _: #p::usize) -> #p::bool { loop {} } }

        #[allow(unused_variables)]
        impl #p::Chart for #chart {
            type Inputs = #inputs;
            type Outputs = #outputs;
            type Step = #step;
            type Transition = #transition;
            type Situation = #step;
            type Actions<'a> = #actions;
            const NAME: &'static #p::str = #name;
            const STEPS: &'static [#step] = &[];
            const TRANSITIONS: &'static [#transition] = &[];
            fn scan(&mut self, inputs: &#inputs, now: #p::Ticks, actions: &mut Self::Actions<'_>) -> #outputs { loop {} }
            fn init(&mut self) {}
            fn is_active(&self, step: #step) -> #p::bool { loop {} }
            fn situation(&self) -> #step { loop {} }
        }
    }
}

fn fields<'m>(declared: impl Iterator<Item = (&'m Ident, &'m Ty)>, p: &TokenStream) -> TokenStream {
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
