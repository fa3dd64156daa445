#![doc = include_str!("../README.md")]

mod args;
mod check;
mod coverage;
mod cycle;
mod diff;
mod draw;
mod export;
mod find;
mod import;
mod model;
mod output;
#[cfg(feature = "print")]
mod print;
mod prove;
mod replay;
mod report;
mod rerun;
mod simulate;
mod suite;
mod time;
#[cfg(feature = "watch")]
mod watch;

use std::ffi::OsString;
use std::fmt;
use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

use args::{Args, Command};

/// Runs the tool with the arguments of a command line, the program's name first; `grafcet` after it, with which cargo calls its
/// plugins, is left out.
///
/// The exit code is 0 where all is well, 1 where something is wrong with a chart, and 2 where what was asked for could not be done: there is no
/// such file, or no such chart.
#[must_use]
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let mut arguments: Vec<OsString> = arguments.into_iter().collect();
    if arguments.get(1).is_some_and(|word| word == "grafcet") {
        arguments.remove(1);
    }
    let args = match Args::try_parse_from(arguments) {
        Ok(args) => args,
        // Help is no mistake.
        Err(error) => {
            let code = if error.use_stderr() { 2 } else { 0 };
            // Where nobody reads, nothing can be said.
            _ = error.print();
            return ExitCode::from(code);
        }
    };
    args.color.write_global();
    let done = match &args.command {
        Command::Check(options) => check::run(options),
        Command::Draw(options) => draw::run(options),
        Command::Diff(options) => diff::run(options),
        Command::Export(options) => export::run(options),
        Command::Import(options) => import::run(options),
        Command::Simulate(options) => simulate::run(options),
        Command::Replay(options) => replay::run(options),
        Command::Coverage(options) => coverage::run(options),
        Command::Tests(options) => suite::run(options),
        Command::Prove(options) => prove::run(options),
        #[cfg(feature = "watch")]
        Command::Watch(options) => watch::run(options),
    };
    match done {
        Ok(Outcome::Well) | Err(Failure::Silent) => ExitCode::SUCCESS,
        Ok(Outcome::Wrong) => ExitCode::from(1),
        Err(failure) => {
            complain(&failure.to_string());
            ExitCode::from(2)
        }
    }
}

/// How a command has ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Outcome {
    Well,
    /// Something is wrong with a chart, and has been said.
    Wrong,
}

impl Outcome {
    fn wrong_if(wrong: bool) -> Self {
        if wrong { Self::Wrong } else { Self::Well }
    }
}

/// Why a command could not be done.
#[derive(Debug)]
enum Failure {
    /// In one sentence.
    Said(String),
    /// At a place in a file, as it is shown.
    Shown(String),
    /// Whoever reads the output has read enough of it, as `head` does.
    Silent,
}

impl Failure {
    /// A file with which something cannot be done.
    fn file(path: &std::path::Path, error: &std::io::Error) -> Self {
        Self::Said(format!("{}: {error}", path.display()))
    }

    /// The output cannot be written.
    fn output(error: &std::io::Error) -> Self {
        match error.kind() {
            std::io::ErrorKind::BrokenPipe => Self::Silent,
            _ => Self::Said(format!("the output cannot be written: {error}")),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Said(sentence) => {
                let error = anstyle::AnsiColor::BrightRed.on_default().bold();
                write!(f, "{error}error{error:#}: {sentence}")
            }
            Self::Shown(text) => f.write_str(text),
            Self::Silent => Ok(()),
        }
    }
}

/// Writes to the output of the program, without colours where that is no terminal.
fn say(text: &str) -> Result<(), Failure> {
    anstream::stdout().write_all(text.as_bytes()).map_err(|error| Failure::output(&error))
}

/// Writes a line beside the output.
fn complain(text: &str) {
    // Where nobody reads, nothing can be said.
    _ = writeln!(anstream::stderr(), "{text}");
}
