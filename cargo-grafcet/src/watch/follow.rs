//! From bytes to moments: frames are found, and the chart whose they are follows them.

use std::sync::Arc;
use std::time::Instant;

use grafcet_compiler::describe::with_description;
use grafcet_core::record::wire::{Decoder, Frame, Received};
use grafcet_sim::{Chart, Cycle, Live, Names, Replay, json};
use serde_json::json;

use super::kept::{Kept, Line, Moment};
use super::steer::Words;

/// The longest frames that are taken: of a chart with some hundred kilobytes of state.
const LONGEST: usize = 1 << 18;

/// Follows what one controller sends, whose chart is one of several.
pub(crate) struct Follower<'c> {
    decoder: Decoder<Vec<u8>>,
    controller: Controller<'c>,
}

struct Controller<'c> {
    charts: &'c [Chart],
    live: Option<Live<'c>>,
    /// What was sent last that is none of these charts.
    foreign: Option<u32>,
    clock: Clock,
    last: Option<(Cycle, Vec<String>)>,
}

/// From readings of a controller's clock to the time since the first one.
#[derive(Default)]
struct Clock {
    last: Option<u32>,
    elapsed: u64,
    begins: bool,
    /// The chart has begun anew (*Init*), and its clock has not.
    stands: bool,
}

impl Clock {
    /// Where the controller has started anew, so has its clock: how long that took nobody knows. On the page it is a tenth of a second.
    /// A chart after *Init* has no reading yet: that is no time of the clock.
    fn at(&mut self, reading: u32, tenth: u64) -> u64 {
        if std::mem::take(&mut self.stands) && reading == 0 && self.last.is_some() {
            return self.elapsed;
        }
        let since = match self.last.replace(reading) {
            Some(_) if self.begins => tenth,
            Some(last) => u64::from(reading.wrapping_sub(last)),
            None => 0,
        };
        self.begins = false;
        self.elapsed += since;
        self.elapsed
    }
}

impl<'c> Follower<'c> {
    pub(crate) fn new(charts: &'c [Chart]) -> Self {
        let controller = Controller { charts, live: None, foreign: None, clock: Clock::default(), last: None };
        Self { decoder: Decoder::new(vec![0; LONGEST]), controller }
    }

    /// What has come, as much as it is.
    pub(crate) fn bytes(&mut self, bytes: &[u8], kept: &Kept) {
        let mut came = Line { bytes: bytes.len() as u64, ..Line::default() };
        let mut moments = Vec::new();
        for byte in bytes {
            match self.decoder.byte(*byte) {
                None => {}
                Some(Ok(received)) => {
                    came.frames += 1;
                    came.lost += u64::from(received.lost);
                    came.heard = Some(Instant::now());
                    if self.controller.choose(&received) {
                        // Moments of another chart have nothing to do with what follows.
                        moments.clear();
                        self.controller.tell(kept);
                    }
                    if let (Some(Frame::Answer(answer)), Some(way)) = (received.frame, &kept.way) {
                        way.answered(&answer);
                    }
                    moments.extend(self.controller.frame(&received));
                }
                Some(Err(_)) => {
                    came.damaged += 1;
                    self.controller.lost("a frame was damaged");
                }
            }
        }
        kept.add(moments);
        if let (Some(way), Some(live)) = (&kept.way, &self.controller.live) {
            way.seen(live.number());
        }
        let unknown = self.controller.unknown();
        kept.line(|line| {
            line.bytes += came.bytes;
            line.frames += came.frames;
            line.damaged += came.damaged;
            line.lost += came.lost;
            line.heard = came.heard.or(line.heard);
            line.unknown = unknown;
        });
    }

    /// Whether what was sent last is none of the charts.
    pub(crate) fn is_foreign(&self) -> bool {
        self.controller.foreign.is_some()
    }

    /// The line was interrupted.
    pub(crate) fn interrupted(&mut self, reason: &str, kept: &Kept) {
        self.decoder = Decoder::new(vec![0; LONGEST]);
        self.controller.lost(reason);
        let unknown = self.controller.unknown();
        kept.line(|line| line.unknown = unknown);
    }
}

