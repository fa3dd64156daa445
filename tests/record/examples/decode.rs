//! Reads what the emulated board has sent (`record 4752…` lines on the standard input) and shows what happened, in the form in which the board showed it
//! before it failed. `cargo xtask record` compares.

use std::io::Read as _;
use std::process::ExitCode;

use grafcet::record::{Records, replay};
use grafcet_record::cell::{Cell, CellInputs};
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

fn run() -> Result<String, String> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).map_err(|error| error.to_string())?;
    let record = bytes(&text).ok_or("a line is no record")?;
    let records = Records::of(&record).map_err(|damage| format!("{damage:?}"))?;
    let mut moments = Vec::new();
    let replayed = replay::<Cell>(&records, &mut (), |moment| {
        // A cycle that was only counted shows what the one before it has shown.
        let now = (*moment.inputs, moment.outputs, moment.chart.active_steps());
        while moments.len() < moment.cycle as usize {
            moments.push(moments.last().cloned().unwrap_or_else(|| now.clone()));
        }
        moments.push(now);
    });
    replayed.map_err(|error| format!("{error:?}"))?;
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
