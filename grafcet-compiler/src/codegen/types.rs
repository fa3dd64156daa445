//! The public types beside the chart: inputs, outputs, names of steps and transitions.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote_spanned};
use syn::spanned::Spanned as _;
use syn::{Attribute, Type};

use super::{Cx, cleared, derives, outside, requirements};
use crate::list::List;
use crate::model::{Expr, Integer, Model, OutputId, Ty};
use crate::place::{self, quote};

pub(super) fn all(cx: &Cx<'_>) -> TokenStream {
    let (inputs, outputs) = (inputs(cx), outputs(cx));
    let (steps, transitions) = (step_names(cx), transition_names(cx));
    quote!(#inputs #outputs #steps #transitions)
}

/// A field that the program sees. What rustc says of it, as where a derived trait is missing, stands at its name.
pub(super) fn field(docs: &TokenStream, name: &Ident, ty: &TokenStream) -> TokenStream {
    let public = quote_spanned!(place::near(name.span())=> pub);
    quote!(#docs #public #name: #ty,)
}

/// What the address of a value is a multiple of, if its type is one that everybody knows.
pub(super) fn align(ty: &Ty) -> Option<u8> {
    match ty {
        Ty::Bool(_) => Some(1),
        Ty::Time(_) => Some(4),
        Ty::Int { rust, .. } => {
            let Integer { bits, is_size, .. } = Integer::of(rust)?;
            Some(if is_size { 5 } else { u8::try_from(bits / 8).ok()? })
        }
        Ty::Other(Type::Path(path)) if path.qself.is_none() => match &*path.path.get_ident()?.to_string() {
            "f32" | "char" => Some(4),
            "f64" => Some(8),
            _ => None,
        },
        Ty::Other(_) => None,
    }
}

fn inputs(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, .. } = cx;
    let fields = model.inputs.values().map(|input| {
        let (name, ty) = (&input.name, rust_type(&input.ty, p));
        let docs = docs(&input.attrs, &format!("Input `{name}`."));
        field(&docs, name, &ty)
    });
    let default = default_inputs(cx);
    let derives = derives::of(model.inputs.values().map(|input| &input.ty));
    let (vis, name, levels) = (&model.vis, &cx.names.inputs, levels(model));
    let written_out = derives.written_out(name, p);
    let derives = if default.is_some() { derives } else { derives.and("Default") }.attributes(model, p);
    let doc = format!("The process inputs of [`{}`], sampled once per cycle.", model.name);
    let constant = outside::default_inputs(model, name, p);
    let item = place::item("struct", name, &model.name, &quote!(#(#fields)*));
    quote! {
        #[doc = #doc]
        #derives
        #levels
        #vis #item

        #written_out
        #default
        #constant
    }
}

/// The inputs of which nothing else is said, where a derive would report a type without a default at the whole chart.
fn default_inputs(cx: &Cx<'_>) -> Option<TokenStream> {
    let Cx { model, p, .. } = cx;
    requirements::distinct(model.inputs.values().map(|input| &input.ty), requirements::has_default).first()?;
    let initial = model.inputs.values().map(|input| {
        let (name, value) = (&input.name, initial_value(None, &input.ty, p));
        quote!(#name: #value,)
    });
    Some(default_of(cx, &cx.names.inputs, &initial.tokens()))
}

fn default_of(cx: &Cx<'_>, name: &Ident, initial: &TokenStream) -> TokenStream {
    let (p, levels) = (&cx.p, levels(cx.model));
    quote! {
        #levels
        impl #p::core::default::Default for #name {
            fn default() -> Self {
                Self { #initial }
            }
        }
    }
}

fn outputs(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, .. } = cx;
    let pieces = cleared::in_pieces(model).map(|fields| fields.into_iter().map(|(id, _)| id).list());
    // Processors without unaligned stores clear many single bytes through a call, words at once.
    let repr = match (pieces.is_some(), model.outputs.len() > 4) {
        (true, true) => Some(quote!(#[repr(C, align(4))])),
        (true, false) => Some(quote!(#[repr(C)])),
        (false, true) => Some(quote!(#[repr(align(4))])),
        (false, false) => None,
    };
    let order = pieces.unwrap_or_else(|| model.outputs.ids().list());
    let fields = order.into_iter().map(|id| {
        let output = &model.outputs[id];
        let (name, ty) = (&output.name, rust_type(&output.ty, p));
        let docs = docs(&output.attrs, &format!("Output `{name}`."));
        field(&docs, name, &ty)
    });
    let fields = fields.tokens();
    let derives = derives::of(model.outputs.values().map(|output| &output.ty));
    let (vis, name, levels) = (&model.vis, &cx.names.outputs, levels(model));
    let default = default_outputs(cx);
    let written_out = derives.written_out(name, p);
    let derives = if default.is_some() { derives } else { derives.and("Default") }.attributes(model, p);
    let doc = format!("The process outputs of [`{}`]; `default()` holds the initial values.", model.name);
    let item = place::item("struct", name, &model.name, &fields);
    quote! {
        #[doc = #doc]
        #derives
        #levels
        #repr
        #vis #item

        #written_out
        #default
    }
}

/// The outputs before anything has acted on them, where the chart says what they are.
fn default_outputs(cx: &Cx<'_>) -> Option<TokenStream> {
    let Cx { model, p, .. } = cx;
    let foreign = requirements::distinct(model.outputs.values().map(|output| &output.ty), requirements::has_default);
    if foreign.is_empty() && model.outputs.values().all(|output| output.init.is_none()) {
        return None;
    }
    let initial = model.outputs.iter().map(|(id, output)| {
        let (name, value) = (&output.name, initial_output(model, id, p));
        quote!(#name: #value,)
    });
    Some(default_of(cx, &cx.names.outputs, &initial.tokens()))
}

fn step_names(cx: &Cx<'_>) -> TokenStream {
    let variants = cx.model.steps.values().map(|step| {
        let name = &step.name;
        let docs = docs(&step.attrs, &format!("Step `{name}`."));
        quote!(#docs #name,)
    });
    let doc = format!("The names of the steps of [`{}`].", cx.model.name);
    let names = name_enum(cx, &cx.names.step, &doc, &variants.tokens());
    let texts = outside::texts(cx.model, &cx.names.step, cx.model.steps.values().map(|step| &step.name), &cx.p);
    quote!(#names #texts)
}

fn transition_names(cx: &Cx<'_>) -> TokenStream {
    let variants = cx.model.drawn_transitions().map(|(id, transition)| {
        let name = cx.names.transition_variant(id);
        let text = transition_text(cx.model, transition);
        quote!(#[doc = #text] #name,)
    });
    let doc = format!("The names of the transitions of [`{}`].", cx.model.name);
    let names = name_enum(cx, &cx.names.transition, &doc, &variants.tokens());
    let variants = cx.model.drawn_transitions().map(|(id, _)| cx.names.transition_variant(id));
    let texts = outside::texts(cx.model, &cx.names.transition, variants, &cx.p);
    quote!(#names #texts)
}

fn name_enum(cx: &Cx<'_>, name: &Ident, doc: &str, variants: &TokenStream) -> TokenStream {
    // The names are the chart's. Where the crate forbids a lint, it cannot be allowed either.
    let unusual = cx.model.steps.values().any(|step| {
        let name = step.name.to_string();
        !name.starts_with(|first: char| first.is_ascii_uppercase()) || name.contains('_')
    });
    let unusual = unusual.then(|| quote!(#[allow(non_camel_case_types)]));
    let (vis, levels) = (&cx.model.vis, levels(cx.model));
    let derives = derives::of_names();
    let (written_out, derives) = (derives.written_out(name, &cx.p), derives.attributes(cx.model, &cx.p));
    let item = place::item("enum", name, &cx.model.name, &quote!(#variants));
    quote! {
        #[doc = #doc]
        #derives
        #unusual
        #levels
        #vis #item

        #written_out
    }
}

/// `` `Off -[on && !over_temp]-> On` ``
pub(super) fn transition_text(model: &Model, transition: &crate::model::Transition) -> String {
    let (from, to) = model.ends_text(transition);
    format!("`{from} -[{}]-> {to}`", transition.condition.text)
}

/// The declared type in Rust.
pub(super) fn rust_type(ty: &Ty, p: &TokenStream) -> TokenStream {
    match ty {
        // What the compiler takes for a primitive type is one, whatever else has its name in the surrounding module.
        Ty::Bool(rust) | Ty::Int { rust, .. } => primitive(rust, p),
        Ty::Other(rust) if ty.is_float() => primitive(rust, p),
        Ty::Other(rust) => rust.to_token_stream(),
        Ty::Time(_) => quote!(#p::Ticks),
    }
}

/// `one == other` or `one != other`. A float that is no number equals itself here: a search for stability that stores it
/// would not end.
pub(super) fn compare(
    ty: &Ty,
    one: &TokenStream,
    operator: &TokenStream,
    other: &TokenStream,
    p: &TokenStream,
) -> TokenStream {
    if let (Ty::Other(rust), false) = (ty, ty.is_float()) {
        if !requirements::is_copy(rust) {
            let not = (operator.to_string() == "!=").then(|| quote!(!));
            let same = requirements::is_same(rust, one, other, p);
            return quote!(#not #same);
        }
    }
    let bits = ty.is_float().then(|| quote!(.to_bits()));
    quote!(#one #bits #operator #other #bits)
}

fn primitive(rust: &Type, p: &TokenStream) -> TokenStream {
    quote_spanned!(Span::call_site().located_at(rust.span())=> #p::core::primitive::#rust)
}

/// The lint levels of the chart, which all its items share; an expectation is met once, at the chart itself.
pub(super) fn levels(model: &Model) -> TokenStream {
    let shared = |attr: &&Attribute| !attr.path().is_ident("doc") && !attr.path().is_ident("expect");
    model.attrs.iter().filter(shared).map(ToTokens::to_token_stream).tokens()
}

/// The user's doc comments and lint attributes; where there is no doc, a line that says what it is.
pub(super) fn docs(attrs: &[Attribute], default: &str) -> TokenStream {
    let documented = attrs.iter().any(|attr| attr.path().is_ident("doc"));
    let default = (!documented).then(|| quote!(#[doc = #default]));
    quote!(#default #(#attrs)*)
}

/// The value of an output before anything has acted on it.
pub(super) fn initial_output(model: &Model, output: OutputId, p: &TokenStream) -> TokenStream {
    let output = &model.outputs[output];
    initial_value(output.init.as_ref(), &output.ty, p)
}

/// What stands after `=`, or the default of the type; constant but for a user's own type without a value.
pub(super) fn initial_value(init: Option<&Expr>, ty: &Ty, p: &TokenStream) -> TokenStream {
    if let Some(init) = init {
        return super::rust::constant(init, p);
    }
    match ty {
        Ty::Bool(_) => quote!(false),
        Ty::Int { .. } => quote!(0),
        Ty::Time(_) => quote!(#p::Ticks::ZERO),
        Ty::Other(_) if ty.is_float() => quote!(0.0),
        Ty::Other(rust) => requirements::default_value(rust, p),
    }
}
