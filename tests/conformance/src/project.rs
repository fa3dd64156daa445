//! The crate with compiled charts: written, built by cargo, run.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use grafcet_conformance::emit;
use grafcet_conformance::recorded::written;

/// A chart and its timeline.
#[derive(Clone)]
pub(crate) struct Case {
    /// A name that can be a module.
    pub(crate) name: String,
    pub(crate) chart: String,
    pub(crate) timeline: String,
    /// The macro that makes it.
    pub(crate) by: &'static str,
    /// Whether it is also recorded and restored.
    pub(crate) recorded: bool,
}

/// What came out of a chart.
#[derive(Clone)]
pub(crate) struct Outcome {
    pub(crate) name: String,
    /// `same`, `lockstep`, `interpreter`, `deadline`, `restored`, `recorded`, `soak`, `broken`, or `rustc` for code that does not compile.
    pub(crate) kind: String,
    /// What differs.
    pub(crate) text: String,
}

/// A folder in which crates are written one after the other.
pub(crate) struct Project {
    folder: PathBuf,
    /// Each chart runs for so many cycles, or so many seconds.
    soak: Option<[u64; 2]>,
}

/// Programs of one crate: they are built and run beside each other.
const PROGRAMS: usize = 2;

/// The macros that print programs, naive and after all passes.
pub(crate) const PRINTED: [&str; 2] = ["grafcet_conformance_printed::naive", "grafcet_conformance_printed::optimised"];

/// What a soak is slow in.
const FAST: &str =
    "\n[profile.dev.package.grafcet-sim]\nopt-level = 3\n\n[profile.dev.package.grafcet-conformance]\nopt-level = 3\n";

const ALLOWED: &str = "#![allow(warnings)]\n";

impl Project {
    /// In the given folder or under the target folder; with the macro that users call and with those that print programs.
    pub(crate) fn new(folder: Option<&Path>, soak: Option<[u64; 2]>) -> Result<Self, String> {
        let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
        let folder = folder.map_or_else(|| target.join("conformance"), Path::to_owned);
        let folder = std::path::absolute(&folder).map_err(|error| error.to_string())?;
        fs::create_dir_all(folder.join("src/bin")).map_err(|error| format!("{}: {error}", folder.display()))?;
        Ok(Self { folder, soak })
    }

    /// Compiles the charts and plays their timelines.
    pub(crate) fn play(&self, cases: &[Case]) -> Result<Vec<Outcome>, String> {
        let mut outcomes = Vec::new();
        let mut cases: Vec<&Case> = cases.iter().collect();
        self.manifest()?;
        while !cases.is_empty() {
            self.programs(&cases)?;
            let Err(errors) = self.build() else { break };
            let guilty = guilty(&errors, &cases);
            if guilty.is_empty() {
                return Err(errors);
            }
            outcomes.extend(cases.iter().filter(|case| guilty.contains(&case.name)).map(|case| Outcome {
                name: case.name.clone(),
                kind: "rustc".to_owned(),
                text: errors.lines().filter(|line| line.contains(&format!("{}.rs:", case.name))).collect(),
            }));
            cases.retain(|case| !guilty.contains(&case.name));
        }
        let ran: Result<Vec<_>, String> = thread::scope(|scope| {
            let programs: Vec<_> =
                (0..PROGRAMS.min(cases.len())).map(|number| scope.spawn(move || self.run(number))).collect();
            programs.into_iter().map(|run| run.join().unwrap_or_else(|_| Err("a panic".to_owned()))).collect()
        });
        outcomes.extend(ran?.into_iter().flatten());
        Ok(outcomes)
    }

    fn manifest(&self) -> Result<(), String> {
        let root = root();
        // There is no build script: what the macros are made of has the features that the programs have, so that cargo takes both for one and
        // builds the compiler of charts once.
        let text = format!(
            "[package]\nname = \"grafcet-conformance-batch\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\n\
             grafcet = {{ path = '{}', features = ['wire'] }}\ngrafcet-conformance = {{ path = '{}' }}\n\
             grafcet-conformance-printed = {{ path = '{}' }}\n\n\
             [build-dependencies]\ngrafcet-core = {{ path = '{}', features = ['wire'] }}\n\
             embedded-io = {{ version = '0.7', features = ['alloc', 'std'] }}\n\n\
             [profile.dev]\ndebug = false\nincremental = false\nopt-level = {}\n\n\
             [profile.dev.package.\"*\"]\nopt-level = 1\n\n[profile.dev.build-override]\nopt-level = 1\n{}",
            root.display(),
            root.join("tests/conformance").display(),
            root.join("tests/conformance/printed").display(),
            root.join("grafcet-core").display(),
            if self.soak.is_some() { 3 } else { 0 },
            if self.soak.is_some() { FAST } else { "" },
        );
        self.write("Cargo.toml", &text)?;
        // The versions that the workspace is tested with.
        let lock = fs::read_to_string(root.join("Cargo.lock")).map_err(|error| format!("Cargo.lock: {error}"))?;
        self.write("Cargo.lock", &lock)
    }

