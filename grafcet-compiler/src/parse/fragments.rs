//! What a macro of `macro_rules` was given comes in groups without delimiters: `$b` of `!$b` is one token, however much
//! is in it. rustc forgets such groups in what a procedural macro gives back, and `!$b` of `a || b` would run as
//! `!a || b`. So they are opened before anything looks at them, and where the operators around could take them apart they
//! get parentheses. What is checked, what is shown and what runs is then the same.

use crate::list::{List, PushAll};
use proc_macro2::{Delimiter, Group, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::{Expr, Type};

use super::condition;
use crate::visit::{begins_with_block, is_block};

/// One level of tokens with the groups opened. What is in other groups is left as it is.
pub(super) fn opened(tokens: TokenStream) -> Vec<TokenTree> {
    let trees: Vec<TokenTree> = tokens.into_iter().list();
    let mut out = Vec::with_capacity(trees.len());
    let mut after_fragment = false;
    for (at, tree) in trees.iter().enumerate() {
        let group = match tree {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => group,
            other => {
                out.push(other.clone());
                after_fragment = false;
                continue;
            }
        };
        let content = opened(group.stream());
        if content.is_empty() {
            continue;
        }
        let between = Between { before: &out, after_fragment, after: &trees[at + 1..] };
        if between.needs_parentheses(&content) {
            let mut parentheses = Group::new(Delimiter::Parenthesis, content.into_iter().collect());
            // Parentheses of ours, so that no lint finds them superfluous.
            parentheses.set_span(Span::mixed_site().located_at(group.span()));
            out.push(parentheses.into());
        } else {
            // What did not touch makes no operator: `a < $t` with `<T>::MAX`.
            end_operator(&mut out);
            out.push_all(content);
            end_operator(&mut out);
        }
        after_fragment = true;
    }
    out
}

/// Makes the last token, if it is an operator's character, the last one of its operator.
fn end_operator(tokens: &mut [TokenTree]) {
    if let Some(TokenTree::Punct(last)) = tokens.last_mut() {
        if last.as_char() != '\'' {
            let mut alone = Punct::new(last.as_char(), Spacing::Alone);
            alone.set_span(last.span());
            *last = alone;
        }
    }
}

/// What a fragment is, as far as parentheses matter.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// It holds together by itself: `a`, `f(x)`; or it is nothing that parentheses could stand around: `let x = 1`, `pub`.
    Whole,
    /// `a.f`: with parentheses after it, it would be a method.
    Field,
    /// `{ … }`, which may be a block or a body of the chart.
    Braces,
    /// It can be an operand, but is a statement where one can begin: `x = 1`, `if a { 1 } else { 2 }`.
    Statement,
    /// The same, but never an operand: `while a { … }`.
    Done,
    /// Operators and the like: `a || b`, `-1`, `&x`, `dyn A + B`.
    Loose,
    /// The same with a block at its beginning, which Rust takes for a statement: `match x { … } > 3`.
    LooseBlock,
}

fn kind(content: &[TokenTree]) -> Kind {
    match content {
        // The attribute is about what follows it.
        [TokenTree::Punct(first), ..] if first.as_char() == '#' => return Kind::Whole,
        [TokenTree::Group(group)] if group.delimiter() == Delimiter::Brace => return Kind::Braces,
        [TokenTree::Literal(literal)] if literal.to_string().starts_with('-') => return Kind::Loose,
        [_] => return Kind::Whole,
        _ => {}
    }
    let tokens: TokenStream = content.iter().cloned().collect();
    match syn::parse2(tokens.clone()) {
        Ok(expr) => kind_of_expr(&expr),
        Err(_) => match syn::parse2(tokens) {
            Ok(Type::TraitObject(object)) if object.bounds.len() > 1 => Kind::Loose,
            Ok(Type::ImplTrait(one)) if one.bounds.len() > 1 => Kind::Loose,
            _ => Kind::Whole,
        },
    }
}

