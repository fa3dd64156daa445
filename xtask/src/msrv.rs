//! The crates that ship, checked with the oldest Rust they promise to build with.

use std::fs;
use std::process::Command;

use crate::command::{Result, capture, find, run as run_command};
use crate::debian;
use crate::project;

/// The `rust-version` of the workspace, as in `1.85`.
const MSRV: &str = env!("CARGO_PKG_RUST_VERSION");

/// All but the tool `cargo-grafcet`, which people install and no program is built with: its terminal needs a newer Rust. What the macro
/// is made of is built, which a user's build has to, too; checked in place of that, it would be compiled for the macro and once more.
const BUILT: [&str; 5] = ["grafcet", "grafcet-core", "grafcet-draw", "grafcet-macros", "grafcet-compiler"];

/// What is a library for tools.
const CHECKED: [&str; 3] = ["grafcet-sim", "grafcet-exchange", "grafcet-prove"];

/// A crate with the charts of the source documents and charts in the full language of both dialects.
const CONSUMER: &str = "hostile-no-std";

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
    for (subcommand, crates) in [("build", &BUILT[..]), ("check", &CHECKED)] {
        let mut command = cargo(toolchain.as_deref(), subcommand)?;
        run_command(command.args(crates.iter().flat_map(|name| ["--package", name])))?;
    }
    // What the macro generates is compiled by the user's compiler.
    let mut command = cargo(toolchain.as_deref(), "check")?;
    run_command(command.args(["--manifest-path", "tests/hostile/Cargo.toml", "--package", CONSUMER]))
}

/// The file says the version that the workspace's manifest says.
fn repeats((file, before, after): &(&str, &str, &str)) -> Result {
    let text = fs::read_to_string(project::root().join(file)).map_err(|error| format!("{file}: {error}"))?;
    let words = format!("{before}{MSRV}{after}");
    if text.contains(&words) { Ok(()) } else { Err(format!("{file} does not say `{words}`")) }
}

/// `cargo build` or `cargo check` of the toolchain of that name, else of Debian's.
fn cargo(toolchain: Option<&str>, subcommand: &str) -> Result<Command> {
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
    command.args([subcommand, "--locked", "--lib", "--target-dir"]).arg(project::target("msrv"));
    // Nobody runs it; and a library and the same one for a macro are two builds with debug information, and one without.
    command.env("CARGO_PROFILE_DEV_DEBUG", "0");
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
