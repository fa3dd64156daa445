//! After a broken item: where the next one begins, and which names are missing now.

use proc_macro2::{Delimiter, Ident};

use super::input::Turns;
use super::{Error, Input, association, attrs, chain, words};
use crate::diagnostic::Sink;
use crate::list::{List, PushAll};

/// Which items stand in a body.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Items {
    OfChart,
    OfStep,
}

impl Items {
    /// Whether an item begins at `input`, as far as can be told in the middle of another one.
    fn item_begins(self, input: &Input) -> bool {
        let line = input.on_new_line();
        if line && input.at("#") {
            return true;
        }
        match self {
            Self::OfChart => words::item_begins(input) || line && chain::begins(input),
            Self::OfStep => association::begins(input) || line && association::could_begin(input),
        }
    }
}

/// Steps over the rest of a broken item: after its `;` or its braces, or before what must be the next one.
pub(super) fn skip(input: &mut Input, start: &Input, items: Items) {
    if input.is_at(start) {
        input.bump();
    }
    let mut turns = Turns::default();
    while turns.more(input) && !items.item_begins(input) {
        let brace = input.at_group(Delimiter::Brace);
        if input.eat(";") {
            return;
        }
        input.bump();
        // Braces end an item, unless they are in the middle of an expression.
        if brace && !input.at(";") && (input.on_new_line() || input.word().is_some()) {
            return;
        }
    }
}

/// Steps over a token that nobody has read and nobody complained about, so that what follows is read.
pub(super) fn moved(input: &mut Input, start: &Input, sink: &mut Sink) {
    if input.is_at(start) && !input.is_empty() {
        unexpected(input).report(sink);
        input.bump();
    }
}

/// The `;` at the end of an item. Where it is missing, or something stands before it, that is reported, and the item
/// stays: what it says is understood.
pub(super) fn semicolon(input: &mut Input, items: Items, sink: &mut Sink) {
    if input.eat(";") {
        return;
    }
    let chain = || items == Items::OfChart && input.word().is_some() && chain::begins(input);
    if input.is_empty() || input.on_new_line() || items.item_begins(input) || chain() {
        sink.notation(input.last(), "`;` is missing after this");
        return;
    }
    if items == Items::OfStep && input.at(",") {
        sink.notation(input.span(), "each line of a step ends with `;`, not with `,`");
        input.bump();
        return;
    }
    unexpected(input).report(sink);
    let start = *input;
    skip(input, &start, items);
}

/// Whether other notations have the word in front of a condition.
pub(super) fn is_conditional(word: &str) -> bool {
    ["when", "falls", "wenn", "unless"].contains(&word)
}

/// Something stands where `;` should.
fn unexpected(input: &Input) -> Error {
    let found = input.found();
    if input.at(":=") {
        return input.error("an assignment is written `=`, not `:=`");
    }
    if input.at_attribute() {
        return input.error(attrs::MISPLACED);
    }
    if input.at("#") {
        return input.error("a time is written with its unit alone: `5s`, not `T#5s`");
    }
    let word = input.word().unwrap_or_default().to_lowercase();
    if is_conditional(&word) {
        let not = if word == "unless" { "!" } else { "" };
        return input.error(format!("the condition of an action stands after `if`: `q if {not}condition;`"));
    }
    if ["after", "nach"].contains(&word.as_str()) && input.next().literal().is_some() {
        return input.error("an action that begins later has the qualifier `D` and its time in front: `D 5s q;`");
    }
    if word == "implies" || input.at("->") {
        return input.error("an implication is written `=>`: `always a => b;`");
    }
    input.error(format!("expected `;`, found {found}"))
}

/// The names that the item at `start`, which is broken, would have declared.
pub(super) fn names(mut start: Input) -> Vec<Ident> {
    attributes(&mut start);
    let Some(first) = start.eat_ident() else { return Vec::new() };
    attributes(&mut start);
    let written = first.to_string();
    if let Some(inside) = start.enter(Delimiter::Brace) {
        // `input { a, b: bool }`
        let declares = matches!(words::meant(&written), Some("input" | "output" | "var" | "param"));
        return if declares { inside.names_until(&start).list() } else { vec![first] };
    }
    if association::is_qualifier(&written) || written == "force" {
        return Vec::new();
    }
    if start.at(":") || start.at_word("step") && words::meant(&written).is_none() {
        return vec![first];
    }
    // `start, stop: bool`, where `start` is no word of ours.
    let mut word = words::meant(&written).filter(|_| !start.at(",")).unwrap_or_default();
    // `initial step Off`: the name stands after the last of the words.
    let mut turns = Turns::default();
    while turns.more(&start)
        && matches!(word, "initial" | "final" | "linked" | "entry" | "exit" | "macro" | "enclosing")
    {
        let Some(next) = start.word() else { break };
        word = words::meant(next).unwrap_or("step");
        if words::meant(next).is_some() {
            start.bump();
        }
    }
    // An unknown word in front of a name stood for one of these.
    if !matches!(word, "" | "input" | "output" | "var" | "param" | "let" | "action" | "step" | "partial") {
        return Vec::new();
    }
    let is_list = matches!(word, "" | "input" | "output" | "var" | "param");
    let mut names = Vec::new();
    if word.is_empty() && start.eat(",") {
        names.push(first);
    }
    listed(&mut start, is_list, &mut names);
    // `speed: u32, direction: Direction`: several lists in one.
    let mut turns = Turns::default();
    while is_list && turns.more(&start) && !start.at(";") && !start.on_new_line() {
        let name = start;
        if start.bump() && start.at(":") && !start.at("::") && !name.at(":") {
            names.push_all({ name }.eat_ident());
        }
    }
    names
}

/// The names that stand next; in a list the comma may be what is missing, or one too many.
fn listed(input: &mut Input, is_list: bool, names: &mut Vec<Ident>) {
    let mut turns = Turns::default();
    while turns.more(input) {
        if let Some(name) = input.eat_ident() {
            names.push(name);
        } else if !is_list || input.at(":") || input.at(";") || input.on_new_line() {
            return;
        } else if !input.at(",") {
            input.bump();
        }
        if !input.eat(",") && !is_list {
            return;
        }
    }
}

/// Steps over attributes.
fn attributes(input: &mut Input) {
    while input.eat("#") {
        input.enter(Delimiter::Bracket);
    }
}

/// Whether the item at `start`, which is broken, is a step without a name.
pub(super) fn is_nameless_step(mut start: Input) -> bool {
    attributes(&mut start);
    let (mut is_step, mut turns) = (false, Turns::default());
    while turns.more(&start) && !is_step {
        match start.word().and_then(words::meant) {
            Some("step") => is_step = true,
            Some("initial" | "final" | "linked" | "entry" | "exit" | "macro" | "enclosing") => {}
            _ => return false,
        }
        start.bump();
    }
    is_step && (start.at(";") || start.at_group(Delimiter::Brace) || start.at_word("within"))
}

/// Whether the item at `start`, which is broken, may have been a step.
pub(super) fn may_be_step(mut start: Input) -> bool {
    attributes(&mut start);
    let Some(first) = start.word() else { return false };
    let no_step = ["input", "output", "var", "param", "let", "action", "partial"];
    match words::meant(first) {
        Some(word) => !no_step.contains(&word) && !SETTINGS.contains(&word),
        None => !chain::begins(&start),
    }
}

const SETTINGS: [&str; 11] = [
    "clock",
    "max_evolutions",
    "budget",
    "assume",
    "optimize",
    "encoding",
    "forceable",
    "modes",
    "never",
    "always",
    "home",
];
