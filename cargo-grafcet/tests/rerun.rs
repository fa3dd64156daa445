//! `check --watch`, beside an editor that saves files.

mod common;

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use common::{MANIFEST, folder, tool};

const GOOD: &str = "grafcet! { sfc Press { input a: bool; initial step A; step B; A -[a]-> B -[!a]-> A; } }\n";

/// No machine takes as long as this.
const LONG: Duration = Duration::from_secs(120);

/// The tool as it watches, and the lines that it writes.
struct Watching {
    child: Child,
    lines: Receiver<String>,
}

impl Watching {
    fn begin(folder: &Path, arguments: &[&str]) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_cargo-grafcet"));
        command.args(["grafcet", "check", "--watch"]).args(arguments).current_dir(folder);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the tool");
        let (sender, lines) = channel();
        let streams: [Option<Box<dyn Read + Send>>; 2] =
            [child.stdout.take().map(|out| Box::new(out) as _), child.stderr.take().map(|err| Box::new(err) as _)];
        for stream in streams.into_iter().flatten() {
            let sender = sender.clone();
            thread::spawn(move || {
                for line in BufReader::new(stream).lines().map_while(Result::ok) {
                    _ = sender.send(line);
                }
            });
        }
        Self { child, lines }
    }

    /// Waits for a line with this in it.
    fn says(&self, what: &str) {
        let mut so_far = Vec::new();
        loop {
            match self.lines.recv_timeout(LONG) {
                Ok(line) if line.contains(what) => return,
                Ok(line) => so_far.push(line),
                Err(error) => panic!("{error} for {what:?} after {so_far:#?}"),
            }
        }
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        _ = self.child.kill();
        _ = self.child.wait();
    }
}

#[test]
fn a_file_is_checked_whenever_it_is_saved() {
    let folder = folder(&[("press.rs", GOOD), ("other.rs", GOOD)]);
    let file = folder.path().join("press.rs");
    let watching = Watching::begin(folder.path(), &["press.rs"]);
    watching.says("1 chart: nothing to say");
    fs::write(folder.path().join("other.rs"), "no chart").expect("saved");
    fs::write(&file, GOOD.replace("!a", "aa")).expect("saved");
    // Nothing is said of a file beside it.
    assert_eq!(watching.lines.recv_timeout(LONG).as_deref(), Ok(""));
    assert_eq!(watching.lines.recv_timeout(LONG).as_deref(), Ok("press.rs has changed"));
    watching.says("unknown_name");
    watching.says("1 chart: 1 error");
    // What is no Rust for a moment ends nothing.
    fs::write(&file, "grafcet! { ").expect("saved");
    watching.says("this is not Rust");
    // Some editors write another file and give it the name.
    let new = folder.path().join("new.tmp");
    fs::write(&new, GOOD).expect("saved");
    fs::rename(&new, &file).expect("renamed");
    watching.says("1 chart: nothing to say");
    // That the tool reads it is no change.
    assert!(watching.lines.recv_timeout(Duration::from_secs(1)).is_err());
}

#[test]
fn a_crate_is_checked_with_files_that_come() {
    let folder = folder(&[MANIFEST, ("src/lib.rs", GOOD)]);
    let watching = Watching::begin(folder.path(), &[]);
    watching.says("1 chart: nothing to say");
    fs::create_dir(folder.path().join("src/line")).expect("a folder");
    fs::write(folder.path().join("src/line/mod.rs"), GOOD.replace("Press", "Line")).expect("saved");
    fs::write(folder.path().join("src/lib.rs"), format!("mod line;\n{GOOD}")).expect("saved");
    watching.says("2 charts: nothing to say");
    fs::write(folder.path().join("src/line/mod.rs"), GOOD.replace("-> A", "-> C")).expect("saved");
    watching.says("unknown_step");
}

#[test]
fn it_is_for_people() {
    let folder = folder(&[("press.rs", GOOD)]);
    for format in [&["--json"][..], &["--sarif"], &["--format", "json"]] {
        let done = tool(folder.path(), &[&["check", "--watch", "press.rs"], format].concat());
        assert_eq!(done.code, Some(2), "{}", done.err);
    }
    let done = tool(folder.path(), &["check", "--watch", "gone/press.rs"]);
    assert!(done.err.contains("changes of files cannot be seen"), "{}", done.err);
    assert_eq!(done.code, Some(2));
}
