//! `let go = auto || rising(next);`: a name for an expression. Where the name is used, the expression stands in its place, so a
//! chart with names is the same chart as one that is written out.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::ToTokens;

use super::Resolver;
use super::blink::Owner;
use super::composed::operand;
use super::declare::first_paragraph;
use super::expr::{Lower, Seen, resolve_named, single_name};
use super::scope::{Meaning, spelled};
use crate::ast;
use crate::diagnostic::Mark;
use crate::list::{List, PushAll};
use crate::model::{Expr, Id, Let, LetId, Mention, Name, Tree};
use crate::place;
use crate::sorted::Set;

/// How deep an expression may be with all names in place: what the guard of the parser lets through.
const DEPTH: usize = 300;

/// Of how many terms one name may be made, and how many all uses may bring into a chart.
const TERMS: usize = 2_000;
const ALL_TERMS: usize = 500_000;

/// A `let`, and how far it is resolved.
pub(super) struct Named {
    value: syn::Expr,
    /// How many inputs, outputs, variables and params are declared before it.
    before: [usize; 4],
    /// What it stands for; not known before its first use, as its edges are no others than those of the uses.
    pub(super) known: Option<Expr>,
    /// Something in it is wrong, and was said.
    broken: bool,
    pub(super) size: Size,
}

/// How large an expression is.
#[derive(Clone, Copy, Default)]
pub(super) struct Size {
    depth: usize,
    terms: usize,
}

/// The size of what has been resolved.
#[derive(Default)]
pub(super) struct Scale {
    /// How deep the walk stands.
    depth: usize,
    deepest: usize,
    terms: usize,
    /// That it is too much has been said.
    full: bool,
}

impl Scale {
    pub(super) fn enter(&mut self) {
        self.depth += 1;
        self.terms += 1;
        self.deepest = self.deepest.max(self.depth);
    }

    pub(super) fn leave(&mut self) {
        self.depth -= 1;
    }

    fn add(&mut self, size: Size) {
        self.terms += size.terms;
        self.deepest = self.deepest.max(self.depth + size.depth);
    }
}

impl Resolver<'_> {
    /// Declares the name.
    pub(super) fn declare_let(&mut self, item: &ast::Let) {
        let model = &mut self.model;
        let before = [model.inputs.len(), model.outputs.len(), model.vars.len(), model.params.len()];
        let text = super::text::of(&item.value);
        let levels = item.attrs.levels.clone();
        let (name, doc) = (spelled(&item.name), first_paragraph(&item.attrs.passed_on));
        let id = model.lets.push(Let { name, levels, doc, text, mentions: Vec::new(), used: false });
        let value = item.value.clone();
        self.lets.push(Named { value, before, known: None, broken: false, size: Size::default() });
        self.scope.declare(&item.name, Meaning::Let(id), self.sink);
    }

    /// Reports what is wrong with the expressions, used or not, each once. What they bring into the model is taken back.
    pub(super) fn check_lets(&mut self) {
        for id in self.model.lets.ids().list() {
            let mentions = self.names_in(self.lets[id.index()].value.to_token_stream());
            self.model.lets[id].mentions = mentions;
            let before = self.sink.count();
            self.scale = Scale::default();
            let _ = self.resolve_let(id);
            let size = Size { depth: self.scale.deepest, terms: self.scale.terms };
            if self.sink.count() == before && size.terms > TERMS {
                let name = &self.model.lets[id].name;
                let message = format!(
                    "`{name}` is made of {} terms once the names in it are written out; {TERMS} is the limit: \
                     name smaller parts",
                    size.terms
                );
                self.sink.notation(name, message);
            }
            let broken = self.sink.count() > before;
            let named = &mut self.lets[id.index()];
            named.size = size;
            named.broken |= broken;
        }
        self.model.edges = crate::model::Arena::default();
        self.model.delays = crate::model::Arena::default();
        self.lets.iter_mut().for_each(|named| named.known = None);
        self.model.lets.ids().list().into_iter().for_each(|id| self.model.lets[id].used = false);
        self.scale = Scale::default();
        self.calls = 0;
    }

    /// What a name stands for, and whether it may have another value in each evaluation: then it is read anew for each use.
    fn named(&mut self, id: LetId) -> (Expr, bool) {
        if let Some(known) = &self.lets[id.index()].known {
            return (known.clone(), false);
        }
        let (mentions, terms, calls) = (self.model.mentions.len(), self.scale.terms, self.calls);
        let expr = self.resolve_let(id);
        self.model.mentions.truncate(mentions);
        self.scale.terms = terms;
        let differs = self.calls > calls;
        if !differs {
            self.lets[id.index()].known = Some(expr.clone());
        }
        (expr, differs)
    }

    fn resolve_let(&mut self, id: LetId) -> Expr {
        self.model.lets[id].used = true;
        let value = self.lets[id.index()].value.clone();
        let owner = std::mem::replace(&mut self.owner, Owner::Chart);
        let defining = self.defining.replace(id);
        let expr = resolve_named(&value, self);
        (self.owner, self.defining) = (owner, defining);
        expr
    }

    /// What a name stands for, as it is written, where that is a `let`.
    pub(super) fn value_of_let(&self, name: &Ident) -> Option<&syn::Expr> {
        match self.scope.get(name)? {
            Meaning::Let(id) => Some(&self.lets[id.index()].value),
            _ => None,
        }
    }

    /// The values that are mentioned in tokens.
    fn names_in(&self, tokens: TokenStream) -> Vec<Name> {
        let mut names = Vec::new();
        for tree in tokens {
            match tree {
                TokenTree::Group(group) => names.push_all(self.names_in(group.stream())),
                TokenTree::Ident(name) => {
                    if let Some(Meaning::Value(value)) = self.scope.get(&name) {
                        names.push(value);
                    }
                }
                _ => {}
            }
        }
        names
    }

    /// Reports a value that a `let` mentions and that is declared after it; `false` if all is well.
    pub(super) fn is_later(&mut self, name: &Ident, value: Name) -> bool {
        let Some(id) = self.defining else { return false };
        let [inputs, outputs, vars, params] = self.lets[id.index()].before;
        let later = match value {
            Name::Input(id) => id.index() >= inputs,
            Name::Output(id) => id.index() >= outputs,
            Name::Var(id) => id.index() >= vars,
            Name::Param(id) => id.index() >= params,
        };
        if later {
            let own = &self.model.lets[id].name;
            let message = format!("`{name}` is declared after `{own}`; declare it in front of this `let`");
            self.sink.notation(name, message);
        }
        later
    }

    /// Reports a name of a `let` that cannot be used here: itself, or one after it.
    fn is_ahead(&mut self, name: &Ident, id: LetId) -> bool {
        let Some(own) = self.defining.filter(|own| *own <= id) else { return false };
        let message = match (own == id, self.stands_for(id, own)) {
            (true, _) => format!("`{name}` stands for itself here; write what it means"),
            (_, true) => {
                let own = &self.model.lets[own].name;
                format!("`{own}` and `{name}` stand for each other; write out what one of them means")
            }
            _ => {
                let own = &self.model.lets[own].name;
                format!("`{name}` is declared after `{own}`; move it in front of this `let`")
            }
        };
        self.sink.notation(name, message);
        true
    }

    /// Whether `other` is mentioned in what `id` stands for.
    fn stands_for(&self, id: LetId, other: LetId) -> bool {
        let (mut open, mut seen) = (vec![id], Set::new());
        while let Some(id) = open.pop() {
            if id == other {
                return true;
            }
            if seen.insert(id) {
                self.lets_in(self.lets[id.index()].value.to_token_stream(), &mut open);
            }
        }
        false
    }

    fn lets_in(&self, tokens: TokenStream, found: &mut Vec<LetId>) {
        for tree in tokens {
            match tree {
                TokenTree::Group(group) => self.lets_in(group.stream(), found),
                TokenTree::Ident(name) => {
                    if let Some(Meaning::Let(id)) = self.scope.get(&name) {
                        found.push(id);
                    }
                }
                _ => {}
            }
        }
    }
}

