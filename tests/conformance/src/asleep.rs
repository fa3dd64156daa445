//! `next_deadline`: a controller that sleeps until it, or until an input changes, behaves like one that scans at every tick.

use crate::play::Difference;
use crate::reader::{Kind, Line};
use crate::{Shown, Subject, Values};

/// The longest time between two lines of a timeline that is played tick by tick; more shows nothing new.
const LONGEST: u32 = 45;

/// The lines played; a timeline of ticks is many times as long as one of cycles.
const LINES: usize = 120;

/// Plays a timeline on two instances of one chart: `awake` is scanned at every tick, `asleep` only where an input or the recipe
/// changes and where its `next_deadline` says so.
///
/// # Errors
/// The first tick at which one shows other outputs or active steps, or calls that are not repetitions.
pub fn compare(asleep: &mut dyn Subject, awake: &mut dyn Subject, lines: &[Line]) -> Result<(), Difference> {
    let mut now = None;
    // What the sleeper was last scanned with.
    let mut last: Option<(Values, u32)> = None;
    for line in lines.iter().take(LINES) {
        let (inputs, then) = match &line.kind {
            Kind::Cycle { inputs, now, .. } => (inputs, *now),
            Kind::Shows(_) => continue,
            Kind::Init => {
                awake.init().and_then(|()| asleep.init()).map_err(|error| failure(line, 0, &error, ""))?;
                last = None;
                continue;
            }
            Kind::Params(changed) => {
                let set = awake.set_params(changed).and_then(|()| asleep.set_params(changed));
                set.map_err(|error| failure(line, 0, &error, ""))?;
                last = None;
                continue;
            }
        };
        let from = now.unwrap_or(then);
        let ticks = then.wrapping_sub(from).min(LONGEST);
        // An input changes in the instant of the line; until then the old ones hold.
        for tick in 0..=ticks {
            let time = from.wrapping_add(tick);
            let held = last.as_ref().map(|(inputs, _)| inputs.clone()).filter(|_| tick < ticks);
            let inputs = held.unwrap_or_else(|| inputs.clone());
            if now == Some(time) && tick < ticks {
                continue;
            }
            scan(awake, asleep, &inputs, time, &mut last, line)?;
            now = Some(time);
        }
    }
    Ok(())
}

fn scan(
    awake: &mut dyn Subject,
    asleep: &mut dyn Subject,
    inputs: &Values,
    time: u32,
    last: &mut Option<(Values, u32)>,
    line: &Line,
) -> Result<(), Difference> {
    let shown = awake.cycle(inputs, time).map_err(|error| failure(line, time, &error, ""))?;
    let due = match &*last {
        None => true,
        Some((before, then)) => {
            let slept = time.wrapping_sub(*then);
            before != inputs || asleep.next_deadline().is_some_and(|deadline| deadline.wrapping_sub(*then) <= slept)
        }
    };
    let found = if due {
        *last = Some((inputs.clone(), time));
        asleep.cycle(inputs, time).map_err(|error| failure(line, time, &error, ""))?
    } else {
        Shown { calls: Vec::new(), ..asleep.shown() }
    };
    let (expected, found) = (without_repetitions(shown), without_repetitions(found));
    if expected == found {
        return Ok(());
    }
    let state = format!("{found} (scanned: {due}, next deadline: {:?})", asleep.next_deadline());
    Err(failure(line, time, &expected.to_string(), &state))
}

fn without_repetitions(mut shown: Shown) -> Shown {
    shown.calls.retain(|call| !call.starts_with("repeated "));
    shown
}

fn failure(line: &Line, time: u32, expected: &str, found: &str) -> Difference {
    Difference { line: line.number, expected: format!("at tick {time}: {expected}"), found: found.to_owned() }
}
