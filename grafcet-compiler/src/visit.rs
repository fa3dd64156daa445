//! A walk through Rust of the user that may change it.
//!
//! `syn` writes the walk anew for each type that walks, some 360 functions. Here it is written for one.

use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, FieldValue, Macro, PatIdent};

/// Who walks.
pub(crate) trait Visit {
    /// Comes to an expression; [`inside`] goes on in it.
    fn expr(&mut self, expr: &mut Expr);

    /// Comes to the call of a macro, in which there are only tokens.
    fn call(&mut self, _call: &mut Macro) {}

    /// Comes to a field of a struct expression, before what is in it.
    fn field(&mut self, _field: &mut FieldValue) {}

    /// Comes to a name that a pattern binds, before what is in it.
    fn binding(&mut self, _pattern: &mut PatIdent) {}
}

/// Walks through all that is in an expression.
pub(crate) fn inside(visitor: &mut dyn Visit, expr: &mut Expr) {
    visit_mut::visit_expr_mut(&mut Walk(visitor), expr);
}

/// Walks through a block.
pub(crate) fn block(visitor: &mut dyn Visit, block: &mut Block) {
    visit_mut::visit_block_mut(&mut Walk(visitor), block);
}

struct Walk<'v>(&'v mut dyn Visit);

impl VisitMut for Walk<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        self.0.expr(expr);
    }

    fn visit_macro_mut(&mut self, call: &mut Macro) {
        self.0.call(call);
    }

    fn visit_field_value_mut(&mut self, field: &mut FieldValue) {
        self.0.field(field);
        visit_mut::visit_field_value_mut(self, field);
    }

    fn visit_pat_ident_mut(&mut self, pattern: &mut PatIdent) {
        self.0.binding(pattern);
        visit_mut::visit_pat_ident_mut(self, pattern);
    }
}
