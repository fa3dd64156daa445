//! The search of a chart that may go round for ever, where its situation is one step and each evolution follows from it: it
//! goes from step to step until nothing clears. Where the bound is reached, a step has come back, and the search is
//! known to go on without another try.

use proc_macro2::{Literal, TokenStream};
use syn::Lifetime;

use super::bind::Moment;
use super::{Cx, names};
use crate::place::{self, quote};
use crate::plan::{Form, Search};

/// With fewer steps the code is smaller where the inputs are found once for all evolutions.
const FEW: usize = 3;

impl Cx<'_> {
    /// Whether the region's enum is as wide as a register, which saves widening the state in every evolution. The field holds
    /// a byte all the same, and so does a table.
    pub(super) fn is_wide(&self) -> bool {
        self.plan.shape.walks() && (self.model.optimize_size || !self.plan.shape.is_long())
    }

    /// The search. The chart's own situation is without the mark as soon as the walk begins.
    pub(super) fn walk(&self) -> TokenStream {
        let (before, after, state) = (names::before(0, self.plan), names::after(0, self.plan), names::walked());
        let (first, mark) = (self.plain_state(0), self.mark(true));
        let limit = Literal::u32_suffixed(self.plan.max_evolutions);
        let label = label();
        let time = self.assume_settled();
        let combinational = self.all_combinational(Moment::Condition);
        let (evolve, stored, restart) = (self.one_match(), self.do_stored(), self.restart_times());
        let (unmark, commit) = (self.set_state(0, &quote!(#state)), self.set_state(0, &quote!(#after)));
        let (unsettle, delayed) = (self.unsettle(), self.unsettle_delays());
        let opaque = self.opaque_inputs();
        // Where a table leads from step to step, that costs some bytes and is faster.
        let for_all = self.model.steps.len() < FEW || self.plan.shape.is_long() && !self.model.optimize_size;
        let (once, each) = if for_all { (opaque, None) } else { (None, opaque) };
        let fence = self.plan.shape.breaks_out.then(|| self.fence());
        quote! {
            #time
            let mut #state = #first;
            #unmark
            #label: {
                #once
                for _ in 0..#limit {
                    #each
                    let #before = #state;
                    #combinational
                    #evolve
                    #stored
                    #state = #after;
                    #commit
                    #restart
                    #delayed
                }
                #mark
                #unsettle
            }
            #fence
        }
    }

    /// The label of the search, where `break` alone would leave something within it.
    pub(super) fn search_label(&self) -> Option<Lifetime> {
        (self.plan.shape.walks() || self.plan.shape.is_long() || self.plan.shape.evolves_once()).then(label)
    }

    /// The end of a search with the activation of a step that nothing can leave at once.
    pub(super) fn end_of_search(&self) -> Option<TokenStream> {
        let ends = &self.plan.search_ends;
        let known = self.plan.shape.form == Form::Sequence && self.plan.shape.search == Search::Ends;
        let some = known && !ends.steps().is_empty();
        some.then(|| {
            let (after, stop, p) = (names::after(0, self.plan), self.stop(), &self.p);
            let ends = ends.steps().iter().map(|step| self.variant(*step));
            quote!(if #p::core::matches!(#after, #(#ends)|*) { #stop; })
        })
    }

    /// `break`, out of the search.
    pub(super) fn stop(&self) -> TokenStream {
        let label = self.search_label();
        quote!(break #label)
    }
}

fn label() -> Lifetime {
    Lifetime::new("'search", place::mixed())
}
