//! What is looked at before a release, beside what CI runs: tools that take longer to install than CI to run.

use std::process::Command;

use crate::command::{Result, capture, find, run as run_command};
use crate::project::{cargo, root};
use crate::{conformance, interface, packages};

/// Checks licences, advisories and sources (`deny.toml`), all sets of features, that the public interfaces are those recorded, that none has
/// changed more since the last release than the version says, and that `abc` says of properties what the prover does.
///
/// # Errors
/// A tool is missing, or one of the checks fails.
pub(crate) fn run() -> Result {
    for name in ["cargo-deny", "cargo-public-api", "cargo-semver-checks"] {
        find(name).ok_or_else(|| format!("{name} is not in the PATH: `cargo install --locked {name}`"))?;
    }
    find("berkeley-abc").ok_or("berkeley-abc is not in the PATH: `apt-get install berkeley-abc`")?;
    run_command(&mut cargo(&["deny", "check"]))?;
    packages::all_features()?;
    interface::compare()?;
    conformance::beside_abc()?;
    let tags =
        capture(Command::new("git").args(["tag", "--list", "v*", "--sort=-version:refname"]).current_dir(root()))?;
    match tags.lines().next() {
        None => println!("release: this is the first, there is no interface to compare with"),
        Some(last) => {
            // Of a macro, the tool knows nothing; what charts expand to is recorded in `tests/golden`.
            for package in packages::published()?.into_iter().filter(|package| package.is_library) {
                run_command(&mut cargo(&["semver-checks", "--package", &package.name, "--baseline-rev", last]))?;
            }
        }
    }
    Ok(())
}
