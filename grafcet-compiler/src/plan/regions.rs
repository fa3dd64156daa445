//! Which steps share a byte: steps that are never active together form a region, whose state is an enum of them.
//!
//! The regions are the colours of the concurrency relation, given greedily in order of declaration. The relation of a
//! well-nested chart has no induced path of four steps (it is a cograph), and on such a graph the greedy colouring
//! needs the fewest colours in any order: one for a chart without parallel branches, else one per parallel branch.

use crate::analysis::Concurrency;
use crate::model::{ForceOrder, Id, Model, StepId};

/// The position of a region.
pub type RegionId = usize;

/// Steps of which at most one is active.
pub struct Region {
    /// In order of declaration.
    pub steps: Vec<StepId>,
    /// The one that is active in the initial situation.
    pub initial: Option<StepId>,
    /// There may be situations in which none of the steps is active.
    pub may_be_empty: bool,
}

/// All regions of a chart.
pub struct Regions {
    regions: Vec<Region>,
    of_step: Vec<RegionId>,
}

impl Regions {
    /// Divides the steps of a chart.
    #[must_use]
    pub fn of(model: &Model, concurrency: &Concurrency) -> Self {
        let mut regions: Vec<Region> = Vec::new();
        let mut of_step = Vec::with_capacity(model.steps.len());
        for step in model.steps.ids() {
            let partial = model.steps[step].partial;
            let fits = |region: &Region| {
                region
                    .steps
                    .iter()
                    .all(|other| model.steps[*other].partial == partial && !concurrency.together(step, *other))
            };
            let region = regions.iter().position(fits).unwrap_or_else(|| {
                regions.push(Region { steps: Vec::new(), initial: None, may_be_empty: true });
                regions.len() - 1
            });
            regions[region].steps.push(step);
            if starts(model, step) {
                regions[region].initial = Some(step);
            }
            of_step.push(region);
        }
        let mut all = Self { regions, of_step };
        for region in 0..all.regions.len() {
            all.regions[region].may_be_empty = all.may_become_empty(model, region);
        }
        all
    }

    /// The region of a step.
    #[must_use]
    pub fn of_step(&self, step: StepId) -> RegionId {
        self.of_step[step.index()]
    }

    /// All regions.
    #[must_use]
    pub fn all(&self) -> &[Region] {
        &self.regions
    }

    /// The situation is one step: the chart has no parallel branches and never stands without an active step.
    #[must_use]
    pub fn is_single(&self) -> bool {
        matches!(&self.regions[..], [region] if !region.may_be_empty)
    }

    /// Whether a region starts empty, or something takes its active step away without giving it another.
    fn may_become_empty(&self, model: &Model, region: RegionId) -> bool {
        let here = |step: &StepId| self.of_step(*step) == region;
        let partial = self.regions[region].steps.first().map(|step| model.steps[*step].partial);
        let forced = model.forces.values().any(|f| Some(f.target) == partial && f.order != ForceOrder::Hold);
        let enclosed = partial.is_some_and(|partial| model.partials[partial].enclosed_by.is_some());
        self.regions[region].initial.is_none()
            || forced
            || enclosed
            || model.transitions.values().any(|t| t.sources.iter().any(here) && !t.targets.iter().any(here))
    }
}

/// Whether a step is active in the initial situation: initial steps of an enclosure are only where the enclosing step is.
#[must_use]
pub fn starts(model: &Model, step: StepId) -> bool {
    let step = &model.steps[step];
    step.initial && model.partials[step.partial].enclosed_by.is_none_or(|outer| starts(model, outer))
}
