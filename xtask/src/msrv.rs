//! The crates that ship, checked with the oldest Rust they promise to build with.

use std::process::Command;

use crate::command::{Result, capture, find, run as run_command};
use crate::debian;
use crate::project;

/// The `rust-version` of the workspace, as in `1.85`.
const MSRV: &str = env!("CARGO_PKG_RUST_VERSION");

const CRATES: [&str; 4] = ["grafcet", "grafcet-core", "grafcet-macros", "grafcet-compiler"];

/// Checks the libraries with rustup's toolchain of that version, else with Debian's.
///
/// # Errors
/// There is neither, or a crate does not build with it.
pub(crate) fn run() -> Result {
    let mut command = match installed()? {
        Some(toolchain) => {
            println!("msrv: rustup's toolchain {toolchain}");
            let mut command = Command::new("rustup");
            project::forget_cargo(command.args(["run", &toolchain, "cargo"]));
            command
        }
        None => debian::cargo(MSRV).map_err(|reason| {
            format!(
                "no Rust {MSRV} here: `rustup toolchain install {MSRV}` installs it; Debian's cannot be used: {reason}"
            )
        })?,
    };
    command.args(["check", "--locked", "--lib"]);
    command.args(CRATES.iter().flat_map(|name| ["--package", name]));
    run_command(command.arg("--target-dir").arg(project::target("msrv")).current_dir(project::root()))
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
