//! The way back, from a page to a controller, where the tool was started with `--steer`.
//!
//! A command goes to one chart, of which it is known what it does now, and the next one only when it was answered: so nothing piles up in front of a
//! line, to be carried out when nobody thinks of it any more.

use std::collections::VecDeque;
use std::io::Write;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use grafcet_core::record::steer::{Answer, Mode, Refused, Request, Wanted, request_len};
use grafcet_sim::Chart;
use serde_json::{Map, Value as Json, json};

/// So long a command waits for its answer, and the next one for it.
const PATIENCE: Duration = Duration::from_secs(3);
/// So many commands are shown with what became of them.
const SHOWN: usize = 5;

/// The modes by the names that the page has for them.
const MODES: [(&str, Mode); 4] = [
    ("automatic", Mode::Automatic),
    ("semi-automatic", Mode::SemiAutomatic),
    ("manual", Mode::Manual),
    ("paused", Mode::Paused),
];

/// What a page asks for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Asked {
    /// The place of the source.
    pub(crate) source: usize,
    /// The fingerprint of the chart that the page shows.
    pub(crate) chart: u32,
    pub(crate) what: What,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum What {
    Init,
    Push,
    Mode(Mode),
    /// The places of steps, in their order.
    Force(Vec<usize>),
}

impl Asked {
    /// What a page has said; none where these words are not exactly a command.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let Json::Object(words) = serde_json::from_str(text).ok()? else { return None };
        let number = |name: &str| words.get(name)?.as_u64();
        let (more, what) = match words.get("do")?.as_str()? {
            "init" => (0, What::Init),
            "push" => (0, What::Push),
            "mode" => {
                let name = words.get("mode")?.as_str()?;
                (1, What::Mode(MODES.iter().find(|(mode, _)| *mode == name)?.1))
            }
            "force" => (1, What::Force(steps(&words)?)),
            _ => return None,
        };
        let (source, chart) = (usize::try_from(number("source")?).ok()?, u32::try_from(number("chart")?).ok()?);
        (words.len() == 3 + more).then_some(Self { source, chart, what })
    }
}

/// Each once, in their order.
fn steps(words: &Map<String, Json>) -> Option<Vec<usize>> {
    let place = |step: &Json| usize::try_from(step.as_u64()?).ok();
    let steps: Vec<usize> = words.get("steps")?.as_array()?.iter().map(place).collect::<Option<_>>()?;
    steps.is_sorted_by(|one, next| one < next).then_some(steps)
}

/// What a chart can be told, as its source says.
#[derive(Clone, Debug)]
pub(crate) struct Words {
    fingerprint: u32,
    steps: Vec<String>,
    modes: bool,
    forceable: bool,
}

impl Words {
    pub(crate) fn of(chart: &Chart) -> Option<Self> {
        let steps = chart.names().steps.iter().map(|step| step.name.clone()).collect();
        let model = chart.model();
        Some(Self {
            fingerprint: chart.fingerprint()?,
            steps,
            modes: model.modes.is_some(),
            forceable: model.forceable,
        })
    }

    /// As the page reads them.
    pub(crate) fn json(&self) -> Json {
        json!({ "chart": self.fingerprint, "modes": self.modes, "forceable": self.forceable })
    }

    fn refuses(&self, what: &What) -> Option<&'static str> {
        match what {
            What::Push | What::Mode(_) if !self.modes => Some("the chart has no `modes;`"),
            What::Force(_) if !self.forceable => Some("the chart is not `forceable;`"),
            What::Force(steps) if steps.iter().any(|step| *step >= self.steps.len()) => {
                Some("the chart has no such step")
            }
            _ => None,
        }
    }

    fn say(&self, what: &What) -> String {
        match what {
            What::Init => "init".to_owned(),
            What::Push => "push".to_owned(),
            What::Mode(mode) => MODES.iter().find(|(_, other)| other == mode).map_or("", |(name, _)| name).to_owned(),
            What::Force(steps) if steps.is_empty() => "force no step".to_owned(),
            What::Force(steps) => {
                let names: Vec<String> = steps.iter().map(|step| format!("`{}`", self.name(*step))).collect();
                format!("force {}", names.join(", "))
            }
        }
    }

    fn name(&self, step: usize) -> &str {
        self.steps.get(step).map_or("?", |name| name)
    }

    /// Why the controller has not done it.
    fn refusal(&self, why: Refused) -> String {
        let name = |step: u32| usize::try_from(step).map_or("?", |step| self.name(step));
        match why {
            Refused::NeverTogether { one, other } => {
                format!("`{}` and `{}` are never active together", name(one), name(other))
            }
            Refused::Old { .. } => {
                format!("{why}; the next one of this page is numbered above it, so try again")
            }
            _ => why.to_string(),
        }
    }
}

