//! Which places a block of the user has really written, where that is known only when it runs.

use proc_macro2::Ident;
use quote::quote;
use syn::{BinOp, Block, Expr, Stmt};

use crate::visit::{self, Visit};

/// Whether the block writes the name whatever happens in it: by a statement of its own, not inside another.
pub(super) fn always(block: &Block, name: &Ident) -> bool {
    block.stmts.iter().any(|stmt| matches!(stmt, Stmt::Expr(expr, _) if assigned(expr) == Some(name)))
}

/// The block with `note = true` behind each assignment to the name; `None` where it may be written in another way.
pub(super) fn noted(block: &Block, name: &Ident, note: &Ident) -> Option<Block> {
    let mut notes = Notes { name, note, other: false };
    let mut block = block.clone();
    visit::block(&mut notes, &mut block);
    (!notes.other).then_some(block)
}

/// The name that an assignment, plain or compound, writes.
fn assigned(expr: &Expr) -> Option<&Ident> {
    let left = match expr {
        Expr::Assign(assign) => &assign.left,
        Expr::Binary(binary) if is_compound(binary.op) => &binary.left,
        _ => return None,
    };
    let mut root = &**left;
    loop {
        root = match root {
            Expr::Field(field) => &field.base,
            Expr::Index(index) => &index.expr,
            Expr::Paren(paren) => &paren.expr,
            Expr::Path(path) => return path.path.get_ident(),
            _ => return None,
        };
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
    note: &'n Ident,
    /// It is borrowed, a method is called on it, or a macro sees it.
    other: bool,
}

impl Notes<'_> {
    fn is_name(&self, expr: &Expr) -> bool {
        matches!(expr, Expr::Path(path) if path.path.is_ident(self.name))
    }
}

impl Visit for Notes<'_> {
    fn expr(&mut self, expr: &mut Expr) {
        visit::inside(self, expr);
        match expr {
            Expr::Reference(reference) if reference.mutability.is_some() && self.is_name(&reference.expr) => {
                self.other = true;
            }
            Expr::MethodCall(call) if self.is_name(&call.receiver) => self.other = true,
            _ => {}
        }
        if assigned(expr) == Some(self.name) {
            let note = self.note;
            *expr = Expr::Verbatim(quote!({ #expr; #note = true; }));
        }
    }

    fn call(&mut self, _: &mut syn::Macro) {
        self.other = true;
    }
}
