//! What a program asks of a chart beside its cycle: names as text, default inputs in constants, the values of variables.

use proc_macro2::{Ident, Span, TokenStream};

use super::machine::Machine;
use super::{Cx, derives, requirements, types};
use crate::model::{Model, Ty};
use crate::place::{self, quote};
use crate::raw::plain;

/// `name`, `Debug` and `Display` of an enum of names, whose variants are listed.
pub(super) fn texts<'n>(
    model: &Model,
    name: &Ident,
    variants: impl Iterator<Item = &'n Ident>,
    p: &TokenStream,
) -> TokenStream {
    let (vis, levels) = (&model.vis, types::levels(model));
    let mut listed = TokenStream::new();
    for variant in variants {
        let text = plain(variant);
        listed.extend(quote!(#text,));
    }
    // Of an enum without variants there is no value, and no cast.
    let found =
        if listed.is_empty() { quote!(match self {}) } else { quote!(#p::name_at(&[#listed], self as #p::usize)) };
    quote! {
        #levels
        impl #name {
            /// The name as it is written.
            #[must_use]
            #vis const fn name(self) -> &'static #p::str {
                #found
            }
        }

        // A method of that name in a trait of the user comes first after a reference, and a variant after `Self::`.
        #[automatically_derived]
        impl #p::core::fmt::Debug for #name {
            fn fmt(&self, f_: &mut #p::core::fmt::Formatter<'_>) -> #p::core::fmt::Result {
                f_.write_str((*self).name())
            }
        }

        impl #p::core::fmt::Display for #name {
            fn fmt(&self, f_: &mut #p::core::fmt::Formatter<'_>) -> #p::core::fmt::Result {
                f_.pad((*self).name())
            }
        }
    }
}

/// `MotorInputs::DEFAULT`, where the default of each input is a constant.
pub(super) fn default_inputs(model: &Model, name: &Ident, p: &TokenStream) -> Option<TokenStream> {
    let constant = |ty: &Ty| !matches!(ty, Ty::Other(_)) || ty.is_float();
    if !model.inputs.values().all(|input| constant(&input.ty)) {
        return None;
    }
    let (vis, levels) = (&model.vis, types::levels(model));
    let mut seen = crate::sorted::Set::new();
    // In a chart with mistakes a name may be there twice.
    let declared = model.inputs.values().filter(|input| seen.insert(input.name.to_string()));
    let values = declared.map(|input| {
        let (name, value) = (&input.name, types::initial_value(None, &input.ty, p));
        quote!(#name: #value,)
    });
    Some(quote! {
        #levels
        impl #name {
            /// The default inputs, for constants and statics.
            #vis const DEFAULT: Self = Self { #(#values)* };
        }
    })
}

/// `MotorVars`. Nobody need use it: a lint at the chart's name would say so.
pub(super) fn vars_name(model: &Model) -> Ident {
    let name = format!("{}Vars", model.name).replace("r#", "");
    Ident::new(&name, Span::call_site().located_at(model.name.span()))
}

/// `MotorVars` and `motor.vars()`, where the chart stores variables.
pub(super) fn vars(cx: &Cx<'_>, machine: &Machine<'_>) -> Option<TokenStream> {
    let Cx { model, p, .. } = cx;
    let vars = &cx.plan.vars;
    let (vis, chart, name, levels) = (&model.vis, &model.name, vars_name(model), types::levels(model));
    let fields = vars.iter().map(|id| {
        let (field, ty) = (public(&model.vars[*id].name), types::rust_type(&model.vars[*id].ty, p));
        let docs = types::docs(&model.vars[*id].attrs, &format!("Variable `{field}`."));
        types::field(&docs, &field, &ty)
    });
    let values = vars.iter().zip(&machine.vars).map(|(id, value)| {
        let field = public(&model.vars[*id].name);
        quote!(#field: #value,)
    });
    let derives = derives::of(vars.iter().map(|id| &model.vars[*id].ty));
    let (written_out, derives) = (derives.written_out(&name, p), derives.attributes(model, p));
    let copied = requirements::copied(model, p);
    let doc = format!("The variables of [`{chart}`], as the last cycle has left them.");
    (!vars.is_empty()).then(|| {
        let item = place::item("struct", &name, &model.name, &quote!(#(#fields)*));
        quote! {
            #[doc = #doc]
            #derives
            #levels
            #vis #item

            #written_out

            #levels
            impl #chart {
                /// The variables, as the last cycle has left them.
                #[must_use]
                #vis fn vars(&self) -> #name {
                    #copied
                    #name { #(#values)* }
                }
            }
        }
    })
}

/// A field that may go unread.
fn public(name: &Ident) -> Ident {
    let mut field = name.clone();
    field.set_span(Span::call_site().located_at(name.span()));
    field
}
