//! Diagnostics as tokens: errors through `compile_error!`, warnings through a deprecated constant.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};

use super::{Diagnostic, Mark, Severity};

/// The tokens that make rustc show the diagnostics at their marks.
pub(super) fn tokens(diagnostics: &[Diagnostic]) -> TokenStream {
    diagnostics.iter().map(one).collect()
}

fn one(diagnostic: &Diagnostic) -> TokenStream {
    diagnostic
        .notes
        .iter()
        .map(|(mark, message)| {
            let message = match diagnostic.rule {
                Some(rule) => format!("{message} [grafcet::{}]", rule.name),
                None => message.clone(),
            };
            match diagnostic.severity {
                Severity::Deny => error(*mark, message),
                // rustc warns of the use of a deprecated item at the tokens of the use: the only
                // warning a macro can give on stable.
                Severity::Warn => quote_spanned! {mark.start=>
                    const _: () = {
                        #[deprecated(note = #message)]
                        const GRAFCET: () = ();
                        GRAFCET
                    };
                },
                Severity::Allow => TokenStream::new(),
            }
        })
        .collect()
}

/// An error over the whole mark: `syn` spans it from the first to the last of these two tokens.
fn error(mark: Mark, message: String) -> TokenStream {
    let (start, end) = (mark.start, mark.end);
    let (first, last) = (quote_spanned!(start=> -), quote_spanned!(end=> -));
    syn::Error::new_spanned(quote!(#first #last), message).to_compile_error()
}
