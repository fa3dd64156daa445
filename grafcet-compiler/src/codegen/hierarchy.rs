//! `grafcet`: what a partial grafcet does when a forcing order or an enclosing step decides about it.

use proc_macro2::{Ident, TokenStream};
use syn::Lifetime;

use super::bind::Moment;
use super::rust::bare;
use super::situation::At;
use super::{Cx, names};
use crate::list::List;
use crate::model::{ForceOrder, Id, PartialId, StepId, Transition};
use crate::place::{self, quote};
use crate::plan::{Below, Descent, directly, is_top};
use crate::sorted::Set;

impl Cx<'_> {
    /// `evolve`, unless something above decides: first forcing, then what follows for enclosures (A15).
    pub(super) fn under_masters(&self, partial: PartialId, evolve: &TokenStream) -> TokenStream {
        let is_active = |step| {
            if self.plan.shape.is_in_place() {
                self.in_step(At::Now, step)
            } else {
                bare(self.is_active(step, Moment::Stable))
            }
        };
        let forces: Vec<_> = self.model.forces.values().filter(|force| force.target == partial).list();
        if !forces.is_empty() {
            // A11: an order that is there after the evolution shows in it; of two that broken assumptions allow, the last in the source (A14).
            let orders = forces.iter().rev().map(|force| {
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
        steps.iter().copied().filter(|step| wanted(&self.model.steps[*step])).list()
    }

    /// An evolution of all partial grafcets, from the top downwards.
    pub(super) fn descend(&self) -> TokenStream {
        let partials = self.plan.evolution.partials.iter();
        if self.plan.descent == Descent::Jumps {
            let top = partials.filter(|id| is_top(self.model, **id));
            return top.map(|partial| self.jump_or_descend(*partial)).tokens();
        }
        let below = partials.clone().filter(|id| !is_top(self.model, **id));
        let declare = below.map(|id| {
            let free = free(*id);
            match self.frozen([*id]) {
                Some(frozen) => quote!(let mut #free = !(#frozen);),
                None => quote!(let mut #free = true;),
            }
        });
        let evolve = partials.map(|id| {
            let evolve = self.within_outer(*id, self.evolve_in_place(*id));
            if is_top(self.model, *id) {
                return evolve;
            }
            let free = free(*id);
            quote!(if #free { #evolve })
        });
        quote!(#(#declare)* #(#evolve)*)
    }

    /// A partial grafcet, and what is below it where it has decided about nothing there.
    fn jump_or_descend(&self, partial: PartialId) -> TokenStream {
        let evolve = self.evolve_in_place(partial);
        let label = label(partial);
        let frozen = self.frozen(directly(self.model, partial));
        let frozen = frozen.map(|frozen| quote!(if #frozen { break #label; }));
        let below = directly(self.model, partial).map(|id| self.within_outer(id, self.jump_or_descend(id)));
        let code = quote!(#evolve #frozen #(#below)*);
        let mut transitions = self.model.partials[partial].transitions.iter().map(|id| &self.model.transitions[*id]);
        if frozen.is_none() && transitions.all(|transition| self.below(transition).partials.is_empty()) {
            return code;
        }
        quote!(#label: { #code })
    }

    /// Whether one of the partial grafcets was forced before the evolution. A13: in the one in which the order ends it is still
    /// frozen.
    fn frozen(&self, partials: impl IntoIterator<Item = PartialId>) -> Option<TokenStream> {
        let partials: Vec<_> = partials.into_iter().list();
        let forces = self.model.forces.values().filter(|force| partials.contains(&force.target));
        let forcing: Set<_> = forces.map(|force| force.step).collect();
        let frozen = forcing.iter().map(|step| self.in_step(At::Before, *step));
        (!forcing.is_empty()).then(|| quote!(#(#frozen)||*))
    }

    /// Only while the enclosing step is active. Where that has been entered in this evolution, something has been decided.
    fn within_outer(&self, partial: PartialId, evolve: TokenStream) -> TokenStream {
        match self.model.partials[partial].enclosed_by {
            Some(outer) if !evolve.is_empty() => {
                let active = self.in_step(At::Now, outer);
                quote!(if #active { #evolve })
            }
            _ => evolve,
        }
    }

    /// What a transition does to the partial grafcets below its own, where they evolve after it.
    pub(super) fn below(&self, transition: &Transition) -> Below {
        if self.plan.shape.descends { Below::of(self.model, &self.plan.regions, transition) } else { Below::default() }
    }

    /// The states that a transition gives the regions below it.
    pub(super) fn overwrite_below(&self, below: &Below) -> Vec<TokenStream> {
        let state = |step: &Option<StepId>, region| step.map_or_else(|| self.empty(region), |step| self.variant(step));
        below.states.iter().map(|(region, step)| self.enter_state(*region, &state(step, *region))).list()
    }

    /// Nothing below a transition of this partial grafcet clears any more, where it decides about something there.
    pub(super) fn end_below(&self, partial: PartialId, below: &Below) -> TokenStream {
        if below.partials.is_empty() || self.plan.descent != Descent::Jumps {
            let free = below.partials.iter().map(|id| free(*id));
            return quote!(#(#free = false;)*);
        }
        let label = label(partial);
        quote!(break #label;)
    }
}

fn label(partial: PartialId) -> Lifetime {
    Lifetime::new(&format!("'below_{}", partial.index()), place::mixed())
}

/// The local that says that nothing above has decided about a partial grafcet in this evolution.
fn free(partial: PartialId) -> Ident {
    names::local(&format!("free_{}", partial.index()))
}
