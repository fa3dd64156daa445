//! What one cycle showed.

use crate::blocked::Blocked;
pub use crate::interp::Phase;
use crate::value::Value;

/// What one cycle showed. Steps, transitions and partial grafcets are their places in [`Names`](crate::Names); values are in the order
/// of declaration.
#[derive(Clone, PartialEq, Debug)]
pub struct Cycle {
    /// In ticks of the chart's clock.
    pub now: u32,
    /// What is not known of the time before it.
    pub gap: Option<Gap>,
    /// So many cycles between the one before and this one did nothing of their own, with the inputs as they were; a record does not say when.
    pub skipped: u32,
    pub inputs: Vec<Value>,
    /// The active steps at its end.
    pub steps: Vec<usize>,
    pub outputs: Vec<Value>,
    /// Those that hold a value.
    pub variables: Vec<Value>,
    /// In their order. An `sfc` has one at most. The activation of the initial situation is none.
    pub evolutions: Vec<Evolution>,
    /// The partial grafcets that are forced at its end.
    pub forced: Vec<Forced>,
    /// The declared actions that were called, in their order.
    pub calls: Vec<Call>,
    /// Blocks and assignments that ran, in their order.
    pub ran: Vec<Ran>,
    /// `grafcet`: the search for a stable situation came to its end.
    pub is_stable: bool,
    /// What the chart waits for at its end.
    pub blocked: Blocked,
}

/// One evolution.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Evolution {
    /// The transitions that cleared. None where the hierarchy alone changed the situation.
    pub cleared: Vec<usize>,
    /// The steps that were left, in an `sfc` those entered anew included.
    pub deactivated: Vec<usize>,
    /// The steps that were entered, in an `sfc` those left in the same evolution included.
    pub activated: Vec<usize>,
    /// The active steps after it.
    pub steps: Vec<usize>,
}

/// A partial grafcet that is forced.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Forced {
    pub partial: usize,
    /// The step with the order.
    pub by: usize,
    /// `{A, B}`, `{}`, `{*}`, `{INIT}`
    pub order: String,
}

/// A call of a declared action.
#[derive(Clone, PartialEq, Debug)]
pub struct Call {
    pub action: String,
    pub phase: Phase,
    pub args: Vec<Value>,
}

/// What ran beside calls.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Ran {
    /// The step it belongs to.
    pub step: usize,
    /// `count = count + 1`
    pub text: String,
}

/// Something is missing in front of a cycle.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Gap {
    /// What happened, in words.
    pub reason: String,
    /// So many cycles, where somebody counted.
    pub cycles: Option<u64>,
}

impl Cycle {
    /// Whether it shows anything that the one before did not, its time and its inputs aside.
    #[must_use]
    pub fn shows_more_than(&self, before: &Self) -> bool {
        let told = |cycle: &Self| (cycle.forced.clone(), cycle.calls.clone(), cycle.ran.clone(), cycle.is_stable);
        let seen = (&self.steps, &self.outputs, &self.variables) != (&before.steps, &before.outputs, &before.variables);
        seen || !self.evolutions.is_empty() || told(before) != told(self)
    }

    /// The evolutions that cleared a transition.
    pub fn cleared(&self) -> impl Iterator<Item = usize> {
        self.evolutions.iter().flat_map(|evolution| evolution.cleared.iter().copied())
    }
}
