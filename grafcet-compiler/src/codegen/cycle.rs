//! The function `cycle` of each dialect.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Cx, names};
use crate::model::Dialect;

impl Cx<'_> {
    /// The body of `cycle`.
    pub(super) fn cycle_body(&self) -> TokenStream {
        match self.model.dialect {
            Dialect::Sfc => self.sfc_cycle(),
            Dialect::Grafcet => self.grafcet_cycle(),
        }
    }

    /// IEC 61131-3: exactly one evolution, then the actions.
    fn sfc_cycle(&self) -> TokenStream {
        let snapshot = self.snapshot();
        let evolve = self.evolve();
        let commit = self.commit();
        let actions = self.sfc_actions();
        let outputs = self.result();
        quote!(#snapshot #evolve #commit #actions #outputs)
    }

    /// IEC 60848: evolutions until the situation is stable, then the continuous outputs.
    fn grafcet_cycle(&self) -> TokenStream {
        let snapshot = self.snapshot();
        let evolve = self.evolve();
        let commit = self.commit();
        let stored = self.stored_actions();
        let unchanged = self.unchanged();
        let (declare, count) = self.bound();
        let activation = self.activation();
        let continuous = self.continuous_actions();
        let outputs = self.result();
        quote! {
            #activation
            #declare
            loop {
                #snapshot
                #evolve
                if #unchanged { break; }
                #count
                #commit
                #stored
            }
            #continuous
            #outputs
        }
    }

    /// The situation before the evolution, and the one after it as far as nothing clears.
    fn snapshot(&self) -> TokenStream {
        let regions = (0..self.plan.regions.all().len()).map(|region| {
            let (before, after) = (names::before(region, self.plan), names::after(region, self.plan));
            let field = names::region_field(region, self.plan);
            let again = self.plan.sees_reentry[region].then(|| {
                let again = names::again(region, self.plan);
                quote!(let mut #again = false;)
            });
            quote!(let #before = self.#field; let mut #after = #before; #again)
        });
        quote!(#(#regions)*)
    }

    fn commit(&self) -> TokenStream {
        let regions = (0..self.plan.regions.all().len()).map(|region| {
            let (field, after) = (names::region_field(region, self.plan), names::after(region, self.plan));
            quote!(self.#field = #after;)
        });
        quote!(#(#regions)*)
    }

    /// A25: the situation is a fixed point.
    fn unchanged(&self) -> TokenStream {
        let same = (0..self.plan.regions.all().len()).map(|region| {
            let (before, after) = (names::before(region, self.plan), names::after(region, self.plan));
            quote!(#after == #before)
        });
        quote!(#(#same)&&*)
    }

    /// A30: the end of a search that does not become stable.
    fn bound(&self) -> (TokenStream, TokenStream) {
        if !self.plan.may_be_unstable {
            return (TokenStream::new(), TokenStream::new());
        }
        let limit = Literal::u32_unsuffixed(self.plan.max_evolutions);
        let (left, p) = (names::local("evolutions_left"), &self.p);
        let declare = quote! {
            let mut #left: #p::u32 = #limit;
            self.stable = true;
        };
        let count = quote! {
            if #left == 0 {
                self.stable = false;
                break;
            }
            #left -= 1;
        };
        (declare, count)
    }

    /// A37: the activation of the initial situation is an evolution of its own.
    fn activation(&self) -> TokenStream {
        if !self.plan.has_start {
            return TokenStream::new();
        }
        let (field, start, initial) = (names::region_field(0, self.plan), self.start(), self.initial(0));
        let stored = self.initial_stored_actions();
        quote! {
            if self.#field == #start {
                self.#field = #initial;
                #stored
            }
        }
    }
}
