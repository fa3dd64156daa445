//! What can stand after a qualifier: `relay`, `count = count + 1`, `heat(80)`, `{ count += 1; }`.

use proc_macro2::{Delimiter, Ident};
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Block, Expr, Token};

use super::input::Turns;
use super::{Error, Input, Result, rust};
use crate::ast::Target;
use crate::list::List;

/// The target of an association or of an action on clearing.
pub(super) fn parse(input: &mut Input) -> Result<Target> {
    let start = *input;
    if input.at_group(Delimiter::Brace) {
        let block = input.rust_tokens(1, Block::parse).map_err(|error| assignment(start).unwrap_or(error))?;
        rust::block(&start, input, &block)?;
        return Ok(Target::Block(block));
    }
    let name = input.name("a name, an assignment, a call or a block")?;
    if input.at_group(Delimiter::Parenthesis) {
        let args = args(input)?;
        rust::exprs(&start, input, &args)?;
        return Ok(Target::Call { name, args });
    }
    if input.at_assign() {
        input.eat("=");
        let value = value(input, &name)?;
        return Ok(Target::Assign { name, value });
    }
    refuse(input, &name)?;
    Ok(Target::Name(name))
}

/// `:=` in a block that Rust could not read.
fn assignment(mut block: Input) -> Option<Error> {
    let (mut inside, mut turns) = (block.enter(Delimiter::Brace)?, Turns::default());
    while turns.more(&inside) {
        if inside.at(":=") {
            return Some(inside.error("an assignment is written `=`, not `:=`"));
        }
        if let Some(error) = assignment(inside) {
            return Some(error);
        }
        inside.bump();
    }
    None
}

/// `T1(IN := start, PT := 5s)`
fn named_argument(mut call: Input) -> Option<Error> {
    let mut inside = call.enter(Delimiter::Parenthesis)?;
    while !inside.at(":=") && inside.bump() {}
    inside.at(":=").then(|| {
        inside.error(
            "arguments stand in their order, without names: `heat(80)`; a timer is a time in a condition, `5s/Step`, or the qualifier \
             `D` or `L`",
        )
    })
}

fn args(input: &mut Input) -> Result<Vec<Expr>> {
    let args = |input: ParseStream| {
        let content;
        syn::parenthesized!(content in input);
        Punctuated::<Expr, Token![,]>::parse_terminated(&content)
    };
    let start = *input;
    let args = input.rust_tokens(1, args).map_err(|error| named_argument(start).unwrap_or(error))?;
    Ok(args.into_iter().list())
}

fn value(input: &mut Input, name: &Ident) -> Result<Expr> {
    if input.is_empty() || input.at(";") {
        return Err(input.error(format!("expected the value of `{name}`, found {}", input.found())));
    }
    let start = *input;
    let value = input.rust(Expr::parse)?;
    rust::expr(&start, input, &value)?;
    Ok(value)
}

/// What other notations write after the name.
fn refuse(input: &Input, name: &Ident) -> Result<()> {
    if input.at(":=") {
        return Err(input.error(format!("an assignment is written `{name} = …`, without `:`")));
    }
    if input.at("==") {
        return Err(input.error(format!("`==` compares; an assignment is written `{name} = …`")));
    }
    if input.at("++") || input.at("--") {
        let sign = if input.at("++") { '+' } else { '-' };
        return Err(input.error(format!("write `{name} = {name} {sign} 1`")));
    }
    for operator in ["+=", "-=", "*=", "/=", "%=", "^=", "&=", "|=", "<<=", ">>="] {
        if input.at(operator) {
            let plain = operator.trim_end_matches('=');
            let message = format!("write `{name} = {name} {plain} …`, or a block: `P1 {{ {name} {operator} …; }}`");
            return Err(input.error(message));
        }
    }
    if input.at(".") && name == "self" {
        return Err(Error::new(name, "the names of a chart stand alone, without `self.`"));
    }
    if input.at(".") || input.at_group(Delimiter::Bracket) {
        let message = format!(
            "an association acts on a whole output or variable; for a part of `{name}` write a block: `P1 {{ {name}… }}`"
        );
        return Err(input.error(message));
    }
    Ok(())
}