impl Lower<'_, '_> {
    /// Puts what `name` stands for in the place of `expr`.
    pub(super) fn put_in_place(&mut self, expr: &mut syn::Expr, name: &Ident, id: LetId) -> Tree {
        match self.expression_of(name, id) {
            Some(named) => {
                *expr = operand(named.tokens);
                named.tree
            }
            None => Tree::Bool(true),
        }
    }

    /// The same among the tokens of a macro call.
    pub(super) fn tokens_in_place(&mut self, name: &Ident, id: LetId) -> TokenTree {
        match self.expression_of(name, id) {
            Some(named) => {
                let mut group = Group::new(Delimiter::Parenthesis, named.tokens.into_token_stream());
                group.set_span(place::mixed());
                group.into()
            }
            None => name.clone().into(),
        }
    }

    /// Whether this is a named condition, which nothing can write; that is reported.
    pub(super) fn refuses_write(&mut self, to: &syn::Expr) -> bool {
        let Some(name) = single_name(to).filter(|name| !self.locals.contains(name)) else { return false };
        let is_let = matches!(self.resolver.scope.get(&name), Some(Meaning::Let(_)));
        if is_let {
            let message =
                format!("`{name}` is a named condition, which nothing writes; declare a `var` to keep a value");
            self.resolver.sink.notation(&name, message);
        }
        is_let
    }

    /// The expression that `name` stands for; what it reads is read here.
    fn expression_of(&mut self, name: &Ident, id: LetId) -> Option<Expr> {
        self.resolver.model.mentions.push((Mention::Let(id), name.span()));
        if self.resolver.is_ahead(name, id) {
            return None;
        }
        let Named { size, broken: false, .. } = self.resolver.lets[id.index()] else {
            // What is wrong was said there, also for who uses it.
            if let Some(own) = self.resolver.defining {
                self.resolver.lets[own.index()].broken = true;
            }
            return None;
        };
        let scale = &mut self.resolver.scale;
        scale.add(size);
        if scale.depth + size.depth > DEPTH {
            let message = format!("with what `{name}` stands for this is nested too deeply; name smaller parts");
            self.resolver.sink.notation(name, message);
            return None;
        }
        if scale.terms > ALL_TERMS {
            if !std::mem::replace(&mut scale.full, true) {
                let message = format!(
                    "the names of this chart stand for more than {ALL_TERMS} terms, counted at each use; move a part into a \
                     `var` or a function"
                );
                self.resolver.sink.notation(name, message);
            }
            return None;
        }
        let (named, differs) = self.resolver.named(id);
        self.differs |= differs;
        if let Some(local) = self.local_in(named.tokens.to_token_stream()) {
            let message = format!(
                "`{local}` means something of its own here, and `{name}` stands for an expression with that name; call one \
                 of them otherwise"
            );
            self.resolver.sink.notation(name, message);
            return None;
        }
        for read in &named.reads {
            self.note(*read);
            self.places.push(Seen { read: *read, mark: Mark::from(name), within: Some(id) });
        }
        Some(named)
    }
}
