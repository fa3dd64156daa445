//! `cargo grafcet coverage`

use std::fs;
use std::path::PathBuf;

use clap::Args as Arguments;
use serde_json::{Value, json};

use crate::args::Charts;
use crate::simulate::session::Session;
use crate::{Failure, Outcome, complain, find, replay, say, simulate};

/// Say what scripts and records have covered of a chart
///
/// Steps, transitions, and of each condition the parts that have decided as true and as false (masking MC/DC). A script has one line a cycle with the inputs
/// that are true.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet coverage --chart Motor --script motor.script
  cargo grafcet coverage --chart Motor --script a.script --script b.script --lcov motor.info

Exit code 1 says that something is not covered.")]
pub(crate) struct Coverage {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Cycles as lines; more than once for several
    #[arg(long, value_name = "FILE", required_unless_present = "record")]
    pub(crate) script: Vec<PathBuf>,
    /// A record of the flight recorder; more than once for several
    #[arg(long, value_name = "FILE")]
    pub(crate) record: Vec<PathBuf>,
    /// What need not be covered: the beginning of a line of the output; more than once for several
    #[arg(long, value_name = "WORDS")]
    pub(crate) except: Vec<String>,
    /// Write an LCOV file about the chart's source
    #[arg(long, value_name = "FILE")]
    pub(crate) lcov: Option<PathBuf>,
    /// One JSON object instead of lines
    #[arg(long)]
    pub(crate) json: bool,
}

pub(crate) fn run(options: &Coverage) -> Result<Outcome, Failure> {
    let found = find::one(&options.charts)?;
    let Some(chart) = replay::chart(&found) else { return Ok(Outcome::Wrong) };
    let mut covered = grafcet_sim::Coverage::of(&chart);
    for file in &options.script {
        let wrong = |error: &dyn std::fmt::Display| Failure::Said(format!("{}: {error}", file.display()));
        let text = fs::read_to_string(file).map_err(|error| Failure::file(file, &error))?;
        let mut session = Session::new(&chart, 1).map_err(|error| wrong(&error))?;
        for scripted in
            &simulate::script::read(session.signals(), &chart.names().params, &text).map_err(|error| wrong(&error))?
        {
            session.play(scripted).map_err(|error| wrong(&error))?;
        }
        covered.add(&session.simulation().coverage());
    }
    for file in &options.record {
        match replay::of_record(&chart, file, false)? {
            Ok(trace) => covered.add(&trace.coverage),
            Err(message) => {
                complain(&message);
                return Ok(Outcome::Wrong);
            }
        }
    }
    if let Some(file) = &options.lcov {
        let source = found.source.path.display().to_string();
        fs::write(file, covered.lcov(&source)).map_err(|error| Failure::file(file, &error))?;
    }
    let missing: Vec<String> = covered.missing().iter().map(ToString::to_string).collect();
    let is_excepted = |line: &&String| options.except.iter().any(|words| line.starts_with(words));
    let open: Vec<&String> = missing.iter().filter(|line| !is_excepted(line)).collect();
    if options.json {
        say(&format!("{}\n", object(&covered, &open)))?;
    } else {
        say(&covered.to_string())?;
    }
    Ok(Outcome::wrong_if(!open.is_empty()))
}

fn object(covered: &grafcet_sim::Coverage, open: &[&String]) -> Value {
    let count =
        |times: &[u64]| json!({ "covered": times.iter().filter(|times| **times > 0).count(), "all": times.len() });
    json!({ "steps": count(covered.entered()), "transitions": count(&covered.cleared()), "missing": open })
}
