//! Which steps can be active together.
//!
//! The relation is computed pair by pair, as for the concurrency relation of Petri nets (Kovalyov 1992): two steps are
//! related if they start together, or if one is entered by a transition whose sources can all be active while the
//! other is. That is a superset of what can really happen, found without exploring situations: what is not related
//! never is active together, so two such steps can share one byte.

use std::collections::VecDeque;

use super::{Logic, Relation, hierarchy, pairs};
use crate::list::List;
use crate::model::{Any, ForceOrder, Id, Model, PartialId, StepId, Transition, TransitionId, Tree};
use crate::sorted::Set;

/// Charts with more steps than this are taken for independent partial grafcets.
const ACROSS: usize = 1_000;

/// Steps that can be active together.
#[derive(Clone, Debug)]
pub struct Concurrency {
    relation: Relation,
    /// Steps that can be active at all, as far as the structure tells.
    reachable: Vec<bool>,
    /// Transitions that can clear, as far as it tells.
    clears: Vec<bool>,
    /// Steps that a transition may activate while they are active.
    unsafe_steps: Vec<bool>,
}

impl Concurrency {
    /// Computes the relation.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        Self::assuming(model, &[])
    }

    /// The same where none of `never` ever holds. The generated code must not rely on that: the plant may break it.
    #[must_use]
    pub fn assuming(model: &Model, never: &[&Tree]) -> Self {
        Self::computed(model, model.is_grafcet().then(|| Logic::assuming(model, never)))
    }

    /// The relation in a chart whose branches are taken one at a time.
    #[must_use]
    pub fn of_exclusive_branches(model: &Model) -> Self {
        Self::computed(model, None)
    }

    /// `overlapping` tells which branches exclude each other, where several can be taken together.
    fn computed(model: &Model, overlapping: Option<Logic<'_>>) -> Self {
        let mut search = Search::new(model);
        search.seed(overlapping);
        search.run();
        search.follow_enclosures();
        Self {
            relation: search.relation,
            reachable: search.reachable,
            clears: search.clears,
            unsafe_steps: search.unsafe_steps,
        }
    }

    /// The same where what partial grafcets do to each other and ask of each other counts, too. The generated code must
    /// not rely on that.
    #[must_use]
    pub fn across_partials(&self, model: &Model) -> Self {
        self.across_partials_from(model, &hierarchy::initial_situation(model), &Set::new())
    }

    /// The same from a known initial situation, if the `granted` transitions asked for no steps.
    pub(super) fn across_partials_from(
        &self,
        model: &Model,
        initial: &Set<StepId>,
        granted: &Set<TransitionId>,
    ) -> Self {
        if model.partials.len() < 2 || model.steps.len() > ACROSS {
            return self.clone();
        }
        let pairs::Pairs { relation, reachable, clears } = pairs::of(model, &self.relation, initial, granted);
        Self { relation, reachable, clears, unsafe_steps: self.unsafe_steps.clone() }
    }

    /// The relation without the pairs of which more is known: they never are active together.
    #[must_use]
    pub fn without(&self, never: impl Fn(StepId, StepId) -> bool) -> Self {
        let mut relation = Relation::new(self.reachable.len());
        for a in 0..self.reachable.len() {
            let later = self.relation.of(a).filter(|b| *b >= a);
            for b in later.filter(|b| *b == a || !never(StepId::new(a), StepId::new(*b))) {
                relation.insert(a, b);
            }
        }
        let Self { reachable, clears, unsafe_steps, .. } = self;
        Self { relation, reachable: reachable.clone(), clears: clears.clone(), unsafe_steps: unsafe_steps.clone() }
    }

    /// Whether two different steps can be active together.
    #[must_use]
    pub fn together(&self, a: StepId, b: StepId) -> bool {
        self.relation.contains(a.index(), b.index())
    }

    /// Which steps can be active together, by their numbers.
    pub(crate) fn relation(&self) -> &Relation {
        &self.relation
    }

    /// The other steps that can be active together with one.
    pub fn beside(&self, step: StepId) -> impl Iterator<Item = StepId> + '_ {
        self.relation.of(step.index()).map(StepId::new).filter(move |other| *other != step)
    }

    /// Whether some situation contains the step, as far as the structure tells.
    #[must_use]
    pub fn reachable(&self, step: StepId) -> bool {
        self.reachable[step.index()]
    }

    /// Whether some evolution clears the transition, as far as the structure tells.
    #[must_use]
    pub fn can_clear(&self, transition: TransitionId) -> bool {
        self.clears[transition.index()]
    }

    /// Whether a transition may activate the step while it is active (and not left at the same time).
    #[must_use]
    pub fn activated_while_active(&self, step: StepId) -> bool {
        self.unsafe_steps[step.index()]
    }
}

