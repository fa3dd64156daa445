//! One object a message.

use grafcet_exchange::Refused;
use serde_json::{Value, json};

use super::{At, Message, Place};
use crate::find::{Found, Source};

fn at(at: At) -> Value {
    json!({ "line": at.line, "column": at.column })
}

/// In the file, as it lies there.
fn bytes(place: Place, source: &Source) -> [usize; 2] {
    [place.start, place.end].map(|at| at + source.skipped)
}

/// Why a chart has no translation, at its place or at the chart's call.
pub(crate) fn refused(chart: &Found, refused: &Refused) -> Value {
    let place = super::place(chart, refused);
    json!({
        "message": refused.message,
        "start": at(place.from),
        "end": at(place.to),
        "bytes": bytes(place, &chart.source),
    })
}

/// A message; each `note` has its own place, the culprit's first.
pub(crate) fn object(message: &Message) -> Value {
    let notes = message.notes().map(|note| {
        let place = note.place;
        let mut value = json!({
            "message": note.sentence,
            "start": at(place.from),
            "end": at(place.to),
            "bytes": bytes(place, &message.source),
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
