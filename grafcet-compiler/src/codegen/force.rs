//! `force`: a cycle that leads into a given situation (A38), of a chart that says `forceable;`.
//!
//! Its evolution is given and not searched for; all else is that of an ordinary cycle: it is the program's second one.

use proc_macro2::{Literal, TokenStream};

use super::machine::Machine;
use super::state::StateEnum;
use super::{Cx, names, requirements, state};
use crate::analysis::Situations;
use crate::list::List;
use crate::model::StepId;
use crate::place::quote;
use crate::program::RegionId;

/// The method and the trait, where the chart asks for them.
pub(super) fn all<'f>(
    cx: &Cx<'_>,
    machine: &Machine<'_>,
    situations: impl FnOnce() -> &'f Situations,
) -> Option<TokenStream> {
    let body = machine.forced.as_ref()?;
    let situations = if cx.is_alone() { &Situations::Alone } else { situations() };
    Some(cx.force(&possible(situations, &cx.p), &cx.forced_situation(machine), body))
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
    fn force(&self, possible: &TokenStream, ask: &TokenStream, body: &TokenStream) -> TokenStream {
        let Cx { model, p, names, .. } = self;
        let (vis, chart, step) = (&model.vis, &names.chart, &names.step);
        let (inputs, outputs) = (&names.inputs, &names.outputs);
        let (copied, levels) = (requirements::copied(model, p), super::types::levels(model));
        let unreached = super::unreached(model);
        let time = model.uses_time();
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
}

/// The state of a region that is asked for.
pub(super) fn asked(region: RegionId) -> proc_macro2::Ident {
    names::local(&format!("forced{region}"))
}
