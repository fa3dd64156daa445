//! Parallel branches of an `sfc` whose arms evolve and act: a way on which a transition clears does what the steps do that it enters,
//! one on which nothing clears what the step does that stays.

use std::borrow::Cow;

use proc_macro2::TokenStream;

use super::Cx;
use super::branches::Branch;
use super::in_order::Item;
use crate::list::List;
use crate::model::{StepId, TransitionId};
use crate::place::quote;
use crate::plan::{BranchGroup, RegionId};
use crate::sorted::Set;

impl Cx<'_> {
    /// The evolution of a group, with the actions of its steps. The steps in `outside` are not active here. `start` is how the first
    /// cycle enters the initial situation.
    pub(super) fn act_in_group(
        &self,
        group: &BranchGroup,
        outside: &Set<StepId>,
        start: Option<TokenStream>,
    ) -> TokenStream {
        let mut elsewhere = outside.clone();
        elsewhere.extend(group.alone.iter().map(|(step, _)| *step));
        // LLVM would look at the states of all branches in front of the first one.
        let fence = self.fence();
        let inner = group.inner.iter().map(|inner| {
            let branch = self.act_in_group(inner, &elsewhere, None);
            quote!(#branch #fence)
        });
        let mut inner = inner.tokens();
        let is_inside = |region: RegionId| group.inner.iter().any(|inner| inner.regions.contains(&region));
        let mut waiting = Vec::new();
        for region in group.regions.iter().filter(|region| !is_inside(**region)) {
            let steps = self.plan.regions.all()[*region].steps.iter().filter(|step| !elsewhere.contains(step));
            waiting.extend(
                steps.map(|step| (*region, *step, self.acts_of(&[*step]))).filter(|(.., acts)| !acts.is_empty()),
            );
        }
        // Of a branch that only goes from step to step, all steps stand in one `match`.
        let in_one =
            inner.is_empty() && group.common.is_empty() && waiting.iter().all(|(region, ..)| *region == group.head);
        let (own, behind) = if in_one { (waiting, Vec::new()) } else { (Vec::new(), waiting) };
        inner.extend(self.in_order(behind.into_iter().map(|(_, step, acts)| Item::After(step, acts))));
        let inner = group.common.iter().rev().fold(inner, |otherwise, id| {
            let (enabled, clear) = (self.enabled_in_place(*id), self.clear_and_act(*id));
            let otherwise = (!otherwise.is_empty()).then(|| quote!(else { #otherwise }));
            quote!(if #enabled { #clear } #otherwise)
        });
        let start = start.map(|enter| {
            let (start, initial) = (self.start(), self.plan.initial.iter().copied());
            let acts =
                self.acts_of(&initial.filter(|step| group.regions.contains(&self.plan.regions.of_step(*step))).list());
            quote!(#start => { #enter #acts })
        });
        if group.alone.is_empty() && own.is_empty() && start.is_none() {
            return inner;
        }
        let covered = group.alone.len() + own.len() + usize::from(start.is_some());
        let alone = group.alone.iter().map(|(step, leaving)| {
            let branches = leaving.iter().map(|id| {
                let condition = self.condition(*id).map(Cow::Borrowed);
                Branch { id: *id, condition, then: self.clear_and_act(*id) }
            });
            let (variant, body) = (self.variant(*step), self.branches(branches.list(), &self.acts_of(&[*step])));
            quote!(#variant => #body)
        });
        let own = own.iter().map(|(_, step, acts)| {
            let variant = self.variant(*step);
            quote!(#variant => { #acts })
        });
        let rest = (covered < self.states(group.head)).then(|| quote!(_ => { #inner }));
        let head = self.plain_state(group.head);
        quote!(match #head { #(#alone)* #(#own)* #start #rest })
    }

    fn clear_and_act(&self, id: TransitionId) -> TokenStream {
        let (clear, acts) = (self.clear(id), self.acts_of(&self.model.transitions[id].targets));
        quote!(#clear #acts)
    }

    /// What steps do while they are active.
    fn acts_of(&self, steps: &[StepId]) -> TokenStream {
        let associations = steps.iter().flat(|step| &self.model.steps[*step].associations);
        let acts = associations.map(|id| self.gather_local(*id).into_body());
        acts.list().into_iter().collect()
    }
}
