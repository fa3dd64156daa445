//! `cargo grafcet replay`

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args as Arguments;
use grafcet_sim::{Chart, Trace, chronogram, page, table, vcd};
use serde_json::{Value as Json, json};

use crate::args::Charts;
use crate::find::{self, Found};
use crate::model::drawn;
use crate::time::duration;
use crate::{Failure, Outcome, complain, cycle, say};

/// Run a record of the flight recorder again, from the chart's source
///
/// It shows cycle by cycle what the chart did and what it waited for. What is missing or differs from the recorded states is a warning.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet replay cell.record src/cell.rs --chart Cell
  cargo grafcet replay cell.record --chart Cell --html cell.html
  cargo grafcet replay cell.record --chart Cell --at 75ms           the chart at this moment, in the terminal
  cargo grafcet replay cell.record --chart Cell --draw moments      a drawing of each moment: moments/Cell-04.svg
  cargo grafcet replay cell.record --chart Cell --json              for a program

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
    /// Draw the chart with its active steps, as SVG, for each cycle in which the situation has changed, to files in this folder that have the cycle's number
    #[arg(long, value_name = "FOLDER")]
    pub(crate) draw: Option<PathBuf>,
    /// Show the chart in place of the table, as it was at this time since the first cycle, as `75ms` or `1.5s`, or at the end of the cycle of this number; `--draw`
    /// writes this one alone
    #[arg(long, value_name = "MOMENT", value_parser = moment)]
    pub(crate) at: Option<Moment>,
    /// One JSON object a cycle instead of the table, or with `--at` that of the moment; warnings go to the error output
    #[arg(long)]
    pub(crate) json: bool,
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
    let at = options.at.map(|moment| moment.cycle(&chart, &trace)).transpose()?;
    match at {
        _ if options.json => objects(&trace, at)?,
        Some(cycle) => say(&chart.text(&trace.cycles[cycle].steps))?,
        None => say(&table(&trace))?,
    }
    if let Some(folder) = &options.draw {
        draw(&chart, &trace, at, folder)?;
    }
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

/// The cycles for a program, all or the one that is meant: as those of `simulate`, with what is not known of the time before them.
fn objects(trace: &Trace, at: Option<usize>) -> Result<(), Failure> {
    for warning in &trace.warnings {
        complain(&format!("warning: {warning}"));
    }
    for (number, cycle) in trace.cycles.iter().enumerate() {
        if at.is_none_or(|at| at == number) {
            let mut object = cycle::object(&trace.names, number, cycle);
            let gap = cycle.gap.as_ref().map(|gap| json!({ "reason": gap.reason, "cycles": gap.cycles }));
            object.insert("gap".to_owned(), json!(gap));
            object.insert("skipped".to_owned(), json!(cycle.skipped));
            say(&format!("{}\n", Json::from(object)))?;
        }
    }
    Ok(())
}

/// A moment of a record.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Moment {
    /// Since the first cycle.
    Time(Duration),
    Cycle(usize),
}

fn moment(text: &str) -> Result<Moment, String> {
    match text.parse() {
        Ok(cycle) => Ok(Moment::Cycle(cycle)),
        Err(_) => duration(text).map(Moment::Time),
    }
}

impl Moment {
    /// The last cycle that was over then.
    fn cycle(self, chart: &Chart, trace: &Trace) -> Result<usize, Failure> {
        let times = trace.times();
        let Some(last) = times.len().checked_sub(1) else {
            return Err(Failure::Said("there is no cycle in the record".to_owned()));
        };
        match self {
            Self::Cycle(cycle) if cycle <= last => Ok(cycle),
            Self::Cycle(cycle) => Err(Failure::Said(format!("there is no cycle {cycle}: the last one is {last}"))),
            Self::Time(time) => {
                let ticks = time.as_nanos() / u128::from(chart.model().clock_nanos);
                if ticks > u128::from(times[last]) {
                    let end = trace.names.time(times[last]);
                    return Err(Failure::Said(format!("the record ends {end} after its first cycle")));
                }
                Ok(times.iter().rposition(|start| u128::from(*start) <= ticks).unwrap_or(0))
            }
        }
    }
}

/// The cycle that is meant, or all whose situation is another than that of the one before, or was so meanwhile.
fn draw(chart: &Chart, trace: &Trace, at: Option<usize>, folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| Failure::file(folder, &error))?;
    let width = trace.cycles.len().saturating_sub(1).to_string().len();
    let mut before: Option<&[usize]> = None;
    for (number, cycle) in trace.cycles.iter().enumerate() {
        let is_new = cycle.gap.is_some() || !cycle.evolutions.is_empty() || before != Some(&cycle.steps[..]);
        before = Some(&cycle.steps);
        if at.map_or(is_new, |at| at == number) {
            let file = folder.join(format!("{}-{number:0width$}.svg", trace.names.chart));
            fs::write(&file, chart.svg(&cycle.steps)).map_err(|error| Failure::file(&file, &error))?;
        }
    }
    Ok(())
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

#[cfg(test)]
mod tests {
    use std::fs;

    use grafcet_sim::{Chart, Simulation, Trace, script};

    use super::draw;

    /// A cycle that leads back to where it began is a moment, too; one in which nothing clears is none.
    #[test]
    fn moments_of_a_record() {
        let source =
            "sfc Turn { input again, out: bool; initial step A; step B; A -[again]-> A; A -[out]-> B -[!out]-> A; }";
        let chart = Chart::parse(source).unwrap_or_else(|error| panic!("{error}"));
        let cycles = script(chart.names(), "-\n-\nagain\n-\nout\nout\n-").unwrap_or_else(|error| panic!("{error}"));
        let mut simulation = Simulation::new(&chart).unwrap_or_else(|error| panic!("{error}"));
        let trace = Trace::play(&mut simulation, &cycles).unwrap_or_else(|error| panic!("{error}"));
        let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
        draw(&chart, &trace, None, folder.path()).unwrap_or_else(|error| panic!("{error}"));
        let files = fs::read_dir(folder.path()).into_iter().flatten().flatten();
        let mut names: Vec<String> = files.map(|file| file.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        assert_eq!(names, ["Turn-0.svg", "Turn-2.svg", "Turn-4.svg", "Turn-6.svg"]);
    }
}
