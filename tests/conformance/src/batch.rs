//! What the crates written by `cargo xtask conformance` run: every chart beside the interpreter.

use std::panic::{self, AssertUnwindSafe};
use std::time::Duration;

use grafcet_compiler::analysis::{Facts, Races};
use grafcet_compiler::plan::Plan;

use crate::oracle::Interpreted;
use crate::reader::{self, Line};
use crate::{Entry, asleep, chart, play, recorded};

/// What is asked of a recorded chart: that it goes on when it is restored, and that its record shows what it did.
pub type Checks = (&'static str, [recorded::Check; 2]);

/// Plays all entries and prints, for each, `== name verdict`, and below it what differs with the shortest timeline
/// found that shows it.
pub fn main(entries: &[Entry], recorded: &[Checks]) {
    // The panic is part of the report, not of the console.
    panic::set_hook(Box::new(|_| ()));
    for entry in entries {
        match report(entry, recorded) {
            Ok(None) => println!("== {} same", entry.name),
            Ok(Some((kind, difference))) => println!("== {} {kind}\n{difference}", entry.name),
            Err(error) => println!("== {} broken\n{error}", entry.name),
        }
    }
}

/// Runs each chart for so many cycles, or so long, and prints for each `== name soaked` and its cycles, those compared and its ticks; or what differs.
pub fn soak(entries: &[(Entry, recorded::Soak)], cycles: u64, time: Duration) {
    panic::set_hook(Box::new(|_| ()));
    for (entry, soak) in entries {
        let mut done = recorded::Done::default();
        let ran = guarded(|| {
            let case = reader::read(entry.text)?;
            done = soak(&chart::resolve(&case.chart)?, cycles, time)?;
            Ok(())
        });
        match ran {
            Ok(()) => println!("== {} soaked\n{} {} {}", entry.name, done.cycles, done.compared, done.ticks),
            Err(error) => println!("== {} differs\n{error}", entry.name),
        }
    }
}

/// The kind of the difference, and its description.
type Found = Option<(&'static str, String)>;

fn report(entry: &Entry, recorded: &[Checks]) -> Result<Found, String> {
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
    if let Some((_, checks)) = recorded.iter().find(|(name, _)| *name == entry.name) {
        for (kind, check) in ["restored", "recorded"].into_iter().zip(checks) {
            let play = |lines: &[Line]| guarded(|| check(&model, &case.chart, lines));
            if let Err(message) = play(&case.lines) {
                return Ok(Some((kind, shortened(&case.lines, message, play))));
            }
        }
    }
    if !Plan::of(&model, &Facts::of(&model), &Races::default()).memory.time {
        return Ok(None);
    }
    let sleeping = |lines: &[Line]| {
        guarded(|| asleep::compare(&mut *(entry.subject)(), &mut *(entry.subject)(), lines).map_err(|d| d.to_string()))
    };
    Ok(sleeping(&case.lines).err().map(|message| ("deadline", shortened(&case.lines, message, sleeping))))
}

fn guarded(run: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
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
