//! The chart's struct and the private enums of its regions.

use proc_macro2::{Ident, Literal, TokenStream};

use super::machine::{Field, Machine};
use super::{Cx, derives, names, recipe, types};
use crate::list::List;
use crate::model::StepId;
use crate::place::{self, quote};
use crate::program::RegionId;
use crate::sorted::sort_by_key;

/// The enum of a region: the steps, of which at most one is active, what it has beside them, and how it is stored.
pub(super) struct StateEnum {
    pub(super) region: RegionId,
    /// Its states, by the steps they are named after.
    pub(super) states: Vec<StepId>,
    /// None of the steps may be active.
    pub(super) empty: bool,
    /// The first cycle may be still to come.
    pub(super) start: bool,
    /// A bit above the state tells that the last search did not become stable (A30).
    pub(super) marked: bool,
    /// It is as wide as a register, which saves widening it in every evolution. The field holds a byte all the same.
    pub(super) wide: bool,
}

/// The variants of a region's enum.
pub(super) fn variants(cx: &Cx<'_>, states: &StateEnum) -> Vec<Ident> {
    let steps = states.states.iter().map(|step| names::private_variant(cx.model, *step));
    let empty = states.empty.then(|| cx.names.empty.clone());
    let start = states.start.then(|| cx.names.start.clone());
    steps.and(empty).and(start).list()
}

