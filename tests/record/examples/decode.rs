//! Reads what the emulated board has sent (`record 4752…` lines on the standard input, or the frames of its serial line in a file) and shows what happened, in the form in which the board showed it
//! before it failed. With `--page FILE` a record also becomes a page, from the chart's source alone. `cargo xtask record` compares.

use std::io::Read as _;
use std::process::ExitCode;

use grafcet::heapless;
use grafcet::record::wire::{self, Follow, frame_len};
use grafcet::record::{Moment, Records, replay};
use grafcet_record::cell::{Cell, CellInputs, CellOutputs, CellStep};
use grafcet_record::fuzz::{told, traced};
use grafcet_record::script::{self, Notes};
use grafcet_sim::{Chart, Replay, page};

fn main() -> ExitCode {
    match run() {
        Ok(shown) => {
            print!("{shown}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

type Seen = (CellInputs, CellOutputs, heapless::Vec<CellStep, 4>);

/// The cycles of one start of the board, one beside each line of the script.
#[derive(Default)]
struct Start(Vec<Seen>);

impl Start {
    fn see(&mut self, moment: &Moment<'_, Cell>) {
        // A cycle that was only counted shows what the one before it has shown.
        let now = (*moment.inputs, moment.outputs, moment.chart.active_steps());
        while self.0.len() < moment.cycle as usize {
            self.0.push(self.0.last().cloned().unwrap_or_else(|| now.clone()));
        }
        self.0.push(now);
    }
}

fn run() -> Result<String, String> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let starts = match words[..] {
        [] => vec![recorded(&standard_input()?)?],
        ["--page", file] => {
            let record = standard_input()?;
            let start = recorded(&record)?;
            std::fs::write(file, paged(&record, &start)?).map_err(|error| format!("{file}: {error}"))?;
            vec![start]
        }
        [file] => sent(&std::fs::read(file).map_err(|error| format!("{file}: {error}"))?)?,
        _ => return Err("decode [--page FILE] < LINES, or decode FRAMES".to_owned()),
    };
    starts.iter().map(shown).collect()
}

/// The record that stands in lines.
fn standard_input() -> Result<Vec<u8>, String> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|error| error.to_string())?;
    bytes(&text).ok_or_else(|| "a line is no record".to_owned())
}

/// What a record in memory shows.
fn recorded(record: &[u8]) -> Result<Start, String> {
    let records = Records::of(record).map_err(|damage| format!("{damage:?}"))?;
    let mut start = Start::default();
    replay::<Cell>(&records, &mut (), |moment| start.see(&moment)).map_err(|error| format!("{error:?}"))?;
    Ok(start)
}

/// The page of a record, which has to show what the compiled chart shows of it, up to the last cycle.
fn paged(record: &[u8], start: &Start) -> Result<String, String> {
    let source = include_str!("../../../examples/charts/cell.rs");
    let chart = Chart::in_file(source, "Cell").map_err(|refused| refused.to_string())?;
    let trace = Replay::new().run(&chart, record).map_err(|error| error.to_string())?;
    if let Some(warning) = trace.warnings.first() {
        return Err(warning.clone());
    }
    let mut number = 0;
    for (index, cycle) in trace.cycles.iter().enumerate() {
        number += cycle.skipped as usize;
        let (found, expected) =
            (traced(&trace, index), start.0.get(number).map(|(_, outputs, steps)| told(steps, outputs)));
        if expected.as_ref() != Some(&found) {
            return Err(format!("cycle {number} is {expected:?}, and on the page {found}"));
        }
        number += 1;
    }
    if number != start.0.len() {
        return Err(format!("the page ends after {number} cycles of {}", start.0.len()));
    }
    Ok(page(&chart, &trace))
}

/// What came over the serial line shows.
fn sent(bytes: &[u8]) -> Result<Vec<Start>, String> {
    let mut follow = Follow::<Cell, _>::new([0; frame_len::<Cell>()]);
    let (mut starts, mut trouble) = (Vec::new(), None);
    follow.bytes(bytes, &mut (), |seen| match seen {
        wire::Seen::Begins => starts.push(Start::default()),
        wire::Seen::Cycle(moment) => {
            if let Some(start) = starts.last_mut() {
                start.see(&moment);
            }
        }
        wire::Seen::Trouble(found) => trouble = Some(found),
    });
    match trouble {
        None => Ok(starts),
        Some(trouble) => Err(format!("the frames have a gap: {trouble:?}")),
    }
}

/// The lines in which the board shows the script.
fn shown(start: &Start) -> Result<String, String> {
    let moments = &start.0;
    let lines = include_str!("../../../examples/charts/cell.script").lines();
    let script: Vec<&str> = lines.filter(|line| !line.starts_with('#')).take(moments.len()).collect();
    let script = script.join("\n");
    let (mut shown, mut number) = (String::new(), 0);
    let mut other = None;
    let played = script::play(&script, &mut shown, |inputs: &CellInputs, _| {
        let (recorded, outputs, steps) = moments[number].clone();
        if *inputs != recorded {
            other.get_or_insert(number);
        }
        number += 1;
        (outputs, steps, Notes::new())
    });
    played.map_err(|error| error.to_string())?;
    match other {
        Some(number) => Err(format!("cycle {number} had other inputs than in the script")),
        None if number != moments.len() => Err(format!("{} cycles for {number} lines of the script", moments.len())),
        None => Ok(shown),
    }
}

fn bytes(text: &str) -> Option<Vec<u8>> {
    let digits: Vec<u8> = text.lines().filter_map(|line| line.strip_prefix("record ")).flat_map(str::bytes).collect();
    let byte = |pair: &[u8]| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok();
    digits.chunks(2).map(byte).collect()
}
