//! What happens to times, edges and delays at the begin of a cycle and at the end of an evolution.

use proc_macro2::TokenStream;
use quote::quote;

use super::bind::Moment;
use super::{Cx, names};

impl Cx<'_> {
    /// The time since the cycle before, added to every time that is counted. The first cycle has none.
    pub(super) fn pass_time(&self) -> TokenStream {
        if !self.plan.memory.time {
            return TokenStream::new();
        }
        let p = &self.p;
        let first = self.first();
        let regions = self.timed_regions().map(|region| {
            let since = names::step_time(region, self.plan);
            quote!(self.#since = self.#since + elapsed;)
        });
        let macros = self.plan.memory.macro_times.iter().map(|id| {
            let since = names::macro_time(*id);
            quote!(self.#since = self.#since + elapsed;)
        });
        quote! {
            let elapsed = if #first { #p::Ticks::ZERO } else { now.since(self.now) };
            self.now = now;
            #(#regions)* #(#macros)*
        }
    }

    /// Regions whose active step's time is counted.
    pub(super) fn timed_regions(&self) -> impl Iterator<Item = usize> + '_ {
        self.plan.memory.step_times.iter().enumerate().filter(|(_, timed)| **timed).map(|(region, _)| region)
    }

    /// A step that has been entered begins its time; one that stays (A4g) goes on.
    pub(super) fn restart_times(&self) -> TokenStream {
        let p = &self.p;
        let regions = self.timed_regions().map(|region| {
            let (before, after) = (names::before(region, self.plan), names::after(region, self.plan));
            let (since, again) = (names::step_time(region, self.plan), self.or_again(region));
            quote!(if #after != #before #again { self.#since = #p::Ticks::ZERO; })
        });
        let macros = self.plan.memory.macro_times.iter().map(|id| {
            let since = names::macro_time(*id);
            let (was, is) = (self.macro_active(*id, Moment::Condition), self.macro_active(*id, Moment::Stable));
            quote!(if #is && !#was { self.#since = #p::Ticks::ZERO; })
        });
        quote!(#(#regions)* #(#macros)*)
    }

    /// The time the active steps had reached, for the actions on leaving them (A34).
    pub(super) fn keep_times(&self) -> TokenStream {
        let regions = self.timed_regions().map(|region| {
            let (reached, since) = (names::step_time_before(region, self.plan), names::step_time(region, self.plan));
            quote!(let #reached = self.#since;)
        });
        quote!(#(#regions)*)
    }

    /// The general delays, sampled once per cycle on the situation it starts from (A36).
    pub(super) fn sample_delays(&self) -> TokenStream {
        let delays = self.model.delays.iter().map(|(id, delay)| {
            let (field, value) = (names::delay_field(id), self.value(&delay.of, Moment::Sample));
            let (on, off) = (self.time(delay.on), self.time(delay.off));
            quote! {
                let input = #value;
                self.#field.update(input, #on, #off, elapsed);
            }
        });
        quote!(#(#delays)*)
    }

    /// The edges of this evolution: `none` says that there are none (A26).
    pub(super) fn sample_edges(&self, none: &TokenStream) -> TokenStream {
        let p = &self.p;
        let edges = self.plan.memory.edges.iter().map(|(id, rising, falling)| {
            let (field, value) = (names::edge_field(*id), self.value(&self.model.edges[*id].of, Moment::Sample));
            let one = |used: bool, is_rising: bool| {
                used.then(|| {
                    let local = names::edge_local(*id, is_rising);
                    let edge = if is_rising { quote!(value && !self.#field) } else { quote!(!value && self.#field) };
                    quote!(#local = #edge && !#none;)
                })
            };
            let (rising, falling) = (one(*rising, true), one(*falling, false));
            quote!(let value: #p::bool = #value; #rising #falling self.#field = value;)
        });
        quote!(#(#edges)*)
    }

    /// The locals that hold the edges.
    pub(super) fn declare_edges(&self) -> TokenStream {
        let edges = self.plan.memory.edges.iter().flat_map(|(id, rising, falling)| {
            let rising = rising.then(|| names::edge_local(*id, true));
            rising.into_iter().chain(falling.then(|| names::edge_local(*id, false)))
        });
        edges.map(|local| quote!(let mut #local = false;)).collect()
    }

    /// Keeps what edges compare with, and puts it back: an evolution that does not take place consumes no edge.
    pub(super) fn keep_edges(&self) -> (TokenStream, TokenStream) {
        let kept = self.plan.memory.edges.iter().map(|(id, ..)| (names::edge_field(*id), names::edge_kept(*id)));
        let (mut keep, mut put_back) = (TokenStream::new(), TokenStream::new());
        for (field, local) in kept {
            keep.extend(quote!(let #local = self.#field;));
            put_back.extend(quote!(self.#field = #local;));
        }
        (keep, put_back)
    }

    /// Whether the first cycle is under way.
    pub(super) fn first(&self) -> TokenStream {
        if !self.plan.has_start {
            return quote!(false);
        }
        let (field, start) = (names::region_field(0, self.plan), self.start());
        quote!((self.#field == #start))
    }
}
