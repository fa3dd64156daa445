//! `cargo grafcet import`

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use annotate_snippets::Level;
use clap::Args as Arguments;
use grafcet_exchange::import::{Chart, Imported, import};
use serde_json::{Value, json};

use crate::find::{self, Source};
use crate::report::{Message, human};
use crate::{Failure, Outcome, check, complain, say};

/// Make Rust of charts of PLC tools: PLCopen XML and the textual form of SFC
///
/// Each SFC of the file becomes a chart, as a person would have written it: chains of transitions, names as Rust has them, comments kept. Conditions and actions in structured text
/// are translated; what is not is a stub with its text, and said at its place. What was renamed stands at the top of the file.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet import plc.xml
  cargo grafcet import motor.st -o src/motor.rs

Exit code 1 says that something is to be looked at or to be written, or that the compiler refuses a chart.")]
pub(crate) struct Import {
    /// PLCopen XML (TC6), or `PROGRAM … END_PROGRAM` with steps and transitions
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Write to this file
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// One JSON object: the source, and of each chart what was renamed and what is to be looked at
    #[arg(long, conflicts_with = "output")]
    pub(crate) json: bool,
}

pub(crate) fn run(options: &Import) -> Result<Outcome, Failure> {
    let path = &options.file;
    let text = fs::read_to_string(path).map_err(|error| Failure::file(path, &error))?;
    let source = Source { path: find::shown(path), text, skipped: 0 };
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let done = import(&source.text, &name)
        .map_err(|wrong| Failure::Shown(human::in_file(&source, wrong.at, &Level::ERROR, &wrong.message)))?;
    let errors = errors(options.output.as_deref().unwrap_or(path), &done)?;
    if options.json {
        say(&format!("{}\n", object(&done, &source, errors)))?;
    } else {
        told(&done, &source);
        match &options.output {
            Some(file) => fs::write(file, &done.rust).map_err(|error| Failure::file(file, &error))?,
            None => say(&done.rust)?,
        }
        if errors > 0 {
            let file = options.output.as_ref().map_or("FILE".into(), |file| file.display().to_string());
            complain(&format!(
                "note: the compiler has {} about it, which `cargo grafcet check {file}` shows",
                if errors == 1 { "an error".to_owned() } else { format!("{errors} errors") }
            ));
        }
    }
    let noted = done.charts.iter().any(|chart| !chart.notes.is_empty());
    Ok(Outcome::wrong_if(noted || errors > 0))
}

/// How many errors the compiler has about what has been made.
fn errors(path: &Path, done: &Imported) -> Result<usize, Failure> {
    let charts = find::of_text(path, &done.rust)?;
    let all = charts.iter().flat_map(|chart| check::messages_of(chart, None));
    Ok(all.filter(Message::is_error).count())
}

/// What is to be looked at, at its place.
fn told(done: &Imported, source: &Source) {
    for note in done.charts.iter().flat_map(|chart| &chart.notes) {
        complain(&format!("{}\n", human::in_file(source, marked(&note.at, source), &Level::WARNING, &note.message)));
    }
}

/// Nobody reads a mark over many lines.
fn marked(at: &Range<usize>, source: &Source) -> Range<usize> {
    let text = source.text.get(at.clone()).unwrap_or_default();
    let begin = at.start + text.len() - text.trim_start().len();
    let line = text.trim().lines().next().unwrap_or_default().trim_end();
    begin..begin + line.len()
}

fn object(done: &Imported, source: &Source, errors: usize) -> Value {
    let chart = |chart: &Chart| {
        let renamed: Vec<Value> =
            chart.renamed.iter().map(|(there, here)| json!({ "there": there, "here": here })).collect();
        let notes = chart.notes.iter().map(|note| {
            let line = source.text.get(..marked(&note.at, source).start).unwrap_or_default().matches('\n').count() + 1;
            json!({ "message": note.message, "bytes": [note.at.start, note.at.end], "line": line })
        });
        json!({ "name": chart.name, "renamed": renamed, "notes": notes.collect::<Vec<_>>() })
    };
    json!({ "rust": done.rust, "charts": done.charts.iter().map(chart).collect::<Vec<_>>(), "errors": errors })
}
