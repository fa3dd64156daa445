//! `L 5s heat(80) if ready;`

use proc_macro2::{Delimiter, Span};

use super::recover::{self, Items};
use super::{Error, Input, Result, chain, condition, foreign, target, time, words};
use crate::ast::{Association, Qualifier, Target, TimeArg};
use crate::diagnostic::{Mark, Sink};

const ALL: &str = "the qualifiers are N, S, R, L, D, P, P1, P0, SD, DS and SL";

/// Words with which other notations say when something is done.
const MOMENTS: &[&str] = &["entry", "enter", "exit", "leave", "during", "do", "while", "for", "loop", "match"];

/// Words with which other notations leave a step.
const GOES: &[&str] = &["goto", "go", "jump", "next", "transition", "transitions", "trans"];

const BY_MOMENT: &str = "what a step does has a qualifier: `P1 { … }` runs when the step becomes active, `P0 { … }` when it is \
                         left, `N { … }` in every cycle";

/// Qualifiers written as words.
const SPOKEN: &[(&str, &str)] =
    &[("set", "S"), ("reset", "R"), ("setze", "S"), ("pulse", "P"), ("puls", "P"), ("nonstored", "N")];

pub(crate) fn is_qualifier(word: &str) -> bool {
    Qualifier::of_letters(word).is_some()
}

/// Whether a line certainly begins here, also where no line breaks are known.
pub(super) fn begins(input: &Input) -> bool {
    let Some(word) = input.word() else { return false };
    let next = input.next();
    (is_qualifier(word) || word == "force") && (next.at_name() || next.literal().is_some())
}

/// Whether a line can begin here, at the beginning of a line of text.
pub(super) fn could_begin(input: &Input) -> bool {
    let Some(word) = input.word().filter(|word| !words::is_rust(word)) else { return false };
    let next = input.next();
    is_qualifier(word) || next.at(";") || next.at_assign() || next.at_word("if") || word == "on" || word == "force"
}

/// One line of a step's body that is no forcing order.
pub(super) fn parse(input: &mut Input, sink: &mut Sink) -> Result<Association> {
    let start = *input;
    misplaced(input)?;
    let (qualifier, event) = match on(input)? {
        Some((span, event)) => (Some((Qualifier::On, span)), Some(event)),
        None => (take_qualifier(input)?, None),
    };
    let time = time(input, qualifier, sink)?;
    let target = after_qualifier(input, &start, qualifier)?;
    let mut condition = None;
    if input.eat_word("if") {
        match condition::parse(input, "the condition of the action") {
            Ok(expr) => condition = Some(expr),
            Err(error) => {
                // What it belongs to is looked at all the same.
                error.report(sink);
                let mark = input.since(&start);
                recover::skip(input, &start, Items::OfStep);
                return Ok(Association { mark, qualifier, time, event, target, condition });
            }
        }
    }
    let mark = input.since(&start);
    let block = matches!(target, Target::Block(_)) && condition.is_none();
    if !block || input.at(";") {
        recover::semicolon(input, Items::OfStep, sink);
    }
    Ok(Association { mark, qualifier, time, event, target, condition })
}

/// What stands elsewhere or is written in another way.
fn misplaced(input: &Input) -> Result<()> {
    if input.at_group(Delimiter::Brace) {
        return Err(input.error("a block has a qualifier: `P1 { … }` runs once, `N { … }` in every cycle"));
    }
    let Some(word) = input.word() else {
        if chain::begins(input) {
            return Err(input.error("transitions stand after the steps, not in them"));
        }
        return Err(input.error(format!("expected what the step does, such as `N q;`, found {}", input.found())));
    };
    let next = input.next();
    if word == "if" {
        return Err(input.error("the condition stands after the action: `q if condition;`"));
    }
    if words::item_begins(input) {
        return Err(input.error(
            if matches!(words::meant(word), Some("input" | "output" | "var" | "param" | "let" | "action")) {
                "declarations stand in front of the steps, not in them"
            } else {
                "steps, transitions and properties stand beside this step, not in it"
            },
        ));
    }
    if next.at("->") || next.at("-") && next.next().at_group(Delimiter::Bracket) {
        return Err(input.error("transitions stand after the steps, not in them"));
    }
    Ok(())
}

