//! What a recorder needs to know of a chart. The code itself is a macro of the runtime (`grafcet_core::record`), so that this is but a list.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote_spanned};
use syn::spanned::Spanned as _;

use super::machine::{Began, Field, Machine};
use super::state::{self, StateEnum};
use super::{Cx, force, recipe, types, variants};
use crate::analysis::Situations;
use crate::fingerprint::{Hash, without};
use crate::list::List;
use crate::model::{Id, Model, Name, StepId, Ty, Variants};
use crate::place::{self, quote};
use crate::sorted::Map;

pub(super) fn all(cx: &Cx<'_>, machine: &Machine<'_>, situations: &Situations, fingerprint: u32) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (chart, inputs) = (&names.chart, &names.inputs);
    let listed = Listed::of(cx);
    let inputs_of = model.inputs.iter().map(|(id, input)| (&input.name, &input.ty, Name::Input(id)));
    let input_fields = fields(inputs_of, &listed, p);
    let foreign = foreign(model, machine, &listed);
    let params = (!model.params.is_empty()).then(|| {
        let params_of = model.params.iter().map(|(id, param)| (&param.name, &param.ty, Name::Param(id)));
        let (name, fields) = (&names.params, fields(params_of, &listed, p));
        let in_range = recipe::has_ranges(model).then(|| {
            let out_of_range = recipe::out_of_range();
            quote!(in #out_of_range)
        });
        quote!(#name { #fields } #in_range where { #foreign })
    });
    let began = machine.began.iter().map(|Began { name, .. }| quote!(#name)).tokens();
    let awaited =
        machine.began.iter().map(|Began { name, awaited, longest }| quote!(#name (#awaited) #longest)).tokens();
    let readings = machine.clock.iter().and(machine.began.iter().map(|began| &began.name)).list();
    let is_reading = |field: &&Field| readings.contains(&&field.name);
    let state = machine.fields.iter().filter(|field| !is_reading(field)).map(|Field { name, ty, .. }| {
        let how = listed.of_type(ty, p);
        quote!(#name: #ty #how,)
    });
    let (state, clock, enums) = (state.tokens(), &machine.clock, enums(cx, machine));
    // What is awaited is asked of it.
    let itself = (!machine.began.is_empty()).then(|| quote!(self #clock));
    let listed = listed.all();
    let layout = {
        let mut hash = Hash::new();
        hash.word(&fingerprint.to_string());
        let path = p.clone().into_iter().list();
        hash.tokens(without(state.clone(), &path));
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
            awaited { #itself #awaited }
            foreign { #foreign }
            possible { #possible }
            enums { #enums }
            listed { #listed }
        }
    }
}

/// Which transitions wait, by the numbers that the description gives them. A match and no list: it takes no memory.
fn blocked(cx: &Cx<'_>, machine: &Machine<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (chart, levels) = (&names.chart, types::levels(model));
    // Those in front of which the same steps stand are asked together.
    let sources = model.drawn_sources();
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
                #p::core::iter::Iterator::filter(0..#count, move |number_| match *number_ { #arms _ => false })
            }
        }
    }
}

fn fields<'m>(
    fields: impl Iterator<Item = (&'m Ident, &'m Ty, Name)>,
    listed: &Listed<'_>,
    p: &TokenStream,
) -> TokenStream {
    let field = |(name, ty, of): (_, &Ty, Name)| {
        let (ty, how) = (types::rust_type(ty, p), listed.of_name(of).map(|how| quote!(as #how)));
        quote!(#name: #ty #how,)
    };
    fields.map(field).tokens()
}

/// The enums whose variants the chart lists, and that carry nothing: their values are recorded by their place in the list, whatever else the program says of them.
struct Listed<'m> {
    /// A type that knows how, its name, and what it is about.
    codings: Vec<(Ident, TokenStream, &'m Variants)>,
}

impl<'m> Listed<'m> {
    fn of(cx: &Cx<'m>) -> Self {
        let plain = cx.model.variants.iter().filter(|variants| variants.list.iter().all(|variant| !variant.has_data));
        let coding = |(index, variants): (usize, &'m Variants)| {
            let name = format!("__{}Listed{index}", cx.model.name).replace("r#", "");
            let ty = variants.names.first().map(|name| types::rust_type(cx.model.ty(*name), &cx.p));
            (Ident::new(&name, place::mixed()), ty.unwrap_or_default(), variants)
        };
        Self { codings: plain.enumerate().map(coding).list() }
    }

    /// How the values of a name are recorded.
    fn of_name(&self, name: Name) -> Option<&Ident> {
        self.codings.iter().find(|(_, _, variants)| variants.names.contains(&name)).map(|(how, ..)| how)
    }

    /// How a field of the state is.
    fn of_type(&self, field: &TokenStream, p: &TokenStream) -> Option<TokenStream> {
        let field = field.to_string();
        self.codings.iter().find_map(|(how, ty, _)| {
            if field == ty.to_string() {
                return Some(quote!(as #how));
            }
            (field == quote!(#p::Option<#ty>).to_string()).then(|| quote!(as #how OrNone))
        })
    }

    fn has_type(&self, ty: &Ty) -> bool {
        let Ty::Other(rust) = ty else { return false };
        let text = rust.to_token_stream().to_string();
        self.codings.iter().any(|(_, listed, _)| listed.to_string() == text)
    }

    fn all(&self) -> TokenStream {
        let one = |(how, ty, variants): &(Ident, TokenStream, &Variants)| {
            let values = variants.list.iter().enumerate().map(|(number, variant)| {
                let (number, value) = (
                    Literal::u32_unsuffixed(u32::try_from(number).unwrap_or(u32::MAX)),
                    variants::value(variants, variant),
                );
                quote!(#number (#value),)
            });
            let values = values.tokens();
            quote!(#how #ty { #values })
        };
        self.codings.iter().map(one).tokens()
    }
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

/// The types of which nobody knows whether they can be recorded, and the trait that says so, where the chart names them: a chart with others is none the worse
/// as long as nobody records it.
fn foreign(model: &Model, machine: &Machine<'_>, listed: &Listed<'_>) -> TokenStream {
    let inputs = model.inputs.iter().map(|(id, input)| (&input.ty, listed.of_name(Name::Input(id)).is_some()));
    let params = model.params.iter().map(|(id, param)| (&param.ty, listed.of_name(Name::Param(id)).is_some()));
    let stored = machine.stored.iter().map(|ty| (*ty, listed.has_type(ty)));
    let foreign = inputs.and(params).and(stored).filter_map(|(ty, is_listed)| match ty {
        Ty::Other(rust) if !ty.is_float() && !is_listed => {
            let bound = quote_spanned!(place::mixed().located_at(rust.span())=> __Record);
            Some(quote!(#rust: #bound,))
        }
        _ => None,
    });
    foreign.tokens()
}
