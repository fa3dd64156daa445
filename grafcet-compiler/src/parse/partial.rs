//! `partial Safety { … }`

use proc_macro2::Delimiter;

use super::{Input, Result, body};
use crate::ast::{Attrs, Partial};
use crate::diagnostic::Sink;

/// A partial grafcet; its keyword is next.
pub(super) fn parse(input: &mut Input, attrs: Attrs, sink: &mut Sink) -> Result<Partial> {
    input.bump();
    let name = input.name("the name of the partial grafcet")?;
    let Some(inside) = input.enter(Delimiter::Brace) else {
        let message =
            format!("a partial grafcet has its steps in braces: `partial {name} {{ … }}`, found {}", input.found());
        return Err(input.error(message));
    };
    let body = body::parse(inside, sink);
    input.eat(";");
    Ok(Partial { attrs, name, body })
}
