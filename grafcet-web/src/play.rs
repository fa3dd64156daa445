//! A chart that somebody plays with, cycle by cycle, forwards and back.

use std::collections::VecDeque;

use grafcet_sim::{Beside, Chart, Cycle, Kind, Names, Signal, Simulation, Value, json};
use serde_json::{Value as Json, json};

use crate::text::Written;

/// So many moments in which something changed can be gone back to: each holds a copy of the chart's memory.
const MOST_BACK: usize = 10_000;

/// A chart that runs.
///
/// What changes nothing is not kept: from the last moment before, it can be run again.
pub struct Play {
    beside: Beside<'static>,
    now: Moment,
    /// What the next cycle begins with, where that is not what the last one has left: after *Init*, and with other parameters.
    changed: Option<Simulation<'static>>,
    /// The moments in which something changed, before this one.
    past: VecDeque<Moment>,
    /// For the next cycle.
    values: Vec<Value>,
    step: u32,
}

/// The end of a cycle, or the beginning of all.
#[derive(Clone)]
struct Moment {
    simulation: Simulation<'static>,
    /// What the cycle was given.
    values: Vec<Value>,
    cycle: Option<Cycle>,
    /// How many cycles there have been.
    number: u32,
    /// Ticks since the first cycle.
    elapsed: u64,
    /// Ticks from the cycle before; those after it that change nothing are as far apart.
    step: u32,
    /// Something is different from the moment before, so that it has to be kept.
    is_new: bool,
}

impl Play {
    /// The chart before its first cycle; from one cycle to the next there are `step` ticks. The chart lives as long as the program, so a page begins each
    /// session in a worker of its own.
    ///
    /// # Errors
    /// It is no chart that can be run: why.
    pub fn new(text: &str, step: u32) -> Result<Self, String> {
        let written = Written::find(text).map_err(|unread| unread.why.to_owned())?;
        let chart = Chart::of_tokens(written.tokens).map_err(|refused| refused.to_string())?;
        let beside = Beside::of(Box::leak(Box::new(chart)));
        let values = beside.first();
        let simulation = beside.start().map_err(|error| error.to_string())?;
        let now = Moment { simulation, values: values.clone(), cycle: None, number: 0, elapsed: 0, step, is_new: true };
        Ok(Self { beside, now, changed: None, past: VecDeque::new(), values, step })
    }

    /// The names of everything, and what kind of value each has.
    #[must_use]
    pub fn names(&self) -> Json {
        let mut names = json::names(self.all_names(), self.beside.signals());
        names["forceable"] = self.beside.chart().model().forceable.into();
        names
    }

    /// The present moment.
    #[must_use]
    pub fn now(&self) -> Json {
        let moment = &self.now;
        let names = self.all_names();
        let done = moment.cycle.as_ref();
        let simulation = self.simulation();
        let blocked = simulation.blocked();
        let did = done.map_or_else(Vec::new, |cycle| json::did(names, cycle));
        let calls = done.iter().flat_map(|cycle| &cycle.calls);
        json!({
            "number": moment.number,
            "elapsed": moment.elapsed,
            "time": names.time(moment.elapsed),
            "now": done.map_or(0, |cycle| cycle.now),
            "steps": simulation.steps(),
            "values": json::values(&moment.values),
            "outputs": json::values(&simulation.outputs()),
            "variables": json::values(&simulation.variables()),
            "params": json::values(&simulation.params()),
            "evolutions": done.map_or_else(Vec::new, json::evolutions),
            "calls": calls.map(|call| json!({
                "action": call.action, "phase": format!("{:?}", call.phase).to_lowercase(), "args": json::values(&call.args),
            })).collect::<Vec<_>>(),
            "did": did,
            "waits": json::waits(&blocked),
            "isFirst": blocked.is_first,
            "said": json::said(&blocked),
            "late": simulation.late_steps(),
            "isNew": moment.is_new,
            "stable": done.is_none_or(|cycle| cycle.is_stable),
        })
    }

