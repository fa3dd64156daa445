//! An older Rust from Debian's packages, unpacked below the target directory: beside a newer one it cannot be installed.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{Result, capture, find, run};
use crate::project;

/// The cargo of Debian's Rust `version` (as in `1.85`), set up to use the compiler beside it.
///
/// # Errors
/// Debian's package tools are missing, its lists do not offer that version, or it does not start.
pub(crate) fn cargo(version: &str) -> Result<Command> {
    let folder = project::target(&format!("debian-rust-{version}"));
    if !folder.is_dir() {
        unpack(version, &folder)?;
    }
    let programs = folder.join("usr/bin");
    let libraries = libraries(&folder)?;
    for program in ["rustc", "cargo"] {
        let mut command = Command::new(programs.join(program));
        let answer = capture(command.arg("--version").env("LD_LIBRARY_PATH", &libraries)).map_err(|error| {
            format!("{error}; the libraries it uses come with `apt-get install libllvm19 libpcre3`")
        })?;
        println!("msrv: Debian's {}", answer.trim_end());
    }
    let mut command = Command::new(programs.join("cargo"));
    project::forget_cargo(&mut command);
    command.env("RUSTC", programs.join("rustc")).env("LD_LIBRARY_PATH", libraries);
    Ok(command)
}

/// Fetches the packages of that version and unpacks them into `folder`.
fn unpack(version: &str, folder: &Path) -> Result {
    if find("apt-get").is_none() || find("dpkg-deb").is_none() {
        return Err("this is not a Debian".to_owned());
    }
    let full = offered(version)?;
    // Renamed when complete, so that an interrupted run leaves no half toolchain.
    let partial = project::target(&format!("debian-rust-{version}.partial"));
    let failed = |what: &str, error| format!("cannot {what} {}: {error}", partial.display());
    if partial.exists() {
        fs::remove_dir_all(&partial).map_err(|error| failed("remove", error))?;
    }
    fs::create_dir_all(&partial).map_err(|error| failed("create", error))?;
    let library = format!("libstd-rust-web-{version}");
    let packages = ["rustc-web", &library, "libstd-rust-web-dev", "cargo-web"].map(|name| format!("{name}={full}"));
    run(Command::new("apt-get").args(["--quiet", "download"]).args(packages).current_dir(&partial))?;
    for package in entries(&partial)? {
        run(Command::new("dpkg-deb").arg("--extract").arg(package).arg(&partial))?;
    }
    fs::rename(&partial, folder).map_err(|error| failed("rename", error))
}

/// The full version of the package that the lists offer, such as `1.85.0+dfsg3-1`.
fn offered(version: &str) -> Result<String> {
    let list = capture(Command::new("apt-cache").args(["madison", "rustc-web"]))?;
    let mut versions = list.lines().filter_map(|line| line.split('|').nth(1)).map(str::trim);
    let fitting = versions.find(|full| full.strip_prefix(version).is_some_and(|rest| rest.starts_with('.')));
    fitting.map(str::to_owned).ok_or_else(|| {
        format!("the package lists offer no rustc-web {version} (Debian 12 has it; `apt-get update` reads the lists)")
    })
}

/// The folders of the shared libraries, one per architecture, as `LD_LIBRARY_PATH` wants them.
fn libraries(folder: &Path) -> Result<OsString> {
    let mut folders = entries(&folder.join("usr/lib"))?;
    folders.retain(|path| path.to_string_lossy().contains("-linux-"));
    std::env::join_paths(folders).map_err(|error| format!("cannot list the libraries in {}: {error}", folder.display()))
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).and_then(|entries| entries.map(|entry| Ok(entry?.path())).collect());
    entries.map_err(|error| format!("cannot read {}: {error}", folder.display()))
}
