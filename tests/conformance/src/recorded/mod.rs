//! Random charts that are recorded and that lose their power: afterwards they go on, and their record shows, as if nothing had been.

mod kept;
mod resumed;
mod soak;
pub mod written;

use grafcet::Chart;
use grafcet_compiler::model::Model;
use grafcet_core::record::{Blocked, Recordable};
use grafcet_core::recordable;

use crate::generated::Mode;
use crate::oracle::Interpreted;
use crate::reader::Line;
use crate::{Shown, Values, play};

pub use soak::{Done, Long, Soak, soak};

recordable! { Mode { Off, Auto, Manual } }

/// What a compiled chart of the comparison says of itself beside [`Subject`](crate::Subject); the emitted code implements it.
pub trait Recorded: 'static {
    /// The chart.
    type Chart: Recordable<Outputs: PartialEq> + Blocked;

    /// In its initial situation.
    fn make() -> Self::Chart;

    /// Inputs by name; those that are not named are false or zero.
    fn inputs(values: &Values) -> Inputs<Self>;

    /// Lends the code actions to `run`, and tells the calls.
    fn called(run: &mut dyn FnMut(&mut Actions<'_, Self>)) -> Vec<String>;

    /// Lends code actions to `run` that do nothing.
    fn silently(run: &mut dyn FnMut(&mut Actions<'_, Self>));

    /// What it shows; no calls.
    fn shown(chart: &Self::Chart, outputs: &Outputs<Self>) -> Shown;

    /// What it shows before its first cycle.
    fn begun(chart: &Self::Chart) -> Shown;

    /// The recipe as declared, but for what is named.
    fn set_params(chart: &mut Self::Chart, recipe: &Values);
}

type Inputs<S> = <<S as Recorded>::Chart as Chart>::Inputs;
type Outputs<S> = <<S as Recorded>::Chart as Chart>::Outputs;
type Actions<'a, S> = <<S as Recorded>::Chart as Chart>::Actions<'a>;

/// What a chart is compared by: its model, its text and its timeline.
pub type Check = fn(&Model, &str, &[Line]) -> Result<Traces, String>;

/// What was shown from a chart's source.
#[derive(Clone, Copy, Default, Debug)]
pub struct Traces {
    /// Records and frames.
    pub all: u32,
    /// Those of them with cycles that are not shown: after a state that does not tell all.
    pub untold: u32,
}

/// That a chart goes on when it is restored, and that its record shows what it did.
#[must_use]
pub const fn checks<S: Recorded>() -> [Check; 2] {
    [goes_on::<S>, is_shown::<S>]
}

/// A chart that is restored at random moments does what the interpreter does, which never stops.
fn goes_on<S: Recorded>(model: &Model, text: &str, lines: &[Line]) -> Result<Traces, String> {
    let mut resumed = resumed::Resumed::<S>::new(text.len() as u64);
    play::in_lockstep(&mut resumed, &mut Interpreted::new(model)?, lines).map_err(|found| found.to_string())?;
    Ok(Traces::default())
}

/// A chart in a recorder does what the interpreter does, and its record shows it again: to the compiled chart, and to the simulation from the
/// chart's source.
fn is_shown<S: Recorded>(model: &Model, text: &str, lines: &[Line]) -> Result<Traces, String> {
    let mut kept = kept::Kept::<S>::new(text.len())?;
    play::in_lockstep(&mut kept, &mut Interpreted::new(model)?, lines).map_err(|found| found.to_string())?;
    kept.flush();
    kept.by_the_chart()?;
    kept.over_the_wire()?;
    kept.by_the_source(text)
}

/// The calls but for repeated ones: what a cycle that was only counted has called is not told.
fn once(calls: &[String]) -> impl Iterator<Item = &String> {
    calls.iter().filter(|call| !call.starts_with("repeated"))
}
