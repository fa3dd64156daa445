//! A record of the controller, run again from the chart's source alone.

mod layout;
mod live;
mod wire;

use std::fmt;

use grafcet_core::record::{Block, Change, Damage, Happened, Key, Reader, Records};

pub use self::layout::Layout;
pub use self::live::Live;
use crate::chart::Chart;
use crate::cycle::{Cycle, Gap};
use crate::names::{Kind, Signal};
use crate::program::Program;
use crate::simulation::{Error, Simulation};
use crate::trace::Trace;
use crate::value::Value;

/// How a record is run again.
#[derive(Clone, Default)]
pub struct Replay<'p> {
    program: Program<'p>,
    is_other: bool,
}

/// Why a record cannot be run again.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ReplayError {
    /// There is no record in these bytes, or nothing of it is whole.
    NoRecord,
    /// The record is of another chart, or of another version of this one.
    OtherChart {
        /// The fingerprint in the record.
        recorded: u32,
        /// That of the source; none where the chart was made of a model.
        source: Option<u32>,
    },
    /// The bits of an input or parameter are no value: the record is of a chart with others.
    Values(String),
    /// The record has more inputs or parameters than the chart.
    More,
    /// A type of the program, of which the source does not tell how it is written down: list its variants in the chart.
    Type(String),
    /// A cycle cannot be run.
    Chart(Error),
}

