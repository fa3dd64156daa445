//! `in 1s..10s`, `in 1..=8` after the type of a declaration.

use proc_macro2::Literal;
use syn::Lit;

use super::time::time_literal;
use super::{Error, Input, Result};
use crate::ast::{Bound, Limit, Range};
use crate::diagnostic::{Mark, Sink, rules};

/// Whether a range stands here: it begins with a number.
pub(super) fn begins(input: &Input) -> bool {
    input.literal().is_some() || input.at("-") || input.at("..")
}

/// What stands after `in`; nothing where a bound was reported.
pub(super) fn parse(input: &mut Input, sink: &mut Sink) -> Result<Option<Range>> {
    let start = *input;
    let low = bound(input, sink)?;
    let text = input.since(&start);
    let closed = input.eat("..=");
    if !closed && !input.eat("..") {
        return Err(input.error(format!(
            "expected `..` or `..=` and the other end of the range, as in `in 1..=8`, found {}",
            input.found()
        )));
    }
    let high = bound(input, sink)?;
    let mark = Mark { start: text.start, end: input.last() };
    Ok(low.zip(high).map(|(low, high)| Range { low, high, closed, mark }))
}

fn bound(input: &mut Input, sink: &mut Sink) -> Result<Option<Bound>> {
    let start = *input;
    let minus = input.eat("-");
    let Some(literal) = input.literal() else {
        return Err(input
            .error(format!("expected a number or a time, as in `in 1..=8` or `in 1s..10s`, found {}", input.found())));
    };
    input.bump();
    let mark = input.since(&start);
    let text = format!("{}{literal}", if minus { "-" } else { "" });
    let limit = match limit(literal, minus) {
        Ok(limit) => limit,
        Err(Fault::Time(message)) => {
            sink.rule(&rules::BAD_TIME, &[], vec![(mark, message)]);
            return Ok(None);
        }
        Err(Fault::Number) => {
            let message = format!("a range goes from integer to integer or from time to time; `{text}` is neither");
            return Err(Error::new(mark.start, message));
        }
    };
    Ok(Some(Bound { limit, text, mark }))
}

enum Fault {
    Number,
    Time(String),
}

fn limit(literal: &Literal, minus: bool) -> std::result::Result<Limit, Fault> {
    let lit = Lit::new(literal.clone());
    match time_literal(&lit) {
        Some(Ok(_)) if minus => return Err(Fault::Time("time runs forward; a time is not negative".to_owned())),
        Some(Ok(time)) => return Ok(Limit::Time(time)),
        Some(Err(message)) => return Err(Fault::Time(message)),
        None => {}
    }
    let Lit::Int(number) = lit else { return Err(Fault::Number) };
    let value: i128 = number.base10_parse().map_err(|_| Fault::Number)?;
    Ok(Limit::Int(if minus { -value } else { value }))
}
