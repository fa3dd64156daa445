//! What CI runs, and what a change is checked with before it is proposed: `cargo xtask ci`.

use std::collections::VecDeque;
use std::env;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Condvar, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::command::{Result, run as run_command};
use crate::project::{cargo, root, target};
use crate::{bench, conformance, firmware, first_chart, msrv, packages, processor, record, record_cost, web};

const FIRMWARE: [&str; 2] = ["--manifest-path", "examples/firmware/Cargo.toml"];
const RTIC: [&str; 2] = ["--manifest-path", "examples/rtic/Cargo.toml"];
const EMBASSY: [&str; 2] = ["--manifest-path", "examples/embassy/Cargo.toml"];
const CORPUS: [&str; 2] = ["--manifest-path", "tests/conformance/board/Cargo.toml"];
const HOSTILE: [&str; 2] = ["--manifest-path", "tests/hostile/Cargo.toml"];
const BENCHES: [&str; 2] = ["--manifest-path", "benches/Cargo.toml"];
const WEB: [&str; 2] = ["--manifest-path", "grafcet-web/bind/Cargo.toml"];
/// What has a lock file of its own.
const APART: [[&str; 2]; 7] = [FIRMWARE, RTIC, EMBASSY, CORPUS, HOSTILE, BENCHES, WEB];

/// A step of CI.
#[derive(Clone, Copy)]
struct Step {
    name: &'static str,
    /// Where most of it builds. Cargo lets one build at a time into a folder: two steps of one folder would wait for each other.
    folder: &'static str,
    run: fn() -> Result,
}

/// Where the workspace is built as `cargo test --workspace` does it.
const WORKSPACE: &str = "debug";

const fn step(name: &'static str, folder: &'static str, run: fn() -> Result) -> Step {
    Step { name, folder, run }
}

/// All that may run beside something else, in the order in which it begins: first what takes long, and what others find built. What
/// asks for a program of the workspace finds it built by `test`, so these steps come before `clippy` and `doc`, for which they would
/// wait.
///
/// No step is ever skipped: one that lacks a tool fails and says which.
const STEPS: [Step; 13] = [
    step("lock files", "none", lock_files),
    step("test", WORKSPACE, test),
    step("msrv", "msrv", msrv::run),
    step("packages", "packages", packages::run),
    step("first chart", "first chart", first_chart::run),
    step("conformance", "conformance", conformance::fixed),
    step("firmware", firmware::FOLDER, firmware::run),
    step("record", firmware::FOLDER, recorder),
    step("cost", firmware::FOLDER, bench::pinned_on_one),
    step("web", "web", web::test),
    step("clippy", WORKSPACE, clippy),
    step("doc", WORKSPACE, doc),
    step("rustfmt", "none", rustfmt),
];

/// What measures how long builds take: nothing runs beside it.
const ALONE: [Step; 1] = [step("builds", "builds", bench::pinned_builds)];

/// So many steps run beside each other: one waits for linkers, tests and the last crate of a build, which takes one processor, while
/// the other builds.
const BESIDE: usize = 2;

/// How a step has ended.
#[derive(Clone, Copy)]
struct Outcome {
    name: &'static str,
    time: Duration,
    /// Seconds, where the system tells: unlike the time, this does not depend on what else the machine does.
    processor: Option<f64>,
    passed: bool,
}

/// Runs all steps, whatever fails, and sums up. What a step prints is shown when it has ended.
///
/// # Errors
/// The names of the steps that failed.
pub(crate) fn run() -> Result {
    let runner = Runner::new()?;
    let mut outcomes = runner.beside(&STEPS);
    outcomes.extend(runner.beside(&ALONE));
    sum_up(&outcomes, &runner.folder)
}

