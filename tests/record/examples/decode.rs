//! Reads what the emulated board has sent (`record 4752…` lines on the standard input, or the frames of its serial line in a file) and shows what happened, in the form in which the board showed it
//! before it failed. `cargo xtask record` compares.

use std::io::Read as _;
use std::process::ExitCode;

use grafcet::heapless;
use grafcet::record::wire::{self, Follow, frame_len};
use grafcet::record::{Moment, Records, replay};
use grafcet_record::cell::{Cell, CellInputs, CellOutputs, CellStep};
use grafcet_record::script::{self, Notes};

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
    let starts = match std::env::args().nth(1) {
        None => vec![recorded()?],
        Some(file) => sent(&std::fs::read(&file).map_err(|error| format!("{file}: {error}"))?)?,
    };
    starts.iter().map(shown).collect()
}

/// What a record in memory shows.
fn recorded() -> Result<Start, String> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|error| error.to_string())?;
    let record = bytes(&text).ok_or("a line is no record")?;
    let records = Records::of(&record).map_err(|damage| format!("{damage:?}"))?;
    let mut start = Start::default();
    replay::<Cell>(&records, &mut (), |moment| start.see(&moment)).map_err(|error| format!("{error:?}"))?;
    Ok(start)
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
