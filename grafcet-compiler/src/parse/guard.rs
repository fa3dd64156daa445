//! Bounds what `syn` and later passes recurse over, so that no input overflows the stack.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

use super::{Error, Result};
use crate::diagnostic::Mark;

/// How deep the recursion over a chart may get, counted in tokens that can lead one level down.
const DEPTH: usize = 1024;

/// A pair of delimiters takes several calls.
const GROUP: usize = 8;

/// Refuses groups nested more than 128 deep, and expressions of more than about a thousand tokens without `;` or `,`.
pub(super) fn check(tokens: &TokenStream) -> Result<()> {
    level(tokens.clone(), 0)
}

/// Counts the tokens since something that certainly ended the last expression, type or pattern.
#[derive(Default)]
struct Run {
    length: usize,
    /// Generic arguments or the parameters of a closure: here a comma does not end anything.
    comma_goes_on: bool,
    before: Before,
}

/// The tokens before the present one, as far as they matter.
#[derive(Default, Clone, Copy, PartialEq)]
enum Before {
    #[default]
    Other,
    Brace,
    Bracket,
    /// `]-`
    Dash,
}

fn level(tokens: TokenStream, above: usize) -> Result<()> {
    let mut run = Run::default();
    for tree in tokens {
        run.step(&tree);
        if above + run.length > DEPTH {
            let message = "this is nested too deeply, or too long for one expression; \
                declare a `var` for a part of it or move it into a function";
            let place = match &tree {
                TokenTree::Group(group) => group.span_open(),
                other => other.span(),
            };
            return Err(Error::new(Mark::from(place), message));
        }
        if let TokenTree::Group(group) = tree {
            level(group.stream(), above + run.length + GROUP - 1)?;
        }
    }
    Ok(())
}

impl Run {
    fn step(&mut self, tree: &TokenTree) {
        let before = std::mem::take(&mut self.before);
        self.length += 1;
        match tree {
            // Behind a brace only these words go on with the same expression.
            TokenTree::Ident(ident) if before == Before::Brace && ident != "else" && ident != "as" => self.end(),
            TokenTree::Ident(_) | TokenTree::Literal(_) => {}
            TokenTree::Group(group) => match group.delimiter() {
                Delimiter::Brace => self.before = Before::Brace,
                Delimiter::Bracket => self.before = Before::Bracket,
                Delimiter::Parenthesis | Delimiter::None => {}
            },
            TokenTree::Punct(punct) => match punct.as_char() {
                ';' => self.end(),
                ',' if !self.comma_goes_on => self.end(),
                '#' if before == Before::Brace => self.end(),
                '-' if before == Before::Bracket && punct.spacing() == Spacing::Joint => self.before = Before::Dash,
                // `]->` is no Rust: a link of a chain, which may be as long as it likes.
                '>' if before == Before::Dash => self.end(),
                '<' | '|' => self.comma_goes_on = true,
                _ => {}
            },
        }
    }

    fn end(&mut self) {
        *self = Self { length: 1, ..Self::default() };
    }
}
