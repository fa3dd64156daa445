//! `cycle` of an `sfc` (IEC 61131-3): exactly one evolution, then the actions.

use proc_macro2::TokenStream;

use super::bind::Moment;
use super::in_order::Item;
use super::situation::At;
use super::{Cx, names};
use crate::list::{List, PushAll};
use crate::model::{Association, AssociationId, Effect, Id, Place, Qualifier};
use crate::place::quote;
use crate::plan::{RegionId, Target, source_order};

impl Cx<'_> {
    /// The body of `cycle`.
    pub(super) fn sfc_cycle(&self) -> TokenStream {
        let time = self.pass_time();
        let first = self.plan.memory.asks_for_start().then(|| {
            let first = self.first();
            quote!(let first_ = #first;)
        });
        let (declare_edges, samples) = (self.declare_edges(), self.sample_all(&quote!(first_)));
        let evolve = self.evolve();
        let keep = self.keep_times();
        let commit = self.commit();
        let settle = self.settle();
        let actions = self.scan_actions();
        let result = self.result();
        // The outputs come first: after the evolution, the compiler would clear them again in every arm.
        let outputs = self.declare_outputs();
        let afters = self.plan.shape.is_in_place().then(|| {
            let (fence, afters) = (self.fence(), self.afters());
            quote!(#fence #afters)
        });
        let moved = self.declare_moved();
        let snapshot = self.snapshot();
        quote! {
            #outputs #time #first #snapshot
            #declare_edges #samples #moved #keep #evolve #commit #afters
            #settle #actions #result
        }
    }

    /// All that comes after the evolution but the outputs.
    pub(super) fn scan_actions(&self) -> TokenStream {
        let (late, actions) = (self.sample_late(), self.sfc_actions());
        quote!(#late #actions)
    }

    /// Flags and values first, then deactivations, activations and the rest (A29).
    fn sfc_actions(&self) -> TokenStream {
        let (last, resets) = (self.keep_last_outputs(), self.declare_resets());
        let holds = self.assigned_under_condition().map(names::holds);
        let resets = quote!(#resets #(let mut #holds = false;)*);
        let apply_resets = self.apply_resets();
        if self.runs_in_one_pass() {
            // Nothing but the active step's own actions: its arm does it all.
            let items = source_order(self.model).map(|id| self.gather_local(id));
            let entered = source_order(self.model).map(|id| self.local_run(id, Part::Activation));
            let rest = self.part(Part::Rest);
            let all = self.in_order(items.and(entered).and(rest));
            return quote!(#last #resets #all #apply_resets);
        }
        // Where the arms of the branches act, what is left are steps that stand in no branch.
        let acted = self.plan.groups.iter().flatten().filter(|_| self.plan.acts_in_arms);
        let acted: Vec<RegionId> = acted.flat(|group| &group.regions).copied().list();
        let left = |id: &AssociationId| {
            let step = self.model.associations[*id].step;
            !acted.contains(&self.plan.regions.of_step(step))
        };
        let local = self.in_any_order(source_order(self.model).filter(left).map(|id| self.gather_local(id)));
        let (flags, q, left) = (self.gather_flags(), self.compute_q(), self.note_leaving());
        let leaving = self.in_order(self.part(Part::Deactivation));
        let entering = self.in_order(self.part(Part::Activation));
        let rest = self.in_order(self.part(Part::Rest));
        quote!(#last #resets #local #flags #apply_resets #q #left #leaving #entering #rest)
    }

    /// One region, no action control, and nothing that leaving a step does: the order across steps does not matter.
    fn runs_in_one_pass(&self) -> bool {
        let leaves = |id: AssociationId| !self.local_run_tokens(id, Part::Deactivation).is_empty();
        self.plan.most_active == 1 && self.plan.control.targets.is_empty() && !source_order(self.model).any(leaves)
    }

    /// All runs of one part of the cycle; a target stands where its first association stands.
    fn part(&self, part: Part) -> impl Iterator<Item = Item> + '_ {
        self.by_target().into_iter().map(move |id| {
            let Some(index) = self.plan.control.of_association[id.index()] else { return self.local_run(id, part) };
            let target: &Target = &self.plan.control.targets[index];
            if target.associations.first() != Some(&id) {
                return Item::After(self.model.associations[id].step, TokenStream::new());
            }
            Item::Always(match part {
                Part::Deactivation => self.run_leaving(index, target),
                Part::Activation => self.run_entering(index, target),
                Part::Rest => self.run_rest(index, target),
            })
        })
    }

    /// All associations in source order, but those that assign one output together, where the first of them stands: they
    /// are one target (A31).
    fn by_target(&self) -> Vec<AssociationId> {
        let assigned = |id: AssociationId| {
            let association = &self.model.associations[id];
            match association.effect {
                Effect::Assign(place, _) if is_assigned(association) => Some(place),
                _ => None,
            }
        };
        let mut order: Vec<AssociationId> = Vec::new();
        for id in source_order(self.model) {
            if order.contains(&id) {
                continue;
            }
            order.push(id);
            if let Some(place) = assigned(id) {
                order
                    .push_all(source_order(self.model).filter(|other| *other != id && assigned(*other) == Some(place)));
            }
        }
        order
    }

    /// What a boolean output or an assigned output gets from its step's arm.
    pub(super) fn gather_local(&self, id: AssociationId) -> Item {
        let association = &self.model.associations[id];
        let step = association.step;
        let nothing = Item::After(step, TokenStream::new());
        if self.plan.control.of_association[id.index()].is_some() {
            return nothing;
        }
        let act = match &association.effect {
            Effect::Control(Place::Output(output))
                if association.qualifier == Qualifier::N && association.condition.is_none() =>
            {
                let local = names::output_local(self.model, *output);
                return Item::After(step, quote!(#local = true;));
            }
            Effect::Control(Place::Output(output)) => self.drive(*output, association.qualifier),
            Effect::Assign(Place::Output(_), _) if association.qualifier == Qualifier::N => {
                // Its value belongs to the rest, its condition is read before the first action runs.
                let Some(condition) = &association.condition else { return nothing };
                let (holds, condition) = (names::holds(id), self.value(condition, Moment::Action));
                return Item::After(step, quote!(#holds = #condition;));
            }
            _ => return nothing,
        };
        let act = self.under_condition(association, act);
        if association.qualifier == Qualifier::P { self.if_entered(step, &act) } else { Item::After(step, act) }
    }

    fn under_condition(&self, association: &Association, act: TokenStream) -> TokenStream {
        match self.continuous_condition(association, Moment::Action) {
            Some(condition) => quote!(if #condition { #act }),
            None => act,
        }
    }

    /// An assignment or a block that its step's arm runs.
    fn local_run(&self, id: AssociationId, part: Part) -> Item {
        let step = self.model.associations[id].step;
        let body = self.local_run_tokens(id, part);
        match part {
            // The final run of N: on a self-loop Q has no gap.
            Part::Deactivation if self.model.associations[id].qualifier == Qualifier::N => {
                let left = self.not_in_step(At::After, step);
                let body = if body.is_empty() { body } else { quote!(if #left { #body }) };
                Item::Before(step, body)
            }
            Part::Deactivation => self.if_left(step, &body),
            Part::Activation => self.if_entered(step, &body),
            Part::Rest => Item::After(step, body),
        }
    }

    /// `speed = e if c`
    fn assigned_under_condition(&self) -> impl Iterator<Item = AssociationId> + '_ {
        self.model.associations.iter().filter(|(_, a)| is_assigned(a) && a.condition.is_some()).map(|(id, _)| id)
    }

    fn local_run_tokens(&self, id: AssociationId, part: Part) -> TokenStream {
        let association = &self.model.associations[id];
        if let (Effect::Assign(Place::Output(output), value), true) = (&association.effect, is_assigned(association)) {
            if part != Part::Rest {
                return TokenStream::new();
            }
            let (local, value) = (names::output_local(self.model, *output), self.value(value, Moment::Action));
            let holds = names::holds(id);
            return match association.condition {
                Some(_) => quote!(if #holds { #local = #value; }),
                None => quote!(#local = #value;),
            };
        }
        let runs = matches!(association.effect, Effect::Assign(..) | Effect::Block(_));
        let wanted = match part {
            Part::Deactivation => matches!(association.qualifier, Qualifier::P0 | Qualifier::N),
            Part::Activation => association.qualifier == Qualifier::P1,
            Part::Rest => association.qualifier == Qualifier::N,
        };
        if !runs || !wanted || self.plan.control.of_association[id.index()].is_some() {
            return TokenStream::new();
        }
        let moment = if part == Part::Deactivation { Moment::Leaving } else { Moment::Action };
        let nothing = TokenStream::new();
        let run = if part == Part::Rest {
            self.unsettling_run(&association.effect, &nothing, moment)
        } else {
            // A step is entered or left in such a cycle.
            let (unsettle, run) = (self.unsettle(), self.effect_run(&association.effect, &nothing, moment));
            quote!(#unsettle #run)
        };
        self.under_condition(association, run)
    }

    /// Times begin where a step has been entered, and whether that has happened, or there was an edge, is noted for the next
    /// cycle: it would do the same as this one otherwise, were it not for the time.
    pub(super) fn settle(&self) -> TokenStream {
        if !self.plan.memory.time {
            return TokenStream::new();
        }
        let restart = self.restart_times();
        let edges = self.edge_names();
        if self.plan.shape.notes_moves {
            let edges = (!edges.is_empty()).then(|| self.unsettle_if(&quote!(#(#edges)||*)));
            return quote!(#restart #edges);
        }
        let regions = 0..self.plan.regions.all().len();
        let compared = if self.plan.shape.is_flags() { 0..1 } else { regions.clone() };
        let again = regions.filter(|region| self.plan.sees_reentry[*region]);
        let again: Vec<_> = again.map(|region| names::again(region, self.plan)).list();
        let changed = compared.map(|region| {
            let (before, after) = (names::before(region, self.plan), names::after(region, self.plan));
            quote!(#before != #after)
        });
        let unsettle = self.unsettle();
        // One question: where two are asked about the same, LLVM keeps the way the evolution has come as a number.
        quote!(if #(#changed)||* #(|| #again)* #(|| #edges)* { #restart #unsettle })
    }

    /// The outputs of the cycle before, where an action reads them, or they may be set and reset.
    fn keep_last_outputs(&self) -> TokenStream {
        let reads =
            |id: &crate::model::OutputId| self.plan.drives[id.index()].read_by_actions || self.is_set_and_reset(*id);
        self.model
            .outputs
            .ids()
            .filter(reads)
            .map(|id| {
                let (last, field) = (names::output_last(self.model, id), names::output_field(self.model, id));
                quote!(let #last = self.#field;)
            })
            .tokens()
    }
}

/// An output that has a value while a step is active.
fn is_assigned(association: &Association) -> bool {
    association.qualifier == Qualifier::N && matches!(association.effect, Effect::Assign(Place::Output(_), _))
}

/// The parts in which actions run (A29).
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Deactivation,
    Activation,
    Rest,
}
