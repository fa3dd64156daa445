//! What generated code says of states, and an expression of the user outside a cycle.

use proc_macro2::{Group, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote_spanned};

use super::rust::{plain_name, with_bindings};
use super::{Cx, names};
use crate::list::List;
use crate::model::{Binary, Expr, Name, Read, StepId, Tree, Ty, Unary, placeholder};
use crate::place::{self, quote};
use crate::program::RegionId;
use crate::visit::without_parens;

impl Cx<'_> {
    /// The value of an expression that reads inputs and the recipe alone.
    pub(super) fn value(&self, expr: &Expr) -> TokenStream {
        let p = &self.p;
        let is_input = matches!(expr.reads[..], [Read::Name(Name::Input(_))]);
        self.bound((&expr.tokens, &expr.tree), is_input, !expr.reads.is_empty(), &|| {
            let bindings = expr.reads.iter().filter_map(|read| {
                let value = match read {
                    Read::Name(name) => {
                        let bound = self.model.value_name(*name);
                        let of_input = matches!(name, Name::Input(_));
                        if of_input { quote!(inputs_.#bound) } else { quote!(self.params.#bound) }
                    }
                    Read::Ticks(ticks) => quote!(#p::Ticks::new(#ticks)),
                    _ => return None,
                };
                Some(self.binding(*read, &value, expr.tree.is_opaque()))
            });
            bindings.tokens()
        })
    }

    /// An expression of the user after bindings of what it reads, if it has to read anything: whether that `is_input`, an input alone.
    pub(super) fn bound(
        &self,
        (tokens, tree): (&syn::Expr, &Tree),
        is_input: bool,
        reads: bool,
        bindings: &dyn Fn() -> TokenStream,
    ) -> TokenStream {
        let tokens = without_parens(tokens);
        // An input alone needs no binding: the user's own token names the field.
        if let (true, Some(name)) = (is_input, plain_name(tokens)) {
            // Located there, so that a type error stands there.
            return quote_spanned!(Span::call_site().located_at(name.span())=> inputs_.#name);
        }
        if reads && self.is_logic(tree) {
            return self.with_inputs(tokens.to_token_stream());
        }
        with_bindings(&bindings(), tokens)
    }

    /// `let on = inputs_.on;` In Rust that is not looked into (`opaque`) a name that is mentioned may stand for something of its own.
    pub(super) fn binding(&self, read: Read, value: &TokenStream, opaque: bool) -> TokenStream {
        let name = match read {
            Read::Name(name) => self.model.value_name(name).clone(),
            other => placeholder::ident(other, place::mixed()).unwrap_or_else(|| names::local("unnamed")),
        };
        let unused = opaque.then(|| quote!(#[allow(unused_variables)]));
        quote!(#unused let #name = #value;)
    }

    /// Whether an expression is made of boolean inputs, `!`, `&&` and `||` alone.
    pub(super) fn is_logic(&self, tree: &Tree) -> bool {
        match tree {
            Tree::Read(Read::Name(Name::Input(id))) => matches!(self.model.inputs[*id].ty, Ty::Bool(_)),
            Tree::Unary(Unary::Not, operand) => self.is_logic(operand),
            Tree::Binary(Binary::And | Binary::Or, left, right) => self.is_logic(left) && self.is_logic(right),
            _ => false,
        }
    }

    /// Tokens with `inputs.on` where they say `on`.
    pub(super) fn with_inputs(&self, tokens: TokenStream) -> TokenStream {
        let one = |token: TokenTree| match token {
            TokenTree::Ident(name) if self.model.inputs.values().any(|input| input.name == name) => {
                // Located there, so that a type error stands there.
                quote_spanned!(Span::call_site().located_at(name.span())=> inputs_.#name)
            }
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), self.with_inputs(group.stream()));
                inner.set_span(group.span());
                TokenTree::Group(inner).into()
            }
            other => other.into(),
        };
        tokens.into_iter().map(one).tokens()
    }

    /// `__MotorState::Off`
    pub(super) fn variant(&self, step: StepId) -> TokenStream {
        self.variant_of(step, self.plan.regions.of_step(step))
    }

    /// The state that is named after a step, in a region that is perhaps another one's.
    pub(super) fn variant_of(&self, step: StepId, region: RegionId) -> TokenStream {
        let region = self.names.region(region, self.plan);
        let step = names::private_variant(self.model, step);
        quote!(#region::#step)
    }

    /// `__MotorState::NONE`
    pub(super) fn empty(&self, region: RegionId) -> TokenStream {
        let (region, empty) = (self.names.region(region, self.plan), &self.names.empty);
        quote!(#region::#empty)
    }
}
