//! `cargo grafcet diff`
//!
//! - `version`: files, and what git keeps of them
//! - `words`: a chart in words; `levels`: the levels of rules in it
//! - `renamed`: what is the same under another name
//! - `changes`: what is left
//! - `drawn`: both versions in one drawing

mod changes;
mod drawn;
mod levels;
mod renamed;
mod version;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args as Arguments;
use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::Model;
use grafcet_core::description::Description;
use grafcet_draw::Difference;
use serde_json::json;

use crate::find::{self, Found};
use crate::model::drawn as model_of;
use crate::output::Content;
#[cfg(feature = "print")]
use crate::print;
use crate::{Failure, Outcome, say};
use changes::Change;
use drawn::{Renamed, Version};
use words::Words;

/// Say what has changed from one version of a chart to another
///
/// Steps, transitions, conditions, actions, what is declared and claimed, and the order where it counts: which transition has priority. What has another name and is
/// otherwise the same is renamed. Blanks and comments do not count. Charts of two files belong together by their names; where there is one in each, these do.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet diff old/motor.rs src/motor.rs
  cargo grafcet diff HEAD~1:src/motor.rs src/motor.rs --draw
  cargo grafcet diff main: src/motor.rs
  cargo grafcet diff old.rs src/motor.rs -o changes.svg

Exit code 1 says that something has changed.")]
pub(crate) struct Diff {
    /// A file with the old version, or `REV:PATH` as git takes it; `REV:` is the other file there
    pub(crate) old: PathBuf,
    /// A file with the new version, or the same
    pub(crate) new: PathBuf,
    /// Only the charts of this name
    #[arg(long, value_name = "NAME")]
    pub(crate) chart: Option<String>,
    /// Draw both versions in one: what is new, gone, changed, or has another place in an order that counts is marked
    #[arg(long, conflicts_with = "json")]
    pub(crate) draw: bool,
    /// Write that drawing of the one chart to a file, with what has changed in words: SVG, PNG or text, by the end of its name
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// The widest text: what stands side by side stands one below the other where there is no room
    #[arg(long, value_name = "COLUMNS")]
    pub(crate) width: Option<u16>,
    /// One JSON object a change
    #[arg(long)]
    pub(crate) json: bool,
}

pub(crate) fn run(options: &Diff) -> Result<Outcome, Failure> {
    let of = |file: &Path, other: &Path| -> Result<Vec<Found>, Failure> {
        let mut charts = version::charts(file, other)?;
        charts.retain(|chart| options.chart.as_ref().is_none_or(|name| chart.name == *name));
        Ok(charts)
    };
    let (old, new) = (of(&options.old, &options.new)?, of(&options.new, &options.old)?);
    if options.output.is_some() {
        one_pair(&old, &new)?;
    }
    if let (true, true, Some(name)) = (old.is_empty(), new.is_empty(), &options.chart) {
        return Err(Failure::Said(format!("there is no chart `{name}` in either file")));
    }
    let mut differs = false;
    if let ([old], [new]) = (&old[..], &new[..]) {
        return Ok(Outcome::wrong_if(compared(old, new, options)?));
    }
    let is_in = |charts: &[Found], name: &str| charts.iter().any(|chart| chart.name == name);
    for chart in old.iter().filter(|chart| !is_in(&new, &chart.name)) {
        differs |= alone(chart, "is gone", options)?;
    }
    for chart in &new {
        differs |= match old.iter().find(|other| other.name == chart.name) {
            Some(other) => compared(other, chart, options)?,
            None => alone(chart, "is new", options)?,
        };
    }
    Ok(Outcome::wrong_if(differs))
}

/// A chart that only one file has.
fn alone(chart: &Found, what: &'static str, options: &Diff) -> Result<bool, Failure> {
    let sentence = format!("the chart {what}");
    let (old, new) = if what == "is new" { (None, Some(&chart.name)) } else { (Some(&chart.name), None) };
    let change = Change { kind: "chart", sentence, old: old.cloned(), new: new.cloned(), steps: Vec::new() };
    say(&shown(&chart.name, &[change], options))?;
    Ok(true)
}

