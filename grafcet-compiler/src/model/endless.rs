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

/// Whether a call by this name may run Rust; what a macro was given stands in a group of its own.
fn is_function(called: &syn::Expr) -> bool {
    match called {
        syn::Expr::Group(group) => is_function(&group.expr),
        syn::Expr::Paren(paren) => is_function(&paren.expr),
        syn::Expr::Path(function) => {
            let name = function.path.segments.last().map(|segment| segment.ident.to_string());
            name.is_some_and(|name| !name.starts_with(char::is_uppercase))
        }
        // What an expression comes to, as a closure.
        _ => true,
    }
}

impl Visit for Endless {
    fn expr(&mut self, expr: &mut syn::Expr) {
        self.found |= match expr {
            syn::Expr::Loop(_) => true,
            syn::Expr::Call(call) => is_function(&call.func),
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

#[cfg(test)]
mod tests {
    use crate::diagnostic::Sink;
    use crate::{model, parse};

    fn may_be_endless(condition: &str, block: &str) -> bool {
        let text = format!(
            "sfc C {{ input a: bool; output n: u8; initial step A; step B {{ P1 {{ {block} }} }} A -[{condition}]-> B -[a]-> A; }}"
        );
        let mut sink = Sink::new();
        let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
        let model = model::resolve(&chart, &mut sink);
        _ = sink.finish();
        model.may_be_endless()
    }

    #[test]
    fn rust_that_may_never_come_back() {
        for condition in ["todo!()", "a && asked()", "(asked)()", "own::asked(a)", "matches!(asked(), 1)", "(|| a)()"] {
            assert!(may_be_endless(condition, "n = 1;"), "{condition}");
        }
        for block in ["loop { n = 1; }", "n = 1; todo!();", "n = if a { todo!() } else { 1 };", "wait();"] {
            assert!(may_be_endless("a", block), "{block}");
        }
    }

    #[test]
    fn rust_that_comes_back() {
        for condition in ["a", "matches!(n, 1 | 2)", "n.pow(2) > 3", "Some(n) == Some(1)", "rising(a)"] {
            assert!(!may_be_endless(condition, "n = 1;"), "{condition}");
        }
        assert!(!may_be_endless("a", "if a { n += 1; }"));
    }
}
