//! How long it takes to build with the macro, beside smlang and statig: processor time of the compiler and all it starts,
//! which does not depend on what else the machine does.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use super::{COMPILER, machines};
use crate::command::{Result, capture};
use crate::processor::children;
use crate::project::{forget_cargo, root, target};
use crate::toolchain;

/// Who is compared, by the crate's name.
pub(super) const CRATES: [&str; 3] = ["grafcet", "smlang", "statig"];

/// Each build is done so often, in turns; the shortest counts.
pub(super) const ROUNDS: usize = 2;

/// How often that crate is edited in a round.
const EDITS: usize = 4;

/// How many charts stand in the crate of small ones, and of how many steps each is.
const SMALL: (usize, usize) = (100, 4);

/// The long chart.
const LONG: usize = 5000;

/// Seconds of processor time, for each of [`CRATES`].
pub(super) struct Times {
    /// From nothing to a crate that depends on the macro and does not use it.
    pub(super) clean: [f64; 3],
    /// `cargo check` of a hundred small charts, after one line has changed.
    pub(super) small: [f64; 3],
    /// `cargo check` of a ring of 100 steps.
    pub(super) chain100: [f64; 3],
    /// `cargo check` of a ring of 1000 steps.
    pub(super) chain1000: [f64; 3],
    /// A ring of 5000 steps as a chart.
    pub(super) long: Compilation,
}

/// What one run of rustc takes.
pub(super) struct Compilation {
    pub(super) seconds: f64,
    pub(super) mebibytes: f64,
}

/// Builds everything.
pub(super) fn measure() -> Result<Times> {
    let projects = CRATES.map(Project::new);
    let none = [f64::MAX; 3];
    let mut times = Times { clean: none, small: none, chain100: none, chain1000: none, long: Compilation::NONE };
    for project in &projects {
        project.fetch()?;
    }
    for _ in 0..ROUNDS {
        for (place, project) in projects.iter().enumerate() {
            println!("bench: building with {}", project.name);
            let least = |time: &mut [f64; 3], now: f64| time[place] = time[place].min(now);
            least(&mut times.clean, project.clean()?);
            for (time, steps) in [(&mut times.chain100, 100), (&mut times.chain1000, 1000)] {
                project.write(&source(project.name, steps))?;
                least(time, project.check()?);
            }
            least(&mut times.small, project.small()?);
        }
        times.long = times.long.least(&projects[0].compile(&source(CRATES[0], LONG))?);
    }
    Ok(times)
}

/// What CI looks at.
pub(super) const WATCHED: [&str; 2] = ["clean", "small"];

impl Times {
    /// How many times statig's [`WATCHED`] takes.
    pub(super) fn ratios(&self) -> [f64; 2] {
        [&self.clean, &self.small].map(|[ours, _, statig]| ours / statig)
    }
}

/// The same, of nothing else.
pub(super) fn ratios(rounds: usize) -> Result<[f64; 2]> {
    let mut times = [[f64::MAX; 2]; 2];
    let projects = [CRATES[0], CRATES[2]].map(Project::new);
    projects.iter().try_for_each(Project::fetch)?;
    for _ in 0..rounds {
        for (place, project) in projects.iter().enumerate() {
            let measured = [project.clean()?, project.small()?];
            times.iter_mut().zip(measured).for_each(|(least, now)| least[place] = least[place].min(now));
        }
    }
    Ok(times.map(|[ours, statig]| ours / statig))
}

/// A crate that uses one of [`CRATES`].
struct Project {
    name: &'static str,
    folder: PathBuf,
}

impl Project {
    fn new(name: &'static str) -> Self {
        Self { name, folder: target("builds").join(name) }
    }

    fn cargo(&self, arguments: &[&str]) -> Command {
        // Ratios are nearly the same with another compiler; the figures that are recorded need this one anyway.
        let (mut command, _) = toolchain::host(COMPILER, arguments).unwrap_or_else(|_| toolchain::in_use(arguments));
        command.current_dir(&self.folder).env_remove("CARGO_TARGET_DIR");
        command
    }

    fn fetch(&self) -> Result {
        self.write("")?;
        capture(&mut self.cargo(&["fetch", "--quiet"])).map(|_| ())
    }

    fn write(&self, source: &str) -> Result {
        let dependency = match self.name {
            "grafcet" => format!("grafcet = {{ path = '{}' }}", root().display()),
            name => locked(name)?,
        };
        let manifest = format!(
            "[package]\nname = \"chain\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\n{dependency}\n"
        );
        let sources = self.folder.join("src");
        fs::create_dir_all(&sources).map_err(|error| format!("{}: {error}", sources.display()))?;
        write(&self.folder.join("Cargo.toml"), &manifest)?;
        write(&sources.join("lib.rs"), source)
    }

    /// Seconds of processor time from nothing to a crate without a chart.
    fn clean(&self) -> Result<f64> {
        let built = self.folder.join("target");
        if built.exists() {
            fs::remove_dir_all(&built).map_err(|error| format!("{}: {error}", built.display()))?;
        }
        self.write("")?;
        self.check()
    }

    /// Seconds of processor time that `cargo check` takes.
    fn check(&self) -> Result<f64> {
        // As the first check of a user: there is nothing that could be reused.
        self.timed_check("0")
    }

