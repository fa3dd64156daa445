//! The fuzzer of `fuzz/` with the one stable toolchain: libFuzzer, and rustc's own counters of what was reached.

use std::fs;
use std::process::Command;

use crate::command::{Result, capture, run as run_command};
use crate::project::{self, cargo};

const MANIFEST: &str = "fuzz/Cargo.toml";

/// What `cargo fuzz` would ask of rustc, but for a sanitizer: there is no `unsafe` in what is looked at.
const FLAGS: [&str; 7] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "-Ccodegen-units=1",
    "--cfg=fuzzing",
];

/// From the first one on inputs may have any length: otherwise each stays with a few bytes for hours, as a run takes milliseconds.
const LENGTHS: [&str; 2] = ["-len_control=0", "-max_len=512"];

/// How long a run may take, in seconds: another program may have the processor meanwhile.
const LONGEST: u32 = 120;

/// Builds a target and lets it run for some seconds; what it finds worth keeping stays below the target folder, `merge` puts the least of it that reaches as much into the corpus.
///
/// # Errors
/// There is no such target, a C++ compiler is missing, or the fuzzer has found something.
pub(crate) fn run(target: &str, seconds: &str, merge: bool) -> Result {
    let host = &host()?;
    let folder = project::target("fuzz");
    let mut build = cargo(&["build", "--quiet", "--release", "--manifest-path", MANIFEST, "--bin", target]);
    // With a target of its own, what runs while building is not instrumented.
    build.args(["--target", host, "--target-dir"]).arg(&folder);
    build.env(format!("CARGO_TARGET_{}_RUSTFLAGS", host.to_uppercase().replace('-', "_")), FLAGS.join(" "));
    run_command(&mut build)?;
    let grown = folder.join("grown").join(target);
    let corpus = project::root().join("fuzz/corpus").join(target);
    for folder in [&grown, &corpus] {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let program = folder.join(host).join("release").join(target);
    let mut fuzz = Command::new(&program);
    fuzz.arg(format!("-timeout={LONGEST}"))
        .arg("-rss_limit_mb=2048")
        .arg(format!("-artifact_prefix={}/{target}-", folder.display()));
    fuzz.args(LENGTHS).arg(format!("-max_total_time={seconds}")).args([&grown, &corpus]);
    run_command(&mut fuzz)?;
    if merge {
        let mut fuzz = Command::new(&program);
        run_command(fuzz.args(["-merge=1"]).args([&corpus, &grown]))?;
    }
    Ok(())
}

/// The target of this machine.
fn host() -> Result<String> {
    let told = capture(Command::new("rustc").arg("-vV"))?;
    let host = told.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned).ok_or_else(|| "rustc does not tell its host".to_owned())
}