    /// Ticks from one cycle to the next.
    pub fn step_by(&mut self, step: u32) {
        self.step = step;
    }

    /// Sets a signal, for the next cycle.
    ///
    /// # Errors
    /// There is no such signal, or it cannot have this value.
    pub fn set(&mut self, place: usize, value: &str) -> Result<(), String> {
        let signal = self.beside.signals().get(place).ok_or("there is no such signal")?;
        self.values[place] = read(signal, value)?;
        Ok(())
    }

    /// Sets a parameter, for the next cycle.
    ///
    /// # Errors
    /// There is no such parameter, or it cannot have this value.
    pub fn set_param(&mut self, place: usize, value: &str) -> Result<(), String> {
        let param = self.all_names().params.get(place).ok_or("there is no such parameter")?;
        let value = read(param, value)?;
        let mut changed = self.simulation().clone();
        changed.set_param(&param.name, value).map_err(|error| error.to_string())?;
        self.changed = Some(changed);
        Ok(())
    }

    /// So many cycles: those in which something changed, and the last one.
    ///
    /// # Errors
    /// The chart's own arithmetic fails; the cycles before that one are made.
    pub fn advance(&mut self, cycles: u32) -> Result<Json, String> {
        let mut shown = Vec::new();
        for left in (0..cycles).rev() {
            self.cycle(self.next())?;
            if self.now.is_new || left == 0 {
                shown.push(self.now());
            }
        }
        Ok(Json::Array(shown))
    }

    /// Cycles until something changes, at most so many: the last one.
    ///
    /// # Errors
    /// As of [`Play::advance`].
    pub fn skip(&mut self, most: u32) -> Result<Json, String> {
        for _ in 0..most {
            self.cycle(self.next())?;
            if self.now.is_new {
                break;
            }
        }
        Ok(self.now())
    }

    /// A cycle at this time of the chart's clock.
    ///
    /// # Errors
    /// The chart's own arithmetic fails; nothing has changed then.
    pub fn cycle_at(&mut self, now: u32) -> Result<Json, String> {
        self.cycle(now)?;
        Ok(self.now())
    }

    /// A cycle that leads into the situation of these steps, as [`grafcet_sim::Simulation::force`]: nobody asks whether the chart can be in it.
    ///
    /// # Errors
    /// There is no such step, or the chart's own arithmetic fails; nothing has changed then.
    pub fn force(&mut self, now: u32, steps: &[usize]) -> Result<Json, String> {
        let situation = self.situation(steps)?;
        let done = self.beside.force(self.simulation(), now, &self.values, &situation);
        let (simulation, cycle) = done.map_err(|error| error.to_string())?;
        self.made(simulation, cycle, true);
        Ok(self.now())
    }

    /// The next cycle, which leads into the situation of these steps, as the compiled chart lets itself be put into it.
    ///
    /// # Errors
    /// The chart is not `forceable;`, or is never in exactly these steps; else as of [`Play::force`].
    pub fn by_hand(&mut self, steps: &[usize]) -> Result<Json, String> {
        self.beside.may_be(&self.situation(steps)?)?;
        self.force(self.next(), steps)
    }

