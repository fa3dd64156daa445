//! `force`: a cycle that leads into a given situation (A38), of a chart that says `forceable;`.
//!
//! Its evolution is given and not searched for; all else is that of an ordinary cycle: of a program its second one, else what the plan's twin says
//! (`Plan::forced`), which keeps the situation before and the one after beside each other.

use proc_macro2::{Literal, TokenStream};

use super::bind::Moment;
use super::machine::Machine;
use super::names::Names;
use super::state::StateEnum;
use super::{Cx, names, requirements, state};
use crate::analysis::{Facts, Situations};
use crate::list::List;
use crate::model::{Id, StepId};
use crate::place::quote;
use crate::plan::RegionId;

/// The method and the trait, where the chart asks for them.
pub(super) fn all(cx: &Cx<'_>, facts: &Facts<'_>, machine: &Machine<'_>) -> Option<TokenStream> {
    let body = machine.forced.as_ref()?;
    let situations = if cx.is_alone() { Situations::Alone } else { Situations::of(cx.model, facts) };
    Some(cx.force(&possible(&situations, &cx.p), &cx.forced_situation(machine), body))
}

/// `Possible::Pairs(b"…")`
pub(super) fn possible(situations: &Situations, p: &TokenStream) -> TokenStream {
    let rows = |rows: &[u8]| Literal::byte_string(rows);
    match situations {
        Situations::Unknown => quote!(#p::Possible::Unknown),
        Situations::Alone => quote!(#p::Possible::Alone),
        Situations::Listed(table) => {
            let rows = rows(table);
            quote!(#p::Possible::Listed(#rows))
        }
        Situations::Diagram(table) => {
            let rows = rows(table);
            quote!(#p::Possible::Diagram(#rows))
        }
        Situations::Pairs(table) => {
            let rows = rows(table);
            quote!(#p::Possible::Pairs(#rows))
        }
        Situations::Parts(pairs, parts) => {
            let (pairs, parts) = (rows(pairs), rows(parts));
            quote!(#p::Possible::Parts(#pairs, #parts))
        }
        Situations::Whole(table) => {
            let rows = rows(table);
            quote!(#p::Possible::Whole(#rows))
        }
    }
}

impl Cx<'_> {
    /// What the plan's twin does, where the chart is not made from a program.
    pub(super) fn forced_body(&self) -> Option<TokenStream> {
        let plan = self.plan.forced.as_deref()?;
        let twin = Cx { model: self.model, plan, names: Names::of(self.model), p: self.p.clone() };
        Some(if twin.model.is_grafcet() { twin.by_search() } else { twin.by_scan() })
    }

    fn force(&self, possible: &TokenStream, ask: &TokenStream, body: &TokenStream) -> TokenStream {
        let Cx { model, p, names, .. } = self;
        let (vis, chart, step) = (&model.vis, &names.chart, &names.step);
        let (inputs, outputs) = (&names.inputs, &names.outputs);
        let (copied, levels) = (requirements::copied(model, p), super::types::levels(model));
        let unreached = super::unreached::allowed(model);
        let time = self.plan.memory.time;
        let given = [("steps", quote!(&[#step])), ("inputs", quote!(&#inputs))];
        let given = given.iter().map(|(name, ty)| names::parameter(name, ty)).list();
        let now = time.then(|| names::parameter("now", &quote!(impl #p::core::convert::Into<#p::Ticks>)));
        let now = now.map(|now| quote!(, #now));
        let ticks = time.then(|| quote!(let now_: #p::Ticks = #p::core::convert::Into::into(now_);));
        let (calls, has_actions) = (&names.actions, !model.actions.is_empty());
        let actions = names::parameter("actions", &quote!(&mut (impl #calls + ?#p::core::marker::Sized)));
        let actions = has_actions.then(|| quote!(, #actions));
        let (pass_now, now_name) = if time { (Some(quote!(, now_)), quote!(now_)) } else { (None, quote!(_)) };
        let (pass, actions_name) =
            if has_actions { (Some(quote!(, actions_)), quote!(actions_)) } else { (None, quote!(_)) };
        quote! {
            #levels
            #unreached
            impl #chart {
                /// One cycle that leads into a situation by hand, whatever the transition conditions say (decision A38): no transition clears, steps that
                /// are not named are left, named ones entered, each with its actions, and nothing of the steps in between runs.
                ///
                /// For commissioning: nothing that the compiler has proved of the chart's ways holds on this one.
                ///
                /// # Errors
                /// The chart is never in exactly these steps; then nothing has happened.
                #[allow(unused_assignments, unused_mut, unused_variables)]
                #vis fn force(&mut self, #(#given),* #now #actions) -> #p::Result<#outputs, #p::ForceError<#step>> {
                    #possible.look(<Self as #p::Chart>::STEPS, steps_)?;
                    #copied
                    #ticks
                    #ask
                    #p::Result::Ok({ #body })
                }
            }

            impl #p::Forceable for #chart {
                fn force(
                    &mut self,
                    steps_: &[#step],
                    inputs_: &#inputs,
                    #now_name: #p::Ticks,
                    #actions_name: &mut Self::Actions<'_>,
                ) -> #p::Result<#outputs, #p::ForceError<#step>> {
                    self.force(steps_, inputs_ #pass_now #pass)
                }
            }
        }
    }

    /// The situation that is asked for, as the states of the regions.
    fn forced_situation(&self, machine: &Machine<'_>) -> TokenStream {
        let forced = names::local("forced");
        if self.plan.shape.is_flags() {
            let bytes = Literal::usize_suffixed(self.flag_bytes());
            let arms = self.model.steps.ids().map(|id| {
                let (name, (byte, mask)) = (state::step_name(self, id), super::situation::place(id.index()));
                quote!(#name => #forced[#byte] |= #mask,)
            });
            let arms = arms.tokens();
            return quote!(let mut #forced = [0; #bytes]; for step_ in steps_ { match *step_ { #arms } });
        }
        let (p, regions) = (&self.p, 0..self.plan.regions.all().len());
        let declare = regions.clone().map(|region| {
            let (name, ty) = (asked(region), self.names.region(region, self.plan));
            quote!(let mut #name: #p::Option<#ty> = #p::Option::None;)
        });
        let arm = |id: StepId| {
            let (name, variant) = (state::step_name(self, id), self.variant(id));
            let region = asked(self.plan.regions.of_step(id));
            quote!(#name => #region = #p::Option::Some(#variant),)
        };
        let arms = self.model.steps.ids().map(arm).tokens();
        let states = regions.map(|region| {
            let name = asked(region);
            let is_empty = |states: &StateEnum| states.region == region && states.empty;
            let none = if machine.regions.iter().any(is_empty) {
                self.empty(region)
            } else {
                quote!(return #p::Result::Err(#p::ForceError::NoSituation))
            };
            quote! {
                let #name = match #name {
                    #p::Option::Some(state_) => state_,
                    #p::Option::None => #none,
                };
            }
        });
        quote!(#(#declare)* for step_ in steps_ { match *step_ { #arms } } #(#states)*)
    }

    /// The situation before, and the one that is asked for as that after it.
    fn forced_snapshot(&self) -> TokenStream {
        let befores = self.befores();
        let again = (0..self.plan.regions.all().len()).filter(|region| self.plan.sees_reentry[*region]);
        let again = again.map(|region| names::again(region, self.plan)).list();
        let afters = if self.plan.shape.is_flags() {
            let (after, forced) = (names::after(0, self.plan), names::local("forced"));
            quote!(let #after = #forced;)
        } else {
            let after = |region| {
                let (after, forced) = (names::after(region, self.plan), asked(region));
                quote!(let #after = #forced;)
            };
            (0..self.plan.regions.all().len()).map(after).tokens()
        };
        quote!(#befores #afters #(let #again = false;)*)
    }

    /// An `sfc`: the scan of any other cycle, but for its evolution.
    fn by_scan(&self) -> TokenStream {
        let (outputs, time) = (self.declare_outputs(), self.pass_time());
        let first = self.plan.memory.asks_for_start().then(|| {
            let first = self.first();
            quote!(let first_ = #first;)
        });
        let (declare_edges, samples) = (self.declare_edges(), self.sample_all(&quote!(first_)));
        let (snapshot, keep, commit) = (self.forced_snapshot(), self.keep_times(), self.commit());
        let (settle, acts, unsettle) = (self.settle(), self.scan_actions(), self.unsettle());
        let result = self.result();
        quote! {
            #outputs #time #first #snapshot #declare_edges #samples #keep #commit #settle #acts #unsettle #result
        }
    }

    /// A `grafcet`: one evolution, and a look at where it has led; the edges of that are still to be seen.
    fn by_search(&self) -> TokenStream {
        let (outputs, forget, time) = (self.declare_outputs(), self.forget_instability(), self.pass_time());
        let (start, left) = (self.start_cycle(), self.unsettle());
        let (declare_edges, still) = (self.declare_edges(), self.sample_edges(true, &quote!(first_evolution_)));
        let (combinational, edges) =
            (self.all_combinational(Moment::Condition), self.sample_edges(false, &quote!(first_evolution_)));
        let first_evolution =
            (self.plan.memory.asks_for_start() && self.samples_in_search()).then(|| quote!(first_evolution_ = false;));
        let (declare, collect) = (self.declare_collected(), self.collect_stored());
        let (stored, take_over) = (self.do_stored(), self.commit_collected());
        let (commit, restart, gone) = (self.commit(), self.restart_times(), self.forget_edges());
        let (evolve, look) = (self.forced_snapshot(), self.befores());
        let (keep, put_back) = self.keep_edges();
        let (continuous, calls, result) = (self.continuous(), self.continuous_calls(), self.result());
        let stable = self.stable_situation();
        quote! {
            #outputs #forget #time #start
            #declare_edges #still
            {
                #evolve #combinational #edges #first_evolution
                #declare #collect #stored #take_over #commit #restart #gone
            }
            #keep
            { #look #combinational #edges }
            #put_back
            #stable #continuous #calls #left #result
        }
    }
}

/// The state of a region that is asked for.
pub(super) fn asked(region: RegionId) -> proc_macro2::Ident {
    names::local(&format!("forced{region}"))
}
