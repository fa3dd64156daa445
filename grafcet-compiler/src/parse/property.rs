//! `never Up.X && Down.X;` `always relay => !over_temp;` `home (A, B);`

use proc_macro2::Delimiter;

use super::recover::{self, Items};
use super::{Input, Result, condition};
use crate::ast::{Attrs, Property};
use crate::diagnostic::Sink;

/// Something to be proved; its keyword, which is `word`, is next.
pub(super) fn parse(input: &mut Input, word: &str, attrs: Attrs, sink: &mut Sink) -> Result<Property> {
    input.bump();
    let keyword = input.last();
    let property = match word {
        "never" => Property::Never { attrs, keyword, condition: condition::parse(input, "what must never hold")? },
        "always" => {
            let first = condition::parse(input, "what must always hold")?;
            if input.eat("=>") {
                let condition = condition::parse(input, "what follows from it, after `=>`")?;
                Property::Always { attrs, keyword, premise: Some(first), condition }
            } else {
                Property::Always { attrs, keyword, premise: None, condition: first }
            }
        }
        _ => {
            let what = "the step of the home situation, or `(A, B)`";
            let steps = match input.enter(Delimiter::Parenthesis) {
                Some(inside) if inside.is_empty() => return Err(inside.error("a home situation has at least one step")),
                Some(mut inside) => inside.names(what)?,
                None => vec![input.step_name(what)?],
            };
            if input.at(",") {
                return Err(input.error("a home situation of several steps is written in parentheses: `home (A, B);`"));
            }
            Property::Home { attrs, keyword, steps }
        }
    };
    recover::semicolon(input, Items::OfChart, sink);
    Ok(property)
}
