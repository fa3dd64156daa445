//! The outputs that a cycle returns, before anything has acted on them.

use proc_macro2::TokenStream;

use super::Printer;
use crate::codegen::cleared::{self, Begins};
use crate::codegen::types;
use crate::model::{OutputId, Tree, Ty};
use crate::place::quote;
use crate::program::{Initial, Role, Value};

impl Printer<'_, '_> {
    /// The outputs as each cycle begins with them.
    pub(super) fn first_outputs(&self) -> TokenStream {
        let (name, model, p) = (&self.cx.names.outputs, self.cx.model, &self.cx.p);
        let (between, fence) = cleared::between(model, &|id| self.begins(id));
        let (mut first, mut then) = (TokenStream::new(), TokenStream::new());
        let mut mutable = None;
        for (id, output) in model.outputs.iter() {
            let (name, place) = (&output.name, self.program.place(Role::Output(id)));
            let value = match place {
                Some(place) => self.initial(place),
                None => types::initial_output(model, id, p),
            };
            if place.is_some_and(|place| self.layout.is_kept(place) || self.layout.is_result(place)) {
                mutable = Some(quote!(mut));
            }
            if between.contains(&id) {
                let other = if matches!(output.ty, Ty::Bool(_)) { quote!(true) } else { quote!(1) };
                first.extend(quote!(#name: #other,));
                then.extend(quote!(outputs_.#name = #value;));
            } else {
                first.extend(quote!(#name: #value,));
            }
        }
        let first = quote!(#name { #first });
        if let Some(fence) = fence {
            let fence = self.fence(fence);
            return quote!(let #mutable outputs_ = #first; #fence #then);
        }
        let is_plain = model.outputs.values().all(|output| output.init.is_none() && matches!(output.ty, Ty::Bool(_)));
        if model.outputs.len() > 1 && is_plain {
            quote!(let #mutable outputs_ = const { #first };)
        } else {
            quote!(let #mutable outputs_ = #first;)
        }
    }

    /// What each cycle begins with in the place of an output; it can be written once more where it is returned.
    fn begins(&self, id: OutputId) -> Begins {
        let model = self.cx.model;
        let place = self.program.place(Role::Output(id));
        let is_zero = match place.map(|place| self.program.places[place.0].initial) {
            Some(Initial::Default | Initial::Value(Value::Bool(false) | Value::Int(0) | Value::Ticks(0))) => true,
            Some(Initial::Constant(written)) => matches!(written.tree, Tree::Bool(false) | Tree::Int(0)),
            Some(Initial::Value(_)) => false,
            None => model.outputs[id].init.is_none(),
        };
        let is_number = matches!(model.outputs[id].ty, Ty::Bool(_) | Ty::Int { .. });
        let is_result = place.is_some_and(|place| self.layout.is_result(place));
        match is_zero {
            true if is_number && is_result => Begins::Cleared,
            true => Begins::Zero,
            false => Begins::Other,
        }
    }
}
