//! `let Some(x) = n` where no `if`, `while` or guard of the user binds its names: generated code would begin with it, and it would
//! be a statement there.

use syn::{BinOp, Expr, Pat};

use super::{Error, Input, Result};
use crate::diagnostic::Mark;
use crate::visit::{self, Locals, Visit};

/// Refuses it in Rust that was cut out between two places.
pub(super) fn check(from: &Input, to: &Input, walk: impl FnOnce(&mut Unbound)) -> Result<()> {
    // Few charts have this word: only these are walked through.
    if !from.names_until(to).any(|name| name == "let") {
        return Ok(());
    }
    let mut unbound = Unbound::default();
    walk(&mut unbound);
    Error::several(unbound.notes).map_or(Ok(()), Err)
}

#[derive(Default)]
pub(super) struct Unbound {
    notes: Vec<(Mark, String)>,
    locals: Locals,
}

impl Unbound {
    /// What stands after `if` or `while`, where `let` may stand between `&&`.
    fn condition(&mut self, condition: &mut Expr) {
        match condition {
            Expr::Let(binding) => self.expr(&mut binding.expr),
            Expr::Binary(both) if matches!(both.op, BinOp::And(_)) => {
                self.condition(&mut both.left);
                self.condition(&mut both.right);
            }
            other => self.expr(other),
        }
    }
}

impl Visit for Unbound {
    fn expr(&mut self, expr: &mut Expr) {
        match expr {
            Expr::Let(binding) => {
                let message = "`let` has no value and binds names only after `if` and `while` of Rust; whether a pattern fits is \
                               written `matches!(…)`, as in `matches!(value, Some(x) if x > 3)`";
                self.notes.push((binding.let_token.span.into(), message.to_owned()));
                self.expr(&mut binding.expr);
            }
            Expr::If(branch) => {
                self.condition(&mut branch.cond);
                visit::block(self, &mut branch.then_branch);
                if let Some((_, otherwise)) = &mut branch.else_branch {
                    self.expr(otherwise);
                }
            }
            Expr::While(repeated) => {
                self.condition(&mut repeated.cond);
                visit::block(self, &mut repeated.body);
            }
            Expr::Match(choice) => {
                self.expr(&mut choice.expr);
                for arm in &mut choice.arms {
                    if let Pat::Guard(guarded) = &mut arm.pat {
                        self.condition(&mut guarded.guard);
                    }
                    self.expr(&mut arm.body);
                }
            }
            other => visit::inside(self, other),
        }
    }

    fn locals(&mut self) -> &mut Locals {
        &mut self.locals
    }
}
