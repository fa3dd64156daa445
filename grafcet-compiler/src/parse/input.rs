//! The cursor through the structure of a chart, and the cut where `syn` takes over.

use proc_macro2::{Delimiter, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::buffer::{Cursor, TokenBuffer};
use syn::parse::{ParseStream, Parser};

use super::{Error, Result};
use crate::diagnostic::Mark;

/// What is left of a body, of a group, or of the whole call. A copy looks ahead.
#[derive(Clone, Copy)]
pub(super) struct Input<'a> {
    cursor: Cursor<'a>,
    /// The token before the cursor.
    last: Span,
    /// The closing delimiter, where an unexpected end is shown.
    close: Span,
}

impl<'a> Input<'a> {
    /// All of a call.
    pub(super) fn new(buffer: &'a TokenBuffer) -> Self {
        let last = Span::call_site();
        let mut end = Self { cursor: buffer.begin(), last, close: last };
        while end.bump().is_some() {}
        Self { cursor: buffer.begin(), last, close: end.last }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.cursor.eof()
    }

    /// Whether both stand at the same token.
    pub(super) fn is_at(&self, other: &Self) -> bool {
        self.cursor == other.cursor
    }

    /// The next token's place, or that of the closing delimiter.
    pub(super) fn span(&self) -> Span {
        match self.cursor.token_tree() {
            Some((TokenTree::Group(group), _)) => group.span_open(),
            Some((tree, _)) => tree.span(),
            None => self.close,
        }
    }

    /// The place of the token before the cursor.
    pub(super) fn last(&self) -> Span {
        self.last
    }

    /// An error at the next token.
    pub(super) fn error(&self, message: impl Into<String>) -> Error {
        Error::new(self.span(), message)
    }

    /// The next token as an error message names it.
    pub(super) fn found(&self) -> String {
        match self.cursor.token_tree() {
            None => "the end".to_owned(),
            Some((TokenTree::Group(group), _)) => match group.delimiter() {
                Delimiter::Parenthesis => "`(`".to_owned(),
                Delimiter::Brace => "`{`".to_owned(),
                Delimiter::Bracket => "`[`".to_owned(),
                Delimiter::None => format!("`{group}`"),
            },
            Some((TokenTree::Punct(punct), rest)) => match rest.punct() {
                Some((next, _)) if punct.spacing() == Spacing::Joint => {
                    format!("`{}{}`", punct.as_char(), next.as_char())
                }
                _ => format!("`{punct}`"),
            },
            Some((tree, _)) => format!("`{tree}`"),
        }
    }

    /// Whether the next token stands on a later line than the last one; `false` where the toolchain does not tell.
    pub(super) fn on_new_line(&self) -> bool {
        self.span().start().line > self.last.end().line && self.last.end().line > 0
    }

    pub(super) fn tree(&self) -> Option<TokenTree> {
        self.cursor.token_tree().map(|(tree, _)| tree)
    }

    /// The next token if it is an identifier, keywords of Rust included.
    pub(super) fn ident(&self) -> Option<Ident> {
        self.cursor.ident().map(|(ident, _)| ident)
    }

    pub(super) fn literal(&self) -> Option<Literal> {
        self.cursor.literal().map(|(literal, _)| literal)
    }

    /// The next token if it is an operator's character.
    pub(super) fn punct(&self) -> Option<Punct> {
        self.cursor.punct().map(|(punct, _)| punct)
    }

    /// Whether the next token is this word.
    pub(super) fn at_word(&self, word: &str) -> bool {
        self.cursor.ident().is_some_and(|(ident, _)| ident == word)
    }

    /// Whether the next tokens are these characters, written without a gap.
    pub(super) fn at(&self, operator: &str) -> bool {
        self.behind(operator).is_some()
    }

    /// Whether a group with this delimiter is next.
    pub(super) fn at_group(&self, delimiter: Delimiter) -> bool {
        self.cursor.group(delimiter).is_some()
    }

    /// Whether `=` is next, and not `==` or `=>`.
    pub(super) fn at_assign(&self) -> bool {
        self.at("=") && !self.at("==") && !self.at("=>")
    }

    /// What follows the next token.
    pub(super) fn next(mut self) -> Self {
        self.bump();
        self
    }

