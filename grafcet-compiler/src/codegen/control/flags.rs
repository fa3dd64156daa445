//! The flags of the targets: what the associations of this cycle say, and what leaving a step says.

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;

use crate::codegen::bind::Moment;
use crate::codegen::in_order::Item;
use crate::codegen::{Cx, names};
use crate::model::{Association, AssociationId, Effect, Id, Qualifier, Trigger};
use crate::place::quote;
use crate::plan::{Target, What, source_order};
use crate::sorted::Set;

/// The field that holds the number of the association that has set a flip-flop last.
pub(in crate::codegen) fn set_by(qualifier: Qualifier) -> String {
    names::flag(qualifier).replace("flag", "set_by")
}

impl Cx<'_> {
    /// The flags of all targets, their conditions read before the first action runs.
    pub(in crate::codegen) fn gather_flags(&self) -> TokenStream {
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
        let flags: Set<Qualifier> = flags.collect();
        let flags = flags.iter().map(|qualifier| {
            let flag = names::target_local(&names::flag(*qualifier), self.model, index, target);
            quote!(let mut #flag = false;)
        });
        let restarts =
            Qualifier::ALL.into_iter().filter(|qualifier| self.restarts(target, *qualifier)).map(|qualifier| {
                let restart = self.restart(index, target, qualifier);
                quote!(let mut #restart = false;)
            });
        let left = self.leavable(target).into_iter().map(|qualifier| {
            let left = self.left(index, target, qualifier);
            quote!(let mut #left = false;)
        });
        let chooses = |qualifier: &Qualifier| match qualifier {
            _ if qualifier.runs_once() => target.has(self.model, *qualifier),
            _ => target.chooses_under(self.model, *qualifier),
        };
        // Of the others the flip-flop remembers which association has set it.
        let seen_anew = |qualifier: &Qualifier| !qualifier.stores_at_once() && *qualifier != Qualifier::R;
        let choice = target.what == What::Runs && self.has_choice(target);
        let numbers = Qualifier::ALL
            .into_iter()
            .filter(|qualifier| choice && seen_anew(qualifier) && chooses(qualifier))
            .map(|qualifier| {
                let number = self.number(qualifier, index, target);
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
        let flag = names::target_local(&names::flag(association.qualifier), self.model, index, target);
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
        match association.qualifier.trigger(self.model.dialect) {
            Trigger::Deactivation => self.if_left(step, &set),
            Trigger::Activation => self.if_entered(step, &set),
            Trigger::Active | Trigger::Event => {
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

    /// The last association of a qualifier in source order that is active: a run takes the arguments of one that acts. P1, P0
    /// and R have no part in that of the others; what sets a flip-flop acts as long as that drives Q.
    fn note_number(&self, id: AssociationId, association: &Association, index: usize, target: &Target) -> TokenStream {
        let qualifier = association.qualifier;
        if target.what != What::Runs || qualifier == Qualifier::R || !self.has_choice(target) {
            return TokenStream::new();
        }
        let number = names::association_number(target, id);
        let name = self.number(qualifier, index, target);
        match qualifier {
            _ if qualifier.runs_once() => quote!(#name = #number;),
            _ if !target.chooses_under(self.model, qualifier) => TokenStream::new(),
            _ if qualifier.stores_at_once() => quote!(self.#name = #number;),
            _ => quote!(#name = #number;),
        }
    }

    /// The association under a qualifier that acts while this drives Q; and for DS, what is done when its delay is over.
    pub(super) fn number_of(&self, index: usize, target: &Target, qualifier: Qualifier) -> (TokenStream, TokenStream) {
        if !target.chooses_under(self.model, qualifier) {
            let number = target.under(self.model, qualifier).next().map(|id| names::association_number(target, id));
            return (quote!(#number), TokenStream::new());
        }
        let number = self.number(qualifier, index, target);
        match qualifier {
            Qualifier::Ds => {
                let set_by = names::target(&set_by(qualifier), self.model, index, target);
                let done = names::target_local("done_flag_ds", self.model, index, target);
                (quote!(self.#set_by), quote!(if #done { self.#set_by = #number; }))
            }
            _ if qualifier.stores_at_once() => (quote!(self.#number), TokenStream::new()),
            _ => (number.to_token_stream(), TokenStream::new()),
        }
    }

    /// What holds the number of the association that acts under a qualifier: a field where the flip-flop remembers it, else a local.
    fn number(&self, qualifier: Qualifier, index: usize, target: &Target) -> Ident {
        if qualifier.stores_at_once() {
            return names::target(&set_by(qualifier), self.model, index, target);
        }
        names::target_local(&names::flag(qualifier).replace("flag", "number"), self.model, index, target)
    }

    /// Several associations of the target give different calls.
    pub(super) fn has_choice(&self, target: &Target) -> bool {
        let runs = |id: &&AssociationId| {
            let association = &self.model.associations[**id];
            association.qualifier != Qualifier::R
                && matches!(&association.effect, Effect::Call(_, arguments) if !arguments.is_empty())
        };
        target.associations.iter().filter(runs).count() > 1
    }

    /// An association of the target under this qualifier, whose timer starts again with its step, can be re-entered (A4s).
    pub(super) fn restarts(&self, target: &Target, qualifier: Qualifier) -> bool {
        let reentered = |id| self.plan.sees_reentry[self.plan.regions.of_step(self.model.associations[id].step)];
        qualifier.restarts_with_step() && target.under(self.model, qualifier).any(reentered)
    }

    /// The local that says that such a step has been re-entered.
    pub(super) fn restart(&self, index: usize, target: &Target, qualifier: Qualifier) -> Ident {
        names::target_local(&format!("restart_{}", names::flag(qualifier)), self.model, index, target)
    }

    /// The qualifiers of the target that leaving a step can end, and a final call with them.
    pub(super) fn leavable(&self, target: &Target) -> Vec<Qualifier> {
        if target.remembers_q { target.leavable(self.model) } else { Vec::new() }
    }

    /// The local that says that a step with this qualifier has been left.
    pub(super) fn left(&self, index: usize, target: &Target, qualifier: Qualifier) -> Ident {
        names::target_local(&format!("left_{}", names::flag(qualifier)), self.model, index, target)
    }

    /// Whether the condition of an association held in the cycle before: the local, and the field.
    pub(super) fn held_before(&self, id: AssociationId, index: usize, target: &Target) -> (Ident, Ident) {
        let held = names::held(target, id);
        let before = names::target_local(&format!("before_{held}"), self.model, index, target);
        (before, names::target(&held, self.model, index, target))
    }
}
