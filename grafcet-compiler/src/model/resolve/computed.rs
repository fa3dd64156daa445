//! Arithmetic of integers that is written as a cast or as a method: what it is computed of.

use syn::Expr;

use super::expr::Lower;
use crate::list::List;
use crate::model::{Binary, Computed, How, Integer, Tree};

impl Lower<'_, '_> {
    /// Resolves the operands of a cast or of a call that is arithmetic of integers; none, with nothing resolved, where it is
    /// anything else.
    pub(super) fn computed(&mut self, expr: &mut Expr) -> Option<Computed> {
        match expr {
            Expr::Cast(cast) => {
                let how = How::As(Integer::of(&cast.ty)?);
                Some(Computed { how, operands: vec![self.lower(&mut cast.expr)] })
            }
            Expr::Call(call) => {
                let how = How::As(made_from(&call.func)?);
                if call.args.len() != 1 {
                    return None;
                }
                Some(Computed { how, operands: vec![self.lower(call.args.first_mut()?)] })
            }
            Expr::If(choice) => {
                let (Some(then), Some((_, otherwise))) = (alone(&mut choice.then_branch), &mut choice.else_branch)
                else {
                    return None;
                };
                let otherwise = match &mut **otherwise {
                    Expr::Block(block) if block.label.is_none() && block.attrs.is_empty() => alone(&mut block.block)?,
                    otherwise @ Expr::If(_) => otherwise,
                    _ => return None,
                };
                if binds(&choice.cond) {
                    return None;
                }
                let condition = self.lower(&mut choice.cond);
                Some(Computed { how: How::If, operands: vec![condition, self.lower(then), self.lower(otherwise)] })
            }
            // `u16::MAX` is a number that has this type.
            Expr::Path(path) => {
                let (ty, value) = limit(path)?;
                Some(Computed { how: How::As(ty), operands: vec![Tree::Int(value)] })
            }
            Expr::MethodCall(call) if call.turbofish.is_none() => {
                let is_time = self.is_time(&call.receiver);
                if !is_time && !self.is_whole(&call.receiver) {
                    return None;
                }
                let how = method(&call.method.to_string(), call.args.len(), is_time)?;
                let mut operands = vec![self.lower(&mut call.receiver)];
                for argument in &mut call.args {
                    operands.push(self.lower(argument));
                }
                Some(Computed { how, operands })
            }
            _ => None,
        }
    }
}

/// The value of a block that is nothing else.
fn alone(block: &mut syn::Block) -> Option<&mut Expr> {
    match &mut block.stmts[..] {
        [syn::Stmt::Expr(value, None)] => Some(value),
        _ => None,
    }
}

/// `let Some(x) = y`, alone or in a chain of `&&`.
fn binds(mut condition: &Expr) -> bool {
    // A long chain leans to the left.
    loop {
        condition = match condition {
            Expr::Let(_) => return true,
            Expr::Binary(binary) if binds(&binary.right) => return true,
            Expr::Binary(binary) => &binary.left,
            Expr::Paren(inner) => &inner.expr,
            _ => return false,
        };
    }
}

/// `u16::MAX`, `i8::MIN`, `u32::BITS`: its type, and what it is. Those of `usize` depend on the machine.
pub(super) fn limit(path: &syn::ExprPath) -> Option<(Integer, i128)> {
    let [ty, name] = [path.path.segments.first()?, path.path.segments.last()?].map(|segment| segment.ident.to_string());
    let of = Integer::named(&ty).filter(|of| !of.is_size && of.bits <= 64 && path.path.segments.len() == 2)?;
    let magnitude = of.bits - u32::from(of.signed);
    match &*name {
        "MAX" => Some((of, (1 << magnitude) - 1)),
        "MIN" => Some((of, if of.signed { -(1 << magnitude) } else { 0 })),
        "BITS" => Some((Integer { signed: false, bits: 32, is_size: false }, of.bits.into())),
        _ => None,
    }
}

/// The type that `u16::from` makes.
pub(super) fn made_from(function: &Expr) -> Option<Integer> {
    let Expr::Path(path) = function else { return None };
    let names: Vec<String> = path.path.segments.iter().map(|segment| segment.ident.to_string()).list();
    match &names[..] {
        [ty, from] if path.qself.is_none() && from == "from" => Integer::named(ty),
        _ => None,
    }
}

/// What a method computes of so many arguments.
fn method(name: &str, arguments: usize, is_time: bool) -> Option<How> {
    if is_time {
        return (name == "get").then_some(How::Get);
    }
    let operator = match name.rsplit('_').next() {
        Some("add") => Some(Binary::Add),
        Some("sub") => Some(Binary::Sub),
        Some("mul") => Some(Binary::Mul),
        _ => None,
    };
    let how = match (name, operator) {
        ("wrapping_add" | "wrapping_sub" | "wrapping_mul", Some(operator)) => (How::Wrapping(operator), 1),
        ("saturating_add" | "saturating_sub" | "saturating_mul", Some(operator)) => (How::Saturating(operator), 1),
        ("min", _) => (How::Min, 1),
        ("max", _) => (How::Max, 1),
        ("clamp", _) => (How::Clamp, 2),
        ("abs", _) => (How::Abs, 0),
        ("unsigned_abs", _) => (How::UnsignedAbs, 0),
        ("abs_diff", _) => (How::AbsDiff, 1),
        ("signum", _) => (How::Signum, 0),
        ("div_euclid", _) => (How::DivEuclid, 1),
        ("rem_euclid", _) => (How::RemEuclid, 1),
        ("pow", _) => (How::Pow, 1),
        _ => return Some(How::Other),
    };
    Some(if how.1 == arguments { how.0 } else { How::Other })
}
