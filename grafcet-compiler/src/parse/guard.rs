//! Bounds what `syn` and later passes recurse over, so that no input overflows the stack.
//!
//! `syn` recurses where Rust nests: in groups, after prefixes, in generic arguments. Here every token that leads a level
//! down has a price, in kilobytes of stack of an unoptimised build as measured (`syn` 3.0, x86-64, rounded up), and the
//! sum over the levels that can be open at once stays below what the smallest stack around has: the 2 MB of a thread.

use proc_macro2::{Delimiter, Punct, Spacing, Span, TokenTree};

use super::{Error, Result};

/// What a chart may use.
const BUDGET: usize = 1500;

/// An operator, a call or a field: nothing for `syn`, but the tree that later passes walk is a level deeper.
const OPERATOR: usize = 5;
/// `{ … }`
const BRACES: usize = 30;
/// `( … )` and `[ … ]`: cheap in expressions, dear in types, and both look the same from here.
const GROUP: usize = 42;
/// `<` of generic arguments
const ANGLE: usize = 56;
/// `&` and `*`, dear in types
const POINTER: usize = 36;
/// `!`, `-`; `@` of patterns
const SIGN: usize = 5;
/// `=` of an assignment
const ASSIGN: usize = 12;
/// The first `|` of a closure
const CLOSURE: usize = 18;
/// `->`
const RESULT: usize = 42;

/// Words in front of what they nest.
const WORDS: &[(&str, usize)] = &[
    ("return", 14),
    ("break", 14),
    ("yield", 14),
    ("let", 14),
    ("if", 14),
    ("match", 14),
    ("while", 14),
    ("for", 14),
    ("async", 10),
    ("fn", 24),
    ("const", 32),
    ("mod", 42),
    ("impl", 42),
    ("trait", 42),
    ("static", 32),
    ("mut", 1),
    ("ref", 1),
    ("box", 3),
    ("dyn", 2),
    ("in", 1),
    ("as", OPERATOR),
    ("else", 1),
    ("move", 1),
    ("unsafe", 1),
    ("loop", 1),
];

/// Walks one level beside whoever lays out the tokens, and refuses what is nested too deeply: more than about 30
/// parentheses, or 300 operators in one expression.
pub(super) struct Guard {
    above: usize,
    run: Run,
}

impl Guard {
    /// The outermost level.
    pub(super) fn new() -> Self {
        Self { above: 0, run: Run::default() }
    }

    /// The next token, an identifier with its text; the guard of what is in it, if it is a group.
    pub(super) fn step(&mut self, tree: &TokenTree, word: &str) -> Result<Self> {
        let mut inside = Self::new();
        match tree {
            TokenTree::Group(group) => {
                let price = if group.delimiter() == Delimiter::Brace { BRACES } else { GROUP };
                inside.above = self.above + self.run.depth() + price;
                self.run.group(group.delimiter());
            }
            TokenTree::Ident(_) => self.run.ident(word),
            TokenTree::Punct(punct) => self.run.punct(punct),
            TokenTree::Literal(_) => self.run.operand(Before::Operand),
        }
        if inside.above.max(self.above + self.run.depth()) <= BUDGET {
            return Ok(inside);
        }
        let place = match tree {
            TokenTree::Group(group) => group.span_open(),
            other => other.span(),
        };
        Err(too_deep(place))
    }
}

fn too_deep(place: Span) -> Error {
    let message = "this is nested too deeply, or too long for one expression; \
        declare a `var` for a part of it, or move it into a function";
    Error::new(place, message)
}

/// What can be open at a place among the tokens of one level, since something that certainly ended an expression.
#[derive(Default)]
struct Run {
    /// What goes on to the end of the expression: operators, assignments, closures, `return`.
    loose: usize,
    /// Calls and fields, which end with the next operator.
    postfix: usize,
    /// Prefixes, which end with their operand.
    tight: usize,
    /// The prefixes of the last operand: they stay open where generic arguments follow it.
    last_tight: usize,
    /// Open generic arguments, or comparisons.
    angles: Vec<usize>,
    /// After a closure's parameters a comma need not end anything.
    closure: bool,
    before: Before,
}

