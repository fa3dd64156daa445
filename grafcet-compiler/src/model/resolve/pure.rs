//! Which Rust has the same value whenever it is evaluated on the same operands.
//!
//! Operators, fields and patterns have, and so do the methods of the standard library by `self` or `&self` on types that are
//! known. Nobody sees what else a call does: it may count, or look at a pin. What the chart says is pure is taken for it.

use quote::ToTokens;
use syn::{Expr, ExprMethodCall, Lit, UnOp};

use super::Resolver;
use super::computed::{limit, made_from};
use super::declare::Where;
use super::expr::{Lower, step_path};
use super::scope::Meaning;
use crate::diagnostic::{Mark, rules};
use crate::list::{List, PushAll};
use crate::methods::{self, Kind};
use crate::model::Ty;

/// What a method is called on.
enum Value<'t> {
    Of(Kind<'t>),
    /// Of what belongs to a known value.
    Iterator,
    Unknown,
}

const ITERATORS: [&str; 6] = ["iter", "into_iter", "chars", "bytes", "windows", "chunks"];

const ADAPTORS: [&str; 11] =
    ["map", "filter", "rev", "skip", "take", "zip", "enumerate", "copied", "cloned", "chain", "step_by"];

const ENDS: [&str; 10] = ["any", "all", "count", "sum", "product", "min", "max", "position", "fold", "last"];

const MACROS: [&str; 9] = ["matches", "cfg", "concat", "stringify", "line", "column", "file", "env", "option_env"];

impl Lower<'_, '_> {
    /// Whether the expression itself, apart from what is in it, may have another value each time.
    pub(super) fn may_differ(&mut self, expr: &Expr) -> bool {
        match expr {
            Expr::Call(call) => !self.is_pure_function(&call.func),
            Expr::MethodCall(call) => !self.is_pure_method(call),
            Expr::Macro(call) => !self.is_pure_macro(&call.mac.path),
            Expr::Unsafe(_) | Expr::Await(_) | Expr::Async(_) | Expr::Verbatim(_) => true,
            _ => false,
        }
    }

    pub(super) fn is_pure_function(&mut self, function: &Expr) -> bool {
        let Expr::Path(path) = function else { return false };
        let names: Vec<String> = path.path.segments.iter().map(|segment| segment.ident.to_string()).list();
        let Some(last) = names.last() else { return false };
        // `Some(level)`, `Point(x, y)`; `u16::from(level)`.
        let makes = last.starts_with(char::is_uppercase);
        let of_number = names.len() == 2 && methods::is_primitive(&names[0]);
        let compares = names.len() == 3 && ["core", "std"].contains(&&*names[0]) && names[1] == "cmp";
        path.qself.is_none() && (makes || of_number || compares || self.is_said_pure(&names.join("::")))
    }

    fn is_pure_method(&mut self, call: &ExprMethodCall) -> bool {
        self.is_known_method(call) || self.is_said_pure(&call.method.to_string())
    }

    fn is_known_method(&self, call: &ExprMethodCall) -> bool {
        let name = call.method.to_string();
        match self.value_of(&call.receiver) {
            Value::Of(kind) => methods::reads(&kind, &name),
            Value::Iterator => ADAPTORS.contains(&&*name) || ENDS.contains(&&*name),
            Value::Unknown => false,
        }
    }

