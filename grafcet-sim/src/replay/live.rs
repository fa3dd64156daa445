//! A chart on the controller, followed while its frames come.

use grafcet_core::record::wire::{Frame, Received};

use super::{Layout, Replay, Run};
use crate::chart::Chart;
use crate::cycle::Cycle;
use crate::simulation::Simulation;
use crate::value::Value;

/// A chart that is followed frame by frame, in as much memory as the chart itself takes: what was shown is not kept.
///
/// After a frame that was lost or damaged nothing is shown up to the next state that the controller tells; the first cycle after it says so
/// ([`Cycle::gap`]).
///
/// ```
/// use grafcet_core::record::wire::Decoder;
/// use grafcet_sim::{Chart, Replay};
///
/// let chart = Chart::parse("sfc Motor { input on: bool; initial step Off; step On; Off -[on]-> On -[!on]-> Off; }")?;
/// let mut live = Replay::new().live(&chart);
/// let mut decoder = Decoder::new([0; 256]);
/// # let bytes: &[u8] = &[];
/// for byte in bytes {
///     match decoder.byte(*byte) {
///         None => {}
///         Some(Ok(received)) => for cycle in live.frame(&received) {
///             println!("{:?}", cycle.steps);
///         },
///         Some(Err(_)) => live.lost("a frame was damaged"),
///     }
/// }
/// assert_eq!(live.unknown(), Some("no state has come yet"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Live<'c> {
    run: Run<'c>,
    fingerprint: Option<u32>,
    /// While the controller's compiler stores the state otherwise.
    set_aside: Option<Layout>,
}

impl<'p> Replay<'p> {
    /// Follows a controller while its frames come.
    #[must_use]
    pub fn live(&self, chart: &'p Chart) -> Live<'p> {
        let run = Run::new(chart, self.program.clone(), Layout::of(chart));
        Live { run, fingerprint: chart.fingerprint(), set_aside: None }
    }
}

impl<'c> Live<'c> {
    /// Takes a frame, and returns what it tells of the chart: mostly a cycle; or the state that the chart is in, where nothing was known before, as
    /// a cycle in which nothing happens.
    pub fn frame(&mut self, received: &Received<'_>) -> Vec<Cycle> {
        let Some(fingerprint) = self.fingerprint else { return Vec::new() };
        let was_known = self.run.simulation.is_some();
        let mut stands = false;
        let mut owner = (fingerprint, 0);
        if let Some(Frame::State { layout, key, .. }) = received.frame {
            owner.1 = layout;
            self.choose(layout);
            stands = key.cycle > 0;
        }
        let done = self.run.received(received, owner).and_then(|()| {
            let mut cycles = self.run.drain();
            let is_news = !was_known || self.run.gap.is_some();
            if cycles.is_empty() && stands && is_news {
                cycles.extend(self.run.stands()?);
            }
            Ok(cycles)
        });
        done.unwrap_or_else(|error| {
            self.run.lose(&error.to_string());
            Vec::new()
        })
    }

    /// Something did not come: from here on nothing is known.
    pub fn lost(&mut self, reason: &str) {
        self.run.lose(reason);
    }

    /// Why it is not known what the chart does now.
    #[must_use]
    pub fn unknown(&self) -> Option<&str> {
        match (&self.run.simulation, &self.run.gap) {
            (Some(_), _) => None,
            (None, Some(gap)) => Some(&gap.reason),
            (None, None) => Some("no state has come yet"),
        }
    }

    /// How many cycles the controller has made, where that is known.
    #[must_use]
    pub fn number(&self) -> u32 {
        self.run.cycle
    }

    /// The parameters in force, where they are known.
    #[must_use]
    pub fn params(&self) -> Vec<Value> {
        self.run.simulation.as_ref().map(Simulation::params).unwrap_or_default()
    }

    /// The steps that are late, by name.
    #[must_use]
    pub fn late_steps(&self) -> Vec<&'c str> {
        self.run.simulation.as_ref().map(Simulation::late_steps).unwrap_or_default()
    }

    /// The chart.
    #[must_use]
    pub fn chart(&self) -> &'c Chart {
        self.run.chart
    }

    /// States can be read only where the controller's compiler has stored them as this one does.
    fn choose(&mut self, layout: u32) {
        let own = self.run.layout.take().or_else(|| self.set_aside.take());
        let is_same = own.as_ref().is_some_and(|own| own.number() == layout);
        (self.run.layout, self.set_aside) = if is_same { (own, None) } else { (None, own) };
    }
}
