//! Rust inside an expression that is not looked into: only its names are resolved.

use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::ToTokens;

use super::expr::{Lower, Seen, single_name};
use super::names::is_of_step;
use super::scope::Meaning;
use crate::list::PushAll;
use crate::model::{How, Read, Tree};
use crate::visit::{self, Locals, Visit};

impl Lower<'_, '_> {
    /// The meaning is the text alone, and what is read.
    pub(super) fn opaque(&mut self, expr: &mut syn::Expr) -> Tree {
        let text = super::text::of(&*expr);
        let differs = self.may_differ(expr);
        // `const { … }` is evaluated once and for all.
        let is_constant = matches!(expr, syn::Expr::Const(_));
        let around = self.differs;
        let (is_whole, is_open) = (self.is_whole(expr), self.is_open(expr));
        let mut computed = None;
        let walk = |lower: &mut Self| {
            computed = lower.computed(expr);
            if computed.is_none() {
                visit::inside(lower, expr);
            }
        };
        match self.rust(text, differs, walk) {
            Tree::Opaque { text, reads, .. } if is_constant => {
                self.differs = around;
                Tree::Opaque { text, reads, call: None, whole: false, open: false, of: None }
            }
            Tree::Opaque { text, reads, call, .. } => {
                let of = computed.filter(|computed| is_whole || computed.how == How::If).map(Box::new);
                Tree::Opaque { text, reads, call, whole: is_whole, open: is_open, of }
            }
            tree => tree,
        }
    }

    /// The meaning of Rust that `walk` goes through; each evaluation `differs` from others.
    pub(super) fn rust(&mut self, text: String, differs: bool, walk: impl FnOnce(&mut Self)) -> Tree {
        let (outside, around) = (std::mem::take(&mut self.reads), std::mem::replace(&mut self.differs, differs));
        walk(self);
        let reads = std::mem::replace(&mut self.reads, outside);
        let differs = std::mem::replace(&mut self.differs, around);
        self.differs |= differs;
        for read in &reads {
            self.note(*read);
        }
        let call = self.evaluation(differs);
        Tree::Opaque { text, reads, call, whole: false, open: false, of: None }
    }

    /// Inside a macro call there are only tokens: declared names are noted, step variables replaced.
    fn macro_tokens(&mut self, tokens: TokenStream) -> TokenStream {
        let mut out = Vec::new();
        for tree in tokens {
            match tree {
                TokenTree::Group(group) => {
                    let mut inner = Group::new(group.delimiter(), self.macro_tokens(group.stream()));
                    inner.set_span(group.span());
                    out.push(TokenTree::Group(inner));
                }
                TokenTree::Ident(name) => {
                    self.macro_ident(&name, &mut out);
                }
                other => out.push(other),
            }
        }
        out.into_iter().collect()
    }

    /// Appends `name`, or the placeholder of `Step.X` when `name` is its `X`.
    fn macro_ident(&mut self, name: &Ident, out: &mut Vec<TokenTree>) {
        if is_of_step(name) {
            if let [.., TokenTree::Ident(step), TokenTree::Punct(dot)] = &out[..] {
                if dot.as_char() == '.' {
                    let mut field: syn::Expr = syn::parse_quote_spanned!(step.span()=> #step.#name);
                    let local = self.locals.contains(step);
                    let meaning = self.resolver.scope.get(step);
                    let is_step = matches!(meaning, Some(Meaning::Step(_) | Meaning::Macro(_)));
                    if !local && (is_step || name != "late" && !matches!(meaning, Some(Meaning::Value(_)))) {
                        self.lower(&mut field);
                        out.truncate(out.len() - 2);
                        out.push_all(field.into_token_stream());
                        return;
                    }
                }
            }
        }
        let is_field = matches!(out.last(), Some(TokenTree::Punct(p)) if p.as_char() == '.');
        let is_other = is_field || self.locals.contains(name);
        if let (false, Some(Meaning::Let(id))) = (is_other, self.resolver.scope.get(name)) {
            out.push(self.tokens_in_place(name, id));
            return;
        }
        if let (false, Some(Meaning::Value(value))) = (is_other, self.resolver.scope.get(name)) {
            self.note(Read::Name(value));
            self.places.push(Seen { read: Read::Name(value), mark: name.into(), within: None });
            let mut name = name.clone();
            name.set_span(name.span().resolved_at(self.resolver.model.value_name(value).span()));
            out.push(TokenTree::Ident(name));
            return;
        }
        out.push(TokenTree::Ident(name.clone()));
    }
}

impl Visit for Lower<'_, '_> {
    fn expr(&mut self, expr: &mut syn::Expr) {
        self.lower(expr);
    }

    fn locals(&mut self) -> &mut Locals {
        &mut self.locals
    }

    fn call(&mut self, call: &mut syn::Macro) {
        self.differs |= !self.is_pure_macro(&call.path);
        call.tokens = self.macro_tokens(std::mem::take(&mut call.tokens));
    }

    fn field(&mut self, field: &mut syn::FieldValue) {
        if field.colon_token.is_some() {
            return;
        }
        match single_name(&field.expr).filter(|name| field.member == name.clone().into()) {
            // `Point { x: x }` would be a lint's business.
            Some(name) => field.member = name.into(),
            // `Point { x }` would lose its name where something else stands for `x`.
            None => field.colon_token = Some(syn::token::Colon::default()),
        }
    }
}
