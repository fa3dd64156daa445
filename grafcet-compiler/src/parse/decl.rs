//! `output speed: u16 = 0;` and `action heat(setpoint: i16);`

use proc_macro2::{Delimiter, Ident};
use syn::Expr;
use syn::parse::Parse;

use super::input::Turns;
use super::recover::{self, Items};
use super::{Error, Input, Result, range, rust, types, variants, words};
use crate::ast::{ActionDecl, Attrs, Decl, DeclKind, Range, Ty, Variants};
use crate::diagnostic::Sink;
use crate::list::List;

/// An input, output, variable or parameter; the keyword is next.
pub(super) fn parse(input: &mut Input, kind: DeclKind, attrs: Attrs, sink: &mut Sink) -> Result<Decl> {
    let keyword = input.word().and_then(words::meant).unwrap_or("var");
    input.bump();
    sign_after(input, keyword, sink)?;
    let names = names(input)?;
    colon(input, &names, keyword)?;
    let ty = types::parse(input, sink).and_then(|ty| types::kept(ty, sink))?;
    let (variants, range) = listed(input, sink)?;
    let start = *input;
    let mut init = if input.at_assign() && input.eat("=") { Some(value(input)?) } else { None };
    if kind == DeclKind::Input && init.take().is_some() {
        sink.notation(input.since(&start), "an input has no initial value: each cycle reads it anew; remove this");
    }
    let mut after = *input;
    if after.eat(",") && after.eat_ident().is_some() && after.at(":") {
        return Err(
            input.error("a declaration has one type; begin another one for the next: `input a: u8; input b: bool;`")
        );
    }
    recover::semicolon(input, Items::OfChart, sink);
    Ok(Decl { attrs, kind, names, ty, variants, range, init })
}

/// What stands after `in`: the variants of an enum or a range.
fn listed(input: &mut Input, sink: &mut Sink) -> Result<(Option<Variants>, Option<Range>)> {
    let keyword = input.span();
    if !input.eat_word("in") {
        return Ok((None, None));
    }
    if range::begins(input) {
        return Ok((None, range::parse(input, sink)?));
    }
    Ok((Some(variants::parse(input, keyword)?), None))
}

fn names(input: &mut Input) -> Result<Vec<Ident>> {
    let mut names = vec![input.name("a name")?];
    while input.eat(",") {
        names.push(input.name("a name after `,`")?);
    }
    Ok(names)
}

/// `input { a: bool }` and `input: a: bool;`, where nothing stands between the keyword and the names.
fn sign_after(input: &mut Input, keyword: &str, sink: &mut Sink) -> Result<()> {
    if input.at_group(Delimiter::Brace) {
        let message =
            format!("declarations have no braces: `{keyword} a, b: bool;`, and another one for the next type");
        return Err(input.error(message));
    }
    if lists_after_colon(input) {
        sink.notation(input.span(), format!("after `{keyword}` stands the name, without `:`: `{keyword} a, b: bool;`"));
        input.eat(":");
    }
    Ok(())
}

/// Whether `a, b: bool` is next, in front of which a keyword is missing.
pub(super) fn lists(input: &Input) -> bool {
    let (mut ahead, mut turns) = (*input, Turns::default());
    while turns.more(&ahead) && ahead.at_name() {
        ahead.bump();
        if !ahead.eat(",") {
            break;
        }
    }
    input.next().at(",") && ahead.at(":") && !ahead.at("::")
}

/// Whether `: a, b: bool` is next.
pub(super) fn lists_after_colon(input: &Input) -> bool {
    let name = input.next();
    let next = name.next();
    input.at(":") && !input.at("::") && name.at_name() && (next.at(",") || next.at(":") && !next.at("::"))
}

fn colon(input: &mut Input, names: &[Ident], keyword: &str) -> Result<()> {
    if input.at(":=") || !input.eat(":") {
        if let (true, Some(word)) =
            (input.word().is_some(), names.last().filter(|name| *name == "mut" || *name == "ref"))
        {
            return Err(Error::new(word.span(), format!("no declaration of a chart has `{word}`; remove it")));
        }
        if let ([ty], Some(name)) = (names, input.word()) {
            // `bool a`
            if let Some(known) = types::known(&ty.to_string()) {
                return Err(Error::new(ty, format!("the type stands after the name: `{keyword} {name}: {known};`")));
            }
        }
        let names = names.iter().map(ToString::to_string).list().join(", ");
        let message = format!("expected `:` and a type, as in `{keyword} {names}: bool;`, found {}", input.found());
        return Err(input.error(message));
    }
    Ok(())
}

/// The expression after `=`.
fn value(input: &mut Input) -> Result<Expr> {
    if input.is_empty() || input.at(";") {
        return Err(input.error(format!("expected a value after `=`, found {}", input.found())));
    }
    let start = *input;
    let value = input.rust(Expr::parse)?;
    rust::expr(&start, input, &value)?;
    Ok(value)
}

/// A code action; the keyword is next.
pub(super) fn action(input: &mut Input, attrs: Attrs, sink: &mut Sink) -> Result<ActionDecl> {
    input.bump();
    let name = input.name("the name of the action")?;
    let Some(mut inside) = input.enter(Delimiter::Parenthesis) else {
        return Err(input.error(format!(
            "an action lists its arguments in parentheses: `action {name}();`, found {}",
            input.found()
        )));
    };
    let (mut params, mut turns) = (Vec::new(), Turns::default());
    while turns.more(&inside) {
        params.push(param(&mut inside, sink)?);
        if !inside.eat(",") && !inside.is_empty() {
            return Err(inside.error(format!("expected `,`, found {}", inside.found())));
        }
    }
    refuse_result(input)?;
    recover::semicolon(input, Items::OfChart, sink);
    Ok(ActionDecl { attrs, name, params })
}

fn param(input: &mut Input, sink: &mut Sink) -> Result<(Ident, Ty)> {
    let name = input.name("an argument, as in `setpoint: i16`")?;
    if input.at("::") || !input.eat(":") {
        return Err(input.error(format!("expected `:` and the type of `{name}`, found {}", input.found())));
    }
    Ok((name, types::parse(input, sink)?))
}

fn refuse_result(input: &Input) -> Result<()> {
    let here: Error = if input.at("->") {
        input.error("an action has no result; what it computes goes through an input of the next cycle")
    } else if input.at_group(Delimiter::Brace) {
        input.error("an action is only declared here; its code is a method of the chart's trait")
    } else {
        return Ok(());
    };
    Err(here)
}
