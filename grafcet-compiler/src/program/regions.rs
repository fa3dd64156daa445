//! Which steps share a byte: steps that are never active together form a region, whose state is an enum of them.
//!
//! The regions are the colours of the concurrency relation, given greedily in order of declaration. The relation of a
//! well-nested chart has no induced path of four steps (it is a cograph), and on such a graph the greedy colouring
//! needs the fewest colours in any order: one for a chart without parallel branches, else one per parallel branch.

use crate::analysis::{Concurrency, Row};
use crate::model::{ForceOrder, Id, Model, PartialId, StepId};
use crate::sorted::Set;

/// The position of a region.
pub type RegionId = usize;

/// Steps of which at most one is active.
pub struct Region {
    /// The partial grafcet all its steps belong to.
    pub partial: PartialId,
    /// In order of declaration.
    pub steps: Vec<StepId>,
    /// The one that is active in the initial situation.
    pub initial: Option<StepId>,
    /// There may be situations in which none of the steps is active.
    pub may_be_empty: bool,
}

/// All regions of a chart.
pub struct Regions {
    list: Vec<Region>,
    of_step: Vec<RegionId>,
}

impl Regions {
    /// Divides the steps of a chart.
    #[must_use]
    pub fn of(model: &Model, concurrency: &Concurrency, initial: &Set<StepId>) -> Self {
        let mut regions: Vec<Region> = Vec::new();
        let mut of_step = Vec::with_capacity(model.steps.len());
        // By region: its steps so far.
        let mut rows: Vec<Row> = Vec::new();
        for step in model.steps.ids() {
            let partial = model.steps[step].partial;
            let meets = |steps: &Row| concurrency.relation().meets(step.index(), steps);
            let fits = |(region, steps): (&Region, &Row)| region.partial == partial && !meets(steps);
            let region = regions.iter().zip(&rows).position(fits).unwrap_or_else(|| {
                regions.push(Region { partial, steps: Vec::new(), initial: None, may_be_empty: true });
                rows.push(Row::new(model.steps.len()));
                regions.len() - 1
            });
            regions[region].steps.push(step);
            rows[region].add(&[step.index()]);
            if initial.contains(&step) {
                regions[region].initial = Some(step);
            }
            of_step.push(region);
        }
        let mut all = Self { list: regions, of_step };
        for region in 0..all.list.len() {
            all.list[region].may_be_empty = all.may_become_empty(model, region);
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
        &self.list
    }

    /// The state is that of one region, which always has an active step.
    #[must_use]
    pub fn is_single(&self) -> bool {
        matches!(&self.list[..], [region] if !region.may_be_empty)
    }

    /// Whether a region starts empty, or something takes its active step away without giving it another.
    fn may_become_empty(&self, model: &Model, region: RegionId) -> bool {
        let here = |step: &StepId| self.of_step(*step) == region;
        let partial = self.list[region].partial;
        let forced = model.orders_on(partial).any(|force| force.order != ForceOrder::Hold);
        self.list[region].initial.is_none()
            || forced
            || model.partials[partial].enclosed_by.is_some()
            || model.transitions.values().any(|t| t.sources.iter().any(here) && !t.targets.iter().any(here))
    }
}
