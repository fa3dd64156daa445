//! Expressions put together from others: `!a`, `a && b`.
//!
//! What is put in between is located nowhere, so that nobody takes it for the user's.

use crate::model::{Binary, Expr, Tree, Unary};
use crate::place;

/// `!a`
pub(super) fn not(a: Expr) -> Expr {
    Expr { tree: Tree::Unary(Unary::Not, Box::new(a.tree)), tokens: negated(a.tokens), ..a }
}

/// `a && b`, shown as `a`.
pub(super) fn and(a: Expr, b: Expr) -> Expr {
    both(a, b, Binary::And, and_in_rust)
}

/// `a || b`, shown as `a`.
pub(super) fn or(a: Expr, b: Expr) -> Expr {
    both(a, b, Binary::Or, or_in_rust)
}

fn both(a: Expr, b: Expr, operator: Binary, in_rust: fn(syn::Expr, syn::Expr) -> syn::Expr) -> Expr {
    let mut reads = a.reads;
    for read in b.reads {
        if !reads.contains(&read) {
            reads.push(read);
        }
    }
    let tree = Tree::Binary(operator, Box::new(a.tree), Box::new(b.tree));
    Expr { tree, tokens: in_rust(operand(a.tokens), operand(b.tokens)), reads, text: a.text, mark: a.mark }
}

/// `!a`, `!(a && b)`
pub(super) fn negated(expr: syn::Expr) -> syn::Expr {
    let op = syn::UnOp::Not(syn::token::Not(place::mixed()));
    syn::Expr::Unary(syn::ExprUnary { attrs: Vec::new(), op, expr: Box::new(operand(expr)) })
}

/// `a && b` of two that bind as tight.
pub(super) fn and_in_rust(a: syn::Expr, b: syn::Expr) -> syn::Expr {
    binary(a, b, syn::BinOp::And(syn::token::AndAnd([place::mixed(); 2])))
}

/// `a || b` of two that bind as tight.
pub(super) fn or_in_rust(a: syn::Expr, b: syn::Expr) -> syn::Expr {
    binary(a, b, syn::BinOp::Or(syn::token::OrOr([place::mixed(); 2])))
}

fn binary(a: syn::Expr, b: syn::Expr, op: syn::BinOp) -> syn::Expr {
    syn::Expr::Binary(syn::ExprBinary { attrs: Vec::new(), left: Box::new(a), op, right: Box::new(b) })
}

/// An expression that means the same beside any operator.
pub(super) fn operand(expr: syn::Expr) -> syn::Expr {
    use syn::Expr::{Call, Field, Lit, Macro, MethodCall, Paren, Path, Verbatim};
    if matches!(expr, Call(_) | Field(_) | Lit(_) | Macro(_) | MethodCall(_) | Paren(_) | Path(_) | Verbatim(_)) {
        return expr;
    }
    in_parentheses(expr)
}

pub(super) fn in_parentheses(expr: syn::Expr) -> syn::Expr {
    let paren_token = syn::token::Paren(place::mixed());
    syn::Expr::Paren(syn::ExprParen { attrs: Vec::new(), paren_token, expr: Box::new(expr) })
}
