//! An evolution of parallel branches that changes the situation in place: a state is read where it is used, and written
//! where a transition clears. The situation before the evolution is kept only where something looks at it later.

use proc_macro2::TokenStream;

use super::bind::Moment;
use super::situation::At;
use super::{Cx, names};
use crate::list::List;
use crate::model::{PartialId, TransitionId};
use crate::place::quote;
use crate::plan::{BranchGroup, RegionId};
use crate::sorted::Set;

impl Cx<'_> {
    /// An `sfc` only wants to know for `next_deadline`.
    pub(super) fn declare_moved(&self) -> Option<TokenStream> {
        if self.model.is_grafcet() {
            return self.plan.shape.notes_moves.then(|| quote!(let mut moved_ = false;));
        }
        self.assume_settled()
    }

    pub(super) fn note_moved(&self) -> Option<TokenStream> {
        if self.model.is_grafcet() {
            return self.plan.shape.notes_moves.then(|| quote!(moved_ = true;));
        }
        self.plan.shape.notes_moves.then(|| self.unsettle()).flatten()
    }

    /// A step is left and entered at once: the state before does not tell.
    pub(super) fn note_reentry(&self) -> Option<TokenStream> {
        self.note_moved()
    }

    /// `state` is that of the region after the evolution.
    pub(super) fn enter_state(&self, region: RegionId, state: &TokenStream) -> TokenStream {
        if self.plan.shape.is_in_place() {
            return self.set_state(region, state);
        }
        let after = names::after(region, self.plan);
        quote!(#after = #state;)
    }

    /// Writes to many regions: from four neighbours on, LLVM calls `memset` on a processor without unaligned stores.
    pub(super) fn few_at_a_time(&self, writes: &[TokenStream]) -> TokenStream {
        let fence = self.plan.shape.is_in_place().then(|| self.fence());
        let mut groups = writes.chunks(3);
        let first: TokenStream = groups.next().into_iter().flatten().cloned().tokens();
        let rest = groups.map(|group| quote!(#fence #(#group)*));
        quote!(#first #(#rest)*)
    }

    /// The evolution of a partial grafcet in place.
    pub(super) fn evolve_in_place(&self, partial: PartialId) -> TokenStream {
        let here = |group: &&BranchGroup| self.plan.regions.all()[group.head].partial == partial;
        let groups: Vec<_> = self.plan.groups.iter().flatten().filter(here).list();
        // A27: the first cycle of an `sfc` enters the initial situation and evaluates no transition.
        let start = (!self.model.is_grafcet()).then(|| {
            let (enter, moved) = (self.enter_initial(), self.note_moved());
            (self.start(), quote!({ #enter #moved }))
        });
        match (&groups[..], start) {
            ([group], Some((_, enter))) if self.plan.acts_in_arms => self.act_in_group(group, &Set::new(), Some(enter)),
            ([group], Some((start, enter))) if group.head == 0 => self.group(group, Some(&quote!(#start => #enter))),
            (groups, Some((_, enter))) => {
                let (starting, evolve) =
                    (self.is_starting(At::Now), groups.iter().map(|group| self.group(group, None)));
                quote!(if #starting #enter else { #(#evolve)* })
            }
            (groups, None) => groups.iter().map(|group| self.group(group, None)).tokens(),
        }
    }

    /// `match` on the head for the steps that are active alone, with what happens beside them after it.
    fn group(&self, group: &BranchGroup, start: Option<&TokenStream>) -> TokenStream {
        let inner: TokenStream = group.inner.iter().map(|inner| self.group(inner, None)).tokens();
        let inner = group.common.iter().rev().fold(inner, |otherwise, id| {
            let (enabled, clear) = (self.enabled_in_place(*id), self.clear(*id));
            let otherwise = (!otherwise.is_empty()).then(|| quote!(else { #otherwise }));
            quote!(if #enabled { #clear } #otherwise)
        });
        if group.alone.is_empty() && start.is_none() {
            return inner;
        }
        if let (Some(branch), None) = (self.branch(group), &start) {
            return branch;
        }
        let arms = group.alone.iter().map(|(step, leaving)| {
            let (variant, body) = (self.variant(*step), self.first_of(leaving));
            quote!(#variant => { #body })
        });
        let covered = group.alone.len() + usize::from(start.is_some());
        let rest = (covered < self.states(group.head)).then(|| quote!(_ => { #inner }));
        let head = self.plain_state(group.head);
        quote!(match #head { #(#arms)* #start #rest })
    }

    /// `self.region_1 = match self.region_1 { Fill => if … { Heat } else { Fill }, … };` for a branch that only goes from
    /// step to step: next states that are constants need no jump for each.
    fn branch(&self, group: &BranchGroup) -> Option<TokenStream> {
        let only_steps = |id: &TransitionId| {
            let transition = &self.model.transitions[*id];
            let one = transition.targets.len() == 1 && transition.sources != transition.targets;
            one && transition.clearing.is_empty()
        };
        let whole = group.regions.len() == 1 && group.alone.iter().all(|(_, leaving)| leaving.iter().all(only_steps));
        // In a search most branches wait: a jump that writes nothing is the shorter way.
        if !whole || self.plan.shape.notes_moves {
            return None;
        }
        let arms = group.alone.iter().map(|(step, _)| {
            let (state, target) = (self.variant(*step), self.next_step(*step));
            quote!(#state => #target,)
        });
        let rest = (group.alone.len() < self.states(group.head)).then(|| quote!(waiting_ => waiting_,));
        let head = self.plain_state(group.head);
        Some(self.set_state(group.head, &quote!(match #head { #(#arms)* #rest })))
    }

    /// The condition of a transition whose regions have not been changed yet, after the other branches of its steps.
    pub(super) fn enabled_in_place(&self, id: TransitionId) -> TokenStream {
        let transition = &self.model.transitions[id];
        let sources = transition.sources.iter().map(|step| self.in_step(At::Now, *step));
        let condition = self.condition(id).map(|condition| self.value(condition, Moment::Enabled(id)));
        let terms: Vec<_> = sources.and(condition).list();
        quote!(#(#terms)&&*)
    }

    /// `let after_1 = self.situation_1;`: the situation after the evolution, of which not all is looked at.
    pub(super) fn afters(&self) -> TokenStream {
        let after = |region| {
            let (after, state) = (names::after(region, self.plan), self.plain_state(region));
            quote!(#[allow(unused_variables)] let #after = #state;)
        };
        (0..self.plan.regions.all().len()).map(after).tokens()
    }
}