    fn programs(&self, cases: &[&Case]) -> Result<(), String> {
        let share = cases.len().div_ceil(PROGRAMS);
        for program in 0..PROGRAMS {
            let part = cases.iter().skip(program * share).take(share);
            let (mut modules, mut entries, mut checks) = (String::new(), String::new(), String::new());
            for case in part {
                let name = &case.name;
                let mut module = emit::module(&case.chart, case.by).map_err(|error| format!("{name}: {error}"))?;
                if case.recorded {
                    let more = written::module(&case.chart).map_err(|error| format!("{name}: {error}"))?;
                    module.push_str(&more);
                    _ = writeln!(checks, "({name:?}, {name}::CHECKS, {name}::SOAK),");
                }
                self.write(&format!("src/{name}.rs"), &module)?;
                self.write(&format!("src/{name}.case"), &format!("{}---\n{}", case.chart, case.timeline))?;
                _ = writeln!(modules, "#[path = \"../{name}.rs\"] mod {name};");
                let subject = format!("|| Box::new({name}::Compiled::default())");
                let text = format!("include_str!(\"../{name}.case\")");
                let entry = format!("Entry {{ name: {name:?}, text: {text}, subject: {subject} }}");
                let line = if self.soak.is_some() { format!("({entry}, {name}::SOAK),") } else { format!("{entry},") };
                _ = writeln!(entries, "{line}");
            }
            let call = match self.soak {
                None => format!("main(&[\n{entries}], &[\n{checks}])"),
                Some([cycles, seconds]) => {
                    format!("soak(&[\n{entries}], {cycles}, std::time::Duration::from_secs({seconds}))")
                }
            };
            let main = format!("fn main() {{ grafcet_conformance::batch::{call}; }}");
            let text = format!("{ALLOWED}use grafcet_conformance::Entry;\n{modules}{main}\n");
            self.write(&format!("src/bin/program{program}.rs"), &text)?;
        }
        Ok(())
    }

    /// The error is what rustc said.
    fn build(&self) -> Result<(), String> {
        let mut command = self.cargo(&["build", "--quiet", "--bins", "--keep-going", "--message-format", "short"]);
        let output = command.output().map_err(|error| format!("cargo: {error}"))?;
        if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned()) }
    }

    fn run(&self, program: usize) -> Result<Vec<Outcome>, String> {
        let mut command = Command::new(self.folder.join(format!("target/debug/program{program}")));
        let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        if !output.status.success() {
            return Err(format!("{command:?} ended with {}; it printed:\n{text}", output.status));
        }
        let outcomes = text.split("== ").skip(1).map(|part| {
            let (head, text) = part.split_once('\n').unwrap_or((part, ""));
            let (name, kind) = head.split_once(' ').unwrap_or((head, "broken"));
            Outcome { name: name.to_owned(), kind: kind.to_owned(), text: text.to_owned() }
        });
        Ok(outcomes.collect())
    }

    fn cargo(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        command.args(arguments).current_dir(&self.folder).env("CARGO_TARGET_DIR", self.folder.join("target"));
        command
    }

    /// Writes a file where it changes, so that cargo keeps what it has built of the others.
    fn write(&self, name: &str, text: &str) -> Result<(), String> {
        let path = self.folder.join(name);
        if fs::read_to_string(&path).is_ok_and(|old| old == text) {
            return Ok(());
        }
        fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
    }
}

/// The charts whose files rustc names.
fn guilty(errors: &str, cases: &[&Case]) -> BTreeSet<String> {
    let errors: Vec<&str> = errors.lines().filter(|line| line.contains("error")).collect();
    let named = |case: &&&Case| errors.iter().any(|line| line.contains(&format!("{}.rs:", case.name)));
    cases.iter().filter(named).map(|case| case.name.clone()).collect()
}

/// The folder of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap_or_default()
}
