//! Regions whose states go together share the place of the first of them.

use super::Program;
use crate::model::StepId;

/// Regions whose states go together: the place of the first one tells the states of all.
#[derive(Clone)]
pub struct United {
    /// In their order.
    pub regions: Vec<usize>,
    /// What that place tells, in the order of the steps that the states are named after: the name, and the steps that are active. It has no name where
    /// none is.
    pub states: Vec<(StepId, Vec<StepId>)>,
}

impl Program<'_> {
    /// The states that the place of a region tells, by the steps they are named after.
    #[must_use]
    pub fn states(&self, region: usize) -> Vec<StepId> {
        match self.united.iter().find(|united| united.regions[0] == region) {
            Some(united) => united.states.iter().map(|(name, _)| *name).collect(),
            None => self.regions[region].clone(),
        }
    }

    /// The steps that are active in a state of a region.
    #[must_use]
    pub fn active_in(&self, region: usize, state: StepId) -> Vec<StepId> {
        let united = self.united.iter().find(|united| united.regions[0] == region);
        let named = united.and_then(|united| united.states.iter().find(|(name, _)| *name == state));
        named.map_or_else(|| vec![state], |(_, active)| active.clone())
    }

    /// The region whose place tells whether a step is active, and in which of its states the step is.
    #[must_use]
    pub fn home(&self, step: StepId) -> (usize, Vec<StepId>) {
        // In order of declaration, each.
        let own = self.regions.iter().position(|steps| steps.binary_search(&step).is_ok()).unwrap_or_default();
        let Some(united) = self.united.iter().find(|united| united.regions.contains(&own)) else {
            return (own, vec![step]);
        };
        let states = united.states.iter().filter(|(_, active)| active.contains(&step));
        (united.regions[0], states.map(|(name, _)| *name).collect())
    }
}
