//! `cargo grafcet simulate`
//!
//! - `session`: the chart, what it is given and what it has done
//! - `screen`: what keys do to it
//! - `script`: sessions as lines of text
//! - `frame`: what it looks like
//! - `terminal`: the loop around these

mod frame;
mod screen;
pub(crate) mod script;
pub(crate) mod session;
mod terminal;
#[cfg(test)]
mod tests;

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args as Arguments;
use grafcet_sim::{Chart, Cycle, Trace, table};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use serde_json::Value as Json;

use crate::args::Charts;
use crate::find;
use crate::{Failure, Outcome, complain, cycle, replay, say};
use screen::Screen;
use session::Session;

/// The time from one cycle to the next where nobody says, in nanoseconds.
const STEP: u64 = 100_000_000;

/// Play with a chart in the terminal
///
/// The chart is drawn with its active steps. Each input has a key, which stands in front of its name: it turns a truth around, takes the next of a list of
/// variants, or asks for a number. Enter makes one cycle, Space lets the chart run, Backspace takes a cycle back, `+` and `-` change the time from one cycle
/// to the next, Ctrl-R makes a cycle that starts like a first one (Init), Ctrl-F asks for steps and makes a cycle into them by hand (of a chart that is `forceable;`), Ctrl-S saves the session as a script, Esc ends it. Parameters stand after the
/// inputs and are exchanged in the same way. Functions and constants of the program around the chart are inputs under their own text;
/// blocks of Rust that cannot be looked into write nothing.
#[derive(Arguments, Debug)]
#[command(after_help = "\
Examples:
  cargo grafcet simulate --chart Motor
  cargo grafcet simulate --chart Motor --save motor.script
  cargo grafcet simulate --chart Motor --script motor.script    without a terminal

Exit code 1 says that the chart has errors, or that a cycle of the script cannot be run.")]
pub(crate) struct Simulate {
    #[command(flatten)]
    pub(crate) charts: Charts,
    /// Run the cycles of this file without a terminal: one line a cycle with the inputs that are true
    #[arg(long, value_name = "FILE")]
    pub(crate) script: Option<PathBuf>,
    /// Where Ctrl-S saves the session, also where the file is there already; else in NAME.script, which must be new
    #[arg(long, value_name = "FILE", conflicts_with = "script")]
    pub(crate) save: Option<PathBuf>,
    /// The time from one cycle to the next at the beginning, in ticks of the chart's clock; else a tenth of a second
    #[arg(long, value_name = "TICKS", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) step: Option<u32>,
    /// With --script: one JSON object a cycle
    #[arg(long, requires = "script")]
    pub(crate) json: bool,
    /// With --script: what a terminal of this size shows after each cycle
    #[arg(long, requires = "script", conflicts_with = "json", value_name = "COLUMNSxROWS", value_parser = size)]
    pub(crate) frames: Option<(u16, u16)>,
}

/// `80x24`
fn size(text: &str) -> Result<(u16, u16), String> {
    let numbers = text.split_once('x').and_then(|(columns, rows)| Some((columns.parse().ok()?, rows.parse().ok()?)));
    let fits = numbers.filter(|(columns, rows)| (40..=1000).contains(columns) && (12..=1000).contains(rows));
    fits.ok_or_else(|| "columns and rows as in 80x24, from 40x12 on".to_owned())
}

pub(crate) fn run(options: &Simulate) -> Result<Outcome, Failure> {
    let found = find::one(&options.charts)?;
    let Some(chart) = replay::chart(&found) else { return Ok(Outcome::Wrong) };
    for block in chart.blocks() {
        complain(&format!("note: `{block}` is Rust that is not simulated: it writes nothing"));
    }
    let step = options.step.unwrap_or_else(|| step(&chart));
    let mut session = match Session::new(&chart, step) {
        Ok(session) => session,
        Err(error) => {
            complain(&format!("error: {} cannot be simulated: {error}", found.name));
            return Ok(Outcome::Wrong);
        }
    };
    match &options.script {
        Some(file) => scripted(&chart, &mut session, file, options),
        None => terminal::play(&mut session, options.save.as_deref()).map(|()| Outcome::Well),
    }
}

/// The time from one cycle to the next where nobody says, in ticks.
pub(crate) fn step(chart: &Chart) -> u32 {
    u32::try_from((STEP / chart.names().nanos_per_tick).max(1)).unwrap_or(u32::MAX)
}

/// Runs the cycles of a file and shows what they did.
fn scripted(chart: &Chart, session: &mut Session<'_>, file: &Path, options: &Simulate) -> Result<Outcome, Failure> {
    let text = fs::read_to_string(file).map_err(|error| Failure::file(file, &error))?;
    let cycles = script::read(session.signals(), &chart.names().params, &text)
        .map_err(|error| Failure::Said(format!("{}: {error}", file.display())))?;
    let mut trace = Trace::of(session.simulation());
    for (number, scripted) in cycles.iter().enumerate() {
        let cycle = match session.play(scripted) {
            Ok(cycle) => cycle.clone(),
            Err(error) => {
                complain(&format!("error: cycle {number} of {} cannot be run: {error}", file.display()));
                return Ok(Outcome::Wrong);
            }
        };
        if options.json {
            say(&format!("{}\n", object(session, &cycle)))?;
        }
        if let Some(size) = options.frames {
            say(&screen_of(session, size))?;
        }
        trace.cycles.push(cycle);
    }
    if !options.json && options.frames.is_none() {
        let simulation = session.simulation();
        say(&format!("{}\n{}\n{}\n", table(&trace), chart.text(&simulation.steps()), simulation.blocked()))?;
    }
    Ok(Outcome::Well)
}

/// What a terminal of so many columns and rows would show.
fn screen_of(session: &Session<'_>, (columns, rows): (u16, u16)) -> String {
    let screen = Screen::of(session);
    let mut terminal = Terminal::new(TestBackend::new(columns, rows)).unwrap_or_else(|never| match never {});
    terminal.draw(|frame| frame::draw(frame, session, &screen)).unwrap_or_else(|never| match never {});
    let buffer = terminal.backend().buffer();
    let lines = buffer.content.chunks(usize::from(columns).max(1));
    let line = |cells: &[ratatui::buffer::Cell]| cells.iter().map(ratatui::buffer::Cell::symbol).collect::<String>();
    lines.fold(String::new(), |all, cells| all + line(cells).trim_end() + "\n")
}

/// One cycle for a program.
fn object(session: &Session<'_>, cycle: &Cycle) -> Json {
    let names = session.names();
    let outside = &session.signals()[session.inputs()..];
    let mut object = cycle::object(names, session.script().len() - 1, cycle);
    object.insert("outside".to_owned(), cycle::values(outside, &session.values()[session.inputs()..]));
    object.insert("params".to_owned(), cycle::values(&names.params, &session.simulation().params()));
    object.into()
}
