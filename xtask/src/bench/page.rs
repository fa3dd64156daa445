//! The page of costs, `docs/cost.md`.

use std::fmt::Write;
use std::fs;
use std::process::Command;

use super::Measured;
use super::builds::{CRATES, Compilation, Times};
use super::goals;
use super::table::{self, FIGURES};
use crate::command::{Result, capture, tool};
use crate::project::root;

const FILE: &str = "docs/cost.md";

const HEAD: &str = "\
# What a chart costs

Written by `cargo xtask bench`, which measures everything in one run. The charts, and who wrote them how, are in `benches/`.

- **flash**: bytes of code and constants that the linker keeps for the cycle function and all it needs, over an empty image
- **instructions**: per cycle, counted on the controllers by the emulator (QEMU, `-icount shift=0`), on the host by callgrind; busy on random
  inputs, idle with all inputs false
- **RAM**: bytes of the chart's state

All are exact and the same in every run, apart from statig's: its code differs from build to build. Compiled at `opt-level = \"s\"` with LTO, C at
`-Os`, for Cortex-M3 (`thumbv7m-none-eabi`), Cortex-M0 (`thumbv6m-none-eabi`) and the host, of which only instructions are counted: it has no goals,
and CI does not look at it. All rows are of one version of rustc, whatever else is installed. All authors of a chart give the same outputs on the same inputs wherever they run,
cycle by cycle: the run compares a hash of them, of inputs that change in every cycle and of the same held for 6.4 s. All evolve first and act then; smlang and statig take one
transition per event, which is what an `sfc` does, and have no parallel branches: Par8 is nine machines with code around them. Who writes times by hand keeps the reading at
which a step was entered, and says where it matters that the counter wraps; generated charts have no such limit: a step may stay active for any length of time. They ask
for a cycle in every 2^31 ticks (24.8 days in milliseconds), as most of the others do.

*ratio* is that to the best of the others; bold is more than that. *tables* is for orientation and no rival: C whose steps are rows of a table of byte numbers, for charts that
follow a rule. It takes a pointer cast over the records of the signals (`((const bool *)inputs)[row.input]`), which safe Rust does not have, and the same kind of condition in all steps.
";

/// Where the build times begin, which are measured apart.
const BUILD: &str = "## Build\n";

/// Writes the page but for the build times, which stay as they are.
pub(super) fn write(measured: &Measured, compilers: &[String]) -> Result {
    let mut page = format!("{HEAD}\n{}\n", tools(compilers)?);
    _ = writeln!(page, "## Goals\n\n{}", goals::table(&goals::of_costs(&measured.boards)));
    for figure in FIGURES {
        _ = writeln!(page, "## {}\n\n{}", title(figure.name), table::of(figure, measured));
    }
    let old = read()?;
    write_text(&(page + old.find(BUILD).map_or("", |start| &old[start..])))
}

/// Writes the build times anew, and their goals.
pub(super) fn write_builds(times: &Times) -> Result {
    let old = read()?;
    let before = old.find(BUILD).map_or(&old[..], |start| &old[..start]);
    write_text(&format!("{before}{}\n{}", builds(times), goals::table(&goals::of_builds(times))))
}

fn read() -> Result<String> {
    fs::read_to_string(root().join(FILE)).map_err(|error| format!("{FILE}: {error}"))
}

fn write_text(page: &str) -> Result {
    fs::write(root().join(FILE), page).map_err(|error| format!("{FILE}: {error}"))
}

fn title(figure: &str) -> String {
    let mut letters = figure.chars();
    letters.next().map(|first| first.to_uppercase().collect::<String>() + letters.as_str()).unwrap_or_default()
}

/// The date and the versions of all tools.
fn tools(compilers: &[String]) -> Result<String> {
    let date = capture(Command::new("date").args(["--utc", "+%Y-%m-%d"]))?;
    let gcc = first_line(tool("arm-none-eabi-gcc", "gcc-arm-none-eabi")?)?;
    let qemu = first_line(tool("qemu-system-arm", "qemu-system-arm")?)?;
    let mut compilers = compilers.to_owned();
    compilers.dedup();
    let cc = first_line(tool("cc", "gcc")?)?;
    let valgrind = first_line(tool("valgrind", "valgrind")?)?;
    let host = format!("({}) {cc}, {valgrind}", std::env::consts::ARCH);
    let rivals = CRATES[1..].iter().map(|name| version(name)).collect::<Result<Vec<_>>>()?.join(", ");
    let (date, compilers) = (date.trim_end(), compilers.join(", "));
    Ok(format!("{date}: {compilers}; for the controllers {gcc}, {qemu}; on the host {host}; {rivals}.\n"))
}

fn first_line(program: std::path::PathBuf) -> Result<String> {
    let text = capture(Command::new(program).arg("--version"))?;
    Ok(text.lines().next().unwrap_or_default().to_owned())
}

/// `smlang 0.8.0`, from the lock file of the benches.
fn version(name: &str) -> Result<String> {
    let lock = root().join("benches/Cargo.lock");
    let text = fs::read_to_string(&lock).map_err(|error| format!("{}: {error}", lock.display()))?;
    let version =
        text.split_once(&format!("name = \"{name}\"\nversion = \"")).and_then(|(_, rest)| rest.split_once('"'));
    version.map(|(version, _)| format!("{name} {version}")).ok_or_else(|| format!("{} has no {name}", lock.display()))
}

fn builds(times: &Times) -> String {
    let mut text = "## Build\n\nMeasured by `cargo xtask bench builds`. Seconds of processor time of cargo and all it starts, the shortest of several in turns: they depend on the \
                    machine, their ratios less so.\n\n"
        .to_owned();
    _ = writeln!(text, "| | {} | {} | {} | of statig's |", CRATES[0], CRATES[1], CRATES[2]);
    text += "| --- | --: | --: | --: | --: |\n";
    let rows = [
        ("the macro and its dependencies, from nothing", &times.clean),
        ("`cargo check`, 100 small charts, after an edit", &times.small),
        ("`cargo check`, ring of 100 steps", &times.chain100),
        ("`cargo check`, ring of 1000 steps", &times.chain1000),
    ];
    for (what, [ours, smlang, statig]) in rows {
        _ = writeln!(text, "| {what} | {ours:.2} | {smlang:.2} | {statig:.2} | {:.2} |", ours / statig);
    }
    let Compilation { seconds, mebibytes } = times.long;
    _ = writeln!(text, "\nrustc takes {seconds:.2} s and {mebibytes:.0} MiB for a ring of 5000 steps.");
    text
}
