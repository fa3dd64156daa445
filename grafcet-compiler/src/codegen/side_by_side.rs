//! Actions of parallel branches within one another: beside a step that is active alone, no branch is asked.

use proc_macro2::TokenStream;

use super::Cx;
use super::in_order::Item;
use crate::model::StepId;
use crate::place::quote;
use crate::plan::BranchGroup;

impl Cx<'_> {
    /// The actions within groups beside each other, and those in none of them, in any order.
    pub(super) fn side_by_side(&self, groups: &[BranchGroup], mut items: Vec<Item>) -> TokenStream {
        let mut tokens = TokenStream::new();
        for group in groups {
            let is_inside =
                |item: &Item| group.regions.iter().any(|region| self.region_of(item) == Some((false, *region)));
            let (inside, others) = items.into_iter().partition(is_inside);
            tokens.extend(self.within(group, inside));
            items = others;
        }
        tokens.extend(self.in_order(items));
        tokens
    }

    /// `match head { Alone => { its actions } Fork => {} _ => { what the branches do } }`
    fn within(&self, group: &BranchGroup, items: Vec<Item>) -> TokenStream {
        let is_alone = |step: &StepId| group.alone.iter().any(|(alone, _)| alone == step);
        let (mut alone, branches): (Vec<_>, Vec<_>) =
            items.into_iter().partition(|item| matches!(item, Item::After(step, _) if is_alone(step)));
        let branches = self.side_by_side(&group.inner, branches);
        if branches.is_empty() || group.alone.is_empty() {
            let alone = self.in_order(alone);
            return quote!(#alone #branches);
        }
        let (mut arms, mut idle) = (TokenStream::new(), Vec::new());
        for (step, _) in &group.alone {
            let of_step = |item: &Item| matches!(item, Item::After(other, _) if other == step);
            let (own, others): (Vec<_>, Vec<_>) = alone.into_iter().partition(of_step);
            alone = others;
            let variant = self.variant(*step);
            if own.is_empty() {
                idle.push(variant);
                continue;
            }
            let bodies = own.into_iter().map(Item::into_body);
            arms.extend(quote!(#variant => { #(#bodies)* }));
        }
        let idle = (!idle.is_empty()).then(|| quote!(#(#idle)|* => {}));
        let head = self.state_after(group.head);
        quote!(match #head { #arms #idle _ => { #branches } })
    }
}