fn kind_of_expr(expr: &Expr) -> Kind {
    match expr {
        Expr::Let(_) => Kind::Whole,
        Expr::While(_) | Expr::ForLoop(_) => Kind::Done,
        Expr::If(branch) if branch.else_branch.is_none() => Kind::Done,
        Expr::Assign(_) => Kind::Statement,
        Expr::Binary(binary) if condition::changes(&binary.op) => Kind::Statement,
        _ if is_block(expr) => Kind::Statement,
        _ if begins_with_block(expr) => Kind::LooseBlock,
        Expr::Field(_) => Kind::Field,
        Expr::Array(_)
        | Expr::Await(_)
        | Expr::Call(_)
        | Expr::Index(_)
        | Expr::Macro(_)
        | Expr::MethodCall(_)
        | Expr::Paren(_)
        | Expr::Path(_)
        | Expr::Repeat(_)
        | Expr::Try(_)
        | Expr::Tuple(_) => Kind::Whole,
        _ => Kind::Loose,
    }
}

/// Where a fragment stands.
struct Between<'t> {
    before: &'t [TokenTree],
    /// The last token before it is the end of another fragment.
    after_fragment: bool,
    after: &'t [TokenTree],
}

impl Between<'_> {
    fn needs_parentheses(&self, content: &[TokenTree]) -> bool {
        match kind(content) {
            // `x as $t < y`: with the type alone, Rust would look for its generic arguments.
            Kind::Whole => self.after_as() && is_punct(self.after, '<'),
            Kind::Field => {
                matches!(self.after, [TokenTree::Group(next), ..] if next.delimiter() == Delimiter::Parenthesis)
            }
            Kind::Braces => self.begins_statement() && self.goes_on(),
            Kind::Statement => (!self.begins_statement() || self.goes_on()) && !self.is_free_of_operators(),
            Kind::Done => !self.begins_statement() && !self.is_free_of_operators(),
            Kind::Loose => !self.is_free_of_operators(),
            Kind::LooseBlock => self.begins_statement() || self.begins_arm() || !self.is_free_of_operators(),
        }
    }

    /// Whether no operator can stand on either side.
    fn is_free_of_operators(&self) -> bool {
        let before = match self.before {
            [] => true,
            // Words in front of an operand; all others bind less than any operator.
            [.., TokenTree::Ident(word)] => {
                !["as", "mut", "const", "ref", "dyn", "impl"].iter().any(|tight| word == tight)
            }
            [before @ .., TokenTree::Punct(last)] => match (before, last.as_char()) {
                ([.., TokenTree::Punct(first)], ':' | '=') if first.spacing() == Spacing::Joint => {
                    last.as_char() == '=' && !['=', '<', '>', '!', '.'].contains(&first.as_char())
                }
                (_, ';' | ',' | ':' | '=') => true,
                _ => self.begins_arm(),
            },
            _ => false,
        };
        let after = match self.after {
            [] => true,
            [TokenTree::Ident(word), ..] => word != "as" && word != "else",
            [TokenTree::Punct(next), ..] => matches!(next.as_char(), ';' | ',') || is_arm(self.after),
            _ => false,
        };
        before && after
    }

    /// Whether a statement can begin here.
    fn begins_statement(&self) -> bool {
        match self.before.last() {
            None => true,
            Some(TokenTree::Punct(last)) => last.as_char() == ';',
            Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Brace || self.after_fragment,
            Some(_) => self.after_fragment,
        }
    }

    /// Whether `=>` is in front of it.
    fn begins_arm(&self) -> bool {
        self.before.len().checked_sub(2).is_some_and(|at| is_arm(&self.before[at..]))
    }

    fn after_as(&self) -> bool {
        matches!(self.before.last(), Some(TokenTree::Ident(last)) if last == "as")
    }

    /// Whether what follows can go on with an expression.
    fn goes_on(&self) -> bool {
        match self.after {
            [] | [TokenTree::Literal(_), ..] => false,
            [TokenTree::Ident(word), ..] => word == "as",
            [TokenTree::Punct(next), ..] => {
                !matches!(next.as_char(), ';' | ',' | '#' | '\'' | ':') && !is_arm(self.after)
            }
            [TokenTree::Group(group), ..] => {
                matches!(group.delimiter(), Delimiter::Parenthesis | Delimiter::Bracket)
            }
        }
    }
}

/// Whether `=>` is next.
fn is_arm(trees: &[TokenTree]) -> bool {
    matches!(trees, [TokenTree::Punct(first), TokenTree::Punct(last), ..]
        if first.as_char() == '=' && first.spacing() == Spacing::Joint && last.as_char() == '>')
}

fn is_punct(trees: &[TokenTree], char: char) -> bool {
    matches!(trees, [TokenTree::Punct(punct), ..] if punct.as_char() == char)
}
