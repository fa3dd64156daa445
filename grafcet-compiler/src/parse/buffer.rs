//! The tokens of a call, laid out flat so that looking ahead costs nothing.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

use super::Result;
use super::guard::Guard;

/// All tokens of a call; the content of a group stands behind the group.
pub(super) struct Buffer(Vec<Token>);

pub(super) struct Token {
    pub(super) tree: TokenTree,
    /// The text of an identifier; asking for it each time would cost more than all the rest.
    pub(super) word: String,
    /// Where the next token on the same level stands.
    pub(super) behind: usize,
}

impl Buffer {
    /// Lays out the tokens, unless they are nested too deeply.
    pub(super) fn new(tokens: TokenStream) -> Result<Self> {
        let mut buffer = Self(Vec::new());
        buffer.level(tokens, Guard::new())?;
        Ok(buffer)
    }

    fn level(&mut self, tokens: TokenStream, mut guard: Guard) -> Result<()> {
        for tree in tokens {
            let at = self.0.len();
            let word = match &tree {
                TokenTree::Ident(ident) => ident.to_string(),
                _ => String::new(),
            };
            let inside = guard.step(&tree, &word)?;
            let content = match &tree {
                TokenTree::Group(group) => Some(group.stream()),
                _ => None,
            };
            self.0.push(Token { tree, word, behind: at + 1 });
            if let Some(content) = content {
                self.level(content, inside)?;
                self.0[at].behind = self.0.len();
            }
        }
        Ok(())
    }

    pub(super) fn tokens(&self) -> &[Token] {
        &self.0
    }
}

impl Token {
    /// Whether this is the invisible group around what a `macro_rules` macro passed on.
    pub(super) fn is_invisible(&self) -> bool {
        self.is_group(Delimiter::None)
    }

    pub(super) fn is_group(&self, delimiter: Delimiter) -> bool {
        matches!(&self.tree, TokenTree::Group(group) if group.delimiter() == delimiter)
    }

    pub(super) fn open(&self) -> Span {
        match &self.tree {
            TokenTree::Group(group) => group.span_open(),
            other => other.span(),
        }
    }

    pub(super) fn close(&self) -> Span {
        match &self.tree {
            TokenTree::Group(group) => group.span_close(),
            other => other.span(),
        }
    }
}
