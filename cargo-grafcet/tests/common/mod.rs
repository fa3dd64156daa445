//! The tool in folders of their own.
#![allow(dead_code, reason = "each test needs a part of it")]

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use tempfile::TempDir;

/// Who is not done by then, will never be.
const LONGEST: Duration = Duration::from_secs(300);

/// What a call of the tool has done.
#[derive(Debug)]
pub(crate) struct Done {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

/// `cargo grafcet …` in a folder. What goes on for ever, as a server that should not have begun, fails the test.
pub(crate) fn tool(folder: &Path, arguments: &[&str]) -> Done {
    tool_within(LONGEST, folder, arguments)
}

/// The same, with a limit.
pub(crate) fn tool_within(limit: Duration, folder: &Path, arguments: &[&str]) -> Done {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cargo-grafcet"));
    command.arg("grafcet").args(arguments).current_dir(folder);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap_or_else(|error| panic!("the tool cannot be run: {error}"));
    let (out, err) = (read(child.stdout.take()), read(child.stderr.take()));
    let end = Instant::now() + limit;
    let code = loop {
        match child.try_wait().unwrap_or_else(|error| panic!("the tool is lost: {error}")) {
            Some(status) => break status.code(),
            None if Instant::now() < end => thread::sleep(Duration::from_millis(2)),
            None => {
                _ = child.kill();
                _ = child.wait();
                let [out, err] = [out, err].map(|text| text.join().unwrap_or_default());
                panic!("`cargo grafcet {}` goes on and on; so far it says:\n{out}{err}", arguments.join(" "));
            }
        }
    };
    let [out, err] = [out, err].map(|text| text.join().unwrap_or_default());
    Done { code, out, err }
}

/// All that is written, while the program runs: a pipe has no room for much.
fn read(from: Option<impl Read + Send + 'static>) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        _ = from.map(|mut from| from.read_to_end(&mut bytes));
        String::from_utf8_lossy(&bytes).into_owned()
    })
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
