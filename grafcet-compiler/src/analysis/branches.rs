//! Transitions that compete for a step: which never get their turn (`sfc`), and which can clear together (`grafcet`).

use super::{Answer, Concurrency, Condition, Logic};
use crate::list::List;
use crate::model::{Binary, Id, Model, Name, Read, StepId, TransitionId, Tree};
use crate::sorted::Set;

/// More pairs of branches than this are not told to the exploration.
const PRESUMED: usize = 1000;

/// Of a step with more branches each is compared with this many before it.
const NEIGHBOURS: usize = 200;

/// The branches of a chart, and what is known of their conditions.
pub(crate) struct Branches<'m> {
    pub(crate) model: &'m Model,
    pub(crate) concurrency: &'m Concurrency,
    pub(crate) logic: &'m Logic<'m>,
    /// By transition.
    pub(crate) conditions: &'m [Condition],
}

/// What competes.
#[derive(Default)]
pub(crate) struct Rivalry {
    pub(crate) shadowed: Vec<Shadowed>,
    pub(crate) overlaps: Vec<Overlap>,
    /// `grafcet`: the same arc with the same condition, the first one first.
    pub(crate) duplicates: Vec<(TransitionId, TransitionId)>,
}

/// A28: a branch that never clears, as others come first whenever it could.
pub(crate) struct Shadowed {
    pub(crate) id: TransitionId,
    /// None of these could be missing.
    pub(crate) by: Vec<TransitionId>,
    /// It is the other one, written once more.
    pub(crate) is_duplicate: bool,
}

/// Rule 4 of IEC 60848: two branches that can clear together.
pub(crate) struct Overlap {
    pub(crate) first: TransitionId,
    pub(crate) second: TransitionId,
    /// With these.
    pub(crate) inputs: String,
}

