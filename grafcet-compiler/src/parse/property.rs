//! `never Up.X && Down.X;` `always relay => !over_temp;` `home (A, B);` `start leads_to Done within 30s;` `Clamp before Drill;`

use proc_macro2::Delimiter;

use super::recover::{self, Items};
use super::{Error, Input, Result, condition, time, words};
use crate::ast::{Attrs, Property, Time};
use crate::diagnostic::Sink;

/// Something to be proved; its keyword, which is `word`, is next.
pub(super) fn parse(input: &mut Input, word: &str, attrs: Attrs, sink: &mut Sink) -> Result<Property> {
    input.bump();
    let keyword = input.last();
    let property = match word {
        "never" => {
            let condition = condition::parse(input, "what must never hold")?;
            if input.at("=>") {
                let message =
                    "after `never` nothing follows from anything: write `always a => !b;`, or `never a && b;`";
                return Err(input.error(message));
            }
            Property::Never { attrs, keyword, condition }
        }
        "always" => {
            let first = condition::parse(input, "what must always hold")?;
            if ["->", "==>", "-->"].iter().any(|sign| input.at(sign)) {
                return Err(input.error("an implication is written `=>`: `always a => b;`"));
            }
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
            if input.at("::") {
                let message = "a way home leads to steps of the chart, which are named alone, `home A;`: without their partial \
                               grafcet, and none of a plant";
                return Err(Error::new(input.last(), message));
            }
            if input.at(",") {
                return Err(input.error("a home situation of several steps is written in parentheses: `home (A, B);`"));
            }
            Property::Home { attrs, keyword, steps }
        }
    };
    recover::semicolon(input, Items::OfChart, sink);
    Ok(property)
}

/// Whether a property begins here that has its word in the middle. A step may be called like the word: it follows an arrow, not an operand.
pub(super) fn relates(input: &Input) -> bool {
    if input.word().is_some_and(|word| words::ITEMS.contains(&word)) {
        return false;
    }
    let (mut at, mut operand) = (*input, input.punct().is_none());
    while at.bump() && !at.is_empty() && !at.at(";") {
        if operand && (at.at_word("leads_to") || at.at_word("before")) {
            return true;
        }
        operand = at.punct().is_none();
        // What stands next is an item of its own: its `;` is missing.
        if words::item_begins(&at) {
            return false;
        }
    }
    false
}

/// `a leads_to b;` `a leads_to b within 5s;` `a before b;`
pub(super) fn relation(input: &mut Input, attrs: Attrs, sink: &mut Sink) -> Result<Property> {
    let property = order(input, attrs, sink)?;
    recover::semicolon(input, Items::OfChart, sink);
    Ok(property)
}

/// The same without its end.
pub(super) fn order(input: &mut Input, attrs: Attrs, sink: &mut Sink) -> Result<Property> {
    let first = condition::parse(input, "what holds first")?;
    let leads = input.eat_word("leads_to");
    if !leads && !input.eat_word("before") {
        return Err(input.error(format!("expected `leads_to` or `before`, found {}", input.found())));
    }
    let keyword = input.last();
    if leads {
        let to = condition::parse(input, "what it leads to")?;
        let within = within(input, sink)?;
        Ok(Property::LeadsTo { attrs, keyword, from: first, to, within })
    } else {
        Ok(Property::Before { attrs, keyword, first, then: condition::parse(input, "what comes after it")? })
    }
}

fn within(input: &mut Input, sink: &mut Sink) -> Result<Option<Time>> {
    if !input.eat_word("within") {
        if let (Some(word), Some(time)) = (input.word(), input.next().literal()) {
            return Err(
                input.error(format!("how long it may take stands after `within`: `within {time}`, not `{word}`"))
            );
        }
        return Ok(None);
    }
    match input.literal() {
        Some(literal) => Ok(time::parse(input, literal, sink)),
        None => Err(Error::new(
            input.last(),
            "after `within` stands how long it may take: `start leads_to Done within 30s;`",
        )),
    }
}
