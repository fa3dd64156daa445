//! Partial grafcets one above another, so that an evolution can change them in place from the top downwards.
//!
//! Where a transition forces or encloses what is below it, or leaves a step that does, nothing below clears: the evolution
//! ends there, and nothing has been done that it would have to take back.

use super::{RegionId, Regions};
use crate::analysis::{Concurrency, hierarchy};
use crate::list::List;
use crate::model::{Force, ForceOrder, Model, PartialId, Step, StepId, Transition};
use crate::sorted::{Map, Set};

/// What a transition does to the partial grafcets below its own, by what it enters and leaves: first by forcing, then by
/// enclosing (A15).
#[derive(Default)]
pub(crate) struct Below {
    /// The partial grafcets that it decides about: they clear nothing in the same evolution.
    pub(crate) partials: Set<PartialId>,
    /// The states that their regions get, as far as these may be others than before. `None` is "no active step".
    pub(crate) states: Map<RegionId, Option<StepId>>,
}

impl Below {
    pub(crate) fn of(model: &Model, regions: &Regions, transition: &Transition) -> Self {
        let mut search = Deciding { model, regions, below: Self::default() };
        let left = transition.sources.iter().filter(|step| !transition.targets.contains(step));
        left.for_each(|step| search.leave(*step));
        let entered = transition.targets.iter().filter(|step| !transition.sources.contains(step));
        entered.for_each(|step| search.enter(*step));
        search.below
    }
}

struct Deciding<'m> {
    model: &'m Model,
    regions: &'m Regions,
    below: Below,
}

impl Deciding<'_> {
    /// Its enclosures are emptied with a step that is left.
    fn leave(&mut self, step: StepId) {
        for (id, partial) in self.model.partials.iter().filter(|(_, partial)| partial.enclosed_by == Some(step)) {
            self.empty(id);
            partial.steps.iter().for_each(|inner| self.leave(*inner));
        }
    }

    /// A step that is entered forces what it forces, and activates the linked steps of its enclosures, which were empty.
    fn enter(&mut self, step: StepId) {
        for force in self.model.forces.values().filter(|force| force.step == step) {
            let situation = match &force.order {
                ForceOrder::Steps(steps) => steps.clone(),
                ForceOrder::Init => self.marked(force.target, |step| step.initial),
                ForceOrder::Hold => {
                    self.below.partials.insert(force.target);
                    continue;
                }
            };
            self.empty(force.target);
            self.model.partials[force.target].steps.iter().for_each(|step| self.leave(*step));
            self.enter_all(&situation);
        }
        for id in self.model.partials.ids().filter(|id| self.model.partials[*id].enclosed_by == Some(step)) {
            self.below.partials.insert(id);
            self.enter_all(&self.marked(id, |step| step.linked));
        }
    }

    fn enter_all(&mut self, steps: &[StepId]) {
        self.below.states.extend(steps.iter().map(|step| (self.regions.of_step(*step), Some(*step))));
        for step in steps {
            self.enter(*step);
        }
    }

    fn empty(&mut self, partial: PartialId) {
        self.below.partials.insert(partial);
        self.below.states.extend(self.regions.of_partial(partial).map(|region| (region, None)));
    }

    fn marked(&self, partial: PartialId, wanted: fn(&Step) -> bool) -> Vec<StepId> {
        let steps = &self.model.partials[partial].steps;
        steps.iter().copied().filter(|step| wanted(&self.model.steps[*step])).list()
    }
}

/// The partial grafcets on which steps of this one act directly.
pub(crate) fn directly(model: &Model, partial: PartialId) -> impl Iterator<Item = PartialId> + '_ {
    model.partials.ids().filter(move |id| hierarchy::masters(model, *id).contains(&partial))
}

/// Whether no step of another partial grafcet acts on this one.
pub(crate) fn is_top(model: &Model, partial: PartialId) -> bool {
    hierarchy::masters(model, partial).is_empty()
}

/// How partial grafcets that evolve in place know that something above them has decided about them in this evolution.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Descent {
    /// A transition that decides about something below it jumps after all that is below: nothing there could clear.
    Jumps,
    /// It notes about which ones it has decided.
    Notes,
    /// A forced situation may be that from before the evolution: each is compared with what is above it.
    Compares,
}

impl Descent {
    pub(super) fn of(model: &Model, regions: &Regions, concurrency: &Concurrency) -> Self {
        let descent = Search { model, regions, concurrency };
        if !model.forces.values().all(|force| descent.overwrites(force)) {
            return Self::Compares;
        }
        let jumps = model.partials.ids().all(|id| descent.has_one_master(id) && descent.ends_at_once(id));
        if jumps { Self::Jumps } else { Self::Notes }
    }
}

struct Search<'m> {
    model: &'m Model,
    regions: &'m Regions,
    concurrency: &'m Concurrency,
}

impl Search<'_> {
    fn has_one_master(&self, partial: PartialId) -> bool {
        let masters = hierarchy::masters(self.model, partial);
        masters.windows(2).all(|pair| pair[0] == pair[1])
    }

    /// Whether nothing below the forced partial grafcet may be as it was before: an enclosing step that is active already stays
    /// so, and its enclosures go on (A21).
    fn overwrites(&self, force: &Force) -> bool {
        let encloses = |step: &StepId| self.model.partials.values().any(|partial| partial.enclosed_by == Some(*step));
        match &force.order {
            ForceOrder::Steps(steps) => !steps.iter().any(encloses),
            ForceOrder::Init => {
                let mut steps = self.model.partials[force.target].steps.iter();
                !steps.any(|step| self.model.steps[*step].initial && encloses(step))
            }
            ForceOrder::Hold => true,
        }
    }

    /// Whether each transition and each forcing step of a partial grafcet that decides about something below it leaves
    /// nothing below that could evolve, and nothing beside it either.
    fn ends_at_once(&self, partial: PartialId) -> bool {
        let Self { model, regions, .. } = self;
        let below = self.all_below(partial);
        if below.is_empty() {
            return true;
        }
        let rests = |transition: &Transition, id| transition.sources.iter().any(|step| self.rests(id, *step));
        let mut transitions = model.partials[partial].transitions.iter().map(|id| &model.transitions[*id]);
        let mut forcing = model.forces.values().map(|force| force.step).filter(|s| model.steps[*s].partial == partial);
        let ends = |transition: &Transition| {
            let decided = Below::of(model, regions, transition).partials;
            decided.is_empty() || below.iter().all(|id| decided.contains(id) || rests(transition, *id))
        };
        regions.of_partial(partial).count() == 1
            && transitions.all(ends)
            && forcing.all(|step| below.iter().all(|id| self.rests(*id, step)))
    }

    fn all_below(&self, partial: PartialId) -> Vec<PartialId> {
        let direct = directly(self.model, partial);
        direct.flat(|id| std::iter::once(id).and(self.all_below(id))).list()
    }

    /// Whether nothing in a partial grafcet clears as long as a step above it is active.
    fn rests(&self, partial: PartialId, step: StepId) -> bool {
        let forces = |force: &Force| force.step == step && force.target == partial;
        if self.model.forces.values().any(forces) {
            return true;
        }
        self.model.partials[partial].enclosed_by.is_some_and(|outer| {
            let around = self.model.steps[outer].partial;
            if around == self.model.steps[step].partial {
                outer != step && !self.concurrency.together(outer, step)
            } else {
                // The enclosures of one that is held go on.
                let held =
                    |force: &Force| force.step == step && force.target == around && force.order == ForceOrder::Hold;
                !self.model.forces.values().any(held) && self.rests(around, step)
            }
        })
    }
}