impl Branches<'_> {
    /// What competes among the transitions that are not dead.
    pub(crate) fn rivalry(&self, dead: &Set<TransitionId>) -> Rivalry {
        let model = self.model;
        let mut found = Rivalry::default();
        let stands = |id: &TransitionId| model.transitions[*id].any.is_none_or(|any| model.anys[any].first == *id);
        for id in model.transitions.ids().filter(|id| !dead.contains(id) && stands(id)) {
            let before = self.before(id, dead);
            if before.is_empty() {
                continue;
            }
            if model.is_grafcet() {
                self.overlapping(id, &before, &mut found);
            } else if let Some(shadowed) = self.shadowed(id, &before) {
                // An `any` never clears if it does from none of its steps.
                let any = model.transitions[id].any;
                let of_any = |other: &TransitionId| any.is_some() && model.transitions[*other].any == any;
                let mut others = model.transitions.ids().filter(|other| *other != id && of_any(other));
                if others
                    .all(|other| dead.contains(&other) || self.shadowed(other, &self.before(other, dead)).is_some())
                {
                    found.shadowed.push(shadowed);
                }
            }
        }
        found
    }

    /// What competes with a transition and stands before it.
    fn before(&self, id: TransitionId, dead: &Set<TransitionId>) -> Vec<TransitionId> {
        let model = self.model;
        let others = model.transitions[id].sources.iter().flat(|step| model.leaving[step.index()].iter().copied());
        let before: Set<TransitionId> = others.filter(|other| *other < id && !dead.contains(other)).collect();
        let mut before: Vec<TransitionId> = before.into_iter().rev().take(NEIGHBOURS).list();
        before.reverse();
        before
    }

    /// Branches of a step whose conditions nobody can relate: conditions that hold where both do. They are meant to exclude
    /// each other, as `mode == Mode::Auto` and `mode == Mode::Manual`; where that matters and they do not, nothing is said.
    pub(crate) fn presumed_exclusive(&self) -> Vec<Tree> {
        let mut presumed = Vec::new();
        let known = |id: &TransitionId| {
            let still = |read: &Read| matches!(read, Read::Name(Name::Input(_) | Name::Param(_)));
            self.model.transitions[*id].condition.reads.iter().all(still)
        };
        for leaving in self.model.leaving.iter().filter(|branches| self.model.is_grafcet() && branches.len() > 1) {
            let leaving: Vec<TransitionId> = leaving.iter().copied().filter(known).list();
            for (i, a) in leaving.iter().enumerate() {
                for b in &leaving[i + 1..] {
                    if presumed.len() < PRESUMED && self.is_undecided(*a, *b) {
                        let tree = |id: TransitionId| Box::new(self.model.transitions[id].condition.tree.clone());
                        presumed.push(Tree::Binary(Binary::And, tree(*a), tree(*b)));
                    }
                }
            }
        }
        presumed
    }

    fn is_undecided(&self, a: TransitionId, b: TransitionId) -> bool {
        if self.model.exclude_each_other(a, b) {
            return false;
        }
        let (first, second) = (self.condition(a), self.condition(b));
        // The exploration does not know what Rust means.
        let is_rust = |id: TransitionId| has_rust(&self.model.transitions[id].condition.tree);
        let open = is_rust(a) && is_rust(b) || !self.logic.exclusive(first, second);
        let answer = || self.logic.certainly_together(&[(first, true), (second, true)], &[]);
        open && !matches!(answer(), Answer::Witness(_))
    }

    fn condition(&self, id: TransitionId) -> &Condition {
        &self.conditions[id.index()]
    }

    /// Of the branches that could clear the first one in the source does.
    fn shadowed(&self, id: TransitionId, before: &[TransitionId]) -> Option<Shadowed> {
        let sources = &self.model.transitions[id].sources;
        // One that is enabled whenever this one is.
        let wins = |other: &&TransitionId| self.model.transitions[**other].sources.iter().all(|s| sources.contains(s));
        let mut first: Vec<(TransitionId, &Condition)> =
            before.iter().filter(wins).map(|other| (*other, self.condition(*other))).list();
        let own = self.condition(id);
        let implied = |by: &[(TransitionId, &Condition)]| {
            self.logic.implies(own, &by.iter().map(|(_, condition)| *condition).list())
        };
        if first.is_empty() || !implied(&first) {
            return None;
        }
        match first.iter().position(|one| implied(std::slice::from_ref(one))) {
            Some(one) => first = vec![first.swap_remove(one)],
            None => {
                // Those without which it still is implied have no part in it.
                let mut at = 0;
                while at < first.len() {
                    let one = first.remove(at);
                    if !implied(&first) {
                        first.insert(at, one);
                        at += 1;
                    }
                }
            }
        }
        let by: Vec<TransitionId> = first.iter().map(|(other, _)| *other).list();
        let is_duplicate = matches!(by[..], [one] if self.is_duplicate(one, id));
        Some(Shadowed { id, by, is_duplicate })
    }

    /// Branches whose conditions hold together all clear.
    fn overlapping(&self, id: TransitionId, before: &[TransitionId], found: &mut Rivalry) {
        let (own, known) = (self.condition(id), found.overlaps.len());
        for other in before.iter().filter(|other| !self.model.exclude_each_other(**other, id)) {
            if self.is_duplicate(*other, id) {
                // What overlaps with that one has been found.
                found.overlaps.truncate(known);
                found.duplicates.push((*other, id));
                return;
            }
            let excluded = self.logic.exclusive(self.condition(*other), own);
            if excluded || self.lead_to_the_same(id, *other) || !self.enabled_together(id, *other) {
                continue;
            }
            let (first, second) = (&self.model.transitions[*other], &self.model.transitions[id]);
            let steps: Set<StepId> = first.sources.iter().and(&second.sources).copied().collect();
            let active = |step: &StepId| self.logic.condition(&Tree::Read(Read::Active(*step)));
            let active: Vec<Condition> = steps.iter().map(active).list();
            let goals = [(self.condition(*other), true), (own, true)];
            let given: Vec<&Condition> = active.iter().list();
            if let Answer::Witness(inputs) = self.logic.certainly_together(&goals, &given) {
                found.overlaps.push(Overlap { first: *other, second: id, inputs });
            }
        }
    }

    /// The same arc with the same condition, written in another way.
    fn is_duplicate(&self, a: TransitionId, b: TransitionId) -> bool {
        self.lead_to_the_same(a, b) && self.logic.equivalent(self.condition(a), self.condition(b))
    }

    /// Whether it makes no difference that both clear.
    fn lead_to_the_same(&self, a: TransitionId, b: TransitionId) -> bool {
        let (a, b) = (&self.model.transitions[a], &self.model.transitions[b]);
        let set = |steps: &[StepId]| steps.iter().copied().collect::<Set<_>>();
        let same = set(&a.sources) == set(&b.sources) && set(&a.targets) == set(&b.targets);
        same && a.clearing.is_empty() && b.clearing.is_empty()
    }

    fn enabled_together(&self, a: TransitionId, b: TransitionId) -> bool {
        let (a, b) = (&self.model.transitions[a], &self.model.transitions[b]);
        a.sources.iter().all(|x| b.sources.iter().all(|y| x == y || self.concurrency.together(*x, *y)))
    }
}

/// Whether a condition holds Rust that is not looked into.
fn has_rust(tree: &Tree) -> bool {
    match tree {
        Tree::Opaque { .. } => true,
        Tree::Unary(_, inner) => has_rust(inner),
        Tree::Binary(_, a, b) => has_rust(a) || has_rust(b),
        _ => false,
    }
}
