//! A walk through Rust of the user that may change it, and which names Rust itself binds where it stands.
//!
//! `syn` writes the walk anew for each type that walks, some 360 functions. Here it is written for one.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::visit_mut::{self, VisitMut};
use syn::{Arm, Block, Expr, FieldValue, Item, Local, Macro, Pat, PatIdent, Stmt, Token};

/// An expression without the parentheses around it.
pub(crate) fn without_parens(expr: &Expr) -> &Expr {
    match expr {
        Expr::Paren(paren) => without_parens(&paren.expr),
        other => other,
    }
}

/// Whether Rust takes an expression for a whole statement where one begins with it.
pub(crate) fn is_block(expr: &Expr) -> bool {
    match expr {
        Expr::Macro(call) => matches!(call.mac.delimiter, syn::MacroDelimiter::Brace(_)),
        Expr::Block(_)
        | Expr::Const(_)
        | Expr::ForLoop(_)
        | Expr::If(_)
        | Expr::Loop(_)
        | Expr::Match(_)
        | Expr::TryBlock(_)
        | Expr::Unsafe(_)
        | Expr::While(_) => true,
        _ => false,
    }
}

/// Whether an expression goes on after such a block at its beginning: `{ … } && a`, `match x { … } > 3`.
pub(crate) fn begins_with_block(expr: &Expr) -> bool {
    let first = match expr {
        Expr::Assign(assign) => &assign.left,
        Expr::Await(awaited) => &awaited.base,
        Expr::Binary(binary) => &binary.left,
        Expr::Call(call) => &call.func,
        Expr::Cast(cast) => &cast.expr,
        Expr::Field(field) => &field.base,
        Expr::Index(index) => &index.expr,
        Expr::MethodCall(call) => &call.receiver,
        Expr::Range(range) => match &range.start {
            Some(start) => start,
            None => return false,
        },
        Expr::Try(tried) => &tried.expr,
        _ => return false,
    };
    is_block(first) || begins_with_block(first)
}

/// Who walks.
pub(crate) trait Visit {
    /// Comes to an expression; [`inside`] goes on in it.
    fn expr(&mut self, expr: &mut Expr);

    /// The names that are bound where the walk stands. The walk keeps them up to date.
    fn locals(&mut self) -> &mut Locals;

    /// Comes to the call of a macro, in which there are only tokens.
    fn call(&mut self, _call: &mut Macro) {}

    /// Leaves a field of a struct expression.
    fn field(&mut self, _field: &mut FieldValue) {}

    /// Comes to a name that a pattern binds.
    fn binding(&mut self, _pattern: &PatIdent) {}
}

/// The names that `let`, patterns, arguments of closures and items inside blocks bind, each as long as its scope.
#[derive(Default)]
pub(crate) struct Locals {
    names: Vec<String>,
    /// How many names there were at the beginning of each open scope.
    open: Vec<usize>,
}

impl Locals {
    /// Whether `name` is bound here.
    pub(crate) fn contains(&self, name: &Ident) -> bool {
        !self.names.is_empty() && self.names.contains(&key(name))
    }

    pub(crate) fn bind(&mut self, name: &Ident) {
        self.names.push(key(name));
    }

    pub(crate) fn enter(&mut self) {
        self.open.push(self.names.len());
    }

    pub(crate) fn leave(&mut self) {
        self.names.truncate(self.open.pop().unwrap_or(0));
    }
}

/// A name without `r#`.
fn key(name: &Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

/// Walks through all that is in an expression.
pub(crate) fn inside(visitor: &mut dyn Visit, expr: &mut Expr) {
    visit_mut::visit_expr_mut(&mut Shower(visitor), expr);
}

/// Walks through a block.
pub(crate) fn block(visitor: &mut dyn Visit, block: &mut Block) {
    Shower(visitor).visit_block_mut(block);
}

/// Whether a pattern binds the name, or may do so by a macro.
pub(crate) fn binds(pattern: &Pat, name: &Ident) -> bool {
    let mut bound = Bound::default();
    Shower(&mut bound).visit_pat_mut(&mut pattern.clone());
    bound.calls || bound.names.contains(name)
}

/// Whoever asks for nothing but names.
#[derive(Default)]
struct Bound {
    names: Locals,
    calls: bool,
}

impl Visit for Bound {
    fn expr(&mut self, _: &mut Expr) {}

    fn locals(&mut self) -> &mut Locals {
        &mut self.names
    }

    fn call(&mut self, _: &mut Macro) {
        self.calls = true;
    }
}

/// Shows all that `syn` visits to a visitor of ours.
struct Shower<'v>(&'v mut dyn Visit);

