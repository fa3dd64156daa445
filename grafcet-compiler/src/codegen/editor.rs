//! What editors find at names that the code does not repeat where they stand: steps in chains, outputs and code actions
//! behind qualifiers.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::names::Names;
use crate::model::{Mention, Model};

/// A function that mentions each of them at the user's tokens, for rust-analyzer alone, which sets this `cfg`.
pub(super) fn mentions(model: &Model, names: &Names, p: &TokenStream) -> TokenStream {
    let (mut steps, mut outputs, mut calls) = (Vec::new(), Vec::new(), Vec::new());
    for (mention, span) in &model.mentions {
        match mention {
            Mention::Step(id) => steps.push(at(&model.steps[*id].name, *span)),
            Mention::Output(id) => outputs.push(at(&model.outputs[*id].name, *span)),
            Mention::Action(id) => calls.push(at(&model.actions[*id].name, *span)),
        }
    }
    // The types are called by the chart's name, but not what is mentioned.
    let [step, record, actions] = [&names.step, &names.outputs, &names.actions].map(|name| at(name, Span::call_site()));
    let actions = (!calls.is_empty()).then(|| quote!(<A: #actions + ?#p::core::marker::Sized>));
    let steps = (!steps.is_empty()).then(|| quote!(let _ = [#(#step::#steps),*];));
    let outputs = (!outputs.is_empty()).then(|| quote!(let _ = (#(&outputs.#outputs,)*);));
    let calls = (!calls.is_empty()).then(|| quote!(let _ = (#(A::#calls,)*);));
    quote! {
        #[allow(unexpected_cfgs)]
        const _: () = {
            #[cfg(rust_analyzer)]
            fn mentions #actions (outputs: &#record) {
                #steps
                #outputs
                #calls
            }
        };
    }
}

fn at(name: &Ident, span: Span) -> Ident {
    let mut name = name.clone();
    name.set_span(span);
    name
}