struct Search<'m> {
    model: &'m Model,
    relation: Relation,
    reachable: Vec<bool>,
    clears: Vec<bool>,
    unsafe_steps: Vec<bool>,
    /// Transitions to look at (again), by index; `queued` keeps each in the list once.
    work: VecDeque<usize>,
    queued: Vec<bool>,
    /// Per step the transitions that leave it.
    leaving: Vec<Vec<usize>>,
    /// Source transitions.
    sourceless: Vec<usize>,
    /// Per `any` whether it leaves each step.
    left: Vec<Vec<bool>>,
}

impl<'m> Search<'m> {
    fn new(model: &'m Model) -> Self {
        let steps = model.steps.len();
        let mut leaving = vec![Vec::new(); steps];
        for (id, transition) in model.transitions.iter() {
            for s in &transition.sources {
                leaving[s.index()].push(id.index());
            }
        }
        let leaves = |any: &Any| {
            let mut left = vec![false; steps];
            any.sources.iter().for_each(|step| left[step.index()] = true);
            left
        };
        Self {
            left: model.anys.values().map(leaves).list(),
            model,
            relation: Relation::new(steps),
            reachable: vec![false; steps],
            clears: vec![false; model.transitions.len()],
            unsafe_steps: vec![false; steps],
            work: VecDeque::new(),
            queued: vec![false; model.transitions.len()],
            leaving,
            sourceless: model.transitions.iter().filter(|(_, t)| t.sources.is_empty()).map(|(id, _)| id.index()).list(),
        }
    }

    /// Situations that do not come from a transition inside the partial grafcet: initial, linked and forced steps.
    /// Different partial grafcets evolve independently, so all their steps can be active together.
    fn seed(&mut self, overlapping: Option<Logic<'_>>) {
        for (id, _) in self.model.partials.iter() {
            for group in self.starts(id) {
                self.enter_together(&group);
            }
        }
        self.seed_across_partials();
        if let Some(logic) = overlapping {
            self.seed_overlapping_branches(&logic);
        }
        self.queue_sources();
    }

    /// Groups of steps of a partial grafcet that become active together.
    fn starts(&self, partial: PartialId) -> Vec<Vec<StepId>> {
        let steps = &self.model.partials[partial].steps;
        let pick = |wanted: &dyn Fn(StepId) -> bool| steps.iter().copied().filter(|s| wanted(*s)).list();
        let mut groups = vec![pick(&|s| self.model.steps[s].initial), pick(&|s| self.model.steps[s].linked)];
        for force in self.model.orders_on(partial) {
            if let ForceOrder::Steps(forced) = &force.order {
                groups.push(forced.clone());
            }
        }
        groups
    }

    fn seed_across_partials(&mut self) {
        if self.model.partials.len() == 1 {
            return;
        }
        let ids: Vec<_> = self.model.steps.ids().list();
        for (i, a) in ids.iter().enumerate() {
            for b in &ids[i + 1..] {
                if self.model.steps[*a].partial != self.model.steps[*b].partial {
                    self.relation.insert(a.index(), b.index());
                }
            }
        }
    }

    /// IEC 60848 rule 4: branches that are not exclusive clear together.
    fn seed_overlapping_branches(&mut self, logic: &Logic<'_>) {
        let transitions: Vec<&Transition> = self.model.transitions.values().list();
        for leaving in self.leaving.clone() {
            let read = |index: &usize| (*index, logic.condition(&transitions[*index].condition.tree));
            let conditions: Vec<_> = leaving.iter().filter(|_| leaving.len() > 1).map(read).list();
            for (i, (a, first)) in conditions.iter().enumerate() {
                for (b, second) in &conditions[i + 1..] {
                    let ids = [*a, *b].map(TransitionId::new);
                    if !self.model.exclude_each_other(ids[0], ids[1]) && !logic.exclusive(first, second) {
                        self.enter_together_with(&transitions[*a].targets, &transitions[*b].targets);
                    }
                }
            }
        }
    }

