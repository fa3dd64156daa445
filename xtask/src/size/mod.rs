//! What generated charts cost on a controller, beside the same charts written by hand in Rust and in C.
//!
//! Three figures, exact and the same in every run: flash, the bytes of code and constants that the linker keeps for the
//! cycle function and all it needs, over an image with nothing in it; instructions per cycle, counted by the emulator,
//! `busy` on random inputs and `idle` with all inputs false; RAM, the size of the chart.

mod measure;
mod table;

use crate::command::Result;

/// Cortex-M3 and Cortex-M0; the code of both runs on the emulated Cortex-M3, whose instructions include those of the
/// other.
const TARGETS: [&str; 2] = ["thumbv7m-none-eabi", "thumbv6m-none-eabi"];

/// Who wrote the charts. The first is compared with the others.
const AUTHORS: [&str; 3] = ["generated", "hand", "c"];

/// Cycles per count, as the image in `benches` runs them.
const CYCLES: u32 = 4096;

/// A tick of the emulated timer is five instructions, and a count may be off by a tick at its start and its end.
const RESOLUTION: u32 = 10;

/// What one chart costs as one author wrote it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cost {
    /// Of the outputs on random inputs.
    hash: u32,
    /// Bytes.
    flash: u32,
    /// Instructions of [`CYCLES`] cycles on random inputs.
    busy: u32,
    /// Instructions of [`CYCLES`] cycles with all inputs false.
    idle: u32,
    /// Bytes.
    ram: u32,
}

/// One chart in one dialect, by all authors.
#[derive(Debug, PartialEq, Eq)]
struct Row {
    /// As in `seq16 grafcet`.
    name: String,
    costs: [Cost; AUTHORS.len()],
}

/// Measures all charts for all targets and prints a table for each.
///
/// # Errors
/// A tool is missing, a build fails, the authors' charts behave differently, or a figure of a generated chart exceeds
/// that of a hand-written one. There is no tolerance: the figures do not vary.
pub(crate) fn run() -> Result {
    let mut excess = Vec::new();
    for target in TARGETS {
        let rows = measure::all(target)?;
        check_equal(target, &rows)?;
        print!("{}", table::of(target, &rows));
        excess.extend(table::excess(&rows).into_iter().map(|what| format!("\n  {target}: {what}")));
    }
    match excess.len() {
        0 => Ok(()),
        count => {
            Err(format!("in {count} places generated charts cost more than hand-written ones:{}", excess.concat()))
        }
    }
}

/// The same work, or the comparison means nothing.
fn check_equal(target: &str, rows: &[Row]) -> Result {
    let differs = |row: &&Row| row.costs.iter().any(|cost| cost.hash != row.costs[0].hash);
    let different: Vec<&str> = rows.iter().filter(differs).map(|row| row.name.as_str()).collect();
    match different[..] {
        [] => Ok(()),
        _ => Err(format!("{target}: the outputs of the authors' charts differ: {}", different.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::{Cost, Row, check_equal};

    #[test]
    fn another_output_is_an_error() {
        let cost = Cost { hash: 1, flash: 1, busy: 1, idle: 1, ram: 1 };
        let mut row = Row { name: "motor sfc".to_owned(), costs: [cost; 3] };
        assert_eq!(check_equal("thumb", std::slice::from_ref(&row)), Ok(()));
        row.costs[2].hash = 2;
        let error = check_equal("thumb", &[row]);
        assert_eq!(error, Err("thumb: the outputs of the authors' charts differ: motor sfc".to_owned()));
    }
}