/// The way to one controller.
#[derive(Default)]
pub(crate) struct Controller {
    /// Apart from all else: while a line takes what is written to it, others look.
    line: Mutex<Option<Box<dyn Write + Send>>>,
    inner: Mutex<Inner>,
}

#[derive(Default)]
struct Inner {
    chart: Option<Words>,
    /// How many cycles the chart has made, as far as is known.
    seen: u32,
    /// The number of the last command, of this tool or another one.
    last: u64,
    sent: VecDeque<Sent>,
}

/// A command, and what became of it.
struct Sent {
    number: u64,
    what: String,
    at: Instant,
    outcome: Option<Result<(), String>>,
}

impl Controller {
    fn inner(&self) -> MutexGuard<'_, Inner> {
        // Nobody leaves it half written: there is nothing in here that panics.
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The line is open.
    pub(crate) fn open(&self, line: Option<Box<dyn Write + Send>>) {
        *self.line.lock().unwrap_or_else(PoisonError::into_inner) = line;
    }

    /// It is not any more.
    pub(crate) fn close(&self) {
        self.open(None);
        for sent in self.inner().sent.iter_mut().filter(|sent| sent.outcome.is_none()) {
            sent.outcome = Some(Err("the line was lost, and nobody knows".to_owned()));
        }
    }

    /// From here on it is this chart, or none that is known.
    pub(crate) fn chart(&self, chart: Option<Words>) {
        self.inner().chart = chart;
    }

    /// The chart has made so many cycles.
    pub(crate) fn seen(&self, cycles: u32) {
        self.inner().seen = cycles;
    }

    /// Sends a command.
    ///
    /// # Errors
    /// Why it was not sent.
    pub(crate) fn send(&self, asked: &Asked) -> Result<(), String> {
        let (number, frame) = self.inner().begin(asked)?;
        let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        let written = match &mut *line {
            Some(line) => line.write_all(&frame).and_then(|()| line.flush()).map_err(|error| error.to_string()),
            None => Err("the line is not connected".to_owned()),
        };
        drop(line);
        written.map_err(|error| {
            self.inner().sent.retain(|sent| sent.number != number);
            format!("it could not be sent: {error}")
        })
    }

    /// What the controller says.
    pub(crate) fn answered(&self, answer: &Answer) {
        let mut guard = self.inner();
        let inner = &mut *guard;
        if let Err(Refused::Old { last }) = answer.outcome {
            inner.last = inner.last.max(last);
        }
        let sent = inner.sent.iter_mut().find(|sent| sent.number == answer.number && sent.outcome.is_none());
        if let (Some(sent), Some(chart)) = (sent, &inner.chart) {
            sent.outcome = Some(answer.outcome.map_err(|why| chart.refusal(why)));
        }
    }

    /// The last commands, as the page reads them.
    pub(crate) fn shown(&self) -> Json {
        let one = |sent: &Sent| {
            let outcome = sent.outcome.as_ref().map(|outcome| match outcome {
                Ok(()) => json!({ "accepted": true }),
                Err(why) => json!({ "accepted": false, "why": why }),
            });
            json!({ "number": sent.number, "what": sent.what, "ago": sent.at.elapsed().as_millis(), "outcome": outcome })
        };
        self.inner().sent.iter().map(one).collect()
    }
}

impl Inner {
    /// The number of a command and its bytes.
    fn begin(&mut self, asked: &Asked) -> Result<(u64, Vec<u8>), String> {
        let Some(chart) = self.chart.as_ref().filter(|chart| chart.fingerprint == asked.chart) else {
            return Err("the controller runs another chart by now".to_owned());
        };
        if let Some(why) = chart.refuses(&asked.what) {
            return Err(why.to_owned());
        }
        if self.sent.back().is_some_and(|last| last.outcome.is_none() && last.at.elapsed() < PATIENCE) {
            return Err("the last command was not answered yet".to_owned());
        }
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let clock = u64::try_from(since.as_millis()).unwrap_or_default();
        let number = self.last.saturating_add(1).max(clock);
        let (fingerprint, steps) = (chart.fingerprint, chart.steps.len());
        let wanted = match &asked.what {
            What::Init => Wanted::Init,
            What::Push => Wanted::Push,
            What::Mode(mode) => Wanted::Mode(*mode),
            What::Force(steps) => Wanted::Force(steps),
        };
        let mut buffer = vec![0; request_len(steps)];
        let request = Request { number, fingerprint, steps, seen: self.seen, wanted };
        let frame = request.write(&mut buffer).ok_or("the chart has no such step")?.to_vec();
        let what = chart.say(&asked.what);
        self.last = number;
        self.sent.push_back(Sent { number, what, at: Instant::now(), outcome: None });
        while self.sent.len() > SHOWN {
            self.sent.pop_front();
        }
        Ok((number, frame))
    }
}