/// Runs one step alone.
///
/// # Errors
/// It fails, or there is none of this name.
pub(crate) fn one(name: &str) -> Result {
    let steps = || STEPS.iter().chain(&ALONE);
    let step = steps().find(|other| other.name == name).ok_or_else(|| {
        let names: Vec<&str> = steps().map(|step| step.name).collect();
        format!("CI has no step `{name}`; it has: {}", names.join(", "))
    })?;
    let result = (step.run)();
    if let Ok(seconds) = processor::children() {
        println!("{PROCESSOR}{seconds:.1} s");
    }
    result
}

/// How a step tells what it took.
const PROCESSOR: &str = "ci: processor time ";

/// What waits for its turn, and the folders in use.
struct Queue {
    state: Mutex<(VecDeque<Step>, Vec<&'static str>)>,
    ended: Condvar,
}

impl Queue {
    /// The first step whose folder nobody uses; it waits for one, and there is none when all have begun.
    fn next(&self) -> Option<Turn<'_>> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            let (waiting, used) = &mut *state;
            if waiting.is_empty() {
                return None;
            }
            if let Some(at) = waiting.iter().position(|step| !used.contains(&step.folder)) {
                let step = waiting.remove(at)?;
                used.push(step.folder);
                return Some(Turn { queue: self, step });
            }
            state = self.ended.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// A step that runs. Whatever ends it, its folder is free again, or the others would wait for ever.
struct Turn<'q> {
    queue: &'q Queue,
    step: Step,
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        let folder = self.step.folder;
        self.queue.state.lock().unwrap_or_else(PoisonError::into_inner).1.retain(|used| *used != folder);
        self.queue.ended.notify_all();
    }
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

    /// Runs all of them, [`BESIDE`] at a time, and tells of them in their order.
    fn beside(&self, steps: &[Step]) -> Vec<Outcome> {
        let queue = Queue { state: Mutex::new((steps.iter().copied().collect(), Vec::new())), ended: Condvar::new() };
        let work = || {
            let mut outcomes = Vec::new();
            while let Some(turn) = queue.next() {
                outcomes.push(self.step(turn.step.name));
            }
            outcomes
        };
        let outcomes: Vec<Outcome> = thread::scope(|scope| {
            let workers: Vec<_> = (0..BESIDE).map(|_| scope.spawn(work)).collect();
            workers.into_iter().flat_map(|worker| worker.join().unwrap_or_default()).collect()
        });
        // Where a worker has ended with a panic, nothing that it ran counts.
        let lost = |name| Outcome { name, time: Duration::ZERO, processor: None, passed: false };
        let of = |step: &Step| outcomes.iter().find(|outcome| outcome.name == step.name).copied();
        steps.iter().map(|step| of(step).unwrap_or_else(|| lost(step.name))).collect()
    }

