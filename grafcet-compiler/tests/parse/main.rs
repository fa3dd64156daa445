//! The parser: every form of the language, every message, recovery after mistakes, hostile sizes.

mod forms;
mod fragments;
mod generated;
mod generator;
mod limits;
mod messages;
mod progress;
mod random;
mod recovery;
mod show;
mod times;

use grafcet_compiler::ast::Chart;
use grafcet_compiler::diagnostic::Sink;
use grafcet_compiler::parse;

/// Parses a text; the chart, and each message with the text it marks.
fn run(text: &str) -> (Option<Chart>, Vec<(String, String)>) {
    let mut sink = Sink::new();
    let chart = parse::chart(text.parse().expect("tokens"), &mut sink);
    let notes = sink.finish().into_iter().flat_map(|diagnostic| diagnostic.notes);
    let errors = notes.map(|(mark, message)| (marked(text, mark.start.start(), mark.end.end()), message)).collect();
    (chart, errors)
}

/// The text between two places.
fn marked(text: &str, start: proc_macro2::LineColumn, end: proc_macro2::LineColumn) -> String {
    let offset = |place: proc_macro2::LineColumn| {
        let lines = text.split_inclusive('\n').take(place.line.saturating_sub(1)).map(|line| line.chars().count());
        lines.sum::<usize>() + place.column
    };
    text.chars().skip(offset(start)).take(offset(end).saturating_sub(offset(start))).collect()
}