    /// What follows `operator`, if it is next.
    pub(super) fn behind(mut self, operator: &str) -> Option<Self> {
        let mut left = operator.chars().count();
        for char in operator.chars() {
            left -= 1;
            let (punct, rest) = self.cursor.punct()?;
            if punct.as_char() != char || (left > 0 && punct.spacing() == Spacing::Alone) {
                return None;
            }
            (self.cursor, self.last) = (rest, punct.span());
        }
        Some(self)
    }

    /// Steps over the next token, a group as a whole.
    pub(super) fn bump(&mut self) -> Option<TokenTree> {
        let (tree, rest) = self.cursor.token_tree()?;
        self.last = match &tree {
            TokenTree::Group(group) => group.span_close(),
            other => other.span(),
        };
        self.cursor = rest;
        Some(tree)
    }

    pub(super) fn eat_ident(&mut self) -> Option<Ident> {
        let (ident, rest) = self.cursor.ident()?;
        (self.cursor, self.last) = (rest, ident.span());
        Some(ident)
    }

    pub(super) fn eat_word(&mut self, word: &str) -> Option<Span> {
        if self.at_word(word) { self.eat_ident().map(|ident| ident.span()) } else { None }
    }

    pub(super) fn eat(&mut self, operator: &str) -> Option<Mark> {
        let start = self.span();
        let rest = self.behind(operator)?;
        *self = rest;
        Some(Mark { start, end: self.last })
    }

    /// Steps over a group and gives what is in it.
    pub(super) fn enter(&mut self, delimiter: Delimiter) -> Option<Self> {
        let (inside, span, rest) = self.cursor.group(delimiter)?;
        (self.cursor, self.last) = (rest, span.close());
        Some(Self { cursor: inside, last: span.open(), close: span.close() })
    }

    /// A name that is declared or mentioned. Keywords of Rust pass: a rule refuses them with its reason.
    pub(super) fn name(&mut self, what: &str) -> Result<Ident> {
        self.eat_ident().ok_or_else(|| self.error(format!("expected {what}, found {}", self.found())))
    }

    /// Names separated by commas, up to the end.
    pub(super) fn names(&mut self, what: &str) -> Result<Vec<Ident>> {
        let mut names = Vec::new();
        while !self.is_empty() {
            names.push(self.name(what)?);
            if self.eat(",").is_none() && !self.is_empty() {
                return Err(self.error(format!("expected `,`, found {}", self.found())));
            }
        }
        Ok(names)
    }

    /// Lets `syn` parse Rust from here, and steps over what it used. What follows is the caller's.
    pub(super) fn rust<T>(&mut self, parse: impl FnOnce(ParseStream) -> syn::Result<T>) -> Result<T> {
        let mut ahead = *self;
        let mut tokens = Vec::new();
        while !ahead.at(";") {
            match ahead.bump() {
                Some(tree) => tokens.push(tree),
                None => break,
            }
        }
        self.cut(tokens, ahead.span(), parse)
    }

    /// Like [`Input::rust`], for exactly the next `count` tokens.
    pub(super) fn rust_tokens<T>(
        &mut self,
        count: usize,
        parse: impl FnOnce(ParseStream) -> syn::Result<T>,
    ) -> Result<T> {
        let mut ahead = *self;
        let tokens = (0..count).map_while(|_| ahead.bump()).collect();
        self.cut(tokens, ahead.span(), parse)
    }

    fn cut<T>(
        &mut self,
        tokens: Vec<TokenTree>,
        end: Span,
        parse: impl FnOnce(ParseStream) -> syn::Result<T>,
    ) -> Result<T> {
        let count = tokens.len();
        // With a `;` behind the piece, "unexpected end" has a place to point at.
        let mut semicolon = Punct::new(';', Spacing::Alone);
        semicolon.set_span(end);
        let tokens = tokens.into_iter().chain([semicolon.into()]).collect::<TokenStream>();
        // Draining the piece keeps `syn` from complaining about the part that is not its business.
        let counted = |input: ParseStream| Ok((parse(input)?, input.parse::<TokenStream>()?.into_iter().count()));
        let (parsed, left) = counted.parse2(tokens)?;
        for _ in 0..(count + 1).saturating_sub(left) {
            self.bump();
        }
        Ok(parsed)
    }

    /// What `from` stands before and this input behind.
    pub(super) fn since(&self, from: &Self) -> Mark {
        Mark { start: from.span(), end: self.last }
    }
}