    pub(super) fn is_pure_macro(&mut self, path: &syn::Path) -> bool {
        let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).list();
        names.last().is_some_and(|last| MACROS.contains(&&**last)) || self.is_said_pure(&names.join("::"))
    }

    fn is_said_pure(&mut self, path: &str) -> bool {
        let said = self.resolver.pure.iter_mut().find(|(name, _)| written(name) == path);
        said.is_some_and(|(_, called)| {
            *called = true;
            true
        })
    }

    fn value_of<'e>(&'e self, expr: &'e Expr) -> Value<'e> {
        match expr {
            Expr::Paren(inner) => self.value_of(&inner.expr),
            Expr::Group(inner) => self.value_of(&inner.expr),
            Expr::Reference(inner) => self.value_of(&inner.expr),
            Expr::Lit(literal) => match literal.lit {
                Lit::Int(_) | Lit::Float(_) | Lit::Bool(_) | Lit::Char(_) | Lit::Byte(_) => Value::Of(Kind::Number),
                Lit::Str(_) => Value::Of(Kind::List(None)),
                _ => Value::Unknown,
            },
            Expr::Cast(cast) => Value::Of(methods::kind_of(&cast.ty)),
            Expr::Call(call) if made_from(&call.func).is_some() => Value::Of(Kind::Number),
            Expr::Path(path) if limit(path).is_some() => Value::Of(Kind::Number),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Not(_) | UnOp::Neg(_)) => self.value_of(&unary.expr),
            Expr::Binary(binary) => match (self.value_of(&binary.left), self.value_of(&binary.right)) {
                (number @ Value::Of(Kind::Number | Kind::Time), Value::Of(_)) => number,
                _ => Value::Unknown,
            },
            Expr::MethodCall(call) if self.is_known_method(call) => self.result_of(call),
            _ => self.place_of(expr),
        }
    }

    /// A declared value, or a part of one; the time of a step.
    fn place_of<'e>(&'e self, expr: &'e Expr) -> Value<'e> {
        if let Expr::Field(field) = expr {
            let is_time = matches!(&field.member, syn::Member::Named(name) if name == "T");
            let is_step = |path: Vec<proc_macro2::Ident>| {
                let meaning = path.last().and_then(|step| self.resolver.scope.get(step));
                matches!(meaning, Some(Meaning::Step(_) | Meaning::Macro(_)))
            };
            if is_time && step_path(&field.base).is_some_and(is_step) {
                return Value::Of(Kind::Time);
            }
        }
        let Some(root) = methods::root(expr).filter(|name| !self.locals.contains(name)) else { return Value::Unknown };
        match self.resolver.scope.get(root) {
            Some(Meaning::Value(name)) => Value::Of(methods::kind(expr, self.resolver.model.ty(name))),
            _ => Value::Unknown,
        }
    }

    fn result_of<'e>(&'e self, call: &'e ExprMethodCall) -> Value<'e> {
        let name = call.method.to_string();
        match self.value_of(&call.receiver) {
            Value::Of(Kind::Number) if name.starts_with("checked_") => Value::Of(Kind::Option),
            Value::Of(Kind::Number) if name.starts_with("overflowing_") => Value::Unknown,
            Value::Of(Kind::Time) if name != "get" => Value::Of(Kind::Time),
            Value::Of(Kind::Number | Kind::Time) => Value::Of(Kind::Number),
            Value::Of(Kind::List(_)) if ITERATORS.contains(&&*name) => Value::Iterator,
            Value::Of(Kind::List(_)) if name == "len" => Value::Of(Kind::Number),
            Value::Iterator if ADAPTORS.contains(&&*name) => Value::Iterator,
            Value::Iterator if name == "count" => Value::Of(Kind::Number),
            _ => Value::Unknown,
        }
    }

    /// Whether the type of Rust that is not looked into is one of integers, `bool` or `char`.
    pub(super) fn is_whole(&self, expr: &Expr) -> bool {
        let is_number = |expr| matches!(self.value_of(expr), Value::Of(Kind::Number));
        match expr {
            Expr::Paren(inner) => self.is_whole(&inner.expr),
            Expr::Group(inner) => self.is_whole(&inner.expr),
            Expr::Lit(literal) => matches!(&literal.lit, Lit::Int(_) | Lit::Bool(_) | Lit::Char(_) | Lit::Byte(_)),
            Expr::Unary(unary) => matches!(unary.op, UnOp::Not(_) | UnOp::Neg(_)) && self.is_whole(&unary.expr),
            Expr::Binary(binary) => self.is_whole(&binary.left) && self.is_whole(&binary.right),
            Expr::Cast(cast) => is_number(expr) && !mentions_float(&*cast.ty),
            Expr::Call(call) => made_from(&call.func).is_some(),
            Expr::MethodCall(call) if self.is_time(&call.receiver) => call.method == "get",
            Expr::MethodCall(call) => {
                let counts = matches!(self.value_of(&call.receiver), Value::Of(Kind::List(_)) | Value::Iterator);
                is_number(expr) && (counts || self.is_whole(&call.receiver))
            }
            Expr::Path(path) if limit(path).is_some() => true,
            Expr::Path(_) | Expr::Index(_) | Expr::Field(_) if is_number(expr) => {
                let name = methods::root(expr).and_then(|root| self.resolver.scope.get(root));
                matches!(name, Some(Meaning::Value(name)) if match self.resolver.model.ty(name) {
                    Ty::Bool(_) | Ty::Int { .. } => true,
                    Ty::Other(rust) => !mentions_float(rust),
                    Ty::Time(_) => false,
                })
            }
            _ => false,
        }
    }

    /// Whether it is a part of a value, or asks which pattern that has: what the value can be, it can be, too.
    pub(super) fn is_open(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Path(_) => true,
            Expr::Paren(inner) => self.is_open(&inner.expr),
            Expr::Group(inner) => self.is_open(&inner.expr),
            Expr::Field(field) => self.is_open(&field.base),
            Expr::Index(index) => self.is_open(&index.expr),
            Expr::Macro(call) => call.mac.path.is_ident("matches"),
            Expr::MethodCall(call) => {
                let asks = ["is_some", "is_none", "is_ok", "is_err", "is_empty"].iter().any(|name| call.method == name);
                asks && self.is_known_method(call) && self.is_open(&call.receiver)
            }
            _ => false,
        }
    }

    /// Whether it is a time, so that its methods are those of times.
    pub(super) fn is_time(&self, expr: &Expr) -> bool {
        matches!(self.value_of(expr), Value::Of(Kind::Time))
    }

    /// The number of this evaluation of a call, where it may have a value of its own.
    pub(super) fn evaluation(&mut self, differs: bool) -> Option<u32> {
        differs.then(|| {
            self.resolver.calls += 1;
            self.resolver.calls
        })
    }
}

fn mentions_float(ty: &impl ToTokens) -> bool {
    let text = ty.to_token_stream().to_string();
    text.contains("f32") || text.contains("f64")
}

/// `sensors::valid`
fn written(path: &syn::Path) -> String {
    let names: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).list();
    names.join("::")
}

impl Resolver<'_> {
    /// `assume pure level_ok, sensors::valid;`
    pub(super) fn assume_pure(&mut self, paths: &[syn::Path], place: Where) {
        if place == Where::Chart {
            self.pure.push_all(paths.iter().map(|path| (path.clone(), false)));
        }
    }

    /// What is said to be pure and never called is a slip of the pen.
    pub(super) fn unused_pure(&mut self) {
        if self.unread || self.model.incomplete {
            return;
        }
        for (path, _) in self.pure.iter().filter(|(_, called)| !called) {
            let message = format!(
                "nothing in this chart calls `{}`; write the path as it is called, or the name of a method or macro alone",
                written(path)
            );
            self.sink.rule(&rules::UNKNOWN_NAME, &[], vec![(Mark::of(path), message)]);
        }
    }
}
