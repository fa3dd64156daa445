//! The stored actions of one evolution of a `grafcet`, and the calls that are due in it.
//!
//! All of them see the values from before the evolution and are committed together (A6). Places that other actions read,
//! and those that events and clearings write, are collected in locals first; the rest is written in its place.

use proc_macro2::TokenStream;

use super::bind::Moment;
use super::in_order::Item;
use super::situation::At;
use super::{Cx, names, types};
use crate::list::List;
use crate::model::{
    Association, AssociationId, Dialect, Effect, Id, Place, Qualifier, StepId, Transition, TransitionId, Trigger,
};
use crate::place::quote;
use crate::plan::{Below, is_stored, source_order};
use crate::sorted::sort_by_key;

/// When an association of a `grafcet` acts.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Instant {
    Deactivation,
    Activation,
    Event,
}

/// Which stored actions are meant.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Which {
    /// Those that write to locals, and the flags of calls that are due.
    Collected,
    /// Those that write in their place, and the calls.
    Direct,
}

impl Cx<'_> {
    /// The locals of an evolution: the values to come, and which calls are due.
    pub(super) fn declare_collected(&self) -> TokenStream {
        let places = self.plan.stored.collected.iter().map(|place| {
            let (next, field) = (names::collected(self.model, *place), names::place_field(self.model, *place));
            quote!(let mut #next = self.#field;)
        });
        let events = self.event_calls().map(|id| names::due("call", id)).map(|due| quote!(let mut #due = false;));
        let clearings = self.clearing_calls().map(|id| names::due("clearing", id.index()));
        let clearings = clearings.map(|due| quote!(let mut #due = false;));
        quote!(#(#places)* #(#events)* #(#clearings)*)
    }

    /// Stored actions that write to locals.
    pub(super) fn collect_stored(&self) -> TokenStream {
        self.stored_by_step(Which::Collected)
    }

    /// Stored actions that write in their place, and the calls that are due, in source order (A33).
    pub(super) fn do_stored(&self) -> TokenStream {
        let steps = self.stored_by_step(Which::Direct);
        let clearings = self.clearing_calls().map(|id| {
            let due = names::due("clearing", id.index());
            let calls = self.model.transitions[id].clearing.iter().filter(|effect| matches!(effect, Effect::Call(..)));
            let calls = calls.map(|effect| self.stored_effect(effect, Moment::Stored));
            quote!(if #due { #(#calls)* })
        });
        quote!(#steps #(#clearings)*)
    }

    /// Takes over what was collected.
    pub(super) fn commit_collected(&self) -> TokenStream {
        let places = self.plan.stored.collected.iter().map(|place| {
            let (next, field) = (names::collected(self.model, *place), names::place_field(self.model, *place));
            quote!(self.#field = #next;)
        });
        quote!(#(#places)*)
    }

    /// Whether the collected actions change anything, or a call is due (A25).
    pub(super) fn collected_unchanged(&self) -> Vec<TokenStream> {
        let places = self.plan.stored.collected.iter().map(|place| {
            let (next, field) = (names::collected(self.model, *place), names::place_field(self.model, *place));
            types::compare(self.model.place_ty(*place), &quote!(#next), &quote!(==), &quote!(self.#field), &self.p)
        });
        let events = self.event_calls().map(|id| names::due("call", id)).map(|due| quote!(!#due));
        let clearings = self.clearing_calls().map(|id| names::due("clearing", id.index())).map(|due| quote!(!#due));
        places.and(events).and(clearings).list()
    }

    /// The stored actions on the activation of the initial situation (A37).
    pub(super) fn initial_stored(&self) -> TokenStream {
        let actions: Vec<_> = self
            .plan
            .initial
            .iter()
            .flat(|step| &self.model.steps[*step].associations)
            .map(|id| &self.model.associations[*id])
            .filter(|association| instant(association) == Some(Instant::Activation))
            .list();
        if actions.is_empty() {
            return TokenStream::new();
        }
        let collects = actions.iter().any(|association| self.plan.stored.is_collected(&association.effect));
        let declare = collects.then(|| {
            let places = self.plan.stored.collected.iter().map(|place| {
                let (next, field) = (names::collected(self.model, *place), names::place_field(self.model, *place));
                quote!(let mut #next = self.#field;)
            });
            quote!(#(#places)*)
        });
        let commit = collects.then(|| self.commit_collected());
        // Before the activation no step asserts them.
        let combinational = self.plan.memory.combinational.iter().map(|var| names::combinational(self.model, *var));
        let combinational = combinational.map(|local| quote!(let #local = false;));
        let actions = actions.iter().map(|association| self.conditional(association, Moment::Start));
        quote!(#(#combinational)* #declare #(#actions)* #commit)
    }

    /// The actions on clearing that write, and the flag of those that call.
    pub(super) fn clearing_actions(&self, id: TransitionId) -> TokenStream {
        let effects = self.model.transitions[id].clearing.iter();
        let writes = effects.filter(|effect| !matches!(effect, Effect::Call(..)));
        let writes = writes.map(|effect| self.stored_effect(effect, Moment::Stored));
        let call = calls_on_clearing(&self.model.transitions[id]).then(|| {
            let due = names::due("clearing", id.index());
            quote!(#due = true;)
        });
        quote!(#(#writes)* #call)
    }

    /// The stored actions on what a transition leaves and enters, here and below it, which act where it clears.
    pub(super) fn stored_at_once(&self, transition: &Transition, below: &Below) -> TokenStream {
        let left = transition.sources.iter().filter(|step| !transition.targets.contains(step));
        let entered = transition.targets.iter().filter(|step| !transition.sources.contains(step));
        let left = left.map(|step| self.at_once(*step, Instant::Deactivation));
        let entered = entered.map(|step| self.at_once(*step, Instant::Activation));
        let below = below.states.iter().map(|(region, step)| {
            let left = self.plan.regions.all()[*region].steps.iter().filter(|other| Some(**other) != *step);
            let left = left.map(|other| (other, self.at_once(*other, Instant::Deactivation)));
            let left = left.filter(|(_, actions)| !actions.is_empty()).map(|(other, actions)| {
                let active = self.in_step(At::Now, *other);
                quote!(if #active { #actions })
            });
            let entered = step.and_then(|step| {
                let (actions, inactive) = (self.at_once(step, Instant::Activation), self.not_in_step(At::Now, step));
                (!actions.is_empty()).then(|| quote!(if #inactive { #actions }))
            });
            quote!(#(#left)* #entered)
        });
        quote!(#(#left)* #(#entered)* #(#below)*)
    }

    /// The actions of a step that act where a transition clears.
    fn at_once(&self, step: StepId, when: Instant) -> TokenStream {
        let actions = self.model.steps[step].associations.iter().map(|id| (*id, &self.model.associations[*id]));
        let actions = actions.filter(|(id, action)| self.acts_at_once(*id) && instant(action) == Some(when));
        actions.map(|(_, action)| self.conditional(action, Moment::Stored)).tokens()
    }

    /// Whether a stored action acts where a transition clears, and not after the evolution.
    fn acts_at_once(&self, id: AssociationId) -> bool {
        self.plan.shape.at_once.contains(&id)
    }

    fn clearing_calls(&self) -> impl Iterator<Item = TransitionId> + '_ {
        self.model.transitions.iter().filter(|(_, transition)| calls_on_clearing(transition)).map(|(id, _)| id)
    }

    /// Calls on an event, by the number of their association.
    fn event_calls(&self) -> impl Iterator<Item = usize> + '_ {
        let calls = self.model.associations.iter().filter(|(_, a)| is_event_call(a));
        calls.map(|(id, _)| id.index())
    }

    /// The stored actions of all steps in source order; where no call makes the order visible, by instant.
    fn stored_by_step(&self, which: Which) -> TokenStream {
        let mut actions: Vec<_> = source_order(self.model)
            .map(|id| (id, &self.model.associations[id]))
            .filter_map(|(id, association)| Some((instant(association)?, id, association)))
            .list();
        let calls = |(_, _, association): &(Instant, AssociationId, &Association)| {
            matches!(association.effect, Effect::Call(..))
        };
        // A forced evolution may leave and enter steps that never follow each other: of two that write one place, the last in the source counts.
        if !actions.iter().any(calls) && !self.plan.shape.given {
            sort_by_key(&mut actions, |(instant, _, _)| *instant);
        }
        self.in_order(actions.into_iter().map(|(instant, id, association)| {
            let body = self.stored_action(id, association, which);
            match instant {
                Instant::Deactivation => self.if_left(association.step, &body),
                Instant::Activation => self.if_entered(association.step, &body),
                Instant::Event => Item::Before(association.step, body),
            }
        }))
    }

    /// The part of a stored action that belongs to this pass; nothing, if it belongs to the other one.
    fn stored_action(&self, id: AssociationId, association: &Association, which: Which) -> TokenStream {
        if is_event_call(association) {
            let due = names::due("call", id.index());
            return match which {
                Which::Collected => {
                    let condition = self.stored_condition(association, Moment::Stored);
                    quote!(if #condition { #due = true; })
                }
                Which::Direct => {
                    let call = self.stored_effect(&association.effect, Moment::Stored);
                    quote!(if #due { #call })
                }
            };
        }
        if self.acts_at_once(id) {
            return TokenStream::new();
        }
        if self.plan.stored.is_collected(&association.effect) == (which == Which::Collected) {
            self.conditional(association, Moment::Stored)
        } else {
            TokenStream::new()
        }
    }

    /// A stored action under its event and condition.
    fn conditional(&self, association: &Association, moment: Moment) -> TokenStream {
        let act = match (association.qualifier, &association.effect) {
            (Qualifier::S, Effect::Control(place)) => self.store(*place, &quote!(true)),
            (Qualifier::R, Effect::Control(place)) => self.store(*place, &quote!(false)),
            (_, effect) => self.stored_effect(effect, moment),
        };
        if association.event.is_none() && association.condition.is_none() {
            return act;
        }
        let condition = self.stored_condition(association, moment);
        quote!(if #condition { #act })
    }

    fn stored_condition(&self, association: &Association, moment: Moment) -> TokenStream {
        let terms = association.event.iter().and(&association.condition).map(|expr| self.value(expr, moment));
        quote!(#(#terms)&&*)
    }

    fn stored_effect(&self, effect: &Effect, moment: Moment) -> TokenStream {
        match effect {
            Effect::Assign(place, value) => {
                let value = self.value(value, moment);
                self.store(*place, &value)
            }
            Effect::Call(action, args) => self.call(*action, &quote!(First), args, moment),
            Effect::Block(code) => self.block(code, moment, |place| self.stored_target(place)),
            Effect::Control(place) => self.store(*place, &quote!(true)),
        }
    }

    fn store(&self, place: Place, value: &TokenStream) -> TokenStream {
        let target = self.stored_target(place);
        quote!(#target = #value;)
    }

    /// Where a stored action writes a place.
    fn stored_target(&self, place: Place) -> TokenStream {
        if self.plan.stored.collected.contains(&place) {
            let next = names::collected(self.model, place);
            return quote!(#next);
        }
        let field = names::place_field(self.model, place);
        quote!(self.#field)
    }
}

fn calls_on_clearing(transition: &Transition) -> bool {
    transition.clearing.iter().any(|effect| matches!(effect, Effect::Call(..)))
}

fn is_event_call(association: &Association) -> bool {
    association.qualifier == Qualifier::On && matches!(association.effect, Effect::Call(..))
}

/// When a stored action acts; `None` for a continuous one.
fn instant(association: &Association) -> Option<Instant> {
    is_stored(association).then_some(match association.qualifier.trigger(Dialect::Grafcet) {
        Trigger::Deactivation => Instant::Deactivation,
        Trigger::Event => Instant::Event,
        Trigger::Active | Trigger::Activation => Instant::Activation,
    })
}
