//! A chart at work for a long time. The compiled one runs each cycle; on stretches of these the interpreter runs beside it, and takes over the state that
//! the chart has come to alone.

use std::time::{Duration, Instant};

use grafcet::{Chart, Ticks};
use grafcet_compiler::model::Ty;
use grafcet_core::record::{Recordable, Writer, restore};
use grafcet_sim::Layout;

use super::resumed::bytes_of;
use super::{Outputs, Recorded};
use crate::oracle::Interpreted;
use crate::random::Rng;
use crate::{Shown, Subject, Values};

/// How long a chart runs, and how that is divided.
#[derive(Clone, Copy, Debug)]
pub struct Long {
    /// Cycles of the compiled chart in all.
    pub cycles: u64,
    /// After so much time it ends early.
    pub time: Duration,
    /// So many cycles of the interpreter a stretch has, …
    compared: u64,
    /// … or so many cycles in all: where nothing changes, the interpreter has nothing to do.
    beside: u64,
    /// So many cycles the chart is alone between two stretches.
    alone: u64,
}

impl Long {
    /// So many cycles, at most for so long.
    #[must_use]
    pub const fn new(cycles: u64, time: Duration) -> Self {
        Self { cycles, time, compared: 2_000, beside: 50_000, alone: 20_000 }
    }

    /// A moment: what CI has time for.
    pub const SHORT: Self =
        Self { cycles: 8_000, time: Duration::from_secs(60), compared: 200, beside: 2_000, alone: 1_000 };
}

/// So long the interpreter is told nothing, at most.
const LONGEST: u32 = 1 << 30;

/// What was done.
#[derive(Clone, Copy, Default, Debug)]
pub struct Done {
    /// Cycles of the compiled chart.
    pub cycles: u64,
    /// Those of them in stretches that the interpreter has followed.
    pub beside: u64,
    /// Those of them that the interpreter has run, too: the others had to be repetitions.
    pub compared: u64,
    /// Ticks that have passed.
    pub ticks: u64,
    /// Stretches that the interpreter has begun from the chart's state.
    pub taken_over: u64,
    /// Charts that have been followed all along since their state did not tell all once.
    pub followed: u64,
}

impl Done {
    /// As numbers in a line.
    #[must_use]
    pub fn line(&self) -> String {
        let Self { cycles, beside, compared, ticks, taken_over, followed } = self;
        format!("{cycles} {beside} {compared} {ticks} {taken_over} {followed}")
    }
}

/// The chart of a source for a long time.
pub type Soak = fn(&grafcet_sim::Chart, Long) -> Result<Done, String>;

/// Runs a chart. On a stretch, in a cycle that its `next_deadline` or, without time, its unchanged state calls a repetition, it has to show what it has shown; in all others what the interpreter
/// shows, which has not run the repetitions. After the cycles that it runs alone its state has to be one that `restore` takes, and the interpreter goes on from it.
///
/// # Errors
/// The first difference.
pub fn soak<S: Recorded>(source: &grafcet_sim::Chart, long: Long) -> Result<Done, String> {
    let end = Instant::now() + long.time;
    let mut run = Run::<S>::new(source)?;
    while run.done.cycles < long.cycles && Instant::now() < end {
        run.round(long).map_err(|error| format!("cycle {}: {error}", run.done.cycles))?;
    }
    Ok(run.done)
}

struct Run<'m, S: Recorded> {
    layout: Layout,
    chart: S::Chart,
    oracle: Interpreted<'m>,
    inputs: Drawn<'m, S>,
    /// What the last cycle has shown.
    outputs: Option<Outputs<S>>,
    now: u32,
    /// The last cycle that the interpreter has run, and for how long nothing changes since.
    at: u32,
    quiet: u32,
    done: Done,
}

impl<'m, S: Recorded> Run<'m, S> {
    fn new(source: &'m grafcet_sim::Chart) -> Result<Self, String> {
        let layout = Layout::of(source).ok_or("the source does not compile")?;
        if layout.number() != S::Chart::LAYOUT {
            return Err("the state is stored otherwise than the source says".to_owned());
        }
        let oracle = Interpreted::new(source.model())?;
        let (chart, inputs, done) = (S::make(), Drawn::new(source.model()), Done::default());
        Ok(Self { layout, chart, oracle, inputs, outputs: None, now: 0, at: 0, quiet: 0, done })
    }

