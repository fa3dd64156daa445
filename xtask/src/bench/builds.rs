//! How long it takes to build with the macro, beside smlang and statig: processor time of the compiler and all it starts,
//! which does not depend on what else the machine does.

use std::fs;
use std::path::{Path, PathBuf};

use super::machines;
use crate::command::{Result, capture};
use crate::processor::children;
use crate::project::{cargo, root, target};

/// Who is compared, by the crate's name.
pub(super) const CRATES: [&str; 3] = ["grafcet", "smlang", "statig"];

/// Each build is done so often, in turns; the shortest counts.
const ROUNDS: usize = 3;

/// Seconds of processor time, for each of [`CRATES`].
pub(super) struct Times {
    /// From nothing to a crate that depends on the macro and does not use it.
    pub(super) clean: [f64; 3],
    /// `cargo check` of a ring of 100 steps.
    pub(super) chain100: [f64; 3],
    /// `cargo check` of a ring of 1000 steps.
    pub(super) chain1000: [f64; 3],
}

/// Builds everything.
pub(super) fn measure() -> Result<Times> {
    let projects = CRATES.map(Project::new);
    let mut times = Times { clean: [f64::MAX; 3], chain100: [f64::MAX; 3], chain1000: [f64::MAX; 3] };
    for project in &projects {
        project.write("")?;
        capture(cargo(&["fetch", "--quiet"]).current_dir(&project.folder))?;
    }
    for _ in 0..ROUNDS {
        for (place, project) in projects.iter().enumerate() {
            println!("bench: building with {}", project.name);
            let built = project.folder.join("target");
            if built.exists() {
                fs::remove_dir_all(&built).map_err(|error| format!("{}: {error}", built.display()))?;
            }
            for (time, steps) in [(&mut times.clean, 0), (&mut times.chain100, 100), (&mut times.chain1000, 1000)] {
                project.write(&source(project.name, steps))?;
                time[place] = time[place].min(project.check()?);
            }
        }
    }
    Ok(times)
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

    /// Seconds of processor time that `cargo check` takes.
    fn check(&self) -> Result<f64> {
        let before = children()?;
        let mut command = cargo(&["check", "--quiet", "--offline", "--target-dir", "target"]);
        // As the first check of a user: there is nothing that could be reused.
        capture(command.current_dir(&self.folder).env("CARGO_INCREMENTAL", "0").env_remove("CARGO_TARGET_DIR"))?;
        Ok(children()? - before)
    }
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
    match (name, steps) {
        (_, 0) => String::new(),
        ("grafcet", _) => format!("grafcet::grafcet! {{ pub sfc Chart {{\n{}}} }}\n", machines::chart(steps)),
        ("smlang", _) => format!("{inputs}{}", machines::smlang_machine(steps)),
        _ => format!("{inputs}{}", machines::statig_machine(steps)),
    }
}

#[cfg(test)]
mod tests {
    use super::{locked, source};

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
}
