//! `next_deadline`: until when nothing happens, unless an input changes.

use proc_macro2::TokenStream;

use super::Cx;
use super::machine::{Deadline, Machine};
use crate::place::quote;

/// The method, where the chart uses time.
pub(super) fn method(cx: &Cx<'_>, machine: &Machine<'_>) -> Option<TokenStream> {
    let (vis, p) = (&cx.model.vis, &cx.p);
    let Deadline { at_once, waits, reading, from } = machine.deadline.as_ref()?;
    let soonest = match from {
        None => quote!(soonest_),
        Some(from) => quote! {
            match soonest_ {
                #p::Option::Some(time_) => #p::Option::Some(#from.after(time_)),
                #p::Option::None => #p::Option::None,
            }
        },
    };
    Some(quote! {
        /// The reading of the clock before which nothing changes unless an input does (or the recipe): a controller
        /// that sleeps until then behaves like one that scans all the time. The reading of the last cycle means
        /// "scan again at once"; `None` means "only an input can change anything".
        #[must_use]
        #vis fn next_deadline(&self) -> #p::Option<#p::Ticks> {
            if #at_once {
                return #p::Option::Some(#reading);
            }
            let mut soonest_ = #p::Option::None;
            #waits
            #soonest
        }
    })
}
