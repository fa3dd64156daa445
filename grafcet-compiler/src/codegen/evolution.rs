//! One evolution: which transitions clear in the situation `before`, and the situation `after`.

use proc_macro2::TokenStream;
use quote::quote;

use super::bind::Moment;
use super::{Cx, names};
use crate::model::{Id, StepId, Transition, TransitionId, Tree};
use crate::plan::RegionId;

impl Cx<'_> {
    /// Statements that change the `after` of every region by the transitions that clear.
    pub(super) fn evolve(&self) -> TokenStream {
        let regions = (0..self.plan.regions.all().len()).map(|region| self.evolve_region(region));
        quote!(#(#regions)*)
    }

    /// The transitions out of the steps of one region.
    fn evolve_region(&self, region: RegionId) -> TokenStream {
        let before = names::before(region, self.plan);
        let steps = &self.plan.regions.all()[region].steps;
        let arms: Vec<_> = steps.iter().filter_map(|step| self.leave_step(*step)).collect();
        let start = self.has_start_variant(region).then(|| {
            let (start, initial, after) = (self.start(), self.initial(region), names::after(region, self.plan));
            quote!(#start => #after = #initial,)
        });
        if arms.is_empty() && start.is_none() {
            return TokenStream::new();
        }
        let covered = arms.len() + usize::from(start.is_some());
        let all = steps.len()
            + usize::from(self.plan.regions.all()[region].may_be_empty)
            + usize::from(self.has_start_variant(region));
        let rest = (covered < all).then(|| quote!(_ => {}));
        quote!(match #before { #(#arms)* #start #rest })
    }

    /// `Off => if … { … } else if … { … }`: in an `sfc` the order is the priority, in a `grafcet` the conditions exclude
    /// each other.
    fn leave_step(&self, step: StepId) -> Option<TokenStream> {
        let leaving: Vec<TransitionId> = self.plan.leaving[step.index()].clone();
        if leaving.is_empty() {
            return None;
        }
        let variant = self.variant(step);
        let mut chain = TokenStream::new();
        for (i, id) in leaving.iter().enumerate() {
            let transition = &self.model.transitions[*id];
            let clear = self.clear(transition);
            if transition.condition.tree == Tree::Bool(true) {
                // Always fireable: nothing behind it in the chain can clear.
                chain.extend(if i == 0 { clear } else { quote!({ #clear }) });
                return Some(quote!(#variant => { #chain }));
            }
            let condition = self.value(&transition.condition, Moment::Condition);
            chain.extend(quote!(if #condition { #clear }));
            if i + 1 < leaving.len() {
                chain.extend(quote!(else));
            }
        }
        Some(quote!(#variant => { #chain }))
    }

    /// The effect of clearing a transition on the situation.
    fn clear(&self, transition: &Transition) -> TokenStream {
        let mut tokens = TokenStream::new();
        for source in &transition.sources {
            let region = self.plan.regions.of_step(*source);
            if !transition.targets.iter().any(|target| self.plan.regions.of_step(*target) == region) {
                let (after, empty) = (names::after(region, self.plan), self.empty(region));
                tokens.extend(quote!(#after = #empty;));
            }
        }
        for target in &transition.targets {
            let region = self.plan.regions.of_step(*target);
            if transition.sources.contains(target) {
                if self.plan.sees_reentry[region] {
                    let again = names::again(region, self.plan);
                    tokens.extend(quote!(#again = true;));
                }
            } else {
                let (after, variant) = (names::after(region, self.plan), self.variant(*target));
                tokens.extend(quote!(#after = #variant;));
            }
        }
        tokens
    }
}
