//! The chart's struct, the private enums of its regions, and the public situation.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Cx, names, types};
use crate::plan::RegionId;

pub(super) fn all(cx: &Cx<'_>) -> TokenStream {
    let regions: TokenStream = (0..cx.plan.regions.all().len()).map(|region| region_enum(cx, region)).collect();
    let chart = chart_struct(cx);
    quote!(#regions #chart)
}

/// The steps of a region; at most one of them is active.
fn region_enum(cx: &Cx<'_>, id: RegionId) -> TokenStream {
    let p = &cx.p;
    let region = &cx.plan.regions.all()[id];
    let name = cx.names.region(id, cx.plan);
    let steps = region.steps.iter().map(|step| names::private_variant(cx.model, *step));
    let empty = region.may_be_empty.then(|| cx.names.empty.clone());
    let start = cx.has_start_variant(id).then(|| cx.names.start.clone());
    let variants = steps.chain(empty).chain(start);
    quote! {
        #[derive(
            #p::core::clone::Clone, #p::core::marker::Copy, #p::core::cmp::PartialEq, #p::core::cmp::Eq,
            #p::core::fmt::Debug,
        )]
        #[doc(hidden)]
        #[allow(non_camel_case_types, clippy::enum_variant_names, clippy::upper_case_acronyms)]
        enum #name { #(#variants,)* }
    }
}

impl Cx<'_> {
    /// The first region's state also says that the first cycle is still to come.
    pub(super) fn has_start_variant(&self, region: RegionId) -> bool {
        region == 0 && self.plan.has_start
    }

    /// `__MotorState::INIT`
    pub(super) fn start(&self) -> TokenStream {
        let (region, start) = (self.names.region(0, self.plan), &self.names.start);
        quote!(#region::#start)
    }

    /// The state of a region in the initial situation, once entered.
    pub(super) fn initial(&self, region: RegionId) -> TokenStream {
        match self.plan.regions.all()[region].initial {
            Some(step) => self.variant(step),
            None => self.empty(region),
        }
    }

    /// The state of a region in a new chart.
    fn new_state(&self, region: RegionId) -> TokenStream {
        if self.has_start_variant(region) { self.start() } else { self.initial(region) }
    }

    /// The remembered outputs with their types and initial values.
    fn output_fields(&self) -> impl Iterator<Item = (proc_macro2::Ident, TokenStream, TokenStream)> {
        let mut outputs: Vec<_> = self.plan.stored.iter().chain(&self.plan.last).copied().collect();
        outputs.sort_unstable();
        outputs.into_iter().map(|id| {
            let ty = types::rust_type(&self.model.outputs[id].ty, &self.p);
            (names::output_field(self.model, id), ty, types::initial_output(self.model, id, &self.p))
        })
    }
}

fn chart_struct(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, plan, p, .. } = cx;
    let (vis, name) = (&model.vis, &model.name);
    let docs = types::docs(&model.attrs, &format!("The chart `{name}`."));
    let regions: Vec<_> = (0..plan.regions.all().len()).collect();
    let region_fields = regions.iter().map(|region| names::region_field(*region, plan));
    let region_types = regions.iter().map(|region| cx.names.region(*region, plan));
    let new_fields = regions.iter().map(|region| names::region_field(*region, plan));
    let new_states = regions.iter().map(|region| cx.new_state(*region));
    let (stored, stored_types, stored_values): (Vec<_>, Vec<_>, Vec<_>) = unzip(cx.output_fields());
    let (stable_field, stable_value) = match plan.may_be_unstable {
        true => (Some(quote!(stable: #p::bool,)), Some(quote!(stable: true,))),
        false => (None, None),
    };
    let derives = types::derives(plan.stored.iter().chain(&plan.last).map(|id| &model.outputs[*id].ty), p);
    let doc_new = format!("A chart `{name}` in its initial situation; its activation belongs to the first cycle.");
    quote! {
        #docs
        #[derive(#derives)]
        #vis struct #name {
            #(#region_fields: #region_types,)*
            #(#stored: #stored_types,)*
            #stable_field
        }

        impl #name {
            #[doc = #doc_new]
            #[must_use]
            #vis const fn new() -> Self {
                Self { #(#new_fields: #new_states,)* #(#stored: #stored_values,)* #stable_value }
            }
        }

        impl #p::core::default::Default for #name {
            fn default() -> Self {
                Self::new()
            }
        }
    }
}

fn unzip<A, B, C>(items: impl Iterator<Item = (A, B, C)>) -> (Vec<A>, Vec<B>, Vec<C>) {
    let (mut a, mut b, mut c) = (Vec::new(), Vec::new(), Vec::new());
    for (x, y, z) in items {
        a.push(x);
        b.push(y);
        c.push(z);
    }
    (a, b, c)
}

/// `MotorStep::Off`, for a step that may be spelled like a keyword of the future.
pub(super) fn step_name(cx: &Cx<'_>, step: crate::model::StepId) -> TokenStream {
    let (names, step) = (&cx.names.step, &cx.model.steps[step].name);
    let step = format_ident!("{step}");
    quote!(#names::#step)
}
