//! The words of the notation, and those that people write in their place.

use super::Input;
use crate::diagnostic::Sink;
use crate::similar;

/// Every word that can begin an item of a body.
pub(super) const ITEMS: &[&str] = &[
    "input",
    "output",
    "var",
    "param",
    "let",
    "action",
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
    "initial",
    "final",
    "linked",
    "entry",
    "exit",
    "macro",
    "enclosing",
    "step",
    "partial",
];

/// What other notations and languages call it.
const ELSEWHERE: &[(&str, &str)] = &[
    ("state", "step"),
    ("place", "step"),
    ("init", "initial"),
    ("start", "initial"),
    ("initial_step", "initial"),
    ("in", "input"),
    ("out", "output"),
    ("static", "var"),
    ("mut", "var"),
    ("const", "param"),
    ("parameter", "param"),
    ("constant", "param"),
    ("end", "final"),
    ("var_input", "input"),
    ("var_output", "output"),
    ("var_in_out", "var"),
    ("var_temp", "var"),
    ("eingang", "input"),
    ("ausgang", "output"),
    ("merker", "var"),
    ("variable", "var"),
    ("vars", "var"),
    ("schritt", "step"),
    ("initialschritt", "initial"),
    ("anfangsschritt", "initial"),
    ("aktion", "action"),
    ("globally", "always"),
    ("invariant", "always"),
    ("assert", "always"),
];

/// What can stand beside a name in an expression or a type.
const RUST: &[&str] = &[
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false", "fn",
    "for", "gen", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "raw", "ref", "return",
    "self", "Self", "static", "struct", "super", "trait", "true", "try", "type", "unsafe", "use", "where", "while",
    "yield",
];

/// The word of the notation that is written, or was meant by what is written.
pub(super) fn meant(written: &str) -> Option<&'static str> {
    if let Some(word) = ITEMS.iter().find(|word| **word == written) {
        return Some(word);
    }
    let lower = written.to_lowercase();
    let exactly = ITEMS.iter().find(|word| **word == lower);
    let elsewhere = || ELSEWHERE.iter().find(|(word, _)| *word == lower).map(|(_, ours)| ours);
    let nearly = || {
        let near = |word: &&&str| word.len() > 3 && similar::distance(word, &lower) <= word.len() / 4;
        ITEMS.iter().find(near)
    };
    exactly.or_else(elsewhere).or_else(nearly).copied().or_else(|| half_typed(written))
}

/// `inp` for `input`: as many letters as one word alone begins with. A capital one begins a name.
fn half_typed(written: &str) -> Option<&'static str> {
    // `force` is a word of its own, in a step.
    if written.len() < 3 || is_rust(written) || written == "force" {
        return None;
    }
    let mut begun = ITEMS.iter().filter(|word| word.starts_with(written));
    begun.next().filter(|_| begun.next().is_none()).copied()
}

/// `INITIAL_STEP`, as IEC 61131-3 writes it.
pub(super) fn is_initial_step(word: &str) -> bool {
    ["initial_step", "initialschritt", "anfangsschritt"].iter().any(|known| word.eq_ignore_ascii_case(known))
}

/// Reports the next word, which is meant, but not written, as one of the notation.
pub(super) fn report(input: &Input, meant: &str, sink: &mut Sink) {
    let both = input.word().is_some_and(is_initial_step);
    let meant = if both { "initial step" } else { meant };
    sink.notation(input.span(), format!("{} is no word of the notation; write `{meant}`", input.found()));
}

/// Whether an item certainly begins here: no expression has one of our words before a name or a number.
pub(super) fn item_begins(input: &Input) -> bool {
    let next = input.next();
    if input.at_word("let") {
        // `if let` binds a pattern; one of ours is a name.
        return next.at_name() && (next.next().at_assign() || next.next().at(":"));
    }
    input.word().is_some_and(|word| ITEMS.contains(&word)) && (next.at_name() || next.literal().is_some())
}

/// Whether `word` is a keyword that Rust allows in an expression or a type.
pub(super) fn is_rust(word: &str) -> bool {
    RUST.contains(&word)
}