    fn situation(&self, steps: &[usize]) -> Result<Vec<&'static str>, String> {
        let names = self.all_names();
        let situation = steps.iter().map(|step| names.steps.get(*step).map(|step| step.name.as_str()));
        situation.collect::<Option<_>>().ok_or_else(|| "there is no such step".to_owned())
    }

    /// The classic *Init*: the next cycle starts like a first one.
    ///
    /// # Errors
    /// An initial value is not understood.
    pub fn init(&mut self) -> Result<(), String> {
        let mut changed = self.simulation().clone();
        changed.init().map_err(|error| error.to_string())?;
        self.changed = Some(changed);
        Ok(())
    }

    /// Back to the end of the cycle of this number.
    ///
    /// # Errors
    /// Its time is forgotten, or has not come yet.
    pub fn rewind(&mut self, number: u32) -> Result<Json, String> {
        if number > self.now.number {
            return Err("that has not happened yet".to_owned());
        }
        self.changed = None;
        if number < self.now.number {
            // What the signals were in a stretch without a change they were at its beginning.
            while let Some(before) = self.past.pop_back() {
                self.now = before;
                if self.now.number <= number {
                    break;
                }
            }
            if self.now.number > number {
                return Err("the beginning is forgotten".to_owned());
            }
            self.values.clone_from(&self.now.values);
            while let Some(last) = self.now.cycle.as_ref().filter(|_| self.now.number < number) {
                self.cycle(last.now.wrapping_add(self.now.step))?;
            }
        }
        Ok(self.now())
    }

    fn all_names(&self) -> &'static Names {
        self.beside.chart().names()
    }

    /// The chart as the next cycle finds it.
    fn simulation(&self) -> &Simulation<'static> {
        self.changed.as_ref().unwrap_or(&self.now.simulation)
    }

    /// The first cycle is at zero.
    fn next(&self) -> u32 {
        self.now.cycle.as_ref().map_or(0, |cycle| cycle.now.wrapping_add(self.step))
    }

    fn cycle(&mut self, now: u32) -> Result<(), String> {
        let done = self.beside.cycle(self.simulation(), now, &self.values);
        let (simulation, cycle) = done.map_err(|error| error.to_string())?;
        self.made(simulation, cycle, false);
        Ok(())
    }

    fn made(&mut self, simulation: Simulation<'static>, cycle: Cycle, forced: bool) {
        let before = &self.now;
        let since = before.cycle.as_ref().map_or(0, |before| cycle.now.wrapping_sub(before.now));
        let differs = |last: &Cycle| {
            let is_late = before.simulation.late_steps() != simulation.late_steps();
            is_late || since != before.step || cycle.shows_more_than(last)
        };
        // What was changed by hand is not there when that moment is run again.
        let by_hand = self.changed.take().is_some() || forced;
        let is_new = by_hand || before.values != self.values || before.cycle.as_ref().is_none_or(differs);
        let next = Moment {
            values: self.values.clone(),
            number: before.number + 1,
            elapsed: before.elapsed + u64::from(since),
            step: if before.cycle.is_some() { since } else { self.step },
            cycle: Some(cycle),
            simulation,
            is_new,
        };
        self.keep_if_new();
        self.now = next;
    }

    fn keep_if_new(&mut self) {
        if self.now.is_new {
            self.past.push_back(self.now.clone());
        }
        if self.past.len() > MOST_BACK {
            self.past.pop_front();
        }
    }
}

fn read(signal: &Signal, text: &str) -> Result<Value, String> {
    let found = match &signal.kind {
        Kind::Bool => text.parse().ok().map(Value::Bool),
        Kind::Int { signed, bits } => text.parse().ok().filter(|value| fits(*value, *signed, *bits)).map(Value::Int),
        Kind::Float(_) => text.parse().ok().map(Value::Float),
        Kind::Time => text.parse().ok().map(Value::Ticks),
        Kind::Listed(_, list) => list.iter().find(|name| *name == text).cloned().map(Value::Name),
        Kind::Other(_) => Some(text.into()),
    };
    found.ok_or_else(|| format!("`{}` cannot be `{text}`", signal.name))
}

fn fits(value: i128, signed: bool, bits: u32) -> bool {
    // Of 128 bits without a sign the upper half is more than the simulation counts.
    let bits = if signed { bits.min(128) - 1 } else { bits.min(127) };
    let end = if bits >= 127 { i128::MAX } else { (1 << bits) - 1 };
    value <= end && value >= if signed { -end - 1 } else { 0 }
}
