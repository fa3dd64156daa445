//! What people write in conditions who know other notations, where Rust would say something else about it or nothing.

use proc_macro2::Ident;
use syn::{BinOp, Expr, ExprField, Lit, Member, UnOp};

use super::Resolver;
use super::expr::{single_name, step_path, without_field};
use super::scope::Meaning;
use crate::diagnostic::Mark;
use crate::model::{Name, Ty};
use crate::parse::time_literal;

/// Looks at each part of a condition that must be true or false by itself. `Feeder::Rest` alone, where that is a step of a
/// partial grafcet, is no Rust there; compared with something it may be a variant of a type with such a name.
pub(super) fn of_condition(expr: &Expr, resolver: &mut Resolver<'_>) {
    part(expr, false, resolver);
}

/// The same of what a `let` names, which as a whole may be a number or a time, too.
pub(super) fn of_named(expr: &Expr, resolver: &mut Resolver<'_>) {
    part(expr, true, resolver);
}

/// `open`: it may be something else than true or false.
fn part(expr: &Expr, open: bool, resolver: &mut Resolver<'_>) {
    match expr {
        Expr::Paren(paren) => part(&paren.expr, open, resolver),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Not(_)) => part(&unary.expr, open, resolver),
        Expr::Binary(binary) => match logic(&binary.op) {
            Logic::Ours => {
                part(&binary.left, false, resolver);
                part(&binary.right, false, resolver);
            }
            Logic::Theirs(ours) if is_bool(&binary.left, resolver) && is_bool(&binary.right, resolver) => {
                let message = format!("this computes with numbers; of two conditions it is written `{ours}`");
                resolver.sink.notation(syn::spanned::Spanned::span(&binary.op), message);
            }
            _ => {}
        },
        Expr::Path(_) => path(expr, open, resolver),
        Expr::Lit(_) if open => {}
        Expr::Lit(lit) => literal(&lit.lit, resolver),
        Expr::Field(named) => field(named, open, resolver),
        Expr::MethodCall(call) => {
            let of = single_name(&call.receiver).filter(|name| is_bool_name(name, resolver));
            if let (Some(name), true) = (of, call.method == "rising" || call.method == "falling") {
                let message = format!("an edge is written `{}({name})`", call.method);
                resolver.sink.notation(Mark::of(expr), message);
            }
        }
        _ => {}
    }
}

/// `a.b` of two conditions; `Fill.T` alone.
fn field(field: &ExprField, open: bool, resolver: &mut Resolver<'_>) {
    let base = single_name(&field.base).is_some_and(|name| is_bool_name(&name, resolver));
    if base && matches!(&field.member, Member::Named(name) if is_bool_name(name, resolver)) {
        let message = "`.` asks for a part of something; both of two conditions are asked with `&&`";
        resolver.sink.notation(field.dot_token.span, message);
    }
    if let (false, Some(step)) = (open, time_of_step(field, resolver)) {
        step_time_alone(field, &format!("{step}.T"), &step, resolver);
    }
}

/// `Fill` of `Fill.T`, where that is a step.
pub(super) fn time_of_step(field: &ExprField, resolver: &Resolver<'_>) -> Option<String> {
    let step = step_path(&field.base)?;
    let is_time = matches!(&field.member, Member::Named(name) if name == "T");
    (is_time && is_step(step.last()?, resolver)).then(|| super::text::of(&field.base))
}

enum Logic {
    Ours,
    /// `+` and `*`, as IEC 60848 and ladder diagrams write *or* and *and*.
    Theirs(&'static str),
    None,
}

fn logic(op: &BinOp) -> Logic {
    match op {
        BinOp::And(_) | BinOp::Or(_) => Logic::Ours,
        BinOp::Add(_) => Logic::Theirs("||"),
        BinOp::Mul(_) => Logic::Theirs("&&"),
        _ => Logic::None,
    }
}

/// Whether an expression is certainly a condition.
fn is_bool(expr: &Expr, resolver: &Resolver<'_>) -> bool {
    match expr {
        Expr::Paren(paren) => is_bool(&paren.expr, resolver),
        Expr::Unary(unary) => matches!(unary.op, UnOp::Not(_)) && is_bool(&unary.expr, resolver),
        Expr::Binary(binary) => match &binary.op {
            BinOp::Eq(_) | BinOp::Ne(_) | BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) => true,
            op => !matches!(logic(op), Logic::None) && is_bool(&binary.left, resolver),
        },
        other => single_name(other).is_some_and(|name| is_bool_name(&name, resolver)),
    }
}

fn is_bool_name(name: &Ident, resolver: &Resolver<'_>) -> bool {
    matches!(ty(name, resolver), Some(Ty::Bool(_)))
}

/// The type of a declared value.
fn ty<'m>(name: &Ident, resolver: &'m Resolver<'_>) -> Option<&'m Ty> {
    match resolver.scope.get(name)? {
        Meaning::Value(Name::Input(id)) => Some(&resolver.model.inputs[id].ty),
        Meaning::Value(Name::Output(id)) => Some(&resolver.model.outputs[id].ty),
        Meaning::Value(Name::Var(id)) => Some(&resolver.model.vars[id].ty),
        Meaning::Value(Name::Param(id)) => Some(&resolver.model.params[id].ty),
        _ => None,
    }
}

