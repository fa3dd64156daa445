//! `late_steps`: which steps take longer than `within` says.

use proc_macro2::TokenStream;

use super::Cx;
use super::machine::Machine;
use super::state::step_name;
use crate::list::List;
use crate::model::Id;
use crate::place::quote;

/// The method, where a step has such a time.
pub(super) fn method(cx: &Cx<'_>, machine: &Machine<'_>) -> Option<TokenStream> {
    let (vis, p, name) = (&cx.model.vis, &cx.p, &cx.names.step);
    let each = machine.late.iter().map(|(id, over)| {
        let (active, step) = (&machine.active[id.index()], step_name(cx, *id));
        quote!(if (#active) && #over { #p::Option::Some(#step) } else { #p::Option::None })
    });
    let each = each.list();
    (!each.is_empty()).then(|| {
        quote! {
            /// The steps that are late: active for longer than `within` lets them, as the last cycle has seen it; in the
            /// order of their declaration.
            #vis fn late_steps(&self) -> impl #p::core::iter::Iterator<Item = #name> + '_ {
                #p::core::iter::Iterator::flatten(#p::core::iter::IntoIterator::into_iter([#(#each),*]))
            }
        }
    })
}