    /// A stretch beside the interpreter, and cycles alone.
    fn round(&mut self, long: Long) -> Result<(), String> {
        self.inputs.redraw();
        let most = long.cycles;
        let (cycles, compared) = (self.done.cycles + long.beside, self.done.compared + long.compared);
        while self.done.cycles < cycles.min(most) && self.done.compared < compared {
            self.cycle()?;
            self.done.cycles += 1;
            self.done.beside += 1;
        }
        if self.done.cycles == most || self.done.followed > 0 {
            return Ok(());
        }
        self.alone(long.alone.min(most - self.done.cycles));
        self.take_over()
    }

    fn cycle(&mut self) -> Result<(), String> {
        let (elapsed, is_other) = self.inputs.next();
        self.now = self.now.wrapping_add(elapsed);
        self.done.ticks += u64::from(elapsed);
        let is_quiet = !is_other && self.now.wrapping_sub(self.at) < self.quiet && self.outputs.is_some();
        // Where it is asked at the chart's own deadlines alone, it does not notice a chart that is late.
        let is_asked = self.inputs.rng.below(16) == 0;
        if is_quiet && !is_asked { self.repeat() } else { self.compare() }
    }

    /// Nothing but a repetition.
    fn repeat(&mut self) -> Result<(), String> {
        let (before, now) = (self.chart.situation(), Ticks::new(self.now));
        let (chart, inputs) = (&mut self.chart, &self.inputs.inputs);
        let mut outputs = None;
        // Calls are repeated.
        let calls = S::called(&mut |actions| outputs = Some(chart.scan(inputs, now, actions)));
        let is_same = outputs == self.outputs && self.chart.situation() == before;
        if is_same && super::once(&calls).next().is_none() { Ok(()) } else { Err("no repetition".to_owned()) }
    }

    fn compare(&mut self) -> Result<(), String> {
        let expected = self.oracle.run(&self.inputs.values, self.now)?;
        let before = (!S::Chart::TIMED).then(|| self.chart.clone());
        let (chart, inputs, now) = (&mut self.chart, &self.inputs.inputs, Ticks::new(self.now));
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

    /// Nobody looks.
    fn alone(&mut self, cycles: u64) {
        let Self { chart, inputs, now, done, .. } = self;
        S::silently(&mut |actions| {
            for _ in 0..cycles {
                let (elapsed, _) = inputs.next();
                *now = now.wrapping_add(elapsed);
                done.ticks += u64::from(elapsed);
                chart.scan(&inputs.inputs, Ticks::new(*now), actions);
            }
        });
        self.done.cycles += cycles;
    }

    /// The interpreter goes on from the chart's state. Where that does not tell all, both begin anew, and the chart is not left alone again.
    fn take_over(&mut self) -> Result<(), String> {
        self.outputs = None;
        let stored = bytes_of(&self.chart)?;
        let restored = restore::<S::Chart>(&stored, self.now).map_err(|error| format!("alone: {error}"))?;
        if !restored.is_same_state(&self.chart) {
            return Err("what was restored is another state".to_owned());
        }
        let mut state = vec![0; S::Chart::STATE_BITS.div_ceil(8)];
        self.chart.write_state(&mut Writer::new(&mut state));
        let recalled = self.layout.recalled(&state, self.now);
        if recalled.and_then(|recalled| self.oracle.recall(&recalled)).is_ok() {
            self.done.taken_over += 1;
            return Ok(());
        }
        self.done.followed += 1;
        self.chart.init();
        self.oracle.init()
    }
}

/// Inputs and times, drawn cycle by cycle.
struct Drawn<'m, S: Recorded> {
    model: &'m grafcet_compiler::model::Model,
    rng: Rng,
    values: Values,
    inputs: super::Inputs<S>,
    /// Of `1 << calm` cycles an input changes in one.
    calm: u32,
}

impl<'m, S: Recorded> Drawn<'m, S> {
    fn new(model: &'m grafcet_compiler::model::Model) -> Self {
        let values = Values::new();
        let inputs = S::inputs(&values);
        let rng = Rng::new(S::Chart::FINGERPRINT.into());
        Self { model, rng, values, inputs, calm: 10 }
    }

    /// How often inputs change from now on.
    fn redraw(&mut self) {
        self.calm = u32::try_from(self.rng.between(2, 11)).unwrap_or(2);
    }

    /// How long after the last cycle the next one is, and whether its inputs are others.
    fn next(&mut self) -> (u32, bool) {
        let chance = self.rng.number();
        let is_other = chance >> (64 - self.calm) == 0;
        if is_other {
            self.change();
        }
        (elapsed(chance), is_other)
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
