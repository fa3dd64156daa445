//! `sfc`: the `ACTION_CONTROL` of IEC 61131-3 for the targets that need it, and the order of the runs (A29).

mod flags;
mod runs;

pub(super) use flags::set_by;

use proc_macro2::{Literal, TokenStream};
use quote::ToTokens;

use super::{Cx, names};
use crate::list::List;
use crate::model::{Qualifier, TimeRef};
use crate::place::quote;
use crate::plan::{Target, What};

impl Cx<'_> {
    /// Whether the end of N, L or D by leaving a step has caused the fall of Q (A29).
    fn by_leaving(&self, index: usize, target: &Target) -> Option<TokenStream> {
        let causes = self.leavable(target).into_iter().map(|qualifier| {
            let (left, now) =
                (self.left(index, target, qualifier), self.term(index, target, qualifier, &quote!(false)).1);
            let held = target.remembers_terms(self.model).then(|| {
                let kept = names::target(&format!("kept_{}", names::flag(qualifier)), self.model, index, target);
                quote!(&& self.#kept)
            });
            quote!((#left && !(#now) #held))
        });
        let causes: Vec<_> = causes.list();
        (!causes.is_empty()).then(|| quote!((#(#causes)||*)))
    }

    /// Q of all targets.
    pub(super) fn compute_q(&self) -> TokenStream {
        self.plan.control.targets.iter().enumerate().map(|(i, target)| self.q(i, target)).tokens()
    }

    /// ```text
    /// Q = !R && (N || S_FF || (L && !L_TMR) || D_TMR || P_TRIG || SD_TMR || DS_FF || (SL_FF && !SL_TMR))
    /// ```
    fn q(&self, index: usize, target: &Target) -> TokenStream {
        let reset = if target.has(self.model, Qualifier::R) {
            let flag = names::target_local(&names::flag(Qualifier::R), self.model, index, target);
            quote!(#flag)
        } else {
            quote!(false)
        };
        let mut statements = TokenStream::new();
        let (mut terms, mut acting) = (Vec::new(), Vec::new());
        for qualifier in Qualifier::ALL.into_iter().filter(|qualifier| qualifier.drives_q()) {
            if target.has(self.model, qualifier) {
                let (statement, term) = self.term(index, target, qualifier, &reset);
                statements.extend(statement);
                if target.remembers_association {
                    let (number, note) = self.number_of(index, target, qualifier);
                    statements.extend(note);
                    acting.push((term.clone(), number));
                }
                terms.push(term);
            }
        }
        let q = names::target_local("q", self.model, index, target);
        let any = match target.what {
            // Where nothing sets it, it keeps its initial value until it is reset.
            What::Boolean(place) if terms.is_empty() => {
                let field = names::place_field(self.model, place);
                quote!(self.#field)
            }
            _ if terms.is_empty() => quote!(false),
            _ => quote!((#(#terms)||*)),
        };
        let acts = target.remembers_association.then(|| self.note_acting(index, target, &acting));
        quote!(#statements let #q = !#reset && #any; #acts)
    }

    /// Remembers which association acts: the last in the source of those that alone would make Q true.
    fn note_acting(&self, index: usize, target: &Target, acting: &[(TokenStream, TokenStream)]) -> TokenStream {
        let q = names::target_local("q", self.model, index, target);
        let remembered = names::target("association", self.model, index, target);
        // The first of all is what it is anyway.
        let above: Vec<_> = acting.iter().filter(|(_, number)| number.to_string() != "0").cloned().list();
        let note = match (acting.len(), &above[..]) {
            (_, []) => quote!(self.#remembered = 0;),
            (1, [(_, number)]) => quote!(self.#remembered = #number;),
            (_, [(term, number)]) => quote!(self.#remembered = if #term { #number } else { 0 };),
            (_, [(first, number), others @ ..]) => {
                let ty = names::number_type(target.associations.len(), &self.p);
                let (terms, numbers): (Vec<_>, Vec<_>) = others.iter().cloned().unzip();
                quote! {
                    let mut acts_: #ty = if #first { #number } else { 0 };
                    #(if #terms && acts_ < #numbers { acts_ = #numbers; })*
                    self.#remembered = acts_;
                }
            }
        };
        quote!(if #q { #note })
    }

    /// One term of Q and the statements that prepare it.
    fn term(
        &self,
        index: usize,
        target: &Target,
        qualifier: Qualifier,
        reset: &TokenStream,
    ) -> (TokenStream, TokenStream) {
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let local = |prefix: &str| names::target_local(prefix, self.model, index, target);
        let flag = local(&names::flag(qualifier));
        let store = |input: &TokenStream| {
            let memory = name(&format!("memory_{}", names::flag(qualifier)));
            (quote!(self.#memory = (self.#memory || #input) && !#reset;), quote!(self.#memory))
        };
        let p = &self.p;
        let timer = |input: &TokenStream| {
            let (timer, done) = (
                name(&format!("timer_{}", names::flag(qualifier))),
                local(&format!("done_{}", names::flag(qualifier))),
            );
            let restart = if self.restarts(target, qualifier) {
                self.restart(index, target, qualifier).into_token_stream()
            } else {
                quote!(false)
            };
            let time = self.target_time(index, target, qualifier);
            (
                quote!(let #done = #p::OnDelay::update(&mut self.#timer, #input, #restart, #time, elapsed_);),
                quote!(#done),
            )
        };
        match qualifier {
            Qualifier::S => store(&quote!(#flag)),
            Qualifier::L => {
                let (statement, done) = timer(&quote!(#flag));
                (statement, quote!(#flag && !#done))
            }
            Qualifier::D => timer(&quote!(#flag)),
            Qualifier::Sd => {
                let (first, stored) = store(&quote!(#flag));
                let (second, done) = timer(&stored);
                (quote!(#first #second), done)
            }
            Qualifier::Ds => {
                let (first, done) = timer(&quote!(#flag));
                let (second, stored) = store(&done);
                (quote!(#first #second), stored)
            }
            Qualifier::Sl => {
                let (first, stored) = store(&quote!(#flag));
                let (second, done) = timer(&stored);
                (quote!(#first #second), quote!(#stored && !#done))
            }
            _ => (TokenStream::new(), quote!(#flag)),
        }
    }

    /// The time of a target's timer: that of the association active last where they differ, read anew in each cycle.
    pub(super) fn target_time(&self, index: usize, target: &Target, qualifier: Qualifier) -> TokenStream {
        let mut times: Vec<(TimeRef, Vec<Literal>)> = Vec::new();
        for id in target.under(self.model, qualifier) {
            let Some(time) = self.model.associations[id].time else { continue };
            let number = names::association_number(target, id);
            match times.iter_mut().find(|(other, _)| *other == time) {
                Some((_, numbers)) => numbers.push(number),
                None => times.push((time, vec![number])),
            }
        }
        let Some(((last, _), others)) = times.split_last() else { return TokenStream::new() };
        let last = self.time(*last);
        if others.is_empty() {
            return last;
        }
        let field = names::target(&format!("time_{}", names::flag(qualifier)), self.model, index, target);
        let arms = others.iter().map(|(time, numbers)| {
            let time = self.time(*time);
            quote!(#(#numbers)|* => #time,)
        });
        quote!(match self.#field { #(#arms)* _ => #last })
    }
}