/// Says how two versions differ, and whether they do.
fn compared(old: &Found, new: &Found, options: &Diff) -> Result<bool, Failure> {
    let model = |chart: &Found| {
        let wrong = || Failure::Said(format!("{}: the chart {} has mistakes", chart.source.path.display(), chart.name));
        model_of(chart).ok_or_else(wrong)
    };
    let (before, after) = (model(old)?, model(new)?);
    let (mut old, new) = (Words::of(&before, old), Words::of(&after, new));
    let mut changes: Vec<Change> = Vec::new();
    for (from, to) in renamed::renamed(&mut old, &new) {
        let is_step = new.steps.iter().any(|step| step.name == to);
        let kind = new.declared.iter().find(|one| one.name == to).map_or("step", |one| one.kind);
        let sentence = format!("the {kind} `{from}` is now called `{to}`");
        let steps = if is_step { vec![to.clone()] } else { Vec::new() };
        changes.push(Change { kind: "renamed", sentence, old: Some(from), new: Some(to), steps });
    }
    let renamed: Vec<String> = changes.iter().flat_map(|one| one.steps.clone()).collect();
    changes.extend(changes::changes(&old, &new));
    say(&shown(&new.name, &changes, options))?;
    if options.draw {
        let text = both((&before, &old), (&after, &new), &renamed, |chart, differences| {
            grafcet_draw::text_compared(chart, differences, &[], options.width)
        });
        say(&format!("\n{text}\n"))?;
    }
    if let Some(file) = &options.output {
        let notes: Vec<String> = changes.iter().map(|one| one.sentence.clone()).collect();
        let picture = both((&before, &old), (&after, &new), &renamed, |chart, differences| {
            picture(file, chart, differences, &notes, options.width)
        })?;
        fs::write(file, picture.bytes()).map_err(|error| Failure::file(file, &error))?;
    }
    Ok(!changes.is_empty())
}

fn shown(chart: &str, changes: &[Change], options: &Diff) -> String {
    if options.json {
        let object = |one: &Change| {
            let Change { kind, sentence, old, new, steps } = one;
            json!({ "chart": chart, "kind": kind, "sentence": sentence, "old": old, "new": new, "steps": steps })
        };
        return changes.iter().fold(String::new(), |all, one| all + &format!("{}\n", object(one)));
    }
    let count = match changes.len() {
        0 => "nothing has changed".to_owned(),
        1 => "1 change".to_owned(),
        count => format!("{count} changes"),
    };
    changes.iter().fold(format!("{chart}: {count}\n"), |all, one| all + &format!("  {}\n", one.sentence))
}

/// One file holds one chart.
fn one_pair(old: &[Found], new: &[Found]) -> Result<(), Failure> {
    if let ([_], [_]) = (old, new) {
        return Ok(());
    }
    let both = new.iter().filter(|chart| old.iter().any(|other| other.name == chart.name)).count();
    if both == 1 && new.len() == 1 {
        return Ok(());
    }
    let message = format!("{both} charts are in both files, and one goes to one file: {}", find::one_of(new));
    Err(Failure::Said(message))
}

/// The drawing of both versions, and what differs in it.
fn both<R>(
    old: (&Model, &Words),
    new: (&Model, &Words),
    renamed: Renamed<'_>,
    then: impl FnOnce(&Description<'_>, &[Difference]) -> R,
) -> R {
    with_description(old.0, |before| {
        with_description(new.0, |after| {
            let old = Version { chart: before, words: old.1 };
            drawn::with_both(old, Version { chart: after, words: new.1 }, renamed, then)
        })
    })
}

fn picture(
    file: &Path,
    chart: &Description<'_>,
    differences: &[Difference],
    notes: &[String],
    width: Option<u16>,
) -> Result<Content, Failure> {
    let svg = || grafcet_draw::svg_compared(chart, differences, notes);
    match file.extension().and_then(|end| end.to_str()) {
        Some("svg") => Ok(svg().into()),
        Some("txt") => Ok(grafcet_draw::text_compared(chart, differences, notes, width).into()),
        #[cfg(feature = "print")]
        Some("png") => Ok(Content::Bytes(print::png_of(chart.name, &svg(), 192)?)),
        _ => Err(Failure::Said(format!("{}: the drawing is written as .svg, .png or .txt", file.display()))),
    }
}
