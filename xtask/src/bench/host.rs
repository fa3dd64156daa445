//! Counts the instructions of the charts on the host with callgrind, which executes every instruction itself and counts it:
//! exactly, whatever else the machine does.
//!
//! Callgrind collects in one function of the program alone and dumps what it has collected whenever that has returned. One
//! run of the program is enough for all charts of an author, and a chart's instructions are what its cycles take more than as
//! many calls of what returns at once, as on the board.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use super::{COMPILER, CYCLES, Cost, Row, measure};
use crate::command::{Result, capture_within, run, tool};
use crate::{project, toolchain};

/// The function of the program in which callgrind collects.
const COUNTED: &str = "bench_counted";

/// So often that runs for each chart: busy cycles and what is around them, idle cycles and what is around them.
const COUNTS: usize = 4;

/// The file that callgrind writes.
const WRITTEN: &str = "callgrind.out";

/// A run takes a second; one that has not ended by then hangs.
const LIMIT: Duration = Duration::from_secs(120);

/// The charts as these authors wrote them; the first has all of them.
pub(super) fn all(authors: &[&'static str]) -> Result<Vec<Row>> {
    let valgrind = tool("valgrind", "valgrind")?;
    println!("bench: {} host, callgrind", std::env::consts::ARCH);
    measure::rows(authors, |author| costs(&valgrind, author))
}

/// Every chart of one author.
fn costs(valgrind: &Path, author: &str) -> Result<Vec<(String, Cost)>> {
    let folder = project::target("host");
    let (mut command, _) = toolchain::host(COMPILER, &["build", "--quiet", "--locked", "--release", "--bin", "count"])?;
    command.args(["--manifest-path", "benches/Cargo.toml", "--features", &measure::features(author)]);
    run(command.arg("--target-dir").arg(&folder))?;
    let mut command = Command::new(valgrind);
    command.args(["--tool=callgrind", "--quiet", "--combine-dumps=yes"]);
    command.arg(format!("--toggle-collect={COUNTED}")).arg(format!("--dump-after={COUNTED}"));
    // Callgrind takes a `%` in a path for a place holder.
    command.arg(format!("--callgrind-out-file={WRITTEN}")).current_dir(&folder);
    let lines = capture_within(command.arg(folder.join("release/count")), LIMIT)?;
    let file = folder.join(WRITTEN);
    let text = fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    of_charts(&lines, &totals(&text)?)
}

/// The costs of the charts that the program has named, of the counts in the same order.
fn of_charts(lines: &str, totals: &[u32]) -> Result<Vec<(String, Cost)>> {
    let charts = lines.lines().count();
    if charts == 0 || totals.len() != COUNTS * charts {
        return Err(format!("callgrind has counted {} times in {COUNTED}, for {charts} charts", totals.len()));
    }
    let charts = lines.lines().zip(totals.chunks_exact(COUNTS));
    charts
        .map(|(line, totals)| of_chart(line, totals).ok_or_else(|| format!("not counts: {line}, {totals:?}")))
        .collect()
}

/// Of a line as `motor sfc 811c9dc5`.
fn of_chart(line: &str, totals: &[u32]) -> Option<(String, Cost)> {
    let (name, hash) = line.rsplit_once(' ')?;
    let [busy, around_busy, idle, around_idle] = *totals else { return None };
    // What returns at once has done that once a cycle.
    let instructions = |all: u32, around| Some(all.checked_sub(around)? + CYCLES);
    let (busy, idle) = (instructions(busy, around_busy)?, instructions(idle, around_idle)?);
    Some((name.to_owned(), Cost { hash: u32::from_str_radix(hash, 16).ok()?, busy, idle, size: None }))
}

/// What callgrind has counted each time when the function has run; it adds a part with what is left at the end.
fn totals(text: &str) -> Result<Vec<u32>> {
    let trigger = format!("desc: Trigger: --dump-after={COUNTED}");
    let parts = text.split("\npart: ").filter(|part| part.lines().any(|line| line == trigger));
    let total = |part: &str| part.lines().find_map(|line| line.strip_prefix("totals: ")?.trim().parse().ok());
    parts
        .map(|part| total(part).ok_or_else(|| format!("callgrind has written a part without a total:\n{part}")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Cost, of_charts, totals};

    /// Two parts, and the rest.
    const TEXT: &str = "\
# callgrind format
version: 1
creator: callgrind-3.19.0
pid: 9113
cmd:  target/host/release/count
part: 1


desc: I1 cache: 
desc: Timerange: Basic block 0 - 103809
desc: Trigger: --dump-after=bench_counted

positions: line
events: Ir
summary: 92017


ob=(6) target/host/release/count
fl=(215) std/src/sys/backtrace.rs
fn=(1052) bench_counted
calls=4096 16 
250 92000
250 17

totals: 92017

part: 2

desc: Trigger: --dump-after=bench_counted

events: Ir
summary: 45241

totals: 45241

part: 3

desc: Trigger: Program termination

events: Ir
summary: 16801023

totals: 16801023
";

    #[test]
    fn parts_of_the_function_are_read() {
        assert_eq!(totals(TEXT), Ok(vec![92_017, 45_241]));
        assert_eq!(totals(""), Ok(vec![]));
        assert!(totals(&TEXT.replace("totals: 45241\n", "")).is_err());
    }

    #[test]
    fn a_chart_costs_what_is_not_around_it() {
        let cost = Cost { hash: 0x1470_1dc5, busy: 50_872, idle: 45_053, size: None };
        let counts = [92_017, 45_241, 86_198, 45_241];
        assert_eq!(of_charts("motor sfc 14701dc5\n", &counts), Ok(vec![("motor sfc".to_owned(), cost)]));
    }

    #[test]
    fn counts_belong_to_charts() {
        let counts = [92_017, 45_241, 86_198, 45_241];
        let other = of_charts("motor sfc 14701dc5\n", &counts[1..]).expect_err("one is missing");
        assert_eq!(other, "callgrind has counted 3 times in bench_counted, for 1 charts");
        assert!(of_charts("", &[]).is_err());
        assert!(of_charts("motor sfc\n", &counts).is_err());
        assert!(of_charts("motor sfc 14701dc5\n", &[1, 2, 3, 4]).is_err(), "less than what is around");
    }
}