    /// A step inside an enclosure is active only together with its enclosing step, so it meets only what that one meets.
    fn follow_enclosures(&mut self) {
        if self.model.partials.values().all(|partial| partial.enclosed_by.is_none()) {
            return;
        }
        let ids: Vec<_> = self.model.steps.ids().list();
        let outside: Vec<Vec<StepId>> = ids.iter().map(|step| self.enclosing(*step)).list();
        let mut relation = Relation::new(ids.len());
        for a in &ids {
            for b in &ids[a.index() + 1..] {
                let meet = self.relation.contains(a.index(), b.index())
                    && outside[a.index()].iter().all(|x| outside[b.index()].iter().all(|y| self.can_meet(*x, *y)));
                if meet {
                    relation.insert(a.index(), b.index());
                }
            }
        }
        self.relation = relation;
    }

    /// The step and the steps around it, outwards.
    fn enclosing(&self, step: StepId) -> Vec<StepId> {
        let mut chain = vec![step];
        let mut at = step;
        while let Some(outer) = self.model.partials[self.model.steps[at].partial].enclosed_by {
            if chain.contains(&outer) {
                break;
            }
            chain.push(outer);
            at = outer;
        }
        chain
    }

    /// Whether two steps are the same, or of different partial grafcets, or can be active together.
    fn can_meet(&self, a: StepId, b: StepId) -> bool {
        a == b
            || self.model.steps[a].partial != self.model.steps[b].partial
            || self.relation.contains(a.index(), b.index())
    }

    fn enter_together(&mut self, steps: &[StepId]) {
        for (i, a) in steps.iter().enumerate() {
            self.reach(*a);
            for b in &steps[i + 1..] {
                self.relate(a.index(), b.index());
            }
        }
    }

    fn enter_together_with(&mut self, left: &[StepId], right: &[StepId]) {
        for a in left {
            for b in right.iter().filter(|b| *b != a) {
                self.relate(a.index(), b.index());
            }
        }
    }

    fn run(&mut self) {
        while let Some(index) = self.work.pop_front() {
            self.queued[index] = false;
            self.fire(index);
        }
    }

    /// What clearing a transition can lead to.
    fn fire(&mut self, index: usize) {
        let transition = &self.model.transitions.values().as_slice()[index];
        let sources: Vec<usize> = transition.sources.iter().map(|s| s.index()).list();
        let enabled = sources.iter().all(|s| self.reachable[*s])
            && sources.iter().enumerate().all(|(i, a)| sources[i + 1..].iter().all(|b| self.relation.contains(*a, *b)));
        if !enabled {
            return;
        }
        self.clears[index] = true;
        self.enter_together(&transition.targets);
        for target in transition.targets.iter().map(|t| t.index()) {
            for bystander in self.relation.common_beyond(&sources, target) {
                if transition.any.is_some_and(|any| bystander == target || self.left[any.index()][bystander]) {
                    // What an `any` leaves is left by it in the same evolution; a target that is active stays so.
                    continue;
                }
                if bystander == target {
                    self.unsafe_steps[target] = true;
                } else if self.reachable[bystander] {
                    self.relate(target, bystander);
                }
            }
        }
    }

    fn reach(&mut self, step: StepId) {
        if !std::mem::replace(&mut self.reachable[step.index()], true) {
            self.queue_leaving(step.index());
            // Steps can be related before they are reached: what leaves one of them now has a bystander.
            for related in self.relation.of(step.index()).list() {
                self.queue_leaving(related);
            }
            // A source transition can clear at any time, so its targets meet every reachable step.
            self.queue_sources();
        }
    }

    fn relate(&mut self, a: usize, b: usize) {
        if self.relation.insert(a, b) {
            self.queue_leaving(a);
            self.queue_leaving(b);
        }
    }

    fn queue_leaving(&mut self, step: usize) {
        for i in 0..self.leaving[step].len() {
            self.queue(self.leaving[step][i]);
        }
    }

    fn queue_sources(&mut self) {
        for i in 0..self.sourceless.len() {
            self.queue(self.sourceless[i]);
        }
    }

    fn queue(&mut self, index: usize) {
        if !std::mem::replace(&mut self.queued[index], true) {
            self.work.push_back(index);
        }
    }
}
