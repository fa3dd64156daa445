//! The search of a chart that may go round for ever, where its situation is one step and each evolution follows from it: it
//! goes from step to step until nothing clears. Where the bound is reached, a step has come back, and the search is
//! known to go on without another try.

use proc_macro2::{Literal, Span, TokenStream};
use quote::quote;
use syn::Lifetime;

use super::bind::Moment;
use super::{Cx, names};

/// From how many steps on the code is smaller where the inputs are found anew in each evolution.
const LONG: usize = 3;

impl Cx<'_> {
    /// Whether the search is such a walk. What edges compare with would change in an evolution too; a sequence whose next
    /// step is computed is smaller in the search with a trial.
    pub(super) fn walks(&self) -> bool {
        self.model.is_grafcet()
            && self.plan.may_be_unstable
            && self.plan.comes_back
            && self.plan.memory.edges.is_empty()
            && self.is_one_match()
            && !self.is_small_sequence()
    }

    /// Whether the region's enum is as wide as a register, which saves widening the state in every evolution. The field holds
    /// a byte all the same.
    pub(super) fn is_wide(&self) -> bool {
        self.walks() && !self.is_sequence()
    }

    /// The search.
    pub(super) fn walk(&self) -> TokenStream {
        let (before, after) = (names::before(0, self.plan), names::after(0, self.plan));
        let (state, mark) = (self.plain_state(0), self.mark(true));
        let limit = Literal::u32_suffixed(self.plan.max_evolutions);
        let label = label();
        let time = self.plan.memory.time.then(|| quote!(self.settled = true;));
        let combinational = self.all_combinational(Moment::Condition);
        let (evolve, stored, restart) = (self.one_match(), self.do_stored(), self.restart_times());
        let commit = self.set_state(0, &quote!(#after));
        let (unsettle, delayed) = (self.unsettle(), self.unsettle_delays());
        let opaque = self.opaque_inputs();
        let few = self.model.steps.len() < LONG;
        let (once, each) = if few { (opaque, None) } else { (None, opaque) };
        let fence = self.breaks_out().then(|| self.fence());
        quote! {
            #time
            #label: {
                let mut state = #state;
                #once
                for _ in 0..#limit {
                    #each
                    let #before = state;
                    #combinational
                    #evolve
                    #stored
                    state = #after;
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

    /// `break`, out of the search.
    pub(super) fn stop(&self) -> TokenStream {
        let label = self.walks().then(label);
        quote!(break #label)
    }
}

fn label() -> Lifetime {
    Lifetime::new("'search", Span::mixed_site())
}
