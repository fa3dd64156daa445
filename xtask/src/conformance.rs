//! Random charts, compiled through the macro, beside the interpreter: the program of the package `grafcet-conformance`.

use crate::command::{Result, run as run_command};
use crate::project::{Program, cargo};

/// Runs the program with these arguments; with `--program` naive programs, which need no rustc.
///
/// # Errors
/// A chart differs, or a crate cannot be built.
pub(crate) fn run(arguments: &[&str]) -> Result {
    // The program builds crates of its own: cargo must not hold its lock meanwhile, so it is run and not tested.
    run_command(Program::Binary("conformance").command()?.args(arguments))
}

/// The checker beside a naive exploration of random charts.
///
/// # Errors
/// A chart differs.
pub(crate) fn brute(arguments: &[&str]) -> Result {
    let program = ["run", "--quiet", "--release", "--package", "grafcet-conformance", "--bin", "brute", "--"];
    run_command(cargo(&program).args(arguments))
}

/// What charts claim, proved or refuted; random ones beside a naive exploration and `abc`.
///
/// # Errors
/// Something is not proved, or differs.
pub(crate) fn prove(arguments: &[&str]) -> Result {
    let program = ["run", "--quiet", "--release", "--package", "grafcet-conformance", "--bin", "prove", "--"];
    run_command(cargo(&program).args(arguments))
}

/// What claims something among the examples and the tests of the macro.
const CLAIMING: [&str; 8] = [
    "examples/charts/cell.rs",
    "examples/charts/pick_and_place.rs",
    "examples/charts/stroke.rs",
    "tests/good/operating_modes.rs",
    "tests/good/press.rs",
    "tests/good/selections_of_rust.rs",
    "tests/good/stop_anywhere.rs",
    "tests/good/supervised_tank.rs",
];

/// The verdicts of `abc` beside ours: on the charts that claim something, and on 500 random ones.
///
/// # Errors
/// `berkeley-abc` is missing, or one differs.
pub(crate) fn beside_abc() -> Result {
    for file in CLAIMING {
        prove(&[file, "--seconds", "60", "--abc"])?;
    }
    for kind in ["plain", "times"] {
        prove(&["--random", "125", "--kind", kind, "--abc"])?;
    }
    Ok(())
}

/// What CI runs: always the same charts.
///
/// # Errors
/// As [`run`].
pub(crate) fn fixed() -> Result {
    run(&FIXED)?;
    run(&PROGRAMS)?;
    run(&PRINTED)
}

/// Which these are; of each kind at least five.
pub(crate) const FIXED: [&str; 8] = ["--charts", "220", "--cycles", "500", "--seed", "77", "--least", "5"];

/// The Rust printed from programs, naive and after passes: the corpus, and of each dialect so many random charts.
const PRINTED: [&str; 7] = ["--printed", "--charts", "12", "--cycles", "200", "--seed", "79"];

/// The same of programs, naive and after passes: as many charts as a minute is enough for.
const PROGRAMS: [&str; 7] = ["--program", "--charts", "2500", "--cycles", "200", "--seed", "78"];
