//! Times in expressions: `5s/Step`, `t1/e/t2`, and numbers that lack their unit.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{BinOp, ExprBinary};

use super::expr::{Lower, literal, looks_like_a_variable, resolve_condition, single_name, step_path};
use super::habits;
use super::scope::Meaning;
use crate::diagnostic::{Mark, rules};
use crate::model::{Delay, Expr, Read, TimeRef, Tree, placeholder};
use crate::visit::without_parens;

/// What stands between the slashes.
pub(super) struct DelayParts {
    on: TimeRef,
    of: syn::Expr,
    off: TimeRef,
}

impl Lower<'_, '_> {
    /// The parts of `t1/e/t2`, if this division is a delay.
    pub(super) fn delay_parts(&mut self, division: &ExprBinary) -> Option<DelayParts> {
        if !matches!(division.op, BinOp::Div(_)) || self.divides_local(&division.left) {
            return None;
        }
        if let syn::Expr::Binary(inner) = &*division.left {
            if matches!(inner.op, BinOp::Div(_)) {
                if let Some(on) = self.resolver.time_of(&inner.left) {
                    return Some(self.three_part_delay(on, inner, &division.right));
                }
            }
        }
        if let Some(meant) = self.misplaced(division) {
            return Some(meant);
        }
        let on = match self.resolver.time_of(&division.left) {
            Some(on) => on,
            // `5/Heat`: a number divided by a step can only be meant as a delay.
            None if is_number(&division.left) && self.is_step(&division.right) => {
                self.resolver.no_unit(&division.left);
                TimeRef::Ticks(0)
            }
            // `(t + 1s)/Heat`
            None if self.is_step(&division.right) && single_name(&division.left).is_none() => {
                let (time, step) = (super::text::of(&division.left), super::text::of(&division.right));
                let time = time.strip_prefix('(').and_then(|time| time.strip_suffix(')')).unwrap_or(&time);
                let message =
                    format!("in front of `/` stands one time, a literal or a name; write `{step}.T >= {time}`");
                self.resolver.sink.notation(Mark::of(&division.left), message);
                TimeRef::Ticks(0)
            }
            // `soack/Soak`, too.
            None => {
                let name = single_name(&division.left)?;
                if self.is_step(&division.right) && self.is_value(&name) {
                    self.resolver.not_waited_for(&name, Some(&super::text::of(without_parens(&division.right))));
                    return Some(DelayParts {
                        on: TimeRef::Ticks(0),
                        of: (*division.right).clone(),
                        off: TimeRef::Ticks(0),
                    });
                }
                if self.is_known(&name) || !looks_like_a_variable(&name) || !self.is_step(&division.right) {
                    return None;
                }
                self.resolver.scope.unknown_name(&name, &format!("param {name}: time = 5s;"), self.resolver.sink);
                TimeRef::Ticks(0)
            }
        };
        Some(DelayParts { on, of: (*division.right).clone(), off: TimeRef::Ticks(0) })
    }

    /// What is meant by `Heat/5s`, `-5s/Heat` and `!5s/Heat`, which are reported.
    fn misplaced(&mut self, division: &ExprBinary) -> Option<DelayParts> {
        let off = TimeRef::Ticks(0);
        if self.is_step(&division.left) && matches!(&*division.right, syn::Expr::Lit(_)) {
            if let Some(on) = self.resolver.time_of(&division.right) {
                let (step, time) = (super::text::of(&division.left), super::text::of(&division.right));
                let message = format!("the time stands in front of its step: `{time}/{step}`");
                self.resolver.sink.notation(Mark::of(division), message);
                return Some(DelayParts { on, of: (*division.left).clone(), off });
            }
        }
        let syn::Expr::Unary(unary) = &*division.left else { return None };
        self.resolver.time_of(&unary.expr)?;
        let (operator, whole) = (super::text::of(unary.op), super::text::of(division));
        let delay = whole.strip_prefix(&operator).unwrap_or(&whole).trim().to_owned();
        let message = match unary.op {
            syn::UnOp::Neg(_) => format!("no time is below zero; write `{delay}`"),
            _ => format!("Rust reads this as `({}) / …`; write `{operator}({delay})`", super::text::of(unary)),
        };
        self.resolver.sink.notation(Mark::of(division), message);
        let on = self.resolver.time_of(&unary.expr)?;
        Some(DelayParts { on, of: (*division.right).clone(), off })
    }

    /// `n / 2`, where `n` is bound in the expression and no time of the chart.
    fn divides_local(&self, expr: &syn::Expr) -> bool {
        match expr {
            syn::Expr::Paren(paren) => self.divides_local(&paren.expr),
            syn::Expr::Binary(inner) if matches!(inner.op, BinOp::Div(_)) => self.divides_local(&inner.left),
            other => single_name(other).is_some_and(|name| self.locals.contains(&name)),
        }
    }

    fn is_known(&self, name: &Ident) -> bool {
        self.locals.contains(name) || self.resolver.scope.get(name).is_some()
    }

