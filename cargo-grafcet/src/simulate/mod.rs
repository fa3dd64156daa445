//! `cargo grafcet simulate`
//!
//! - `session`: the chart, what it is given and what it has done
//! - `screen`: what keys do to it
//! - `frame`: what it looks like
//! - `terminal`: the loop around these

mod frame;
mod screen;
pub(crate) mod session;
mod terminal;
#[cfg(test)]
mod tests;

use std::fs;
use std::path::Path;

use grafcet_sim::{Chart, Cycle, Signal, Trace, Value, happened, script_of, table};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use serde_json::{Map, json};

use crate::args::Simulate;
use crate::find;
use crate::{Failure, Outcome, complain, replay, say};
use screen::Screen;
use session::Session;

/// The time from one cycle to the next where nobody says, in nanoseconds.
const STEP: u64 = 100_000_000;

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
    let cycles =
        script_of(session.signals(), &text).map_err(|error| Failure::Said(format!("{}: {error}", file.display())))?;
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
fn object(session: &Session<'_>, cycle: &Cycle) -> serde_json::Value {
    let names = session.names();
    let values = |signals: &[Signal], values: &[Value]| -> Map<String, serde_json::Value> {
        signals.iter().zip(values).map(|(signal, value)| (signal.name.clone(), json_of(value))).collect()
    };
    let (inputs, outside) = session.signals().split_at(session.inputs());
    let steps: Vec<&str> = cycle.steps.iter().map(|step| names.steps[*step].name.as_str()).collect();
    let waits: Vec<String> = cycle.blocked.waiting.iter().map(ToString::to_string).collect();
    json!({
        "cycle": session.script().len() - 1,
        "now": cycle.now,
        "inputs": values(inputs, &cycle.inputs),
        "outside": values(outside, &session.values()[inputs.len()..]),
        "steps": steps,
        "outputs": values(&names.outputs, &cycle.outputs),
        "variables": values(&names.variables, &cycle.variables),
        "happened": happened(names, cycle),
        "stable": cycle.is_stable,
        "waits": waits,
    })
}

fn json_of(value: &Value) -> serde_json::Value {
    match value {
        Value::Bool(value) => (*value).into(),
        Value::Int(value) => i64::try_from(*value).map_or_else(|_| value.to_string().into(), Into::into),
        Value::Float(value) => (*value).into(),
        Value::Ticks(value) => (*value).into(),
        Value::Name(name) => name.clone().into(),
        Value::Unknown => serde_json::Value::Null,
    }
}
