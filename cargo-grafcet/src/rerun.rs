//! `check --watch`: once more whenever a file has changed.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use notify::{Event, EventKind, RecursiveMode, Watcher};

use crate::args::Charts;
use crate::{Failure, Outcome, complain, find, say};

/// A file is written in several pieces, and an editor moves it to and fro: so long nothing more has happened to it.
const SETTLED: Duration = Duration::from_millis(100);

/// Does it at once, and again after each change of a file that is meant, until nobody reads the output any more.
///
/// # Errors
/// The files are not known, or the system does not tell of changes. What goes wrong with the charts themselves is said, and mended by the next change.
pub(crate) fn run(charts: &Charts, mut check: impl FnMut() -> Result<Outcome, Failure>) -> Result<Outcome, Failure> {
    let (sender, changes) = channel();
    let cannot = |error: notify::Error| Failure::Said(format!("changes of files cannot be seen: {error}"));
    let mut watcher = notify::recommended_watcher(sender).map_err(cannot)?;
    // What changes during the first check counts.
    for folder in find::folders(charts)? {
        let mode = if folder.is_recursive { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive };
        watcher.watch(&folder.path, mode).map_err(cannot)?;
    }
    loop {
        match check() {
            Ok(_) => {}
            Err(Failure::Silent) => return Err(Failure::Silent),
            Err(failure) => complain(&failure.to_string()),
        }
        let Some(file) = next(&changes, &charts.files) else { return Ok(Outcome::Well) };
        say(&format!("\n{} has changed\n", find::shown(&file).display()))?;
    }
}

/// The first file of the next changes.
fn next(changes: &Receiver<notify::Result<Event>>, files: &[PathBuf]) -> Option<PathBuf> {
    loop {
        let change = changes.recv().ok()?;
        if let Some(changed) = meant(change, files) {
            while changes.recv_timeout(SETTLED).is_ok() {}
            return Some(changed);
        }
    }
}

/// The file that has changed, if it is one of those that are named, or Rust where none is.
fn meant(change: notify::Result<Event>, files: &[PathBuf]) -> Option<PathBuf> {
    // That somebody reads it is no change.
    let event = change.ok().filter(|event| !matches!(event.kind, EventKind::Access(_)))?;
    let is_named = |path: &Path| files.iter().any(|file| file.file_name() == path.file_name());
    let is_meant = |path: &&PathBuf| match files {
        [] => path.extension().is_some_and(|extension| extension == "rs"),
        _ => is_named(path),
    };
    event.paths.iter().find(is_meant).cloned()
}
