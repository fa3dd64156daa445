//! Words and signs of other notations in an expression that Rust could not read.

use proc_macro2::Delimiter;

use super::input::Turns;
use super::{Error, Input, Result, refused};
use crate::diagnostic::{Mark, Sink};

/// All of them from here to the end of the item, each with what is written here.
pub(super) fn all(mut input: Input) -> Option<Error> {
    let mut notes = Vec::new();
    let start = input;
    collect(&mut input, &mut notes, true);
    if notes.is_empty() && start.at_word("if") {
        notes.push((start.span().into(), "a condition stands for itself; remove `if`".to_owned()));
    }
    if notes.is_empty() {
        notes.extend(single(start));
    }
    Error::several(notes)
}

/// `(* a comment *)`, as IEC 61131-3 writes it, and `# a comment`, which are reported and stepped over.
pub(super) fn comments(input: &mut Input, sink: &mut Sink) {
    const MESSAGE: &str = "a comment is written `/* … */`, or `// …` to the end of the line";
    let in_parentheses = |input: &Input| { *input }.enter(Delimiter::Parenthesis).is_some_and(|inside| inside.at("*"));
    let mut turns = Turns::default();
    while turns.more(input) {
        let next = input.next();
        if in_parentheses(input) {
            sink.notation(input.span(), MESSAGE);
            input.bump();
        } else if input.at("#") && (next.word().is_some() || next.literal().is_some()) {
            sink.notation(input.span(), MESSAGE);
            input.bump();
            // Where the toolchain does not tell lines apart, to the end of the item.
            let mut turns = Turns::default();
            while turns.more(input) && !input.on_new_line() && !(input.at(";") && input.next().on_new_line()) {
                input.bump();
            }
        } else {
            return;
        }
    }
}

/// An item of Rust in a chart.
pub(super) fn of_rust(input: &Input, word: &str) -> Result<()> {
    let named = starts_operand(&input.next());
    Err(input.error(match word {
        "fn" | "method" => {
            "code is declared `action heat(setpoint: i16);` and written as a method of the chart's trait"
        }
        "use" | "struct" | "enum" | "type" | "mod" | "impl" | "trait" | "extern" | "unsafe" | "macro_rules"
            if named =>
        {
            "items of Rust stand outside of the chart, before `grafcet!` or after it"
        }
        _ => return Ok(()),
    }))
}

/// A keyword of Rust that no expression has, in one that Rust could not read: it was meant as a name.
pub(super) fn keyword(mut input: Input) -> Option<Error> {
    let declared = refused::keywords(&input);
    for _ in 0..100 {
        let word = input.word().unwrap_or_default();
        if input.is_empty() || input.at(";") || word == "for" {
            return None;
        }
        let is_name =
            ["in", "type", "use", "mod", "pub", "enum", "trait", "impl", "where", "do", "final"].contains(&word);
        if is_name && declared.iter().all(|name| name != word) {
            let message =
                format!("`{word}` is a keyword of Rust; a signal of that name is written `r#{word}` everywhere");
            return Some(input.error(message));
        }
        input.bump();
    }
    None
}

/// `a > 3 & b < 5`: to Rust `a > (3 & b) < 5`, which it does not read.
fn single(mut input: Input) -> Option<(Mark, String)> {
    let (mut compared, mut operand, mut sign) = (false, false, None);
    for _ in 0..100 {
        if input.is_empty() || input.at(";") || input.at("=>") {
            return None;
        }
        if let Some(after) = input.after("&&").or_else(|| input.after("||")).or_else(|| input.after(",")) {
            (input, compared, operand, sign) = (after, false, false, None);
            continue;
        }
        if let Some(inside) = input.delimiter().and_then(|delimiter| input.enter(delimiter)) {
            let found = single(inside);
            if found.is_some() {
                return found;
            }
            operand = true;
            continue;
        }
        if let Some(compares) = ["<=", ">=", "==", "!=", "<", ">"].iter().find_map(|sign| input.after(sign)) {
            if sign.is_some() {
                return sign;
            }
            (input, compared, operand) = (compares, true, false);
            continue;
        }
        if let (true, Some(bits @ ('&' | '|'))) = (compared && operand, input.punct().map(proc_macro2::Punct::as_char))
        {
            let message = format!("between conditions stands `{bits}{bits}`; `{bits}` binds closer than a comparison");
            sign = Some((input.span().into(), message));
        }
        operand = input.punct().is_none();
        input.bump();
    }
    None
}

/// Whether something stands here that an expression can begin with.
pub(super) fn starts_operand(input: &Input) -> bool {
    input.at_name() || input.literal().is_some()
}

