//! As rustc shows it, at the place in the file.

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use proc_macro2::Span;

use super::{Message, Note, Place};
use grafcet_exchange::Refused;

use crate::find::{Found, Source};

/// One message with all who take part.
pub(crate) fn shown(message: &Message) -> String {
    let path = message.source.path.display().to_string();
    let level = if message.is_error() { Level::ERROR } else { Level::WARNING };
    let rule = message.rule();
    let mut groups = Vec::new();
    for (index, note) in message.notes().enumerate() {
        let mut group = if index == 0 {
            let title = level.clone().primary_title(note.sentence);
            Group::with_title(match &rule {
                Some(rule) => title.id(rule.as_str()),
                None => title,
            })
        } else {
            Group::with_title(Level::NOTE.secondary_title(note.sentence))
        };
        group = group.element(snippet(&message.source, &path, &note));
        if !note.table.is_empty() {
            group = group.element(Level::NOTE.message(note.table));
        }
        groups.push(group);
    }
    format!("{}\n", Renderer::styled().render(&groups))
}

fn snippet<'s>(source: &'s Source, path: &'s str, note: &Note<'_>) -> Snippet<'s, annotate_snippets::Annotation<'s>> {
    Snippet::source(&source.text).path(path).annotation(AnnotationKind::Primary.span(note.place.start..note.place.end))
}

/// Why a chart has no translation, at its place or at the chart's call.
pub(crate) fn refused(chart: &Found, refused: &Refused) -> String {
    let place = super::place(chart, refused);
    let path = chart.source.path.display().to_string();
    let note = Note { place, sentence: &refused.message, table: "" };
    let title = format!("{} has no translation: {}", chart.name, refused.message);
    let group = Group::with_title(Level::ERROR.primary_title(&title)).element(snippet(&chart.source, &path, &note));
    format!("{}\n", Renderer::styled().render(&[group]))
}

/// An error at a place, for what is no chart.
pub(crate) fn at(source: &Source, span: Span, what: &str) -> String {
    let place = Place::or_begin(span, source);
    in_file(source, place.start..place.end, &Level::ERROR, what)
}

/// What is said of a place in a file of any kind.
pub(crate) fn in_file(source: &Source, at: std::ops::Range<usize>, level: &Level<'_>, what: &str) -> String {
    let path = source.path.display().to_string();
    let title = level.clone().primary_title(what);
    // After the last character there is nothing to mark.
    let group = if at.start >= source.text.len() || source.text.get(at.clone()).is_none() {
        Group::with_title(title).element(Origin::path(&path))
    } else {
        let mark = AnnotationKind::Primary.span(at);
        Group::with_title(title).element(Snippet::source(&source.text).path(&path).annotation(mark))
    };
    Renderer::styled().render(&[group])
}
