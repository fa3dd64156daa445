//! What CI runs, and what a change is checked with before it is proposed: `cargo xtask ci`.

use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::command::{Result, run as run_command};
use crate::project::{cargo, root};
use crate::{bench, conformance, firmware, first_chart, msrv, packages, record, record_cost};

const FIRMWARE: [&str; 2] = ["--manifest-path", "examples/firmware/Cargo.toml"];
const RTIC: [&str; 2] = ["--manifest-path", "examples/rtic/Cargo.toml"];
const EMBASSY: [&str; 2] = ["--manifest-path", "examples/embassy/Cargo.toml"];
const CORPUS: [&str; 2] = ["--manifest-path", "tests/conformance/board/Cargo.toml"];
const HOSTILE: [&str; 2] = ["--manifest-path", "tests/hostile/Cargo.toml"];
const BENCHES: [&str; 2] = ["--manifest-path", "benches/Cargo.toml"];
/// What has a lock file of its own.
const APART: [[&str; 2]; 6] = [FIRMWARE, RTIC, EMBASSY, CORPUS, HOSTILE, BENCHES];

/// A named step of CI.
type Step = (&'static str, fn() -> Result);

/// No step is ever skipped: one that lacks a tool fails and says which.
const STEPS: [Step; 12] = [
    ("lock files", lock_files),
    ("rustfmt", rustfmt),
    ("test", test),
    ("conformance", conformance::fixed),
    ("clippy", clippy),
    ("doc", doc),
    ("msrv", msrv::run),
    ("firmware", firmware::run),
    ("record", recorder),
    ("first chart", first_chart::run),
    ("cost", bench::pinned_on_one),
    ("packages", packages::run),
];

/// Runs all steps, whatever fails, and sums up.
///
/// # Errors
/// The names of the steps that failed.
pub(crate) fn run() -> Result {
    let outcomes = STEPS.map(|(name, step)| {
        println!("\n==> {name}");
        let start = Instant::now();
        let result = step();
        if let Err(message) = &result {
            eprintln!("error: {message}");
        }
        (name, start.elapsed(), result.is_ok())
    });
    sum_up(&outcomes)
}

fn sum_up(outcomes: &[(&str, Duration, bool)]) -> Result {
    println!("\n==> summary");
    for (name, time, passed) in outcomes {
        let verdict = if *passed { "passed" } else { "FAILED" };
        println!("{verdict} {:7.1} s  {name}", time.as_secs_f64());
    }
    let failed: Vec<&str> = outcomes.iter().filter(|(.., passed)| !passed).map(|(name, ..)| *name).collect();
    match failed[..] {
        [] => Ok(()),
        _ => Err(format!("{} of {} steps failed: {}", failed.len(), outcomes.len(), failed.join(", "))),
    }
}

/// The lock files belong to the manifests: what is tested is what a fresh clone builds.
fn lock_files() -> Result {
    let metadata = ["metadata", "--quiet", "--locked", "--format-version", "1"];
    run_command(cargo(&metadata).stdout(Stdio::null()))?;
    APART.iter().try_for_each(|manifest| run_command(cargo(&metadata).args(manifest).stdout(Stdio::null())))
}

fn rustfmt() -> Result {
    run_command(&mut cargo(&["fmt", "--all", "--check"]))?;
    APART.iter().try_for_each(|manifest| run_command(cargo(&["fmt", "--all", "--check"]).args(manifest)))
}

fn recorder() -> Result {
    record::run()?;
    record_cost::check()
}

/// The command that the README tells the newcomer.
fn test() -> Result {
    let readme = fs::read_to_string(root().join("README.md")).map_err(|error| format!("README.md: {error}"))?;
    if !readme.contains("cargo test --workspace") {
        return Err("README.md does not name the test command `cargo test --workspace`".to_owned());
    }
    run_command(&mut cargo(&["test", "--workspace"]))?;
    run_command(&mut cargo(&["test", "--package", "grafcet", "--features", "std", "--doc"]))
}

fn clippy() -> Result {
    const DENIED: [&str; 3] = ["--", "-D", "warnings"];
    run_command(cargo(&["clippy", "--workspace", "--all-targets"]).args(DENIED))?;
    // The board's part needs its target; the charts and the script do not.
    run_command(cargo(&["clippy", "--lib"]).args(FIRMWARE).args(DENIED))
}

fn doc() -> Result {
    run_command(cargo(&["doc", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings"))
}
