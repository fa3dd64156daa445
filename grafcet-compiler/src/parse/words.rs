//! The words of the notation, and those that people write in their place.

use proc_macro2::Ident;

use super::Input;
use crate::diagnostic::Sink;

/// Every word that can begin an item of a body.
pub(super) const ITEMS: &[&str] = &[
    "input",
    "output",
    "var",
    "param",
    "action",
    "clock",
    "max_evolutions",
    "budget",
    "assume",
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
    ("in", "input"),
    ("out", "output"),
    ("let", "var"),
    ("static", "var"),
    ("mut", "var"),
    ("const", "param"),
    ("parameter", "param"),
    ("constant", "param"),
    ("end", "final"),
];

/// The word of the notation that `ident`, followed by what it is followed by, was meant to be.
pub(super) fn meant(ident: &Ident) -> Option<&'static str> {
    let written = ident.to_string();
    let lower = written.to_lowercase();
    let exactly = ITEMS.iter().find(|word| **word == lower);
    let elsewhere = || ELSEWHERE.iter().find(|(word, _)| *word == lower).map(|(_, ours)| ours);
    let nearly = || {
        let near = |word: &&&str| word.len() > 3 && strsim::osa_distance(word, &lower) <= word.len() / 4;
        ITEMS.iter().find(near)
    };
    exactly.or_else(elsewhere).or_else(nearly).copied()
}

/// Reports a word that is meant, but not written, as one of the notation.
pub(super) fn report(ident: &Ident, meant: &str, sink: &mut Sink) {
    sink.notation(ident, format!("`{ident}` is no word of the notation; write `{meant}`"));
}

/// Whether an item certainly begins here: no expression has one of our words before a name or a number.
pub(super) fn item_begins(input: &Input) -> bool {
    let Some(word) = input.ident() else { return false };
    let behind = input.next();
    ITEMS.iter().any(|item| word == item) && (behind.ident().is_some() || behind.literal().is_some())
}
