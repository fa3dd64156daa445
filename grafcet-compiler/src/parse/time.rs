//! Durations: `5s`, `500ms`, `1.5s`, `1h30m`, `250us`.

use proc_macro2::{Literal, TokenStream, TokenTree};
use syn::Lit;

use super::Input;
use crate::ast::Time;
use crate::diagnostic::{Mark, Sink, rules};

/// The units, the longest first, in nanoseconds.
const UNITS: &[(&str, u64)] =
    &[("h", 3_600_000_000_000), ("m", 60_000_000_000), ("s", 1_000_000_000), ("ms", 1_000_000), ("us", 1_000)];

/// The suffixes that make a number an ordinary one.
const RUST: &[&str] = &[
    "u8", "u16", "u32", "u64", "u128", "usize", "i8", "i16", "i32", "i64", "i128", "isize", "f16", "f32", "f64", "f128",
];

/// The time that `lit` is: `None` for an ordinary number or a text, an error (as a sentence) for a unit that is none.
#[must_use]
pub fn time_literal(lit: &Lit) -> Option<Result<Time, String>> {
    let (token, suffix) = match lit {
        Lit::Int(int) => (int.token(), int.suffix()),
        Lit::Float(float) => (float.token(), float.suffix()),
        _ => return None,
    };
    if suffix.is_empty() || RUST.contains(&suffix) {
        return None;
    }
    Some(nanos(&token.to_string()).map(|nanos| Time { span: lit.span(), nanos }))
}

/// Whether a chart speaks of time: `5s`, `Step.T`, a value of type `time`. For one that could not be read as a whole.
#[must_use]
pub(crate) fn mentions_time(chart: TokenStream) -> bool {
    let mut open = vec![chart];
    while let Some(tokens) = open.pop() {
        let mut dot = false;
        for token in tokens {
            match &token {
                TokenTree::Group(group) => open.push(group.stream()),
                TokenTree::Literal(literal) if matches!(time_literal(&Lit::new(literal.clone())), Some(Ok(_))) => {
                    return true;
                }
                TokenTree::Ident(name) if name == "time" || dot && name == "T" => return true,
                _ => {}
            }
            dot = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '.');
        }
    }
    false
}

/// The time at `input`, where nothing else than a time can stand; `None` is a number that was reported.
pub(super) fn parse(input: &mut Input, literal: &Literal, sink: &mut Sink) -> Option<Time> {
    let mut mark = Mark::from(input.span());
    input.bump();
    let message = match time_literal(&Lit::new(literal.clone())) {
        Some(Ok(time)) => return Some(time),
        Some(Err(message)) => message,
        None if UNITS.iter().any(|(unit, _)| input.at_word(unit)) && input.next().at_name() => {
            mark = mark.to(input.span());
            let unit = input.eat_ident().map(|unit| unit.to_string()).unwrap_or_default();
            format!("number and unit stand together: write `{literal}{unit}`")
        }
        None if input.at(".") && !input.at("..") && input.next().literal().is_some() => {
            input.bump();
            mark = mark.to(input.span());
            let part = input.literal().map(ToString::to_string).unwrap_or_default();
            input.bump();
            format!("`{literal}.{part}` is no time: a number has one decimal point")
        }
        None if literal.to_string().starts_with('"') => "a time is written without quotes, as in `5s`".to_owned(),
        None => format!("`{literal}` has no unit of time; the units are h, m, s, ms and us, as in `5s`"),
    };
    sink.rule(&rules::BAD_TIME, &[], vec![(mark, message)]);
    None
}

/// The nanoseconds of `1h30m`.
fn nanos(text: &str) -> Result<u64, String> {
    let mut rest = text;
    let mut sum = 0_u64;
    let mut last = u64::MAX;
    while !rest.is_empty() {
        let (number, after) = split(rest, |c: char| c.is_ascii_digit() || c == '.' || c == '_');
        let (name, after) = split(after, |c: char| !c.is_ascii_digit());
        rest = after;
        let Some(&(_, unit)) = UNITS.iter().find(|(unit, _)| *unit == name) else {
            if let Some(ours) = meant(name) {
                return Err(format!("`{text}` is no time: `{name}` is no unit; write `{ours}`"));
            }
            let fault = if name.is_empty() { "its end has no unit".to_owned() } else { format!("`{name}` is no unit") };
            return Err(format!("`{text}` is no time: {fault}; the units are h, m, s, ms and us"));
        };
        if unit >= last {
            return Err(format!("`{text}` is no time: write the larger unit first, and each unit once, as in `1h30m`"));
        }
        last = unit;
        let part = scaled(number, unit).ok_or_else(|| format!("`{text}` is too long or too fine for a time"))?;
        sum = sum.checked_add(part).ok_or_else(|| format!("`{text}` is too long for a time"))?;
    }
    Ok(sum)
}

/// The unit that is meant by another word.
fn meant(name: &str) -> Option<&'static str> {
    Some(match name.to_lowercase().as_str() {
        "hour" | "hours" | "std" => "h",
        "min" | "mins" | "minute" | "minutes" => "m",
        "sec" | "secs" | "second" | "seconds" | "sek" => "s",
        "msec" | "msecs" | "millis" => "ms",
        "usec" | "micros" | "µs" => "us",
        lower => UNITS.iter().find(|(unit, _)| *unit == lower)?.0,
    })
}

fn split(text: &str, of_first: impl Fn(char) -> bool) -> (&str, &str) {
    text.split_at(text.find(|c| !of_first(c)).unwrap_or(text.len()))
}

/// `1.5` times a unit, exactly; `None` where that is no whole number of nanoseconds.
fn scaled(number: &str, unit: u64) -> Option<u64> {
    let number = number.replace('_', "");
    let (whole, fraction) = number.split_once('.').unwrap_or((&number, ""));
    let mut nanos = whole.parse::<u64>().ok()?.checked_mul(unit)?;
    let mut place = unit;
    for digit in fraction.trim_end_matches('0').chars() {
        if place % 10 != 0 {
            return None;
        }
        place /= 10;
        nanos = nanos.checked_add(place * u64::from(digit.to_digit(10)?))?;
    }
    Some(nanos)
}
