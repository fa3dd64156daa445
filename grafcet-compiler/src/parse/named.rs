//! `let go = auto || rising(next);`

use syn::Type;
use syn::parse::Parse;

use super::recover::{self, Items};
use super::{Input, Result, condition};
use crate::ast::{Attrs, Let};
use crate::diagnostic::Sink;

/// A named condition; `let` is next.
pub(super) fn parse(input: &mut Input, attrs: Attrs, sink: &mut Sink) -> Result<Let> {
    input.bump();
    if input.at_word("mut") {
        let message = "a `let` names an expression and is never written; remove `mut`, or declare a `var`";
        sink.notation(input.span(), message);
        input.bump();
    }
    let name = input.name("the name of the condition, as in `let go = auto || rising(next);`")?;
    let start = *input;
    if !input.at("::") && !input.at(":=") && input.eat(":") {
        let ty = input.rust(Type::parse)?;
        let message = if matches!(&ty, Type::Path(path) if path.path.is_ident("bool")) {
            format!("a `let` has the type of its expression; write `let {name} = …;`")
        } else {
            let ty = quote::ToTokens::to_token_stream(&ty);
            format!(
                "a `let` has the type of its expression; write `let {name} = …;`, or `var {name}: {ty} = …;` if it is to change"
            )
        };
        sink.notation(input.since(&start), message);
    }
    if !input.at_assign() || !input.eat("=") {
        let found = input.found();
        return Err(input.error(format!("expected `=` and a condition, as in `let {name} = a && b;`, found {found}")));
    }
    let value = condition::parse(input, "a condition, such as `auto || rising(next)`")?;
    recover::semicolon(input, Items::OfChart, sink);
    Ok(Let { attrs, name, value })
}
