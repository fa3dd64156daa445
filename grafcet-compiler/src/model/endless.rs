//! Rust of the user that may never come back, as `todo!()`: what is generated after it is never reached, and rustc and Clippy would say so.

use syn::{Block, Macro};

use super::{Effect, Expr, Model};
use crate::list::{List, PushAll};
use crate::visit::{self, Locals, Visit};

impl Model {
    /// Whether some of a chart's conditions, values or blocks may never come back.
    pub(crate) fn may_be_endless(&self) -> bool {
        let mut expressions: Vec<&Expr> = self.transitions.values().map(|transition| &transition.condition).list();
        for association in self.associations.values() {
            expressions.push_all(&association.event);
            expressions.push_all(&association.condition);
        }
        expressions.push_all(self.edges.values().map(|edge| &edge.of));
        expressions.push_all(self.delays.values().map(|delay| &delay.of));
        expressions.into_iter().any(of_expr) || self.effects().into_iter().any(of_effect)
    }
}

fn of_effect(effect: &Effect) -> bool {
    match effect {
        Effect::Block(code) => of_block(&code.tokens),
        effect => effect.expressions().iter().any(of_expr),
    }
}

fn of_expr(expr: &Expr) -> bool {
    // What is looked into calls nothing.
    expr.tree.is_opaque() && {
        let mut endless = Endless::default();
        endless.expr(&mut expr.tokens.clone());
        endless.found
    }
}

fn of_block(block: &Block) -> bool {
    let mut endless = Endless::default();
    visit::block(&mut endless, &mut block.clone());
    endless.found
}

/// Looks for a macro, a function or a loop that may not come back. What begins with a capital letter makes a value.
#[derive(Default)]
struct Endless {
    found: bool,
    locals: Locals,
}

impl Visit for Endless {
    fn expr(&mut self, expr: &mut syn::Expr) {
        self.found |= match expr {
            syn::Expr::Loop(_) => true,
            syn::Expr::Call(call) => match &*call.func {
                syn::Expr::Path(function) => {
                    let name = function.path.segments.last().map(|segment| segment.ident.to_string());
                    name.is_some_and(|name| name.trim_start_matches("r#").starts_with(char::is_lowercase))
                }
                _ => false,
            },
            _ => false,
        };
        visit::inside(self, expr);
    }

    fn locals(&mut self) -> &mut Locals {
        &mut self.locals
    }

    fn call(&mut self, _: &mut Macro) {
        self.found = true;
    }
}
