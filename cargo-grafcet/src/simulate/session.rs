//! A chart that somebody plays with: what has been done so far, and what the next cycle is given. It knows no terminal.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

use grafcet_sim::{Chart, Cycle, Error, Kind, Names, Program, Scripted, Signal, Simulation, Value};

/// So many cycles can be taken back: each holds a copy of the chart's memory.
const MOST_BACK: usize = 10_000;

/// Values of what the program around the chart tells, by its text.
type Told = Rc<RefCell<Vec<(String, Value)>>>;

pub(crate) struct Session<'c> {
    chart: &'c Chart,
    /// The chart's inputs, and behind them what the program around it tells.
    signals: Vec<Signal>,
    told: Told,
    now: Moment<'c>,
    /// The moments before each of the last cycles.
    past: VecDeque<Moment<'c>>,
    /// All cycles so far.
    script: Vec<Scripted>,
    values: Vec<Value>,
    step: u32,
}

/// The end of a cycle, or the beginning of all.
#[derive(Clone)]
pub(crate) struct Moment<'c> {
    simulation: Simulation<'c>,
    cycle: Option<Cycle>,
    /// Ticks since the first cycle.
    elapsed: u64,
}

impl<'c> Session<'c> {
    /// The chart before its first cycle; from one cycle to the next there are `step` ticks.
    ///
    /// # Errors
    /// Something in the chart depends on itself, or an initial value is not understood.
    pub(crate) fn new(chart: &'c Chart, step: u32) -> Result<Self, Error> {
        let outside = chart.outside();
        let signals: Vec<Signal> = chart.names().inputs.iter().chain(&outside).cloned().collect();
        let values: Vec<Value> = signals.iter().enumerate().map(|(place, one)| first(chart, place, one)).collect();
        let told: Told = Rc::default();
        let asked = Rc::clone(&told);
        // What blocks of Rust write is not known: they write nothing.
        let program = Program::new().block(|_| Some(Vec::new())).function(move |question| {
            let told = asked.borrow();
            told.iter().find(|(text, _)| question.is(text)).map(|(_, value)| value.clone())
        });
        let simulation = Simulation::beside(chart, program)?;
        let now = Moment { simulation, cycle: None, elapsed: 0 };
        Ok(Self { chart, signals, told, now, past: VecDeque::new(), script: Vec::new(), values, step })
    }

    /// One cycle with the values that are set, a time step after the last one; the first is at zero.
    ///
    /// # Errors
    /// The chart's own arithmetic fails; nothing has changed then.
    pub(crate) fn cycle(&mut self) -> Result<&Cycle, Error> {
        let now = self.script.last().map_or(0, |(last, _)| last.wrapping_add(self.step));
        self.cycle_at(now)
    }

    /// One cycle as a script has it.
    ///
    /// # Errors
    /// As of [`Session::cycle`].
    pub(crate) fn play(&mut self, (now, values): &Scripted) -> Result<&Cycle, Error> {
        let known = values.iter().zip(&self.signals).enumerate();
        self.values = known
            .map(|(place, (value, one))| match value {
                Value::Unknown => first(self.chart, place, one),
                value => value.clone(),
            })
            .collect();
        self.cycle_at(*now)
    }

    fn cycle_at(&mut self, now: u32) -> Result<&Cycle, Error> {
        let (inputs, outside) = self.values.split_at(self.inputs());
        let texts = self.signals[inputs.len()..].iter().map(|signal| signal.name.clone());
        *self.told.borrow_mut() = texts.zip(outside.iter().cloned()).collect();
        let mut next = self.now.clone();
        let cycle = next.simulation.cycle_with(now, inputs)?;
        next.elapsed += self.script.last().map_or(0, |(last, _)| u64::from(now.wrapping_sub(*last)));
        self.past.push_back(std::mem::replace(&mut self.now, next));
        if self.past.len() > MOST_BACK {
            self.past.pop_front();
        }
        self.script.push((now, self.values.clone()));
        Ok(self.now.cycle.insert(cycle))
    }

    /// Takes the last cycle back, with what it was given; `false` where there is none, or its beginning is forgotten.
    pub(crate) fn back(&mut self) -> bool {
        let Some(before) = self.past.pop_back() else { return false };
        self.now = before;
        self.script.pop();
        if let Some((_, values)) = self.script.last() {
            self.values.clone_from(values);
        }
        true
    }

    /// What the next cycle is given.
    pub(crate) fn set(&mut self, signal: usize, value: Value) {
        self.values[signal] = value;
    }

    /// Turns a truth around, and takes the next one of a list. `false` where the signal is neither.
    pub(crate) fn toggle(&mut self, signal: usize) -> bool {
        let value = &mut self.values[signal];
        match (&self.signals[signal].kind, &*value) {
            (Kind::Bool, Value::Bool(was)) => *value = Value::Bool(!was),
            (Kind::Listed(_, list), Value::Name(was)) => {
                let place = list.iter().position(|name| name == was).map_or(0, |place| place + 1);
                *value = Value::Name(list[place % list.len()].clone());
            }
            _ => return false,
        }
        true
    }

    /// The next longer or shorter time step of 1, 2, 5, 10 and so on.
    pub(crate) fn step_by(&mut self, longer: bool) {
        const LONGEST: u32 = 1_000_000_000;
        let decades = (0..=9).flat_map(|power| [1, 2, 5].map(|one| 10_u32.pow(power).saturating_mul(one)));
        let steps: Vec<u32> = decades.filter(|step| *step <= LONGEST).collect();
        let other = if longer {
            steps.iter().find(|step| **step > self.step)
        } else {
            steps.iter().rfind(|step| **step < self.step)
        };
        self.step = other.copied().unwrap_or(self.step);
    }

    pub(crate) fn chart(&self) -> &'c Chart {
        self.chart
    }

    pub(crate) fn names(&self) -> &'c Names {
        self.chart.names()
    }

    pub(crate) fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// So many of the signals are the chart's inputs.
    pub(crate) fn inputs(&self) -> usize {
        self.chart.names().inputs.len()
    }

    pub(crate) fn values(&self) -> &[Value] {
        &self.values
    }

    /// Ticks from one cycle to the next.
    pub(crate) fn step(&self) -> u32 {
        self.step
    }

    /// Ticks since the first cycle.
    pub(crate) fn elapsed(&self) -> u64 {
        self.now.elapsed
    }

    /// All cycles so far.
    pub(crate) fn script(&self) -> &[Scripted] {
        &self.script
    }

    /// The last cycle; none before the first.
    pub(crate) fn last(&self) -> Option<&Cycle> {
        self.now.cycle.as_ref()
    }

    /// The chart as it is now.
    pub(crate) fn simulation(&self) -> &Simulation<'c> {
        &self.now.simulation
    }
}

/// What a signal is before anybody has set it. A name that stands for itself is no variant that the chart names, where that is a function's, and the one that
/// is meant, where it is a constant's.
fn first(chart: &Chart, place: usize, signal: &Signal) -> Value {
    match &signal.kind {
        Kind::Bool => Value::Bool(false),
        Kind::Int { .. } => Value::Int(0),
        Kind::Float(_) => Value::Float(0.0),
        Kind::Time => Value::Ticks(0),
        Kind::Listed(_, list) => list.first().map_or(Value::Unknown, |first| Value::Name(first.clone())),
        Kind::Other(_) if place < chart.names().inputs.len() => Value::Name("?".to_owned()),
        Kind::Other(_) => Value::Name(signal.name.split_whitespace().collect()),
    }
}
