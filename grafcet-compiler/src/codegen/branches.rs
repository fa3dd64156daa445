//! The branches of one step: what all of their conditions begin with is tested once.

use std::borrow::Cow;

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;

use super::Cx;
use super::bind::Moment;
use crate::list::List;
use crate::model::{Binary, Expr, Read, TransitionId, Tree, placeholder};
use crate::place::{self, quote};

/// One branch: under which condition it is taken, `None` for "always", and what it does.
pub(super) struct Branch<'e> {
    /// The transition, whose source steps are active here.
    pub(super) id: TransitionId,
    pub(super) condition: Option<Cow<'e, Expr>>,
    pub(super) then: TokenStream,
}

impl Cx<'_> {
    /// `{ if … { … } else if … { … } else { … } }`; the first branch whose condition holds is taken, else `stay`.
    pub(super) fn branches(&self, branches: Vec<Branch<'_>>, stay: &TokenStream) -> TokenStream {
        if let Some((common, branches)) = self.shared(&branches) {
            let common = self.branch_value(&common);
            let inner = self.branches(branches, stay);
            return quote!({ if #common #inner else { #stay } });
        }
        let mut chain = TokenStream::new();
        for branch in branches {
            let then = &branch.then;
            match self.branch_value(&branch) {
                Some(condition) => chain.extend(quote!(if #condition { #then } else)),
                // Always taken: nothing after it can be.
                None if chain.is_empty() => return quote!({ #then }),
                None => return quote!({ #chain { #then } }),
            }
        }
        if chain.is_empty() { quote!({ #stay }) } else { quote!({ #chain { #stay } }) }
    }

    fn branch_value(&self, branch: &Branch<'_>) -> Option<TokenStream> {
        branch.condition.as_ref().map(|condition| self.value(condition, Moment::Enabled(branch.id)))
    }
}

impl Cx<'_> {
    /// The conjunct that all conditions begin with, and the branches without it. One that calls functions of the user may
    /// do something when it is evaluated, and is left alone.
    fn shared<'e>(&self, branches: &[Branch<'e>]) -> Option<(Branch<'e>, Vec<Branch<'e>>)> {
        let first = first_term(&branches.first()?.condition.as_ref()?.tree);
        let begins = |branch: &Branch<'_>| {
            branch.condition.as_ref().is_some_and(|condition| first_term(&condition.tree) == first)
        };
        if branches.len() < 2 || !branches.iter().all(begins) {
            return None;
        }
        let mut common: Option<Expr> = None;
        let mut rests = Vec::with_capacity(branches.len());
        for Branch { id, condition, then } in branches {
            let (first, rest) = self.split(condition.as_ref()?)?;
            if first.tree.is_opaque() || common.as_ref().is_some_and(|common| common.tree != first.tree) {
                return None;
            }
            common = Some(first);
            rests.push(Branch { id: *id, condition: rest.map(Cow::Owned), then: then.clone() });
        }
        let id = branches.first()?.id;
        let common = Branch { id, condition: common.map(Cow::Owned), then: TokenStream::new() };
        Some((common, rests))
    }

    /// `a && (b && c)` and `(a && b) && c` begin with `a`; the rest is `None` where there is none.
    fn split(&self, condition: &Expr) -> Option<(Expr, Option<Expr>)> {
        let (tree, tokens) = parts(&condition.tree, &condition.tokens)?;
        let part = |tree: Tree, tokens: syn::Expr| {
            let mentioned = |read: &Read| {
                let name = match read {
                    Read::Name(name) => Some(self.model.value_name(*name).clone()),
                    other => placeholder::ident(*other, place::mixed()),
                };
                name.is_some_and(|name| mentions(tokens.to_token_stream(), &name.to_string()))
            };
            let reads = condition.reads.iter().copied().filter(mentioned).list();
            Expr { tree, tokens, reads, text: condition.text.clone(), mark: condition.mark }
        };
        let rest = tree.1.zip(tokens.1).map(|(tree, tokens)| part(tree, tokens));
        Some((part(tree.0, tokens.0), rest))
    }
}

/// What a condition begins with: most have nothing in common, and that is seen without taking them apart.
fn first_term(mut tree: &Tree) -> &Tree {
    while let Tree::Binary(Binary::And, left, _) = tree {
        tree = left;
    }
    tree
}

/// Whether a name stands anywhere in the tokens.
fn mentions(tokens: TokenStream, name: &str) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == name,
        TokenTree::Group(group) => mentions(group.stream(), name),
        TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    })
}

/// First and rest, of the meaning and of the tokens; `None` where the two do not have the same form.
type Parts = ((Tree, Option<Tree>), (syn::Expr, Option<syn::Expr>));

fn parts(tree: &Tree, tokens: &syn::Expr) -> Option<Parts> {
    match (tree, tokens) {
        (_, syn::Expr::Paren(paren)) => parts(tree, &paren.expr),
        (Tree::Binary(Binary::And, left, right), syn::Expr::Binary(both)) if matches!(both.op, syn::BinOp::And(_)) => {
            let (trees, expressions) = parts(left, &both.left)?;
            Some(match (trees.1, expressions.1) {
                (Some(tree), Some(rest)) => {
                    let tree = Tree::Binary(Binary::And, Box::new(tree), right.clone());
                    let mut both = both.clone();
                    both.left = Box::new(rest);
                    ((trees.0, Some(tree)), (expressions.0, Some(syn::Expr::Binary(both))))
                }
                _ => ((trees.0, Some((**right).clone())), (expressions.0, Some((*both.right).clone()))),
            })
        }
        (Tree::Binary(Binary::And, ..), _) => None,
        _ => Some(((tree.clone(), None), (tokens.clone(), None))),
    }
}
