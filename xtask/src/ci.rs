//! What CI runs, and what a change is checked with before it is proposed: `cargo xtask ci`.

use std::env;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::command::{Result, run as run_command};
use crate::project::{cargo, root, target};
use crate::{bench, conformance, firmware, first_chart, msrv, packages, record, record_cost, web};

const FIRMWARE: [&str; 2] = ["--manifest-path", "examples/firmware/Cargo.toml"];
const RTIC: [&str; 2] = ["--manifest-path", "examples/rtic/Cargo.toml"];
const EMBASSY: [&str; 2] = ["--manifest-path", "examples/embassy/Cargo.toml"];
const CORPUS: [&str; 2] = ["--manifest-path", "tests/conformance/board/Cargo.toml"];
const HOSTILE: [&str; 2] = ["--manifest-path", "tests/hostile/Cargo.toml"];
const BENCHES: [&str; 2] = ["--manifest-path", "benches/Cargo.toml"];
const WEB: [&str; 2] = ["--manifest-path", "grafcet-web/bind/Cargo.toml"];
/// What has a lock file of its own.
const APART: [[&str; 2]; 7] = [FIRMWARE, RTIC, EMBASSY, CORPUS, HOSTILE, BENCHES, WEB];

/// A named step of CI.
type Step = (&'static str, fn() -> Result);

/// Two rows of steps that run beside each other: a step of one waits for linkers, tests and the last crate of a build, which takes
/// one processor, while the other builds. Cargo lets one build at a time into a folder, so what stands in the second row has
/// folders of its own, first those steps that build nowhere else.
///
/// No step is ever skipped: one that lacks a tool fails and says which.
const ROWS: [&[Step]; 2] = [
    &[
        ("lock files", lock_files),
        ("rustfmt", rustfmt),
        ("test", test),
        ("conformance", conformance::fixed),
        ("clippy", clippy),
        ("doc", doc),
    ],
    &[
        ("msrv", msrv::run),
        ("packages", packages::run),
        ("firmware", firmware::run),
        ("record", recorder),
        ("first chart", first_chart::run),
        ("web", web::test),
    ],
];

/// What measures how long builds take: nothing runs beside it.
const ALONE: [Step; 1] = [("cost", bench::pinned_on_one)];

/// How a step has ended: its name, how long it took, whether it passed.
type Outcome = (&'static str, Duration, bool);

/// Runs all steps, whatever fails, and sums up. What a step prints is shown when it has ended.
///
/// # Errors
/// The names of the steps that failed.
pub(crate) fn run() -> Result {
    let runner = Runner::new()?;
    let mut outcomes: Vec<Outcome> = thread::scope(|scope| {
        let rows = ROWS.map(|row| (row, scope.spawn(|| runner.row(row))));
        rows.into_iter().flat_map(|(row, thread)| thread.join().unwrap_or_else(|_| lost(row))).collect()
    });
    outcomes.extend(runner.row(&ALONE));
    sum_up(&outcomes)
}

/// Runs one step alone.
///
/// # Errors
/// It fails, or there is none of this name.
pub(crate) fn one(name: &str) -> Result {
    let steps = || ROWS.into_iter().flatten().chain(&ALONE);
    let step = steps().find(|(other, _)| *other == name).ok_or_else(|| {
        let names: Vec<&str> = steps().map(|(name, _)| *name).collect();
        format!("CI has no step `{name}`; it has: {}", names.join(", "))
    })?;
    (step.1)()
}

/// Runs each step as a program of its own, so that it has its own output, and its own count of processor time.
struct Runner {
    /// A copy of this program: while it runs, a step may build it anew.
    program: PathBuf,
    /// What the program is told before the step's name.
    words: Vec<&'static str>,
    /// For what the steps print.
    folder: PathBuf,
}

impl Runner {
    fn new() -> Result<Self> {
        let folder = target("ci");
        let program = folder.join("xtask");
        let failed = |error: std::io::Error| format!("{}: {error}", program.display());
        fs::create_dir_all(&folder).map_err(failed)?;
        let copied = env::current_exe().and_then(|this| fs::copy(this, &program));
        copied.map_err(failed)?;
        Ok(Self { program, words: vec!["ci"], folder })
    }

    fn row(&self, steps: &[Step]) -> Vec<Outcome> {
        steps.iter().map(|(name, _)| self.step(name)).collect()
    }

    fn step(&self, name: &'static str) -> Outcome {
        let start = Instant::now();
        println!("==> {name} begins");
        let log = self.folder.join(format!("{name}.log"));
        let result = self.run(name, &log);
        let time = start.elapsed();
        let printed = fs::read(&log).unwrap_or_default();
        let mut text = format!("\n==> {name}\n{}", String::from_utf8_lossy(&printed));
        if let Err(message) = &result {
            _ = writeln!(text, "error: {message}");
        }
        // In one piece: the other row prints, too.
        println!("{text}");
        (name, time, result.is_ok())
    }

    fn run(&self, name: &str, log: &Path) -> Result {
        let failed = |error: std::io::Error| format!("{}: {error}", log.display());
        let output = File::create(log).map_err(failed)?;
        let errors = output.try_clone().map_err(failed)?;
        let mut command = Command::new(&self.program);
        command.args(&self.words).arg(name).stdin(Stdio::null()).stdout(output).stderr(errors);
        run_command(&mut command)
    }
}

/// Where a row has ended with a panic, none of it counts.
fn lost(row: &[Step]) -> Vec<Outcome> {
    row.iter().map(|(name, _)| (*name, Duration::ZERO, false)).collect()
}

fn sum_up(outcomes: &[Outcome]) -> Result {
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

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::Duration;

    use super::{ALONE, ROWS, Runner, sum_up};

    /// A runner whose steps are this script.
    fn runner(name: &str, script: &'static str) -> Runner {
        let folder = std::env::temp_dir().join(format!("grafcet-ci-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        Runner { program: "sh".into(), words: vec!["-c", script, "sh"], folder }
    }

    #[test]
    fn a_step_keeps_all_that_it_prints_in_its_order() {
        let runner = runner("order", "echo $1; echo wrong >&2; echo right; exit 1");
        let (name, _, passed) = runner.step("clippy");
        assert_eq!((name, passed), ("clippy", false));
        let printed = fs::read_to_string(runner.folder.join("clippy.log")).expect("what it printed");
        assert_eq!(printed, "clippy\nwrong\nright\n");
        fs::remove_dir_all(&runner.folder).expect("the folder");
    }

    #[test]
    fn a_step_that_fails_keeps_none_after_it_from_running() {
        let runner = runner("goes-on", "test \"$1\" != test");
        let passed: Vec<bool> = runner.row(ROWS[0]).into_iter().map(|(.., passed)| passed).collect();
        assert_eq!(passed, [true, true, false, true, true, true]);
        fs::remove_dir_all(&runner.folder).expect("the folder");
    }

    #[test]
    fn the_summary_names_what_failed() {
        let outcome = |name, passed| (name, Duration::ZERO, passed);
        assert_eq!(sum_up(&[outcome("test", true), outcome("doc", true)]), Ok(()));
        let error = "2 of 3 steps failed: test, msrv".to_owned();
        assert_eq!(sum_up(&[outcome("test", false), outcome("doc", true), outcome("msrv", false)]), Err(error));
    }

    #[test]
    fn each_step_has_a_name_of_its_own() {
        let mut names: Vec<&str> = ROWS.into_iter().flatten().chain(&ALONE).map(|(name, _)| *name).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!((names.len(), count), (13, 13));
    }
}
