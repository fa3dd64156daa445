//! Rust of the user that was cut out: what `syn` reads and generated code cannot hold.

use syn::{Block, Expr};

use super::{Input, Result, leaving, unbound};
use crate::visit::{self, Visit};

/// An expression that was cut out between two places.
pub(super) fn expr(from: &Input, to: &Input, expr: &Expr) -> Result<()> {
    exprs(from, to, std::slice::from_ref(expr))
}

/// Several expressions.
pub(super) fn exprs(from: &Input, to: &Input, exprs: &[Expr]) -> Result<()> {
    leaving::check(from, to, |leaving| exprs.iter().for_each(|expr| leaving.expr(&mut expr.clone())))?;
    unbound::check(from, to, |unbound| exprs.iter().for_each(|expr| unbound.expr(&mut expr.clone())))
}

/// A block.
pub(super) fn block(from: &Input, to: &Input, block: &Block) -> Result<()> {
    leaving::check(from, to, |leaving| visit::block(leaving, &mut block.clone()))?;
    unbound::check(from, to, |unbound| visit::block(unbound, &mut block.clone()))
}
