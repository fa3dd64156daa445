//! A look at a chart between two cycles.

use std::collections::BTreeMap;

use super::hierarchy;
use super::modes::{self, Mode};
use super::remembered::Remembered;
use super::state::State;
use super::value::{Error, Value};
use super::view::View;
use super::world::Given;
use grafcet_compiler::model::{Blinker, DelayId, Model, Name, PartialId, StepId, TimeRef, TransitionId, Tree};

/// What expressions are between two cycles.
pub struct Look<'a> {
    pub(super) model: &'a Model,
    pub(super) state: &'a State,
    pub(super) given: Given<'a>,
    /// As they were sampled last.
    pub(super) delays: BTreeMap<DelayId, bool>,
    /// What properties remember, where one is looked at.
    pub(super) remembered: Option<&'a Remembered>,
}

/// How far a delay has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Counted {
    /// What it delays holds.
    pub signal: bool,
    /// For so many ticks; the time between two cycles counts where it did so in both.
    pub ticks: u32,
    /// What the delay says.
    pub output: bool,
}

impl Look<'_> {
    pub(super) fn view(&self) -> View<'_> {
        View { remembered: self.remembered, ..self.state.view(self.model, self.given, &self.delays) }
    }

    /// Whether a condition holds.
    ///
    /// # Errors
    /// It is not understood, or would panic in Rust.
    pub fn holds(&self, tree: &Tree) -> Result<bool, Error> {
        self.view().holds(tree)
    }

    /// The value of a name.
    ///
    /// # Errors
    /// As of [`Look::holds`].
    pub fn name(&self, name: Name) -> Result<Value, Error> {
        self.view().value_of(name)
    }

    /// The value of a time.
    ///
    /// # Errors
    /// As of [`Look::holds`].
    pub fn ticks(&self, time: TimeRef) -> Result<u32, Error> {
        self.view().ticks(time)
    }

    /// How long a step or macro-step has been active; zero where it is not.
    #[must_use]
    pub fn since(&self, of: Blinker) -> u32 {
        match of {
            Blinker::Step(step) => self.view().time_of(step),
            Blinker::Macro(id) => self.view().time_of_macro(id),
        }
    }

    /// How far a delay has come.
    #[must_use]
    pub fn delay(&self, id: DelayId) -> Counted {
        let delayed = self.state.delays.get(&id).copied().unwrap_or_default();
        let (signal, ticks) = delayed.counted();
        Counted { signal, ticks, output: delayed.output }
    }

    /// Whether the chart has made no cycle yet, or begins anew.
    #[must_use]
    pub fn is_first(&self) -> bool {
        self.state.first
    }

    /// Whether all steps in front of a transition are active, frozen or not.
    #[must_use]
    pub fn follows(&self, id: TransitionId) -> bool {
        self.model.transitions[id].sources.iter().all(|step| self.state.situation.contains(step))
    }

    /// The mode in which a transition is held back; none where nothing holds it back.
    ///
    /// # Errors
    /// As of [`Look::holds`].
    pub fn mode(&self, id: TransitionId) -> Result<Option<Mode>, Error> {
        match (&self.model.modes, &self.model.transitions[id].held) {
            (Some(modes), Some(_)) => modes::mode(modes, &self.view()).map(Some),
            _ => Ok(None),
        }
    }

    /// The transition that clears by hand in place of this one: an earlier one that leaves one of its steps.
    #[must_use]
    pub fn goes_before(&self, id: TransitionId) -> Option<TransitionId> {
        modes::goes_before(id, &self.view())
    }

    /// The active step that forces a partial grafcet.
    #[must_use]
    pub fn forced_by(&self, id: PartialId) -> Option<StepId> {
        let gives = self.model.orders_on(id);
        gives.map(|force| force.step).rfind(|step| self.state.situation.contains(step))
    }

    /// Whether a partial grafcet may clear anything (A13, A17).
    #[must_use]
    pub fn is_free(&self, id: PartialId) -> bool {
        !self.model.is_grafcet() || hierarchy::is_free(id, &self.state.situation, self.model)
    }
}
