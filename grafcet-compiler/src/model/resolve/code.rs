//! Rust blocks behind a qualifier, an event or `=>`.

use syn::{BinOp, Block, Stmt};

use super::Resolver;
use super::expr::{Lower, single_name};
use super::foreign::locals_of_block;
use super::scope::{Meaning, Scope};
use crate::model::{Binary, Code, Name, Place, Statement, Tree};
use crate::visit::{self, Visit};

/// Resolves one block of the user.
pub(super) fn resolve(block: &Block, resolver: &mut Resolver<'_>) -> Code {
    let mut writes = Writes { scope: &resolver.scope, places: Vec::new() };
    visit::block(&mut writes, &mut block.clone());
    let writes = writes.places;

    let mut lower = Lower::new(resolver);
    locals_of_block(&mut block.clone(), &mut lower.locals);
    let mut tokens = block.clone();
    visit::block(&mut lower, &mut tokens);
    let reads = std::mem::take(&mut lower.reads);
    let statements = statements(&mut block.clone(), &mut lower);
    Code { tokens, statements, reads, writes, text: super::text::of(block) }
}

/// The statements of a block, where all of them are understood.
fn statements(block: &mut Block, lower: &mut Lower<'_, '_>) -> Option<Vec<Statement>> {
    block.stmts.iter_mut().map(|stmt| statement(stmt, lower)).collect()
}

fn statement(stmt: &mut Stmt, lower: &mut Lower<'_, '_>) -> Option<Statement> {
    let Stmt::Expr(expr, _) = stmt else { return None };
    match expr {
        syn::Expr::Assign(assign) => {
            let place = lower.place(&assign.left)?;
            Some(Statement::Assign(place, lower.lower(&mut assign.right)))
        }
        syn::Expr::Binary(binary) => {
            let operator = compound(&binary.op)?;
            let place = lower.place(&binary.left)?;
            let old = lower.lower(&mut binary.left);
            let value = lower.lower(&mut binary.right);
            Some(Statement::Assign(place, Tree::Binary(operator, Box::new(old), Box::new(value))))
        }
        syn::Expr::If(branch) => {
            let condition = lower.lower(&mut branch.cond);
            let then = statements(&mut branch.then_branch, lower)?;
            let otherwise = match &mut branch.else_branch {
                None => Vec::new(),
                Some((_, expr)) => match &mut **expr {
                    syn::Expr::Block(block) => statements(&mut block.block, lower)?,
                    other => vec![statement(&mut Stmt::Expr(other.clone(), None), lower)?],
                },
            };
            Some(Statement::If(condition, then, otherwise))
        }
        _ => None,
    }
}

/// The operator of a compound assignment.
fn compound(op: &BinOp) -> Option<Binary> {
    Some(match op {
        BinOp::AddAssign(_) => Binary::Add,
        BinOp::SubAssign(_) => Binary::Sub,
        BinOp::MulAssign(_) => Binary::Mul,
        BinOp::DivAssign(_) => Binary::Div,
        BinOp::RemAssign(_) => Binary::Rem,
        BinOp::BitXorAssign(_) => Binary::BitXor,
        BinOp::BitAndAssign(_) => Binary::BitAnd,
        BinOp::BitOrAssign(_) => Binary::BitOr,
        BinOp::ShlAssign(_) => Binary::Shl,
        BinOp::ShrAssign(_) => Binary::Shr,
        _ => return None,
    })
}

/// The places a block may write: assigned, borrowed mutably, the receiver of a method, or seen by a macro.
struct Writes<'a> {
    scope: &'a Scope,
    places: Vec<Place>,
}

impl Writes<'_> {
    fn note(&mut self, expr: &syn::Expr) {
        let mut root = expr;
        loop {
            root = match root {
                syn::Expr::Field(field) => &field.base,
                syn::Expr::Index(index) => &index.expr,
                syn::Expr::Paren(paren) => &paren.expr,
                _ => break,
            };
        }
        if let Some(name) = single_name(root) {
            self.note_name(&name);
        }
    }

    fn note_name(&mut self, name: &syn::Ident) {
        let place = match self.scope.get(name) {
            Some(Meaning::Value(Name::Output(id))) => Place::Output(id),
            Some(Meaning::Value(Name::Var(id))) => Place::Var(id),
            _ => return,
        };
        if !self.places.contains(&place) {
            self.places.push(place);
        }
    }

    fn note_tokens(&mut self, tokens: proc_macro2::TokenStream) {
        for tree in tokens {
            match tree {
                proc_macro2::TokenTree::Group(group) => self.note_tokens(group.stream()),
                proc_macro2::TokenTree::Ident(name) => self.note_name(&name),
                _ => {}
            }
        }
    }
}

impl Visit for Writes<'_> {
    fn expr(&mut self, expr: &mut syn::Expr) {
        match expr {
            syn::Expr::Assign(assign) => self.note(&assign.left),
            syn::Expr::Binary(binary) if compound(&binary.op).is_some() => self.note(&binary.left),
            syn::Expr::Reference(reference) if reference.mutability.is_some() => self.note(&reference.expr),
            syn::Expr::MethodCall(call) => self.note(&call.receiver),
            _ => {}
        }
        visit::inside(self, expr);
    }

    fn call(&mut self, call: &mut syn::Macro) {
        self.note_tokens(call.tokens.clone());
    }
}
