//! What a target does, in the order of the runs: among what is left, among what is entered, and the rest (A29).

use proc_macro2::TokenStream;
use quote::ToTokens;

use crate::codegen::bind::Moment;
use crate::codegen::in_order::Item;
use crate::codegen::situation::At;
use crate::codegen::{Cx, names, types};
use crate::list::List;
use crate::model::{AssociationId, Effect, Expr, Id, Place, Qualifier, Ty};
use crate::place::quote;
use crate::plan::{Target, What, source_order};

impl Cx<'_> {
    /// Final calls caused by leaving a step are told apart from the others (A29).
    pub(in crate::codegen) fn note_leaving(&self) -> TokenStream {
        let items = source_order(self.model).filter_map(|id| {
            let index = self.plan.control.of_association[id.index()]?;
            let (target, association) = (&self.plan.control.targets[index], &self.model.associations[id]);
            if !self.leavable(target).contains(&association.qualifier) {
                return None;
            }
            let left = self.left(index, target, association.qualifier);
            let note = match target.remembers_held.contains(&id).then(|| self.held_before(id, index, target).0) {
                Some(before) => quote!(#left |= #before;),
                None => quote!(#left = true;),
            };
            if association.qualifier == Qualifier::D {
                // On a self-loop the delay begins again: that ends the action.
                return Some(self.if_left(association.step, &note));
            }
            let is_left = self.not_in_step(At::After, association.step);
            Some(Item::Before(association.step, quote!(if #is_left { #note })))
        });
        self.in_order(items)
    }

    /// The run of a target among the deactivations: P0, and a final call caused by leaving a step.
    pub(in crate::codegen) fn run_leaving(&self, index: usize, target: &Target) -> TokenStream {
        if target.what != What::Runs {
            return TokenStream::new();
        }
        let local = |prefix: &str| names::target_local(prefix, self.model, index, target);
        let p0 = target.has(self.model, Qualifier::P0).then(|| local(&names::flag(Qualifier::P0)));
        let (q, kept) = (local("q"), names::target("kept_q", self.model, index, target));
        let falls = target.remembers_q.then(|| quote!(self.#kept && !#q));
        let leaving = self.by_leaving(index, target);
        let p0_run = |phase: TokenStream| self.run_at(index, target, &phase, RunKind::P0, Moment::Leaving);
        let (first, last) = (p0_run(quote!(First)), p0_run(quote!(Final)));
        let final_run = self.run_at(index, target, &quote!(Final), RunKind::Level, Moment::Leaving);
        match (p0, falls, leaving) {
            (Some(p0), Some(falls), Some(left)) => {
                quote!(if #p0 { if #falls { #last } else { #first } } else if #falls && #left { #final_run })
            }
            (Some(p0), Some(falls), None) => quote!(if #p0 { if #falls { #last } else { #first } }),
            (Some(p0), None, _) => quote!(if #p0 { #first }),
            (None, Some(falls), Some(left)) => quote!(if #falls && #left { #final_run }),
            _ => TokenStream::new(),
        }
    }

    /// The run of a target among the activations: P1.
    pub(in crate::codegen) fn run_entering(&self, index: usize, target: &Target) -> TokenStream {
        if target.what != What::Runs || !target.has(self.model, Qualifier::P1) {
            return TokenStream::new();
        }
        let p1 = names::target_local(&names::flag(Qualifier::P1), self.model, index, target);
        let run = self.run(index, target, &quote!(First), RunKind::P1);
        quote!(if #p1 { #run })
    }

    /// What is left of a target: its value, or its run while Q holds, or the final call that no leaving has caused.
    pub(in crate::codegen) fn run_rest(&self, index: usize, target: &Target) -> TokenStream {
        let local = |prefix: &str| names::target_local(prefix, self.model, index, target);
        let q = local("q");
        match target.what {
            What::Boolean(Place::Output(output)) => {
                let local = names::output_local(self.model, output);
                return quote!(#local = #q;);
            }
            What::Boolean(Place::Var(var)) => {
                let field = names::var_field(self.model, var);
                let settled = self.unsettle_if(&quote!(self.#field != #q));
                return quote!(#settled self.#field = #q;);
            }
            What::Runs if !target.remembers_q => return TokenStream::new(),
            What::Runs => {}
        }
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let kept = name("kept_q");
        let first = self.run(index, target, &quote!(First), RunKind::Level);
        let repeated = self.run(index, target, &quote!(Repeated), RunKind::Level);
        let last = self.run(index, target, &quote!(Final), RunKind::Level);
        let done = |qualifier, prefix: &str| {
            target.has(self.model, qualifier).then(|| local(prefix)).map(|flag| quote!(&& !#flag))
        };
        let not_p1 = done(Qualifier::P1, &names::flag(Qualifier::P1));
        let not_p0 = done(Qualifier::P0, &names::flag(Qualifier::P0));
        let not_left = self.by_leaving(index, target).map(|left| quote!(&& !#left));
        let kept_terms = self.leavable(target).into_iter().filter(|_| target.remembers_terms(self.model));
        let kept_terms = kept_terms.map(|qualifier| {
            let (kept, now) = (
                name(&format!("kept_{}", names::flag(qualifier))),
                self.term(index, target, qualifier, &quote!(false)).1,
            );
            quote!(self.#kept = #now;)
        });
        let run = if self.tells_phase(target) { quote!(if self.#kept { #repeated } else { #first }) } else { first };
        quote! {
            if #q #not_p1 { #run } else if self.#kept && !#q #not_p0 #not_left { #last }
            self.#kept = #q;
            #(#kept_terms)*
        }
    }

    /// Only the method of an action is told the phase.
    fn tells_phase(&self, target: &Target) -> bool {
        target.associations.iter().any(|id| matches!(self.model.associations[*id].effect, Effect::Call(..)))
    }

    /// One run of a target.
    fn run(&self, index: usize, target: &Target, phase: &TokenStream, kind: RunKind) -> TokenStream {
        self.run_at(index, target, phase, kind, Moment::Action)
    }

    /// One run of a target; among the steps left, with the time they had reached (A34).
    fn run_at(&self, index: usize, target: &Target, phase: &TokenStream, kind: RunKind, moment: Moment) -> TokenStream {
        let unsettle = self.unsettle();
        let runs =
            target.associations.iter().copied().filter(|id| self.model.associations[*id].qualifier != Qualifier::R);
        let of_kind = |id: &AssociationId| match (kind, self.model.associations[*id].qualifier) {
            (RunKind::P0, qualifier) => qualifier == Qualifier::P0,
            (RunKind::P1, qualifier) => qualifier != Qualifier::P0,
            (RunKind::Level, qualifier) => !qualifier.runs_once(),
        };
        let runs: Vec<_> = runs.filter(of_kind).list();
        let one = |id: &AssociationId| self.effect_run(&self.model.associations[*id].effect, phase, moment);
        let Some((last, others)) = runs.split_last() else { return TokenStream::new() };
        if !self.has_choice(target) || others.is_empty() {
            return self.unsettling_run(&self.model.associations[*last].effect, phase, moment);
        }
        let local = |prefix: &str| names::target_local(prefix, self.model, index, target);
        let number = match kind {
            RunKind::P0 => local("number_p0").into_token_stream(),
            RunKind::P1 => self.number_on_entry(index, target),
            RunKind::Level => {
                let field = names::target("association", self.model, index, target);
                quote!(self.#field)
            }
        };
        let arms = others.iter().map(|id| {
            let (number, run) = (names::association_number(target, *id), one(id));
            quote!(#number => { #run })
        });
        let last = one(last);
        quote!(#unsettle match #number { #(#arms)* _ => { #last } })
    }

    /// P1 together with an active Q is one run, with the arguments of the last in the source of those that act.
    fn number_on_entry(&self, index: usize, target: &Target) -> TokenStream {
        let local = |prefix: &str| names::target_local(prefix, self.model, index, target);
        let (q, p1) = (local("q"), local("number_p1"));
        let levels = |id: &&AssociationId| self.model.associations[**id].qualifier.drives_q();
        let Some(level) = target.associations.iter().find(levels) else { return p1.into_token_stream() };
        let acts = if target.remembers_association {
            let field = names::target("association", self.model, index, target);
            quote!(self.#field)
        } else if target.associations.first() == Some(level) {
            return p1.into_token_stream();
        } else {
            names::association_number(target, *level).into_token_stream()
        };
        quote!(if #q && #acts > #p1 { #acts } else { #p1 })
    }

    /// The same in an `sfc`: the next cycle has something to do where it changed something. Nobody sees whether a call or a block did.
    pub(in crate::codegen) fn unsettling_run(
        &self,
        effect: &Effect,
        phase: &TokenStream,
        moment: Moment,
    ) -> TokenStream {
        let (unsettle, model) = (self.unsettle(), self.model);
        match effect {
            Effect::Assign(place, value) if unsettle.is_some() && is_followed(model.place_ty(*place), value) => {
                let (field, value, p) = (names::place_field(model, *place), self.value(value, moment), &self.p);
                let ty = model.place_ty(*place);
                let rust = types::rust_type(ty, p);
                let changes = types::compare(ty, &quote!(value_), &quote!(!=), &quote!(self.#field), p);
                quote!({ let value_: #rust = #value; if #changes { #unsettle self.#field = value_; } })
            }
            _ => {
                let run = self.effect_run(effect, phase, moment);
                quote!(#unsettle #run)
            }
        }
    }

    /// The effect of an action that runs.
    pub(in crate::codegen) fn effect_run(&self, effect: &Effect, phase: &TokenStream, moment: Moment) -> TokenStream {
        match effect {
            Effect::Call(action, args) => self.call(*action, phase, args, moment),
            Effect::Assign(place, value) => {
                let (field, value) = (names::place_field(self.model, *place), self.value(value, moment));
                quote!(self.#field = #value;)
            }
            Effect::Block(code) => self.block(code, moment, |place| {
                let field = names::place_field(self.model, place);
                quote!(self.#field)
            }),
            Effect::Control(_) => TokenStream::new(),
        }
    }
}

/// Whether a value is another one only where something it reads is, and it can be seen whether it is. A type of the user's compares as it likes.
fn is_followed(ty: &Ty, value: &Expr) -> bool {
    let known = matches!(ty, Ty::Bool(_) | Ty::Int { .. } | Ty::Time(_)) || ty.is_float();
    known && !value.tree.may_differ()
}

/// Which associations a run is of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum RunKind {
    /// On leaving a step.
    P0,
    /// On entering one: its arguments are the last in the source among P1 and what is active.
    P1,
    /// While Q holds, and the final call.
    Level,
}
