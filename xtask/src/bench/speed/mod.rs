//! `cargo xtask bench check`: how long the compiler takes, built as users' macros are.

mod charts;
mod large;

use std::fmt::Write;
use std::fs;
use std::time::Duration;

use self::charts::Chart;
use crate::command::{Result, capture, capture_within};
use crate::project::{cargo, root, target};

/// No chart may take that long; what does counts as running without end.
const LIMIT: Duration = Duration::from_secs(120);

/// The most memory a chart may take, in KiB.
const MEMORY: u64 = 500 * 1024;

/// Each chart is compiled so often; the shortest time counts, since other programs can only lengthen it.
const ROUNDS: usize = 3;

/// What compiling a chart took.
struct Cost {
    milliseconds: u64,
    /// KiB; 0 where the system does not tell.
    memory: u64,
    /// The rules that spoke.
    said: String,
}

/// Compiles charts of many kinds with a compiler in the dev profile (without optimisation), each in a process of its own,
/// and prints a table of times and memory beside what they may take.
///
/// # Errors
/// The compiler does not build, a chart takes more than [`LIMIT`], or is refused where it should not be. That a time is
/// exceeded is only shown: times depend on the machine.
pub(crate) fn check(only: Option<&str>) -> Result {
    let folder = target("bench");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let build = ["build", "--package", "grafcet-compiler", "--example", "compile_time", "--target-dir"];
    capture(cargo(&build).arg(&folder))?;
    let program = folder.join("debug/examples/compile_time");
    println!("{:44} {:>8} {:>8} {:>8}  ", "chart", "time ms", "limit", "MiB");
    let (mut refused, mut times) = (String::new(), Vec::new());
    let charts = charts::all(&root())?;
    for chart in charts.iter().filter(|chart| only.is_none_or(|only| chart.name.contains(only))) {
        let file = folder.join(format!("{}.txt", chart.name.replace(' ', "_").replace(',', "")));
        fs::write(&file, &chart.text).map_err(|error| format!("{}: {error}", file.display()))?;
        let mut best: Option<Cost> = None;
        for _ in 0..ROUNDS {
            let cost = read(&capture_within(std::process::Command::new(&program).arg(&file), LIMIT)?)?;
            let worse = cost.milliseconds > 2000;
            if best.as_ref().is_none_or(|best| cost.milliseconds < best.milliseconds) {
                best = Some(cost);
            }
            if worse {
                break;
            }
        }
        let Some(cost) = best else { continue };
        println!("{}", row(chart, &cost));
        if cost.said != chart.says {
            _ = write!(refused, "\n  {}: {} speaks, expected was {}", chart.name, cost.said, chart.says);
        }
        times.push((chart.name.clone(), cost.milliseconds));
    }
    growth(&times);
    if refused.is_empty() { Ok(()) } else { Err(format!("other messages than expected:{refused}")) }
}

fn read(line: &str) -> Result<Cost> {
    let words: Vec<&str> = line.split_whitespace().collect();
    match words[..] {
        [milliseconds, memory, said] => {
            let number = |word: &str| word.parse().map_err(|_| format!("not a number: {word}"));
            Ok(Cost { milliseconds: number(milliseconds)?, memory: number(memory)?, said: said.to_owned() })
        }
        _ => Err(format!("not a measurement: {line}")),
    }
}

fn row(chart: &Chart, cost: &Cost) -> String {
    let limit = chart.limit.map_or_else(|| "-".to_owned(), |limit| limit.to_string());
    let exceeded = chart.limit.is_some_and(|limit| cost.milliseconds >= limit) || cost.memory >= MEMORY;
    let verdict = if exceeded { "EXCEEDED" } else { "" };
    let (name, time, memory) = (&chart.name, cost.milliseconds, cost.memory / 1024);
    format!("{name:44} {time:8} {limit:>8} {memory:8}  {verdict}{}", said(&cost.said)).trim_end().to_owned()
}

fn said(said: &str) -> String {
    if said == "-" { String::new() } else { format!(" {said}") }
}

/// How the time grows from the sequence of 1,000 steps to that of 10,000: 10 is linear.
fn growth(times: &[(String, u64)]) {
    for dialect in ["sfc", "grafcet"] {
        let of = |steps: &str| {
            let name = format!("sequence of {steps} steps, {dialect}");
            times.iter().find(|(other, _)| *other == name).map(|(_, time)| *time)
        };
        if let (Some(short), Some(long)) = (of("1000"), of("10000")) {
            let tenths = long * 10 / short.max(1);
            println!("10,000 over 1,000 steps, {dialect}: {}.{} times", tenths / 10, tenths % 10);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn a_line_of_the_compiler_is_read() {
        let cost = read("12 3400 unsafe_step,deadlock\n").expect("a measurement");
        assert_eq!((cost.milliseconds, cost.memory, &cost.said[..]), (12, 3400, "unsafe_step,deadlock"));
        assert!(read("12 3400").is_err());
        assert!(read("a 3400 -").is_err());
    }
}
