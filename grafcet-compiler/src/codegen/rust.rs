//! Rust of the user, as it may stand in generated code.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::ToTokens;

use crate::list::List;
use crate::model::{Expr, Read, placeholder};
use crate::place::{self, quote};
use crate::visit::begins_with_block;

/// A constant expression: literals, times and Rust constants.
pub(super) fn constant(expr: &Expr, p: &TokenStream) -> TokenStream {
    let bindings: TokenStream = expr
        .reads
        .iter()
        .filter_map(|read| match read {
            Read::Ticks(ticks) => {
                let name = placeholder::ident(*read, place::mixed())?;
                Some(quote!(let #name = #p::Ticks::new(#ticks);))
            }
            _ => None,
        })
        .tokens();
    let tokens = &expr.tokens;
    if bindings.is_empty() { tokens.to_token_stream() } else { quote!({ #bindings #tokens }) }
}

/// An expression after the bindings of what it reads.
pub(super) fn with_bindings(bindings: &TokenStream, tokens: &syn::Expr) -> TokenStream {
    if bindings.is_empty() && is_term(tokens) && !shows_struct(tokens) {
        return tokens.to_token_stream();
    }
    if begins_with_block(tokens) {
        // Rust would take the block for a statement.
        return quote!({ #bindings let value_ = #tokens; value_ });
    }
    quote!({ #bindings #tokens })
}

pub(super) fn plain_name(expr: &syn::Expr) -> Option<&Ident> {
    match expr {
        syn::Expr::Path(path) => path.path.get_ident(),
        _ => None,
    }
}

/// A term without the parentheses it has for the sake of the operators around it, where there are none.
pub(super) fn bare(term: TokenStream) -> TokenStream {
    let mut trees = term.clone().into_iter();
    match (trees.next(), trees.next()) {
        (Some(TokenTree::Group(group)), None) if group.delimiter() == Delimiter::Parenthesis => group.stream(),
        _ => term,
    }
}

/// Whether an expression means the same beside any operator that generated code puts there.
pub(super) fn is_term(expr: &syn::Expr) -> bool {
    use syn::Expr::{Array, Block, Call, Field, Index, Lit, Macro, MethodCall, Path, Tuple, Unary};
    let lists = matches!(expr, Array(_) | Block(_) | Call(_) | Macro(_) | MethodCall(_) | Tuple(_));
    lists || matches!(expr, Field(_) | Index(_) | Lit(_) | Path(_) | Unary(_))
}

/// Whether braces of a struct stand open in an expression, which Rust takes for a block after `if`: `!Foo {}`.
pub(super) fn shows_struct(expr: &syn::Expr) -> bool {
    match expr {
        syn::Expr::Struct(_) => true,
        syn::Expr::Unary(unary) => shows_struct(&unary.expr),
        syn::Expr::Call(call) => shows_struct(&call.func),
        syn::Expr::Index(index) => shows_struct(&index.expr),
        syn::Expr::Field(field) => shows_struct(&field.base),
        syn::Expr::MethodCall(call) => shows_struct(&call.receiver),
        _ => false,
    }
}
