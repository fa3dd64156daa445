//! The cursor through the structure of a chart, and the cut where `syn` takes over.

use proc_macro2::{Delimiter, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::TokenStreamExt;
use syn::parse::{ParseStream, Parser};

use super::buffer::{Buffer, Token};
use super::{Error, Result, attrs, refused, words};
use crate::diagnostic::Mark;

/// What is left of a body, of a group, or of the whole call. A copy looks ahead.
#[derive(Clone, Copy)]
pub(super) struct Input<'a> {
    tokens: &'a [Token],
    at: usize,
    end: usize,
    /// The group this is the inside of.
    group: Option<usize>,
    /// The token before `at`; none at the beginning.
    last: Option<usize>,
}

/// The turns of a loop over tokens, which ends where a turn has not moved the cursor: none can turn for ever.
#[derive(Default)]
pub(super) struct Turns(Option<usize>);

impl Turns {
    /// Whether there are more tokens, and the last turn has moved on.
    pub(super) fn more(&mut self, input: &Input) -> bool {
        let last = self.0.replace(input.at);
        !input.is_empty() && last != Some(input.at)
    }
}

impl<'a> Input<'a> {
    /// All of a call.
    pub(super) fn new(buffer: &'a Buffer) -> Self {
        let tokens = buffer.tokens();
        Self { tokens, at: 0, end: tokens.len(), group: None, last: None }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.at >= self.end
    }

    /// Whether both stand at the same token.
    pub(super) fn is_at(&self, other: &Self) -> bool {
        self.at == other.at
    }

