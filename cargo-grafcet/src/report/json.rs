//! One object a message.

use serde_json::{Value, json};

use super::{At, Message};

/// A message; each `note` has its own place, the culprit's first.
pub(crate) fn object(message: &Message) -> Value {
    let at = |at: At| json!({ "line": at.line, "column": at.column });
    let notes = message.notes().map(|note| {
        let place = note.place;
        let mut value = json!({
            "message": note.sentence,
            "start": at(place.from),
            "end": at(place.to),
            "bytes": [place.start, place.end],
        });
        if !note.table.is_empty() {
            value["table"] = note.table.into();
        }
        value
    });
    json!({
        "level": message.level(),
        "rule": message.rule(),
        "chart": message.chart,
        "file": message.source.path.display().to_string(),
        "notes": notes.collect::<Vec<_>>(),
    })
}
