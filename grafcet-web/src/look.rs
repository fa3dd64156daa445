//! What there is to say of a text while it is typed: messages at their places, the drawing, the names in it.

use grafcet_compiler::describe::with_description;
use grafcet_compiler::diagnostic::{Diagnostic, Severity};
use grafcet_compiler::model::Model;
use grafcet_compiler::{Wanted, diagnose};
use proc_macro2::Ident;
use serde_json::{Value, json};

use crate::text::{Places, Unread, Written};

/// What can be seen at once: the drawing, and where its parts stand in the text; the names.
pub(crate) fn look(text: &str) -> Value {
    let places = Places::of(text);
    let written = Written::find(text).ok();
    let found = written.as_ref().and_then(Written::model);
    let drawing = found.as_ref().filter(|(_, whole)| *whole);
    json!({
        "name": written.map_or_else(String::new, |written| written.name),
        "drawing": drawing.map(|(model, _)| with_description(model, grafcet_draw::svg_live)),
        "transitions": drawing.map_or_else(Vec::new, |(model, _)| transitions(model, &places)),
        "steps": drawing.map_or_else(Vec::new, |(model, _)| steps(model, &places)),
        "words": found.as_ref().map_or_else(Vec::new, |(model, _)| words(model)),
    })
}

/// What the compiler says, which may take its time; and whether the chart can run.
pub(crate) fn check(text: &str) -> Value {
    let places = Places::of(text);
    let written = match Written::find(text) {
        Ok(written) => written,
        Err(Unread { at, why }) => {
            let note = json!({ "from": at.start, "to": at.end, "text": why, "table": "" });
            return json!({ "messages": [{ "level": "error", "rule": null, "notes": [note] }], "runs": false });
        }
    };
    let said = diagnose(written.tokens.clone(), Wanted::default());
    // What a chart claims of itself may be broken: it runs all the same.
    let wrong = |one: &Diagnostic| one.severity == Severity::Deny && !one.is_about_a_claim();
    json!({
        "messages": said.iter().map(|one| message(one, &written, &places)).collect::<Vec<_>>(),
        "runs": !said.iter().any(wrong),
    })
}

/// Where the transitions stand in the text, in the order of the drawing's marks.
fn transitions(model: &Model, places: &Places<'_>) -> Vec<Value> {
    let all = model.drawn_transitions();
    all.map(|(_, transition)| places.mark(transition.mark).map_or(Value::Null, |at| json!([at.start, at.end])))
        .collect()
}

/// The same for the steps.
fn steps(model: &Model, places: &Places<'_>) -> Vec<Value> {
    let at = |name: &Ident| places.mark(name.into()).map_or(Value::Null, |at| json!([at.start, at.end]));
    model.steps.values().map(|step| at(&step.name)).collect()
}

fn message(said: &Diagnostic, written: &Written, places: &Places<'_>) -> Value {
    let notes = said.notes.iter().map(|(mark, text)| {
        let (sentence, table) = text.split_once('\n').unwrap_or((text, ""));
        let at = places.mark(*mark).or_else(|| places.mark(written.call.into())).unwrap_or(0..0);
        json!({ "from": at.start, "to": at.end, "text": sentence, "table": table })
    });
    json!({
        "level": if said.severity == Severity::Deny { "error" } else { "warning" },
        "rule": said.rule.map(|rule| rule.name),
        "notes": notes.collect::<Vec<_>>(),
    })
}

/// What can be completed: each name with what it is.
fn words(model: &Model) -> Vec<Value> {
    let word = |name: &Ident, kind: &str| json!([name.to_string(), kind]);
    let mut words: Vec<Value> = model.inputs.values().map(|one| word(&one.name, "input")).collect();
    words.extend(model.outputs.values().map(|one| word(&one.name, "output")));
    words.extend(model.vars.values().map(|one| word(&one.name, "variable")));
    words.extend(model.params.values().map(|one| word(&one.name, "parameter")));
    words.extend(model.lets.values().map(|one| word(&one.name, "named condition")));
    words.extend(model.actions.values().map(|one| word(&one.name, "action")));
    words.extend(model.steps.values().map(|one| word(&one.name, "step")));
    words.extend(model.macros.values().map(|one| word(&one.name, "macro-step")));
    words.extend(model.partials.values().filter_map(|one| one.name.as_ref()).map(|name| word(name, "partial grafcet")));
    words
}
