//! The public interface of each crate that is published, beside the record of it in `tests/interface`.

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use crate::command::{Result, capture};
use crate::packages;
use crate::project::{cargo, root};

/// Records all of them anew.
///
/// # Errors
/// `cargo public-api` cannot list one.
pub(crate) fn record() -> Result {
    for package in packages::published()? {
        let file = file(&package.name);
        fs::write(&file, list(&package.name)?).map_err(|error| format!("{}: {error}", file.display()))?;
    }
    Ok(())
}

/// Compares all of them with what is recorded.
///
/// # Errors
/// One differs, and how; it has no record; or `cargo public-api` cannot list it.
pub(crate) fn compare() -> Result {
    let mut changed = String::new();
    for package in packages::published()? {
        let file = file(&package.name);
        let recorded = fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let now = list(&package.name)?;
        if recorded != now {
            _ = write!(changed, "{}\n{}", package.name, difference(&recorded, &now));
        }
    }
    match changed.as_str() {
        "" => Ok(()),
        _ => Err(format!(
            "interfaces differ from what is recorded:\n{changed}`cargo xtask interface record` records what is meant to be so"
        )),
    }
}

fn file(package: &str) -> PathBuf {
    root().join("tests/interface").join(package).with_extension("txt")
}

/// One line for each public item, with all features; without implementations that come of themselves or of a derive.
fn list(package: &str) -> Result<String> {
    capture(&mut cargo(&["public-api", "--package", package, "--all-features", "-sss", "--color=never"]))
}

/// The lines that only one of the two has, in their order.
fn difference(recorded: &str, now: &str) -> String {
    let mut lines = String::new();
    for (sign, these, others) in [('-', recorded, now), ('+', now, recorded)] {
        for line in these.lines().filter(|line| !others.lines().any(|other| other == *line)) {
            _ = writeln!(lines, "{sign} {line}");
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::difference;

    #[test]
    fn what_came_and_what_went() {
        let (old, new) = ("pub mod a\npub fn a::f()\n", "pub mod a\npub fn a::f(bool)\npub fn a::g()\n");
        assert_eq!(difference(old, new), "- pub fn a::f()\n+ pub fn a::f(bool)\n+ pub fn a::g()\n");
        assert_eq!(difference(old, old), "");
    }
}
