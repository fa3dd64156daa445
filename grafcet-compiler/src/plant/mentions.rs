//! `Cylinder::Out.X`, `Cylinder::jammed`: what a chart's properties and assumptions say of plants.
//!
//! Each becomes an input of the chart that only the proof has, and whose value is that of the plant at the end of the cycle.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use super::call::{Call, is_sign, is_word};
use crate::diagnostic::Sink;
use crate::list::{List, PushAll};
use crate::model::{Claim, Expr, Model, Name, Read, Seen, Tree, Ty, Watched};
use crate::similar;

/// A chart in which they are replaced.
pub(super) struct Mentions {
    pub(super) tokens: TokenStream,
    all: Vec<Mention>,
}

struct Mention {
    /// The input that stands for it.
    name: Ident,
    ty: TokenStream,
    plant: usize,
    /// What is named of it.
    named: String,
    what: Seen,
    /// As it is written.
    text: String,
}

/// Whether an expression says something of a plant.
pub(super) fn any(expr: &syn::Expr, plants: &[String]) -> bool {
    within(expr.to_token_stream(), plants)
}

fn within(tokens: TokenStream, plants: &[String]) -> bool {
    let all = tokens.into_iter().list();
    all.iter().enumerate().any(|(at, token)| match token {
        TokenTree::Group(group) => within(group.stream(), plants),
        TokenTree::Ident(name) => is_sign(all.get(at + 1), ':') && plants.contains(&name.to_string()),
        _ => false,
    })
}

pub(super) fn replaced(call: &Call, plants: &[&Model], sink: &mut Sink) -> Mentions {
    let mut replacer = Replacer { plants, all: Vec::new(), sink };
    let mut tokens = TokenStream::new();
    for token in call.chart.clone() {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let mut inside = replacer.body(group.stream());
                for mention in &replacer.all {
                    let (name, ty) = (&mention.name, &mention.ty);
                    inside.extend(quote!(input #name: #ty;));
                }
                let mut braces = Group::new(Delimiter::Brace, inside);
                braces.set_span(group.span());
                tokens.extend([TokenTree::Group(braces)]);
            }
            token => tokens.extend([token]),
        }
    }
    tokens.extend(call.rest.clone());
    Mentions { tokens, all: replacer.all }
}

/// The chart cannot look at its plants but by its inputs.
pub(super) fn only_in_claims(system: &Model, mentions: &Mentions, sink: &mut Sink) {
    for mention in &mentions.all {
        let Some((id, _)) = system.inputs.iter().find(|(_, input)| input.name == mention.name) else { continue };
        let read = Read::Name(Name::Input(id));
        if system.expressions().iter().any(|reads| reads.contains(&read)) {
            let message = format!(
                "a chart sees a plant by its inputs alone; `{}` may stand in properties and assumptions, and what the chart \
                 shall know is an output of the plant and an input of the chart",
                mention.text
            );
            sink.notation(&mention.name, message);
        }
    }
}

impl Mentions {
    pub(super) fn watched(&self, system: &Model) -> Vec<Watched> {
        let mut watched = Vec::new();
        for mention in &self.all {
            if let Some((input, _)) = system.inputs.iter().find(|(_, input)| input.name == mention.name) {
                watched.push(Watched { input, plant: mention.plant, what: mention.what });
            }
        }
        watched
    }

    /// A text with what was written.
    pub(super) fn said(&self, text: &str) -> String {
        let said = |text: String, mention: &Mention| replace_word(&text, &mention.name.to_string(), &mention.text);
        self.all.iter().fold(text.to_owned(), said)
    }

    /// Messages have what was written.
    pub(super) fn name(&self, system: &mut Model) {
        let rename = |expr: &mut Expr| {
            expr.text = self.said(&expr.text);
            reword(&mut expr.tree, &|text| self.said(text));
        };
        let properties = system.properties.iter_mut().map(|property| &mut property.claim);
        for claim in properties.chain(system.orders.iter_mut().map(|order| &mut order.claim)) {
            match claim {
                Claim::Never(one) => rename(one),
                Claim::Always { premise, condition } => {
                    premise.iter_mut().for_each(rename);
                    rename(condition);
                }
                Claim::LeadsTo { from: one, to: other, .. } | Claim::Before { first: one, then: other } => {
                    rename(one);
                    rename(other);
                }
                Claim::Home(..) => {}
            }
        }
        for id in system.memories.ids() {
            rename(&mut system.memories[id].of);
        }
        system.assumptions.iter_mut().for_each(|assumption| rename(&mut assumption.never));
        system.often.iter_mut().for_each(rename);
    }
}

