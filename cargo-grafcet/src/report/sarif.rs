//! SARIF 2.1.0, which code scanning of hosting services reads.

use grafcet_compiler::diagnostic::{Severity, rules};
use serde_json::{Value, json};

use super::{Message, Note};

/// The page of rules, whose headings are the names.
const PAGE: &str = "https://docs.rs/grafcet/latest/grafcet/manual/rules";

/// All messages of one run.
pub(crate) fn log(messages: &[Message]) -> Value {
    let rules = rules::ALL.iter().map(|rule| {
        json!({
            "id": format!("grafcet::{}", rule.name),
            "defaultConfiguration": { "level": level(rule.default) },
            "helpUri": format!("{PAGE}/index.html#{}", rule.name),
        })
    });
    json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "cargo-grafcet",
                "version": env!("CARGO_PKG_VERSION"),
                "informationUri": "https://docs.rs/grafcet",
                "rules": rules.collect::<Vec<_>>(),
            }},
            // Columns count characters.
            "columnKind": "unicodeCodePoints",
            "results": messages.iter().map(result).collect::<Vec<_>>(),
        }],
    })
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Allow => "none",
        Severity::Warn => "warning",
        Severity::Deny => "error",
    }
}

fn result(message: &Message) -> Value {
    let mut notes = message.notes();
    let first = notes.next();
    let text = first.as_ref().map_or_else(String::new, |note| match note.table {
        "" => note.sentence.to_owned(),
        table => format!("{}\n{table}", note.sentence),
    });
    let mut result = json!({
        "level": level(message.said.severity),
        "message": { "text": text },
        "locations": first.iter().map(|note| location(message, note)).collect::<Vec<_>>(),
    });
    let related: Vec<Value> = notes
        .map(|note| {
            let mut place = location(message, &note);
            place["message"] = json!({ "text": note.sentence });
            place
        })
        .collect();
    if !related.is_empty() {
        result["relatedLocations"] = related.into();
    }
    // A mistake of notation has no rule.
    if let Some(rule) = message.rule() {
        result["ruleId"] = rule.into();
    }
    result
}

fn location(message: &Message, note: &Note<'_>) -> Value {
    let (from, to) = (note.place.from, note.place.to);
    json!({
        "physicalLocation": {
            "artifactLocation": { "uri": uri(&message.source.path) },
            "region": {
                "startLine": from.line, "startColumn": from.column, "endLine": to.line, "endColumn": to.column,
            },
        },
        "logicalLocations": [{ "name": message.chart, "kind": "type" }],
    })
}

/// A path as a reference: forward slashes, and everything but plain characters in percents.
fn uri(path: &std::path::Path) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let text = path.display().to_string().replace('\\', "/");
    let encoded: String = text
        .bytes()
        .map(|byte| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") })
        .collect();
    if path.is_absolute() { format!("file://{encoded}") } else { encoded }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::uri;

    #[test]
    fn paths_as_references() {
        assert_eq!(uri(Path::new("src/a b/ü.rs")), "src/a%20b/%C3%BC.rs");
        assert_eq!(uri(Path::new("/a/b.rs")), "file:///a/b.rs");
    }
}