    /// Whether `name` is an input, output, variable or param.
    fn is_value(&self, name: &Ident) -> bool {
        !self.locals.contains(name) && matches!(self.resolver.scope.get(name), Some(Meaning::Value(_)))
    }

    fn is_step(&self, expr: &syn::Expr) -> bool {
        let name = step_path(without_parens(expr)).and_then(|path| path.last().cloned());
        let meaning = name.filter(|name| !self.locals.contains(name)).and_then(|name| self.resolver.scope.get(&name));
        matches!(meaning, Some(Meaning::Step(_) | Meaning::Macro(_)))
    }

    fn three_part_delay(&mut self, on: TimeRef, inner: &ExprBinary, last: &syn::Expr) -> DelayParts {
        let off = self.resolver.time_of(last).unwrap_or_else(|| {
            let message = "after the second `/` of a delay stands a time: `3s/e/2s`".to_owned();
            self.resolver.sink.notation(Mark::of(last), message);
            TimeRef::Ticks(0)
        });
        DelayParts { on, of: (*inner.right).clone(), off }
    }

    /// `t1/e/t2`; `t/Step` needs only the step's time.
    pub(super) fn delay(&mut self, parts: DelayParts, expr: &mut syn::Expr) -> Tree {
        let DelayParts { on, of, off } = parts;
        if self.refuses_locals(&of, "a delay") {
            return Tree::Bool(true);
        }
        let Some(step) = self.delayed_step(&of) else {
            if let Some(step) = self.delayed_time(&of) {
                let message = format!("`{step}.T` is a time; after `/` stands the step itself, `{step}`");
                self.resolver.sink.notation(Mark::of(&of), message);
                return Tree::Bool(true);
            }
            let of = resolve_condition(&of, self.resolver);
            let delay = self.resolver.delay(Delay { on, of, off });
            return self.replace(expr, Read::Delay(delay));
        };
        if let [name] = &step[..] {
            if let (None, Some(message)) = (self.resolver.scope.get(name), habits::delayed(name, self.resolver)) {
                self.resolver.sink.rule(&rules::UNKNOWN_STEP, &[], vec![(name.into(), message)]);
                return Tree::Bool(true);
            }
        }
        let read = match self.step(&step) {
            Some(Meaning::Step(id)) if off == TimeRef::Ticks(0) => Read::Elapsed(on, id),
            Some(Meaning::Macro(id)) if off == TimeRef::Ticks(0) => Read::MacroElapsed(on, id),
            Some(Meaning::Step(id)) => self.delay_of_activity(on, Read::Active(id), &of, off),
            Some(Meaning::Macro(id)) => self.delay_of_activity(on, Read::MacroActive(id), &of, off),
            _ => return Tree::Bool(true),
        };
        self.replace(expr, read)
    }

    /// `Step` or `Partial::Step` after the first `/`; what else it may be is an expression.
    fn delayed_step(&self, of: &syn::Expr) -> Option<Vec<Ident>> {
        let of = without_parens(of);
        let meaning = |name: &Ident| self.resolver.scope.get(name);
        let is_step = |name: &Ident| matches!(meaning(name), Some(Meaning::Step(_) | Meaning::Macro(_)));
        let path = step_path(of)?;
        let found = match &path[..] {
            [name] => is_step(name) || meaning(name).is_none() && !looks_like_a_variable(name),
            [partial, step] => self.resolver.scope.has_partial(partial) || is_step(step),
            _ => false,
        };
        found.then_some(path)
    }

    /// `Step` of `5s/Step.T`
    fn delayed_time(&self, of: &syn::Expr) -> Option<String> {
        match without_parens(of) {
            syn::Expr::Field(field) => habits::time_of_step(field, self.resolver),
            _ => None,
        }
    }

    /// `5s/Step/2s`
    fn delay_of_activity(&mut self, on: TimeRef, active: Read, step: &syn::Expr, off: TimeRef) -> Read {
        let mark = Mark::of(step);
        let tokens = placeholder::ident(active, mark.start).into_token_stream();
        let of = Expr {
            tree: Tree::Read(active),
            tokens: syn::Expr::Verbatim(tokens),
            reads: vec![active],
            text: format!("{}.X", super::text::of(step)),
            mark,
        };
        Read::Delay(self.resolver.delay(Delay { on, of, off }))
    }

    /// `Heat.T > 5` and `5/Heat`: a time has a unit.
    pub(super) fn units(&mut self, binary: &ExprBinary, left: &Tree, right: &Tree) {
        let since = |tree: &Tree| matches!(tree, Tree::Read(Read::Since(_) | Read::MacroSince(_)));
        match (left, right) {
            _ if matches!(binary.op, BinOp::Mul(_) | BinOp::Div(_)) => {}
            (time, Tree::Int(_)) if since(time) => self.resolver.no_unit(&binary.right),
            (Tree::Int(_), time) if since(time) => self.resolver.no_unit(&binary.left),
            _ => {}
        }
    }
}

fn is_number(expr: &syn::Expr) -> bool {
    matches!(expr, syn::Expr::Lit(lit) if matches!(literal(&lit.lit), Some(Tree::Int(_))))
}
