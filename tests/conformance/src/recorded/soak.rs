//! A chart at work for a long time: the compiled one runs every cycle, the interpreter those in which anything can change.

use std::time::{Duration, Instant};

use grafcet::{Chart, Ticks};
use grafcet_compiler::model::{Model, Ty};
use grafcet_core::record::Recordable;

use super::{Outputs, Recorded};
use crate::oracle::Interpreted;
use crate::random::Rng;
use crate::{Shown, Subject, Values};

/// So long the interpreter is told nothing, at most.
const LONGEST: u32 = 1 << 30;

/// What was done.
#[derive(Clone, Copy, Default, Debug)]
pub struct Done {
    /// Cycles of the compiled chart.
    pub cycles: u64,
    /// Those of them that the interpreter has run, too, and that were compared.
    pub compared: u64,
    /// Ticks that have passed.
    pub ticks: u64,
}

/// The chart for so many cycles, or until the time is over.
pub type Soak = fn(&Model, u64, Duration) -> Result<Done, String>;

/// Runs a chart. In a cycle that its `next_deadline` or, without time, its unchanged state calls a repetition, it has to show what it has shown; in all others what the interpreter
/// shows, which has not run the repetitions.
///
/// # Errors
/// The first difference.
pub fn soak<S: Recorded>(model: &Model, cycles: u64, time: Duration) -> Result<Done, String> {
    let end = Instant::now() + time;
    let mut run = Run::<S>::new(model)?;
    // The clock is looked at now and then.
    while run.done.cycles < cycles && (run.done.cycles % 4096 > 0 || Instant::now() < end) {
        run.cycle().map_err(|error| format!("cycle {}: {error}", run.done.cycles))?;
        run.done.cycles += 1;
    }
    Ok(run.done)
}

struct Run<'m, S: Recorded> {
    model: &'m Model,
    chart: S::Chart,
    oracle: Interpreted<'m>,
    rng: Rng,
    values: Values,
    inputs: super::Inputs<S>,
    /// What the last cycle has shown.
    outputs: Option<Outputs<S>>,
    now: u32,
    /// The last cycle that the interpreter has run, and for how long nothing changes since.
    at: u32,
    quiet: u32,
    done: Done,
}

impl<'m, S: Recorded> Run<'m, S> {
    fn new(model: &'m Model) -> Result<Self, String> {
        let values = Values::new();
        let inputs = S::inputs(&values);
        let oracle = Interpreted::new(model)?;
        let rng = Rng::new(model.steps.len() as u64);
        let (chart, done) = (S::make(), Done::default());
        Ok(Self { model, chart, oracle, rng, values, inputs, outputs: None, now: 0, at: 0, quiet: 0, done })
    }

    fn cycle(&mut self) -> Result<(), String> {
        let chance = self.rng.number();
        let elapsed = elapsed(chance);
        self.now = self.now.wrapping_add(elapsed);
        self.done.ticks += u64::from(elapsed);
        let mut is_quiet = self.now.wrapping_sub(self.at) < self.quiet && self.outputs.is_some();
        if chance >> 54 == 0 {
            self.change();
            is_quiet = false;
        }
        if is_quiet { self.repeat() } else { self.compare() }
    }

    /// Nothing but a repetition.
    fn repeat(&mut self) -> Result<(), String> {
        let (before, now) = (self.chart.situation(), Ticks::new(self.now));
        let (chart, inputs) = (&mut self.chart, &self.inputs);
        let mut outputs = None;
        // Calls are repeated.
        let calls = S::called(&mut |actions| outputs = Some(chart.scan(inputs, now, actions)));
        let is_same = outputs == self.outputs && self.chart.situation() == before;
        if is_same && super::once(&calls).next().is_none() { Ok(()) } else { Err("no repetition".to_owned()) }
    }

    fn compare(&mut self) -> Result<(), String> {
        let expected = self.oracle.cycle(&self.values, self.now)?;
        let before = (!S::Chart::TIMED).then(|| self.chart.clone());
        let (chart, inputs, now) = (&mut self.chart, &self.inputs, Ticks::new(self.now));
        let mut outputs = None;
        let calls = S::called(&mut |actions| outputs = Some(chart.scan(inputs, now, actions)));
        let outputs = outputs.ok_or("no cycle")?;
        let found = Shown { calls, ..S::shown(&self.chart, &outputs) };
        if found != expected {
            return Err(format!("at {}\n  expected {expected}\n  found    {found}", self.now));
        }
        self.outputs = Some(outputs);
        self.done.compared += 1;
        self.at = self.now;
        self.quiet = match before {
            Some(before) if self.chart.is_same_state(&before) => LONGEST,
            Some(_) => 0,
            None => self.chart.wakes_at().map_or(LONGEST, |at| at.get().wrapping_sub(self.now).min(LONGEST)),
        };
        Ok(())
    }

    /// Another value of an input.
    fn change(&mut self) {
        if self.model.inputs.is_empty() {
            return;
        }
        let which = self.rng.below(self.model.inputs.len());
        let Some(input) = self.model.inputs.values().nth(which) else { return };
        let name = input.name.to_string().trim_start_matches("r#").to_owned();
        let before = self.values.get(&name).copied().unwrap_or_default();
        // Small, so that the chart's arithmetic stays within its types.
        let value = match &input.ty {
            Ty::Bool(_) => 1 - before,
            Ty::Int { rust, .. } if quote::quote!(#rust).to_string().starts_with('i') => self.rng.below(17) as i128 - 8,
            Ty::Int { .. } | Ty::Time(_) => self.rng.below(9) as i128,
            Ty::Other(_) => self.rng.below(3) as i128,
        };
        self.values.insert(name, value);
        self.inputs = S::inputs(&self.values);
    }
}

/// A tick or none as a rule; now and then so many that the clock soon wraps around. With [`LONGEST`] less than 2^31 pass between two cycles of the interpreter.
fn elapsed(chance: u64) -> u32 {
    match chance & 0xfff {
        0 => 1 << 30,
        1 => (1 << 30) - 1,
        2 => 70_000,
        3..16 => 500,
        even if even % 2 == 0 => 1,
        _ => 0,
    }
}
