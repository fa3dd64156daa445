//! What the flight recorder costs: instructions, flash and RAM of each example on both targets, and bytes of the record.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;
use std::time::Duration;

use crate::command::{Result, capture, capture_within, run as run_command, tool};
use crate::firmware::{EXAMPLES, EXAMPLES_CRATE, FOLDER};
use crate::image::Linker;
use crate::project::{self, cargo};
use crate::toolchain::BareMetal;

/// Cortex-M3 and Cortex-M0; the code of both runs on the emulated Cortex-M3.
const TARGETS: [&str; 2] = ["thumbv7m-none-eabi", "thumbv6m-none-eabi"];

/// The cycles of a count, as the program on the board runs them.
const CYCLES: u32 = 1000;

/// The most instructions that the recorder may take in a cycle without change on a Cortex-M3.
const GOAL: u32 = 40;

/// An image ends within seconds; one that has not by then hangs.
const LIMIT: Duration = Duration::from_secs(60);

const PAGE: &str = "docs/record.md";

/// An `sfc` of one region by time that keeps the reading of the clock for a recorder alone: with the feature on its image is another one.
const KEEPS_READING: [&str; 2] = ["stroke", "pick_and_place"];

/// The table in the page stands between this line and the next blank one.
const TABLE: &str = "| chart | quiet M3 | M0 |";

/// What the recorder adds to a chart on one target.
struct Cost {
    quiet: u32,
    changed: u32,
    /// As frames over a wire, each cycle changed.
    sent: u32,
    flash: u32,
    ram: u32,
}

/// Measures, writes the table of the page and compares with the goal.
///
/// # Errors
/// A toolchain or QEMU is missing, a build fails, images without the recorder are others with its feature, or the goal is missed.
pub(crate) fn run() -> Result {
    let [m3, m0] = [costs(TARGETS[0])?, costs(TARGETS[1])?];
    let mut table = format!(
        "{TABLE} change M3 | M0 | sent M3 | M0 | flash M3 | M0 | RAM |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
    );
    for ((name, m3), m0) in EXAMPLES.iter().zip(&m3).zip(&m0) {
        _ = writeln!(
            table,
            "| {name} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            m3.quiet, m0.quiet, m3.changed, m0.changed, m3.sent, m0.sent, m3.flash, m0.flash, m3.ram
        );
    }
    println!(
        "{table}\n{}",
        capture(&mut cargo(&["run", "--quiet", "--package", "grafcet-record", "--example", "bytes"]))?
    );
    write(&table)?;
    goal(&m3)
}

/// What CI asks: images without the recorder are those of before, and the goal is reached.
///
/// # Errors
/// As [`run`].
pub(crate) fn check() -> Result {
    goal(&costs(TARGETS[0])?)
}

fn goal(m3: &[Cost]) -> Result {
    match EXAMPLES.iter().zip(m3).find(|(_, cost)| cost.quiet > GOAL) {
        Some((name, cost)) => {
            Err(format!("{name}: {} instructions in a cycle without change, {GOAL} are the goal", cost.quiet))
        }
        None => {
            println!("record: at most {GOAL} instructions in a cycle without change");
            Ok(())
        }
    }
}

fn write(table: &str) -> Result {
    let path = project::root().join(PAGE);
    let text = fs::read_to_string(&path).map_err(|error| format!("{PAGE}: {error}"))?;
    let (before, rest) = text.split_once(TABLE).ok_or_else(|| format!("{PAGE} has no table `{TABLE}`"))?;
    let (_, after) = rest.split_once("\n\n").ok_or_else(|| format!("{PAGE}: nothing follows the table"))?;
    fs::write(&path, format!("{before}{table}\n{after}")).map_err(|error| format!("{PAGE}: {error}"))
}

