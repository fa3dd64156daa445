//! What the examples share: their command line and the way a run is shown.

mod timeline;

use std::ffi::OsString;
use std::fmt;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use anstyle::Style;
use grafcet::description::Description;

pub(crate) use timeline::Timeline;

use super::script::PlayError;

/// What the examples print has lines of so many characters at most, whatever the terminal.
const COLUMNS: u16 = 80;
const BOLD: Style = Style::new().bold();

/// An example as its command line knows it.
pub(crate) struct Example {
    /// What follows `cargo run --example`.
    pub(crate) name: &'static str,
    /// What it shows, in a sentence for `--help`.
    pub(crate) about: &'static str,
    /// Its charts, which are drawn above the timeline.
    pub(crate) charts: &'static [&'static Description<'static>],
    /// Runs the chart on its model of the plant and shows the timeline.
    pub(crate) show: fn(&mut dyn Write) -> io::Result<()>,
    /// Plays a script and writes plain lines.
    pub(crate) play: for<'s> fn(&'s str, &mut dyn fmt::Write) -> Result<(), PlayError<'s>>,
}

/// Why an example ended before its end.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command line or the script asks for what there is not; the message is for the user.
    Usage(String),
    /// What it shows could not be written.
    Output(io::Error),
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Output(error)
    }
}

impl Failure {
    /// The exit status and what to tell the user.
    pub(crate) fn verdict(self) -> (u8, Option<String>) {
        match self {
            Self::Usage(message) => (2, Some(message)),
            // The reader has seen enough, as `head` has.
            Self::Output(error) if error.kind() == io::ErrorKind::BrokenPipe => (0, None),
            Self::Output(error) => (1, Some(format!("cannot write: {error}"))),
        }
    }
}

impl Example {
    /// The whole program.
    pub(crate) fn main(&self) -> ExitCode {
        let arguments = std::env::args_os().skip(1).collect();
        let Err(failure) = self.run(arguments, &mut anstream::stdout().lock()) else { return ExitCode::SUCCESS };
        let (status, message) = failure.verdict();
        if let Some(message) = message {
            // Where nobody reads the errors either, the exit status says it.
            _ = writeln!(io::stderr(), "error: {message}");
        }
        ExitCode::from(status)
    }

    /// The program without its process: what it prints goes to `out`.
    pub(crate) fn run(&self, arguments: Vec<OsString>, out: &mut dyn Write) -> Result<(), Failure> {
        let mut arguments = arguments.into_iter();
        let Some(first) = arguments.next() else {
            self.draw(out)?;
            return Ok((self.show)(out)?);
        };
        let rest: Vec<OsString> = arguments.collect();
        match (first.to_str(), &rest[..]) {
            (Some("--help" | "-h"), []) => Ok(out.write_all(self.usage().as_bytes())?),
            (Some("--chart"), []) => Ok(self.draw(out)?),
            (Some("--script"), [file]) => self.play(file.as_ref(), out),
            (Some("--script"), []) => Err(self.wrong("`--script` needs a file after it")),
            (Some("--help" | "-h" | "--chart" | "--script"), [.., surplus]) => Err(self.unexpected(surplus)),
            _ => Err(self.unexpected(&first)),
        }
    }

    fn draw(&self, out: &mut dyn Write) -> io::Result<()> {
        self.charts.iter().try_for_each(|chart| {
            writeln!(out, "{BOLD}{}{BOLD:#}", chart.name)?;
            writeln!(out, "{}", grafcet_draw::text_within(chart, &(), COLUMNS))
        })
    }

    fn play(&self, file: &Path, out: &mut dyn Write) -> Result<(), Failure> {
        let in_file = |error: &dyn fmt::Display| Failure::Usage(format!("{}: {error}", file.display()));
        let script = std::fs::read_to_string(file).map_err(|error| in_file(&error))?;
        let mut lines = String::new();
        let played = (self.play)(&script, &mut lines);
        out.write_all(lines.as_bytes())?;
        played.map_err(|error| in_file(&error))
    }

    fn unexpected(&self, argument: &OsString) -> Failure {
        self.wrong(&format!("unexpected argument `{}`", argument.to_string_lossy()))
    }

    fn wrong(&self, message: &str) -> Failure {
        Failure::Usage(format!("{message}\n\n{}", self.usage().trim_end()))
    }

    fn usage(&self) -> String {
        let Self { name, about, .. } = self;
        format!(
            "\
{about}

Usage: cargo run --example {name} [-- --chart | --script FILE]

Without arguments: draws the chart and runs it on a model of its plant, one line
per cycle.

  --chart        draws the chart and ends
  --script FILE  instead of the model, takes the inputs from FILE and prints
                 plain lines. FILE has one line per cycle, with the names of the
                 inputs that are true (`-` or an empty line: none) and numbers
                 as `level=300`; `@1500` is what the clock reads from then on;
                 `#` begins a comment line
  --help         this text
"
        )
    }
}
