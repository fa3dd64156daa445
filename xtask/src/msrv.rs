//! The crates that ship, checked with the oldest Rust they promise to build with.

use std::fs;
use std::process::Command;

use crate::command::{Result, capture, find, run as run_command};
use crate::debian;
use crate::project;

/// The `rust-version` of the workspace, as in `1.85`.
const MSRV: &str = env!("CARGO_PKG_RUST_VERSION");

/// A crate with the charts of the source documents and charts in the full language of both dialects: with it all is built that a
/// program with charts is made of. Checking these crates by themselves, too, would compile the compiler of charts three times.
const CONSUMER: &str = "hostile-no-std";

/// The libraries for tools. The tool `cargo-grafcet` itself people install, and no program is built with it: its terminal needs a
/// newer Rust.
const LIBRARIES: [&str; 3] = ["grafcet-sim", "grafcet-exchange", "grafcet-prove"];

/// Who repeats the version, because it does not inherit it from the workspace, and how.
const REPEATED: [(&str, &str, &str); 5] = [
    ("README.md", "MSRV: Rust ", "."),
    ("benches/Cargo.toml", "rust-version = \"", "\""),
    ("examples/firmware/Cargo.toml", "rust-version = \"", "\""),
    ("tests/hostile/Cargo.toml", "rust-version = \"", "\""),
    ("tests/conformance/board/Cargo.toml", "rust-version = \"", "\""),
];

/// Checks the libraries and a crate with charts with rustup's toolchain of that version, else with Debian's.
///
/// # Errors
/// There is neither, or a crate does not build with it.
pub(crate) fn run() -> Result {
    REPEATED.iter().try_for_each(repeats)?;
    let toolchain = installed()?;
    // What the macro generates is compiled by the user's compiler.
    let mut command = cargo(toolchain.as_deref())?;
    run_command(command.args(["--manifest-path", "tests/hostile/Cargo.toml", "--package", CONSUMER]))?;
    let mut command = cargo(toolchain.as_deref())?;
    run_command(command.args(LIBRARIES.iter().flat_map(|name| ["--package", name])))
}

/// The file says the version that the workspace's manifest says.
fn repeats((file, before, after): &(&str, &str, &str)) -> Result {
    let text = fs::read_to_string(project::root().join(file)).map_err(|error| format!("{file}: {error}"))?;
    let words = format!("{before}{MSRV}{after}");
    if text.contains(&words) { Ok(()) } else { Err(format!("{file} does not say `{words}`")) }
}

/// `cargo check` of the toolchain of that name, else of Debian's.
fn cargo(toolchain: Option<&str>) -> Result<Command> {
    let mut command = match toolchain {
        Some(toolchain) => {
            println!("msrv: rustup's toolchain {toolchain}");
            let mut command = Command::new("rustup");
            project::forget_cargo(command.args(["run", toolchain, "cargo"]));
            command
        }
        None => debian::cargo(MSRV).map_err(|reason| {
            format!(
                "no Rust {MSRV} here: `rustup toolchain install {MSRV}` installs it; Debian's cannot be used: {reason}"
            )
        })?,
    };
    command.args(["check", "--locked", "--lib", "--target-dir"]).arg(project::target("msrv"));
    command.current_dir(project::root());
    Ok(command)
}

/// The name of rustup's toolchain of that version, where there are both.
fn installed() -> Result<Option<String>> {
    if find("rustup").is_none() {
        return Ok(None);
    }
    let list = capture(Command::new("rustup").args(["toolchain", "list"]))?;
    let names = list.lines().filter_map(|line| line.split_whitespace().next());
    let mut fitting = names.filter(|name| {
        // `1.85-x86_64-…` and `1.85.1-x86_64-…`, but neither `1.8-…` nor `1.851-…`
        name.strip_prefix(MSRV).is_some_and(|rest| rest.starts_with(['-', '.']))
    });
    Ok(fitting.next().map(str::to_owned))
}
