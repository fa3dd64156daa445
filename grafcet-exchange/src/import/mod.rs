//! From the notations of PLC tools to Rust source with charts in it.
//!
//! - `source`: a chart as it stands in a file; `textual` and `xml` read it there, with `lexer`, `parser` and `statement` for structured text, `drawing` (and `codesys`) for what
//!   is connected with what, and `drawn` for networks that are a condition
//! - `names`: names that Rust takes
//! - `types`, `enums`: enums that a file declares, and their values
//! - `expr`, `parts`, `functions`, `block`: conditions, values, functions and statements in Rust
//! - `blocks`: standard function blocks that are written out; `timers`: those of some steps alone; `walk`: what statements read and write
//! - `facts`: what the variables of a program are: who writes them, which of them only remember what was before
//! - `actions`, `drives`: what steps do, as a person would have written it
//! - `rust`, `declare`: a chart as source

mod actions;
mod block;
mod blocks;
mod codesys;
mod declare;
mod drawing;
mod drawn;
mod drives;
mod enums;
mod expr;
mod facts;
mod functions;
mod lexer;
mod names;
mod parser;
mod parts;
mod rust;
mod source;
mod statement;
mod textual;
mod timers;
mod types;
mod walk;
mod xml;

use std::fmt;
use std::ops::Range;

use source::Pou;

/// Why a file cannot be read, and where.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Wrong {
    /// In bytes of the file.
    pub at: Range<usize>,
    /// What is wrong, on one line.
    pub message: String,
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Wrong {}

/// A file of Rust with the charts that another one holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Imported {
    /// Rust with a call of `grafcet!` for each chart, and functions that a person has to write.
    pub rust: String,
    /// In the order of the file.
    pub charts: Vec<Chart>,
}

/// One chart of it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Chart {
    /// In Rust.
    pub name: String,
    /// What has another name than in the file: both names.
    pub renamed: Vec<(String, String)>,
    /// What is not there, is a stub, or does something a little different, with its place in the file.
    pub notes: Vec<Wrong>,
}

/// The charts of a file of PLCopen XML or of the textual form of SFC, in Rust.
///
/// What has no translation is a stub with its text: a code action, or a function that a transition asks. `file` is how the file is called in the
/// source.
///
/// # Errors
/// The file is none of either notation, or there is no SFC in it.
pub fn import(text: &str, file: &str) -> Result<Imported, Wrong> {
    let begin = text.trim_start_matches('\u{feff}').trim_start();
    if let Some(wrong) = elsewhere(text) {
        return Err(wrong);
    }
    let (mut pous, types) =
        if begin.starts_with('<') { (xml::pous(text)?, types::of_xml(text)) } else { textual::pous(text)? };
    types::settle(&mut pous, types)?;
    // That a file says how it is called is no news in another one.
    for pou in &mut pous {
        pou.notes.retain(|line| line != file);
    }
    let mut charts = Vec::new();
    let mut sources = Vec::new();
    for pou in pous.iter().filter(|pou| !pou.steps.is_empty()) {
        let (chart, source) = rust::chart(pou, &pous)?;
        charts.push(chart);
        sources.push(source);
    }
    if charts.is_empty() {
        let (at, what) = pous.first().map_or((0..0, "no program"), |pou: &Pou| (pou.at.clone(), "no SFC"));
        return Err(Wrong { at, message: format!("there is {what} in this file: no step") });
    }
    Ok(Imported { rust: rust::file(file, &charts, &sources), charts })
}

/// Files in which tools keep their projects, whose drawings nobody else reads.
fn elsewhere(text: &str) -> Option<Wrong> {
    const ROOTS: [(&str, &str); 3] = [
        ("TcPlcObject", "a POU as TwinCAT keeps it; export it as PLCopen XML (in the context menu of the PLC project)"),
        ("ExportFile", "an export of CODESYS in its own format; export it as PLCopen XML (Project, Export PLCopenXML)"),
        ("RSLogix5000Content", "a project of Logix Designer, which writes no PLCopen XML: its SFC is not read"),
    ];
    let begin = text.find(|letter: char| !letter.is_whitespace() && letter != '\u{feff}')?;
    let root = text.match_indices('<').find(|(at, _)| !text[at + 1..].starts_with(['?', '!']))?.0;
    if !text[begin..].starts_with('<') {
        return None;
    }
    let (name, what) = ROOTS.into_iter().find(|(name, _)| text[root + 1..].starts_with(name))?;
    Some(Wrong { at: root..root + 1 + name.len(), message: format!("this is {what}") })
}
