//! `cargo grafcet diff`
//!
//! - `words`: a chart in words; `levels`: the levels of rules in it
//! - `renamed`: what is the same under another name
//! - `changes`: what is left

mod changes;
mod levels;
mod renamed;
mod words;

use std::path::PathBuf;

use clap::Args as Arguments;
use grafcet_compiler::describe::with_description;
use grafcet_compiler::model::Model;
use serde_json::json;

use crate::find::{self, Found};
use crate::model::drawn;
use crate::{Failure, Outcome, say};
use changes::Change;
use words::Words;

/// Say what has changed from one version of a chart to another
///
/// Steps, transitions, conditions, actions, what is declared and claimed, and the order where it counts: which transition has priority. What has another name and is
/// otherwise the same is renamed. Blanks and comments do not count. Charts of two files belong together by their names; where there is one in each, these do.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet diff old/motor.rs src/motor.rs
  git show HEAD~1:src/motor.rs > old.rs; cargo grafcet diff old.rs src/motor.rs --draw

Exit code 1 says that something has changed.")]
pub(crate) struct Diff {
    /// A file with the old version
    pub(crate) old: PathBuf,
    /// A file with the new version
    pub(crate) new: PathBuf,
    /// Only the charts of this name
    #[arg(long, value_name = "NAME")]
    pub(crate) chart: Option<String>,
    /// Draw the new version; a dot marks the steps with which something has changed
    #[arg(long, conflicts_with = "json")]
    pub(crate) draw: bool,
    /// One JSON object a change
    #[arg(long)]
    pub(crate) json: bool,
}

pub(crate) fn run(options: &Diff) -> Result<Outcome, Failure> {
    let of = |file| -> Result<Vec<Found>, Failure> {
        let mut charts = find::of_files(std::slice::from_ref(file))?;
        charts.retain(|chart| options.chart.as_ref().is_none_or(|name| chart.name == *name));
        Ok(charts)
    };
    let (old, new) = (of(&options.old)?, of(&options.new)?);
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
        drawn(chart).ok_or_else(wrong)
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
    changes.extend(changes::changes(&old, &new));
    say(&shown(&new.name, &changes, options))?;
    if options.draw {
        say(&format!("\n{}\n", drawing(&after, &changes)))?;
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

/// The new version, with a mark at each step that a change is about.
fn drawing(model: &Model, changes: &[Change]) -> String {
    with_description(model, |chart| {
        let is_marked = |name: &str| changes.iter().any(|one| one.steps.iter().any(|step| step == name));
        let marked = (0..chart.steps.len()).map(|step| is_marked(&words::step_name(chart, step))).collect();
        grafcet_draw::text(chart, &Marked(marked))
    })
}

/// The steps that are marked, by number.
struct Marked(Vec<bool>);

impl grafcet_core::ActiveSteps for Marked {
    fn is_active_at(&self, step: usize) -> bool {
        self.0[step]
    }
}
