//! Diagnostics as tokens: errors through `compile_error!`, warnings through a deprecated constant.

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

use super::{Diagnostic, Mark, Rule, Severity};

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
                // A table stands below the sentence.
                Some(rule) => match message.split_once('\n') {
                    Some((sentence, table)) => format!("{sentence} [grafcet::{}]\n{table}", rule.name),
                    None => format!("{message} [grafcet::{}]", rule.name),
                },
                None => message.clone(),
            };
            match diagnostic.severity {
                Severity::Deny => error(*mark, message),
                Severity::Warn => warning(*mark, diagnostic.rule, &message),
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

/// rustc warns of the use of a deprecated item at the tokens of the use: the only warning a macro can give on stable.
/// The use is a path of two names, so that it reaches from the first token to the last.
fn warning(mark: Mark, rule: Option<&Rule>, message: &str) -> TokenStream {
    let module = Ident::new("grafcet", mark.start);
    let name = Ident::new(rule.map_or("notation", |rule| rule.name), mark.end);
    quote! {
        const _: () = {
            mod #module {
                #[deprecated(note = #message)]
                #[allow(non_upper_case_globals)]
                pub(super) const #name: () = ();
            }
            #module::#name
        };
    }
}
