//! `prove --with`: another checker, asked by files.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use grafcet_prove::checker::{Answer, Question};

use super::progress::Progress;
use crate::Failure;

/// From one look at the command to the next.
const LOOK: Duration = Duration::from_millis(10);

/// So much of what a command has written is shown where it says nothing that is understood.
const LINES: usize = 5;

/// A command that answers questions.
pub(crate) struct Checker {
    /// As it was given.
    pub(crate) command: String,
    words: Vec<String>,
}

/// What stands in a command for a file.
const FILES: [(&str, &str); 3] = [("{aig}", "circuit.aig"), ("{aag}", "circuit.aag"), ("{btor2}", "circuit.btor2")];
const WITNESS: (&str, &str) = ("{witness}", "witness");

/// The files of one question, which are gone with it.
struct Files {
    folder: tempfile::TempDir,
}

impl Files {
    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn create(&self, name: &str) -> Result<File, Failure> {
        let path = self.path(name);
        File::create(&path).map_err(|error| Failure::file(&path, &error))
    }

    /// What a command has written, also where it is no text.
    fn text(&self, name: &str) -> String {
        fs::read(self.path(name)).map_or_else(|_| String::new(), |bytes| String::from_utf8_lossy(&bytes).into_owned())
    }
}

impl Checker {
    /// By its command line, whose words are as those of a shell.
    pub(crate) fn new(command: &str) -> Result<Self, Failure> {
        let wrong = |what: &str| Failure::Said(format!("--with `{command}`: {what}"));
        let mut words = shlex::split(command).ok_or_else(|| wrong("a quotation mark is not closed"))?;
        if words.is_empty() {
            return Err(wrong("there is no command"));
        }
        if !FILES.iter().any(|(name, _)| words.iter().any(|word| word.contains(name))) {
            words.push(FILES[0].0.to_owned());
        }
        Ok(Self { command: command.to_owned(), words })
    }

    /// What it says, where it has said so until then.
    pub(crate) fn ask(
        &self,
        question: &Question<'_, '_>,
        until: Instant,
        progress: Option<&Progress>,
    ) -> Result<Answer, Failure> {
        let folder = tempfile::tempdir()
            .map_err(|error| Failure::Said(format!("there is no folder for the circuit: {error}")))?;
        let files = Files { folder };
        let child = self.start(question, &files)?;
        match self.end(child, until, progress)? {
            Some(status) => self.said(question, &files, status),
            None => Ok(Answer::Open(format!("`{}` was stopped at the limit", self.command))),
        }
    }

    fn start(&self, question: &Question<'_, '_>, files: &Files) -> Result<Child, Failure> {
        let mut words = self.words.clone();
        for (place, name) in FILES.into_iter().chain([WITNESS]) {
            let path = files.path(name);
            let mut asks = false;
            for word in words.iter_mut().filter(|word| word.contains(place)) {
                *word = word.replace(place, &path.display().to_string());
                asks = true;
            }
            if !asks || place == WITNESS.0 {
                continue;
            }
            let bytes = match place {
                "{aig}" => question.aiger(),
                "{aag}" => question.aiger_text().into_bytes(),
                _ => question.btor2().into_bytes(),
            };
            fs::write(&path, bytes).map_err(|error| Failure::file(&path, &error))?;
        }
        // In files and not through pipes, which a program that outlives the command would hold open.
        let (out, err) = (files.create("stdout")?, files.create("stderr")?);
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]).stdin(Stdio::null()).stdout(out).stderr(err);
        command.spawn().map_err(|error| {
            Failure::Said(format!("--with `{}`: `{}` cannot be started: {error}", self.command, words[0]))
        })
    }

    /// None where it was stopped.
    fn end(
        &self,
        mut child: Child,
        until: Instant,
        progress: Option<&Progress>,
    ) -> Result<Option<ExitStatus>, Failure> {
        let failed = |error: std::io::Error| Failure::Said(format!("--with `{}`: {error}", self.command));
        loop {
            if let Some(status) = child.try_wait().map_err(failed)? {
                return Ok(Some(status));
            }
            if Instant::now() >= until {
                // It may have ended by itself meanwhile.
                _ = child.kill();
                child.wait().map_err(failed)?;
                return Ok(None);
            }
            if let Some(progress) = progress {
                progress.waits_for(&self.command);
            }
            thread::sleep(LOOK);
        }
    }

    /// In the file that it was told of, else on its output.
    fn said(&self, question: &Question<'_, '_>, files: &Files, status: ExitStatus) -> Result<Answer, Failure> {
        let (witness, out) = (files.text(WITNESS.1), files.text("stdout"));
        let mut wrong = None;
        for text in [&witness, &out].into_iter().filter(|text| !text.trim().is_empty()) {
            match question.read(text) {
                Ok(answer) => return Ok(answer),
                Err(what) => wrong = wrong.or(Some(what)),
            }
        }
        let what = wrong.unwrap_or_else(|| "it has written nothing".to_owned());
        let err = files.text("stderr");
        let last = last(if err.trim().is_empty() { &out } else { &err });
        Err(Failure::Said(format!(
            "--with `{}` ({status}): what it says is not understood: {what}; it has to write a witness of AIGER or BTOR2, to its output or to the file \
             `{{witness}}`{last}",
            self.command
        )))
    }
}

/// The last lines, each on its own.
fn last(text: &str) -> String {
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    lines[lines.len().saturating_sub(LINES)..].iter().fold(String::new(), |all, line| all + "\n  | " + line)
}

/// The name of a command is enough where somebody reads it in a sentence.
pub(crate) fn name(command: &str) -> String {
    let first = shlex::split(command).and_then(|words| words.into_iter().next()).unwrap_or_default();
    Path::new(&first).file_name().map_or(first.clone(), |name| name.to_string_lossy().into_owned())
}
