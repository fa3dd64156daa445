//! `clock 1ms;` `max_evolutions 20;` `budget 100_000;` `assume never b1 && b3;` `optimize size;` `encoding flags;` `forceable;` `modes;`

use proc_macro2::Span;
use syn::punctuated::Punctuated;
use syn::{LitInt, Path, Token};

use super::recover::{self, Items};
use super::{Error, Input, Result, condition, property, time};
use crate::ast::{Attrs, Setting, Time};
use crate::diagnostic::Sink;
use crate::list::List;

/// A statement about the chart as a whole; its keyword, which is `word`, is next.
pub(super) fn parse(input: &mut Input, word: &str, sink: &mut Sink) -> Result<Setting> {
    input.bump();
    let keyword = input.last();
    let setting = match word {
        "clock" => Setting::Clock { keyword, unit: unit(input, sink)? },
        "max_evolutions" => Setting::MaxEvolutions { keyword, count: count(input, word)? },
        "budget" => Setting::Budget { keyword, count: count(input, word)? },
        "optimize" => optimize(input, keyword)?,
        "encoding" => encoding(input, keyword)?,
        "forceable" => Setting::Forceable { keyword },
        "modes" => Setting::Modes { keyword },
        _ => assume(input, keyword, sink)?,
    };
    recover::semicolon(input, Items::OfChart, sink);
    Ok(setting)
}

fn unit(input: &mut Input, sink: &mut Sink) -> Result<Time> {
    let Some(literal) = input.literal() else {
        return Err(input.error(format!("the clock's unit is a time such as `1ms`, found {}", input.found())));
    };
    time::parse(input, literal, sink).ok_or_else(Error::reported)
}

fn count(input: &mut Input, word: &str) -> Result<LitInt> {
    let Some(literal) = input.literal() else {
        return Err(input.error(format!("expected a number, as in `{word} 20;`, found {}", input.found())));
    };
    let syn::Lit::Int(count) = syn::Lit::new(literal.clone()) else {
        return Err(input.error(format!("expected a whole number, as in `{word} 20;`, found {}", input.found())));
    };
    if !count.suffix().is_empty() || count.base10_digits().starts_with('-') {
        return Err(input.error(format!("expected a plain number, as in `{word} 20;`, found `{count}`")));
    }
    input.bump();
    Ok(count)
}

fn optimize(input: &mut Input, keyword: Span) -> Result<Setting> {
    if !input.eat_word("size") {
        let message = format!("a chart can be optimized for `size`, found {}; write `optimize size;`", input.found());
        return Err(Error::new(input.span(), message));
    }
    Ok(Setting::OptimizeSize { keyword })
}

fn encoding(input: &mut Input, keyword: Span) -> Result<Setting> {
    if !input.eat_word("flags") {
        let message =
            format!("the encoding that can be asked for is `flags`, found {}; write `encoding flags;`", input.found());
        return Err(Error::new(input.span(), message));
    }
    Ok(Setting::EncodingFlags { keyword })
}

fn assume(input: &mut Input, keyword: Span, sink: &mut Sink) -> Result<Setting> {
    if input.eat_word("pure") {
        let paths = Punctuated::<Path, Token![,]>::parse_separated_nonempty_with;
        let paths = input.rust(|stream| {
            paths(stream, |stream| {
                let path = Path::parse_mod_style(stream)?;
                // The name of a macro may be written as it is called.
                if stream.peek(Token![!]) {
                    stream.parse::<Token![!]>()?;
                }
                Ok(path)
            })
        })?;
        return Ok(Setting::AssumePure { keyword, paths: paths.into_iter().list() });
    }
    if input.eat_word("often") {
        return Ok(Setting::AssumeOften { keyword, condition: condition::parse(input, "what comes again and again")? });
    }
    if input.at_word("cycle") && input.next().at_word("within") {
        return cycle(input, keyword, sink);
    }
    if !input.at_word("never") && property::relates(input) {
        return Ok(Setting::AssumeOrder { keyword, order: property::order(input, Attrs::default(), sink)? });
    }
    if !input.eat_word("never") {
        let message = "what the plant excludes is written `assume never b1 && b3;`, what it answers `assume valve leads_to full \
                       within 10s;`, what comes first `assume lower before bottom;`, what comes again and again \
                       `assume often door_closed;`, how far cycles are apart `assume cycle within 100ms;`, which calls have no \
                       state `assume pure level_ok;`";
        return Err(Error::new(input.span(), message));
    }
    Ok(Setting::AssumeNever { keyword, condition: condition::parse(input, "what never happens")? })
}

/// `within 100ms`, after `assume cycle`.
fn cycle(input: &mut Input, keyword: Span, sink: &mut Sink) -> Result<Setting> {
    input.bump();
    input.bump();
    let time = input.literal().and_then(|literal| time::parse(input, literal, sink));
    match time {
        Some(longest) => Ok(Setting::AssumeCycle { keyword, longest }),
        None => {
            let message = "after `within` stands the longest time between two cycles: `assume cycle within 100ms;`";
            Err(Error::new(input.last(), message))
        }
    }
}
