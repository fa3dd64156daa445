//! `cargo grafcet replay`

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args as Arguments;
use grafcet_sim::{Chart, Trace, chronogram, page, table, vcd};

use crate::args::Charts;
use crate::find::{self, Found};
use crate::model::drawn;
use crate::{Failure, Outcome, complain, say};

/// Run a record of the flight recorder again, from the chart's source
///
/// It shows cycle by cycle what the chart did and what it waited for. What is missing or differs from the recorded states is a warning.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet replay cell.record src/cell.rs --chart Cell
  cargo grafcet replay cell.record --chart Cell --html cell.html

Exit code 1 says that there are warnings, or that the record cannot be run.")]
pub(crate) struct Replay {
    /// The memory of a recorder, or what it has sent over a wire
    pub(crate) record: PathBuf,
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Write a page with the chart and the chronogram to step through
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    /// Write a waveform (VCD)
    #[arg(long, value_name = "FILE")]
    pub(crate) vcd: Option<PathBuf>,
    /// Write a chronogram (SVG)
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Also a record of another version of the chart, with the same inputs and parameters
    #[arg(long)]
    pub(crate) even_if_changed: bool,
}

pub(crate) fn run(options: &Replay) -> Result<Outcome, Failure> {
    let found = find::one(&options.charts)?;
    let Some(chart) = chart(&found) else { return Ok(Outcome::Wrong) };
    let trace = match of_record(&chart, &options.record, options.even_if_changed)? {
        Ok(trace) => trace,
        Err(message) => {
            complain(&message);
            return Ok(Outcome::Wrong);
        }
    };
    say(&table(&trace))?;
    let write = |file: &Path, text: String| fs::write(file, text).map_err(|error| Failure::file(file, &error));
    if let Some(file) = &options.html {
        write(file, page(&chart, &trace))?;
    }
    if let Some(file) = &options.svg {
        write(file, chronogram(&trace))?;
    }
    if let Some(file) = &options.vcd {
        let out = fs::File::create(file).map_err(|error| Failure::file(file, &error))?;
        vcd(&trace, std::io::BufWriter::new(out)).map_err(|error| Failure::file(file, &error))?;
    }
    Ok(Outcome::wrong_if(!trace.warnings.is_empty()))
}

/// A chart that can be run; what is wrong with it is said.
pub(crate) fn chart(found: &Found) -> Option<Chart> {
    drawn(found)?;
    match Chart::of_tokens(found.tokens.clone()) {
        Ok(chart) => Some(chart),
        Err(refused) => {
            complain(&format!("error: {}: {refused}", found.name));
            None
        }
    }
}

/// What a record shows, or why it shows nothing.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn of_record(chart: &Chart, file: &Path, even_if_changed: bool) -> Result<Result<Trace, String>, Failure> {
    let bytes = fs::read(file).map_err(|error| Failure::file(file, &error))?;
    let mut replay = grafcet_sim::Replay::new();
    if even_if_changed {
        replay = replay.even_if_changed();
    }
    Ok(replay.run_any(chart, &bytes).map_err(|error| format!("error: {}: {error}", file.display())))
}
