//! What the cycles of both dialects share: the situation before and after an evolution, and calls of actions.

use proc_macro2::TokenStream;

use super::bind::Moment;
use super::situation::At;
use super::{Cx, names};
use crate::list::List;
use crate::model::{ActionId, Dialect, Expr};
use crate::place::quote;
use crate::plan::RegionId;

impl Cx<'_> {
    /// The body of `cycle`.
    pub(super) fn cycle_body(&self) -> TokenStream {
        match self.model.dialect {
            Dialect::Sfc => self.sfc_cycle(),
            Dialect::Grafcet => self.grafcet_cycle(),
        }
    }

    /// The situation before the evolution.
    pub(super) fn befores(&self) -> TokenStream {
        if self.plan.shape.is_flags() {
            let before = names::before(0, self.plan);
            return quote!(let #before = self.situation;);
        }
        (0..self.plan.regions.all().len()).map(|region| self.before(region)).tokens()
    }

    /// The state of a region before the evolution.
    pub(super) fn before(&self, region: RegionId) -> TokenStream {
        let (before, state) = (names::before(region, self.plan), self.plain_state(region));
        // In place, most of an evolution looks at the chart's own situation.
        let unused = self.plan.shape.is_in_place().then(|| quote!(#[allow(unused_variables)]));
        if self.enters_first(region) {
            let (starting, empty) = (self.is_starting(At::Before), self.empty(region));
            return quote!(#unused let #before = if #starting { #empty } else { #state };);
        }
        quote!(#unused let #before = #state;)
    }

    /// A region after the first one whose initial step is entered in the first cycle of an `sfc`.
    fn enters_first(&self, region: RegionId) -> bool {
        !self.model.is_grafcet() && region > 0 && self.plan.regions.all()[region].initial.is_some()
    }

    /// The situation before the evolution, and the one after it as far as nothing clears. Where the evolution happens in
    /// place, the one after is the chart's own.
    pub(super) fn snapshot(&self) -> TokenStream {
        let in_place = self.plan.shape.is_in_place();
        let befores = self.befores();
        let afters = (0..self.plan.regions.all().len()).map(|region| {
            let (before, after) = (names::before(region, self.plan), names::after(region, self.plan));
            let own = !in_place && !self.plan.shape.is_flags();
            let declare = own.then(|| quote!(let mut #after = #before;));
            let again = self.plan.sees_reentry[region].then(|| {
                let again = names::again(region, self.plan);
                quote!(let mut #again = false;)
            });
            quote!(#declare #again)
        });
        let flags = self.plan.shape.is_flags().then(|| {
            let (before, after) = (names::before(0, self.plan), names::after(0, self.plan));
            quote!(let mut #after = #before;)
        });
        quote!(#befores #flags #(#afters)*)
    }

    /// The situation after the evolution becomes the chart's, where it is not already.
    pub(super) fn commit(&self) -> TokenStream {
        if self.plan.shape.is_in_place() {
            return TokenStream::new();
        }
        if self.plan.shape.is_flags() {
            let after = names::after(0, self.plan);
            return quote!(self.situation = #after;);
        }
        let regions = (0..self.plan.regions.all().len()).map(|region| {
            let after = names::after(region, self.plan);
            self.set_state(region, &quote!(#after))
        });
        quote!(#(#regions)*)
    }

    /// A call of a code action.
    pub(super) fn call(&self, action: ActionId, phase: &TokenStream, args: &[Expr], moment: Moment) -> TokenStream {
        let (name, p) = (&self.model.actions[action].name, &self.p);
        let args = args.iter().map(|arg| self.value(arg, moment));
        quote!(actions_.#name(#p::Phase::#phase, #(#args),*);)
    }
}
