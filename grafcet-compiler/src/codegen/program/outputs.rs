//! The outputs that a cycle returns, before anything has acted on them.

use proc_macro2::TokenStream;

use super::Printer;
use crate::codegen::{cleared, types};
use crate::model::{OutputId, Ty};
use crate::place::quote;
use crate::program::{Initial, Role, Value};

impl Printer<'_, '_> {
    /// The outputs as each cycle begins with them.
    pub(super) fn first_outputs(&self) -> TokenStream {
        let (name, model, p) = (&self.cx.names.outputs, self.cx.model, &self.cx.p);
        let mut between = cleared::between(model);
        between.retain(|id| self.is_cleared(*id));
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
        if !between.is_empty() {
            let fence = self.fence();
            return quote!(let #mutable outputs_ = #first; #fence #then);
        }
        let is_plain = model.outputs.values().all(|output| output.init.is_none() && matches!(output.ty, Ty::Bool(_)));
        if model.outputs.len() > 1 && is_plain {
            quote!(let #mutable outputs_ = const { #first };)
        } else {
            quote!(let #mutable outputs_ = #first;)
        }
    }

    /// Whether each cycle begins with the output as zero, and writes it where it is returned.
    fn is_cleared(&self, id: OutputId) -> bool {
        let is_number = matches!(self.cx.model.outputs[id].ty, Ty::Bool(_) | Ty::Int { .. });
        let place = self.program.place(Role::Output(id)).filter(|place| is_number && self.layout.is_result(*place));
        let initial = place.map(|place| self.program.places[place.0].initial);
        matches!(initial, Some(Initial::Default | Initial::Value(Value::Bool(false))))
    }
}