/// The token before the present one.
#[derive(Default, Clone, Copy, PartialEq)]
enum Before {
    /// A prefix may follow.
    #[default]
    Start,
    Operand,
    Word,
    Brace,
    Bracket,
    /// A character, whether the next one is joined to it, and whether an operand stood before it.
    Sign {
        char: char,
        joint: bool,
        binary: bool,
    },
    /// `]-` or `A-`
    Dash,
}

impl Run {
    fn depth(&self) -> usize {
        self.loose + self.postfix + self.tight + self.angles.iter().sum::<usize>()
    }

    fn end(&mut self) {
        *self = Self::default();
    }

    fn operand(&mut self, before: Before) {
        self.last_tight = std::mem::take(&mut self.tight);
        self.before = before;
    }

    fn group(&mut self, delimiter: Delimiter) {
        if self.after_operand() {
            self.postfix += OPERATOR;
        }
        self.operand(match delimiter {
            Delimiter::Brace => Before::Brace,
            Delimiter::Bracket => Before::Bracket,
            Delimiter::Parenthesis | Delimiter::None => Before::Operand,
        });
    }

    fn ident(&mut self, word: &str) {
        // After a brace only these words go on with the same expression.
        if self.before == Before::Brace && word != "else" && word != "as" {
            self.end();
        }
        match WORDS.iter().find(|(prefix, _)| word == *prefix) {
            Some((_, price)) => {
                self.loose += price;
                self.before = Before::Start;
            }
            None => self.operand(Before::Word),
        }
    }

    fn punct(&mut self, punct: &Punct) {
        let (char, joint) = (punct.as_char(), punct.spacing() == Spacing::Joint);
        let before = self.before;
        let binary = self.after_operand();
        self.before = Before::Sign { char, joint, binary };
        match (before, char) {
            // `]->` and `A->` are no Rust: a link of a chain, which may be as long as it likes.
            (_, ';') | (Before::Brace, '#') | (Before::Dash, '>') => self.end(),
            (_, ',') if self.angles.is_empty() && !self.closure => self.end(),
            (Before::Bracket | Before::Word, '-') if joint => {
                self.operator(false);
                self.before = Before::Dash;
            }
            (Before::Sign { char: first, joint: true, binary: true }, _) if self.pair(first, char) => {}
            (_, '.') if binary => self.postfix += OPERATOR,
            (_, '?') if binary => {
                self.postfix += OPERATOR;
                self.before = Before::Operand;
            }
            (_, '=') => self.loose += ASSIGN,
            (_, '<') => self.angles.push(ANGLE + self.last_tight),
            (_, '>') => drop(self.angles.pop()),
            (_, '|') if binary => self.operator(true),
            (_, '|') => {
                self.closure = true;
                self.loose += CLOSURE;
            }
            (_, '&' | '*') if !binary => self.tight += POINTER,
            (_, '@') => self.loose += SIGN,
            (_, '!' | '-') if !binary => self.tight += SIGN,
            (_, ':' | ',' | '#' | '\'' | '.') => {}
            _ => self.operator(false),
        }
    }

    /// Whether the next token can be a binary operator, a call or a field.
    fn after_operand(&self) -> bool {
        !matches!(self.before, Before::Start | Before::Sign { .. } | Before::Dash)
    }

    /// A binary operator; one that no type has `ends_types`.
    fn operator(&mut self, ends_types: bool) {
        self.postfix = 0;
        self.loose += OPERATOR;
        if ends_types {
            self.angles.clear();
        }
    }

    /// Whether two characters after an operand are one operator; if so, its price.
    fn pair(&mut self, first: char, second: char) -> bool {
        match (first, second) {
            // The first character was taken for an assignment, or for generic arguments.
            ('=', '=' | '>') => self.loose = self.loose.saturating_sub(ASSIGN),
            ('<', '=') => drop(self.angles.pop()),
            ('&', '&') | ('|', '|') => self.angles.clear(),
            ('!' | '>', '=') => {}
            ('-', '>') => self.loose += RESULT,
            _ => return false,
        }
        true
    }
}