impl Shower<'_> {
    /// Walks through what is a scope of its own.
    fn scope(&mut self, walk: impl FnOnce(&mut Self)) {
        self.0.locals().enter();
        walk(self);
        self.0.locals().leave();
    }
}

impl VisitMut for Shower<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        self.0.expr(expr);
    }

    fn visit_macro_mut(&mut self, call: &mut Macro) {
        let name = call.path.segments.last().map(|segment| segment.ident.to_string());
        let matched = (name.as_deref() == Some("matches")).then(|| call.parse_body::<Matches>());
        let Some(Ok(mut matched)) = matched else { return self.0.call(call) };
        self.visit_expr_mut(&mut matched.expr);
        self.scope(|walk| {
            walk.visit_pat_mut(&mut matched.pattern);
            if let Some(guard) = &mut matched.guard {
                walk.visit_expr_mut(guard);
            }
        });
        call.tokens = matched.into_tokens();
    }

    fn visit_field_value_mut(&mut self, field: &mut FieldValue) {
        visit_mut::visit_field_value_mut(self, field);
        self.0.field(field);
    }

    fn visit_pat_ident_mut(&mut self, pattern: &mut PatIdent) {
        self.0.binding(pattern);
        self.0.locals().bind(&pattern.ident);
        visit_mut::visit_pat_ident_mut(self, pattern);
    }

    fn visit_block_mut(&mut self, block: &mut Block) {
        self.scope(|walk| {
            // Items are known in all of their block.
            for stmt in &block.stmts {
                if let Stmt::Item(Item::Const(syn::ItemConst { ident, .. })) = stmt {
                    walk.0.locals().bind(ident);
                } else if let Stmt::Item(Item::Static(syn::ItemStatic { ident, .. })) = stmt {
                    walk.0.locals().bind(ident);
                } else if let Stmt::Item(Item::Fn(function)) = stmt {
                    walk.0.locals().bind(&function.sig.ident);
                }
            }
            visit_mut::visit_block_mut(walk, block);
        });
    }

    /// An item sees nothing of what is around it.
    fn visit_item_mut(&mut self, _: &mut Item) {}

    /// What is after `=` and `else` does not see the names of the pattern.
    fn visit_local_mut(&mut self, local: &mut Local) {
        if let Some(init) = &mut local.init {
            self.visit_expr_mut(&mut init.expr);
            if let Some((_, diverge)) = &mut init.diverge {
                self.visit_expr_mut(diverge);
            }
        }
        self.visit_pat_mut(&mut local.pat);
    }

    /// `let` in a condition.
    fn visit_expr_let_mut(&mut self, condition: &mut syn::ExprLet) {
        self.visit_expr_mut(&mut condition.expr);
        self.visit_pat_mut(&mut condition.pat);
    }

    fn visit_expr_if_mut(&mut self, branch: &mut syn::ExprIf) {
        self.scope(|walk| {
            walk.visit_expr_mut(&mut branch.cond);
            walk.visit_block_mut(&mut branch.then_branch);
        });
        if let Some((_, otherwise)) = &mut branch.else_branch {
            self.visit_expr_mut(otherwise);
        }
    }

    fn visit_expr_while_mut(&mut self, repeated: &mut syn::ExprWhile) {
        self.scope(|walk| visit_mut::visit_expr_while_mut(walk, repeated));
    }

    fn visit_expr_for_loop_mut(&mut self, repeated: &mut syn::ExprForLoop) {
        self.visit_expr_mut(&mut repeated.expr);
        self.scope(|walk| {
            walk.visit_pat_mut(&mut repeated.pat);
            walk.visit_block_mut(&mut repeated.body);
        });
    }

    fn visit_arm_mut(&mut self, arm: &mut Arm) {
        self.scope(|walk| visit_mut::visit_arm_mut(walk, arm));
    }

    fn visit_expr_closure_mut(&mut self, closure: &mut syn::ExprClosure) {
        self.scope(|walk| visit_mut::visit_expr_closure_mut(walk, closure));
    }
}

/// What stands in `matches!(…)`: the one macro of the standard library that binds names.
struct Matches {
    expr: Expr,
    pattern: Pat,
    guard: Option<Expr>,
}

impl Parse for Matches {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let expr = input.parse()?;
        input.parse::<Token![,]>()?;
        let pattern = Pat::parse_multi_with_leading_vert(input)?;
        let guard = if input.peek(Token![if]) { Some((input.parse::<Token![if]>()?, input.parse()?).1) } else { None };
        input.parse::<Option<Token![,]>>()?;
        Ok(Self { expr, pattern, guard })
    }
}

impl Matches {
    fn into_tokens(self) -> TokenStream {
        let Self { expr, pattern, guard } = self;
        let guard = guard.map(|guard| quote!(if #guard));
        quote!(#expr, #pattern #guard)
    }
}
