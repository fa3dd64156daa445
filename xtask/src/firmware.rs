//! The example charts on bare metal: built or checked for every target, run on an emulated board, compared with the host.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use crate::command::{Result, capture, capture_within, run as run_command, tool};
use crate::image::Linker;
use crate::project::{self, Program};
use crate::toolchain::BareMetal;

/// The target of the emulated board.
const BOARD: &str = "thumbv7m-none-eabi";

/// The folder of the build results of all that is built for controllers. Their profiles are the same, so that `core` and the
/// compiler of charts, which all of them need, are built once.
pub(crate) const FOLDER: &str = "firmware";

/// The manifest of the examples for the board.
pub(crate) const EXAMPLES_CRATE: &str = "examples/firmware/Cargo.toml";

/// The same of the charts as tasks of RTIC and Embassy.
const RTIC_CRATE: &str = "examples/rtic/Cargo.toml";
const EMBASSY_CRATE: &str = "examples/embassy/Cargo.toml";

/// The programs that live from interrupts and have no counterpart on the host, with their folder, how a reader starts them there, and
/// what they print.
const PROGRAMS: [(&str, &str, &str, &str); 3] = [
    (
        "messages",
        "examples/firmware",
        "cargo run --release --bin messages",
        include_str!("../../tests/examples/messages.expected"),
    ),
    ("staircase-rtic", "examples/rtic", "cargo run --release", include_str!("../../tests/examples/staircase.expected")),
    (
        "staircase-embassy",
        "examples/embassy",
        "cargo run --release",
        include_str!("../../tests/examples/staircase.expected"),
    ),
];

/// Where the runner of the board stands for all that has none of its own.
const RUNNER: &str = "examples/firmware";

/// The manifest of the conformance corpus for the board, and its images: as one it would not fit into the board's flash.
const CORPUS: (&str, [&str; 2]) = ("tests/conformance/board/Cargo.toml", ["first_half", "second_half"]);

/// The target with the fewest instructions: linked, it shows that nothing is missing there.
const LINKED: &str = "thumbv6m-none-eabi";

/// The targets for which the code is checked, with what of the crate: the image is for Cortex-M. They have what the others have.
const CHECKED: [(&str, &str); 2] = [("thumbv7em-none-eabihf", "--bins"), ("riscv32imc-unknown-none-elf", "--lib")];

/// The name of the image that plays the scripts.
const IMAGE: &str = "lm3s6965evb";

/// The examples in the order in which the firmware plays their scripts.
pub(crate) const EXAMPLES: [&str; 9] =
    ["motor", "line24v", "recipe", "branch_on_result", "cell", "tickless", "stroke", "pick_and_place", "controller"];

/// An emulated board ends within a fraction of a second; one that has not by then hangs.
const LIMIT: Duration = Duration::from_secs(60);

/// More differences than these show nothing new.
const SHOWN: usize = 20;

/// Builds or checks for all targets, runs the image in QEMU and compares.
///
/// # Errors
/// A toolchain or QEMU is missing, a build fails, the image fails or hangs, or it answers other than the host.
pub(crate) fn run() -> Result {
    let host = host_lines()?;
    cargo("build", EXAMPLES_CRATE, BOARD, "--bins")?;
    compare(&host, &board_lines(IMAGE, RUNNER)?)?;
    println!("firmware: {} lines on the board equal those of the host", host.lines().count());
    programs()?;
    cargo("build", EXAMPLES_CRATE, LINKED, "--bins")?;
    CHECKED.iter().try_for_each(|(target, what)| cargo("check", EXAMPLES_CRATE, target, what))?;
    no_panics()?;
    corpus()
}

/// What the image prints that records the cell, fails, and sends its record after the reset; and the file of what it has sent over its serial line.
///
/// # Errors
/// A toolchain or QEMU is missing, the build fails, or the image fails or hangs.
pub(crate) fn recorded() -> Result<(String, PathBuf)> {
    build_with("record", "record")?;
    let line = project::target(FOLDER).join("record.frames");
    let lines = emulated("record", RUNNER, &["-serial", &format!("file:{}", line.display())])?;
    Ok((lines, line))
}

