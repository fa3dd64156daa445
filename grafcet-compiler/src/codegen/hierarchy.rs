//! `grafcet`: what a partial grafcet does when a forcing order or an enclosing step decides about it.

use proc_macro2::TokenStream;
use quote::quote;

use super::Cx;
use super::bind::{Moment, bare};
use super::situation::At;
use crate::model::{ForceOrder, PartialId, StepId, Transition};
use crate::plan::RegionId;
use crate::sorted::Map;

impl Cx<'_> {
    /// `evolve`, unless something above decides: first forcing, then what follows for enclosures (A15).
    pub(super) fn under_masters(&self, partial: PartialId, evolve: &TokenStream) -> TokenStream {
        if self.evolves_upwards() {
            return self.under_idle_masters(partial, evolve);
        }
        let is_active = |step| {
            if self.in_place() { self.in_step(At::Now, step) } else { bare(self.is_active(step, Moment::Stable)) }
        };
        let forces: Vec<_> = self.model.forces.values().filter(|force| force.target == partial).collect();
        if !forces.is_empty() {
            // A11: an order that is there after the evolution shows in it.
            let orders = forces.iter().map(|force| {
                let ordered = is_active(force.step);
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
        let (was, is) = (bare(self.is_active(outer, Moment::Condition)), is_active(outer));
        let empty = self.set_situation(partial, &[]);
        let linked = self.set_situation(partial, &self.marked(partial, |step| step.linked));
        // A19: if the enclosing step is left, the inner transitions clear nothing.
        quote!(if !(#is) { #empty } else if !(#was) { #linked } else { #evolve })
    }

    fn marked(&self, partial: PartialId, wanted: fn(&crate::model::Step) -> bool) -> Vec<StepId> {
        let steps = &self.model.partials[partial].steps;
        steps.iter().copied().filter(|step| wanted(&self.model.steps[*step])).collect()
    }

    /// Whether partial grafcets evolve in place from the bottom upwards.
    pub(super) fn evolves_upwards(&self) -> bool {
        self.model.partials.len() > 1 && self.in_place() && self.plan.upwards
    }

    /// `evolve`, unless the situation before the evolution freezes the partial grafcet. Those above have not evolved yet.
    fn under_idle_masters(&self, partial: PartialId, evolve: &TokenStream) -> TokenStream {
        let forces = self.model.forces.values().filter(|force| force.target == partial);
        let frozen: Vec<_> = forces.map(|force| self.in_step(At::Now, force.step)).collect();
        if !frozen.is_empty() {
            return quote!(if !(#(#frozen)||*) { #evolve });
        }
        let Some(outer) = self.model.partials[partial].enclosed_by else { return evolve.clone() };
        let active = self.in_step(At::Now, outer);
        quote!(if #active { #evolve })
    }

    /// The regions below that a transition overwrites by what it enters and leaves: first by forcing, then by enclosing (A15).
    pub(super) fn overwritten_by(&self, transition: &Transition) -> Vec<TokenStream> {
        let mut states = Map::new();
        let left = transition.sources.iter().filter(|step| !transition.targets.contains(step));
        left.for_each(|step| self.leaving(*step, &mut states));
        let entered = transition.targets.iter().filter(|step| !transition.sources.contains(step));
        entered.for_each(|step| self.entering(*step, &mut states));
        let state = |step: Option<StepId>, region| step.map_or_else(|| self.empty(region), |step| self.variant(step));
        states.into_iter().map(|(region, step)| self.enter_state(region, &state(step, region))).collect()
    }

    /// Its enclosures are emptied with a step that is left.
    fn leaving(&self, step: StepId, states: &mut Map<RegionId, Option<StepId>>) {
        for (id, partial) in self.model.partials.iter().filter(|(_, partial)| partial.enclosed_by == Some(step)) {
            states.extend(self.plan.regions.of_partial(id).map(|region| (region, None)));
            partial.steps.iter().for_each(|inner| self.leaving(*inner, states));
        }
    }

    /// A step that is entered forces what it forces, and activates the linked steps of its enclosures, which were empty.
    fn entering(&self, step: StepId, states: &mut Map<RegionId, Option<StepId>>) {
        for force in self.model.forces.values().filter(|force| force.step == step) {
            let situation = match &force.order {
                ForceOrder::Steps(steps) => steps.clone(),
                ForceOrder::Init => self.marked(force.target, |step| step.initial),
                ForceOrder::Hold => continue,
            };
            states.extend(self.plan.regions.of_partial(force.target).map(|region| (region, None)));
            self.model.partials[force.target].steps.iter().for_each(|step| self.leaving(*step, states));
            self.all_entered(&situation, states);
        }
        for id in self.model.partials.ids().filter(|id| self.model.partials[*id].enclosed_by == Some(step)) {
            self.all_entered(&self.marked(id, |step| step.linked), states);
        }
    }

    fn all_entered(&self, steps: &[StepId], states: &mut Map<RegionId, Option<StepId>>) {
        states.extend(steps.iter().map(|step| (self.plan.regions.of_step(*step), Some(*step))));
        for step in steps {
            self.entering(*step, states);
        }
    }
}