/// The type and what belongs to it.
pub(super) fn region_enum(cx: &Cx<'_>, states: &StateEnum) -> TokenStream {
    let p = &cx.p;
    let name = cx.names.region(states.region, cx.plan);
    let derives = derives::of_states();
    let (written_out, derives) = (derives.written_out(&name, p), derives.attributes(cx.model, p));
    let variants = variants(cx, states);
    let marked = states.marked.then(|| marked(cx, &variants));
    let texts = variants.iter().map(|variant| variant.to_string().trim_start_matches("r#").to_owned()).list();
    let wide = states.wide.then(|| quote!(#[repr(u32)]));
    quote! {
        #derives
        #[doc(hidden)]
        #wide
        enum #name { #(#variants,)* }

        #written_out

        #[automatically_derived]
        impl #p::core::fmt::Debug for #name {
            fn fmt(&self, f_: &mut #p::core::fmt::Formatter<'_>) -> #p::core::fmt::Result {
                f_.write_str(#p::name_at(&[#(#texts),*], *self as #p::usize))
            }
        }

        #marked
    }
}

/// A30: that the last search did not become stable is told by a bit above the first region's state, so that it takes no
/// byte of its own.
fn marked(cx: &Cx<'_>, variants: &[Ident]) -> TokenStream {
    let p = &cx.p;
    let (name, state) = (cx.names.marked(cx.plan), cx.names.region(0, cx.plan));
    let derives = derives::of_states().and("Debug");
    let (written_out, derives) = (derives.written_out(&name, p), derives.attributes(cx.model, p));
    let mark = variants.len().next_power_of_two();
    let (number, literal): (_, fn(usize) -> Literal) = match mark {
        0..=128 => (quote!(#p::u8), |n| Literal::u8_suffixed(u8::try_from(n).unwrap_or(u8::MAX))),
        _ => (quote!(#p::u16), |n| Literal::u16_suffixed(u16::try_from(n).unwrap_or(u16::MAX))),
    };
    let (mark, numbers) = (literal(mark), literal(mark - 1));
    let numbered = from_number(&state, variants, &literal);
    quote! {
        /// A state, and above it the mark of a search that did not become stable.
        #derives
        #[doc(hidden)]
        struct #name(#number);

        #written_out

        impl #name {
            const fn of(state_: #state) -> Self {
                Self(state_ as #number)
            }

            const fn state(self) -> #state {
                let number_ = self.0 & #numbers;
                #numbered
            }

            /// Another state, and the mark as it is.
            const fn with(self, state_: #state) -> Self {
                Self(self.0 & #mark | state_ as #number)
            }

            const fn unmarked(self) -> Self {
                Self(self.0 & #numbers)
            }

            const fn marked(self) -> Self {
                Self(self.0 | #mark)
            }

            const fn is_marked(self) -> #p::bool {
                self.0 & #mark != 0
            }
        }
    }
}

/// The state that `number` stands for. Numbers that no state has are the last one's; that it is asked for first keeps LLVM
/// from comparing with each of three.
fn from_number(state: &Ident, variants: &[Ident], literal: &impl Fn(usize) -> Literal) -> TokenStream {
    let Some((last, others)) = variants.split_last() else { return TokenStream::new() };
    let Some((rest, first)) = others.split_last() else { return quote!({ let _ = number_; #state::#last }) };
    let arms = first.iter().enumerate().map(|(i, variant)| {
        let number = literal(i);
        quote!(#number => #state::#variant,)
    });
    let highest = literal(others.len());
    quote!(if number_ >= #highest { #state::#last } else { match number_ { #(#arms)* _ => #state::#rest } })
}

/// The struct, and how it is made.
pub(super) fn chart(cx: &Cx<'_>, machine: &Machine<'_>, drawing: &TokenStream) -> TokenStream {
    let Cx { model, p, .. } = cx;
    let (vis, name) = (&model.vis, &model.name);
    let docs = types::docs(&model.attrs, &format!("The chart `{name}`."));
    let fields = &machine.fields;
    let (layout, declared) = declared(cx, fields);
    let values = fields.iter().map(|Field { name, initial, .. }| quote!(#name: #initial,));
    let stored = machine.stored.iter().copied();
    let derives = derives::of(stored.and(model.params.values().map(|param| &param.ty))).of_chart();
    let (written_out, derives) = (derives.written_out(name, p), derives.attributes(model, p));
    let levels = types::levels(model);
    let new = constructors(cx, &quote!(#(#values)*));
    let encoding = cx.encoding(machine).map(|text| format!("\n\n{text}"));
    let encoding = encoding.map(|text| quote!(#[doc = #text]));
    let item = place::item("struct", name, &model.name, &declared);
    quote! {
        #docs
        #drawing
        #encoding
        #derives
        #layout
        #vis #item

        #written_out

        #levels
        impl #name { #new }

        impl #p::core::default::Default for #name {
            fn default() -> Self {
                Self::new()
            }
        }
    }
}

/// The fields in their order, and what keeps it. An instruction of two bytes reaches so many bytes from where the struct begins, and as many words. So in one that
/// is larger what is small stands first; rustc places it last. Where the alignment of a type is not known rustc decides, as it wastes none.
fn declared(cx: &Cx<'_>, fields: &[Field]) -> (Option<TokenStream>, TokenStream) {
    const REACH: usize = 32;
    let params = (!cx.model.params.is_empty()).then(|| {
        let name = &cx.names.params;
        let aligned = cx.model.params.values().map(|param| types::align(&param.ty)).list();
        (aligned.into_iter().try_fold(1, |most, align| Some(most.max(align?))), quote!(params: #name,))
    });
    let declared = fields.iter().map(|Field { name, ty, align, .. }| (*align, quote!(#name: #ty,)));
    let mut declared = declared.and(params).list();
    // Each takes as many bytes as its alignment at least.
    let size = declared.iter().try_fold(0, |sum, (align, _)| align.map(|align| sum + usize::from(align)));
    let is_ordered = size.is_some_and(|size| size > REACH);
    if is_ordered {
        sort_by_key(&mut declared, |(align, _)| *align);
    }
    let fields = declared.into_iter().map(|(_, field)| field).tokens();
    (is_ordered.then(|| quote!(#[repr(C)])), fields)
}

/// `new`, and with a recipe `with_params`, `params` and `set_params`.
fn constructors(cx: &Cx<'_>, values: &TokenStream) -> TokenStream {
    let (vis, name) = (&cx.model.vis, &cx.model.name);
    let doc = format!("A chart `{name}` in its initial situation; its activation belongs to the first cycle.");
    if cx.model.params.is_empty() {
        let new = quote! {
            #[doc = #doc]
            #[must_use]
            #vis const fn new() -> Self {
                Self { #values }
            }
        };
        return new;
    }
    let params = &cx.names.params;
    let (given, bound) = (names::parameter("params", &quote!(#params)), names::bound_in_const("params"));
    let with_doc = format!("A chart `{name}` in its initial situation, with this recipe.");
    if recipe::has_ranges(cx.model) {
        let exchanged = recipe::exchanged_in_range(cx, values);
        let new = quote! {
            #[doc = #doc]
            #[must_use]
            #vis const fn new() -> Self {
                let params_ = #params::new();
                Self { #values params: params_ }
            }

            #exchanged
        };
        return new;
    }
    quote! {
        #[doc = #doc]
        #[must_use]
        #vis const fn new() -> Self {
            Self::with_params(#params::new())
        }

        #[doc = #with_doc]
        #[must_use]
        #vis const fn with_params(#given) -> Self {
            #bound
            Self { #values params: params_ }
        }

        /// The recipe in use.
        #[must_use]
        #vis const fn params(&self) -> &#params {
            &self.params
        }

        /// Exchanges the recipe; the next cycle uses the new one.
        #vis fn set_params(&mut self, #given) {
            self.params = params_;
        }
    }
}

/// `MotorStep::Off`
pub(super) fn step_name(cx: &Cx<'_>, step: StepId) -> TokenStream {
    let (names, step) = (&cx.names.step, &cx.model.steps[step].name);
    quote!(#names::#step)
}
