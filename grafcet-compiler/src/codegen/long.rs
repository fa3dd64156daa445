//! Long charts of which one step is active: steps that end on the same condition share its test, and a table says which
//! step is after each. A cycle costs the same whatever the step, and a step as little as two bytes beside its actions. Under `optimize size`
//! it is one byte for the condition and one for the actions: the step after is computed.

use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use quote::ToTokens;
use syn::Lifetime;

use super::bind::Moment;
use super::{Cx, names};
use crate::list::List;
use crate::model::StepId;
use crate::place::{self, quote};
use crate::sorted::Map;

/// How many actions have to set an output before a `true` for all of them is smaller.
const SET: usize = 6;

/// States in which the same is to be done.
struct Shared {
    states: Vec<TokenStream>,
    then: TokenStream,
}

impl Cx<'_> {
    /// `let after = …;`, and in an `sfc` the chart's own situation, which is left alone where nothing clears. In a search
    /// that ends it.
    pub(super) fn long(&self) -> TokenStream {
        let (before, after, next) = (names::before(0, self.plan), names::after(0, self.plan), names::local("next"));
        let label = evolved();
        let stay = if self.model.is_grafcet() { self.stop() } else { quote!(break #label #before) };
        let wait = self.wait(&stay);
        let found = self.behind(&next, &stay);
        let branches = self.model.steps.ids().any(|step| {
            self.plan.evolution.only_exit(self.model, step).is_none() && self.plan.evolution.leads_on(self.model, step)
        });
        match self.model.is_grafcet() {
            true if branches => quote!(let #after = #label: { #wait #found #next };),
            true => quote!(#wait #found let #after = #next;),
            false => {
                let commit = self.set_state(0, &quote!(#next));
                quote!(let #after = #label: { #wait #found #commit #next };)
            }
        }
    }

    /// `let next = …;`, the step after the active one, where that has but one transition.
    fn behind(&self, next: &Ident, stay: &TokenStream) -> TokenStream {
        let (before, steps) = (names::before(0, self.plan), &self.plan.regions.all()[0].steps);
        let target = |step: StepId| {
            let exit = self.plan.evolution.only_exit(self.model, step)?;
            self.model.transitions[exit].targets.first().copied()
        };
        if self.model.optimize_size {
            let computed = self.in_order_but(steps, target);
            return quote!(let #next = #computed;);
        }
        let p = &self.p;
        let targets = steps.iter().map(|step| self.variant(target(*step).unwrap_or(*step)));
        let first = self.has_start_variant(0).then(|| self.initial(0));
        let (region, states) = (self.names.region(0, self.plan), Literal::usize_suffixed(self.states(0)));
        quote! {
            const NEXT: [#region; #states] = [#(#targets,)* #first];
            let #p::core::option::Option::Some(&#next) = NEXT.get(#before as #p::usize) else { #stay };
        }
    }

    /// The step after the active one. LLVM computes it as `state + 1` where all of a `match` do that, so the few jumps that
    /// a sequence has are told apart in front of it.
    fn in_order_but(&self, steps: &[StepId], target: impl Fn(StepId) -> Option<StepId>) -> TokenStream {
        let before = names::before(0, self.plan);
        let (mut in_order, mut jumps) = (TokenStream::new(), TokenStream::new());
        for (i, step) in steps.iter().enumerate() {
            let (state, target) = (self.variant(*step), target(*step));
            let behind = steps.get(i + 1).copied();
            if let Some(target) = target.filter(|target| Some(*target) != behind) {
                let target = self.variant(target);
                jumps.extend(quote!(#state => #target,));
            }
            let behind = self.variant(behind.unwrap_or(*step));
            in_order.extend(quote!(#state => #behind,));
        }
        let start = self.has_start_variant(0).then(|| {
            let (start, first) = (self.start(), self.initial(0));
            jumps.extend(quote!(#start => #first,));
            quote!(#start => #first,)
        });
        quote!(match #before { #jumps _ => match #before { #in_order #start } })
    }

    /// What a step does that has not one transition alone.
    fn leave_long(&self, step: StepId) -> TokenStream {
        let (label, next, state) = (evolved(), names::local("next"), self.next_step(step));
        if self.model.is_grafcet() {
            // Every path of a step that nothing leads on from ends the search already.
            return if self.plan.evolution.leads_on(self.model, step) { quote!(break #label #state) } else { state };
        }
        let commit = self.set_state(0, &quote!(#next));
        quote!(let #next = #state; #commit break #label #next)
    }

    /// A `match` that tests the condition of the active step, or of what a table says it waits for.
    fn wait(&self, stay: &TokenStream) -> TokenStream {
        let before = names::before(0, self.plan).to_token_stream();
        let mut waits = self.waits(stay);
        if self.has_start_variant(0) {
            // No search begins in front of the initial situation.
            let then = if self.model.is_grafcet() { stay.clone() } else { TokenStream::new() };
            waits.push(Shared { states: vec![self.start()], then });
        }
        if self.plan.shape.looks_up_waits {
            return self.by_table(&before, &waits);
        }
        let arms = waits.iter().map(|Shared { states, then }| quote!(#(#states)|* => { #then }));
        quote!(match #before { #(#arms)* })
    }

    /// Under `optimize size` what the steps do, that of several steps once; `None` where few do the same.
    pub(super) fn shared_actions(&self, state: &TokenStream, arms: &[(StepId, TokenStream)]) -> Option<TokenStream> {
        if !self.model.optimize_size || !self.plan.shape.is_long() {
            return None;
        }
        // In the other direction than the conditions: LLVM would see where two tables are alike, and copy the actions.
        let mut shared = share(arms.iter().rev().map(|(step, body)| (self.variant(*step), body.clone())));
        if shared.len() * 2 > arms.len() {
            return None;
        }
        let (p, on) = (&self.p, names::local("on"));
        // One `true` for all outputs, which LLVM would load anew for each.
        let set: Vec<Option<TokenStream>> = shared.iter().map(|shared| set_to(&on, &shared.then)).list();
        if set.iter().flatten().count() < SET {
            return Some(self.by_table(state, &shared));
        }
        shared.iter_mut().zip(set).for_each(|(shared, set)| shared.then = set.unwrap_or_else(|| shared.then.clone()));
        let act = self.by_table(state, &shared);
        Some(quote!(let #on = #p::core::hint::black_box(true); #act))
    }

    /// `match` on what a table says about `state`. A state that is not told of does nothing.
    fn by_table(&self, state: &TokenStream, shared: &[Shared]) -> TokenStream {
        let p = &self.p;
        let (kind, nothing) = (names::local("Kind"), names::local("Nothing"));
        let variant = |number: usize| names::local(&format!("K{number}"));
        let mut of_state: Map<String, Ident> = Map::new();
        for (number, Shared { states, .. }) in shared.iter().enumerate() {
            of_state.extend(states.iter().map(|state| (state.to_string(), variant(number))));
        }
        let steps = self.plan.regions.all()[0].steps.iter().map(|step| self.variant(*step));
        let start = self.has_start_variant(0).then(|| self.start());
        let table: Vec<&Ident> =
            steps.chain(start).map(|state| of_state.get(&state.to_string()).unwrap_or(&nothing)).list();
        let length = Literal::usize_suffixed(table.len());
        let rest = table.contains(&&nothing).then_some(&nothing);
        let variants = (0..shared.len()).map(variant).chain(rest.cloned());
        let arms = shared.iter().enumerate().map(|(number, Shared { then, .. })| {
            let variant = variant(number);
            quote!(#p::core::option::Option::Some(#kind::#variant) => { #then })
        });
        quote! {{
            enum #kind { #(#variants,)* }
            const KINDS: [#kind; #length] = [#(#kind::#table,)*];
            match KINDS.get(#state as #p::usize) { #(#arms)* _ => {} }
        }}
    }

    /// What the steps wait for.
    fn waits(&self, stay: &TokenStream) -> Vec<Shared> {
        share(self.plan.regions.all()[0].steps.iter().map(|step| {
            let test = match self.plan.evolution.only_exit(self.model, *step).map(|exit| (exit, self.condition(exit))) {
                None => self.leave_long(*step),
                Some((_, None)) => TokenStream::new(),
                Some((exit, Some(condition))) => {
                    let condition = self.value(condition, Moment::Enabled(exit));
                    quote!(if #condition {} else { #stay })
                }
            };
            (self.variant(*step), test)
        }))
    }
}

/// The states that do the same, in the order of their first ones.
fn share(states: impl Iterator<Item = (TokenStream, TokenStream)>) -> Vec<Shared> {
    let mut shared: Vec<Shared> = Vec::new();
    let mut places: Map<String, usize> = Map::new();
    for (state, then) in states {
        let place = *places.or_insert_with(then.to_string(), || {
            shared.push(Shared { states: Vec::new(), then });
            shared.len() - 1
        });
        shared[place].states.push(state);
    }
    shared
}

/// `output = true;` is `output = on;`; `None` where there is none.
fn set_to(on: &Ident, actions: &TokenStream) -> Option<TokenStream> {
    let (mut assigned, mut any) = (false, false);
    let tokens = actions.clone().into_iter().map(|token| {
        let is_true = assigned && matches!(&token, TokenTree::Ident(ident) if ident == "true");
        assigned = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '=');
        any |= is_true;
        if is_true { TokenTree::Ident(on.clone()) } else { token }
    });
    let tokens = tokens.collect();
    any.then_some(tokens)
}

/// What the next step is found in.
fn evolved() -> Lifetime {
    Lifetime::new("'evolved", place::mixed())
}
