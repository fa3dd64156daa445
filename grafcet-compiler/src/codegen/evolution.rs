//! One evolution: which transitions clear in the situation `before`, and the situation `after`.

use std::borrow::Cow;

use proc_macro2::TokenStream;

use super::bind::Moment;
use super::branches::Branch;
use super::situation::At;
use super::{Cx, names};
use crate::list::{List, PushAll};
use crate::model::{AnyId, Expr, Id, PartialId, StepId, Transition, TransitionId, Tree};
use crate::place::quote;
use crate::plan::{Form, RegionId};
use crate::sorted::sort_unstable;

impl Cx<'_> {
    /// Statements that change the `after` of every region by the transitions that clear.
    pub(super) fn evolve(&self) -> TokenStream {
        if self.plan.shape.descends {
            return self.descend();
        }
        let declare = self.plan.evolution.entered_last.iter().map(|step| {
            let enter = names::enter_local(*step);
            quote!(let mut #enter = false;)
        });
        let once = self.model.anys.ids().filter(|any| self.acts_for_several(*any)).map(|any| {
            let cleared = names::any_cleared(any);
            quote!(let mut #cleared = false;)
        });
        let partials = self.plan.evolution.partials.iter().map(|partial| self.evolve_partial(*partial));
        quote!(#(#declare)* #(#once)* #(#partials)*)
    }

    /// Whether several transitions of an `any` may clear together, of which one alone does what is done on clearing.
    fn acts_for_several(&self, any: AnyId) -> bool {
        let first = &self.model.transitions[self.model.anys[any].first];
        let regions = if self.plan.shape.is_flags() {
            self.plan.most_active
        } else {
            self.plan.regions.of_partial(first.partial).count()
        };
        !first.clearing.is_empty() && regions > 1
    }

    /// The actions on clearing a transition; of an `any` once.
    fn acts_on_clearing(&self, id: TransitionId) -> TokenStream {
        let actions = self.clearing_actions(id);
        match self.model.transitions[id].any.filter(|any| self.acts_for_several(*any)) {
            Some(any) => {
                let cleared = names::any_cleared(any);
                quote!(if !#cleared { #cleared = true; #actions })
            }
            None => actions,
        }
    }

    /// A partial grafcet, unless a forcing order or its enclosing step decides about it.
    fn evolve_partial(&self, partial: PartialId) -> TokenStream {
        match self.plan.shape.form {
            Form::InPlace => self.under_masters(partial, &self.evolve_in_place(partial)),
            Form::Flags | Form::Compared => self.evolve_compared(partial),
            Form::Program => TokenStream::new(),
        }
    }

    /// A partial grafcet, of which the situation after is a copy.
    fn evolve_compared(&self, partial: PartialId) -> TokenStream {
        let contests = self.plan.evolution.contests.iter().map(|contest| self.contest(contest));
        let regions: Vec<_> = self.plan.regions.of_partial(partial).list();
        let transitions = if self.plan.shape.is_flags() {
            let steps = self.model.partials[partial].steps.iter();
            let arms = steps.filter_map(|step| Some((*step, self.leave_step(*step)?)));
            vec![self.visit(At::Before, &arms.list())]
        } else {
            regions.iter().map(|region| self.evolve_region(*region)).list()
        };
        let sources = self.source_transitions(partial);
        let late = self.enter_late(partial);
        let evolve = quote!(#(#contests)* #(#transitions)* #sources #late);
        if self.model.is_grafcet() {
            return self.under_masters(partial, &evolve);
        }
        // A27: the first cycle of an `sfc` enters the initial situation and evaluates no transition.
        let starting = self.is_starting(At::Before);
        if self.plan.shape.is_flags() {
            let (initial, moved, after) = (self.initial_flags(), self.note_moved(), names::after(0, self.plan));
            return quote!(if #starting { #after = #initial; #moved } else { #evolve });
        }
        if regions.len() == 1 {
            return evolve;
        }
        let enter = regions.iter().map(|region| {
            let (after, initial) = (names::after(*region, self.plan), self.initial(*region));
            quote!(#after = #initial;)
        });
        quote!(if #starting { #(#enter)* } else { #evolve })
    }

    /// `{ if … { On } else { Off } }`
    pub(super) fn next_step(&self, step: StepId) -> TokenStream {
        self.next_step_or(step, &self.stay(step))
    }

    /// The step after, or `stay`.
    fn next_step_or(&self, step: StepId, stay: &TokenStream) -> TokenStream {
        let leaving = &self.plan.evolution.owned[step.index()];
        if leaving.is_empty() {
            return stay.clone();
        }
        let branches = leaving.iter().map(|id| self.a_branch(*id, self.clear_to(*id)));
        self.branches(branches.list(), stay)
    }

    fn a_branch(&self, id: TransitionId, then: TokenStream) -> Branch<'_> {
        Branch { id, condition: self.condition(id).map(Cow::Borrowed), then }
    }

    /// The condition of a transition after the other branches of its steps, `None` for `true` and for `else`.
    pub(super) fn condition(&self, id: TransitionId) -> Option<&Expr> {
        let transition = &self.model.transitions[id];
        let always = transition.condition.tree == Tree::Bool(true) || transition.plain_else().is_some();
        (!always).then_some(&transition.condition)
    }

    /// A path on which nothing clears: in a search it is the end of it.
    fn stay(&self, step: StepId) -> TokenStream {
        self.variant(step)
    }

    /// What clearing does beside the situation, and the step it leads to.
    fn clear_to(&self, id: TransitionId) -> TokenStream {
        let transition = &self.model.transitions[id];
        if self.model.is_grafcet() && transition.sources == transition.targets {
            // A4g: nothing happens to a step that is left and entered at once.
            return transition.sources.iter().map(|step| self.stay(*step)).tokens();
        }
        let actions = self.clearing_actions(id);
        let (stays, seen) = (transition.sources == transition.targets, self.plan.sees_reentry[0]);
        let again = (stays && seen).then(|| {
            let again = names::again(0, self.plan);
            quote!(#again = true;)
        });
        let moved = if stays { seen.then(|| self.note_reentry()).flatten() } else { self.note_moved() };
        let begin = transition.targets.iter().map(|step| self.begin_time(*step, transition));
        let target = transition.targets.iter().map(|step| self.variant(*step));
        quote!(#actions #again #(#begin)* #moved #(#target)*)
    }

    /// The transitions out of the steps of one region.
    fn evolve_region(&self, region: RegionId) -> TokenStream {
        let before = names::before(region, self.plan);
        let steps = &self.plan.regions.all()[region].steps;
        let arms = steps.iter().filter_map(|step| Some((self.variant(*step), self.leave_step(*step)?)));
        let arms: Vec<_> = arms.map(|(variant, body)| quote!(#variant => { #body })).list();
        let alone = !self.model.is_grafcet() && self.plan.regions.all().len() == 1;
        let start = (alone && self.has_start_variant(region)).then(|| {
            let (start, initial, after) = (self.start(), self.initial(region), names::after(region, self.plan));
            quote!(#start => #after = #initial,)
        });
        let covered = arms.len() + usize::from(start.is_some());
        if covered == 0 {
            return TokenStream::new();
        }
        let rest = (covered < self.states(region)).then(|| quote!(_ => {}));
        quote!(match #before { #(#arms)* #start #rest })
    }

    /// The transitions that are looked at when a step is active.
    fn leave_step(&self, step: StepId) -> Option<TokenStream> {
        let leaving = &self.plan.evolution.owned[step.index()];
        if leaving.is_empty() {
            return None;
        }
        Some(if self.plan.evolution.exclusive[step.index()] { self.first_of(leaving) } else { self.all_of(leaving) })
    }

    /// IEC 60848 rule 4: all that can clear do so together. An `else` asks whether another branch has cleared: each condition is
    /// evaluated once.
    fn all_of(&self, leaving: &[TransitionId]) -> TokenStream {
        let otherwise = |id: &TransitionId| self.model.transitions[*id].plain_else();
        let elses: Vec<_> = leaving.iter().filter_map(|id| Some((id, otherwise(id)?))).list();
        let declare = elses.iter().map(|(id, _)| {
            let other = names::other_branch(**id);
            quote!(let mut #other = false;)
        });
        let declare: TokenStream = declare.tokens();
        let transitions = leaving.iter().map(|id| {
            let clear = self.clear(*id);
            if otherwise(id).is_some() {
                let (other, sources) = (names::other_branch(*id), self.other_sources(&self.model.transitions[*id]));
                return quote!(if #(#sources &&)* !#other { #clear });
            }
            let notes = elses.iter().filter(|(_, others)| others.contains(id)).map(|(id, _)| names::other_branch(**id));
            self.if_enabled(*id, &quote!(#(#notes = true;)* #clear))
        });
        quote!(#declare #(#transitions)*)
    }

    /// `if … { … } else if … { … }`: in an `sfc` the order is the priority, in a `grafcet` the conditions exclude each
    /// other.
    pub(super) fn first_of(&self, leaving: &[TransitionId]) -> TokenStream {
        if leaving.len() > 1 && leaving.iter().all(|id| self.model.transitions[*id].sources.len() == 1) {
            let branches = leaving.iter().map(|id| self.a_branch(*id, self.clear(*id)));
            return self.branches(branches.list(), &TokenStream::new());
        }
        let mut chain = TokenStream::new();
        for (i, id) in leaving.iter().enumerate() {
            let clear = self.clear(*id);
            let Some(condition) = self.enabled(*id) else {
                // Always fireable: nothing after it in the chain can clear.
                chain.extend(if i == 0 { clear } else { quote!({ #clear }) });
                return chain;
            };
            chain.extend(quote!(if #condition { #clear }));
            if i + 1 < leaving.len() {
                chain.extend(quote!(else));
            }
        }
        chain
    }

    /// The condition of a transition whose first source step is active, after the other branches, with the other sources;
    /// `None` is "always".
    fn enabled(&self, id: TransitionId) -> Option<TokenStream> {
        let condition = self.condition(id).map(|condition| self.value(condition, Moment::Enabled(id)));
        let terms: Vec<_> = self.other_sources(&self.model.transitions[id]).into_iter().and(condition).list();
        (!terms.is_empty()).then(|| quote!(#(#terms)&&*))
    }

    /// Whether the sources of a transition after its first one are active.
    fn other_sources(&self, transition: &Transition) -> Vec<TokenStream> {
        transition.sources.iter().skip(1).map(|step| self.is_active(*step, Moment::Condition)).list()
    }

    fn if_enabled(&self, id: TransitionId, then: &TokenStream) -> TokenStream {
        match self.enabled(id) {
            Some(condition) => quote!(if #condition { #then }),
            None => quote!({ #then }),
        }
    }

    /// A28: transitions that compete for the sources of an AND-convergence, by priority.
    fn contest(&self, contest: &[TransitionId]) -> TokenStream {
        let mut sources: Vec<StepId> = contest.iter().flat(|id| &self.model.transitions[*id].sources).copied().list();
        sort_unstable(&mut sources);
        sources.dedup();
        let declare = sources.iter().map(|step| names::left_local(*step)).map(|left| quote!(let mut #left = false;));
        let transitions = contest.iter().map(|id| {
            let transition = &self.model.transitions[*id];
            let active = transition.sources.iter().map(|step| self.is_active(*step, Moment::Condition));
            let left: Vec<_> = transition.sources.iter().map(|step| names::left_local(*step)).list();
            // Nothing has left the sources of an `else`: none of the other branches could clear.
            let condition =
                transition.plain_else().is_none().then(|| self.value(&transition.condition, Moment::Enabled(*id)));
            let terms = active.and(left.iter().map(|left| quote!(!#left))).and(condition);
            let clear = self.clear(*id);
            quote!(if #(#terms)&&* { #(#left = true;)* #clear })
        });
        quote!(#(#declare)* #(#transitions)*)
    }

    /// Transitions without a source step are enabled always, in an enclosure while its step is active (A17).
    fn source_transitions(&self, partial: PartialId) -> TokenStream {
        let sources = self.model.partials[partial].transitions.iter();
        let sources = sources.filter(|id| self.model.transitions[**id].sources.is_empty());
        sources.map(|id| self.if_enabled(*id, &self.clear(*id))).tokens()
    }

    /// The effect of clearing a transition: on the situation, and the actions on clearing.
    pub(super) fn clear(&self, id: TransitionId) -> TokenStream {
        let transition = &self.model.transitions[id];
        let leave = transition.sources.iter().map(|source| self.leave(*source, transition));
        let mut writes: Vec<_> = leave.filter(|leave| !leave.is_empty()).list();
        for target in &transition.targets {
            let region = self.plan.regions.of_step(*target);
            if self.plan.evolution.entered_last.contains(target) {
                let enter = names::enter_local(*target);
                writes.push(quote!(#enter = true;));
            } else if transition.sources.contains(target) {
                if self.plan.sees_reentry[region] {
                    let again = names::again(region, self.plan);
                    writes.push(quote!(#again = true;));
                }
            } else {
                writes.push(self.enter(*target));
            }
            writes.push_all(self.begin_time(*target, transition));
        }
        let moved = (!writes.is_empty()).then(|| self.note_moved()).flatten();
        let below = self.below(transition);
        writes.push_all(self.overwrite_below(&below));
        let (actions, at_once) = (self.acts_on_clearing(id), self.stored_at_once(transition, &below));
        let (writes, end) = (self.few_at_a_time(&writes), self.end_below(transition.partial, &below));
        quote!(#actions #at_once #writes #moved #end)
    }

    /// Takes a source step away, unless a target takes its place in the region anyway.
    fn leave(&self, source: StepId, transition: &Transition) -> TokenStream {
        let region = self.plan.regions.of_step(source);
        let late = |step: &StepId| self.plan.evolution.entered_last.contains(step);
        let replaced = transition.targets.iter().any(|t| self.plan.regions.of_step(*t) == region && !late(t));
        let must_leave = transition.targets.contains(&source) && late(&source);
        if replaced || !must_leave && transition.targets.contains(&source) {
            return TokenStream::new();
        }
        self.leave_empty(source)
    }

    /// Steps that one transition takes away and another one gives back: activation wins (rule 5).
    fn enter_late(&self, partial: PartialId) -> TokenStream {
        let late = self.plan.evolution.entered_last.iter().filter(|step| self.model.steps[**step].partial == partial);
        late.map(|step| {
            let region = self.plan.regions.of_step(*step);
            let again = self.plan.sees_reentry[region].then(|| {
                let again = names::again(region, self.plan);
                let (was, left) = (self.in_step(At::Before, *step), self.not_in_step(At::After, *step));
                // A step that was active and not left is not activated anew.
                quote!(if #was && #left { #again = true; })
            });
            let (is_entered, enter) = (names::enter_local(*step), self.enter(*step));
            quote!(if #is_entered { #again #enter })
        })
        .tokens()
    }
}