    /// One for each token of the call, which stands before it.
    pub(super) fn everywhere(&self) -> impl Iterator<Item = Self> + use<'a> {
        let tokens = self.tokens;
        (0..tokens.len()).map(move |at| Self { tokens, at, end: tokens.len(), group: None, last: None })
    }

    fn token(&self) -> Option<&'a Token> {
        self.tokens[..self.end].get(self.at)
    }

    /// Steps over the token at `at`.
    fn step(&mut self, at: usize) {
        self.last = Some(at);
        self.at = self.tokens[at].next;
    }

    /// The next token's place, or that of the closing delimiter.
    pub(super) fn span(&self) -> Span {
        match (self.token(), self.group) {
            (Some(token), _) => token.open,
            (None, Some(group)) => self.tokens[group].close,
            (None, None) => self.last(),
        }
    }

    /// The place of the token before the cursor.
    pub(super) fn last(&self) -> Span {
        match (self.last, self.group) {
            (Some(last), _) => self.tokens[last].close,
            (None, Some(group)) => self.tokens[group].open,
            (None, None) => Span::call_site(),
        }
    }

    /// An error at the next token.
    pub(super) fn error(&self, message: impl Into<String>) -> Error {
        Error::new(self.span(), message)
    }

    /// The next token as an error message names it.
    pub(super) fn found(&self) -> String {
        let Some(token) = self.token() else { return "the end".to_owned() };
        match &token.tree {
            TokenTree::Group(group) => match group.delimiter() {
                Delimiter::Parenthesis => "`(`".to_owned(),
                Delimiter::Brace => "`{`".to_owned(),
                Delimiter::Bracket => "`[`".to_owned(),
                Delimiter::None => "nothing".to_owned(),
            },
            TokenTree::Punct(punct) => match self.next().punct() {
                Some(next) if punct.spacing() == Spacing::Joint => format!("`{}{}`", punct.as_char(), next.as_char()),
                _ => format!("`{punct}`"),
            },
            tree => format!("`{tree}`"),
        }
    }

    /// Whether the next token stands on a later line than the last one; `false` where the toolchain does not tell.
    pub(super) fn on_new_line(&self) -> bool {
        let last = self.last().end().line;
        last > 0 && self.span().start().line > last
    }

    /// The delimiter of the next token if it is a group.
    pub(super) fn delimiter(&self) -> Option<Delimiter> {
        match &self.token()?.tree {
            TokenTree::Group(group) => Some(group.delimiter()),
            _ => None,
        }
    }

    /// The next token if it is an identifier, keywords of Rust included.
    pub(super) fn word(&self) -> Option<&'a str> {
        self.token().filter(|token| matches!(token.tree, TokenTree::Ident(_))).map(|token| token.word.as_str())
    }

    pub(super) fn literal(&self) -> Option<&'a Literal> {
        match &self.token()?.tree {
            TokenTree::Literal(literal) => Some(literal),
            _ => None,
        }
    }

    /// The next token if it is an operator's character.
    pub(super) fn punct(&self) -> Option<&'a Punct> {
        match &self.token()?.tree {
            TokenTree::Punct(punct) => Some(punct),
            _ => None,
        }
    }

    /// Whether the next token is this word.
    pub(super) fn at_word(&self, word: &str) -> bool {
        self.word() == Some(word)
    }

    /// Whether a name can be next that goes on with the line: `q if c` ends in front of `if`.
    pub(super) fn at_name(&self) -> bool {
        self.word().is_some_and(|word| word != "if")
    }

    /// Whether the next tokens are these characters, written without a gap.
    pub(super) fn at(&self, operator: &str) -> bool {
        self.after(operator).is_some()
    }

    /// Whether a group with this delimiter is next.
    pub(super) fn at_group(&self, delimiter: Delimiter) -> bool {
        self.token().is_some_and(|token| token.is_group(delimiter))
    }

    /// Whether an attribute is next.
    pub(super) fn at_attribute(&self) -> bool {
        self.at("#") && self.next().at_group(Delimiter::Bracket)
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
    pub(super) fn after(mut self, operator: &str) -> Option<Self> {
        let mut chars = operator.chars().peekable();
        while let Some(char) = chars.next() {
            let punct = self.punct()?;
            if punct.as_char() != char || (chars.peek().is_some() && punct.spacing() == Spacing::Alone) {
                return None;
            }
            self.bump();
        }
        Some(self)
    }

    /// Steps over the next token, a group as a whole; `false` at the end.
    pub(super) fn bump(&mut self) -> bool {
        let more = !self.is_empty();
        if more {
            self.step(self.at);
        }
        more
    }

    pub(super) fn eat_ident(&mut self) -> Option<Ident> {
        let TokenTree::Ident(ident) = &self.token()?.tree else { return None };
        self.bump();
        Some(ident.clone())
    }

    pub(super) fn eat_word(&mut self, word: &str) -> bool {
        self.at_word(word) && self.bump()
    }

    pub(super) fn eat(&mut self, operator: &str) -> bool {
        let after = self.after(operator);
        if let Some(after) = after {
            *self = after;
        }
        after.is_some()
    }

    /// Steps over a group and gives what is in it.
    pub(super) fn enter(&mut self, delimiter: Delimiter) -> Option<Self> {
        if !self.at_group(delimiter) {
            return None;
        }
        let group = self.at;
        self.step(group);
        Some(Self { at: group + 1, end: self.at, group: Some(group), last: None, ..*self })
    }

    /// Every name from here up to `end`, also inside groups.
    pub(super) fn names_until(&self, end: &Self) -> impl Iterator<Item = Ident> + 'a {
        let names = |token: &Token| match &token.tree {
            TokenTree::Ident(name) => Some(name.clone()),
            _ => None,
        };
        self.tokens[self.at..end.at].iter().filter_map(names)
    }

    /// Whether a word or sign that leaves a function or a loop stands from here up to `end`, also inside groups.
    pub(super) fn may_leave_until(&self, end: &Self) -> bool {
        self.tokens[self.at..end.at].iter().any(|token| match &token.tree {
            TokenTree::Ident(_) => matches!(token.word.as_str(), "return" | "break" | "continue"),
            TokenTree::Punct(sign) => sign.as_char() == '?',
            _ => false,
        })
    }

    /// A name that is declared or mentioned. Keywords of Rust pass: a rule refuses them with its reason.
    pub(super) fn name(&mut self, what: &str) -> Result<Ident> {
        self.eat_ident().ok_or_else(|| {
            let message = format!("expected {what}, found {}", self.found());
            self.error(if self.at_attribute() { attrs::MISPLACED.to_owned() } else { message })
        })
    }

    /// The next token if it is a number, as steps are called on paper.
    pub(super) fn number(&self) -> Option<String> {
        self.literal().map(ToString::to_string).filter(|text| text.bytes().all(|byte| byte.is_ascii_digit()))
    }

    /// The name of a step. A number passes as the name that its declaration is told to take.
    pub(super) fn step_name(&mut self, what: &str) -> Result<Ident> {
        let Some(number) = self.number() else { return self.name(what) };
        self.bump();
        Ok(Ident::new(&format!("S{number}"), self.last()))
    }

    /// Names of steps separated by commas, up to the end.
    pub(super) fn names(&mut self, what: &str) -> Result<Vec<Ident>> {
        let (mut names, mut turns) = (Vec::new(), Turns::default());
        while turns.more(self) {
            names.push(self.step_name(what)?);
            if !self.eat(",") && !self.is_empty() {
                return Err(self.error(format!("expected `,`, found {}", self.found())));
            }
        }
        Ok(names)
    }

    /// Lets `syn` parse Rust from here, and steps over what it used. What follows is the caller's.
    pub(super) fn rust<T>(&mut self, parse: impl Fn(ParseStream) -> syn::Result<T>) -> Result<T> {
        let mut ahead = *self;
        let (mut operand, mut lifetime) = (false, false);
        while let Some(token) = ahead.token() {
            // No expression and no type has a name right after an operand: so much less to cut out where `;` is missing.
            let name = !token.word.is_empty() && !words::is_rust(&token.word);
            let sign = |char| matches!(&token.tree, TokenTree::Punct(punct) if punct.as_char() == char);
            if name && operand || sign(';') {
                break;
            }
            // A type follows the name of a lifetime, `&'a u8`.
            operand = name && !lifetime || matches!(token.tree, TokenTree::Literal(_));
            lifetime = sign('\'');
            ahead.at = token.next;
        }
        self.cut(ahead, parse)
    }

    /// Like [`Input::rust`], for exactly the next `count` tokens.
    pub(super) fn rust_tokens<T>(&mut self, count: usize, parse: impl Fn(ParseStream) -> syn::Result<T>) -> Result<T> {
        let mut ahead = *self;
        for _ in 0..count {
            if let Some(token) = self.tokens[..self.end].get(ahead.at) {
                ahead.at = token.next;
            }
        }
        self.cut(ahead, parse)
    }

    /// Cuts out the tokens up to `end` and lets `syn` parse them.
    fn cut<T>(&mut self, end: Self, parse: impl Fn(ParseStream) -> syn::Result<T>) -> Result<T> {
        // Draining the piece keeps `syn` from complaining about the part that is not its business.
        let counted = |input: ParseStream| Ok((parse(input)?, input.parse::<TokenStream>()?));
        let piece = self.piece(&end);
        let (parsed, left) = match counted.parse2(piece.clone()) {
            // A keyword that is declared as a name has its error there, and is a name here.
            Err(error) => match refused::raw(piece, &refused::keywords(self)) {
                Some(piece) => counted.parse2(piece)?,
                None => return Err(error.into()),
            },
            Ok(read) => read,
        };
        self.step_over(&end, left);
        Ok(parsed)
    }

    /// The tokens up to `end`, and a `;`: with that, "unexpected end" has a place to point at.
    fn piece(&self, end: &Self) -> TokenStream {
        let mut tokens = TokenStream::new();
        let mut at = self.at;
        while at < end.at {
            tokens.append(self.tokens[at].tree.clone());
            at = self.tokens[at].next;
        }
        let mut semicolon = Punct::new(';', Spacing::Alone);
        semicolon.set_span(end.span());
        tokens.append(semicolon);
        tokens
    }

    /// Steps over what was used of the piece up to `end`: all but what is left of it and its `;`.
    fn step_over(&mut self, end: &Self, left: TokenStream) {
        let mut starts = Vec::new();
        let mut at = self.at;
        while at < end.at {
            starts.push(at);
            at = self.tokens[at].next;
        }
        let used = (starts.len() + 1).saturating_sub(left.into_iter().count());
        if let Some(last) = starts.get(used.wrapping_sub(1)) {
            self.step(*last);
        }
    }

    /// What `from` stands before and this input after.
    pub(super) fn since(&self, from: &Self) -> Mark {
        Mark { start: from.span(), end: self.last() }
    }
}