    fn step(&self, name: &'static str) -> Outcome {
        let start = Instant::now();
        println!("==> {name} begins");
        let log = log(&self.folder, name);
        let result = self.run(name, &log);
        let time = start.elapsed();
        let printed = fs::read(&log).unwrap_or_default();
        let mut text = format!("\n==> {name}\n{}", String::from_utf8_lossy(&printed));
        let told = text.lines().find_map(|line| line.strip_prefix(PROCESSOR)?.strip_suffix(" s")?.parse().ok());
        if let Err(message) = &result {
            _ = writeln!(text, "error: {message}");
        }
        // In one piece: another one prints, too.
        println!("{text}");
        Outcome { name, time, processor: told, passed: result.is_ok() }
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

/// What a step has printed.
fn log(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.log"))
}

/// Shows once more why steps have failed, as their logs are long and may have been cut, and then how each has ended.
fn sum_up(outcomes: &[Outcome], folder: &Path) -> Result {
    for outcome in outcomes.iter().filter(|outcome| !outcome.passed) {
        let printed = fs::read(log(folder, outcome.name)).unwrap_or_default();
        println!(
            "\n==> {} failed; from what it printed:\n{}",
            outcome.name,
            excerpt(&String::from_utf8_lossy(&printed))
        );
    }
    println!("\n==> summary");
    for Outcome { name, time, processor, passed } in outcomes {
        let verdict = if *passed { "passed" } else { "FAILED" };
        let processor = processor.map_or_else(|| "?".to_owned(), |seconds| format!("{seconds:.1}"));
        println!("{verdict} {:7.1} s, {processor:>7} s of processor time  {name}", time.as_secs_f64());
    }
    let failed: Vec<&str> = outcomes.iter().filter(|outcome| !outcome.passed).map(|outcome| outcome.name).collect();
    match failed[..] {
        [] => Ok(()),
        _ => Err(format!("{} of {} steps failed: {}", failed.len(), outcomes.len(), failed.join(", "))),
    }
}

/// So many lines at the end of a log say why a step has failed, and so many of what a test program says of its tests that have.
const SHOWN: usize = 30;

/// What test programs say of tests that have failed, wherever it stands, and the last lines.
fn excerpt(log: &str) -> String {
    let lines: Vec<&str> = log.lines().collect();
    let last = lines.len().saturating_sub(SHOWN);
    // Within what is said of failed tests: how many more lines of it are shown.
    let (mut shown, mut within) = (String::new(), None);
    for (at, line) in lines.iter().enumerate() {
        match *line {
            "failures:" => within = within.or(Some(SHOWN)),
            line if line.starts_with("test result:") => within = None,
            _ => {}
        }
        if at >= last || within.is_some_and(|left| left > 0) {
            _ = writeln!(shown, "{line}");
        }
        within = within.map(|left: usize| left.saturating_sub(1));
    }
    shown
}

/// The lock files belong to the manifests: what is tested is what a fresh clone builds.
fn lock_files() -> Result {
    let metadata = ["metadata", "--quiet", "--locked", "--format-version", "1"];
    run_command(cargo(&metadata).stdout(Stdio::null()))?;
    APART.iter().try_for_each(|manifest| run_command(cargo(&metadata).args(manifest).stdout(Stdio::null())))
}

fn rustfmt() -> Result {
    run_command(&mut cargo(&["fmt", "--all", "--check"]))?;
    // With `--all` also the crates of the workspace that these depend on, once more. Only what has no package of its own needs that.
    APART.iter().try_for_each(|manifest| {
        let all: &[&str] = if *manifest == HOSTILE { &["--all"] } else { &[] };
        run_command(cargo(&["fmt", "--check"]).args(all).args(manifest))
    })
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
    // All that fails is shown.
    run_command(&mut cargo(&["test", "--workspace", "--no-fail-fast"]))
}

fn clippy() -> Result {
    const DENIED: [&str; 3] = ["--", "-D", "warnings"];
    run_command(cargo(&["clippy", "--workspace", "--all-targets"]).args(DENIED))?;
    // The board's part needs its target; the charts and the script do not.
    run_command(cargo(&["clippy", "--lib"]).args(FIRMWARE).args(DENIED))
}

/// The workspace turns on all features of the compiler; published, its page is made without them.
fn doc() -> Result {
    let document =
        |which: &[&str]| run_command(cargo(&["doc", "--no-deps"]).args(which).env("RUSTDOCFLAGS", "-D warnings"));
    document(&["--workspace"])?;
    document(&["--package", "grafcet-compiler"])
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::Duration;

    use super::{ALONE, Outcome, Runner, STEPS, Step, excerpt, step, sum_up};

    /// A runner whose steps are this script.
    fn runner(name: &str, script: &'static str) -> Runner {
        let folder = std::env::temp_dir().join(format!("grafcet-ci-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        Runner { program: "sh".into(), words: vec!["-c", script, "sh"], folder }
    }

    #[test]
    fn a_step_keeps_all_that_it_prints_in_its_order() {
        let script = "echo $1; echo wrong >&2; echo right; echo ci: processor time 2.5 s; exit 1";
        let runner = runner("order", script);
        let outcome = runner.step("clippy");
        assert_eq!((outcome.name, outcome.processor, outcome.passed), ("clippy", Some(2.5), false));
        let printed = fs::read_to_string(runner.folder.join("clippy.log")).expect("what it printed");
        assert_eq!(printed, "clippy\nwrong\nright\nci: processor time 2.5 s\n");
        fs::remove_dir_all(&runner.folder).expect("the folder");
    }

    #[test]
    fn a_step_that_fails_keeps_none_after_it_from_running() {
        let runner = runner("goes-on", "test \"$1\" != test");
        let passed: Vec<_> = runner.beside(&STEPS).iter().map(|outcome| (outcome.name, outcome.passed)).collect();
        assert_eq!(passed, STEPS.map(|step| (step.name, step.name != "test")));
        fs::remove_dir_all(&runner.folder).expect("the folder");
    }

    #[test]
    fn two_steps_run_beside_each_other_but_not_in_one_folder() {
        // Each tells that it runs, and who else does.
        let runner = runner("beside", "touch $0-$1.runs; sleep 0.4; ls $0-*.runs; rm $0-$1.runs");
        let folder = runner.folder.join("at").display().to_string();
        let words = vec!["-c", runner.words[1], Box::leak(folder.into_boxed_str())];
        let runner = Runner { words, ..runner };
        let steps: [Step; 3] =
            [("a", "x"), ("b", "x"), ("c", "y")].map(|(name, folder)| step(name, folder, super::rustfmt));
        assert!(runner.beside(&steps).iter().all(|outcome| outcome.passed));
        let beside =
            |name: &str| fs::read_to_string(runner.folder.join(format!("{name}.log"))).expect("what it printed");
        assert!(beside("a").contains("at-c.runs") || beside("c").contains("at-a.runs"), "{}", beside("a"));
        assert!(!beside("a").contains("at-b.runs") && !beside("b").contains("at-a.runs"), "{}", beside("a"));
        fs::remove_dir_all(&runner.folder).expect("the folder");
    }

    #[test]
    fn the_summary_names_what_failed() {
        let outcome = |name, passed| Outcome { name, time: Duration::ZERO, processor: None, passed };
        let nowhere = std::path::Path::new("nowhere");
        assert_eq!(sum_up(&[outcome("test", true), outcome("doc", true)], nowhere), Ok(()));
        let error = "2 of 3 steps failed: test, msrv".to_owned();
        let outcomes = [outcome("test", false), outcome("doc", true), outcome("msrv", false)];
        assert_eq!(sum_up(&outcomes, nowhere), Err(error));
    }

    #[test]
    fn an_excerpt_has_each_failing_test_and_the_end() {
        let failed = "running 2 tests\ntest a ... FAILED\n\nfailures:\n\n---- a stdout ----\nnot equal\n\nfailures:\n    a\n\n\
                      test result: FAILED. 1 passed; 1 failed\n";
        let passed = "running 1 test\ntest b ... ok\ntest result: ok. 1 passed\n".repeat(40);
        let excerpt = excerpt(&format!("{passed}{failed}{passed}error: 1 target failed"));
        assert!(excerpt.starts_with("failures:\n\n---- a stdout ----\nnot equal\n\nfailures:\n    a\n\ntest b ... ok"));
        assert!(excerpt.ends_with("error: 1 target failed\n"));
        assert_eq!(excerpt.lines().count(), 38);
    }

    #[test]
    fn an_excerpt_of_a_long_failure_is_short() {
        let long = format!(
            "failures:\n\n---- a stdout ----\n{}\ntest result: FAILED. 1 failed\n{}",
            "b\n".repeat(900),
            "c\n".repeat(60)
        );
        let excerpt = excerpt(&long);
        assert!(excerpt.starts_with("failures:\n\n---- a stdout ----\nb\n"));
        assert!(excerpt.lines().count() <= 60, "{excerpt}");
    }

    #[test]
    fn each_step_has_a_name_of_its_own() {
        let mut names: Vec<&str> = STEPS.iter().chain(&ALONE).map(|step| step.name).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!((names.len(), count), (14, 14));
    }
}
