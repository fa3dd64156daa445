//! `todo!()` in Rust of the user never comes back: generated code behind it is never reached, and rustc and Clippy would say so.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::ToTokens;

use crate::list::{List, PushAll};
use crate::model::{Effect, Expr, Model};
use crate::place::quote;

/// The attribute of what holds such Rust; none where nothing of it can be endless.
pub(super) fn allowed(model: &Model) -> Option<TokenStream> {
    let mut expressions: Vec<&Expr> = model.transitions.values().map(|transition| &transition.condition).list();
    for association in model.associations.values() {
        expressions.push_all(&association.event);
        expressions.push_all(&association.condition);
    }
    expressions.push_all(model.edges.values().map(|edge| &edge.of));
    expressions.push_all(model.delays.values().map(|delay| &delay.of));
    let endless = expressions.into_iter().any(is_endless) || model.effects().into_iter().any(of_effect);
    endless.then(|| quote!(#[allow(unreachable_code, clippy::diverging_sub_expression)]))
}

fn of_effect(effect: &Effect) -> bool {
    match effect {
        Effect::Block(code) => within(code.tokens.to_token_stream()),
        effect => effect.expressions().iter().any(is_endless),
    }
}

fn is_endless(expr: &Expr) -> bool {
    within(expr.tokens.to_token_stream())
}

/// Whether a macro, a function or a loop stands there that may not come back.
fn within(tokens: TokenStream) -> bool {
    let all = tokens.into_iter().list();
    all.iter().enumerate().any(|(at, tree)| match (tree, all.get(at + 1)) {
        (TokenTree::Group(group), _) => within(group.stream()),
        (TokenTree::Ident(name), _) if name == "loop" => true,
        (TokenTree::Ident(name), Some(TokenTree::Punct(sign))) if sign.as_char() == '!' => {
            name != "matches" && matches!(all.get(at + 2), Some(TokenTree::Group(_)))
        }
        (TokenTree::Ident(name), Some(TokenTree::Group(group))) if group.delimiter() == Delimiter::Parenthesis => {
            let is_method = matches!(all[..at].last(), Some(TokenTree::Punct(dot)) if dot.as_char() == '.');
            let is_name = syn::parse2::<Ident>(name.to_token_stream()).is_ok();
            is_name && !is_method && name.to_string().starts_with(char::is_lowercase)
        }
        _ => false,
    })
}
