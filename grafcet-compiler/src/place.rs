//! Where rustc shows what it has to say about code that nobody wrote: at the chart's keyword, `sfc` or `grafcet`.
//!
//! Tokens of a macro stand at its call, unless they are told otherwise, and rustc would underline the whole chart. The keyword, and
//! not the chart's name, as editors ask the code at a name what it means. The place is that of the chart which is being compiled: every
//! token of ours needs it, and nothing depends on it but messages.

use std::cell::Cell;

use proc_macro2::{Ident, Span, TokenStream, TokenTree};

use crate::list::List;
pub(crate) use crate::quoted::quote;

thread_local! {
    static KEYWORD: Cell<Option<Span>> = const { Cell::new(None) };
}

/// As long as it lives, tokens stand at a keyword.
pub(crate) struct AtKeyword(());

impl AtKeyword {
    pub(crate) fn at(keyword: Span) -> Self {
        KEYWORD.set(Some(keyword));
        Self(())
    }
}

impl Drop for AtKeyword {
    fn drop(&mut self) {
        KEYWORD.set(None);
    }
}

/// What names mean at the call of the macro.
pub(crate) fn here() -> Span {
    located(Span::call_site())
}

/// The same for names of ours: no token of the user can mean them.
pub(crate) fn mixed() -> Span {
    located(Span::mixed_site())
}

/// What names mean at the call of the macro, at a token of the user: `pub` of a field at its name.
pub(crate) fn near(token: Span) -> Span {
    Span::call_site().located_at(token)
}

/// `struct MotorStep { … }` at the name of its chart, and not at the keyword: what rustc says of an item as a whole, as that there are two of
/// the name, stands there.
pub(crate) fn item(keyword: &str, name: &Ident, chart: &Ident, body: &TokenStream) -> TokenStream {
    let at = near(chart.span());
    let keyword = Ident::new(keyword, at);
    quote::quote_spanned!(at=> #keyword #name { #body })
}

fn located(span: Span) -> Span {
    KEYWORD.get().map_or(span, |keyword| span.located_at(keyword))
}

/// Tokens from elsewhere, such as the path of the facade, which mean what they meant.
pub(crate) fn moved(tokens: &TokenStream) -> TokenStream {
    let moved = |mut tree: TokenTree| {
        tree.set_span(located(tree.span()));
        tree
    };
    tokens.clone().into_iter().map(moved).map(TokenStream::from).tokens()
}
