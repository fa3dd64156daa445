//! How many evolutions a search may take whose circles all come to an end: who knows nothing of the proof stops it after its bound (A30).
//!
//! Each evolution needs something that clears, and that an evolution before could not. Where conditions look at inputs alone, it was not enabled: one clearing leads to the next, on a
//! way on which no transition stands twice. Where they look at steps and values it may have waited for something that has nothing to do with it, so all clearings count.

use super::once::{Events, clears_once};
use super::successors::Successors;
use super::{Candidates, circles, is_constant_read};
use crate::analysis::Concurrency;
use crate::analysis::edges::is_edge_of_inputs;
use crate::list::List;
use crate::model::{Id, Model, PartialId, StepId, TransitionId};
use crate::sorted::Set;

/// Of larger partial grafcets no ways are looked for.
const LARGE: usize = 200;

/// The evolutions of a search in which `counted` are what counts take to end circles.
pub(super) fn evolutions(
    (model, lengths): (&Model, Option<&Lengths<'_>>),
    successors: &mut Successors<'_>,
    (counted, events): (u64, Events),
) -> Option<u64> {
    let varies = |id: TransitionId| {
        let reads = &model.transitions[id].condition.reads;
        reads.iter().any(|read| !is_constant_read(read) && !is_edge_of_inputs(model, read))
    };
    if !model.transitions.ids().any(varies) {
        // What the first evolution alone sees, and a look at events: nothing waits for what these store.
        return counted.checked_add(model.steps.len() as u64 + 2);
    }
    let clearings = counted.checked_add(lengths?.evolutions(successors))?;
    match events {
        Events::None => Some(clearings),
        Events::First => clearings.checked_add(1),
        Events::AfterClearings => clearings.checked_mul(2)?.checked_add(1),
    }
}

/// How often things happen in one search.
pub(super) struct Lengths<'s> {
    model: &'s Model,
    concurrency: &'s Concurrency,
    /// By transition: it clears in the first evolution alone, or with the step that is active at the beginning.
    once: Vec<bool>,
    /// By partial grafcet, the transitions of others that activate steps of it, by what is forced or enclosed.
    entered_by: Vec<Vec<TransitionId>>,
    /// By partial grafcet, how often they do.
    entries: Vec<u64>,
}

impl<'s> Lengths<'s> {
    /// `None` where partial grafcets enter each other in turn, or a step may be entered by two that are active together: then each of its transitions may clear for both.
    pub(super) fn of(model: &'s Model, concurrency: &'s Concurrency, successors: &Successors<'_>) -> Option<Self> {
        if is_entered_twice(model, concurrency) {
            return None;
        }
        let once = model.transitions.ids().map(|id| clears_once(model, concurrency, id)).list();
        let mut entered_by = vec![Vec::new(); model.partials.len()];
        for (id, transition) in model.transitions.iter() {
            let partials: Set<PartialId> =
                successors.activates(id).iter().map(|step| model.steps[*step].partial).collect();
            for partial in partials.iter().filter(|partial| **partial != transition.partial) {
                entered_by[partial.index()].push(id);
            }
        }
        let entries = vec![0; model.partials.len()];
        let mut lengths = Self { model, concurrency, once, entered_by, entries };
        // As long as a chain of partial grafcets may be, each above the next one.
        for _ in 0..=model.partials.len() {
            let all = |ids: &Vec<TransitionId>| ids.iter().map(|id| lengths.clearings(*id)).sum();
            let entries: Vec<u64> = lengths.entered_by.iter().map(all).list();
            if entries == lengths.entries {
                return Some(lengths);
            }
            lengths.entries = entries;
        }
        None
    }

    /// How often a transition clears at most that is in no circle: once for each time that its partial grafcet begins anew.
    pub(super) fn clearings(&self, id: TransitionId) -> u64 {
        let partial = self.model.transitions[id].partial;
        if self.once[id.index()] { 1 } else { 1 + self.entries[partial.index()] }
    }

    /// How often others enter a partial grafcet so that it may come into a circle of its own.
    pub(super) fn entries_into(&self, successors: &mut Successors<'_>, partial: PartialId, circle: &Candidates) -> u64 {
        let mut all = 0;
        for id in &self.entered_by[partial.index()] {
            let (mut seen, mut waiting) = (Candidates::new(), vec![*id]);
            while let Some(at) = waiting.pop() {
                let next = self.next(successors, partial, at);
                waiting.extend(next.into_iter().filter(|next| seen.insert(*next)));
            }
            if !seen.is_disjoint(circle) {
                all += self.clearings(*id);
            }
        }
        all
    }

