//! The recipe (`param`) and the trait of the code actions (`action`).

use proc_macro2::{Ident, Literal, Span, TokenStream, TokenTree};
use quote::quote_spanned;

use super::{Cx, derives, names, types};
use crate::analysis::integer_constant;
use crate::list::{List, PushAll};
use crate::model::{Model, Ty};
use crate::place::{self, quote};

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
        let range = param.range.as_ref().map_or_else(String::new, |range| format!(" It is in `{}`.", range.text));
        let docs = types::docs(&param.attrs, &format!("Parameter `{name}`.{range}"));
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
    let ranges = has_ranges(model).then(|| ranges(cx));
    let item = place::item("struct", name, &model.name, &quote!(#(#fields)*));
    quote! {
        #[doc = #doc]
        #derives
        #levels
        #vis #item

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

        #ranges
    }
}

/// Whether the chart says of a param what it may be.
pub(super) fn has_ranges(model: &Model) -> bool {
    model.params.values().any(|param| param.range.is_some())
}

/// What the generated code asks of a recipe before it takes it.
fn ranges(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (name, out_of_range) = (&names.params, out_of_range());
    let (mut asked, mut defaults) = (Vec::new(), Vec::new());
    for param in model.params.values() {
        let Some(range) = &param.range else { continue };
        let (field, text, is_time) = (&param.name, &range.text, matches!(param.ty, Ty::Time(_)));
        let (below, above) = param.beyond(range);
        let value = if is_time { quote!(self.#field.get()) } else { quote!(self.#field) };
        let shown = field.to_string();
        let shown = shown.trim_start_matches("r#");
        let refused = quote!(return #p::Option::Some(#p::OutOfRange { param: #shown, range: #text }));
        let (low, high) = (Literal::i128_unsuffixed(range.low), Literal::i128_unsuffixed(range.high));
        asked.push_all(below.then(|| quote!(if #value < #low { #refused; })));
        asked.push_all(above.then(|| quote!(if #value > #high { #refused; })));
        // The value of a constant of Rust is known to rustc alone.
        if let Some(init) = param.init.as_ref().filter(|init| integer_constant(&init.tree).is_none()) {
            let message = format!("`{shown}` is not in `{text}`");
            let at = init.mark.start;
            let p: TokenStream = p.clone().into_iter().map(|token| located(token, at)).tokens();
            let place = place::mixed().located_at(at);
            let in_range = quote_spanned!(place=> #name::new().#out_of_range().is_none());
            defaults.push(quote_spanned!(place=> const _: () = #p::core::assert!(#in_range, #message);));
        }
    }
    quote! {
        impl #name {
            /// The first param that is not what the chart says of it.
            #[allow(unused_comparisons, clippy::absurd_extreme_comparisons, clippy::manual_range_contains)]
            const fn #out_of_range(&self) -> #p::Option<#p::OutOfRange> {
                #(#asked)*
                #p::Option::None
            }
        }

        #(#defaults)*
    }
}

/// A token that means what it means and stands there.
fn located(mut token: TokenTree, at: Span) -> TokenStream {
    token.set_span(token.span().located_at(at));
    token.into()
}

/// The method that asks. Of ours, as the type is the user's.
pub(super) fn out_of_range() -> Ident {
    Ident::new("__out_of_range", place::here())
}

/// `with_params`, `params` and `set_params` of a chart with ranges.
pub(super) fn exchanged_in_range(cx: &Cx<'_>, values: &TokenStream) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (vis, params, out_of_range) = (&model.vis, &names.params, out_of_range());
    let doc = format!("A chart `{}` in its initial situation, with this recipe.", model.name);
    let (given, bound) = (names::parameter("params", &quote!(#params)), names::bound_in_const("params"));
    quote! {
        #[doc = #doc]
        ///
        /// # Errors
        /// A param is not in the range that the chart states.
        #vis const fn with_params(#given) -> #p::Result<Self, #p::OutOfRange> {
            #bound
            match params_.#out_of_range() {
                #p::Option::Some(refused_) => #p::Result::Err(refused_),
                #p::Option::None => #p::Result::Ok(Self { #values params: params_ }),
            }
        }

        /// The recipe in use.
        #[must_use]
        #vis const fn params(&self) -> &#params {
            &self.params
        }

        /// Exchanges the recipe; the next cycle uses the new one.
        ///
        /// # Errors
        /// A param is not in the range that the chart states; the chart keeps the recipe that it has.
        #vis fn set_params(&mut self, #given) -> #p::Result<(), #p::OutOfRange> {
            match params_.#out_of_range() {
                #p::Option::Some(refused_) => #p::Result::Err(refused_),
                #p::Option::None => {
                    self.params = params_;
                    #p::Result::Ok(())
                }
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
        // Beside `self` and the phase Clippy allows five arguments, and what is called `iter` shall be one.
        let is_odd = action.params.len() > 5 || name == "iter";
        let allowed = is_odd.then(|| quote!(#[allow(clippy::too_many_arguments, clippy::iter_not_returning_iterator)]));
        quote!(#docs #allowed fn #name(&mut self, phase: #p::Phase, #(#params),*);)
    });
    let (vis, name, levels) = (&model.vis, &cx.names.actions, types::levels(model));
    let doc = format!("The code actions of [`{}`], carried out by the program.", model.name);
    let item = place::item("trait", name, &model.name, &quote!(#(#methods)*));
    quote! {
        #[doc = #doc]
        #levels
        #vis #item
    }
}
