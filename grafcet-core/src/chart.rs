//! What every chart has in common, for generic code.

use core::fmt::{Debug, Display};

use crate::Ticks;

/// A chart that `grafcet!` has generated.
///
/// The generated types have inherent methods for daily use; this trait is the uniform form, with the arguments a
/// particular chart may not need.
pub trait Chart {
    /// The process inputs, sampled once per cycle.
    type Inputs;
    /// The process outputs of one cycle.
    type Outputs;
    /// The names of the steps.
    type Step: Copy + Eq + Debug + Display + 'static;
    /// The names of the transitions.
    type Transition: Copy + Eq + Debug + Display + 'static;
    /// The situation: which steps are active.
    type Situation: Copy + Eq + Debug + Display;
    /// What carries out the chart's code actions; `()` where it has none.
    type Actions<'a>: ?Sized;

    /// The name of the chart in the source.
    const NAME: &'static str;
    /// All steps, in the order of their declaration.
    const STEPS: &'static [Self::Step];
    /// All transitions, in the order of the source.
    const TRANSITIONS: &'static [Self::Transition];

    /// One cycle: samples `inputs` at the time `now`, evolves and acts. A chart that does not use time ignores `now`.
    fn scan(&mut self, inputs: &Self::Inputs, now: Ticks, actions: &mut Self::Actions<'_>) -> Self::Outputs;

    /// Back to the initial situation (the classic *Init*): the next cycle is a first one.
    fn init(&mut self);

    /// Whether a step is active.
    fn is_active(&self, step: Self::Step) -> bool;

    /// Which steps are active.
    fn situation(&self) -> Self::Situation;

    /// Whether these steps are active, in any order, and no others.
    fn is_exactly(&self, steps: &[Self::Step]) -> bool {
        Self::STEPS.iter().all(|step| self.is_active(*step) == steps.contains(step))
    }
}
