//! What editors find at names that the code does not repeat where they stand: steps in chains, outputs and code actions
//! after qualifiers, macro-steps, partial grafcets, variables that actions write, named conditions. What expressions read is mentioned, too:
//! a program takes conditions apart, and has one for all steps that wait for the same.

use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;

use super::names::Names;
use super::types::rust_type;
use crate::list::PushAll;
use crate::model::{Mention, Model};
use crate::place::{self, quote};

/// A function that mentions each of them at the user's tokens, for rust-analyzer alone, which sets this `cfg`.
pub(super) fn mentions(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let [mut steps, mut outputs, mut calls, mut vars, mut macros, mut partials, mut lets] = [const { Vec::new() }; 7];
    let [mut inputs, mut params] = [const { Vec::new() }; 2];
    for (mention, span) in &model.mentions {
        let (mentioned, name) = match mention {
            Mention::Step(id) => (&mut steps, Some(&model.steps[*id].name)),
            Mention::Input(id) => (&mut inputs, Some(&model.inputs[*id].name)),
            Mention::Param(id) => (&mut params, Some(&model.params[*id].name)),
            Mention::Output(id) => (&mut outputs, Some(&model.outputs[*id].name)),
            Mention::Action(id) => (&mut calls, Some(&model.actions[*id].name)),
            Mention::Var(id) => (&mut vars, Some(&model.vars[*id].name)),
            Mention::Macro(id) => (&mut macros, Some(&model.macros[*id].name)),
            Mention::Let(id) => (&mut lets, Some(&model.lets[*id].name)),
            Mention::Partial(id) => (&mut partials, model.partials[*id].name.as_ref()),
        };
        mentioned.push_all(name.map(|name| at(name, *span)));
    }
    // The types are called by the chart's name, but not what is mentioned.
    let [step, read, record, actions] =
        [&names.step, &names.inputs, &names.outputs, &names.actions].map(|name| at(name, place::here()));
    let recipe = at(&names.params, place::here());
    let actions = (!calls.is_empty()).then(|| quote!(<A: #actions + ?#p::core::marker::Sized>));
    let steps = (!steps.is_empty()).then(|| quote!(let _ = [#(#step::#steps),*];));
    let recipe = (!params.is_empty()).then(|| quote!(params_: &#recipe,));
    let inputs = (!inputs.is_empty()).then(|| quote!(let _ = (#(&inputs_.#inputs,)*);));
    let params = (!params.is_empty()).then(|| quote!(let _ = (#(&params_.#params,)*);));
    let outputs = (!outputs.is_empty()).then(|| quote!(let _ = (#(&outputs_.#outputs,)*);));
    let calls = (!calls.is_empty()).then(|| quote!(let _ = (#(A::#calls,)*);));
    let macros = named("MacroStep", model.macros.values().map(|macro_step| &macro_step.name), &macros);
    let partials = named("Partial", model.partials.values().filter_map(|partial| partial.name.as_ref()), &partials);
    let (vars, lets) = (variables(model, &vars, p), conditions(model, &lets));
    quote! {
        #[allow(unexpected_cfgs)]
        const _: () = {
            #[cfg(rust_analyzer)]
            fn mentions #actions (inputs_: &#read, #recipe outputs_: &#record) {
                #steps
                #inputs
                #params
                #outputs
                #calls
                #macros
                #partials
                #vars
                #lets
            }
        };
    }
}

/// What the rest of the code has no item for gets one, in a block of its own: its name means something else there.
fn named<'m>(kind: &str, declared: impl Iterator<Item = &'m Ident>, mentioned: &[Ident]) -> Option<TokenStream> {
    let kind = format_ident!("{kind}");
    (!mentioned.is_empty()).then(|| quote!({ enum #kind { #(#declared,)* } let _ = [#(#kind::#mentioned),*]; }))
}

/// The same of named conditions, with what they stand for.
fn conditions(model: &Model, mentioned: &[Ident]) -> Option<TokenStream> {
    let declared = model.lets.values().map(|named| {
        let (name, doc) = (&named.name, format!("`{}`\n\n{}", named.text, named.doc));
        quote!(#[doc = #doc] #name,)
    });
    (!model.lets.is_empty()).then(|| quote!({ enum Let { #(#declared)* } let _: &[Let] = &[#(Let::#mentioned),*]; }))
}

/// The same of variables, which have a type.
fn variables(model: &Model, mentioned: &[Ident], p: &TokenStream) -> Option<TokenStream> {
    let (names, types): (Vec<_>, Vec<_>) = model.vars.values().map(|var| (&var.name, rust_type(&var.ty, p))).unzip();
    (!mentioned.is_empty()).then(|| {
        quote!({
            struct Variables { #(#names: #types,)* }
            fn mentions(variables_: &Variables) { let _ = (#(&variables_.#mentioned,)*); }
        })
    })
}

fn at(name: &Ident, span: Span) -> Ident {
    let mut name = name.clone();
    name.set_span(span);
    name
}
