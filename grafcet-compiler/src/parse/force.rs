//! `force Production {S1, S2};`

use proc_macro2::Delimiter;

use super::{Error, Input, Result};
use crate::ast::{Force, ForceOrder};

/// A forcing order; its keyword is next.
pub(super) fn parse(input: &mut Input) -> Result<Force> {
    let start = *input;
    input.bump();
    let partial = input.name("the partial grafcet to force")?;
    let Some(inside) = input.enter(Delimiter::Brace) else {
        let forms = format!("`{{S1, S2}}`, `{{*}}`, `{{}}` or `{{INIT}}`, as in `force {partial} {{INIT}};`");
        return Err(input.error(format!("expected the situation: {forms}, found {}", input.found())));
    };
    let order = order(inside)?;
    let mark = input.since(&start);
    // After braces a `;` is optional.
    input.eat(";");
    Ok(Force { mark, partial, order })
}

fn order(mut inside: Input) -> Result<ForceOrder> {
    if inside.is_empty() {
        return Ok(ForceOrder::Empty);
    }
    let alone = |input: &Input, order| {
        if input.is_empty() { Ok(order) } else { Err(input.error("`*` and `INIT` stand alone between the braces")) }
    };
    if inside.eat("*") {
        return alone(&inside, ForceOrder::Hold);
    }
    if inside.eat_word("INIT") {
        return alone(&inside, ForceOrder::Init);
    }
    let steps = inside.names("a step of the situation")?;
    match steps.iter().find(|step| *step == "INIT") {
        Some(init) => Err(Error::new(init, "`INIT` stands alone between the braces")),
        None => Ok(ForceOrder::Steps(steps)),
    }
}
