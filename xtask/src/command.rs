//! Running other programs.

use std::ffi::OsStr;
use std::io::Read;
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// The error is the message that the user reads.
pub(crate) type Result<T = ()> = std::result::Result<T, String>;

/// Runs a program with the user's console.
///
/// # Errors
/// It cannot be started or does not end with success.
pub(crate) fn run(command: &mut Command) -> Result {
    let status = command.status().map_err(|error| cannot_start(command, &error))?;
    check(command, status)
}

/// Runs a program and answers with what it printed; its errors go to the user's console.
///
/// # Errors
/// As [`run`], and where the output is not UTF-8.
pub(crate) fn capture(command: &mut Command) -> Result<String> {
    command.stderr(Stdio::inherit());
    let output = command.output().map_err(|error| cannot_start(command, &error))?;
    check(command, output.status)?;
    text(command, output.stdout)
}

/// Runs a program that might hang, and answers with what it printed. All that it printed is part of the error where it
/// fails.
///
/// # Errors
/// As [`capture`], and where the program has not ended within `limit`; it is then killed.
pub(crate) fn capture_within(command: &mut Command, limit: Duration) -> Result<String> {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|error| cannot_start(command, &error))?;
    // Read beside the waiting: a program whose pipe is full waits for its reader.
    let stdout = read(child.stdout.take());
    let stderr = read(child.stderr.take());
    let status = wait(&mut child, limit);
    let stdout = text(command, collect(stdout))?;
    let problem = match status {
        Ok(Some(status)) if status.success() => return Ok(stdout),
        Ok(Some(status)) => format!("ended with {status}"),
        Ok(None) => format!("did not end within {} s", limit.as_secs()),
        Err(error) => format!("cannot be waited for: {error}"),
    };
    let stderr = String::from_utf8_lossy(&collect(stderr)).into_owned();
    Err(format!("{} {problem}; it printed:\n{stdout}{stderr}", show(command)))
}

/// The first program of this name in the PATH.
pub(crate) fn find(name: &str) -> Option<PathBuf> {
    find_all(name).next()
}

/// The first program of this name in the PATH, which a package of Debian brings.
///
/// # Errors
/// There is none; the message says what to install.
pub(crate) fn tool(name: &str, package: &str) -> Result<PathBuf> {
    find(name).ok_or_else(|| format!("{name} is not in the PATH; on Debian `apt-get install {package}`"))
}

/// Every program of this name in the PATH, in its order.
pub(crate) fn find_all(name: &str) -> impl Iterator<Item = PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    folders.into_iter().map(move |folder| folder.join(name)).filter(|program| program.is_file())
}

fn wait(child: &mut Child, limit: Duration) -> std::io::Result<Option<ExitStatus>> {
    let end = Instant::now() + limit;
    while Instant::now() < end {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        thread::sleep(Duration::from_millis(10));
    }
    child.kill()?;
    child.wait()?;
    Ok(None)
}

fn read(pipe: Option<impl Read + Send + 'static>) -> JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // A pipe that breaks shows what came before.
        _ = pipe.map(|mut pipe| pipe.read_to_end(&mut bytes));
        bytes
    })
}

fn collect(reader: JoinHandle<Vec<u8>>) -> Vec<u8> {
    reader.join().unwrap_or_default()
}

fn text(command: &Command, bytes: Vec<u8>) -> Result<String> {
    String::from_utf8(bytes).map_err(|error| format!("the output of {} is not UTF-8: {error}", show(command)))
}

fn check(command: &Command, status: ExitStatus) -> Result {
    if status.success() { Ok(()) } else { Err(format!("{} ended with {status}", show(command))) }
}

fn cannot_start(command: &Command, error: &std::io::Error) -> String {
    format!("cannot start {}: {error}", show(command))
}

fn show(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    let words: Vec<_> = words.map(OsStr::to_string_lossy).collect();
    format!("`{}`", words.join(" "))
}