impl fmt::Display for ReplayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoRecord => f.write_str("there is no record in these bytes, or nothing of it is whole"),
            Self::OtherChart { recorded, source: Some(source) } => {
                write!(
                    f,
                    "the record is of another chart or version: its fingerprint is {recorded:08x}, that of the source {source:08x}"
                )
            }
            Self::OtherChart { recorded, source: None } => {
                write!(f, "whether the record is of this chart is not known: its fingerprint is {recorded:08x}")
            }
            Self::Values(name) => write!(f, "what is recorded of `{name}` is no value of it"),
            Self::More => f.write_str("the record has more inputs or parameters than the chart"),
            Self::Type(name) => {
                write!(f, "how `{name}` is recorded does not follow from the source: list its variants")
            }
            Self::Chart(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for ReplayError {}

impl From<Error> for ReplayError {
    fn from(error: Error) -> Self {
        Self::Chart(error)
    }
}

impl<'p> Replay<'p> {
    /// With nothing around the chart.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// What the program around the chart contributes.
    #[must_use]
    pub fn beside(mut self, program: Program<'p>) -> Self {
        self.program = program;
        self
    }

    /// Also a record of another version of the chart with the same inputs and parameters: to see what a change of the chart changes. The
    /// trace has a warning.
    #[must_use]
    pub fn even_if_changed(mut self) -> Self {
        self.is_other = true;
        self
    }

    /// Runs the record, which are the bytes of a recorder's memory.
    ///
    /// What is missing or not known is a gap in the trace, and what differs from the recorded states a warning.
    ///
    /// # Errors
    /// As [`ReplayError`] says.
    pub fn run(&self, chart: &Chart, record: &[u8]) -> Result<Trace, ReplayError> {
        let records = Records::of(record).map_err(|_| ReplayError::NoRecord)?;
        self.all(chart, (records.fingerprint(), records.layout()), |run| run.all(&records))
    }

    /// Runs what a recorder has sent over a wire: the bytes as they came, from the start of the controller on.
    ///
    /// What was lost or damaged is a gap in the trace up to the next state; what differs from the states that it tells, a warning. The
    /// hashes in between are those of the compiled chart, and are not looked at.
    ///
    /// # Errors
    /// As [`ReplayError`] says; `NoRecord` where no state came.
    pub fn frames(&self, chart: &Chart, bytes: &[u8]) -> Result<Trace, ReplayError> {
        let recorded = wire::owner(bytes).ok_or(ReplayError::NoRecord)?;
        self.all(chart, recorded, |run| run.frames(bytes, recorded))
    }

    fn all(
        &self,
        chart: &Chart,
        (recorded, stored): (u32, u32),
        run_all: impl FnOnce(&mut Run<'_>) -> Result<(), ReplayError>,
    ) -> Result<Trace, ReplayError> {
        let source = chart.fingerprint();
        let is_same = source == Some(recorded);
        if !is_same && !self.is_other {
            return Err(ReplayError::OtherChart { recorded, source });
        }
        let layout = is_same.then(|| Layout::of(chart)).flatten();
        let is_other_layout = layout.as_ref().is_some_and(|layout| layout.number() != stored);
        let mut run = Run::new(chart, self.program.clone(), layout.filter(|_| !is_other_layout));
        run_all(&mut run)?;
        let is_known = run.simulation.is_some();
        run.cover();
        let mut trace = match run.trace {
            Some(trace) => trace,
            None => Trace::of(&Simulation::beside(chart, self.program.clone())?),
        };
        if let (Some(gap), false) = (run.gap, is_known) {
            trace.warnings.push(format!("the end of the record is missing: {}", gap.reason));
        }
        if !is_same {
            trace.warnings.insert(0, ReplayError::OtherChart { recorded, source }.to_string());
        } else if run.layout.is_none() {
            let why = if is_other_layout { "another compiler has made them" } else { "the chart does not compile" };
            trace.warnings.push(format!("the recorded states could not be looked at: {why}"));
        }
        Ok(trace)
    }
}

/// So many bytes tell why something is missing, and what else has happened until it is known again.
const LONGEST_REASON: usize = 400;

/// A record that is being run.
struct Run<'r> {
    chart: &'r Chart,
    program: Program<'r>,
    layout: Option<Layout>,
    /// None where the state is not known.
    simulation: Option<Simulation<'r>>,
    trace: Option<Trace>,
    /// As they are written down.
    inputs: Vec<u8>,
    cycle: u32,
    /// How many cycles there were up to the last one that is shown.
    shown: u32,
    now: u32,
    /// What is to be said in front of the next cycle.
    gap: Option<Gap>,
}

impl<'r> Run<'r> {
    fn new(chart: &'r Chart, program: Program<'r>, layout: Option<Layout>) -> Self {
        let (inputs, simulation, trace, gap) = (Vec::new(), None, None, None);
        Self { chart, program, layout, simulation, trace, inputs, cycle: 0, shown: 0, now: 0, gap }
    }

    fn all(&mut self, records: &Records<'_>) -> Result<(), ReplayError> {
        for block in records.blocks() {
            let block = match block {
                Ok(block) => block,
                Err(damage) => {
                    self.lose(&said(damage));
                    continue;
                }
            };
            if block.missing > 0 {
                self.lose(&format!("{} blocks of the record were overwritten or are damaged", block.missing));
            }
            self.block(&block)?;
        }
        Ok(())
    }

    fn block(&mut self, block: &Block<'_>) -> Result<(), ReplayError> {
        self.key(&block.key)?;
        for entry in block.entries() {
            let entry = match entry {
                Ok(entry) => entry,
                Err(damage) => {
                    self.lose(&said(damage));
                    return Ok(());
                }
            };
            match entry.what {
                Happened::Cycle { elapsed, change } => self.cycle(entry.skipped, elapsed, change)?,
                Happened::State(key) => self.key(&key)?,
            }
        }
        if block.torn {
            self.lose("the program ended while it wrote an entry, or a bit of it has changed since");
        }
        Ok(())
    }

    fn cycle(&mut self, skipped: u32, elapsed: u32, change: Option<Change<'_>>) -> Result<(), ReplayError> {
        if let Some(change) = change {
            change.apply(&mut self.inputs);
        }
        self.cycle = self.cycle.wrapping_add(skipped);
        self.run(self.now.wrapping_add(elapsed), skipped)
    }

    /// From here on nothing is known.
    fn lose(&mut self, reason: &str) {
        self.cover();
        self.note(reason);
    }

    /// What the simulation so far has covered goes to the trace.
    fn cover(&mut self) {
        if let (Some(simulation), Some(trace)) = (self.simulation.take(), &mut self.trace) {
            trace.coverage.add(&simulation.coverage());
        }
    }

    fn note(&mut self, reason: &str) {
        let before = self.gap.take();
        // Of a line that is nothing but noise, the beginning tells enough.
        let is_told = |before: &Gap| before.reason.ends_with(reason) || before.reason.len() > LONGEST_REASON;
        if before.as_ref().is_some_and(is_told) {
            self.gap = before;
            return;
        }
        let reason = before.map_or_else(|| reason.to_owned(), |before| format!("{}; {reason}", before.reason));
        self.gap = Some(Gap { reason, cycles: None });
    }

    /// A cycle with the inputs as they are; `skipped` ones in front of it did nothing.
    fn run(&mut self, now: u32, skipped: u32) -> Result<(), ReplayError> {
        self.now = now;
        self.cycle = self.cycle.wrapping_add(1);
        let names = self.chart.names();
        let values = read(&names.inputs, &self.inputs)?;
        let Some(simulation) = &mut self.simulation else { return Ok(()) };
        let trace = self.trace.get_or_insert_with(|| Trace::of(simulation));
        let mut cycle = simulation.cycle_with(now, &values)?;
        let missing = self.cycle.wrapping_sub(1).wrapping_sub(skipped).checked_sub(self.shown);
        let missing = missing.filter(|missing| *missing > 0).map(u64::from);
        cycle.gap = self.gap.take().map(|gap| Gap { cycles: missing, ..gap });
        self.shown = self.cycle;
        cycle.skipped = skipped;
        trace.cycles.push(cycle);
        Ok(())
    }

    /// The cycles that were made since this was asked last.
    fn drain(&mut self) -> Vec<Cycle> {
        let Some(trace) = &mut self.trace else { return Vec::new() };
        // The gaps say it, too.
        trace.warnings.clear();
        std::mem::take(&mut trace.cycles)
    }

    /// The state that the chart is known to be in, though no cycle was seen that has led there.
    fn stands(&mut self) -> Result<Option<Cycle>, ReplayError> {
        let values = read(&self.chart.names().inputs, &self.inputs)?;
        let Some(simulation) = &mut self.simulation else { return Ok(None) };
        let mut cycle = simulation.stands(self.now, &values)?;
        self.trace.get_or_insert_with(|| Trace::of(simulation));
        let missing = self.cycle.checked_sub(self.shown).filter(|missing| *missing > 0).map(u64::from);
        cycle.gap = self.gap.take().map(|gap| Gap { cycles: missing, ..gap });
        self.shown = self.cycle;
        Ok(Some(cycle))
    }

    /// A state that is written down.
    fn key(&mut self, key: &Key<'_>) -> Result<(), ReplayError> {
        let params = read(&self.chart.names().params, key.params)?;
        if self.simulation.is_some() && self.cycle != key.cycle {
            // One cycle in place of all that did nothing.
            let skipped = key.cycle.wrapping_sub(self.cycle).wrapping_sub(1);
            self.cycle = self.cycle.wrapping_add(skipped);
            self.run(key.reading, skipped)?;
        }
        self.inputs = key.inputs.to_vec();
        (self.cycle, self.now) = (key.cycle, key.reading);
        // A chart that goes on can be in a state that is also its first one.
        if key.fresh && (key.replaced || self.simulation.is_none()) {
            if self.trace.is_some() {
                let begun = if key.replaced { "the chart began anew here" } else { "here the chart is as it begins" };
                self.note(begun);
            }
            self.cover();
            let mut simulation = Simulation::beside(self.chart, self.program.clone())?;
            set_params(&mut simulation, &params)?;
            self.simulation = Some(simulation);
            return Ok(());
        }
        let Some(simulation) = &mut self.simulation else { return self.begin(key, &params) };
        set_params(simulation, &params)?;
        let Some(layout) = &self.layout else { return Ok(()) };
        let difference = layout.difference(key.state, simulation);
        if !key.replaced {
            if let Some(difference) = difference {
                let said = format!("the replay differs from the record after {} cycles: {difference}", key.cycle);
                if let Some(trace) = &mut self.trace {
                    trace.warnings.push(said.clone());
                }
                self.lose(&said);
                return self.begin(key, &params);
            }
            return Ok(());
        }
        // What cannot be seen may be other than before, too.
        let (recalled, read) = layout.read(key.state, key.reading);
        let taken = read.and_then(|()| simulation.recall(&recalled));
        let said = format!("the chart was changed from outside after {} cycles", key.cycle);
        match (difference, taken) {
            (None, Ok(())) => {}
            (Some(difference), Ok(())) => self.note(&format!("{said}: {difference}")),
            (Some(difference), Err(unknown)) => self.lose(&format!("{said}: {difference}; {}", not_told(&unknown))),
            // What follows is shown as if that were as before; where it is not, the next state tells.
            (None, Err(unknown)) => self.note(&format!("{said}; {}, taken to be as it was", not_told(&unknown))),
        }
        Ok(())
    }

    /// The chart goes on from a recorded state, as what came before is not known.
    fn begin(&mut self, key: &Key<'_>, params: &[Value]) -> Result<(), ReplayError> {
        let Some(layout) = &self.layout else {
            self.note("the recorded state cannot be looked at");
            return Ok(());
        };
        let mut simulation = Simulation::beside(self.chart, self.program.clone())?;
        set_params(&mut simulation, params)?;
        let (recalled, read) = layout.read(key.state, key.reading);
        match read.and_then(|()| simulation.recall(&recalled)) {
            Ok(()) => self.simulation = Some(simulation),
            Err(unknown) => self.note(&not_told(&unknown)),
        }
        Ok(())
    }
}

fn not_told(unknown: &str) -> String {
    format!("the recorded state does not tell {unknown}")
}

fn said(damage: Damage) -> String {
    match damage {
        Damage::NoRecord => "nothing is whole".to_owned(),
        Damage::OtherChart { fingerprint } => format!("a part of the record is of another chart ({fingerprint:08x})"),
        Damage::OtherLayout => "a part of the record was made by another compiler".to_owned(),
        Damage::Nonsense => "bytes that mean nothing".to_owned(),
    }
}

fn set_params(simulation: &mut Simulation<'_>, params: &[Value]) -> Result<(), ReplayError> {
    let names = simulation.names();
    for (param, value) in names.params.iter().zip(params) {
        simulation.set_param(&param.name, value.clone())?;
    }
    Ok(())
}

/// The values that are written in these bits.
fn read(signals: &[Signal], bytes: &[u8]) -> Result<Vec<Value>, ReplayError> {
    let mut bits = Reader::new(bytes);
    let values = signals.iter().map(|signal| value(&mut bits, signal)).collect::<Result<_, _>>()?;
    // What is left of the last byte is zero.
    let left = bits.left();
    if left < 8 && bits.is_empty(left) { Ok(values) } else { Err(ReplayError::More) }
}

fn value(bits: &mut Reader<'_>, signal: &Signal) -> Result<Value, ReplayError> {
    let none = || ReplayError::Values(signal.name.clone());
    Ok(match &signal.kind {
        Kind::Bool => Value::Bool(bits.take(1).ok_or_else(none)? != 0),
        Kind::Int { signed, bits: width } => Value::Int(layout::int(bits, *width, *signed).ok_or_else(none)?),
        Kind::Time => Value::Ticks(bits.take(32).ok_or_else(none)?),
        Kind::Float(32) => Value::Float(f32::from_bits(bits.take(32).ok_or_else(none)?).into()),
        Kind::Float(_) => {
            let (low, high) = (bits.take(32).ok_or_else(none)?, bits.take(32).ok_or_else(none)?);
            Value::Float(f64::from_bits(u64::from(high) << 32 | u64::from(low)))
        }
        Kind::Listed(_, names) => {
            let place = bits.take(grafcet_core::record::bits_for(names.len())).ok_or_else(none)?;
            Value::Name(names.get(place as usize).ok_or_else(none)?.clone())
        }
        Kind::Other(_) => return Err(ReplayError::Type(signal.name.clone())),
    })
}
