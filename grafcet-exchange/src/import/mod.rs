//! From the notations of PLC tools to Rust source with charts in it.
//!
//! - `source`: a chart as it stands in a file; `textual` and `xml` read it there, with `lexer` and `parser` for structured text, `drawing` for what
//!   is connected with what, and `drawn` for networks that are a condition
//! - `names`: names that Rust takes
//! - `expr`, `parts`: conditions, values and statements in Rust
//! - `facts`: what the variables of a program are: who writes them, which of them only remember what was before
//! - `actions`, `drives`: what steps do, as a person would have written it
//! - `rust`, `declare`: a chart as source

mod actions;
mod declare;
mod drawing;
mod drawn;
mod drives;
mod expr;
mod facts;
mod lexer;
mod names;
mod parser;
mod parts;
mod rust;
mod source;
mod textual;
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
    let mut pous = if begin.starts_with('<') { xml::pous(text)? } else { textual::pous(text)? };
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
