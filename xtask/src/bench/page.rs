//! The page of costs, `docs/cost.md`.

use std::fmt::Write;
use std::fs;
use std::process::Command;

use super::Measured;
use super::builds::{CRATES, Times};
use super::goals::{self, Goal};
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
`-Os`, for Cortex-M3 (`thumbv7m-none-eabi`), Cortex-M0 (`thumbv6m-none-eabi`) and the host, of which only instructions are counted: its compilers are
those at hand, so it has no goals, and CI does not look at it. All authors of a chart give the same outputs on the same inputs wherever they run,
cycle by cycle: the run compares a hash of them. All evolve first and act then; smlang and statig take one transition per event, which is
what an `sfc` does, and have no parallel branches: Par8 is nine machines with code around them.

*ratio* is that to the best of the others; bold is more than that.
";

/// Writes the page.
pub(super) fn write(measured: &Measured, times: &Times, goals: &[Goal], compilers: &[String]) -> Result {
    let mut page = format!("{HEAD}\n{}\n", tools(compilers)?);
    _ = writeln!(page, "## Goals\n\n{}", goals::table(goals));
    for figure in FIGURES {
        _ = writeln!(page, "## {}\n\n{}", title(figure.name), table::of(figure, measured));
    }
    page += &builds(times);
    let file = root().join(FILE);
    fs::write(&file, page).map_err(|error| format!("{}: {error}", file.display()))
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
    let rustc = capture(Command::new("rustc").arg("--version"))?;
    let cc = first_line(tool("cc", "gcc")?)?;
    let valgrind = first_line(tool("valgrind", "valgrind")?)?;
    let host = format!("({}) {}, {cc}, {valgrind}", std::env::consts::ARCH, rustc.trim_end());
    let rivals = CRATES[1..].iter().map(|name| version(name)).collect::<Result<Vec<_>>>()?.join(", ");
    let (date, compilers) = (date.trim_end(), compilers.join(", "));
    Ok(format!("{date}: for the controllers {compilers}, {gcc}; on the host {host}; {qemu}; {rivals}.\n"))
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
    let mut text = "## Build\n\nSeconds of processor time of cargo and all it starts, the shortest of several in turns: they depend on the \
                    machine, their ratios less so.\n\n"
        .to_owned();
    _ = writeln!(text, "| | {} | {} | {} |\n| --- | --: | --: | --: |", CRATES[0], CRATES[1], CRATES[2]);
    let rows = [
        ("the macro and its dependencies, from nothing", &times.clean),
        ("`cargo check`, ring of 100 steps", &times.chain100),
        ("`cargo check`, ring of 1000 steps", &times.chain1000),
    ];
    for (what, [ours, smlang, statig]) in rows {
        _ = writeln!(text, "| {what} | {ours:.2} | {smlang:.2} | {statig:.2} |");
    }
    text
}
