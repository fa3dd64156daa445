//! The flight recorder on the emulated board: the cell runs, the program panics in the middle and resets the board, the next start sends the record, and the host
//! shows from it what happened.

use std::io::Write as _;
use std::process::Stdio;

use crate::command::Result;
use crate::firmware;
use crate::project::cargo;

/// Builds the image, runs it in QEMU, reads the record, and compares it with what the board itself has shown.
///
/// # Errors
/// A toolchain or QEMU is missing, a build fails, or the record shows anything else than what happened.
pub(crate) fn run() -> Result {
    let shown = firmware::recorded()?;
    let (record, lines): (Vec<&str>, Vec<&str>) = shown.lines().partition(|line| line.starts_with("record "));
    let replayed = decoded(&record.join("\n"))?;
    let replayed: Vec<&str> = replayed.lines().collect();
    // The board could not show the cycle in which the program failed; the record has it.
    let Some((last, before)) = replayed.split_last().filter(|(_, before)| !before.is_empty()) else {
        return Err("the record holds no cycle before the last one".to_owned());
    };
    if before != lines {
        return Err(format!("the record shows\n{}\nand the board has shown\n{}", before.join("\n"), lines.join("\n")));
    }
    println!("record: {} cycles on the board equal those of the record", before.len());
    println!("record: and this is the cycle in which the program failed: {last}");
    Ok(())
}

fn decoded(record: &str) -> Result<String> {
    let mut command = cargo(&["run", "--quiet", "--package", "grafcet-record", "--example", "decode"]);
    let failed = |error: std::io::Error| format!("the decoder: {error}");
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().map_err(failed)?;
    if let Some(mut input) = child.stdin.take() {
        input.write_all(record.as_bytes()).map_err(failed)?;
    }
    let output = child.wait_with_output().map_err(failed)?;
    if !output.status.success() {
        return Err("the record could not be decoded".to_owned());
    }
    String::from_utf8(output.stdout).map_err(|error| error.to_string())
}