/// A name, or a step of another partial grafcet.
fn path(expr: &Expr, open: bool, resolver: &mut Resolver<'_>) {
    let Some(names) = step_path(expr) else { return };
    match &names[..] {
        [partial, step] if is_step(step, resolver) && resolver.scope.has_partial(partial) => {
            resolver.sink.notation(Mark::of(expr), without_field(&format!("{partial}::{step}")));
        }
        [name] if !open && matches!(ty(name, resolver), Some(Ty::Time(_))) => {
            time_alone(expr, &name.to_string(), resolver);
        }
        [name] if !open && named_time(name, resolver).is_some() => {
            let step = named_time(name, resolver).unwrap_or_default();
            step_time_alone(expr, &name.to_string(), &step, resolver);
        }
        // A constant of the program may be called so, which is compared with something.
        [name] => resolver.alone.push(name.to_string()),
        _ => {}
    }
}

/// The step whose time a `let` names.
fn named_time(name: &Ident, resolver: &Resolver<'_>) -> Option<String> {
    match resolver.value_of_let(name) {
        Some(Expr::Field(field)) => time_of_step(field, resolver),
        _ => None,
    }
}

/// `5s`, `1`
fn literal(lit: &Lit, resolver: &mut Resolver<'_>) {
    let text = quote::ToTokens::to_token_stream(lit).to_string();
    match time_literal(lit) {
        Some(Ok(_)) => time_alone(lit, &text, resolver),
        None if text == "0" || text == "1" => {
            let message = format!("`{text}` is a number; write `{}`", if text == "1" { "true" } else { "false" });
            resolver.sink.notation(lit.span(), message);
        }
        _ => {}
    }
}

fn time_alone(mark: impl quote::ToTokens, time: &str, resolver: &mut Resolver<'_>) {
    let step = resolver.from.clone().unwrap_or_else(|| "Step".to_owned());
    let message =
        format!("a time alone is no condition; `{time}/{step}` holds once step `{step}` has been active for so long");
    resolver.sink.notation(Mark::of(mark), message);
}

fn step_time_alone(mark: impl quote::ToTokens, time: &str, step: &str, resolver: &mut Resolver<'_>) {
    let message = format!(
        "a time alone is no condition; `{time} >= 3s`, or `3s/{step}`, holds once step `{step}` has been active for so long"
    );
    resolver.sink.notation(Mark::of(mark), message);
}

fn is_step(name: &Ident, resolver: &Resolver<'_>) -> bool {
    matches!(resolver.scope.get(name), Some(Meaning::Step(_) | Meaning::Macro(_)))
}

/// What a name that nobody has declared is called here, if it is one of another notation.
pub(super) fn name(name: &Ident, resolver: &Resolver<'_>) -> Option<String> {
    let text = name.to_string();
    match text.as_str() {
        "TRUE" | "FALSE" => return Some(format!("`{text}` is written `{}`", text.to_lowercase())),
        _ => {}
    }
    let step = variable_of(&text, resolver).filter(|_| resolver.alone.contains(&text))?;
    Some(format!("whether step `{step}` is active is written `{step}.X`"))
}

/// The step that `X1` and `XHeat` speak of in IEC 60848.
fn variable_of(text: &str, resolver: &Resolver<'_>) -> Option<String> {
    let rest = text.strip_prefix('X').filter(|rest| !rest.is_empty())?;
    let steps = || resolver.scope.steps().map(ToString::to_string);
    let exactly = steps().find(|step| step == rest);
    let numbered = || steps().find(|step| is_number(rest) && step.trim_start_matches(char::is_alphabetic) == rest);
    exactly.or_else(numbered)
}

fn is_number(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

/// `5s/X1`: the step itself stands there.
pub(super) fn delayed(name: &Ident, resolver: &Resolver<'_>) -> Option<String> {
    let text = name.to_string();
    let numbered = || text.strip_prefix('X').is_some_and(|rest| !rest.is_empty() && is_number(rest));
    let from = || resolver.from.clone().filter(|_| numbered());
    let step = variable_of(&text, resolver).or_else(from)?;
    Some(format!("no step is called `{name}`: after `/` stands the step itself, `{step}`"))
}

/// What a function block of IEC 61131-3 is here.
pub(super) fn function(name: &Ident) -> Option<String> {
    let text = name.to_string();
    let ours = match text.as_str() {
        "R_TRIG" | "RISING" => "an edge is written `rising(a)`",
        "F_TRIG" | "FALLING" => "an edge is written `falling(a)`",
        "TON" => "a delay is written `5s/Step`, or `3s/a` for an expression",
        "TOF" => {
            "a delay is written `3s/a/2s`: true once `a` has been true for 3 s, false once it has been false for 2 s"
        }
        "TP" => "a pulse is an action: `L 5s q;` is on for 5 s from the activation of the step on",
        "NOT" => "a negation is written `!a`",
        _ => return None,
    };
    Some(format!("`{text}` is no function here; {ours}"))
}