#[cfg(test)]
mod tests {
    use std::io::{self, Write};
    use std::sync::{Arc, Mutex};

    use grafcet::record::Recordable;
    use grafcet::record::steer::{Commands, command_len};
    use grafcet_core::record::steer::{Answer, Refused};
    use grafcet_sim::{Chart, calls};
    use serde_json::json;

    use super::super::tests::motor::{Motor, SOURCE};
    use super::{Asked, Controller, What, Words};

    /// A line that keeps what is written to it, or breaks.
    #[derive(Clone, Default)]
    struct Line(Arc<Mutex<Vec<u8>>>, bool);

    impl Write for Line {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if self.1 {
                return Err(io::ErrorKind::TimedOut.into());
            }
            self.0.lock().expect("the line").extend(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Line {
        /// The numbers of the commands that have come, as the controller reads them after so many cycles.
        fn numbers(&self, cycles: u32) -> Vec<u64> {
            let mut commands = Commands::<Motor, _, _>::new([0; command_len::<Motor>()], [], 0);
            let bytes = self.0.lock().expect("the line").clone();
            let read = |byte| commands.push(byte, cycles)?.ok().map(|command| command.number);
            bytes.into_iter().filter_map(read).collect()
        }
    }

    fn way(line: &Line) -> Controller {
        let (_, tokens) = calls(&SOURCE.parse().expect("Rust")).remove(0);
        let way = Controller::default();
        way.chart(Words::of(&Chart::of_tokens(tokens).expect("a chart")));
        way.open(Some(Box::new(line.clone())));
        way.seen(70);
        way
    }

    fn init() -> Asked {
        Asked { source: 0, chart: Motor::FINGERPRINT, what: What::Init }
    }

    #[test]
    fn the_next_number_is_above_all_that_were_heard_of() {
        let line = Line::default();
        let way = way(&line);
        assert_eq!(way.send(&init()), Ok(()));
        let first = line.numbers(70)[0];
        assert!(first > 1_700_000_000_000, "the milliseconds of the clock: {first}");
        assert!(line.numbers(71).is_empty(), "the cycle that was seen goes with it");
        let last = u64::MAX - 5;
        way.answered(&Answer { number: first, outcome: Err(Refused::Old { last }) });
        let why = way.shown()[0]["outcome"]["why"].as_str().map(str::to_owned).expect("a reason");
        assert!(why.ends_with("the next one of this page is numbered above it, so try again"), "{why}");
        assert_eq!(way.send(&init()), Ok(()));
        assert_eq!(line.numbers(70), [first, last + 1]);
        // What is said of it later, and of commands of others, changes nothing.
        way.answered(&Answer { number: first, outcome: Ok(()) });
        way.answered(&Answer { number: first + 1, outcome: Ok(()) });
        assert_eq!((&way.shown()[0]["outcome"]["accepted"], &way.shown()[1]["outcome"]), (&json!(false), &json!(null)));
        way.answered(&Answer { number: last + 1, outcome: Ok(()) });
        assert_eq!(way.shown()[1]["outcome"], json!({ "accepted": true }));
    }

    #[test]
    fn what_could_not_be_sent_waits_for_no_answer() {
        let broken = Line(Arc::default(), true);
        let way = way(&broken);
        let error = way.send(&init()).expect_err("it breaks");
        assert!(error.starts_with("it could not be sent: "), "{error}");
        assert_eq!(way.shown(), json!([]));
        way.close();
        assert_eq!(way.send(&init()), Err("it could not be sent: the line is not connected".to_owned()));
        let line = Line::default();
        way.open(Some(Box::new(line.clone())));
        assert_eq!((way.send(&init()), line.numbers(70).len()), (Ok(()), 1));
        assert_eq!(way.send(&init()), Err("the last command was not answered yet".to_owned()));
        // Without a chart, or another one, nothing is sent.
        way.chart(None);
        assert_eq!(way.send(&init()), Err("the controller runs another chart by now".to_owned()));
    }
}
