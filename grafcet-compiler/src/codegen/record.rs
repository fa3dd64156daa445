//! What a recorder needs to know of a chart. The code itself is a macro of the runtime (`grafcet_core::record`), so that this is but a list.

use proc_macro2::{Literal, TokenStream};
use quote::ToTokens;

use super::machine::{Field, Machine};
use super::state::{self, StateEnum};
use super::{Cx, force, recipe, types};
use crate::analysis::Situations;
use crate::fingerprint::Hash;
use crate::list::List;
use crate::model::{Id, Model, StepId, Ty};
use crate::place::quote;
use crate::sorted::Map;

pub(super) fn all(cx: &Cx<'_>, machine: &Machine<'_>, situations: &Situations, fingerprint: u32) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (chart, inputs) = (&names.chart, &names.inputs);
    let input_fields = fields(model.inputs.values().map(|input| (&input.name, &input.ty)), p);
    let params = (!model.params.is_empty()).then(|| {
        let (name, fields) = (&names.params, fields(model.params.values().map(|param| (&param.name, &param.ty)), p));
        let in_range = recipe::has_ranges(model).then(|| {
            let out_of_range = recipe::out_of_range();
            quote!(in #out_of_range)
        });
        quote!(#name { #fields } #in_range)
    });
    let began = machine.began.iter().map(|name| quote!(#name)).tokens();
    let is_reading = |field: &&Field| machine.clock.iter().chain(&machine.began).any(|reading| *reading == field.name);
    let state =
        machine.fields.iter().filter(|field| !is_reading(field)).map(|Field { name, ty, .. }| quote!(#name: #ty,));
    let (state, clock, enums) = (state.tokens(), &machine.clock, enums(cx, machine));
    let foreign = foreign(model, machine).into_iter().map(|ty| quote!(#ty,)).tokens();
    let layout = {
        let mut hash = Hash::new();
        hash.word(&fingerprint.to_string());
        hash.tokens(state.clone());
        hash.tokens(began.clone());
        hash.tokens(enums.clone());
        Literal::u32_suffixed(hash.finish())
    };
    let fingerprint = Literal::u32_suffixed(fingerprint);
    let (possible, blocked) = (force::possible(situations, p), blocked(cx, machine));
    quote! {
        #blocked

        #p::recorded! {
            chart #chart #fingerprint #layout
            inputs #inputs { #input_fields }
            params { #params }
            state { #state }
            clock { #clock #began }
            foreign { #foreign }
            possible { #possible }
            enums { #enums }
        }
    }
}

/// Which transitions wait, by the numbers that the description gives them. A match and no list: it takes no memory.
fn blocked(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (chart, levels) = (&names.chart, types::levels(model));
    // Those in front of which the same steps stand are asked together; of what an `any` stands for each.
    let drawn = model.drawn_transitions().map(|(_, transition)| match transition.any {
        None => vec![&transition.sources[..]],
        any => model.transitions.values().filter(|other| other.any == any).map(|other| &other.sources[..]).list(),
    });
    let sources = drawn.list();
    let count = Literal::usize_suffixed(sources.len());
    let mut alike: Map<Vec<&[StepId]>, Vec<Literal>> = Map::new();
    for (number, steps) in sources.into_iter().enumerate() {
        alike.or_default(steps).push(Literal::usize_suffixed(number));
    }
    let arms = alike.iter().map(|(sources, numbers)| {
        let each = sources.iter().map(|steps| {
            let active = steps.iter().map(|step| &machine.active[step.index()]).list();
            if active.is_empty() { quote!(true) } else { quote!((#((#active))&&*)) }
        });
        let each = each.list();
        quote!(#(#numbers)|* => #(#each)||*,)
    });
    let arms = arms.tokens();
    quote! {
        #levels
        #[automatically_derived]
        impl #p::Blocked for #chart {
            fn blocked(&self) -> impl #p::core::iter::Iterator<Item = #p::usize> {
                #p::core::iter::Iterator::filter(0..#count, move |number| match *number { #arms _ => false })
            }
        }
    }
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
    let one = |states: &StateEnum| {
        let (name, variants) = (cx.names.region(states.region, cx.plan), state::variants(cx, states));
        let marked = states.marked.then(|| {
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
