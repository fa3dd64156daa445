//! What is kept of a source: the last moments, in bounded memory, and how its line does.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use serde_json::{Value as Json, json};

use super::steer::{Asked, Controller};

/// So much memory the moments of a source take at most, however many are to be kept.
pub(crate) const MOST_BYTES: usize = 32 << 20;

/// A source as all viewers see it. The thread that reads it writes, the server looks.
pub(crate) struct Kept {
    /// What it is called on the page.
    pub(crate) label: String,
    /// The way back, where the tool was started with `--steer`.
    pub(crate) way: Option<Controller>,
    most: usize,
    inner: Mutex<Inner>,
}

#[derive(Default)]
struct Inner {
    chart: Option<Arc<str>>,
    /// How often the chart was another one: moments of different ones have nothing in common.
    epoch: u64,
    /// Each with its number. Of one whose place another has taken, the number is missing.
    moments: VecDeque<(u64, Moment)>,
    bytes: usize,
    /// The number of the next moment.
    next: u64,
    line: Line,
    /// How often anything of this was written.
    version: u64,
}

/// What a cycle has shown.
pub(crate) struct Moment {
    /// As the page reads it.
    pub(crate) text: Box<str>,
    /// It shows more than a time that has gone on.
    pub(crate) is_new: bool,
}

/// How a line does.
#[derive(Clone, Default)]
pub(crate) struct Line {
    /// `connected`
    pub(crate) state: String,
    /// Why it is not known what the chart does now.
    pub(crate) unknown: Option<String>,
    pub(crate) bytes: u64,
    pub(crate) frames: u64,
    pub(crate) damaged: u64,
    pub(crate) lost: u64,
    /// When the last whole frame came.
    pub(crate) heard: Option<Instant>,
}

/// How far a viewer has come.
#[derive(Default)]
pub(crate) struct Seen {
    /// None where there was more than it got at once.
    version: Option<u64>,
    epoch: Option<u64>,
    /// The first moment that it has not.
    next: u64,
    /// What had happened before it came: of that it gets all.
    before: Option<u64>,
}

/// So many moments a viewer gets at once of what happened before it came.
const MANY: usize = 500;
/// So many of what happens while it looks; where more happens, it gets the last of them.
pub(crate) const FEW: usize = 50;

impl Kept {
    pub(crate) fn new(label: String, most: usize, way: Option<Controller>) -> Self {
        Self { label, way, most, inner: Mutex::default() }
    }

    fn inner(&self) -> MutexGuard<'_, Inner> {
        // Nobody leaves it half written: there is nothing in here that panics.
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// From here on it is this chart, or none that is known.
    pub(crate) fn chart(&self, chart: Option<Arc<str>>) {
        let mut inner = self.inner();
        inner.epoch += 1;
        inner.chart = chart;
        inner.moments.clear();
        inner.bytes = 0;
        inner.version += 1;
    }

    pub(crate) fn line(&self, change: impl FnOnce(&mut Line)) {
        let mut inner = self.inner();
        change(&mut inner.line);
        inner.version += 1;
    }

    /// Adds moments, and forgets the oldest where there are too many. One in which nothing is new but the time takes the place of another such one.
    pub(crate) fn add(&self, moments: Vec<Moment>) {
        let mut guard = self.inner();
        let inner = &mut *guard;
        for moment in moments {
            let len = |gone: Option<(u64, Moment)>| gone.map_or(0, |(_, gone)| gone.text.len());
            if !moment.is_new && inner.moments.back().is_some_and(|(_, last)| !last.is_new) {
                inner.bytes -= len(inner.moments.pop_back());
            }
            inner.bytes += moment.text.len();
            inner.moments.push_back((inner.next, moment));
            inner.next += 1;
            while inner.moments.len() > self.most || inner.bytes > MOST_BYTES && inner.moments.len() > 1 {
                inner.bytes -= len(inner.moments.pop_front());
            }
        }
        inner.version += 1;
    }

    /// Sends a command to the controller.
    ///
    /// # Errors
    /// Why it was not sent.
    pub(crate) fn steer(&self, asked: &Asked) -> Result<(), String> {
        let way = self.way.as_ref().ok_or("the tool was started without `--steer`")?;
        // Who does not see what happens does not steer.
        if self.inner().line.unknown.is_some() {
            return Err("what the chart does now is not known".to_owned());
        }
        let sent = way.send(asked);
        self.line(|_| {});
        sent
    }

    /// How many moments are kept, and how many bytes they take.
    #[cfg(test)]
    pub(crate) fn size(&self) -> (usize, usize) {
        let inner = self.inner();
        (inner.moments.len(), inner.bytes)
    }

    /// How often the line was written to.
    #[cfg(test)]
    pub(crate) fn line_now(&self) -> Line {
        self.inner().line.clone()
    }

    /// What a viewer has not seen yet, as the page reads it, and whether there is more at once; none where nothing is new.
    pub(crate) fn news(&self, place: usize, seen: &mut Seen) -> Option<(String, bool)> {
        let inner = self.inner();
        if seen.version == Some(inner.version) {
            return None;
        }
        let chart = if seen.epoch == Some(inner.epoch) {
            String::new()
        } else {
            seen.epoch = Some(inner.epoch);
            seen.next = 0;
            seen.before = Some(inner.next);
            let chart = inner.chart.as_deref().unwrap_or("null");
            format!(",\"chart\":{chart}")
        };
        let (moments, missed) = inner.unseen(seen);
        let more = seen.next < inner.next;
        seen.version = (!more).then_some(inner.version);
        let line = line(&inner.line);
        let steered = self.way.as_ref().map_or_else(String::new, |way| format!(",\"steered\":{}", way.shown()));
        Some((
            format!(
                "{{\"source\":{place},\"line\":{line}{chart}{steered},\"missed\":{missed},\"moments\":[{moments}]}}"
            ),
            more,
        ))
    }
}

impl Inner {
    /// The next moments for a viewer, and how many it has missed in front of them.
    fn unseen(&self, seen: &mut Seen) -> (String, u64) {
        let from = self.moments.partition_point(|(number, _)| *number < seen.next);
        let left = self.moments.len() - from;
        let (skip, most) = match seen.before {
            Some(before) if seen.next < before => (0, MANY),
            _ => {
                seen.before = None;
                (left.saturating_sub(FEW), FEW)
            }
        };
        // What was forgotten before it came, it has not missed.
        let first = self.moments.front().map_or(self.next, |(number, _)| *number);
        let forgotten = if seen.next == 0 { 0 } else { first.saturating_sub(seen.next) };
        let moments: Vec<&(u64, Moment)> = self.moments.iter().skip(from + skip).take(most).collect();
        seen.next = moments.last().map_or(self.next, |(number, _)| number + 1);
        let texts: Vec<&str> = moments.iter().map(|(_, moment)| &*moment.text).collect();
        (texts.join(","), forgotten + skip as u64)
    }
}

fn line(line: &Line) -> Json {
    json!({
        "state": line.state,
        "unknown": line.unknown,
        "bytes": line.bytes,
        "frames": line.frames,
        "damaged": line.damaged,
        "lost": line.lost,
        "heard": line.heard.map(|heard| heard.elapsed().as_millis()),
    })
}
