//! Parallel branches within one another, so that an evolution can change the regions in place, one after the other.
//!
//! Where a transition that forks or joins clears, nothing else in the regions it touches can: they are tested first, and
//! the branches inside only where none of them clears. So no region is changed before all that look at its state have done so.

use super::{Evolution, RegionId, Regions};
use crate::analysis::{Concurrency, Union};
use crate::list::List;
use crate::model::{Id, Model, StepId, TransitionId};
use crate::sorted::{Map, Set};

/// Parallel branches that belong together: regions that transitions connect.
pub struct BranchGroup {
    /// Its regions, in order.
    pub regions: Vec<RegionId>,
    /// The region that holds the steps in `alone`.
    pub head: RegionId,
    /// Steps beside which no region of the group has an active step, and the transitions that leave them.
    pub alone: Vec<(StepId, Vec<TransitionId>)>,
    /// Transitions with several sources that touch all regions: where one clears, nothing else in the group does.
    pub common: Vec<TransitionId>,
    /// What evolves where neither a step alone is active nor a common transition clears: independent of one another.
    pub inner: Vec<BranchGroup>,
}

impl BranchGroup {
    /// The groups of a chart, one for each set of connected regions; `None` where the branches are not within one another.
    pub(super) fn all(
        model: &Model,
        regions: &Regions,
        evolution: &Evolution,
        concurrency: &Concurrency,
    ) -> Option<Vec<Self>> {
        let plain = regions.all().len() > 1
            && !regions.are_flags()
            && evolution.contests.is_empty()
            && model.anys.is_empty()
            && evolution.entered_last.is_empty()
            && model.steps.ids().all(|step| evolution.exclusive[step.index()])
            && model.transitions.values().all(|t| !t.sources.is_empty());
        if !plain {
            return None;
        }
        let search = Search { model, regions, evolution, concurrency };
        let all: Vec<_> = (0..regions.all().len()).list();
        search.parts(&all, &model.transitions.ids().list()).into_iter().map(|part| search.group(part)).collect()
    }
}

/// Regions, and the transitions that touch nothing else.
#[derive(Default)]
struct Part {
    regions: Vec<RegionId>,
    transitions: Vec<TransitionId>,
}

struct Search<'m> {
    model: &'m Model,
    regions: &'m Regions,
    evolution: &'m Evolution,
    concurrency: &'m Concurrency,
}

impl Search<'_> {
    fn group(&self, part: Part) -> Option<BranchGroup> {
        let Part { regions, transitions } = part;
        let (head, alone) = self.head(&regions)?;
        let inside: Set<_> = transitions.iter().copied().collect();
        let leaving = |step: &StepId| {
            let owned = self.evolution.owned[step.index()].iter().copied();
            let owned: Vec<_> = owned.filter(|id| self.is_single(*id) && inside.contains(id)).list();
            (!owned.is_empty()).then_some((*step, owned))
        };
        let alone: Vec<_> = alone.iter().filter_map(leaving).list();
        let from_alone: Set<_> = alone.iter().flat(|(_, owned)| owned).copied().collect();
        let rest: Vec<_> = transitions.into_iter().filter(|id| !from_alone.contains(id)).list();
        let (common, rest): (Vec<_>, Vec<_>) = rest.into_iter().partition(|id| self.is_common(*id, &regions));
        if rest.is_empty() {
            return Some(BranchGroup { regions, head, alone, common, inner: Vec::new() });
        }
        let parts = self.parts(&regions, &rest);
        if parts.len() == 1 && alone.is_empty() && common.is_empty() {
            return None;
        }
        let inner = parts.into_iter().filter(|part| !part.transitions.is_empty()).map(|part| self.group(part));
        Some(BranchGroup { inner: inner.collect::<Option<_>>()?, regions, head, alone, common })
    }

    /// The region with most steps beside which the others are empty, and these steps.
    fn head(&self, regions: &[RegionId]) -> Option<(RegionId, Vec<StepId>)> {
        let heads = regions.iter().map(|region| {
            let steps = self.regions.all()[*region].steps.iter().copied();
            let alone = |step: &StepId| {
                self.concurrency.beside(*step).all(|other| !regions.contains(&self.regions.of_step(other)))
            };
            (*region, steps.filter(alone).list())
        });
        heads.reduce(|best, head| if head.1.len() > best.1.len() { head } else { best })
    }

    /// Whether a transition has several sources, which are all that is active in these regions when it is enabled.
    fn is_common(&self, id: TransitionId, regions: &[RegionId]) -> bool {
        let sources = &self.model.transitions[id].sources;
        let source_of = |region: RegionId| sources.iter().any(|source| self.regions.of_step(*source) == region);
        let empty = |region: RegionId| {
            let steps = &self.regions.all()[region].steps;
            steps.iter().all(|step| sources.iter().any(|source| !self.concurrency.together(*source, *step)))
        };
        sources.len() > 1 && regions.iter().all(|region| source_of(*region) || empty(*region))
    }

    fn is_single(&self, id: TransitionId) -> bool {
        self.model.transitions[id].sources.len() == 1
    }

    /// Divides regions into those that transitions connect.
    fn parts(&self, regions: &[RegionId], transitions: &[TransitionId]) -> Vec<Part> {
        let mut connected = Union::new(self.regions.all().len());
        for id in transitions {
            let (here, others) = self.touched(*id);
            others.for_each(|other| connected.join(here, other));
        }
        let mut parts: Map<RegionId, Part> = Map::new();
        for region in regions {
            parts.or_default(connected.root(*region)).regions.push(*region);
        }
        for id in transitions {
            parts.or_default(connected.root(self.touched(*id).0)).transitions.push(*id);
        }
        parts.into_iter().map(|(_, part)| part).list()
    }

    /// The regions of a transition's steps: one, and all of them.
    fn touched(&self, id: TransitionId) -> (RegionId, impl Iterator<Item = RegionId> + '_) {
        let transition = &self.model.transitions[id];
        let steps = transition.sources.iter().and(&transition.targets);
        (self.regions.of_step(transition.sources[0]), steps.map(|step| self.regions.of_step(*step)))
    }
}