struct Replacer<'a> {
    plants: &'a [&'a Model],
    all: Vec<Mention>,
    sink: &'a mut Sink,
}

impl Replacer<'_> {
    fn stream(&mut self, tokens: TokenStream) -> TokenStream {
        let all = tokens.into_iter().list();
        let (mut out, mut at) = (TokenStream::new(), 0);
        while at < all.len() {
            let plant = match &all[at] {
                TokenTree::Ident(name) => self.plants.iter().position(|plant| plant.name == *name),
                _ => None,
            };
            let is_path = is_sign(all.get(at + 1), ':') && is_sign(all.get(at + 2), ':');
            match (plant, all.get(at + 3)) {
                (Some(plant), Some(TokenTree::Ident(name)))
                    if is_path && !is_sign(all.get(at.wrapping_sub(1)), ':') =>
                {
                    let field = is_sign(all.get(at + 4), '.');
                    let is_x = field && is_word(all.get(at + 5), "X");
                    let is_t = field && ["T", "late"].iter().any(|word| is_word(all.get(at + 5), word));
                    if is_t {
                        let message = "a property knows the steps of a plant, and not their times; let the plant have a step or an \
                                       output for what matters";
                        self.sink.notation(name, message);
                    }
                    let mut stands_for = self.mention(plant, name, is_x || is_t);
                    let length = if is_x || is_t { 6 } else { 4 };
                    // All of it, where whoever reads the source can say so.
                    let whole = all[at].span().join(all[at + length - 1].span());
                    stands_for.set_span(whole.unwrap_or_else(|| name.span()));
                    out.extend([TokenTree::Ident(stands_for)]);
                    at += length;
                }
                _ if is_word(all.get(at), "blink") && self.is_mentioned(all.get(at + 1)) => {
                    let message = "what blinks in a property counts from the activation of a step of the chart; let the plant have an output \
                                   for what matters";
                    self.sink.notation(all[at].span(), message);
                    out.extend(quote!(false));
                    at += 2;
                }
                _ => {
                    match &all[at] {
                        TokenTree::Group(group) => {
                            let mut inner = Group::new(group.delimiter(), self.stream(group.stream()));
                            inner.set_span(group.span());
                            out.extend([TokenTree::Group(inner)]);
                        }
                        token => out.extend([token.clone()]),
                    }
                    at += 1;
                }
            }
        }
        out
    }

    /// Whether a group says something of a plant.
    fn is_mentioned(&self, group: Option<&TokenTree>) -> bool {
        let plants = self.plants.iter().map(|plant| plant.name.to_string()).list();
        matches!(group, Some(TokenTree::Group(group)) if within(group.stream(), &plants))
    }

    /// What stands between the braces of the chart. A condition with a name is one of the chart, wherever it is used: it keeps its words.
    fn body(&mut self, tokens: TokenStream) -> TokenStream {
        let plants = self.plants.iter().map(|plant| plant.name.to_string()).list();
        let all = tokens.into_iter().list();
        let (mut out, mut rest) = (TokenStream::new(), &all[..]);
        while let Some(at) = rest.iter().position(|token| is_word(Some(token), "let")) {
            let end = rest[at..].iter().position(|token| is_sign(Some(token), ';')).map_or(rest.len(), |end| at + end);
            out.extend(self.stream(rest[..at].iter().cloned().map(TokenStream::from).tokens()));
            let named: TokenStream = rest[at..end].iter().cloned().map(TokenStream::from).tokens();
            if within(named.clone(), &plants) {
                let message = "a condition with a name is one of the chart, which sees a plant by its inputs alone; write what it says of the \
                               plant into the property or assumption";
                self.sink.notation(rest[at].span(), message);
            }
            out.extend(named);
            rest = &rest[end..];
        }
        out.extend(self.stream(rest.iter().cloned().map(TokenStream::from).tokens()));
        out
    }

    /// The input that stands for something of a plant.
    fn mention(&mut self, plant: usize, name: &Ident, is_step: bool) -> Ident {
        let model = self.plants[plant];
        let named = name.to_string();
        let what = self.find(model, name, is_step);
        if let Some(known) = self.all.iter().find(|mention| mention.plant == plant && mention.named == named) {
            return known.name.clone();
        }
        let mut stands_for = Ident::new(&format!("__{}_{name}", model.name).replace("r#", ""), name.span());
        // `Arm::Up_In` and `Arm_Up::In`.
        while self.all.iter().any(|mention| mention.name == stands_for) {
            stands_for = Ident::new(&format!("{stands_for}_"), name.span());
        }
        let bool = quote!(bool);
        let ty = match what {
            Some(Seen::Value(value)) => match model.ty(value) {
                Ty::Bool(rust) | Ty::Int { rust, .. } => quote!(#rust),
                Ty::Time(_) | Ty::Other(_) => {
                    let message =
                        format!("`{name}` is neither `bool` nor a number; of a plant no other values are followed");
                    self.sink.notation(name, message);
                    bool
                }
            },
            _ => bool,
        };
        let field = if is_step { ".X" } else { "" };
        let text = format!("{}::{name}{field}", model.name);
        let what = what.unwrap_or(Seen::Step(crate::model::Id::new(0)));
        self.all.push(Mention { name: stands_for.clone(), ty, plant, named, what, text });
        stands_for
    }

    fn find(&mut self, model: &Model, name: &Ident, is_step: bool) -> Option<Seen> {
        let step = model.steps.iter().find(|(_, step)| step.name == *name).map(|(id, _)| Seen::Step(id));
        let macro_step = model.macros.iter().find(|(_, step)| step.name == *name).map(|(id, _)| Seen::Macro(id));
        if let Some(step) = step.or(macro_step) {
            return Some(step);
        }
        let value = values(model).into_iter().find(|value| model.value_name(*value) == name);
        if let Some(value) = value {
            if is_step {
                let message =
                    format!("`{name}` is no step of the plant `{}`; its value is `{}::{name}`", model.name, model.name);
                self.sink.notation(name, message);
            }
            return Some(Seen::Value(value));
        }
        let mut known = values(model).into_iter().map(|value| model.value_name(value)).list();
        known.push_all(model.steps.values().map(|step| &step.name));
        let near = similar::nearest(name, &known);
        let field = |near: &Ident| if model.steps.values().any(|step| step.name == *near) { ".X" } else { "" };
        let hint =
            near.map_or_else(String::new, |near| format!("; did you mean `{}::{near}{}`?", model.name, field(near)));
        self.sink.notation(name, format!("the plant `{}` has nothing that is called `{name}`{hint}", model.name));
        None
    }
}

