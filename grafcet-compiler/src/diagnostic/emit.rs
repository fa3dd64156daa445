//! Diagnostics as tokens: errors through `compile_error!`, warnings through a deprecated constant.

use crate::list::List;
use proc_macro2::{Delimiter, Group, Ident, TokenStream};
use quote::{quote, quote_spanned};

use super::{Diagnostic, Mark, Rule, Severity};

/// The tokens that make rustc show the diagnostics at their marks.
pub(super) fn tokens(diagnostics: &[Diagnostic], root: &TokenStream) -> TokenStream {
    diagnostics.iter().map(|diagnostic| one(diagnostic, root)).tokens()
}

fn one(diagnostic: &Diagnostic, root: &TokenStream) -> TokenStream {
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
                Severity::Deny => error(*mark, &message, root),
                Severity::Warn => warning(*mark, diagnostic.rule, &message),
                Severity::Allow => TokenStream::new(),
            }
        })
        .tokens()
}

/// An error over the whole mark: rustc shows the call of a macro from its first to its last token.
///
/// Since 2018, `::core` leads to the macro past every name of the user; in the edition 2015 there is no such path. Which
/// edition it is only rustc knows, by the place of `async`.
fn error(mark: Mark, message: &str, root: &TokenStream) -> TokenStream {
    let edition = quote_spanned!(mark.start=> async);
    let path = quote_spanned!(mark.start=> ::core::);
    let call = quote_spanned!(mark.start=> compile_error!);
    let mut message = Group::new(Delimiter::Brace, quote!(#message));
    message.set_span(mark.end);
    quote!(#root::__private::by_edition! { #edition [#path] #call #message })
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
