//! Which compiler can build for a bare-metal target on this machine.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{Result, capture, find, find_all};
use crate::project;

/// A way to build for one bare-metal target.
pub(crate) enum BareMetal {
    /// The toolchain in use has `core` for the target, from `rustup target add`.
    Installed,
    /// A toolchain that comes with its own source builds `core` as part of the project.
    FromSource {
        cargo: PathBuf,
        rustc: PathBuf,
        /// The linker `rust-lld`, which a distribution's compiler does not bring along.
        linker: PathBuf,
    },
}

impl BareMetal {
    /// Finds the way for `target`: an installed one, else the first compiler in the PATH that has its own source.
    ///
    /// # Errors
    /// There is none; the message says what to install.
    pub(crate) fn find(target: &str) -> Result<Self> {
        let found = Self::find_that(target, |_| Ok(true))?;
        found.ok_or_else(|| {
            format!(
                "no compiler here can build for {target}; install the target with `rustup target add {target}`, or a compiler \
                 with its source: `rustup component add rust-src`, on Debian `apt-get install rustc-web cargo-web rust-web-src`"
            )
        })
    }

    /// The way by a compiler of this version, where there is one.
    ///
    /// # Errors
    /// A compiler does not start.
    pub(crate) fn of_version(target: &str, version: &str) -> Result<Option<Self>> {
        Self::find_that(target, |rustc| is_version(rustc, version))
    }

    fn find_that(target: &str, fits: impl Fn(&Path) -> Result<bool>) -> Result<Option<Self>> {
        let rustc = Path::new("rustc");
        if fits(rustc)? && has_core(&print(rustc, &["--print", "target-libdir", "--target", target])?) {
            return Ok(Some(Self::Installed));
        }
        for rustc in find_all("rustc") {
            let cargo = rustc.with_file_name("cargo");
            let source = print(&rustc, &["--print", "sysroot"])?.join("lib/rustlib/src/rust/library/core");
            if cargo.is_file() && source.is_dir() && fits(&rustc)? {
                return Ok(Some(Self::FromSource { cargo, rustc, linker: linker()? }));
            }
        }
        Ok(None)
    }

    /// How to name it to the user.
    pub(crate) fn describe(&self) -> String {
        match self {
            Self::Installed => "the installed target".to_owned(),
            Self::FromSource { rustc, .. } => {
                format!("core from the source of {}", rustc.display())
            }
        }
    }

    /// What the compiler says of itself, as in `rustc 1.96.0 (…)`.
    ///
    /// # Errors
    /// It does not start.
    pub(crate) fn version(&self) -> Result<String> {
        let rustc = match self {
            Self::Installed => Path::new("rustc"),
            Self::FromSource { rustc, .. } => rustc,
        };
        version(rustc)
    }

    /// `cargo <subcommand> --target <target>` at the root of the workspace.
    pub(crate) fn cargo(&self, subcommand: &str, target: &str) -> Command {
        self.cargo_with(subcommand, target, "core")
    }

    /// The same for a target that has more of the standard library: `std,panic_abort`.
    pub(crate) fn cargo_with(&self, subcommand: &str, target: &str, libraries: &str) -> Command {
        match self {
            Self::Installed => project::cargo(&[subcommand, "--target", target]),
            Self::FromSource { cargo, rustc, linker } => {
                let mut command = Command::new(cargo);
                command.current_dir(project::root()).args([subcommand, "--target", target]);
                command.arg(format!("-Zbuild-std={libraries}"));
                // `-Zbuild-std` is not stable, and neither compiler nor cargo is a nightly one.
                command.env("RUSTC_BOOTSTRAP", "1").env("RUSTC", rustc);
                project::forget_cargo(&mut command);
                command.env(format!("CARGO_TARGET_{}_LINKER", target.to_uppercase().replace('-', "_")), linker);
                command
            }
        }
    }
}

/// `cargo <arguments>` of a compiler of this version for the host, at the root of the workspace, and the compiler.
///
/// # Errors
/// There is none, or it does not start.
pub(crate) fn host(wanted: &str, arguments: &[&str]) -> Result<(Command, PathBuf)> {
    if is_version(Path::new("rustc"), wanted)? {
        return Ok(in_use(arguments));
    }
    for rustc in find_all("rustc") {
        let cargo = rustc.with_file_name("cargo");
        if cargo.is_file() && is_version(&rustc, wanted)? {
            let mut command = Command::new(cargo);
            command.args(arguments).current_dir(project::root()).env("RUSTC", &rustc);
            project::forget_cargo(&mut command);
            return Ok((command, rustc));
        }
    }
    Err(missing(wanted))
}

/// The same of the toolchain in use, whatever its version is.
pub(crate) fn in_use(arguments: &[&str]) -> (Command, PathBuf) {
    (project::cargo(arguments), "rustc".into())
}

/// What to do where a version is missing.
pub(crate) fn missing(wanted: &str) -> String {
    format!(
        "no rustc {wanted} in the PATH, with which all costs are measured: `rustup toolchain install {wanted} --target \
         thumbv7m-none-eabi --target thumbv6m-none-eabi` and `cargo +{wanted} xtask …`, or Debian's rustc-web of that version"
    )
}

fn is_version(rustc: &Path, wanted: &str) -> Result<bool> {
    Ok(version(rustc)?.split_whitespace().nth(1) == Some(wanted))
}

fn version(rustc: &Path) -> Result<String> {
    let version = capture(project::forget_cargo(Command::new(rustc).arg("--version")))?;
    Ok(version.trim_end().to_owned())
}

fn has_core(libraries: &Path) -> bool {
    let Ok(files) = libraries.read_dir() else {
        return false;
    };
    files.flatten().any(|file| file.file_name().to_string_lossy().starts_with("libcore-"))
}

/// The `rust-lld` of the toolchain in use, else one in the PATH.
///
/// # Errors
/// There is none; the message says what to install.
pub(crate) fn linker() -> Result<PathBuf> {
    let rustlib = print(Path::new("rustc"), &["--print", "sysroot"])?.join("lib/rustlib");
    let hosts = rustlib.read_dir().into_iter().flatten().flatten();
    let mut bundled = hosts.map(|host| host.path().join("bin/rust-lld")).filter(|linker| linker.is_file());
    bundled.next().or_else(|| find("rust-lld")).or_else(|| find("ld.lld")).ok_or_else(|| {
        "no linker for bare-metal targets: neither does the toolchain in use bring rust-lld along, nor is rust-lld or \
         ld.lld in the PATH; install Rust through rustup, or on Debian `apt-get install lld`"
            .to_owned()
    })
}

/// The path that `rustc --print …` answers with.
fn print(rustc: &Path, arguments: &[&str]) -> Result<PathBuf> {
    let answer = capture(project::forget_cargo(Command::new(rustc).args(arguments)))?;
    Ok(PathBuf::from(answer.trim_end()))
}
