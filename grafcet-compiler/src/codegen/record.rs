//! What a recorder needs to know of a chart. The code itself is a macro of the runtime (`grafcet_core::record`), so that this is but a list.

use proc_macro2::{Literal, TokenStream};
use quote::ToTokens;

use super::machine::{Field, Machine};
use super::{Cx, state, types};
use crate::analysis::{Concurrency, Nesting};
use crate::fingerprint::Hash;
use crate::list::List;
use crate::model::{Id, Model, Ty};
use crate::place::quote;

pub(super) fn all(cx: &Cx<'_>, machine: &Machine<'_>, fingerprint: u32) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (chart, inputs) = (&names.chart, &names.inputs);
    let input_fields = fields(model.inputs.values().map(|input| (&input.name, &input.ty)), p);
    let params = (!model.params.is_empty()).then(|| {
        let (name, fields) = (&names.params, fields(model.params.values().map(|param| (&param.name, &param.ty)), p));
        quote!(#name { #fields })
    });
    let is_clock = |field: &&Field| machine.clock.as_ref() == Some(&field.name);
    let state =
        machine.fields.iter().filter(|field| !is_clock(field)).map(|Field { name, ty, .. }| quote!(#name: #ty,));
    let (state, clock, enums) = (state.tokens(), &machine.clock, enums(cx, machine));
    let foreign = foreign(model, machine).into_iter().map(|ty| quote!(#ty,)).tokens();
    let layout = {
        let mut hash = Hash::new();
        hash.word(&fingerprint.to_string());
        hash.tokens(state.clone());
        hash.tokens(enums.clone());
        Literal::u32_suffixed(hash.finish())
    };
    let fingerprint = Literal::u32_suffixed(fingerprint);
    let (whole, together) = together(model, cx.plan.regions.is_single() && !cx.plan.shape.is_flags());
    quote! {
        #p::recorded! {
            chart #chart #fingerprint #layout
            inputs #inputs { #input_fields }
            params { #params }
            state { #state }
            clock { #clock }
            foreign { #foreign }
            together #whole #together
            enums { #enums }
        }
    }
}

/// Charts with more steps have no table: it grows with the square of their number.
const MOST_STEPS: usize = 256;

/// With which others each step can be active, and whether as many as can be together always are: so it is in a chart that is well
/// nested, whose branches exclude each other. One region whose state is an enum has one active step, or none, by itself.
fn together(model: &Model, one_region: bool) -> (bool, Literal) {
    if one_region || model.steps.len() > MOST_STEPS {
        return (false, Literal::byte_string(&[]));
    }
    let concurrency = Concurrency::of(model);
    let exclusive = Concurrency::of_exclusive_branches(model);
    let is_nested = Nesting::of(model).is_some();
    let concurrency = concurrency.across_partials(model);
    let mut whole = is_nested;
    let row = model.steps.len().div_ceil(8);
    let mut table = vec![0; row * model.steps.len()];
    for a in model.steps.ids() {
        for b in model.steps.ids() {
            let together = a != b && concurrency.together(a, b);
            whole &= a == b || together == exclusive.together(a, b);
            if together {
                table[a.index() * row + b.index() / 8] |= 1_u8 << (b.index() % 8);
            }
        }
    }
    (whole, Literal::byte_string(&table))
}

fn fields<'m>(fields: impl Iterator<Item = (&'m proc_macro2::Ident, &'m Ty)>, p: &TokenStream) -> TokenStream {
    let field = |(name, ty): (_, &Ty)| {
        let ty = types::rust_type(ty, p);
        quote!(#name: #ty,)
    };
    fields.map(field).tokens()
}

/// The enums of the regions with their variants, and the first one's with the mark above it.
fn enums(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let one = |&(region, empty, start): &(_, _, _)| {
        let (name, variants) = (cx.names.region(region, cx.plan), state::variants(cx, region, empty, start));
        let marked = cx.is_marked(region).then(|| {
            let marked = cx.names.marked(cx.plan);
            quote!(#marked #name {})
        });
        quote!(#name { #(#variants)* } #marked)
    };
    machine.regions.iter().map(one).tokens()
}

/// The types of which nobody knows whether they can be recorded: a chart with others is none the worse as long as nobody records it.
fn foreign(model: &Model, machine: &Machine<'_>) -> Vec<TokenStream> {
    let (inputs, params) = (model.inputs.values(), model.params.values());
    let all = inputs.map(|input| &input.ty).chain(params.map(|param| &param.ty)).chain(machine.stored.iter().copied());
    let foreign = all.filter_map(|ty| match ty {
        Ty::Other(rust) if !ty.is_float() => Some(rust.to_token_stream()),
        _ => None,
    });
    foreign.list()
}
