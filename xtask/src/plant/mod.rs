//! Faults planted one by one into the runtime, the lowering and the code generator: do the tests of CI find them?
//!
//! Each is a patch of a few words, put into a copy of the tree. What runs there is what CI runs, with the same random charts;
//! comparisons with recorded files are left out, as they show every change and judge none.

mod faults;
mod quick;

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::command::{Result, capture, tool};
use crate::project::{cargo, root, target};
use faults::{FAULTS, Fault};
use quick::{Outcome, Quick};

/// After so many seconds a test has not ended, or the charts of the corpus, which take less than one.
const SLOW: &str = "1800";
const LIMIT: &str = "60";

/// A test of CI.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Finder {
    /// The unit tests of `grafcet-core`.
    Core,
    /// What is stored and read back, on the charts of the examples.
    Snapshots,
    /// The charts with timelines worked out by hand.
    Corpus,
    /// The random charts of a dialect.
    Random(&'static str),
}

impl Finder {
    /// All of them, the quick ones first.
    const ALL: [Self; 5] = [Self::Core, Self::Snapshots, Self::Corpus, Self::Random("sfc"), Self::Random("grafcet")];

    fn name(self) -> String {
        match self {
            Self::Core => "unit tests of grafcet-core".to_owned(),
            Self::Snapshots => "snapshots of the examples".to_owned(),
            Self::Corpus => "corpus".to_owned(),
            Self::Random(dialect) => format!("random {dialect} charts"),
        }
    }

    fn arguments(self) -> Vec<&'static str> {
        match self {
            Self::Core => vec!["test", "--quiet", "--package", "grafcet-core", "--lib"],
            Self::Snapshots => vec!["test", "--quiet", "--package", "grafcet-record", "--test", "snapshot"],
            Self::Corpus => vec!["test", "--quiet", "--package", "grafcet-conformance", "--test", "corpus"],
            Self::Random(dialect) => {
                let program = ["run", "--quiet", "--package", "grafcet-conformance", "--bin", "conformance", "--"];
                let mut words = program.to_vec();
                words.extend(crate::conformance::FIXED);
                words.extend(["--shrink", "0", "--dialect", dialect]);
                words
            }
        }
    }
}

/// Plants every fault, or those whose name holds a word.
///
/// # Errors
/// A patch does not fit any more, nobody finds a fault, or `timeout` is missing.
pub(crate) fn run(word: Option<&str>) -> Result {
    tool("timeout", "coreutils")?;
    let folder = target("plant");
    let tree = folder.join("tree");
    copy(&tree)?;
    let chosen: Vec<&Fault> = FAULTS.iter().filter(|fault| word.is_none_or(|word| fault.name.contains(word))).collect();
    if chosen.is_empty() {
        return Err(format!("no fault is called {}", word.unwrap_or_default()));
    }
    let quick = Quick::new(&folder, &tree)?;
    // Where a test fails without a fault, it finds nothing.
    if let Outcome::Fails(text) = quick.play("")? {
        return Err(format!("the corpus fails without a fault: {text}"));
    }
    let mut unseen = Vec::new();
    for fault in chosen {
        let path = tree.join(fault.file);
        let sound = read(&path)?;
        write(&path, &fault.plant(&sound)?)?;
        let found = find(fault, &quick, &folder);
        write(&path, &sound)?;
        let found = found?;
        println!("{}: {}", fault.name, found.as_deref().unwrap_or("NOT FOUND"));
        // What takes long is looked at without a fault only where it was needed.
        let slow = Finder::ALL.into_iter().find(|finder| found.as_ref() == Some(&finder.name()));
        if let Some(finder) = slow.filter(|finder| fails(*finder, &folder)) {
            return Err(format!("{} fail without a fault", finder.name()));
        }
        if found.is_none() {
            unseen.push(fault.name);
        }
    }
    if unseen.is_empty() { Ok(()) } else { Err(format!("nobody finds: {}", unseen.join("; "))) }
}

/// Who finds it: first the test that is known to, then all of them, the quick ones first.
fn find(fault: &Fault, quick: &Quick, folder: &Path) -> Result<Option<String>> {
    for charts in fault.charts.into_iter().chain(fault.charts.map(|_| "")) {
        if let Outcome::Fails(text) = quick.play(charts)? {
            return Ok(Some(format!("corpus ({text})")));
        }
    }
    Ok(Finder::ALL.into_iter().find(|finder| fails(*finder, folder)).map(Finder::name))
}

/// A command that is ended, together with what it has started.
fn bounded(program: impl AsRef<OsStr>, seconds: &str) -> Command {
    let mut command = Command::new("timeout");
    command.arg(seconds).arg(program).stdin(Stdio::null());
    command
}

fn fails(finder: Finder, folder: &Path) -> bool {
    // A search without end finds a fault, too.
    let mut command = bounded(cargo(&[]).get_program(), SLOW);
    command.args(finder.arguments());
    command.current_dir(folder.join("tree")).env("CARGO_TARGET_DIR", folder.join("target"));
    command.env("CARGO_INCREMENTAL", "0").env("CARGO_PROFILE_DEV_DEBUG", "0");
    let status = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
    !status.is_ok_and(|status| status.success())
}

/// All files of the tree as they are, those that are not recorded yet included.
fn copy(tree: &Path) -> Result {
    let mut git = Command::new("git");
    git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]).current_dir(root());
    let mut files: Vec<PathBuf> = capture(&mut git)?.split_terminator('\0').map(PathBuf::from).collect();
    files.retain(|file| root().join(file).is_file());
    for file in files {
        let (from, to) = (root().join(&file), tree.join(&file));
        let fail = |error: std::io::Error| format!("{}: {error}", to.display());
        // What has not changed keeps its date, so that cargo keeps what it has built of it.
        if fs::read(&from).ok() == fs::read(&to).ok() {
            continue;
        }
        fs::create_dir_all(to.parent().unwrap_or(tree)).map_err(fail)?;
        fs::copy(&from, &to).map_err(fail)?;
    }
    Ok(())
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::{FAULTS, read, root};

    #[test]
    fn every_fault_still_has_its_place() {
        let wrong = FAULTS.iter().filter_map(|fault| fault.plant(&read(&root().join(fault.file)).ok()?).err());
        assert_eq!(wrong.collect::<Vec<_>>(), Vec::<String>::new());
        assert!(FAULTS.iter().all(|fault| root().join(fault.file).is_file()));
    }

    #[test]
    fn every_fault_stands_in_contributing() {
        let page = read(&root().join("CONTRIBUTING.md")).expect("the page");
        let missing: Vec<&str> = FAULTS.iter().map(|fault| fault.name).filter(|name| !page.contains(name)).collect();
        assert_eq!(missing, Vec::<&str>::new());
    }
}
