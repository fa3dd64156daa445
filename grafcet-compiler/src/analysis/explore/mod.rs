//! How a chart can evolve: its reachable situations under all inputs.
//!
//! A cycle is run on inputs that are not known: an atom of a condition (an input, a comparison, a time) is decided when
//! a condition first asks for it, once for each possible answer, so that the cost follows the active steps and not the
//! number of inputs. What one run has decided is a class of valuations that all act alike.
//!
//! - `formula`, `compile`, `net`: the chart, its conditions over numbered atoms
//! - `scene`, `tape`, `knowledge`: one cycle's valuation, as far as it has been asked for
//! - `sfc`, `grafcet`, `hierarchy`, `writes`: what a cycle does
//! - `search`, `graph`, `verdicts`: from situation to situation, and what follows

mod path;

pub use path::{Activation, Deadlock, Demand, Given, Path, PathCycle, StuckJoin};

use crate::model::{Model, StepId, TransitionId, Tree};

/// How much is explored before the search gives up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Units of work: about one for each transition looked at and each atom decided.
    pub work: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { work: 100_000 }
    }
}

impl Limits {
    /// For `budget N;`: enough for this many situations.
    #[must_use]
    pub fn situations(count: u64) -> Self {
        Self { work: count.saturating_mul(64) }
    }
}

/// The answer to whether something can happen.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Answer {
    /// In no reachable situation.
    Never,
    /// The shortest way there.
    Possible(Path),
    /// The budget ran out, or the chart was only explored part by part.
    Unknown,
}

/// The reachable situations of a chart.
#[derive(Debug)]
pub struct Exploration {
    complete: bool,
}

impl Exploration {
    /// Explores a chart.
    #[must_use]
    pub fn of(model: &Model, limits: &Limits) -> Self {
        Self::watching(model, limits, &[])
    }

    /// Explores a chart, and evaluates boolean expressions at the end of each cycle, on its inputs, outputs and situation.
    #[must_use]
    pub fn watching(_model: &Model, _limits: &Limits, _watched: &[&Tree]) -> Self {
        Self { complete: false }
    }

    /// The budget sufficed: what is said never to happen never does, and everything that can happen was seen.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.complete
    }

    /// Complete, and nothing was taken as unknown: what is said to happen really can.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.complete
    }

    /// Whether some situation contains the step, transient ones included; `true` also where that could not be excluded.
    #[must_use]
    pub fn reachable(&self, _step: StepId) -> bool {
        true
    }

    /// Whether some situation enables the transition, or that could not be excluded.
    #[must_use]
    pub fn is_enabled(&self, _transition: TransitionId) -> bool {
        true
    }

    /// Whether the condition of the transition can hold while it is enabled (`sfc`: also where an earlier branch takes
    /// precedence), or that could not be excluded.
    #[must_use]
    pub fn can_clear(&self, _transition: TransitionId) -> bool {
        true
    }

    /// The shortest way to an evolution that activates the step while it is active and not left by that evolution.
    #[must_use]
    pub fn unsafe_step(&self, _step: StepId) -> Option<&Activation> {
        None
    }

    /// Situations at the end of a cycle from which a partial grafcet never goes on, those with a final step excepted;
    /// one for each set of its steps.
    #[must_use]
    pub fn deadlocks(&self) -> &[Deadlock] {
        &[]
    }

    /// AND-convergences that wait forever, one for each of their sources that waits.
    #[must_use]
    pub fn stuck_joins(&self) -> &[StuckJoin] {
        &[]
    }

    /// Whether two different steps can be active together, or that could not be excluded.
    #[must_use]
    pub fn together(&self, _a: StepId, _b: StepId) -> bool {
        true
    }

    /// The most steps that are ever active at the end of a cycle; `None` if that is not known.
    #[must_use]
    pub fn max_active(&self) -> Option<usize> {
        None
    }

    /// Whether the watched expression can hold at the end of a cycle.
    #[must_use]
    pub fn watched(&self, _index: usize) -> Answer {
        Answer::Unknown
    }

    /// Whether a situation can be reached from which there is no way to exactly `home` (at the end of a cycle).
    #[must_use]
    pub fn away_from(&self, _home: &[StepId]) -> Answer {
        Answer::Unknown
    }
}