/// `on rising(a)`, unless `on` is the name of an output.
fn on(input: &mut Input) -> Result<Option<(Span, syn::Expr)>> {
    let next = input.next();
    let called = next.at_group(Delimiter::Parenthesis) && ends(&next.next());
    if !input.at_word("on") || ends(&next) || next.at_assign() || called {
        return Ok(None);
    }
    input.bump();
    let span = input.last();
    let what = "an event, such as `rising(a)`";
    if input.at_group(Delimiter::Brace) {
        return Err(input.error(format!("expected {what}, found `{{`")));
    }
    let event = condition::before_block(input, what)?;
    if input.at("=>") || input.at("->") || input.at(":") {
        let message = "what happens then stands right after the event: `on rising(a) n = 1;`; a transition stands after the steps";
        return Err(input.error(message));
    }
    Ok(Some((span, event)))
}

/// Whether a target is complete in front of `input`.
fn ends(input: &Input) -> bool {
    input.is_empty() || input.at(";") || input.at_word("if")
}

fn take_qualifier(input: &mut Input) -> Result<Option<(Qualifier, Span)>> {
    let Some(word) = input.word() else { return Ok(None) };
    let next = input.next();
    let Some(qualifier) = Qualifier::of_letters(word) else {
        return unknown(input, word).map(|()| None);
    };
    if next.at(":") && !next.at(":=") {
        let message = format!("a qualifier stands in front of what it acts on, without `:`: `{word} q;`");
        return Err(next.error(message));
    }
    if next.at_assign() || next.at_group(Delimiter::Parenthesis) && ends(&next.next()) {
        return Ok(None);
    }
    let span = input.span();
    input.bump();
    let sign = |sign| next.after(sign).filter(|_| word == "P" && !next.at("+=") && !next.at("-="));
    let qualifier = if let Some(rest) = sign("+") {
        *input = rest;
        Qualifier::P1
    } else if let Some(rest) = sign("-") {
        *input = rest;
        Qualifier::P0
    } else {
        qualifier
    };
    if ends(input) {
        let example = if qualifier.has_time() { format!("{word} 5s q") } else { format!("{word} q") };
        return Err(Error::new(span, format!("the qualifier `{word}` acts on something: `{example};`")));
    }
    Ok(Some((qualifier, span)))
}

/// What to write for a word with which other notations say when something is done, or what comes then.
fn moment(word: &str) -> Option<&'static str> {
    if GOES.contains(&word) {
        return Some("transitions stand after the steps, not in them: `A -[x]-> B;`");
    }
    MOMENTS.contains(&word).then_some(BY_MOMENT)
}

/// Refuses `X q`, `s q` and `X 5s q`, where something stands like a qualifier and is none.
fn unknown(input: &mut Input, word: &str) -> Result<()> {
    let next = input.next();
    let braces = next.at_group(Delimiter::Brace);
    let time = next.next();
    let qualifier_follows = next.word().is_some_and(is_qualifier)
        && !next.on_new_line()
        && (ends(&time) || time.literal().is_some() && ends(&time.next()));
    let stands_like_one = next.at_name() || next.literal().is_some() || braces;
    if let (Some(message), true) = (moment(word), next.at(":") && !next.at(":=")) {
        return Err(input.error(message));
    }
    if word == "F" && next.at("/") {
        let (target, order) = (next.next(), next.next().next());
        let message = match target.word() {
            Some(target) if order.at_group(Delimiter::Brace) => {
                format!("a forcing order is written `force {target} {{…}};`")
            }
            _ => "a forcing order is written `force G {INIT};`".to_owned(),
        };
        let mark = Mark { start: input.span(), end: next.span() };
        return Err(Error::new(mark, message));
    }
    // `q when c`: the end of the line says what is wrong.
    let conditional = next.word().is_some_and(|word| recover::is_conditional(&word.to_lowercase()));
    if !stands_like_one || conditional || next.on_new_line() || begins(&next) && !qualifier_follows {
        return Ok(());
    }
    if qualifier_follows {
        let qualifier = next.word().unwrap_or_default();
        let end = if ends(&time) { time } else { time.next() };
        let time = time.literal().map_or_else(String::new, |time| format!(" {time}"));
        let message = format!("the qualifier stands in front: `{qualifier}{time} {word};`");
        let mark = Mark { start: input.span(), end: end.last() };
        *input = end;
        return Err(Error::new(mark, message));
    }
    let upper = word.to_uppercase();
    Err(input.error(if is_qualifier(&upper) {
        format!("qualifiers are capital letters: write `{upper}`")
    } else if word == "when" {
        "a condition stands after the action, `q if condition;`, and a transition after the steps, `A -[x]-> B;`"
            .to_owned()
    } else if words::meant(word) == Some("step") {
        "a step cannot stand in a step; a `macro step` or an `enclosing step` holds others".to_owned()
    } else if let Some(message) = moment(word) {
        message.to_owned()
    } else if let Some((_, letter)) = SPOKEN.iter().find(|(spoken, _)| *spoken == word.to_lowercase()) {
        format!("`{word}` is the qualifier `{letter}`: `{letter} {};`", next.word().unwrap_or("q"))
    } else {
        format!("`{word}` is no qualifier; {ALL}")
    }))
}