/// The emulator with that image, to be told where its serial line leads.
///
/// # Errors
/// A toolchain or QEMU is missing, or the build fails.
pub(crate) fn recorder() -> Result<Command> {
    build_with("record", "record")?;
    emulator("record", RUNNER)
}

/// The emulator with the image that is steered over its serial line, in our time.
///
/// # Errors
/// As [`recorder`].
pub(crate) fn steered() -> Result<Command> {
    build_with("steered", "steer")?;
    let emulator = emulator("steered", RUNNER)?;
    let mut words = emulator.get_args();
    let mut command = Command::new(emulator.get_program());
    while let Some(word) = words.next() {
        // How long an instruction takes, and that sleeping takes no time, are two words.
        if word == "-icount" {
            _ = words.next();
        } else {
            command.arg(word);
        }
    }
    Ok(command)
}

/// Builds an image that needs a feature.
fn build_with(image: &str, feature: &str) -> Result {
    let mut command = BareMetal::find(BOARD)?.cargo("build", BOARD);
    command.args(["--quiet", "--release", "--manifest-path", EXAMPLES_CRATE, "--bin", image, "--features", feature]);
    run_command(command.arg("--target-dir").arg(project::target(FOLDER)))
}

/// The examples with interrupts, and as tasks.
fn programs() -> Result {
    cargo("build", RTIC_CRATE, BOARD, "--bins")?;
    cargo("build", EMBASSY_CRATE, BOARD, "--bins")?;
    PROGRAMS.iter().try_for_each(|(name, folder, command, expected)| {
        let readme = read(&format!("{folder}/README.md"))?;
        if !readme.lines().any(|line| line.split('#').next().is_some_and(|typed| typed.trim_end() == *command)) {
            return Err(format!("{folder}/README.md does not name `{command}`"));
        }
        compare(expected, &board_lines(name, folder)?).map_err(|error| format!("{name}: {error}"))?;
        println!("firmware: {name} prints what it should");
        Ok(())
    })
}

/// No cycle function of the examples leads to a panic: linked alone, none of its machinery is there.
fn no_panics() -> Result {
    let mut command = BareMetal::find(BOARD)?.cargo("rustc", BOARD);
    command.args(["--quiet", "--release", "--manifest-path", EXAMPLES_CRATE, "--lib", "--features", "roots"]);
    run_command(command.args(["--crate-type", "staticlib", "--target-dir"]).arg(project::target(FOLDER)))?;
    let library = project::target(FOLDER).join(BOARD).join("release/libgrafcet_firmware.a");
    let linker = Linker::new(library)?;
    if linker.link("root_of_a_panic")?.panics()?.is_none() {
        return Err("no panic is found where there is one: the names to look for have changed".to_owned());
    }
    for example in EXAMPLES {
        if let Some(symbol) = linker.link(&format!("root_of_{example}"))?.panics()? {
            return Err(format!("the cycle of {example} can panic: it reaches `{symbol}`"));
        }
    }
    println!("firmware: no cycle of the examples reaches a panic");
    Ok(())
}

/// The conformance corpus on the board: an image fails where a chart shows something else than its file expects.
fn corpus() -> Result {
    let (manifest, [first, second]) = CORPUS;
    cargo("build", manifest, BOARD, "--bins")?;
    let charts = charts()?;
    for (image, count) in [(first, charts.div_ceil(2)), (second, charts / 2)] {
        compare(&format!("{count} charts, 0 failed\n"), &board_lines(image, RUNNER)?)?;
    }
    println!("firmware: the conformance corpus shows the same on the board");
    Ok(())
}

/// How many charts the corpus has.
fn charts() -> Result<usize> {
    let folder = "tests/conformance";
    let entries = fs::read_dir(project::root().join(folder)).map_err(|error| format!("{folder}: {error}"))?;
    Ok(entries.flatten().filter(|entry| entry.path().extension().is_some_and(|extension| extension == "chart")).count())
}

fn cargo(subcommand: &str, manifest: &str, target: &str, what: &str) -> Result {
    let toolchain = BareMetal::find(target)?;
    println!("firmware: {subcommand} {manifest}, {target}, {}", toolchain.describe());
    let mut command = toolchain.cargo(subcommand, target);
    command.args(["--quiet", "--release", "--manifest-path", manifest, what, "--target-dir"]);
    run_command(command.arg(project::target(FOLDER)))
}

