//! A chart that runs, compiled or interpreted. It knows neither the compiler nor the interpreter, so that `cargo xtask plant` builds it alone.

use std::collections::{BTreeMap, BTreeSet};

pub use crate::reader::Expected as Shown;

/// Values by name; `true` is 1, times are in ticks.
pub type Values = BTreeMap<String, i128>;

/// What may be said of the next cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Rest {
    /// It has something to do without an input and without time: "at once" is the only right answer.
    Goes,
    /// It would do nothing; but the one that has run did something, so another look may be asked for.
    Looks,
    /// It would do nothing, as the one that has run.
    Sleeps,
}

/// A chart that runs: compiled or interpreted.
pub trait Subject {
    /// One cycle; inputs that are not named are false or zero.
    ///
    /// # Errors
    /// The interpreter does not understand the chart, or the chart's own arithmetic fails.
    fn cycle(&mut self, inputs: &Values, now: u32) -> Result<Shown, String>;

    /// A cycle that leads into a situation by hand; `None` where the chart refuses it.
    ///
    /// # Errors
    /// As for [`Subject::cycle`], or the chart cannot be forced.
    fn force(&mut self, steps: &BTreeSet<String>, inputs: &Values, now: u32) -> Result<Option<Shown>, String> {
        let _ = (steps, inputs, now);
        Err("the chart cannot be forced".to_owned())
    }

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
