//! `next_deadline`: a controller that sleeps until it, or until an input changes, behaves like one that scans at every tick.

use crate::play::Difference;
use crate::reader::{Kind, Line};
use crate::{Shown, Subject, Values};

/// The longest time between two lines of a timeline that is played tick by tick.
const LONGEST: u32 = 45;

/// A longer time than this is played as if it were the longest one: it is there for clocks that wrap.
const FAR: u32 = 1_000_000;

/// So many ticks about deadlines are scanned within one long time: what blinks has no last one.
const ABOUT_DEADLINES: u32 = 60;

/// The lines played; a timeline of ticks is many times as long as one of cycles.
const LINES: usize = 120;

/// The one that sleeps. What it shows and until when it sleeps changes with its own cycles alone, so that each is asked for once and
/// not at every tick.
struct Sleeper<'s> {
    subject: &'s mut dyn Subject,
    deadline: Option<u32>,
    /// Without calls; none where it has not been asked for yet.
    shown: Option<Shown>,
    /// What it was last scanned with.
    last: Option<(Values, u32)>,
}

impl<'s> Sleeper<'s> {
    fn new(subject: &'s mut dyn Subject) -> Self {
        Self { deadline: subject.next_deadline(), subject, shown: None, last: None }
    }

    /// Something has been done to it: with a cycle by these inputs and at this time, or without one.
    fn changed(&mut self, last: Option<(Values, u32)>) {
        self.deadline = self.subject.next_deadline();
        self.shown = None;
        self.last = last;
    }

    /// Whether it has to be scanned.
    fn is_due(&self, inputs: &Values, time: u32) -> bool {
        self.last.as_ref().is_none_or(|(before, then)| {
            let slept = time.wrapping_sub(*then);
            before != inputs || self.deadline.is_some_and(|deadline| deadline.wrapping_sub(*then) <= slept)
        })
    }

    fn shown(&mut self) -> &Shown {
        let subject = &self.subject;
        self.shown.get_or_insert_with(|| Shown { calls: Vec::new(), ..subject.shown() })
    }
}

/// Plays a timeline on two instances of one chart: `awake` is scanned at every tick, `asleep` only where an input or the recipe
/// changes and where its `next_deadline` says so.
///
/// # Errors
/// The first tick at which one shows other outputs or active steps, or calls that are not repetitions.
pub fn compare(asleep: &mut dyn Subject, awake: &mut dyn Subject, lines: &[Line]) -> Result<(), Difference> {
    let mut now = None;
    let mut asleep = Sleeper::new(asleep);
    let mut seen = vec![awake.shown().steps];
    for line in lines.iter().take(LINES) {
        let (inputs, then) = match &line.kind {
            Kind::Cycle { inputs, now, .. } => (inputs, *now),
            Kind::Force { asked, inputs, now: then, .. } => {
                let (steps, _) = asked.steps(&seen);
                // Nobody is asleep while somebody stands beside the machine: both are forced at once.
                let from = now.unwrap_or(*then);
                let time = from.wrapping_add(Moments::new(then.wrapping_sub(from), false).last);
                let expected = awake.force(&steps, inputs, time).map_err(|error| failure(line, time, &error, ""))?;
                let found = asleep.subject.force(&steps, inputs, time);
                let found = found.map_err(|error| failure(line, time, &error, ""))?;
                if let (Some(expected), Some(found)) = (expected, found) {
                    let (expected, found) = (without_repetitions(expected), without_repetitions(found));
                    if expected != found {
                        return Err(failure(line, time, &expected.to_string(), &found.to_string()));
                    }
                    now = Some(time);
                    asleep.changed(Some((inputs.clone(), time)));
                }
                continue;
            }
            Kind::Shows(_) | Kind::Wakes(_) | Kind::Refuses(_) => continue,
            Kind::Init => {
                let init = awake.init().and_then(|()| asleep.subject.init());
                init.map_err(|error| failure(line, 0, &error, ""))?;
                asleep.changed(None);
                continue;
            }
            Kind::Params(changed) => {
                let set = awake.set_params(changed).and_then(|()| asleep.subject.set_params(changed));
                set.map_err(|error| failure(line, 0, &error, ""))?;
                asleep.changed(None);
                continue;
            }
        };
        let from = now.unwrap_or(then);
        // An input changes in the instant of the line; until then the old ones hold.
        let mut held = asleep.last.as_ref().map_or_else(|| inputs.clone(), |(inputs, _)| inputs.clone());
        let mut moments = Moments::new(then.wrapping_sub(from), now.is_none());
        while let Some(moment) = moments.next(asleep.deadline.map(|deadline| deadline.wrapping_sub(from))) {
            let time = from.wrapping_add(moment);
            if moments.is_last(moment) {
                held.clone_from(inputs);
            }
            scan(awake, &mut asleep, &held, time, line)?;
            now = Some(time);
        }
        let shown = awake.shown();
        if shown.stable && !seen.contains(&shown.steps) {
            seen.push(shown.steps);
        }
    }
    Ok(())
}