impl Controller<'_> {
    /// Looks which chart a state is of, and says whether it is another one than before.
    fn choose(&mut self, received: &Received<'_>) -> bool {
        let Some(Frame::State { fingerprint, .. }) = received.frame else { return false };
        if self.live.as_ref().is_some_and(|live| live.chart().fingerprint() == Some(fingerprint)) {
            return false;
        }
        let chart = self.charts.iter().find(|chart| chart.fingerprint() == Some(fingerprint));
        let was_known = self.live.is_some();
        self.foreign = if chart.is_none() { Some(fingerprint) } else { None };
        self.live = chart.map(|chart| Replay::new().live(chart));
        (self.clock, self.last) = (Clock::default(), None);
        was_known || chart.is_some()
    }

    /// Tells which chart it is.
    fn tell(&self, kept: &Kept) {
        let chart = self.live.as_ref().map(Live::chart);
        let words = kept.way.as_ref().and(chart).and_then(Words::of);
        kept.chart(chart.map(|chart| about(chart, words.as_ref())));
        if let Some(way) = &kept.way {
            way.chart(words);
        }
    }

    fn frame(&mut self, received: &Received<'_>) -> Vec<Moment> {
        self.clock.begins |= received.begins;
        let is_init = matches!(received.frame, Some(Frame::State { key, .. }) if key.replaced && key.fresh);
        self.clock.stands |= is_init && !received.begins;
        let Some(mut live) = self.live.take() else { return Vec::new() };
        let cycles = live.frame(received);
        let moments = cycles.into_iter().map(|cycle| self.moment(&live, cycle)).collect();
        self.live = Some(live);
        moments
    }

    fn lost(&mut self, reason: &str) {
        if let Some(live) = &mut self.live {
            live.lost(reason);
        }
    }

    fn unknown(&self) -> Option<String> {
        match (&self.live, self.foreign) {
            (Some(live), _) => live.unknown().map(str::to_owned),
            (None, Some(fingerprint)) => {
                let charts = self.charts.iter().take(8).map(|chart| {
                    let own = chart.fingerprint().unwrap_or_default();
                    format!("`{}` ({own:08x})", chart.names().chart)
                });
                let more = if self.charts.len() > 8 { ", …" } else { "" };
                Some(format!(
                    "the controller runs another chart or another version of it: its fingerprint is {fingerprint:08x}, and here are {}{more}",
                    charts.collect::<Vec<_>>().join(", ")
                ))
            }
            (None, None) => Some("no state has come yet".to_owned()),
        }
    }

    fn moment(&mut self, live: &Live<'_>, cycle: Cycle) -> Moment {
        let names = live.chart().names();
        let late: Vec<String> = live.late_steps().into_iter().map(str::to_owned).collect();
        let elapsed = self.clock.at(cycle.now, 100_000_000 / names.nanos_per_tick.max(1));
        let is_new = cycle.gap.is_some()
            || self.last.as_ref().is_none_or(|(last, was_late)| {
                *was_late != late || last.inputs != cycle.inputs || cycle.shows_more_than(last)
            });
        let text = json!({
            "number": live.number(),
            "elapsed": elapsed,
            "time": names.time(elapsed),
            "now": cycle.now,
            "gap": cycle.gap.as_ref().map(|gap| json!({ "reason": gap.reason, "cycles": gap.cycles })),
            "skipped": cycle.skipped,
            "steps": cycle.steps,
            "values": json::values(&cycle.inputs),
            "outputs": json::values(&cycle.outputs),
            "variables": json::values(&cycle.variables),
            "params": json::values(&live.params()),
            "evolutions": json::evolutions(&cycle),
            "did": json::did(names, &cycle),
            "waits": json::waits(&cycle.blocked),
            "said": json::said(&cycle.blocked),
            "late": late,
            "isNew": is_new,
            "stable": cycle.is_stable,
        });
        self.last = Some((cycle, late));
        Moment { text: text.to_string().into(), is_new }
    }
}

/// What the page has to know of a chart: its names, its picture, and what it can be told.
fn about(chart: &Chart, words: Option<&Words>) -> Arc<str> {
    let names: &Names = chart.names();
    let drawing = with_description(chart.model(), grafcet_draw::svg_live);
    let takes = words.map(Words::json);
    json!({ "names": json::names(names, &names.inputs), "drawing": drawing, "takes": takes }).to_string().into()
}
