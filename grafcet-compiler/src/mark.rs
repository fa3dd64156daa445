//! A place in the source.

use proc_macro2::{Span, TokenTree};
use quote::ToTokens;

/// The tokens an error points at, from the first to the last.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// The first token.
    pub start: Span,
    /// The last token.
    pub end: Span,
}

impl Mark {
    /// All of `tokens`.
    pub fn of(tokens: impl ToTokens) -> Self {
        let mut tokens = tokens.into_token_stream().into_iter();
        let Some(first) = tokens.next() else {
            return Self::from(Span::call_site());
        };
        let open = |tree: &TokenTree| match tree {
            TokenTree::Group(group) => group.span_open(),
            other => other.span(),
        };
        let close = |tree: &TokenTree| match tree {
            TokenTree::Group(group) => group.span_close(),
            other => other.span(),
        };
        let start = open(&first);
        let end = close(&tokens.last().unwrap_or(first));
        Self { start, end }
    }

    /// From the beginning of this mark to the end of another.
    #[must_use]
    pub fn to(self, end: impl Into<Self>) -> Self {
        Self { start: self.start, end: end.into().end }
    }

    /// Line and column of the beginning, for sorting; (0, 0) where the toolchain does not tell.
    #[must_use]
    pub(crate) fn position(&self) -> (usize, usize) {
        let start = self.start.start();
        (start.line, start.column)
    }

    /// Tells marks apart, also where the toolchain gives no positions. It says nothing about their order.
    #[must_use]
    pub(crate) fn key(&self) -> String {
        format!("{:?} {:?}", self.start, self.end)
    }
}

impl From<Span> for Mark {
    fn from(span: Span) -> Self {
        Self { start: span, end: span }
    }
}

impl From<&syn::Ident> for Mark {
    fn from(ident: &syn::Ident) -> Self {
        ident.span().into()
    }
}
