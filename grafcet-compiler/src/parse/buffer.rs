//! The tokens of a call, laid out flat so that looking ahead costs nothing.

use crate::list::List;
use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};

use super::guard::Guard;
use super::{Result, fragments};

/// All tokens of a call; the content of a group stands after the group. No group is without delimiters.
pub(super) struct Buffer(Vec<Token>);

pub(super) struct Token {
    pub(super) tree: TokenTree,
    /// The text of an identifier; asking for it each time would cost more than all the rest.
    pub(super) word: String,
    /// Where the next token on the same level stands.
    pub(super) next: usize,
    /// The delimiters of a group, or all of another token.
    pub(super) open: Span,
    pub(super) close: Span,
}

impl Buffer {
    /// Lays out the tokens, unless they are nested too deeply.
    pub(super) fn new(tokens: TokenStream) -> Result<Self> {
        let mut buffer = Self(Vec::new());
        buffer.level(tokens.clone(), Guard::new(), false)?;
        if buffer.0.iter().any(|token| token.is_group(Delimiter::None)) {
            // Nothing in them is nested too deeply, so they can be looked into. Without them it may be.
            buffer.0.clear();
            buffer.level(tokens, Guard::new(), true)?;
        }
        Ok(buffer)
    }

    /// Lays out one level and what is in it; whether groups without delimiters were opened there.
    fn level(&mut self, tokens: TokenStream, mut guard: Guard, open: bool) -> Result<bool> {
        let mut opened = open && tokens.clone().into_iter().any(|tree| is_invisible(&tree));
        let level = if opened { fragments::opened(tokens) } else { tokens.into_iter().list() };
        for tree in level {
            let at = self.0.len();
            let word = match &tree {
                TokenTree::Ident(ident) => ident.to_string(),
                _ => String::new(),
            };
            let inside = guard.step(&tree, &word)?;
            let group = match &tree {
                TokenTree::Group(group) => Some(group.clone()),
                _ => None,
            };
            let span = tree.span();
            let (open_at, close_at) =
                group.as_ref().map_or((span, span), |group| (group.span_open(), group.span_close()));
            self.0.push(Token { tree, word, next: at + 1, open: open_at, close: close_at });
            if let Some(group) = group {
                let changed = self.level(group.stream(), inside, open)?;
                self.0[at].next = self.0.len();
                if changed {
                    self.0[at].tree = self.rebuilt(at, &group);
                }
                opened |= changed;
            }
        }
        Ok(opened)
    }

    /// The group at `at` with what is laid out after it.
    fn rebuilt(&self, at: usize, group: &Group) -> TokenTree {
        let mut content = Vec::new();
        let mut inside = at + 1;
        while let Some(token) = self.0.get(inside) {
            content.push(token.tree.clone());
            inside = token.next;
        }
        let mut rebuilt = Group::new(group.delimiter(), content.into_iter().collect());
        rebuilt.set_span(group.span());
        rebuilt.into()
    }

    pub(super) fn tokens(&self) -> &[Token] {
        &self.0
    }
}

/// Whether this is the group around what a `macro_rules` macro was given.
fn is_invisible(tree: &TokenTree) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::None)
}

impl Token {
    pub(super) fn is_group(&self, delimiter: Delimiter) -> bool {
        matches!(&self.tree, TokenTree::Group(group) if group.delimiter() == delimiter)
    }
}