    /// The same of small charts after an edit, with all that an earlier check has left; the shortest of several, as it is but seconds.
    fn small(&self) -> Result<f64> {
        let charts = small_charts(self.name);
        self.write(&charts)?;
        self.timed_check("1")?;
        let edited = |edit| {
            self.write(&format!("{charts}pub fn edited{edit}() {{}}\n"))?;
            self.timed_check("1")
        };
        (0..EDITS).try_fold(f64::MAX, |least, edit| Ok(least.min(edited(edit)?)))
    }

    fn timed_check(&self, incremental: &str) -> Result<f64> {
        let before = children()?;
        let mut command = self.cargo(&["check", "--quiet", "--offline", "--target-dir", "target"]);
        capture(command.env("CARGO_INCREMENTAL", incremental))?;
        Ok(children()? - before)
    }

    /// What rustc takes for a source, of which cargo has built the dependencies.
    fn compile(&self, source: &str) -> Result<Compilation> {
        self.write(source)?;
        let deps = self.folder.join("target/debug/deps");
        let facade = entries(&deps)?.into_iter().find(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            name.starts_with("libgrafcet-") && path.extension().is_some_and(|extension| extension == "rmeta")
        });
        let facade = facade.ok_or_else(|| format!("cargo has built no grafcet in {}", deps.display()))?;
        let (_, rustc) = toolchain::host(COMPILER, &[])?;
        let mut command = Command::new(rustc);
        command.args(["--edition", "2024", "--crate-type", "lib", "--emit", "metadata", "--out-dir"]).arg(&self.folder);
        command.arg("--extern").arg(format!("grafcet={}", facade.display()));
        command.arg("-L").arg(format!("dependency={}", deps.display())).arg("src/lib.rs").current_dir(&self.folder);
        run_watched(forget_cargo(&mut command))
    }
}

impl Compilation {
    /// More than any.
    const NONE: Self = Self { seconds: f64::MAX, mebibytes: f64::MAX };

    fn least(&self, other: &Self) -> Self {
        Self { seconds: self.seconds.min(other.seconds), mebibytes: self.mebibytes.min(other.mebibytes) }
    }
}

/// Runs a program and looks at its memory as long as it lives: the system keeps the most that it has had.
fn run_watched(command: &mut Command) -> Result<Compilation> {
    let before = children()?;
    let text = format!("{command:?}");
    let failed = |error| format!("{text}: {error}");
    let mut child = command.stdin(Stdio::null()).spawn().map_err(failed)?;
    let status = PathBuf::from(format!("/proc/{}/status", child.id()));
    let mut kibibytes = 0;
    let ended = loop {
        if let Some(ended) = child.try_wait().map_err(failed)? {
            break ended;
        }
        let most = fs::read_to_string(&status).ok().and_then(|text| most_memory(&text));
        kibibytes = most.unwrap_or(0).max(kibibytes);
        thread::sleep(Duration::from_millis(2));
    };
    if !ended.success() {
        return Err(format!("{text} ended with {ended}"));
    }
    Ok(Compilation { seconds: children()? - before, mebibytes: f64::from(kibibytes) / 1024.0 })
}

/// The line `VmHWM:   123456 kB`.
fn most_memory(status: &str) -> Option<u32> {
    status.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok())
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).and_then(|entries| entries.map(|entry| Ok(entry?.path())).collect());
    entries.map_err(|error| format!("{}: {error}", folder.display()))
}

/// The version that the benches use, as a line of a manifest.
fn locked(name: &str) -> Result<String> {
    let manifest = root().join("benches/Cargo.toml");
    let text = fs::read_to_string(&manifest).map_err(|error| format!("{}: {error}", manifest.display()))?;
    let line = text.lines().find(|line| line.strip_prefix(name).is_some_and(|rest| rest.starts_with(" = { version")));
    line.map(|line| line.replace(", optional = true", "")).ok_or_else(|| format!("the benches do not use {name}"))
}

/// Where manifest and source have not changed, they are not written: cargo looks at the times of files.
fn write(path: &Path, text: &str) -> Result {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// The library's source: a ring of so many steps.
fn source(name: &str, steps: usize) -> String {
    let fields = machines::list(machines::signals(steps), |i| format!("pub x{i}: bool, "));
    let inputs = format!("pub struct ChartInputs {{ {fields} }}\n");
    match name {
        "grafcet" => format!("grafcet::grafcet! {{ pub sfc Chart {{\n{}}} }}\n", machines::chart(steps)),
        "smlang" => format!("{inputs}{}", machines::smlang_machine(steps)),
        _ => format!("{inputs}{}", machines::statig_machine(steps)),
    }
}

/// Small rings, each in a module of its own.
fn small_charts(name: &str) -> String {
    let (count, steps) = SMALL;
    let chart = source(name, steps);
    machines::list(count, |number| format!("pub mod chart{number} {{\n{chart}}}\n"))
}

#[cfg(test)]
mod tests {
    use super::{locked, most_memory, source};

    #[test]
    fn the_rivals_are_those_of_the_benches() {
        for name in ["smlang", "statig"] {
            let line = locked(name).expect("a dependency of the benches");
            assert!(line.starts_with(&format!("{name} = {{ version = ")) && line.ends_with(" }"), "{line}");
        }
    }

    #[test]
    fn the_same_ring_for_all() {
        for name in super::CRATES {
            let source = source(name, 100);
            assert!(source.contains("x15") && source.to_lowercase().contains("s99"), "{source}");
        }
    }

    #[test]
    fn the_most_memory_is_read() {
        assert_eq!(most_memory("Name:\trustc\nVmHWM:\t  123456 kB\nVmRSS:\t  1 kB\n"), Some(123_456));
        assert_eq!(most_memory("Name:\tsh\n"), None);
    }
}
