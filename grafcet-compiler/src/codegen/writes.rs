//! Which places a block of the user has really written, where that is known only when it runs.

use proc_macro2::Ident;
use syn::{BinOp, Block, Expr, Stmt};

use crate::methods;
use crate::model::Ty;
use crate::place::quote;
use crate::visit::{self, Locals, Visit};

/// Whether the block writes the name whatever happens in it: by a statement of its own, not inside another.
pub(super) fn always(block: &Block, name: &Ident) -> bool {
    // After a pattern that binds the name it is another one.
    let own =
        block.stmts.iter().take_while(|stmt| !matches!(stmt, Stmt::Local(local) if visit::binds(&local.pat, name)));
    { own }.any(|stmt| matches!(stmt, Stmt::Expr(expr, _) if assigned(expr).contains(&name)))
}

/// The block with `note = true` after each assignment to the name, which has this type; `None` where it may be written in
/// another way.
pub(super) fn noted(block: &Block, name: &Ident, ty: &Ty, note: &Ident) -> Option<Block> {
    let mut notes = Notes { name, ty, note, locals: Locals::default(), other: false };
    let mut block = block.clone();
    visit::block(&mut notes, &mut block);
    (!notes.other).then_some(block)
}

/// The names that an assignment, plain or compound, writes.
fn assigned(expr: &Expr) -> Vec<&Ident> {
    match expr {
        Expr::Assign(assign) => methods::targets(&assign.left),
        Expr::Binary(binary) if is_compound(binary.op) => methods::targets(&binary.left),
        _ => Vec::new(),
    }
}

fn is_compound(operator: BinOp) -> bool {
    use BinOp::{
        AddAssign, BitAndAssign, BitOrAssign, BitXorAssign, DivAssign, MulAssign, RemAssign, ShlAssign, ShrAssign,
        SubAssign,
    };
    let sum = matches!(operator, AddAssign(_) | SubAssign(_) | MulAssign(_) | DivAssign(_) | RemAssign(_));
    let bits = matches!(operator, BitAndAssign(_) | BitOrAssign(_) | BitXorAssign(_));
    sum || bits || matches!(operator, ShlAssign(_) | ShrAssign(_))
}

struct Notes<'n> {
    name: &'n Ident,
    ty: &'n Ty,
    note: &'n Ident,
    locals: Locals,
    /// It is borrowed, a method that may write is called on it, or a macro sees it.
    other: bool,
}

impl Notes<'_> {
    fn is_name(&self, expr: &Expr) -> bool {
        methods::root(expr) == Some(self.name) && !self.locals.contains(self.name)
    }
}

impl Visit for Notes<'_> {
    fn expr(&mut self, expr: &mut Expr) {
        visit::inside(self, expr);
        self.other |= match expr {
            Expr::Reference(reference) => reference.mutability.is_some() && self.is_name(&reference.expr),
            Expr::RawAddr(address) => self.is_name(&address.expr),
            Expr::MethodCall(call) => self.is_name(&call.receiver) && !methods::only_reads(call, self.ty),
            _ => false,
        };
        if assigned(expr).contains(&self.name) && !self.locals.contains(self.name) {
            let note = self.note;
            *expr = Expr::Verbatim(quote!({ #expr; #note = true; }));
        }
    }

    fn locals(&mut self) -> &mut Locals {
        &mut self.locals
    }

    fn call(&mut self, _: &mut syn::Macro) {
        self.other = true;
    }

    fn binding(&mut self, pattern: &syn::PatIdent) {
        self.other |= pattern.by_ref.is_some() && pattern.mutability.is_some();
    }
}
