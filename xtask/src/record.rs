//! The flight recorder on the emulated board: the cell runs, the program panics in the middle or hangs until its watchdog resets the board, the next start sends the record, and the host
//! shows from it, and from the frames of the serial line, what happened: as lines, and as a page.

use std::fs;
use std::io::Write as _;
use std::process::Stdio;

use crate::command::{Result, run as run_command};
use crate::firmware;
use crate::project::{self, Program, cargo};

/// How the program on the board fails, one after the other: each time it has begun, it shows this.
const FAILURES: [&str; 2] = ["# panic", "# watchdog"];

/// Builds the image, runs it in QEMU, reads the records and what came over the serial line, and compares both with what the board itself has shown.
///
/// # Errors
/// A toolchain or QEMU is missing, a build fails, or a record or the frames show anything else than what happened.
pub(crate) fn run() -> Result {
    let (shown, line) = firmware::recorded()?;
    let mut replayed = String::new();
    let mut rest = shown.as_str();
    for (index, failure) in FAILURES.iter().enumerate() {
        let begun = rest.split_once(&format!("{failure}\n")).ok_or_else(|| format!("no `{failure}`:\n{shown}"))?.1;
        let end = FAILURES.get(index + 1).and_then(|next| begun.find(next)).unwrap_or(begun.len());
        replayed.push_str(&one(failure, &begun[..end])?);
        rest = &begun[end..];
    }
    let sent = decoded("", &[&line.display().to_string()])?;
    if sent != replayed {
        return Err(format!("over the serial line came\n{sent}\nand the records show\n{replayed}"));
    }
    println!("record: the frames of the serial line show the same {} cycles, and both starts", sent.lines().count());
    Ok(())
}

/// One run of the program, which fails: what its record shows.
fn one(failure: &str, shown: &str) -> Result<String> {
    let (record, lines): (Vec<&str>, Vec<&str>) = shown.lines().partition(|line| line.starts_with("record "));
    let page = project::target("record").join(format!("{}.html", failure.trim_start_matches("# ")));
    fs::create_dir_all(project::target("record")).map_err(|error| format!("{}: {error}", page.display()))?;
    let all = decoded(&record.join("\n"), &["--page", &page.display().to_string()])?;
    let replayed: Vec<&str> = all.lines().collect();
    // The board could not show the cycle in which the program failed; the record has it.
    let Some((last, before)) = replayed.split_last().filter(|(_, before)| !before.is_empty()) else {
        return Err("the record holds no cycle before the last one".to_owned());
    };
    if before != lines {
        return Err(format!("the record shows\n{}\nand the board has shown\n{}", before.join("\n"), lines.join("\n")));
    }
    println!("{failure}: {} cycles on the board equal those of the record", before.len());
    println!("{failure}: and this is the cycle in which the program failed: {last}");
    println!("{failure}: the page {} shows all of them", page.display());
    Ok(all)
}

/// A test is made of a record.
///
/// # Errors
/// A file cannot be read, or is no record of this chart.
pub(crate) fn test(arguments: &[&str; 4]) -> Result {
    let program = ["run", "--quiet", "--package", "grafcet-sim", "--example", "record_test", "--"];
    run_command(cargo(&program).args(arguments))
}

fn decoded(record: &str, arguments: &[&str]) -> Result<String> {
    let mut command = Program::Example("decode").command()?;
    command.args(arguments);
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
