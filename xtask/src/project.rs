//! Where things are in the project.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::Result;

/// The folder of the workspace.
pub(crate) fn root() -> PathBuf {
    let xtask = Path::new(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().unwrap_or(xtask).to_owned()
}

/// A folder for build results under cargo's target directory, one per purpose: toolchains that take turns in one folder
/// rebuild what the other built.
pub(crate) fn target(purpose: &str) -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    // A relative path counts from where the user stands, the tasks run at the root.
    let target = target.and_then(|path| std::path::absolute(path).ok());
    target.unwrap_or_else(|| root().join("target")).join(purpose)
}

/// Removes a folder, where it is there.
///
/// # Errors
/// It cannot be removed.
pub(crate) fn remove(folder: &Path) -> Result {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(format!("{}: {error}", folder.display())),
        _ => Ok(()),
    }
}

/// The cargo that runs this task, at the root of the workspace.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(arguments).current_dir(root());
    command
}

/// Makes a command for a program of another toolchain than the one that runs this task: `cargo run` has set the paths of
/// its own.
pub(crate) fn forget_cargo(command: &mut Command) -> &mut Command {
    command.env_remove("CARGO").env_remove("LD_LIBRARY_PATH")
}
