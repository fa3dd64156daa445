//! `cycle` of a `grafcet` (IEC 60848): evolutions until the situation is stable, then the continuous actions.

use proc_macro2::{Literal, TokenStream};

use super::bind::Moment;
use super::in_order::Item;
use super::{Cx, names};
use crate::analysis::combinational;
use crate::list::List;
use crate::model::{ActionId, Association, Effect, Place, VarId};
use crate::place::quote;
use crate::plan::{Search, source_order};

impl Cx<'_> {
    /// The body of `cycle`.
    pub(super) fn grafcet_cycle(&self) -> TokenStream {
        let time = self.pass_time();
        let start = self.start_cycle();
        let search = self.search();
        let left = self.left_by_start();
        let (continuous, calls, result) = (self.continuous(), self.continuous_calls(), self.result());
        let stable = self.stable_situation();
        let outputs = self.declare_outputs();
        let forget = self.forget_instability();
        // The outputs come first: after the search, the compiler would clear them again in every arm.
        quote!(#outputs #forget #time #start #search #left #stable #continuous #calls #result)
    }

    /// A37: the activation of the initial situation is an evolution of its own. Delays are sampled on the initial situation
    /// with the values from before its actions (A36).
    pub(super) fn start_cycle(&self) -> TokenStream {
        let delays = self.sample_on_start();
        if !self.plan.has_start {
            return delays;
        }
        let (first, enter) = (self.first(), self.enter_initial());
        let stored = self.initial_stored();
        let mutable = self.samples_in_search().then(|| quote!(mut));
        let first_evolution =
            self.plan.memory.asks_for_start().then(|| quote!(let #mutable first_evolution_ = #first;));
        if delays.is_empty() || stored.is_empty() {
            return quote!(#first_evolution if #first { #enter #stored } #delays);
        }
        quote! {
            #first_evolution
            let first_ = #first;
            if first_ {
                #enter
            }
            #delays
            if first_ { #stored }
        }
    }

    /// The actions of the initial situation may have changed what a delay looks at: the next cycle samples it.
    fn left_by_start(&self) -> Option<TokenStream> {
        let acts = self.plan.has_start && !self.model.delays.is_empty() && !self.initial_stored().is_empty();
        let unsettle = acts.then(|| self.unsettle()).flatten()?;
        Some(quote!(if first_ { #unsettle }))
    }

    /// The delays, on the situation the cycle starts from.
    fn sample_on_start(&self) -> TokenStream {
        if self.model.delays.is_empty() {
            return TokenStream::new();
        }
        let (snapshot, samples) = (self.befores(), self.sample_delays(&quote!(first_evolution_)));
        quote!({ #snapshot #samples })
    }

    /// The search for stability.
    fn search(&self) -> TokenStream {
        let combinational = self.all_combinational(Moment::Condition);
        let (declare_bound, bound) = self.bound();
        let (declare_edges, still) = (self.declare_edges(), self.sample_edges(true, &quote!(first_evolution_)));
        let (edges, forget) = (self.sample_edges(false, &quote!(first_evolution_)), self.forget_edges());
        let keep_edges = self.plan.may_be_unstable.then(|| self.keep_edges().0);
        let first_evolution = self.plan.memory.asks_for_start() && self.samples_in_search();
        let first_evolution = first_evolution.then(|| quote!(first_evolution_ = false;));
        let (stored, commit_collected) = (self.do_stored(), self.commit_collected());
        let (commit, restart) = (self.commit(), self.restart_times());
        let evolve = self.evolve_or_stop();
        let time = self.assume_settled();
        let opaque = self.opaque_inputs();
        // In place, an evolution reads each state where it uses it: held in registers, the states would be moved from one to
        // another on every way.
        let (once, each) = if self.plan.shape.is_in_place() { (opaque, Some(self.fence())) } else { (None, opaque) };
        // An edge is gone in the next cycle.
        let gone = self.edge_names();
        let gone = (!gone.is_empty()).then(|| self.unsettle_if(&quote!(#(#gone)||*)));
        let unsettle = self.unsettle_delays();
        let snapshot = self.snapshot();
        quote! {
            #declare_bound
            #declare_edges
            #still
            #time
            #once
            loop {
                #each #snapshot
                #combinational #keep_edges #edges #first_evolution
                #evolve
                #bound
                #stored #commit_collected #commit #restart #unsettle #forget
            }
            #gone
        }
    }

    /// Inputs do not change during the search, and LLVM would read all of them in front of the loop, also those that no
    /// active step asks for.
    pub(super) fn opaque_inputs(&self) -> Option<TokenStream> {
        let p = &self.p;
        let reads = !self.model.inputs.is_empty();
        reads.then(|| quote!(let inputs_ = #p::core::hint::black_box(inputs_);))
    }

    /// A delay is sampled once per cycle: the next one sees the new situation.
    pub(super) fn unsettle_delays(&self) -> Option<TokenStream> {
        (!self.model.delays.is_empty()).then(|| self.unsettle()).flatten()
    }

    /// No instruction: it keeps LLVM from copying the actions of the steps into the evolution before, or from holding the
    /// states of all regions in registers.
    pub(super) fn fence(&self) -> TokenStream {
        let p = &self.p;
        let atomic = quote!(#p::core::sync::atomic);
        quote!(#atomic::compiler_fence(#atomic::Ordering::SeqCst);)
    }

    /// One evolution, or the end of the search where nothing changes.
    fn evolve_or_stop(&self) -> TokenStream {
        let (declare, collect) = (self.declare_collected(), self.collect_stored());
        let unchanged = self.unchanged();
        if !self.plan.shape.is_in_place() {
            let (moved, evolve) = (self.declare_moved(), self.evolve());
            return quote!(#declare #moved #evolve #collect if #unchanged { break; });
        }
        let afters = self.afters();
        let (moved, evolve) = (self.declare_moved(), self.evolve());
        quote!(#declare #moved #evolve #afters #collect if #unchanged { break; })
    }

    /// A25: the situation is a fixed point, and nothing else is to be done.
    fn unchanged(&self) -> TokenStream {
        let same = if self.plan.shape.notes_moves { vec![quote!(!moved_)] } else { self.is_same() };
        let terms: Vec<_> = same.into_iter().and(self.collected_unchanged()).list();
        if terms.is_empty() { quote!(true) } else { quote!(#(#terms)&&*) }
    }

    /// A30: the end of a search that does not become stable.
    fn bound(&self) -> (TokenStream, TokenStream) {
        if self.plan.shape.search != Search::Bounded {
            return Default::default();
        }
        let (limit, p) = (Literal::u32_unsuffixed(self.plan.max_evolutions), &self.p);
        let declare = quote! {
            let mut evolutions_left_: #p::u32 = #limit;
        };
        let put_back = self.keep_edges().1;
        let (mark, unsettle) = (self.mark(true), self.unsettle());
        let bound = quote! {
            if evolutions_left_ == 0 {
                #put_back
                #mark
                #unsettle
                break;
            }
            evolutions_left_ -= 1;
        };
        (declare, bound)
    }

    /// The mark of an unstable search is taken away at the begin of the next cycle.
    pub(super) fn forget_instability(&self) -> Option<TokenStream> {
        self.is_marked(0).then(|| self.mark(false))
    }

    /// The situation the search has reached, for the continuous actions.
    pub(super) fn stable_situation(&self) -> TokenStream {
        let continuous = self.model.associations.values().any(|a| !crate::plan::is_stored(a));
        if !continuous {
            return TokenStream::new();
        }
        let states = (0..self.plan.regions.all().len()).map(|region| {
            let (after, state) = (names::after(region, self.plan), self.plain_state(region));
            quote!(let #after = #state;)
        });
        let combinational = self.all_combinational(Moment::Stable);
        if self.plan.shape.is_in_place() {
            let fence = self.fence();
            let states = self.afters();
            return quote!(#fence #states #combinational);
        }
        if self.plan.shape.is_flags() {
            let after = names::after(0, self.plan);
            return quote!(let #after = self.situation; #combinational);
        }
        quote!(#(#states)* #combinational)
    }

    /// Variables that follow from the situation (A22), each after those it reads.
    pub(super) fn all_combinational(&self, moment: Moment) -> TokenStream {
        self.plan.memory.combinational.iter().map(|var| self.combinational(*var, moment)).tokens()
    }

    /// A variable that follows from the situation.
    pub(super) fn combinational(&self, var: VarId, moment: Moment) -> TokenStream {
        let local = names::combinational(self.model, var);
        let terms = combinational::asserted(self.model, var).map(|association| {
            let active = self.is_active(association.step, moment);
            let condition = self.continuous_condition(association, moment).map(|condition| quote!(&& #condition));
            quote!((#active #condition))
        });
        quote!(let #local = #(#terms)||*;)
    }

    /// The continuous outputs, on the stable situation (A9, A10).
    pub(super) fn continuous(&self) -> TokenStream {
        let items = source_order(self.model).map(|id| {
            let association = &self.model.associations[id];
            let act = match &association.effect {
                Effect::Control(Place::Output(output)) if !crate::plan::is_stored(association) => {
                    let local = names::output_local(self.model, *output);
                    quote!(#local = true;)
                }
                Effect::Assign(Place::Output(output), value) if !crate::plan::is_stored(association) => {
                    let (local, value) = (names::output_local(self.model, *output), self.value(value, Moment::Stable));
                    quote!(#local = #value;)
                }
                _ => TokenStream::new(),
            };
            if act.is_empty() {
                return Item::After(association.step, act);
            }
            match (self.continuous_condition(association, Moment::Stable), &association.effect) {
                (Some(condition), _) => Item::After(association.step, quote!(if #condition { #act })),
                (None, Effect::Control(Place::Output(output))) => {
                    let local = names::output_local(self.model, *output);
                    Item::After(association.step, quote!(#local = true;))
                }
                (None, _) => Item::After(association.step, act),
            }
        });
        if self.assigns_across_regions() {
            return self.in_order(items);
        }
        self.in_any_order(items)
    }

    /// Whether steps of several regions give an output its value, of which the last one in the source counts.
    fn assigns_across_regions(&self) -> bool {
        let continuous = || self.model.associations.values().filter(|association| !crate::plan::is_stored(association));
        let mut assigned = continuous().filter_map(|association| match &association.effect {
            Effect::Assign(place, _) => Some((*place, self.plan.regions.of_step(association.step))),
            _ => None,
        });
        let writes = |association: &Association, place| association.effect.writes().contains(&place);
        assigned.any(|(place, region)| {
            continuous().any(|other| writes(other, place) && self.plan.regions.of_step(other.step) != region)
        })
    }

    /// `N heat(80)`: called once per cycle, after all others, and told its phase (A33).
    pub(super) fn continuous_calls(&self) -> TokenStream {
        let mut actions: Vec<ActionId> = Vec::new();
        for association in source_order(self.model).map(|id| &self.model.associations[id]) {
            if let (Effect::Call(action, _), false) = (&association.effect, crate::plan::is_stored(association)) {
                if !actions.contains(action) {
                    actions.push(*action);
                }
            }
        }
        actions.into_iter().map(|action| self.continuous_call(action)).tokens()
    }

    fn continuous_call(&self, action: ActionId) -> TokenStream {
        let associations = self.continuous_calls_of(action);
        if associations.is_empty() {
            return TokenStream::new();
        }
        let (called, number) = (names::called(self.model, action), names::called_number(self.model, action));
        let choice = self.remembers_call(action);
        let gathered = self.in_order(associations.iter().enumerate().map(|(i, association)| {
            let index = Literal::usize_unsuffixed(i);
            let note = choice.then(|| quote!(self.#number = #index;));
            let set = quote!(active_ = true; #note);
            Item::After(
                association.step,
                match self.continuous_condition(association, Moment::Stable) {
                    Some(condition) => quote!(if #condition { #set }),
                    None => set,
                },
            )
        }));
        let call = |phase: &TokenStream| {
            let one = |association: &Association| self.effect_run(&association.effect, phase, Moment::Stable);
            match associations.split_last() {
                Some((last, others)) if choice => {
                    let arms = others.iter().enumerate().map(|(i, association)| {
                        let (index, call) = (Literal::usize_unsuffixed(i), one(association));
                        quote!(#index => { #call })
                    });
                    let last = one(last);
                    quote!(match self.#number { #(#arms)* _ => { #last } })
                }
                Some((last, _)) => one(last),
                None => TokenStream::new(),
            }
        };
        let (first, repeated, last) = (call(&quote!(First)), call(&quote!(Repeated)), call(&quote!(Final)));
        let unsettle = self.unsettle();
        quote! {
            {
                let mut active_ = false;
                #gathered
                if active_ {
                    #unsettle
                    if self.#called { #repeated } else { #first }
                } else if self.#called {
                    #last
                }
                self.#called = active_;
            }
        }
    }

    /// The associations that call an action continuously.
    pub(super) fn continuous_calls_of(&self, action: ActionId) -> Vec<&Association> {
        let calls = |association: &&Association| {
            !crate::plan::is_stored(association)
                && matches!(association.effect, Effect::Call(other, _) if other == action)
        };
        source_order(self.model).map(|id| &self.model.associations[id]).filter(calls).list()
    }

    /// Several associations give arguments, so the last active one is remembered.
    pub(super) fn remembers_call(&self, action: ActionId) -> bool {
        self.continuous_calls_of(action).len() > 1 && !self.model.actions[action].params.is_empty()
    }
}