/// When the one that is awake is scanned between two lines, in ticks since the first: at every tick, or, where the time is
/// long, in its first ticks and about each deadline.
struct Moments {
    /// The next one, if every tick is one.
    next: u32,
    last: u32,
    /// Ticks about deadlines that are still scanned.
    about_deadlines: u32,
    done: bool,
}

impl Moments {
    fn new(ticks: u32, at_once: bool) -> Self {
        let last = if ticks > FAR { LONGEST } else { ticks };
        // The instant of the line before has been scanned then.
        Self { next: u32::from(!at_once && last > 0), last, about_deadlines: ABOUT_DEADLINES, done: false }
    }

    fn is_last(&self, moment: u32) -> bool {
        moment == self.last
    }

    fn next(&mut self, deadline: Option<u32>) -> Option<u32> {
        if self.done {
            return None;
        }
        let mut moment = self.next.min(self.last);
        if moment > LONGEST / 2 && self.last > LONGEST {
            // Nothing changes until just before the deadline; a deadline that has passed is far away.
            let near = deadline.filter(|deadline| (moment..self.last).contains(&deadline.wrapping_sub(1)));
            let here = deadline.is_some_and(|deadline| moment.wrapping_sub(deadline) <= 1);
            moment = match near {
                _ if self.about_deadlines == 0 => self.last,
                _ if here => moment,
                Some(deadline) => deadline - 1,
                None => self.last,
            };
            self.about_deadlines = self.about_deadlines.saturating_sub(1);
        }
        self.next = moment.saturating_add(1);
        self.done = moment == self.last;
        Some(moment)
    }
}

fn scan(
    awake: &mut dyn Subject,
    asleep: &mut Sleeper<'_>,
    inputs: &Values,
    time: u32,
    line: &Line,
) -> Result<(), Difference> {
    let shown = awake.cycle(inputs, time).map_err(|error| failure(line, time, &error, ""))?;
    let expected = without_repetitions(shown);
    let due = asleep.is_due(inputs, time);
    let found = if due {
        let found = asleep.subject.cycle(inputs, time).map_err(|error| failure(line, time, &error, ""))?;
        asleep.changed(Some((inputs.clone(), time)));
        &without_repetitions(found)
    } else {
        asleep.shown()
    };
    if expected == *found {
        return Ok(());
    }
    let found = found.to_string();
    let state = format!("{found} (scanned: {due}, next deadline: {:?})", asleep.deadline);
    Err(failure(line, time, &expected.to_string(), &state))
}

fn without_repetitions(mut shown: Shown) -> Shown {
    shown.calls.retain(|call| !call.starts_with("repeated "));
    shown
}

fn failure(line: &Line, time: u32, expected: &str, found: &str) -> Difference {
    Difference { line: line.number, expected: format!("at tick {time}: {expected}"), found: found.to_owned() }
}
