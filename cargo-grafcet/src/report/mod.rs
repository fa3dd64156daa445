//! What the compiler says, as people and programs read it.

pub(crate) mod human;
pub(crate) mod json;
pub(crate) mod sarif;

use std::rc::Rc;

use grafcet_compiler::diagnostic::{Diagnostic, Mark, Severity};
use grafcet_exchange::Refused;
use proc_macro2::Span;

use crate::find::{Found, Source};

/// What is said of a chart.
pub(crate) struct Message {
    pub(crate) source: Rc<Source>,
    /// `Motor`
    pub(crate) chart: String,
    /// Where what stands nowhere is shown.
    pub(crate) call: Span,
    pub(crate) said: Diagnostic,
}

impl Message {
    pub(crate) fn is_error(&self) -> bool {
        self.said.severity == Severity::Deny
    }

    /// `error`, `warning`
    pub(crate) fn level(&self) -> &'static str {
        if self.is_error() { "error" } else { "warning" }
    }

    /// `grafcet::deadlock`; none for a mistake of notation.
    pub(crate) fn rule(&self) -> Option<String> {
        self.said.rule.map(|rule| format!("grafcet::{}", rule.name))
    }

    pub(crate) fn notes(&self) -> impl Iterator<Item = Note<'_>> {
        self.said.notes.iter().map(|(mark, text)| {
            let (sentence, table) = text.split_once('\n').unwrap_or((text, ""));
            let place = Place::of(*mark, &self.source).unwrap_or_else(|| Place::or_begin(self.call, &self.source));
            Note { place, sentence, table }
        })
    }
}

/// One participant of a mistake.
pub(crate) struct Note<'m> {
    pub(crate) place: Place,
    pub(crate) sentence: &'m str,
    /// What stands below the sentence, as the cycles of a counterexample; often nothing.
    pub(crate) table: &'m str,
}

/// From the first to the last character of a mark.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Place {
    /// In bytes.
    pub(crate) start: usize,
    pub(crate) end: usize,
    pub(crate) from: At,
    /// After the last character.
    pub(crate) to: At,
}

/// A line and a column, both counted from one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct At {
    pub(crate) line: usize,
    /// In characters.
    pub(crate) column: usize,
}

/// Where what has no translation stands; else where the chart is called.
fn place(chart: &Found, refused: &Refused) -> Place {
    let mark = refused.mark.unwrap_or_else(|| chart.call.into());
    Place::of(mark, &chart.source).unwrap_or_else(|| Place::or_begin(chart.call, &chart.source))
}

impl Place {
    /// A mark in its file; none where it stands nowhere in it, as what is said of a call without a token.
    pub(crate) fn of(mark: Mark, source: &Source) -> Option<Self> {
        let (start, end) = (mark.start.byte_range().start, mark.end.byte_range().end);
        (end > 0 && source.text.get(start..end).is_some()).then(|| Self::between(start, end, source))
    }

    /// The same, or the beginning of the file.
    pub(crate) fn or_begin(span: Span, source: &Source) -> Self {
        Self::of(span.into(), source).unwrap_or_else(|| Self::between(0, 0, source))
    }

    fn between(start: usize, end: usize, source: &Source) -> Self {
        Self { start, end, from: At::of(start, source), to: At::of(end, source) }
    }
}

impl At {
    fn of(byte: usize, source: &Source) -> Self {
        let before = &source.text[..byte];
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().map_or(0, |line| line.chars().count()) + 1;
        Self { line, column }
    }
}
