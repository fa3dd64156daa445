//! What happened, cycle by cycle.

use crate::coverage::Coverage;
use crate::cycle::{Cycle, Gap};
use crate::names::{Kind, Names, Signal};
use crate::script::Scripted;
use crate::simulation::{Error, Simulation};
use crate::value::Value;

/// What happened, cycle by cycle: what tables, waveforms, chronograms and pages are made of.
#[derive(Clone, PartialEq, Debug)]
pub struct Trace {
    pub names: Names,
    /// At the beginning.
    pub params: Vec<Value>,
    /// The steps that were active before the first cycle.
    pub initial: Vec<usize>,
    pub cycles: Vec<Cycle>,
    /// What the cycles have covered.
    pub coverage: Coverage,
    /// What is not true of the whole: another version of the chart, a state that differs. Every view shows it.
    pub warnings: Vec<String>,
}

impl Trace {
    /// An empty one of what this simulation does next.
    #[must_use]
    pub fn of(simulation: &Simulation<'_>) -> Self {
        Self {
            names: simulation.names().clone(),
            params: simulation.params(),
            initial: simulation.steps(),
            cycles: Vec::new(),
            coverage: Coverage::of(simulation.chart()),
            warnings: Vec::new(),
        }
    }

    /// Runs the simulation through cycles: the time of each, and the inputs that change.
    ///
    /// # Errors
    /// As of [`Simulation::cycle`].
    pub fn run<'i>(
        simulation: &mut Simulation<'_>,
        cycles: impl IntoIterator<Item = (u32, Vec<(&'i str, Value)>)>,
    ) -> Result<Self, Error> {
        let mut trace = Self::of(simulation);
        for (now, inputs) in cycles {
            trace.cycles.push(simulation.cycle(now, &inputs)?);
        }
        trace.coverage = simulation.coverage();
        Ok(trace)
    }

    /// Runs the simulation through a script, as [`script`](crate::script()) reads it.
    ///
    /// # Errors
    /// As of [`Simulation::cycle`].
    pub fn play(simulation: &mut Simulation<'_>, cycles: &[Scripted]) -> Result<Self, Error> {
        let mut trace = Self::of(simulation);
        for (now, inputs) in cycles {
            trace.cycles.push(simulation.cycle_with(*now, inputs)?);
        }
        trace.coverage = simulation.coverage();
        Ok(trace)
    }

    /// The time from the first cycle to each, in ticks; the clock may have wrapped around meanwhile.
    #[must_use]
    pub fn times(&self) -> Vec<u64> {
        let mut total = 0;
        let mut before: Option<u32> = None;
        let mut times = Vec::with_capacity(self.cycles.len());
        for cycle in &self.cycles {
            total += before.map_or(0, |before| u64::from(cycle.now.wrapping_sub(before)));
            before = Some(cycle.now);
            times.push(total);
        }
        times
    }

    /// The gaps, and the cycles after them.
    pub fn gaps(&self) -> impl Iterator<Item = (usize, &Gap)> {
        self.cycles.iter().enumerate().filter_map(|(index, cycle)| Some((index, cycle.gap.as_ref()?)))
    }

    /// The first cycle at which two traces of a chart differ in what is seen from outside: active steps, outputs, calls. Steps and
    /// outputs are compared by name, so that versions of a chart can be compared.
    #[must_use]
    pub fn first_difference(&self, other: &Self) -> Option<Difference> {
        let cycles = self.cycles.iter().zip(&other.cycles).enumerate();
        for (index, (a, b)) in cycles {
            let (here, there) = (self.seen(a), other.seen(b));
            if let Some((here, there)) = here.into_iter().zip(there).find(|(here, there)| here != there) {
                return Some(Difference { cycle: index, here, there });
            }
        }
        let (here, there) = (self.cycles.len(), other.cycles.len());
        let count = |count: usize| format!("{count} cycles");
        (here != there).then(|| Difference { cycle: here.min(there), here: count(here), there: count(there) })
    }

    /// What a cycle showed, in words that can be compared.
    pub(crate) fn seen(&self, cycle: &Cycle) -> [String; 3] {
        let mut steps: Vec<&str> = cycle.steps.iter().map(|step| self.names.steps[*step].name.as_str()).collect();
        steps.sort_unstable();
        let outputs = self.names.outputs.iter().zip(&cycle.outputs);
        let text = |(output, value): (&Signal, &Value)| match (&output.kind, value) {
            // Two of them that differ are never one text.
            (Kind::Float(64), Value::Float(value)) => format!("{} = {value}", output.name),
            (_, value) => format!("{} = {value}", output.name),
        };
        let mut outputs: Vec<String> = outputs.map(text).collect();
        outputs.sort_unstable();
        let calls = cycle.calls.iter().map(|call| {
            let args: Vec<String> = call.args.iter().map(ToString::to_string).collect();
            format!("{}({}) {:?}", call.action, args.join(", "), call.phase)
        });
        let calls: Vec<String> = calls.collect();
        [
            format!("steps {}", steps.join(", ")),
            format!("outputs {}", outputs.join(", ")),
            format!("calls {}", calls.join(", ")),
        ]
    }
}

/// Where two traces differ first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// Counted from zero.
    pub cycle: usize,
    pub here: String,
    pub there: String,
}

impl std::fmt::Display for Difference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "cycle {}: {}, but {}", self.cycle, self.here, self.there)
    }
}
