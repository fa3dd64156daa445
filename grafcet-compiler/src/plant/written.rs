//! The body of a plant in the words of an `sfc`: what it may choose becomes inputs that nobody drives.
//!
//! ```text
//! either A -[c]-> (B or C);    A -[choose_c && (c)]-> C;  A -[c]-> B;
//! 2s..4s/Moving                (4s/Moving || early_moving && 2s/Moving)
//! fault jammed;                input jammed: bool;
//! choice part_comes;           input part_comes: bool;
//! ```

use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};
use syn::Lit;

use super::call::{Call, Written, is_sign, is_word};
use crate::ast::{Body, DeclKind, Item, Property, Setting};
use crate::diagnostic::{Mark, Sink};
use crate::list::List;
use crate::parse;
use crate::raw;

/// The dialect of a plant that is written as a chart: an `sfc` of which messages know that it is a plant. A user writes `plant`.
pub(crate) const KEYWORD: &str = "__plant";

/// A plant as the tokens of a chart.
pub(super) struct Plain {
    pub(super) tokens: TokenStream,
    /// The inputs that nobody drives.
    pub(super) free: Vec<String>,
}

pub(super) fn plain(plant: &Written, call: &Call, sink: &mut Sink) -> Plain {
    let taken = declared_names(plant.body.stream());
    let mut body = Plainer { free: Vec::new(), taken, declared: TokenStream::new(), sink };
    let inside = body.items(plant.body.stream());
    let Plainer { free, declared, .. } = body;
    let (before, name, clock) = (&plant.before, &plant.name, clock(&call.body));
    let keyword = Ident::new(KEYWORD, plant.keyword.span());
    // A machine may stand still for ever, and nobody has to use its type.
    let mut tokens = quote!(#[allow(dead_code)] #before #keyword #name);
    let mut braces = Group::new(
        Delimiter::Brace,
        quote!(#![allow(grafcet::deadlock)] #![allow(grafcet::overlapping_branches)] #clock #declared #inside),
    );
    braces.set_span(plant.body.span());
    tokens.extend([TokenTree::Group(braces)]);
    Plain { tokens, free }
}

/// What a plant does not have.
pub(super) fn refuse(body: &Body, sink: &mut Sink) {
    for item in &body.items {
        match item {
            Item::Property(property) => {
                let keyword = match property {
                    Property::Never { keyword, .. }
                    | Property::Always { keyword, .. }
                    | Property::Home { keyword, .. }
                    | Property::LeadsTo { keyword, .. }
                    | Property::Before { keyword, .. } => *keyword,
                };
                let message = "what is to be proved of a plant stands in the chart, where its steps have its name in front: \
                               `never Cylinder::Out.X && …;`";
                sink.notation(keyword, message);
            }
            Item::Setting(
                Setting::AssumeCycle { keyword, .. }
                | Setting::AssumeOften { keyword, .. }
                | Setting::AssumeOrder { keyword, .. },
            ) => {
                sink.notation(
                    *keyword,
                    "how often a plant is looked at, what comes again and again, and what after what, stands in the chart",
                );
            }
            Item::Decl(decl) if matches!(decl.kind, DeclKind::Param) => {
                let name = decl.names.first().map_or_else(Span::call_site, Ident::span);
                sink.notation(name, "a plant has no params; what may be one way or another is a time between two bounds, `2s..4s/Step`, or a `choice`");
            }
            _ => {}
        }
    }
}

/// `clock 10ms;` of the chart: a plant counts in the same ticks.
fn clock(chart: &TokenStream) -> TokenStream {
    let all = chart.clone().into_iter().list();
    for at in 0..all.len() {
        if is_word(all.get(at), "clock") && is_sign(all.get(at + 2), ';') && (at == 0 || !is_sign(all.get(at - 1), '.'))
        {
            return all[at..at + 3].iter().cloned().map(TokenStream::from).tokens();
        }
    }
    TokenStream::new()
}

/// The names after `input`, `output`, `var`, `fault` and `choice`.
fn declared_names(body: TokenStream) -> Vec<String> {
    let mut names = Vec::new();
    let all = body.into_iter().list();
    for item in all.split(|token| is_sign(Some(token), ';')) {
        // A declaration may stand after the braces of a step.
        let is_word_of = |token: &TokenTree| {
            ["input", "output", "var", "fault", "choice"].iter().any(|word| is_word(Some(token), word))
        };
        let Some(at) = item.iter().position(is_word_of) else { continue };
        let after = item[at + 1..].iter().take_while(|token| !is_sign(Some(token), ':'));
        names.extend(after.filter_map(|token| match token {
            TokenTree::Ident(name) => Some(name.to_string()),
            _ => None,
        }));
    }
    names
}

struct Plainer<'s> {
    free: Vec<String>,
    /// What the plant declares itself.
    taken: Vec<String>,
    declared: TokenStream,
    sink: &'s mut Sink,
}

impl Plainer<'_> {
    fn items(&mut self, body: TokenStream) -> TokenStream {
        let all = body.into_iter().list();
        let (mut out, mut at, mut begins) = (TokenStream::new(), 0, true);
        while at < all.len() {
            let word = match &all[at] {
                TokenTree::Ident(word) if begins => word.to_string(),
                _ => String::new(),
            };
            let end = all[at..].iter().position(|token| is_sign(Some(token), ';')).map_or(all.len(), |end| at + end);
            match word.as_str() {
                "either" if !is_sign(all.get(at + 1), '-') => {
                    out.extend(self.either(&all[at..end]));
                    at = end + 1;
                }
                "fault" | "choice"
                    if matches!(all.get(at + 1), Some(TokenTree::Ident(_))) || is_sign(all.get(at + 1), ':') =>
                {
                    self.names(&all[at..end], &word);
                    at = end + 1;
                }
                "clock" if matches!(all.get(at + 1), Some(TokenTree::Literal(_))) => {
                    self.sink.notation(all[at].span(), "a plant counts in the ticks of its chart; remove this");
                    at = end + 1;
                }
                _ => {
                    begins = is_sign(all.get(at), ';')
                        || matches!(&all[at], TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
                    let next = self.between(&all[at..], &mut out);
                    at += next;
                }
            }
        }
        out
    }

    /// `fault jammed, stuck;`
    fn names(&mut self, item: &[TokenTree], word: &str) {
        let mut rest = &item[1..];
        if let [TokenTree::Punct(colon), after @ ..] = rest {
            self.sink.notation(colon.span(), format!("no `:` stands after `{word}`: `{word} jammed, stuck;`"));
            rest = after;
        }
        while let [TokenTree::Ident(name), after @ ..] = rest {
            let doc = format!(" A {word}: nobody drives it.");
            self.declare(name, &doc);
            rest = match after {
                [] => return,
                [TokenTree::Punct(comma), after @ ..] if comma.as_char() == ',' => after,
                _ => break,
            };
        }
        let at = rest.first().unwrap_or(&item[0]).span();
        self.sink.notation(at, format!("a {word} is a name alone, false or true: `{word} jammed, stuck;`"));
    }

    fn declare(&mut self, name: &Ident, doc: &str) {
        self.free.push(name.to_string());
        self.declared.extend(quote!(#[doc = #doc] input #name: bool;));
    }

    /// An input beside those that are there, called after a step.
    fn choice(&mut self, what: &str, step: &Ident, doc: &str) -> Ident {
        let base = format!("{what}_{}", snake(&raw::plain(step)));
        let (mut name, mut number) = (base.clone(), 1);
        while self.free.contains(&name) || self.taken.contains(&name) {
            number += 1;
            name = format!("{base}_{number}");
        }
        let name = Ident::new(&name, step.span());
        self.declare(&name, doc);
        name
    }

    /// `either A -[c]-> (B or C)`: the first where nothing is chosen.
    fn either(&mut self, item: &[TokenTree]) -> TokenStream {
        let mark = Mark { start: item[0].span(), end: item[item.len() - 1].span() };
        let form = "a choice is drawn as one transition: `either Down -[valve]-> (Moving or Stuck);`";
        let arrow = item.iter().position(|token| is_sign(Some(token), '-')).unwrap_or(item.len());
        let (from, rest) = item[1.min(item.len())..].split_at(arrow.saturating_sub(1));
        let [_, TokenTree::Group(condition), _, _, TokenTree::Group(targets)] = rest else {
            self.sink.notation(mark, form);
            return TokenStream::new();
        };
        let targets: Vec<Vec<TokenTree>> = alternatives(targets);
        let is_else = is_word(condition.stream().into_iter().next().as_ref(), "else");
        let is_missing = targets.iter().any(Vec::is_empty);
        if targets.len() < 2 || is_missing || is_else || condition.delimiter() != Delimiter::Bracket {
            self.sink.notation(mark, form);
            return TokenStream::new();
        }
        let from: TokenStream = from.iter().cloned().map(TokenStream::from).tokens();
        let condition_tokens = self.stream(condition.stream());
        let arrow = |condition: TokenStream, target: &[TokenTree]| {
            let mut group = Group::new(Delimiter::Bracket, condition);
            group.set_span(item[0].span());
            let target: TokenStream = target.iter().cloned().map(TokenStream::from).tokens();
            quote_spanned!(item[0].span()=> #from - #group -> #target;)
        };
        let mut out = TokenStream::new();
        for target in &targets[1..] {
            let first = target.iter().find_map(first_name).unwrap_or_else(|| Ident::new("other", mark.start));
            let doc = format!(" The way to `{first}` is chosen.");
            let choice = self.choice("choose", &first, &doc);
            out.extend(arrow(quote!(#choice && (#condition_tokens)), target));
        }
        out.extend(arrow(condition_tokens, &targets[0]));
        out
    }

    fn stream(&mut self, tokens: TokenStream) -> TokenStream {
        let all = tokens.into_iter().list();
        let (mut out, mut at) = (TokenStream::new(), 0);
        while at < all.len() {
            at += self.between(&all[at..], &mut out);
        }
        out
    }

    /// One token, or a time between two bounds; returned is how many tokens that was.
    fn between(&mut self, rest: &[TokenTree], out: &mut TokenStream) -> usize {
        match rest {
            [
                TokenTree::Literal(low),
                TokenTree::Punct(a),
                TokenTree::Punct(b),
                TokenTree::Literal(high),
                TokenTree::Punct(slash),
                TokenTree::Ident(step),
                ..,
            ] if (a.as_char(), b.as_char(), slash.as_char()) == ('.', '.', '/') => {
                self.ordered(low, high);
                let doc = format!(" `{step}` may end before its latest time.");
                let early = self.choice("early", step, &doc);
                out.extend(quote_spanned!(low.span()=> (#high/#step || #early && #low/#step)));
                6
            }
            [
                TokenTree::Literal(low),
                TokenTree::Punct(a),
                TokenTree::Punct(b),
                TokenTree::Punct(c),
                TokenTree::Literal(high),
                TokenTree::Punct(slash),
                TokenTree::Ident(step),
                ..,
            ] if (a.as_char(), b.as_char(), c.as_char(), slash.as_char()) == ('.', '.', '=', '/') => {
                self.sink.notation(low.span(), format!("a time between two bounds is written `{low}..{high}/{step}`"));
                out.extend(quote_spanned!(low.span()=> #high/#step));
                7
            }
            [TokenTree::Group(group), ..] => {
                let mut inner = Group::new(group.delimiter(), self.stream(group.stream()));
                inner.set_span(group.span());
                out.extend([TokenTree::Group(inner)]);
                1
            }
            [token, ..] => {
                out.extend([token.clone()]);
                1
            }
            [] => 1,
        }
    }

    fn ordered(&mut self, low: &Literal, high: &Literal) {
        let nanos = |literal: &Literal| match parse::time_literal(&Lit::new(literal.clone())) {
            Some(Ok(time)) => Some(time.nanos),
            _ => None,
        };
        if let (Some(from), Some(to)) = (nanos(low), nanos(high)) {
            if from > to {
                let mark = Mark { start: low.span(), end: high.span() };
                self.sink.notation(mark, format!("the lower bound comes first: `{high}..{low}`"));
            }
        }
    }
}

/// What stands between `or`.
fn alternatives(targets: &Group) -> Vec<Vec<TokenTree>> {
    let mut all = vec![Vec::new()];
    for token in targets.stream() {
        match all.last_mut() {
            Some(last) if !is_word(Some(&token), "or") => last.push(token),
            _ => all.push(Vec::new()),
        }
    }
    all
}

fn first_name(token: &TokenTree) -> Option<Ident> {
    match token {
        TokenTree::Ident(name) => Some(name.clone()),
        TokenTree::Group(group) => group.stream().into_iter().find_map(|token| first_name(&token)),
        _ => None,
    }
}

/// `AtTop` as `at_top`
fn snake(name: &str) -> String {
    let mut snake = String::new();
    let mut lower = false;
    for letter in name.chars() {
        if letter.is_uppercase() && lower {
            snake.push('_');
        }
        lower = !letter.is_uppercase() && letter != '_';
        snake.extend(letter.to_lowercase());
    }
    snake
}
