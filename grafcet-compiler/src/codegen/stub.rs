//! What a chart with mistakes expands to: its types, so that the rest of the program gets no follow-up errors.

use proc_macro2::TokenStream;
use quote::ToTokens;

use super::names::Names;
use super::{derives, editor, outside, recipe, requirements, types};
use crate::list::List;
use crate::model::{Assumption, Model, Name, Read, Ty};
use crate::place::{self, quote};
use crate::sorted::Set;
use syn::{Attribute, Ident};

/// The public items of a chart, with empty bodies. `timed` where `cycle` takes the time, `recorded` where a program may record the chart.
pub(crate) fn stub(model: &Model, timed: bool, recorded: bool, root: &TokenStream) -> TokenStream {
    let root = place::moved(root);
    let p = quote!(#root::__private);
    let names = Names::of(model);
    let records = records(model, &names, &p);
    let enums = enums(model, &names, &p);
    let methods = methods(model, timed, &names, &p);
    let uniform = uniform(model, &names, &p);
    let mentions = editor::mentions(model, &names, &p);
    let copied = requirements::copied(model, &p);
    let copied = (!copied.is_empty()).then(|| quote!(const _: () = { #copied };));
    let recorded = recorded.then(|| {
        let Names { chart, inputs, .. } = &names;
        quote! {
            #p::recorded_stub! { #chart #inputs }
            impl #p::Blocked for #chart {
                fn blocked(&self) -> impl #p::core::iter::Iterator<Item = #p::usize> { #p::core::iter::empty() }
            }
        }
    });
    quote!(#records #enums #methods #uniform #recorded #mentions #copied)
}

/// The chart, its inputs, outputs and recipe.
fn records(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let Names { chart, inputs, outputs, params, .. } = names;
    let record = |name: &Ident, docs: TokenStream, declared: Vec<Declared<'_>>| {
        let vis = &model.vis;
        let derives = derives::of(declared.iter().map(|(_, _, ty)| *ty));
        let (written_out, derives) = (derives.written_out(name, p), derives.attributes(model, p));
        let fields = fields(declared.into_iter(), p);
        let item = place::item("struct", name, &model.name, &quote!(#fields));
        quote! {
            #docs
            #derives
            #[allow(missing_docs, dead_code, clippy::all, clippy::pedantic)]
            #vis #item
            #written_out
            impl #p::core::default::Default for #name { fn default() -> Self { loop {} } }
        }
    };
    let none = TokenStream::new;
    let chart = record(chart, docs(&model.attrs), Vec::new());
    let declared = model.inputs.values().map(|input| (&input.attrs[..], &input.name, &input.ty));
    let default = outside::default_inputs(model, inputs, p);
    let inputs = record(inputs, none(), declared.list());
    let declared = model.outputs.values().map(|output| (&output.attrs[..], &output.name, &output.ty));
    let outputs = record(outputs, none(), declared.list());
    let params = (!model.params.is_empty()).then(|| {
        let vis = &model.vis;
        let declared = model.params.values().map(|param| (&param.attrs[..], &param.name, &param.ty));
        let record = record(params, none(), declared.list());
        // A recipe may be a constant, which rustc evaluates beside these errors: a value, and no `loop {}`.
        let mut seen = Set::new();
        let declared = model.params.values().filter(|param| seen.insert(param.name.to_string()));
        let values = declared.map(|param| {
            let own = matches!(param.ty, Ty::Other(_)) && !param.ty.is_float();
            let value = match &param.init {
                // What is missing is reported.
                None if own => quote!(#p::core::panic!()),
                init => types::initial_value(init.as_ref().filter(|_| own), &param.ty, p),
            };
            let name = &param.name;
            quote!(#name: #value,)
        });
        let new = quote!(#vis const fn new() -> Self { Self { #(#values)* } });
        quote!(#record #[allow(missing_docs, dead_code, unreachable_code)] impl #params { #new })
    });
    let vars = (!model.vars.is_empty()).then(|| {
        let declared = model.vars.values().map(|var| (&var.attrs[..], &var.name, &var.ty));
        record(&outside::vars_name(model), none(), declared.list())
    });
    quote!(#chart #inputs #default #outputs #params #vars)
}

/// The names of steps and transitions.
fn enums(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let list = |name: &Ident, variants: Vec<TokenStream>| {
        let vis = &model.vis;
        let derives = derives::of_names().and("Debug");
        let (written_out, derives) = (derives.written_out(name, p), derives.attributes(model, p));
        let item = place::item("enum", name, &model.name, &quote!(#(#variants,)*));
        quote! {
            #derives
            #[allow(missing_docs, dead_code, non_camel_case_types, clippy::all, clippy::pedantic)]
            #vis #item

            #written_out

            #[allow(missing_docs, dead_code)]
            impl #name { #vis const fn name(self) -> &'static #p::str { "" } }
            impl #p::core::fmt::Display for #name {
                fn fmt(&self, _: &mut #p::core::fmt::Formatter<'_>) -> #p::core::fmt::Result { #p::core::result::Result::Ok(()) }
            }
        }
    };
    let mut seen = Set::new();
    let steps = model.steps.values().filter(|step| seen.insert(step.name.to_string())).map(|step| {
        let (docs, name) = (docs(&step.attrs), &step.name);
        quote!(#docs #name)
    });
    let steps = list(&names.step, steps.list());
    let transitions = model.drawn_transitions().map(|(id, _)| names.transition_variant(id).to_token_stream()).list();
    let transitions = list(&names.transition, transitions);
    quote!(#steps #transitions)
}

/// The methods, with the arguments they would have; and the trait of the code actions, whose methods need not be there.
fn methods(model: &Model, timed: bool, names: &Names, p: &TokenStream) -> TokenStream {
    let Names { chart, inputs, outputs, step, params, actions, .. } = names;
    let vis = &model.vis;
    let now = timed.then(|| quote!(, now_: impl #p::core::convert::Into<#p::Ticks>));
    let reads_params = |assumption: &Assumption| {
        let is_param = |read: &Read| matches!(read, Read::Name(Name::Param(_)));
        assumption.of_range.is_none() && assumption.never.reads.iter().any(is_param)
    };
    let of_recipe = model.assumptions.iter().any(reads_params).then(|| quote!(&self,));
    let recipe = (!model.params.is_empty()).then(|| recipe_methods(model, params, p));
    let vars = (!model.vars.is_empty()).then(|| {
        let name = outside::vars_name(model);
        quote!(#vis fn vars(&self) -> #name { loop {} })
    });
    let has_time = model.steps.values().any(|step| step.late.is_some());
    let late = has_time.then(|| {
        quote! {
            #vis fn late_steps(&self) -> impl #p::core::iter::Iterator<Item = #step> + '_ {
                #p::core::iter::empty()
            }
        }
    });
    let force = model.forceable.then(|| {
        let calls = (!model.actions.is_empty()).then(|| quote!(, actions_: &mut (impl #actions + ?#p::core::marker::Sized)));
        quote! {
            #vis fn force(&mut self, steps_: &[#step], inputs_: &#inputs #now #calls) -> #p::Result<#outputs, #p::ForceError<#step>> { loop {} }
        }
    });
    let calls =
        (!model.actions.is_empty()).then(|| quote!(, actions_: &mut (impl #actions + ?#p::core::marker::Sized)));
    let trait_item = (!model.actions.is_empty()).then(|| actions_trait(model, actions, p));
    quote! {
        #trait_item

        #[allow(missing_docs, dead_code, unused_variables, clippy::all)]
        impl #chart {
            #vis const CHART: #p::description::Description<'static> = #p::description::Description {
                name: "", dialect: #p::description::Dialect::Sfc, partials: &[], macros: &[], steps: &[], transitions: &[], lets: &[],
            };
            #vis const fn new() -> Self { Self {} }
            #recipe
            #vis fn cycle(&mut self, inputs_: &#inputs #now #calls) -> #outputs { loop {} }
            #force
            #vis fn init(&mut self) {}
            #vis fn is_active(&self, step_: #step) -> #p::bool { loop {} }
            #vis fn active_steps(&self) -> #p::heapless::Vec<#step, 1> { loop {} }
            #vis fn situation(&self) -> #step { loop {} }
            #vis fn is_exactly(&self, steps_: &[#step]) -> #p::bool { loop {} }
            #vars
            #late
            #vis fn is_stable(&self) -> #p::bool { loop {} }
            #vis fn next_deadline(&self) -> #p::Option<#p::Ticks> { loop {} }
            #vis fn assumptions_hold(#of_recipe inputs_: &#inputs) -> #p::bool { loop {} }
            #vis const fn ticks(duration_: #p::core::time::Duration) -> #p::Ticks { #p::Ticks::ZERO }
        }
    }
}

fn recipe_methods(model: &Model, params: &Ident, p: &TokenStream) -> TokenStream {
    let vis = &model.vis;
    let (with_params, set_params) = if recipe::has_ranges(model) {
        let refused = quote!(#p::OutOfRange);
        (
            quote!(#vis const fn with_params(params_: #params) -> #p::Result<Self, #refused> { #p::Result::Ok(Self {}) }),
            quote!(#vis fn set_params(&mut self, params_: #params) -> #p::Result<(), #refused> { loop {} }),
        )
    } else {
        (
            quote!(#vis const fn with_params(params_: #params) -> Self { Self {} }),
            quote!(#vis fn set_params(&mut self, params_: #params) {}),
        )
    };
    quote! {
        #with_params
        #vis fn params(&self) -> &#params { loop {} }
        #set_params
    }
}

/// The trait of the code actions, whose methods do nothing.
fn actions_trait(model: &Model, actions: &Ident, p: &TokenStream) -> TokenStream {
    let vis = &model.vis;
    // A name that is declared twice has been reported.
    let mut seen = Set::new();
    let declared = model.actions.values().filter(|action| seen.insert(action.name.to_string()));
    let methods = declared.map(|action| {
        let (docs, name) = (docs(&action.attrs), &action.name);
        let params = action.params.iter().map(|(name, ty)| {
            let ty = types::rust_type(ty, p);
            quote!(#name: #ty)
        });
        quote!(#docs fn #name(&mut self, phase: #p::Phase, #(#params),*) {})
    });
    let item = place::item("trait", actions, &model.name, &quote!(#(#methods)*));
    quote!(#[allow(missing_docs, dead_code, unused_variables)] #vis #item)
}

/// The trait `Chart`.
fn uniform(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let Names { chart, inputs, outputs, step, transition, actions, .. } = names;
    let name = model.name.to_string();
    // Who asks for the first one gets it.
    let mut seen = Set::new();
    let all = model.steps.values().map(|step| &step.name).filter(|step| seen.insert(step.to_string())).list();
    let actions = if model.actions.is_empty() { quote!(()) } else { quote!(dyn #actions + 'a) };
    let forceable = model.forceable.then(|| {
        quote! {
            #[allow(unused_variables)]
            impl #p::Forceable for #chart {
                fn force(
                    &mut self,
                    steps_: &[#step],
                    inputs_: &#inputs,
                    now_: #p::Ticks,
                    actions_: &mut Self::Actions<'_>,
                ) -> #p::Result<#outputs, #p::ForceError<#step>> {
                    loop {}
                }
            }
        }
    });
    quote! {
        #forceable

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
            const STEPS: &'static [#step] = &[#(#step::#all),*];
            const TRANSITIONS: &'static [#transition] = &[];
            fn scan(&mut self, inputs_: &#inputs, now_: #p::Ticks, actions_: &mut Self::Actions<'_>) -> #outputs { loop {} }
            fn init(&mut self) {}
            fn is_active(&self, step_: #step) -> #p::bool { loop {} }
            fn situation(&self) -> #step { loop {} }
        }
    }
}

/// A declaration's attributes, its name and type.
type Declared<'m> = (&'m [Attribute], &'m Ident, &'m Ty);

fn fields<'m>(declared: impl Iterator<Item = Declared<'m>>, p: &TokenStream) -> TokenStream {
    let mut seen = Set::new();
    declared
        .filter(|(_, name, _)| seen.insert(name.to_string()))
        .map(|(attrs, name, ty)| {
            let (docs, ty) = (docs(attrs), types::rust_type(ty, p));
            types::field(&docs, name, &ty)
        })
        .tokens()
}

/// The user's doc comments, which an editor shows while the chart is half written.
fn docs(attrs: &[Attribute]) -> TokenStream {
    attrs.iter().filter(|attr| attr.path().is_ident("doc")).map(ToTokens::to_token_stream).tokens()
}
