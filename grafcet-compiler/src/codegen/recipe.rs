//! The recipe (`param`) and the trait of the code actions (`action`).

use proc_macro2::TokenStream;

use super::{Cx, derives, types};
use crate::place::quote;

pub(super) fn all(cx: &Cx<'_>) -> TokenStream {
    let (params, actions) = (params(cx), actions(cx));
    quote!(#params #actions)
}

/// `MotorParams`: the values that may be exchanged while the program runs.
fn params(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, .. } = cx;
    if model.params.is_empty() {
        return TokenStream::new();
    }
    let fields = model.params.values().map(|param| {
        let (name, ty) = (&param.name, types::rust_type(&param.ty, p));
        let docs = types::docs(&param.attrs, &format!("Parameter `{name}`."));
        types::field(&docs, name, &ty)
    });
    let values = model.params.values().map(|param| {
        let (name, value) = (&param.name, types::initial_value(param.init.as_ref(), &param.ty, p));
        quote!(#name: #value,)
    });
    let derives = derives::of(model.params.values().map(|param| &param.ty));
    let (vis, name, chart) = (&model.vis, &cx.names.params, &model.name);
    let (written_out, derives) = (derives.written_out(name, p), derives.attributes(model, p));
    let levels = types::levels(model);
    let doc = format!("The recipe of [`{chart}`]; `default()` holds the values in the chart.");
    quote! {
        #[doc = #doc]
        #derives
        #levels
        #vis struct #name { #(#fields)* }

        #written_out

        #levels
        impl #name {
            /// The values in the chart.
            #[must_use]
            #vis const fn new() -> Self {
                Self { #(#values)* }
            }
        }

        impl #p::core::default::Default for #name {
            fn default() -> Self {
                Self::new()
            }
        }
    }
}

/// `MotorActions`: what carries out the code actions.
fn actions(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, .. } = cx;
    if model.actions.is_empty() {
        return TokenStream::new();
    }
    let methods = model.actions.values().map(|action| {
        let name = &action.name;
        let docs = types::docs(&action.attrs, &format!("Action `{name}`; `phase` tells which call this is."));
        let params = action.params.iter().map(|(name, ty)| {
            let ty = types::rust_type(ty, p);
            quote!(#name: #ty)
        });
        quote!(#docs fn #name(&mut self, phase: #p::Phase, #(#params),*);)
    });
    let (vis, name, levels) = (&model.vis, &cx.names.actions, types::levels(model));
    let doc = format!("The code actions of [`{}`], carried out by the program.", model.name);
    quote! {
        #[doc = #doc]
        #levels
        #vis trait #name { #(#methods)* }
    }
}
