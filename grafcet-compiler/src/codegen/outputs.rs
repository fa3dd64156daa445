//! Outputs: what is collected in a cycle, what is remembered, what is returned.

use proc_macro2::TokenStream;

use super::bind::Moment;
use super::{Cx, names, types};
use crate::list::List;
use crate::model::{Association, Id, OutputId, Qualifier};
use crate::place::quote;

impl Cx<'_> {
    /// The outputs to be returned, with their initial values.
    pub(super) fn declare_outputs(&self) -> TokenStream {
        let outputs = &self.names.outputs;
        let mutable = self.model.outputs.ids().any(|id| {
            let drive = &self.plan.drives[id.index()];
            drive.continuous || drive.stored
        });
        let mutable = mutable.then(|| quote!(mut));
        let fields = self.model.outputs.iter().map(|(id, output)| {
            let (name, value) = (&output.name, types::initial_output(self.model, id, &self.p));
            quote!(#name: #value,)
        });
        quote!(let #mutable outputs_ = #outputs { #(#fields)* };)
    }

    /// A boolean output under a qualifier.
    pub(super) fn drive(&self, output: OutputId, qualifier: Qualifier) -> TokenStream {
        let field = names::output_field(self.model, output);
        match qualifier {
            Qualifier::S => {
                let alone = !self.plan.drives[output.index()].reset_flag;
                let unsettle = alone.then(|| self.unsettle_read(output, &quote!(!self.#field)));
                quote!(#unsettle self.#field = true;)
            }
            Qualifier::R if self.plan.drives[output.index()].reset_flag => {
                let reset = names::output_reset(self.model, output);
                quote!(#reset = true;)
            }
            Qualifier::R => {
                let unsettle = self.unsettle_read(output, &quote!(self.#field));
                quote!(#unsettle self.#field = false;)
            }
            _ => {
                let local = names::output_local(self.model, output);
                quote!(#local = true;)
            }
        }
    }

    /// After `if`, and what L and D of one step mean: `q if !(t/Step)` and `q if t/Step` (A32).
    pub(super) fn continuous_condition(&self, association: &Association, moment: Moment) -> Option<TokenStream> {
        let limit = association.time.map(|time| match (moment, association.qualifier) {
            // In the arm of its step, after the evolution.
            (Moment::Action, qualifier) => {
                let since = self.counted(self.plan.regions.of_step(association.step));
                let time = self.time(time);
                if qualifier == Qualifier::L { quote!(#since < #time) } else { quote!(#since >= #time) }
            }
            (_, Qualifier::L) => {
                let elapsed = self.elapsed(time, association.step, moment);
                quote!(!#elapsed)
            }
            _ => self.elapsed(time, association.step, moment),
        });
        let condition = association.condition.as_ref().map(|condition| self.value(condition, moment));
        let terms: Vec<_> = limit.into_iter().and(condition).list();
        (!terms.is_empty()).then(|| quote!(#(#terms)&&*))
    }

    /// The flags of resets that come after everything that sets.
    pub(super) fn declare_resets(&self) -> TokenStream {
        self.reset_outputs().map(|id| names::output_reset(self.model, id)).map(|r| quote!(let mut #r = false;)).tokens()
    }

    /// Reset dominates.
    pub(super) fn apply_resets(&self) -> TokenStream {
        self.reset_outputs()
            .map(|id| {
                let drive = &self.plan.drives[id.index()];
                let reset = names::output_reset(self.model, id);
                let (field, local) = (names::output_field(self.model, id), names::output_local(self.model, id));
                let stored = drive.stored.then(|| quote!(self.#field = false;));
                let continuous = drive.continuous.then(|| quote!(#local = false;));
                let changed = self.is_set_and_reset(id).then(|| {
                    let last = names::output_last(self.model, id);
                    self.unsettle_if(&quote!(self.#field != #last))
                });
                quote!(if #reset { #stored #continuous } #changed)
            })
            .tokens()
    }

    /// Whether it tells the next cycle something, and one cycle may set and reset it: what it was before all of that tells whether it has
    /// changed.
    pub(super) fn is_set_and_reset(&self, output: OutputId) -> bool {
        let drive = &self.plan.drives[output.index()];
        drive.read && drive.stored && drive.reset_flag && self.unsettle().is_some()
    }

    /// A stored output that others read has changed.
    fn unsettle_read(&self, output: OutputId, change: &TokenStream) -> Option<TokenStream> {
        self.plan.drives[output.index()].read.then(|| self.unsettle_if(change)).flatten()
    }

    fn reset_outputs(&self) -> impl Iterator<Item = OutputId> + '_ {
        self.model.outputs.ids().filter(|id| self.plan.drives[id.index()].reset_flag)
    }

    /// The outputs `cycle` returns.
    pub(super) fn result(&self) -> TokenStream {
        let stored = self.plan.memory.stored.iter().map(|id| {
            let (local, field) = (names::output_local(self.model, *id), names::output_field(self.model, *id));
            let set = self.plan.drives[id.index()].continuous.then(|| quote!(#local ||));
            quote!(#local = #set self.#field;)
        });
        let remember = self.plan.memory.last.iter().map(|id| {
            let (field, local) = (names::output_last_field(self.model, *id), names::output_local(self.model, *id));
            let changed =
                types::compare(&self.model.outputs[*id].ty, &quote!(self.#field), &quote!(!=), &local, &self.p);
            let unsettle = self.unsettle_if(&changed);
            quote!(#unsettle self.#field = #local;)
        });
        quote!(#(#stored)* #(#remember)* outputs_)
    }
}
