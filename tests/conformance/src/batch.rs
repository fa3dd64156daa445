//! What the crates written by `cargo xtask conformance` run: every chart beside the interpreter.

use std::panic::{self, AssertUnwindSafe};
use std::time::Duration;

use crate::oracle::Interpreted;
use crate::reader::{self, Line};
use crate::recorded::{self, Long, Traces};
use crate::{Entry, asleep, chart, fragments, play};

/// What is asked of a recorded chart: that it goes on when it is restored, that its record shows what it did, and that for a longer time it is the same.
pub type Checks = (&'static str, [recorded::Check; 2], recorded::Soak);

/// Plays all entries and prints, for each, `== name verdict`, and below it what differs with the shortest timeline
/// found that shows it; of a recorded chart that is the same, how many traces its source has shown, and how many of them not as a whole.
pub fn main(entries: &[Entry], recorded: &[Checks]) {
    // The panic is part of the report, not of the console.
    panic::set_hook(Box::new(|_| ()));
    for entry in entries {
        let mut traces = Traces::default();
        match report(entry, recorded, &mut traces) {
            Ok(None) => println!("== {} same\n{} {}", entry.name, traces.all, traces.untold),
            Ok(Some((kind, difference))) => println!("== {} {kind}\n{difference}", entry.name),
            Err(error) => println!("== {} broken\n{error}", entry.name),
        }
    }
}

/// Runs each chart for so many cycles, or so long, and prints for each `== name soaked` and what was done, as numbers; or what differs.
pub fn soak(entries: &[(Entry, recorded::Soak)], cycles: u64, time: Duration) {
    panic::set_hook(Box::new(|_| ()));
    for (entry, soak) in entries {
        let mut done = recorded::Done::default();
        let ran = guarded(|| {
            let case = reader::read(entry.text)?;
            done = soak(&parsed(&case.chart)?, Long::new(cycles, time))?;
            Ok(())
        });
        match ran {
            Ok(()) => println!("== {} soaked\n{}", entry.name, done.line()),
            Err(error) => println!("== {} differs\n{error}", entry.name),
        }
    }
}

fn parsed(text: &str) -> Result<grafcet_sim::Chart, String> {
    grafcet_sim::Chart::parse(text).map_err(|refused| refused.to_string())
}

/// The kind of the difference, and its description.
type Found = Option<(&'static str, String)>;

fn report(entry: &Entry, recorded: &[Checks], traces: &mut Traces) -> Result<Found, String> {
    let case = reader::read(entry.text)?;
    let model = chart::resolve(&case.chart)?;
    let lockstep = |lines: &[Line]| {
        guarded(|| {
            let mut oracle = Interpreted::new(&model)?;
            play::in_lockstep(&mut *(entry.subject)(), &mut oracle, lines).map_err(|d| d.to_string())
        })
    };
    if let Err(message) = lockstep(&case.lines) {
        let kind = if message.contains("no error of the interpreter") { "interpreter" } else { "lockstep" };
        return Ok(Some((kind, shortened(&case.lines, message, lockstep))));
    }
    if let Some((_, checks, soak)) = recorded.iter().find(|(name, ..)| *name == entry.name) {
        for (kind, check) in ["restored", "recorded"].into_iter().zip(checks) {
            let play = |lines: &[Line]| guarded(|| check(&model, &case.chart, lines));
            match play(&case.lines) {
                Ok(shown) => *traces = shown,
                Err(message) => {
                    let played = |lines: &[Line]| play(lines).map(drop);
                    return Ok(Some((kind, shortened(&case.lines, message, played))));
                }
            }
        }
        // With fragments it is another one than its source.
        if fragments::plain(&case.chart) == case.chart {
            let soaked = guarded(|| soak(&parsed(&case.chart)?, Long::SHORT));
            if let Err(message) = soaked {
                return Ok(Some(("soak", message)));
            }
        }
    }
    if !model.uses_time() {
        return Ok(None);
    }
    let sleeping = |lines: &[Line]| {
        guarded(|| asleep::compare(&mut *(entry.subject)(), &mut *(entry.subject)(), lines).map_err(|d| d.to_string()))
    };
    Ok(sleeping(&case.lines).err().map(|message| ("deadline", shortened(&case.lines, message, sleeping))))
}

fn guarded<T>(run: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    panic::catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<String>().cloned();
        let text = text.or_else(|| payload.downcast_ref::<&str>().map(|text| (*text).to_owned()));
        Err(format!("panic: {}", text.unwrap_or_default()))
    })
}

/// Leaves lines out of a timeline as long as a difference stays; the difference and the timeline.
fn shortened(lines: &[Line], message: String, play: impl Fn(&[Line]) -> Result<(), String>) -> String {
    let (mut lines, mut message) = (lines.to_vec(), message);
    let mut size = lines.len().div_ceil(2);
    while size > 0 {
        let mut start = 0;
        let mut shorter = false;
        while start < lines.len() {
            let end = (start + size).min(lines.len());
            let rest = [&lines[..start], &lines[end..]].concat();
            match play(&rest) {
                Err(error) => {
                    (lines, message, shorter) = (rest, error, true);
                }
                Ok(()) => start = end,
            }
        }
        size = if size == 1 && shorter { 1 } else { size / 2 };
    }
    let timeline: Vec<String> = lines.iter().map(|line| format!("{}: {}", line.number, line.text())).collect();
    format!("{message}\n  timeline\n    {}", timeline.join("\n    "))
}
