//! `sfc`: the `ACTION_CONTROL` of IEC 61131-3 for the targets that need it, and the order of the runs (A29).

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::bind::Moment;
use super::segments::Item;
use super::{Cx, names};
use crate::model::{Association, AssociationId, Effect, Id, Place, Qualifier, TimeRef};
use crate::plan::{Target, What, source_order};

/// The qualifiers whose flag is the activity of a step; the others are events.
const LEVELS: [Qualifier; 8] =
    [Qualifier::N, Qualifier::S, Qualifier::R, Qualifier::L, Qualifier::D, Qualifier::Sd, Qualifier::Ds, Qualifier::Sl];

/// The qualifiers whose timer starts again with a step that is left and re-entered at once.
const RESTARTED: [Qualifier; 3] = [Qualifier::L, Qualifier::D, Qualifier::Ds];

impl Cx<'_> {
    /// The flags of all targets, their conditions read before the first action runs.
    pub(super) fn gather_flags(&self) -> TokenStream {
        let targets = &self.plan.control.targets;
        let declare = targets.iter().enumerate().map(|(i, target)| self.declare_flags(i, target));
        let gathered = source_order(self.model).filter_map(|id| {
            let target = self.plan.control.of_association[id.index()]?;
            Some(self.gather(id, target))
        });
        let gathered = self.in_order(gathered);
        quote!(#(#declare)* #gathered)
    }

    fn declare_flags(&self, index: usize, target: &Target) -> TokenStream {
        let flags = target.associations.iter().map(|id| self.model.associations[*id].qualifier);
        let mut flags: Vec<Qualifier> = flags.collect();
        flags.sort_unstable();
        flags.dedup();
        let flags = flags.iter().map(|qualifier| {
            let flag = names::target(names::flag(*qualifier), self.model, index, target);
            quote!(let mut #flag = false;)
        });
        let restarts = RESTARTED.into_iter().filter(|qualifier| self.restarts(target, *qualifier)).map(|qualifier| {
            let restart = self.restart(index, target, qualifier);
            quote!(let mut #restart = false;)
        });
        let left = self.leavable(target).into_iter().map(|qualifier| {
            let left = self.left(index, target, qualifier);
            quote!(let mut #left = false;)
        });
        let chooses = |qualifier: &&(Qualifier, &str)| {
            target.what == What::Runs && self.has_choice(target) && target.has(self.model, qualifier.0)
        };
        let numbers = [(Qualifier::P0, "number_p0"), (Qualifier::P1, "number_p1")];
        let numbers = numbers.iter().filter(chooses).map(|(_, prefix)| {
            let number = names::target(prefix, self.model, index, target);
            let ty = names::number_type(target.associations.len(), &self.p);
            quote!(let mut #number: #ty = 0;)
        });
        let held = target.remembers_held.iter().map(|id| {
            let (before, held) = self.held_before(*id, index, target);
            quote!(let #before = self.#held; self.#held = false;)
        });
        quote!(#(#flags)* #(#restarts)* #(#left)* #(#numbers)* #(#held)*)
    }

    /// What one association adds to the flags of its target.
    fn gather(&self, id: AssociationId, index: usize) -> Item {
        let (association, target) = (&self.model.associations[id], &self.plan.control.targets[index]);
        let flag = names::target(names::flag(association.qualifier), self.model, index, target);
        let number = self.note_number(id, association, index, target);
        let mut set = quote!(#flag = true; #number);
        if target.remembers_time(self.model, association.qualifier) {
            let prefix = format!("time_{}", names::flag(association.qualifier));
            let field = names::target(&prefix, self.model, index, target);
            let number = names::association_number(target, id);
            set.extend(quote!(self.#field = #number;));
        }
        if target.remembers_held.contains(&id) {
            let held = self.held_before(id, index, target).1;
            set.extend(quote!(self.#held = true;));
        }
        if let Some(condition) = &association.condition {
            let condition = self.value(condition, Moment::Action);
            set = quote!(if #condition { #set });
        }
        let step = association.step;
        let region = self.plan.regions.of_step(step);
        match association.qualifier {
            Qualifier::P0 => self.if_left(step, &set),
            Qualifier::P1 | Qualifier::P => self.if_entered(step, &set),
            _ => {
                let qualifier = association.qualifier;
                let again = self.plan.sees_reentry[region] && self.restarts(target, qualifier);
                let restart = again.then(|| {
                    let (restart, again) = (self.restart(index, target, qualifier), names::again(region, self.plan));
                    quote!(#restart |= #again;)
                });
                Item::After(step, quote!(#set #restart))
            }
        }
    }

    /// Which association's arguments a run takes: the last active one in source order, never an R (A31).
    fn note_number(&self, id: AssociationId, association: &Association, index: usize, target: &Target) -> TokenStream {
        if target.what != What::Runs || association.qualifier == Qualifier::R || !self.has_choice(target) {
            return TokenStream::new();
        }
        let number = names::association_number(target, id);
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let (leaving, entering, remembered) = (name("number_p0"), name("number_p1"), name("association"));
        match association.qualifier {
            Qualifier::P0 => quote!(#leaving = #number;),
            Qualifier::P1 => quote!(#entering = #number;),
            _ if target.has(self.model, Qualifier::P1) => quote!(#entering = #number; self.#remembered = #number;),
            _ => quote!(self.#remembered = #number;),
        }
    }

    /// Several associations of the target give different calls.
    fn has_choice(&self, target: &Target) -> bool {
        let runs = |id: &&AssociationId| {
            let association = &self.model.associations[**id];
            association.qualifier != Qualifier::R
                && matches!(&association.effect, Effect::Call(_, arguments) if !arguments.is_empty())
        };
        target.associations.iter().filter(runs).count() > 1
    }

    /// An association of the target under this qualifier, whose timer starts again with its step, can be re-entered (A4s).
    fn restarts(&self, target: &Target, qualifier: Qualifier) -> bool {
        let reentered = |id| self.plan.sees_reentry[self.plan.regions.of_step(self.model.associations[id].step)];
        RESTARTED.contains(&qualifier) && target.under(self.model, qualifier).any(reentered)
    }

    /// The local that says that such a step has been re-entered.
    fn restart(&self, index: usize, target: &Target, qualifier: Qualifier) -> Ident {
        names::target(&format!("restart_{}", names::flag(qualifier)), self.model, index, target)
    }

    /// The qualifiers of the target that leaving a step can end, and a final call with them.
    fn leavable(&self, target: &Target) -> Vec<Qualifier> {
        if target.remembers_q { target.leavable(self.model) } else { Vec::new() }
    }

    /// The local that says that a step with this qualifier has been left.
    fn left(&self, index: usize, target: &Target, qualifier: Qualifier) -> Ident {
        names::target(&format!("left_{}", names::flag(qualifier)), self.model, index, target)
    }

    /// Whether the condition of an association held in the cycle before: the local, and the field.
    fn held_before(&self, id: AssociationId, index: usize, target: &Target) -> (Ident, Ident) {
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        (name(&format!("before_{}", names::held(target, id))), name(&names::held(target, id)))
    }

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
        let causes: Vec<_> = causes.collect();
        (!causes.is_empty()).then(|| quote!((#(#causes)||*)))
    }

    /// Q of all targets.
    pub(super) fn compute_q(&self) -> TokenStream {
        self.plan.control.targets.iter().enumerate().map(|(i, target)| self.q(i, target)).collect()
    }

    /// ```text
    /// Q = !R && (N || S_FF || (L && !L_TMR) || D_TMR || P_TRIG || SD_TMR || DS_FF || (SL_FF && !SL_TMR))
    /// ```
    fn q(&self, index: usize, target: &Target) -> TokenStream {
        let reset = if target.has(self.model, Qualifier::R) {
            let flag = names::target(names::flag(Qualifier::R), self.model, index, target);
            quote!(#flag)
        } else {
            quote!(false)
        };
        let mut statements = TokenStream::new();
        let mut terms = Vec::new();
        for qualifier in LEVELS.into_iter().chain([Qualifier::P]) {
            if qualifier != Qualifier::R && target.has(self.model, qualifier) {
                let (statement, term) = self.term(index, target, qualifier, &reset);
                statements.extend(statement);
                terms.push(term);
            }
        }
        let q = names::target("q", self.model, index, target);
        let any = match target.what {
            // Where nothing sets it, it keeps its initial value until it is reset.
            What::Boolean(place) if terms.is_empty() => {
                let field = names::place_field(self.model, place);
                quote!(self.#field)
            }
            _ if terms.is_empty() => quote!(false),
            _ => quote!((#(#terms)||*)),
        };
        quote!(#statements let #q = !#reset && #any;)
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
        let flag = name(names::flag(qualifier));
        let store = |input: &TokenStream| {
            let memory = name(&format!("memory_{}", names::flag(qualifier)));
            (quote!(self.#memory = (self.#memory || #input) && !#reset;), quote!(self.#memory))
        };
        let timer = |input: &TokenStream| {
            let (timer, done) =
                (name(&format!("timer_{}", names::flag(qualifier))), name(&format!("done_{}", names::flag(qualifier))));
            let restart = if self.restarts(target, qualifier) {
                self.restart(index, target, qualifier).into_token_stream()
            } else {
                quote!(false)
            };
            let time = self.target_time(index, target, qualifier);
            (quote!(let #done = self.#timer.update(#input, #restart, #time, elapsed);), quote!(#done))
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

    /// Final calls caused by leaving a step are told apart from the others (A29).
    pub(super) fn note_leaving(&self) -> TokenStream {
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
            let (after, variant) =
                (names::after(self.plan.regions.of_step(association.step), self.plan), self.variant(association.step));
            Some(Item::Before(association.step, quote!(if #after != #variant { #note })))
        });
        self.in_order(items)
    }

    /// The run of a target among the deactivations: P0, and a final call caused by leaving a step.
    pub(super) fn run_leaving(&self, index: usize, target: &Target) -> TokenStream {
        if target.what != What::Runs {
            return TokenStream::new();
        }
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let p0 = target.has(self.model, Qualifier::P0).then(|| name(names::flag(Qualifier::P0)));
        let (q, kept) = (name("q"), name("kept_q"));
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
    pub(super) fn run_entering(&self, index: usize, target: &Target) -> TokenStream {
        if target.what != What::Runs || !target.has(self.model, Qualifier::P1) {
            return TokenStream::new();
        }
        let p1 = names::target(names::flag(Qualifier::P1), self.model, index, target);
        let run = self.run(index, target, &quote!(First), RunKind::P1);
        quote!(if #p1 { #run })
    }

    /// What is left of a target: its value, or its run while Q holds, or the final call that no leaving has caused.
    pub(super) fn run_rest(&self, index: usize, target: &Target) -> TokenStream {
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let q = name("q");
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
        let kept = name("kept_q");
        let first = self.run(index, target, &quote!(First), RunKind::Level);
        let repeated = self.run(index, target, &quote!(Repeated), RunKind::Level);
        let last = self.run(index, target, &quote!(Final), RunKind::Level);
        let done = |qualifier, prefix: &str| {
            target.has(self.model, qualifier).then(|| name(prefix)).map(|flag| quote!(&& !#flag))
        };
        let not_p1 = done(Qualifier::P1, names::flag(Qualifier::P1));
        let not_p0 = done(Qualifier::P0, names::flag(Qualifier::P0));
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
            (RunKind::Level, qualifier) => !matches!(qualifier, Qualifier::P0 | Qualifier::P1),
        };
        let runs: Vec<_> = runs.filter(of_kind).collect();
        let one = |id: &AssociationId| self.effect_run(&self.model.associations[*id].effect, phase, moment);
        let Some((last, others)) = runs.split_last() else { return TokenStream::new() };
        if !self.has_choice(target) || others.is_empty() {
            let run = one(last);
            return quote!(#unsettle #run);
        }
        let name = |prefix: &str| names::target(prefix, self.model, index, target);
        let number = match kind {
            RunKind::P0 => name("number_p0").into_token_stream(),
            RunKind::P1 => name("number_p1").into_token_stream(),
            RunKind::Level => {
                let field = name("association");
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

    /// The effect of an action that runs.
    pub(super) fn effect_run(&self, effect: &Effect, phase: &TokenStream, moment: Moment) -> TokenStream {
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