/// The same of Rust that is not looked into.
fn reword(tree: &mut Tree, said: &dyn Fn(&str) -> String) {
    match tree {
        Tree::Unary(_, operand) => reword(operand, said),
        Tree::Binary(_, left, right) => [left, right].into_iter().for_each(|tree| reword(tree, said)),
        Tree::Opaque { text, of, .. } => {
            *text = said(text);
            let operands = of.iter_mut().flat_map(|computed| &mut computed.operands);
            operands.for_each(|tree| reword(tree, said));
        }
        Tree::Bool(_) | Tree::Int(_) | Tree::Read(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => {}
    }
}

/// A name in a text, and no part of a longer one.
fn replace_word(text: &str, word: &str, by: &str) -> String {
    let is_part = |letter: Option<char>| letter.is_some_and(|letter| letter.is_alphanumeric() || letter == '_');
    let (mut replaced, mut rest) = (String::new(), text);
    while let Some(at) = rest.find(word) {
        let (before, after) = (&rest[..at], &rest[at + word.len()..]);
        let whole = !is_part(before.chars().next_back()) && !is_part(after.chars().next());
        replaced.push_str(before);
        replaced.push_str(if whole { by } else { word });
        rest = after;
    }
    replaced + rest
}

fn values(model: &Model) -> Vec<Name> {
    let mut all = model.inputs.ids().map(Name::Input).list();
    all.push_all(model.outputs.ids().map(Name::Output));
    all.push_all(model.vars.ids().map(Name::Var));
    all
}
