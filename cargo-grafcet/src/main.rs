//! `cargo grafcet`: the library beside it does everything.

use std::process::ExitCode;

fn main() -> ExitCode {
    cargo_grafcet::run(std::env::args_os())
}
