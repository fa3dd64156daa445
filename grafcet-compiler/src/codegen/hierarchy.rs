//! `grafcet`: what a partial grafcet does when a forcing order or an enclosing step decides about it.

use proc_macro2::TokenStream;
use quote::quote;

use super::Cx;
use super::bind::{Moment, bare};
use crate::model::{ForceOrder, PartialId, StepId};

impl Cx<'_> {
    /// `evolve`, unless something above decides: first forcing, then what follows for enclosures (A15).
    pub(super) fn under_masters(&self, partial: PartialId, evolve: &TokenStream) -> TokenStream {
        let forces: Vec<_> = self.model.forces.values().filter(|force| force.target == partial).collect();
        if !forces.is_empty() {
            // A11: an order that is there after the evolution shows in it.
            let orders = forces.iter().map(|force| {
                let ordered = bare(self.is_active(force.step, Moment::Stable));
                let situation = match &force.order {
                    ForceOrder::Steps(steps) => self.set_situation(partial, steps),
                    ForceOrder::Init => self.set_situation(partial, &self.marked(partial, |step| step.initial)),
                    ForceOrder::Hold => TokenStream::new(),
                };
                quote!(if #ordered { #situation } else)
            });
            // A13: in the evolution in which the order ends the partial grafcet is still frozen.
            let frozen = forces.iter().map(|force| self.is_active(force.step, Moment::Condition));
            return quote!(#(#orders)* if !(#(#frozen)||*) { #evolve });
        }
        let Some(outer) = self.model.partials[partial].enclosed_by else { return evolve.clone() };
        let (was, is) = (self.is_active(outer, Moment::Condition), self.is_active(outer, Moment::Stable));
        let empty = self.set_situation(partial, &[]);
        let linked = self.set_situation(partial, &self.marked(partial, |step| step.linked));
        // A19: if the enclosing step is left, the inner transitions clear nothing.
        quote!(if !#is { #empty } else if !#was { #linked } else { #evolve })
    }

    fn marked(&self, partial: PartialId, wanted: fn(&crate::model::Step) -> bool) -> Vec<StepId> {
        let steps = &self.model.partials[partial].steps;
        steps.iter().copied().filter(|step| wanted(&self.model.steps[*step])).collect()
    }
}
