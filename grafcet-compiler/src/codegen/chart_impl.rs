//! The methods of a chart, and its implementation of the trait `Chart`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::state::step_name;
use super::{Cx, names};
use crate::model::StepId;
use crate::plan::RegionId;

/// `cycle`, `init`, `is_active`, `active_steps`, `situation`, `is_stable`.
pub(super) fn inherent(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (vis, chart, inputs, outputs, step) = (&model.vis, &names.chart, &names.inputs, &names.outputs, &names.step);
    let body = cx.cycle_body();
    let (capacity, pushes) = active_steps(cx);
    let is_active = is_active(cx);
    let (situation_type, situation) = situation(cx);
    let stable = is_stable(cx);
    quote! {
        impl #chart {
            /// One cycle: evaluates the transition conditions on `inputs`, clears, and returns the outputs of the new
            /// situation.
            #vis fn cycle(&mut self, inputs: &#inputs) -> #outputs {
                #body
            }

            /// Back to the initial situation (the classic *Init*), stored outputs reset; the next cycle is a first one.
            #vis fn init(&mut self) {
                *self = Self::new();
            }

            /// Whether `step` is active.
            #[must_use]
            #vis fn is_active(&self, step: #step) -> #p::bool {
                #is_active
            }

            /// The active steps, in the order of their declaration; the capacity is the most that can be active.
            #[must_use]
            #vis fn active_steps(&self) -> #p::heapless::Vec<#step, #capacity> {
                #pushes
            }

            /// The situation: which steps are active.
            #[must_use]
            #vis const fn situation(&self) -> #situation_type {
                #situation
            }

            #stable
        }
    }
}

/// The uniform form for generic code.
pub(super) fn uniform(cx: &Cx<'_>) -> TokenStream {
    let Cx { model, p, names, .. } = cx;
    let (chart, inputs, outputs, step) = (&names.chart, &names.inputs, &names.outputs, &names.step);
    let transition = &names.transition;
    let name = model.name.to_string();
    let steps = model.steps.ids().map(|id| step_name(cx, id));
    let transitions = model.transitions.ids().map(|id| cx.names.transition_variant(id));
    let situation = situation(cx).0;
    quote! {
        impl #p::Chart for #chart {
            type Inputs = #inputs;
            type Outputs = #outputs;
            type Step = #step;
            type Transition = #transition;
            type Situation = #situation;
            type Actions<'a> = ();

            const NAME: &'static #p::str = #name;
            const STEPS: &'static [#step] = &[#(#steps),*];
            const TRANSITIONS: &'static [#transition] = &[#(#transition::#transitions),*];

            fn scan(&mut self, inputs: &#inputs, _now: #p::Ticks, _actions: &mut ()) -> #outputs {
                self.cycle(inputs)
            }

            fn init(&mut self) {
                self.init();
            }

            fn is_active(&self, step: #step) -> #p::bool {
                self.is_active(step)
            }

            fn situation(&self) -> #situation {
                self.situation()
            }
        }
    }
}

/// The capacity of `active_steps` and the body that fills it.
fn active_steps(cx: &Cx<'_>) -> (Literal, TokenStream) {
    let regions = cx.plan.regions.all();
    let capacity = Literal::usize_unsuffixed(regions.len().max(1));
    let p = &cx.p;
    let steps = names::local("steps");
    let pushes = if cx.plan.regions.is_single() {
        quote!(let _ = #steps.push(self.situation());)
    } else {
        // The order of declaration runs across the regions.
        cx.model
            .steps
            .ids()
            .map(|id| {
                let (active, name) = (holds(cx, id), step_name(cx, id));
                quote!(if #active { let _ = #steps.push(#name); })
            })
            .collect()
    };
    (capacity, quote!(let mut #steps = #p::heapless::Vec::new(); #pushes #steps))
}

fn is_active(cx: &Cx<'_>) -> TokenStream {
    if cx.plan.regions.is_single() {
        return quote!(self.situation() == step);
    }
    let step = &cx.names.step;
    let arms = cx.model.steps.ids().map(|id| {
        let (name, active) = (&cx.model.steps[id].name, holds(cx, id));
        quote!(#step::#name => #active,)
    });
    quote!(match step { #(#arms)* })
}

/// Whether the chart's state holds a step.
fn holds(cx: &Cx<'_>, step: StepId) -> TokenStream {
    let region = cx.plan.regions.of_step(step);
    let (field, variant) = (names::region_field(region, cx.plan), cx.variant(step));
    let starting = (cx.has_start_variant(region) && cx.plan.regions.all()[region].initial == Some(step)).then(|| {
        let start = cx.start();
        quote!(|| self.#field == #start)
    });
    quote!((self.#field == #variant #starting))
}

/// The type of the situation and the expression that reads it.
fn situation(cx: &Cx<'_>) -> (TokenStream, TokenStream) {
    let step = &cx.names.step;
    let region: RegionId = 0;
    let field = names::region_field(region, cx.plan);
    let arms = cx.plan.regions.all().iter().flat_map(|region| &region.steps).map(|id| {
        let (variant, name) = (cx.variant(*id), step_name(cx, *id));
        let starting =
            (cx.has_start_variant(region) && cx.plan.regions.all()[region].initial == Some(*id)).then(|| {
                let start = cx.start();
                quote!(| #start)
            });
        quote!(#variant #starting => #name,)
    });
    (quote!(#step), quote!(match self.#field { #(#arms)* }))
}

/// A30: whether the last search for stability came to an end.
fn is_stable(cx: &Cx<'_>) -> Option<TokenStream> {
    let (vis, p) = (&cx.model.vis, &cx.p);
    if !cx.model.is_grafcet() {
        return None;
    }
    let value = if cx.plan.may_be_unstable { quote!(self.stable) } else { quote!(true) };
    Some(quote! {
        /// Whether the last cycle reached a stable situation. If not, it stopped after the most evolutions it may make
        /// and keeps the situation it had reached (decision A30).
        #[must_use]
        #vis const fn is_stable(&self) -> #p::bool {
            #value
        }
    })
}