    /// The evolutions of a search in which something clears, without what counts take to end circles.
    fn evolutions(&self, successors: &mut Successors<'_>) -> u64 {
        self.model.partials.ids().map(|partial| self.of_partial(successors, partial)).sum()
    }

    /// The evolutions in which something of a partial grafcet clears.
    fn of_partial(&self, successors: &mut Successors<'_>, partial: PartialId) -> u64 {
        let model = self.model;
        let own = |id: &TransitionId| model.transitions[*id].partial == partial;
        let transitions = model.transitions.ids().filter(own).list();
        let steps = &model.partials[partial].steps;
        let beside = |at: usize| steps[..at].iter().any(|other| self.concurrency.together(*other, steps[at]));
        let entries = self.entries[partial.index()];
        if transitions.len() > LARGE || (0..steps.len()).any(beside) {
            // Each step is entered once.
            return (1 + entries) * transitions.len().min(2 * steps.len()) as u64;
        }
        let mut ways = Ways::of(self, successors, partial, &transitions);
        // What holds once is the first to clear.
        let first = transitions.iter().map(|id| 1 + ways.after(successors, *id)).max().unwrap_or(0);
        let after = |id: &TransitionId| self.clearings(*id) * ways.after(successors, *id);
        first + self.entered_by[partial.index()].iter().map(after).sum::<u64>()
    }

    /// What clears in a partial grafcet after a transition has, as far as what is constant tells.
    fn next(&self, successors: &mut Successors<'_>, partial: PartialId, id: TransitionId) -> Vec<TransitionId> {
        let is_next =
            |next: &TransitionId| self.model.transitions[*next].partial == partial && !self.once[next.index()];
        successors.after(id).into_iter().filter(is_next).list()
    }
}

/// Whether two transitions enter a step from steps that may be active together.
fn is_entered_twice(model: &Model, concurrency: &Concurrency) -> bool {
    let sources = |id: &TransitionId| &model.transitions[*id].sources;
    let meet = |one: &TransitionId, other: &TransitionId| {
        // What leaves any step clears for all that are active, and enters its targets once.
        let any = model.transitions[*one].any;
        let is_same = any.is_some() && any == model.transitions[*other].any;
        let (one, other) = (sources(one), sources(other));
        let shares = is_same || one.iter().any(|step| other.contains(step));
        !shares && one.iter().any(|a| other.iter().any(|b| concurrency.together(*a, *b)))
    };
    let is_beside = |id: &&TransitionId| sources(id).iter().any(|step| concurrency.beside(*step).next().is_some());
    let entered = |step: StepId| {
        let entering = model.entering[step.index()].iter().filter(is_beside).list();
        (0..entering.len()).any(|at| entering[..at].iter().any(|other| meet(other, entering[at])))
    };
    model.steps.ids().any(entered)
}

/// The longest ways in a partial grafcet of which one step is active at a time.
struct Ways<'l, 's> {
    lengths: &'l Lengths<'s>,
    partial: PartialId,
    circles: Vec<Candidates>,
    /// By transition, how many clear on the longest way that it begins.
    longest: Vec<Option<u64>>,
}

impl<'l, 's> Ways<'l, 's> {
    fn of(
        lengths: &'l Lengths<'s>,
        successors: &mut Successors<'_>,
        partial: PartialId,
        transitions: &[TransitionId],
    ) -> Self {
        let again: Candidates = transitions.iter().copied().filter(|id| !lengths.once[id.index()]).collect();
        let circles = circles(successors, &again);
        Self { lengths, partial, circles, longest: vec![None; lengths.once.len()] }
    }

    /// The longest way that a transition of this partial grafcet or of another one leads to.
    fn after(&mut self, successors: &mut Successors<'_>, id: TransitionId) -> u64 {
        let next = self.lengths.next(successors, self.partial, id);
        next.into_iter().map(|next| self.from(successors, next)).max().unwrap_or(0)
    }

    fn from(&mut self, successors: &mut Successors<'_>, id: TransitionId) -> u64 {
        if let Some(longest) = self.longest[id.index()] {
            return longest;
        }
        let longest = match self.circles.iter().position(|circle| circle.contains(&id)) {
            None => 1 + self.after(successors, id),
            // Of a circle each step once, and then out of it.
            Some(at) => {
                let circle = self.circles[at].clone();
                let steps: Set<StepId> =
                    circle.iter().flat(|one| self.lengths.model.transitions[*one].sources.clone()).collect();
                let next: Candidates =
                    circle.iter().flat(|one| self.lengths.next(successors, self.partial, *one)).collect();
                let out = next.difference(&circle).copied().list();
                let out = out.into_iter().map(|next| self.from(successors, next)).max().unwrap_or(0);
                steps.len() as u64 + out
            }
        };
        self.longest[id.index()] = Some(longest);
        longest
    }
}
