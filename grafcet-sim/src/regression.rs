//! A record as a test: what a chart showed when it was recorded, beside what it does with the same inputs now.

use std::fmt::{self, Write as _};

use crate::chart::Chart;
use crate::replay::{Replay, ReplayError};
use crate::show::raised;
use crate::trace::Trace;

/// The chart does not do any more what it did when the record became a test.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Changed {
    /// The first cycle that differs.
    Cycle {
        /// Counted from zero.
        cycle: usize,
        /// Its time in ticks.
        now: u32,
        /// Its inputs that are neither false nor zero.
        inputs: String,
        /// What the chart showed then.
        expected: String,
        /// What it shows now.
        found: String,
    },
    /// The cycles are the same as far as they go, but there are more or fewer.
    Cycles {
        expected: usize,
        found: usize,
        /// What the replay says of it.
        why: String,
    },
    /// The record cannot be run with the chart as it is now: an input was renamed, or has another type.
    Replay(ReplayError),
    /// The file of what is expected is none, in this line.
    Expected(usize),
}

impl fmt::Display for Changed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cycle { cycle, now, inputs, expected, found } => write!(
                f,
                "cycle {cycle} at {now} with the inputs {inputs} is the first that differs\n  when recorded: {expected}\n  now:           {found}"
            ),
            Self::Cycles { expected, found, why } => {
                write!(f, "the record has shown {expected} cycles, and shows {found} now: {why}")
            }
            Self::Replay(error) => error.fmt(f),
            Self::Expected(line) => write!(f, "line {line} of what is expected was not written by `Trace::outside`"),
        }
    }
}

impl std::error::Error for Changed {}

impl Trace {
    /// What is seen from outside, as lines of text to be kept beside a record: active steps, outputs and calls of each cycle in which they are others than in the one
    /// before; at the end the number of cycles.
    #[must_use]
    pub fn outside(&self) -> String {
        let mut text = String::new();
        for (cycle, shown) in self.changes() {
            _ = writeln!(text, "{cycle} {shown}");
        }
        _ = writeln!(text, "{} cycles", self.cycles.len());
        text
    }

    /// The cycles in which it changes what is seen.
    fn changes(&self) -> Vec<(usize, String)> {
        let mut changes: Vec<(usize, String)> = Vec::new();
        for (index, cycle) in self.cycles.iter().enumerate() {
            let shown = self.seen(cycle).join("; ").trim_end().trim_end_matches("; calls").to_owned();
            if changes.last().is_none_or(|(_, last)| *last != shown) {
                changes.push((index, shown));
            }
        }
        changes
    }
}

impl Replay<'_> {
    /// Runs the record, or the frames, with the chart as it is now, and compares with what [`Trace::outside`] has kept of the chart as it was.
    ///
    /// # Errors
    /// The first cycle that differs.
    pub fn compare(&self, chart: &Chart, record: &[u8], expected: &str) -> Result<(), Changed> {
        let (expected, count) = read(expected)?;
        let trace = self.clone().even_if_changed().run_any(chart, record).map_err(Changed::Replay)?;
        let found = trace.changes();
        let first = (0..expected.len().max(found.len())).find(|at| expected.get(*at) != found.get(*at));
        if let Some(at) = first {
            let places = [&expected, &found].map(|all| all.get(at).map_or(usize::MAX, |(cycle, _)| *cycle));
            let cycle = places[0].min(places[1]);
            // Who changes nothing here shows what it showed before.
            let shown = |all: &[(usize, String)], place: usize| {
                let at = if place == cycle { Some(at) } else { at.checked_sub(1) };
                at.and_then(|at| all.get(at)).map_or_else(String::new, |(_, shown)| shown.clone())
            };
            if let Some(seen) = trace.cycles.get(cycle) {
                return Err(Changed::Cycle {
                    cycle,
                    now: seen.now,
                    inputs: raised(&trace.names.inputs, &seen.inputs),
                    expected: shown(&expected, places[0]),
                    found: shown(&found, places[1]),
                });
            }
        }
        if trace.cycles.len() == count {
            return Ok(());
        }
        Err(Changed::Cycles { expected: count, found: trace.cycles.len(), why: trace.warnings.join("; ") })
    }

    /// Runs what is a record in memory or frames of a wire.
    ///
    /// # Errors
    /// As of [`Replay::run`].
    pub fn run_any(&self, chart: &Chart, bytes: &[u8]) -> Result<Trace, ReplayError> {
        match self.run(chart, bytes) {
            Err(ReplayError::NoRecord) => self.frames(chart, bytes),
            other => other,
        }
    }
}

/// The changes, and the number of cycles.
fn read(expected: &str) -> Result<(Vec<(usize, String)>, usize), Changed> {
    let mut changes = Vec::new();
    for (index, line) in expected.lines().enumerate() {
        let wrong = || Changed::Expected(index + 1);
        let (number, shown) = line.split_once(' ').ok_or_else(wrong)?;
        let number = number.parse().map_err(|_| wrong())?;
        if shown == "cycles" {
            return Ok((changes, number));
        }
        changes.push((number, shown.to_owned()));
    }
    Err(Changed::Expected(expected.lines().count() + 1))
}

/// The text of a test of this name: the record in `name.record` and what is expected in `name.expected` beside it, the chart in `source`.
#[must_use]
pub fn test_of_record(name: &str, source: &str, chart: &str) -> String {
    format!(
        "//! Written from a record: `{chart}` does again what it did when it was recorded.\n\n\
         use grafcet_sim::{{Chart, Replay}};\n\n\
         #[test]\n\
         fn {name}() {{\n    \
             let chart = Chart::in_file(include_str!({source:?}), {chart:?}).expect(\"the chart\");\n    \
             let (record, expected) = (include_bytes!(\"{name}.record\"), include_str!(\"{name}.expected\"));\n    \
             if let Err(changed) = Replay::new().compare(&chart, record, expected) {{\n        \
                 panic!(\"{{changed}}\");\n    \
             }}\n\
         }}\n"
    )
}
