//! The tool in folders of their own.
#![allow(dead_code, reason = "each test needs a part of it")]

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

/// What a call of the tool has done.
#[derive(Debug)]
pub(crate) struct Done {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

/// `cargo grafcet …` in a folder.
pub(crate) fn tool(folder: &Path, arguments: &[&str]) -> Done {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cargo-grafcet"));
    let output = command.arg("grafcet").args(arguments).current_dir(folder).output();
    let output = output.unwrap_or_else(|error| panic!("the tool cannot be run: {error}"));
    Done {
        code: output.status.code(),
        out: String::from_utf8_lossy(&output.stdout).into_owned(),
        err: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

/// A folder with these files.
pub(crate) fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("no folder: {error}"));
    for (name, text) in files {
        let file = folder.path().join(name);
        let made = file.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&file, text));
        made.unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    }
    folder
}

/// A crate of its own.
pub(crate) const MANIFEST: (&str, &str) =
    ("Cargo.toml", "[package]\nname = \"plant\"\nedition = \"2024\"\n[workspace]\n");
