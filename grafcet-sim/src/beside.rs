//! A chart with a place for everything that it is given: its inputs, and what the program around it tells.

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

use grafcet_compiler::analysis::{Facts, Situations};
use grafcet_core::{ForceError, Possible};

use crate::{Chart, Cycle, Error, Kind, Program, Signal, Simulation, Value};

/// Values of what the program around the chart tells, by its text.
type Told = Rc<RefCell<Vec<(String, Value)>>>;

/// A chart with a place for everything that it is given: its inputs, and after them what the program around it tells ([`Chart::outside`]), so that somebody
/// can play with it who has no program.
pub struct Beside<'c> {
    chart: &'c Chart,
    signals: Vec<Signal>,
    told: Told,
    /// Which situations there are, once somebody has asked.
    situations: OnceCell<Situations>,
}

impl<'c> Beside<'c> {
    /// With nothing told yet.
    #[must_use]
    pub fn of(chart: &'c Chart) -> Self {
        let signals = chart.names().inputs.iter().cloned().chain(chart.outside()).collect();
        Self { chart, signals, told: Told::default(), situations: OnceCell::new() }
    }

    /// The chart before its first cycle.
    ///
    /// # Errors
    /// Something in the chart depends on itself, or an initial value is not understood.
    pub fn start(&self) -> Result<Simulation<'c>, Error> {
        let asked = Rc::clone(&self.told);
        // What blocks of Rust write is not known: they write nothing.
        let program = Program::new().block(|_| Some(Vec::new())).function(move |question| {
            let told = asked.borrow();
            told.iter().find(|(text, _)| question.is(text)).map(|(_, value)| value.clone())
        });
        Simulation::beside(self.chart, program)
    }

    /// One cycle with a value for each signal; what went before stays as it is.
    ///
    /// # Errors
    /// The chart's own arithmetic fails, or a value does not fit.
    pub fn cycle(&self, before: &Simulation<'c>, now: u32, values: &[Value]) -> Result<(Simulation<'c>, Cycle), Error> {
        let inputs = self.tell(values);
        let mut next = before.clone();
        let cycle = next.cycle_with(now, inputs)?;
        Ok((next, cycle))
    }

    /// The same with a cycle that leads into the situation of these steps by hand, as [`Simulation::force`].
    ///
    /// # Errors
    /// As of [`Beside::cycle`], or there is no step of that name.
    pub fn force(
        &self,
        before: &Simulation<'c>,
        now: u32,
        values: &[Value],
        steps: &[&str],
    ) -> Result<(Simulation<'c>, Cycle), Error> {
        let inputs = self.tell(values).iter().cloned();
        let named: Vec<(&str, Value)> = self.signals.iter().map(|signal| signal.name.as_str()).zip(inputs).collect();
        let mut next = before.clone();
        let cycle = next.force(now, steps, &named)?;
        Ok((next, cycle))
    }

    /// Whether the compiled chart lets itself be put into exactly these steps by hand.
    ///
    /// # Errors
    /// It is not `forceable;`, has no such step, or is never in exactly these: why, as a sentence for the user.
    pub fn may_be(&self, steps: &[&str]) -> Result<(), String> {
        let (model, names) = (self.chart.model(), self.chart.names());
        if !model.forceable {
            return Err("the chart takes no cycle by hand: it does not say `forceable;`".to_owned());
        }
        let place = |step: &&str| names.step_named(step).ok_or_else(|| format!("there is no step `{step}`"));
        let places = steps.iter().map(place).collect::<Result<Vec<usize>, String>>()?;
        let all: Vec<usize> = (0..model.steps.len()).collect();
        let situations = self.situations.get_or_init(|| Situations::of(model, &Facts::of(model)));
        let name = |place: usize| &names.steps[place].name;
        possible(situations).look(&all, &places).map_err(|error| match error {
            ForceError::NeverTogether(one, other) => {
                format!("`{}` and `{}` are never active together", name(one), name(other))
            }
            ForceError::NoSituation => "the chart has no situation of exactly these steps".to_owned(),
        })
    }

    /// Tells what is the program's; the inputs are left.
    fn tell<'v>(&self, values: &'v [Value]) -> &'v [Value] {
        let (inputs, outside) = values.split_at(self.inputs());
        let texts = self.signals[inputs.len()..].iter().map(|signal| signal.name.clone());
        *self.told.borrow_mut() = texts.zip(outside.iter().cloned()).collect();
        inputs
    }

    /// The chart.
    #[must_use]
    pub fn chart(&self) -> &'c Chart {
        self.chart
    }

    /// The chart's inputs, and after them what the program around it tells.
    #[must_use]
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// So many of the signals are the chart's inputs.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.chart.names().inputs.len()
    }

    /// What the signals are before anybody has set them.
    #[must_use]
    pub fn first(&self) -> Vec<Value> {
        (0..self.signals.len()).map(|place| self.first_of(place)).collect()
    }

    /// What one of them is then. A name that stands for itself is no variant that the chart names, where that is a function's, and the one that is meant, where it is a constant's.
    #[must_use]
    pub fn first_of(&self, place: usize) -> Value {
        let signal = &self.signals[place];
        match &signal.kind {
            Kind::Bool => Value::Bool(false),
            Kind::Int { .. } => Value::Int(0),
            Kind::Float(_) => Value::Float(0.0),
            Kind::Time => Value::Ticks(0),
            Kind::Listed(_, list) => list.first().map_or(Value::Unknown, |first| Value::Name(first.clone())),
            Kind::Other(_) if place < self.inputs() => Value::Name("?".to_owned()),
            Kind::Other(_) => Value::Name(signal.name.split_whitespace().collect()),
        }
    }
}

/// The situations of a chart, as the compiled chart has them.
fn possible(situations: &Situations) -> Possible<'_> {
    match situations {
        Situations::Unknown => Possible::Unknown,
        Situations::Alone => Possible::Alone,
        Situations::Listed(table) => Possible::Listed(table),
        Situations::Diagram(table) => Possible::Diagram(table),
        Situations::Pairs(table) => Possible::Pairs(table),
        Situations::Parts(pairs, parts) => Possible::Parts(pairs, parts),
        Situations::Whole(table) => Possible::Whole(table),
    }
}
