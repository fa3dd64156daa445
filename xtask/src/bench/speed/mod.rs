//! `cargo xtask bench check`: how long the compiler takes, built as users' macros are.

mod charts;
mod large;

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;
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

/// Milliseconds: what takes longer is compiled once.
const LONG: u64 = 10_000;

/// What compiling a chart took.
struct Cost {
    milliseconds: u64,
    /// KiB; 0 where the system does not tell.
    memory: u64,
    /// The rules that spoke.
    said: String,
}

/// What the others are measured by.
const MEASURE: &str = "sequence of 1000 steps, sfc";

/// How much longer than [`MEASURE`] these may take, in hundredths: about half as much again as they took when that was written.
const WATCHED: [(&str, u64); 8] = [
    ("nested, 1000 steps, sfc", 500),
    ("nested, 1000 steps, grafcet", 500),
    ("20 branches, times, edges, variables, sfc", 200),
    ("30 macro-steps", 90),
    ("3 parallel branches of 333 steps, sfc", 500),
    ("3 parallel branches of 333 steps, grafcet", 600),
    ("100 partial grafcets of 10 steps", 500),
    ("machining cell", 150),
];

/// Compiles charts of many kinds with a compiler in the dev profile (without optimisation), each in a process of its own,
/// and prints a table of times and memory beside what they may take.
///
/// # Errors
/// The compiler does not build, a chart takes more than [`LIMIT`], or is refused where it should not be. That a time is
/// exceeded is only shown: times depend on the machine.
pub(crate) fn check(only: Option<&str>) -> Result {
    let compiler = Compiler::build()?;
    println!("{:44} {:>8} {:>8} {:>8}  ", "chart", "time ms", "limit", "MiB");
    let (mut refused, mut times) = (String::new(), Vec::new());
    let charts = charts::all(&root())?;
    for chart in charts.iter().filter(|chart| only.is_none_or(|only| chart.name.contains(only))) {
        let cost = compiler.least(chart)?;
        println!("{}", row(chart, &cost));
        if cost.said != chart.says {
            _ = write!(refused, "\n  {}: {} speaks, expected was {}", chart.name, cost.said, chart.says);
        }
        times.push((chart.name.clone(), cost.milliseconds));
    }
    growth(&times);
    if refused.is_empty() { Ok(()) } else { Err(format!("other messages than expected:{refused}")) }
}

/// Compares what some charts take with what a ring takes in the same run.
///
/// # Errors
/// As [`check`]; or a chart takes longer beside the ring than it may.
pub(crate) fn pinned() -> Result {
    let compiler = Compiler::build()?;
    let charts = charts::all(&root())?;
    let least = |name: &str| {
        let chart =
            charts.iter().find(|chart| chart.name == name).ok_or_else(|| format!("there is no chart {name}"))?;
        Ok::<u64, String>(compiler.least(chart)?.milliseconds)
    };
    let measure = least(MEASURE)?;
    let mut slow = String::new();
    for (name, most) in WATCHED {
        let hundredths = 100 * least(name)? / measure.max(1);
        println!("bench: {name}: {hundredths} hundredths of {MEASURE}, at most {most}");
        if hundredths > most {
            _ = write!(slow, "\n  {name} takes {hundredths} hundredths of {MEASURE}, at most {most}");
        }
    }
    if slow.is_empty() { Ok(()) } else { Err(format!("the macro has become slow:{slow}")) }
}

/// The compiler of charts without optimisation, as a program.
struct Compiler {
    folder: PathBuf,
}

impl Compiler {
    fn build() -> Result<Self> {
        let folder = target("bench");
        fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        let build = ["build", "--package", "grafcet-compiler", "--example", "compile_time", "--target-dir"];
        capture(cargo(&build).arg(&folder))?;
        Ok(Self { folder })
    }

    /// The shortest of several runs; one that takes long is not repeated.
    fn least(&self, chart: &Chart) -> Result<Cost> {
        let file = self.folder.join(format!("{}.txt", chart.name.replace(' ', "_").replace(',', "")));
        fs::write(&file, &chart.text).map_err(|error| format!("{}: {error}", file.display()))?;
        let program = self.folder.join("debug/examples/compile_time");
        let run = || read(&capture_within(std::process::Command::new(&program).arg(&file), LIMIT)?);
        let mut best = run()?;
        for _ in 1..ROUNDS {
            if best.milliseconds > LONG {
                break;
            }
            let cost = run()?;
            if cost.milliseconds < best.milliseconds {
                best = cost;
            }
        }
        Ok(best)
    }
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
    use super::{MEASURE, WATCHED, charts, read};
    use crate::project::root;

    #[test]
    fn what_is_watched_is_there() {
        let charts = charts::all(&root()).expect("charts");
        for name in WATCHED.iter().map(|(name, _)| *name).chain([MEASURE]) {
            assert!(charts.iter().any(|chart| chart.name == name), "{name}");
        }
    }

    #[test]
    fn a_line_of_the_compiler_is_read() {
        let cost = read("12 3400 unsafe_step,deadlock\n").expect("a measurement");
        assert_eq!((cost.milliseconds, cost.memory, &cost.said[..]), (12, 3400, "unsafe_step,deadlock"));
        assert!(read("12 3400").is_err());
        assert!(read("a 3400 -").is_err());
    }
}