/// `T#5s`: the input after it and what stands after the sign.
pub(super) fn iec_time<'a>(input: &Input<'a>) -> Option<(Input<'a>, String)> {
    let word = input.word().filter(|word| ["t", "time", "lt", "ltime"].contains(&word.to_lowercase().as_str()));
    word.filter(|_| input.next().at("#"))?;
    let literal = input.next().next();
    Some((literal.next(), literal.literal()?.to_string()))
}

/// What Rust calls an operator that is written as a word.
fn operator(word: &str) -> Option<&'static str> {
    match word.to_lowercase().as_str() {
        "and" => Some("&&"),
        "or" => Some("||"),
        "not" => Some("!"),
        "xor" => Some("^"),
        "mod" => Some("%"),
        _ => None,
    }
}

/// At the `outermost` level, `=>` ends a condition.
fn collect(input: &mut Input, notes: &mut Vec<(Mark, String)>, outermost: bool) {
    let mut operand = false;
    // Where a `;` is missing, the rest of the chart is no part of this condition.
    for _ in 0..100 {
        if input.is_empty() || input.at(";") || outermost && input.at("=>") {
            return;
        }
        let start = *input;
        if let Some((after, message)) = sign(input, operand) {
            *input = after;
            notes.push((input.since(&start), message));
            operand = start.punct().is_none() && operator(start.word().unwrap_or_default()).is_none();
            continue;
        }
        operand = input.punct().is_none();
        match input.delimiter().and_then(|delimiter| input.enter(delimiter)) {
            Some(mut inside) => collect(&mut inside, notes, false),
            None => {
                input.bump();
            }
        }
    }
}

const IMPLIES: &str = "an implication is written `=>`: `always a => b;`; within a condition it is `!a || b`";

/// The word or sign of another notation at `input`, as far as it reaches, and what to write in its place.
fn sign<'a>(input: &Input<'a>, operand: bool) -> Option<(Input<'a>, String)> {
    let next = input.next();
    if let Some((after, time)) = iec_time(input) {
        return Some((after, format!("a time is written with its unit alone: `{time}`")));
    }
    if let Some((word, ours)) = input.word().and_then(|word| Some((word, operator(word)?))) {
        // A name like any other, unless an operand follows it.
        let operates = starts_operand(&next) || next.at_group(Delimiter::Parenthesis) || next.at("!");
        return operates.then(|| (next, format!("`{word}` is written `{ours}`")));
    }
    if let (Some(edge @ ("rising" | "falling")), Some(name)) = (input.word(), next.word()) {
        return Some((next.next(), format!("an edge is written `{edge}({name})`")));
    }
    if input.word() == Some("after") && next.literal().is_some() {
        let message = "a time is asked of a step: `5s/A` holds once step `A` has been active for so long";
        return Some((next.next(), message.to_owned()));
    }
    if let (Some(number), Some(unit @ ("h" | "m" | "s" | "ms" | "us" | "min"))) = (input.literal(), next.word()) {
        let unit = if unit == "min" { "m" } else { unit };
        return Some((next.next(), format!("number and unit stand together: write `{number}{unit}`")));
    }
    if let (Some(number), true, Some(part)) = (input.literal(), next.at(".") && !next.at(".."), next.next().literal()) {
        let time = format!("{number}.{part}");
        if time.ends_with(['h', 'm', 's']) {
            return Some((next.next().next(), format!("`{time}` is no time: a number has one decimal point")));
        }
    }
    let signs: [(&str, bool, &str); 11] = [
        ("<==>", true, "that two conditions are the same is written `a == b`"),
        ("<=>", true, "that two conditions are the same is written `a == b`"),
        ("<->", true, "that two conditions are the same is written `a == b`"),
        ("==>", true, IMPLIES),
        ("-->", true, IMPLIES),
        ("<>", true, "`<>` is written `!=`"),
        ("=<", true, "`=<` is written `<=`"),
        (":=", true, "a condition compares with `==`"),
        ("/", !operand, "a negation is written `!a`"),
        ("^", !operand, "an edge is written `rising(a)` or `falling(a)`"),
        ("%", !operand, "an address has a name here: declare `input start: bool;`, and the program fills it in"),
    ];
    let (text, _, message) = signs.into_iter().find(|(text, fits, _)| *fits && input.at(text))?;
    let mut end = input.after(text)?;
    if text == "%" {
        // `%IX0.0`
        let mut turns = Turns::default();
        while turns.more(&end) && (end.word().is_some() || end.literal().is_some() || end.at(".") && !end.at("..")) {
            end.bump();
        }
    }
    Some((end, message.to_owned()))
}