/// Of each example.
fn costs(target: &str) -> Result<Vec<Cost>> {
    let toolchain = BareMetal::find(target)?;
    let folder = project::target(FOLDER).join(target).join("release");
    build(&toolchain, target, &["--lib", "--crate-type", "staticlib", "--features", "roots"])?;
    let library = folder.join("libgrafcet_firmware.a");
    let alone = EXAMPLES.iter().map(|name| code(&library, &root(name))).collect::<Result<Vec<_>>>()?;
    build(&toolchain, target, &["--lib", "--crate-type", "staticlib", "--features", "roots,record"])?;
    let linker = Linker::new(library.clone())?;
    let mut flash = Vec::new();
    for (name, alone) in EXAMPLES.iter().zip(&alone) {
        let differs = code(&library, &root(name))? != *alone;
        if differs != KEEPS_READING.contains(name) {
            let is = if differs { "another one" } else { "the same again" };
            return Err(format!("{target}: the image of {name} is {is} where the feature is on and not used"));
        }
        let bytes = linker.link(&format!("recorded_{name}"))?.flash()?;
        flash.push(bytes.saturating_sub(linker.link(&root(name))?.flash()?));
    }
    commands(&toolchain, target, &library)?;
    build(&toolchain, target, &["--bin", "record_cost", "--features", "record"])?;
    let mut qemu = Command::new(tool("qemu-system-arm", "qemu-system-arm")?);
    // Without counters of time, every instruction takes the same time.
    qemu.args(["-cpu", "cortex-m3", "-machine", "lm3s6965evb", "-nographic", "-icount", "shift=0"]);
    qemu.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(folder.join("record_cost"));
    let lines = capture_within(&mut qemu, LIMIT)?;
    let costs: Option<Vec<Cost>> = EXAMPLES
        .iter()
        .zip(flash)
        .map(|(name, flash)| counted(lines.lines().find_map(|line| line.strip_prefix(name))?, flash))
        .collect();
    costs.ok_or_else(|| format!("{target}: the board says\n{lines}"))
}

/// Images that record are the same where commands could be taken and are not; and what takes them cannot panic.
fn commands(toolchain: &BareMetal, target: &str, library: &std::path::Path) -> Result {
    let recorded = |name: &&str| code(library, &format!("recorded_{name}"));
    let before = EXAMPLES.iter().map(recorded).collect::<Result<Vec<_>>>()?;
    build(toolchain, target, &["--lib", "--crate-type", "staticlib", "--features", "roots,steer"])?;
    for (name, before) in EXAMPLES.iter().zip(before) {
        if recorded(name)? != before {
            return Err(format!(
                "{target}: the image that records {name} is another one where it could be steered and is not"
            ));
        }
    }
    let image = Linker::new(library.to_owned())?.link("steered_cell")?;
    match image.panics()? {
        Some(symbol) => Err(format!("{target}: what takes commands for the cell can panic: {symbol}")),
        None => {
            println!("record: what takes commands for the cell has {} bytes ({target}) and no panic", image.flash()?);
            Ok(())
        }
    }
}

/// The cycle alone.
fn root(name: &str) -> String {
    if name == "controller" { "alone_controller".to_owned() } else { format!("root_of_{name}") }
}

/// What the linker keeps of a root, byte by byte.
fn code(library: &std::path::Path, root: &str) -> Result<Vec<u8>> {
    Linker::new(library.to_owned())?.link(root)?.code()
}

fn counted(line: &str, flash: u32) -> Option<Cost> {
    let words: Vec<u32> = line.split_whitespace().map(|word| word.parse().ok()).collect::<Option<_>>()?;
    let [alone, recorded, alone_changed, recorded_changed, sent, ram] = words[..] else { return None };
    let more = |alone: u32, recorded: u32| (recorded.saturating_sub(alone) + CYCLES / 2) / CYCLES;
    let (quiet, changed) = (more(alone, recorded), more(alone_changed, recorded_changed));
    Some(Cost { quiet, changed, sent: more(alone_changed, sent), flash, ram })
}

fn build(toolchain: &BareMetal, target: &str, what: &[&str]) -> Result {
    let mut command = toolchain.cargo("rustc", target);
    command.args(["--quiet", "--release", "--manifest-path", EXAMPLES_CRATE]).args(what);
    run_command(command.arg("--target-dir").arg(project::target(FOLDER)))
}
