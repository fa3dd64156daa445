//! Where things are in the project.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{Result, run};

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

/// A program of the workspace, ready to be run.
pub(crate) enum Program {
    Binary(&'static str),
    Example(&'static str),
}

impl Program {
    fn name(&self) -> &'static str {
        let (Self::Binary(name) | Self::Example(name)) = self;
        name
    }

    /// Builds it.
    ///
    /// # Errors
    /// It does not build.
    pub(crate) fn command(&self) -> Result<Command> {
        Self::build(std::slice::from_ref(self))?;
        Ok(self.built())
    }

    /// Builds programs as `cargo test --workspace` does it, which leaves nothing to build after it: for one package alone, cargo would
    /// build the compiler of charts and all else anew, with the features that this package asks for.
    ///
    /// # Errors
    /// One of them does not build.
    pub(crate) fn build(programs: &[Self]) -> Result {
        let mut command = cargo(&["build", "--quiet", "--workspace", "--profile", "test"]);
        // Only where it builds an example, too, cargo takes the features that tests ask for.
        command.args(["--example", "decode"]);
        for program in programs {
            let kind = if matches!(program, Self::Binary(_)) { "--bin" } else { "--example" };
            command.args([kind, program.name()]);
        }
        run(&mut command)
    }

    /// One that has been built, to be run at the root of the workspace.
    pub(crate) fn built(&self) -> Command {
        let mut command = Command::new(self.file());
        command.current_dir(root());
        command
    }

    /// Where it is.
    pub(crate) fn file(&self) -> PathBuf {
        let folder = if matches!(self, Self::Binary(_)) { "debug" } else { "debug/examples" };
        target(folder).join(format!("{}{}", self.name(), std::env::consts::EXE_SUFFIX))
    }
}

/// Makes a command for a program of another toolchain than the one that runs this task: `cargo run` has set the paths of
/// its own.
pub(crate) fn forget_cargo(command: &mut Command) -> &mut Command {
    command.env_remove("CARGO").env_remove("LD_LIBRARY_PATH")
}
