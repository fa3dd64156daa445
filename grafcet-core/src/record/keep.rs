//! Where a recorder writes.

use super::chart::Recordable;
use super::encode::{Cycle, State};
#[cfg(feature = "wire")]
use super::wire::Answer;

/// Where a recorder writes: [`Memory`](super::Memory), a wire, or a pair of both.
pub trait Keep {
    /// Whether a state has to be written in front of the next cycle.
    #[doc(hidden)]
    fn is_due<C: Recordable>(&self) -> bool;

    /// Writes a state.
    #[doc(hidden)]
    fn state<C: Recordable>(&mut self, state: &State<'_, C>);

    /// Writes the inputs of a cycle, in front of it.
    #[doc(hidden)]
    fn cycle<C: Recordable>(&mut self, cycle: &Cycle<'_, C>);

    /// After a cycle whose inputs were written.
    #[doc(hidden)]
    fn after<C: Recordable>(&mut self, chart: &C) {
        _ = chart;
    }

    /// Tells the host what became of a command, where there is one.
    #[cfg(feature = "wire")]
    #[doc(hidden)]
    fn answer<C: Recordable>(&mut self, answer: &Answer) {
        _ = answer;
    }
}

/// Both get everything. A state that one of them asks for goes to the other one, too: otherwise it would not know of the cycles in front of it that were
/// only counted.
impl<A: Keep, B: Keep> Keep for (A, B) {
    fn is_due<C: Recordable>(&self) -> bool {
        self.0.is_due::<C>() || self.1.is_due::<C>()
    }

    fn state<C: Recordable>(&mut self, state: &State<'_, C>) {
        self.0.state(state);
        self.1.state(state);
    }

    fn cycle<C: Recordable>(&mut self, cycle: &Cycle<'_, C>) {
        self.0.cycle(cycle);
        self.1.cycle(cycle);
    }

    fn after<C: Recordable>(&mut self, chart: &C) {
        self.0.after(chart);
        self.1.after(chart);
    }

    #[cfg(feature = "wire")]
    fn answer<C: Recordable>(&mut self, answer: &Answer) {
        self.0.answer::<C>(answer);
        self.1.answer::<C>(answer);
    }
}