/// The time of a qualifier that has one.
fn time(input: &mut Input, qualifier: Option<(Qualifier, Span)>, sink: &mut Sink) -> Result<Option<TimeArg>> {
    let Some((qualifier, span)) = qualifier else { return Ok(None) };
    let word = qualifier.word();
    if let Some((_, time)) = foreign::iec_time(input) {
        let start = *input;
        input.bump();
        input.bump();
        sink.notation(start.span(), format!("a time is written with its unit alone: `{time}`"));
    }
    if let Some(literal) = input.literal() {
        if qualifier.has_time() {
            return Ok(time::parse(input, literal, sink).map(TimeArg::Literal));
        }
        sink.notation(input.span(), format!("`{word}` takes no time; those that do are L, D, SD, DS and SL"));
        input.bump();
        return Ok(None);
    }
    if !qualifier.has_time() {
        return Ok(None);
    }
    // `L soak q`: a name is the time where a target follows it, on whatever line, and not the next association.
    let next = input.next();
    let another = next.on_new_line() && begins(&next);
    let target_follows = next.at_group(Delimiter::Brace) || next.at_name() && !another;
    if input.word().is_some() && target_follows {
        return Ok(input.eat_ident().map(TimeArg::Name));
    }
    if input.at_group(Delimiter::Parenthesis) {
        return Err(input.error(format!(
            "the time of `{word}` is a literal such as `5s` or the name of a `param` or `var` of type `time`"
        )));
    }
    if let (Some(target), Some(time)) = (input.word(), next.literal()) {
        let mark = Mark { start: input.span(), end: next.span() };
        return Err(Error::new(
            mark,
            format!("the time of `{word}` stands in front of its target: `{word} {time} {target};`"),
        ));
    }
    let message = if input.word().is_some() && (input.next().at(";") || input.next().is_empty()) {
        format!("`{word}` needs two things after it, a time and its target: `{word} 5s q;`")
    } else {
        format!("`{word}` needs a time in front of its target: `{word} 5s q;`")
    };
    sink.notation(span, message);
    Ok(None)
}

fn after_qualifier(input: &mut Input, start: &Input, qualifier: Option<(Qualifier, Span)>) -> Result<Target> {
    if ends(input) {
        let mark = Mark { start: start.span(), end: input.last() };
        return Err(Error::new(mark, "this acts on nothing; name an output, a variable or an action after it"));
    }
    if let (Some((_, span)), Some(word)) = (qualifier, input.word()) {
        let next = input.next();
        let another = next.at_name() && !next.on_new_line() && !begins(&next);
        if another && is_qualifier(word) {
            let mark = Mark { start: span, end: input.span() };
            return Err(Error::new(mark, "an association has one qualifier; write a line for each"));
        }
    }
    target::parse(input)
}