/// What the examples print on the host, below the headings that the firmware prints.
fn host_lines() -> Result<String> {
    Program::build(&EXAMPLES.map(Program::Example))?;
    EXAMPLES
        .iter()
        .map(|example| {
            let script = format!("examples/charts/{example}.script");
            let printed = capture(Program::Example(example).built().args(["--script", &script]))?;
            match printed.as_str() {
                "" => Err(format!("the example {example} printed nothing for {script}: nothing to compare")),
                _ => Ok(format!("# {example}\n{printed}")),
            }
        })
        .collect()
}

/// What an image prints, run as `cargo run` does in this folder.
fn board_lines(image: &str, folder: &str) -> Result<String> {
    emulated(image, folder, &[])
}

/// The same with other words for the emulator.
fn emulated(image: &str, folder: &str, more: &[&str]) -> Result<String> {
    capture_within(emulator(image, folder)?.args(more), LIMIT)
}

/// The emulator with an image.
fn emulator(image: &str, folder: &str) -> Result<Command> {
    let image = project::target(FOLDER).join(BOARD).join("release").join(image);
    let config = format!("{folder}/.cargo/config.toml");
    let text = read(&config)?;
    let mut words = runner(&text).ok_or_else(|| format!("{config} names no runner"))?;
    let emulator = words.next().ok_or_else(|| format!("{config} names an empty runner"))?;
    let mut command = Command::new(tool(emulator, emulator)?);
    command.args(words).arg(image);
    Ok(command)
}

/// The words of the `runner` in a configuration of cargo.
fn runner(config: &str) -> Option<impl Iterator<Item = &str>> {
    let line = config.lines().find_map(|line| line.strip_prefix("runner = \"")?.strip_suffix('"'))?;
    Some(line.split_whitespace())
}

fn read(file: &str) -> Result<String> {
    fs::read_to_string(project::root().join(file)).map_err(|error| format!("{file}: {error}"))
}

fn compare(expected: &str, board: &str) -> Result {
    let (mut expected, mut board) = (expected.lines(), board.lines());
    let mut differences = Vec::new();
    for number in 1.. {
        match (expected.next(), board.next()) {
            (None, None) => break,
            (expected, board) if expected == board => {}
            (expected, board) => {
                let [expected, board] = [expected, board].map(|line| line.unwrap_or("(nothing)"));
                differences.push(format!("\n  line {number}\n    expected: {expected}\n    board:    {board}"));
            }
        }
    }
    let count = differences.len();
    differences.truncate(SHOWN);
    match count {
        0 => Ok(()),
        _ => Err(format!("the board answers other than expected in {count} lines:{}", differences.concat())),
    }
}

#[cfg(test)]
mod tests {
    use super::{compare, runner};

    #[test]
    fn the_runner_is_what_stands_there() {
        let words = |config| runner(config).map(Iterator::collect::<Vec<_>>);
        assert_eq!(words("[target.t]\nrunner = \"a -b c\"\n"), Some(vec!["a", "-b", "c"]));
        assert_eq!(words("[target.t]\n"), None);
    }

    #[test]
    fn equal_lines_compare_equal() {
        assert_eq!(compare("# motor\n0 Off | - | red\n", "# motor\n0 Off | - | red\n"), Ok(()));
    }

    #[test]
    fn another_line_and_a_missing_one_are_shown() {
        let error = compare("# motor\n0 Off | - | red\n1 Off | - | red\n", "# motor\n0 Off | - | -\n");
        let expected = "the board answers other than expected in 2 lines:\n  line 2\n    expected: 0 Off | - | red\n    \
                        board:    0 Off | - | -\n  line 3\n    expected: 1 Off | - | red\n    board:    (nothing)";
        assert_eq!(error, Err(expected.to_owned()));
    }

    #[test]
    fn a_surplus_line_of_the_board_is_a_difference() {
        assert!(compare("# motor\n", "# motor\n0 Off | - | red\n").is_err());
    }
}
