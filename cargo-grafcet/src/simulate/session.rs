//! A chart that somebody plays with: what has been done so far, and what the next cycle is given. It knows no terminal.

use std::collections::VecDeque;

use grafcet_sim::{Beside, Chart, Cycle, Error, Kind, Names, Signal, Simulation, Value};

use super::script::Played;

/// So many cycles can be taken back: each holds a copy of the chart's memory.
const MOST_BACK: usize = 10_000;

pub(crate) struct Session<'c> {
    beside: Beside<'c>,
    now: Moment<'c>,
    /// The moments before each of the last cycles.
    past: VecDeque<Moment<'c>>,
    /// All cycles so far.
    script: Vec<Played>,
    /// The signals, and after them the parameters.
    shown: Vec<Signal>,
    values: Vec<Value>,
    /// The parameters from the next cycle on.
    params: Vec<Value>,
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
        let beside = Beside::of(chart);
        let now = Moment { simulation: beside.start()?, cycle: None, elapsed: 0 };
        let values = beside.first();
        let params = now.simulation.params();
        let shown = beside.signals().iter().chain(&chart.names().params).cloned().collect();
        Ok(Self { beside, now, past: VecDeque::new(), script: Vec::new(), shown, values, params, step })
    }

    /// One cycle with the values that are set, a time step after the last one; the first is at zero.
    ///
    /// # Errors
    /// The chart's own arithmetic fails; nothing has changed then.
    pub(crate) fn cycle(&mut self) -> Result<&Cycle, Error> {
        self.cycle_at(self.next(), false, None)
    }

    /// The same, but it starts like a first one: the classic *Init*.
    ///
    /// # Errors
    /// As of [`Session::cycle`].
    pub(crate) fn init(&mut self) -> Result<&Cycle, Error> {
        self.cycle_at(self.next(), true, None)
    }

    fn next(&self) -> u32 {
        self.script.last().map_or(0, |last| last.now.wrapping_add(self.step))
    }

    /// The same, but into these steps by hand, whatever the conditions say.
    ///
    /// # Errors
    /// The chart is not `forceable;`, has no such step, or is never in exactly these; or as of [`Session::cycle`]. Nothing has changed then.
    pub(crate) fn force(&mut self, steps: Vec<String>) -> Result<&Cycle, String> {
        let now = self.next();
        self.beside.may_be(&steps.iter().map(String::as_str).collect::<Vec<_>>())?;
        self.cycle_at(now, false, Some(steps)).map_err(|error| error.to_string())
    }

    /// One cycle as a script has it.
    ///
    /// # Errors
    /// As of [`Session::cycle`].
    pub(crate) fn play(&mut self, played: &Played) -> Result<&Cycle, String> {
        let known = played.values.iter().enumerate();
        self.values = known
            .map(|(place, value)| match value {
                Value::Unknown => self.beside.first_of(place),
                value => value.clone(),
            })
            .collect();
        for (place, value) in &played.params {
            self.params[*place] = value.clone();
        }
        if let Some(steps) = &played.by_hand {
            self.beside.may_be(&steps.iter().map(String::as_str).collect::<Vec<_>>())?;
        }
        self.cycle_at(played.now, played.init, played.by_hand.clone()).map_err(|error| error.to_string())
    }

    fn cycle_at(&mut self, now: u32, init: bool, by_hand: Option<Vec<String>>) -> Result<&Cycle, Error> {
        let mut before = self.now.simulation.clone();
        let was = before.params();
        let exchanged = self.params.iter().cloned().enumerate().filter(|(place, value)| was[*place] != *value);
        let exchanged: Vec<(usize, Value)> = exchanged.collect();
        for (place, value) in &exchanged {
            before.set_param(&self.names().params[*place].name, value.clone())?;
        }
        if init {
            before.init()?;
        }
        let (simulation, cycle) = match &by_hand {
            None => self.beside.cycle(&before, now, &self.values)?,
            Some(steps) => {
                let steps: Vec<&str> = steps.iter().map(String::as_str).collect();
                self.beside.force(&before, now, &self.values, &steps)?
            }
        };
        let since = self.script.last().map_or(0, |last| u64::from(now.wrapping_sub(last.now)));
        let next = Moment { simulation, cycle: None, elapsed: self.now.elapsed + since };
        self.past.push_back(std::mem::replace(&mut self.now, next));
        if self.past.len() > MOST_BACK {
            self.past.pop_front();
        }
        self.script.push(Played { now, values: self.values.clone(), params: exchanged, init, by_hand });
        Ok(self.now.cycle.insert(cycle))
    }

    /// Takes the last cycle back, with what it was given; `false` where there is none, or its beginning is forgotten.
    pub(crate) fn back(&mut self) -> bool {
        let Some(before) = self.past.pop_back() else { return false };
        self.now = before;
        self.script.pop();
        self.params = self.now.simulation.params();
        if let Some(last) = self.script.last() {
            self.values.clone_from(&last.values);
        }
        true
    }

    /// What the next cycle is given.
    pub(crate) fn set(&mut self, signal: usize, value: Value) {
        *self.value_mut(signal) = value;
    }

    fn value_mut(&mut self, shown: usize) -> &mut Value {
        match shown.checked_sub(self.values.len()) {
            None => &mut self.values[shown],
            Some(param) => &mut self.params[param],
        }
    }

    /// Turns a truth around, and takes the next one of a list. `false` where the signal is neither.
    pub(crate) fn toggle(&mut self, signal: usize) -> bool {
        let kind = self.shown[signal].kind.clone();
        let value = self.value_mut(signal);
        match (&kind, &*value) {
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
        self.beside.chart()
    }

    pub(crate) fn names(&self) -> &'c Names {
        self.chart().names()
    }

    pub(crate) fn signals(&self) -> &[Signal] {
        self.beside.signals()
    }

    /// What can be set: the signals, and after them the parameters.
    pub(crate) fn shown(&self) -> &[Signal] {
        &self.shown
    }

    /// The value of each of these.
    pub(crate) fn shown_values(&self) -> impl Iterator<Item = &Value> {
        self.values.iter().chain(&self.params)
    }

    /// So many of the signals are the chart's inputs.
    pub(crate) fn inputs(&self) -> usize {
        self.beside.inputs()
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
    pub(crate) fn script(&self) -> &[Played] {
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
