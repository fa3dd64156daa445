//! Conformance: what generated code does, cycle by cycle, beside what was worked out by hand and what the interpreter
//! says.
//!
//! - the corpus: the `.chart` files of this folder, run by `cargo test`
//! - [`random`]: well-formed charts made from a number, run by `cargo xtask conformance`
//! - [`program`]: the naive programs of both beside the interpreter, without rustc
#![allow(clippy::format_collect, reason = "texts of a few lines; clearer than a loop that writes")]

pub mod asleep;
pub mod batch;
pub mod board;
pub mod brute;
pub mod chart;
pub mod emit;
pub mod fragments;
pub mod generated;
pub mod interp;
pub mod oracle;
pub mod play;
pub mod program;
pub mod random;
#[path = "../reader.rs"]
pub mod reader;
pub mod simpler;

use std::collections::BTreeMap;

pub use interp::Rest;
pub use reader::Expected as Shown;

/// Values by name; `true` is 1, times are in ticks.
pub type Values = BTreeMap<String, i128>;

/// A chart that runs: compiled or interpreted.
pub trait Subject {
    /// One cycle; inputs that are not named are false or zero.
    ///
    /// # Errors
    /// The interpreter does not understand the chart, or the chart's own arithmetic fails.
    fn cycle(&mut self, inputs: &Values, now: u32) -> Result<Shown, String>;

    /// The classic *Init*.
    ///
    /// # Errors
    /// As for [`Subject::cycle`].
    fn init(&mut self) -> Result<(), String>;

    /// Exchanges the named parameters; the others keep their values.
    ///
    /// # Errors
    /// As for [`Subject::cycle`].
    fn set_params(&mut self, changed: &Values) -> Result<(), String>;

    /// What the chart shows without a cycle; no calls.
    fn shown(&self) -> Shown;

    /// The generated `next_deadline`; `None` also for a chart without time.
    fn next_deadline(&self) -> Option<u32>;

    /// The interpreter's word on whether the last cycle left something to the next one; none where nobody asks for time.
    fn rest(&self) -> Option<Rest> {
        None
    }
}

/// A compiled chart with its text and its timeline.
pub struct Entry {
    /// How it is called in reports.
    pub name: &'static str,
    /// The file: chart, `---`, timeline.
    pub text: &'static str,
    /// Makes a new instance of the compiled chart.
    pub subject: fn() -> Box<dyn Subject>,
}
