//! `shadowed_branch`, `overlapping_branches`: transitions that compete for a step.

use super::drawing;
use super::rivals::{self, Rivals};
use crate::analysis::{Answer, Concurrency, Condition, Logic};
use crate::diagnostic::{Sink, rules};
use crate::list::List;
use crate::model::{Binary, Id, LevelAttr, Model, Name, Read, StepId, Transition, TransitionId, Tree};
use crate::sorted::{Map, Set};

/// More pairs of branches than this are not told to the exploration.
const PRESUMED: usize = 1000;

/// Of a step with more branches each is compared with this many before it.
const NEIGHBOURS: usize = 200;

pub(super) struct Branches<'m> {
    pub(super) model: &'m Model,
    pub(super) concurrency: &'m Concurrency,
    pub(super) logic: &'m Logic<'m>,
    /// By transition.
    pub(super) conditions: &'m [Condition],
    /// Transitions of which it was said that their condition always holds: that they shadow others need not be said.
    pub(super) always: &'m Set<TransitionId>,
}

/// Two branches that can clear together.
struct Overlap {
    first: TransitionId,
    second: TransitionId,
    inputs: String,
}

impl Branches<'_> {
    /// Leaves out the transitions that never clear, and returns the shadowed ones.
    pub(super) fn check(&self, dead: &Set<TransitionId>, sink: &mut Sink) -> Set<TransitionId> {
        let model = self.model;
        let (mut shadowed, mut overlapping) = (Set::new(), Vec::new());
        let stands = |id: &TransitionId| model.transitions[*id].any.is_none_or(|any| model.anys[any].first == *id);
        for id in model.transitions.ids().filter(|id| !dead.contains(id) && stands(id)) {
            // What competes with it and stands before it.
            let others =
                model.transitions[id].sources.iter().flat_map(|step| model.leaving[step.index()].iter().copied());
            let before: Set<TransitionId> = others.filter(|other| *other < id && !dead.contains(other)).collect();
            if before.is_empty() {
                continue;
            }
            let mut before: Vec<TransitionId> = before.into_iter().rev().take(NEIGHBOURS).list();
            before.reverse();
            if model.is_grafcet() {
                self.overlapping(id, &before, &mut overlapping, sink);
            } else if self.shadowed(id, &before, sink) {
                shadowed.insert(id);
            }
        }
        self.report_overlapping(&overlapping, sink);
        shadowed
    }

    /// Branches of a step whose conditions nobody can relate: conditions that hold where both do. They are meant to exclude
    /// each other, as `mode == Mode::Auto` and `mode == Mode::Manual`; where that matters and they do not, nothing is said.
    pub(super) fn presumed_exclusive(&self) -> Vec<Tree> {
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

    /// A28: of the branches that could clear the first one in the source does.
    fn shadowed(&self, id: TransitionId, before: &[TransitionId], sink: &mut Sink) -> bool {
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
            return false;
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
        let shadowing: Vec<TransitionId> = first.iter().map(|(other, _)| *other).list();
        match shadowing[..] {
            _ if shadowing.iter().any(|other| self.always.contains(other)) => {}
            [one] if self.is_duplicate(one, id) => drawing::duplicate_transition(self.model, one, id, sink),
            _ => self.report_shadowed(id, &shadowing, sink),
        }
        true
    }

    fn report_shadowed(&self, id: TransitionId, shadowing: &[TransitionId], sink: &mut Sink) {
        let transition = &self.model.transitions[id];
        let (own, text) = (self.model.transition_text(transition), &transition.condition.text);
        let who = match shadowing {
            [one] => {
                let first = &self.model.transitions[*one];
                format!("`{}` of {}", first.condition.text, self.model.transition_text(first))
            }
            _ => format!("one of the {} conditions", shadowing.len()),
        };
        let message = format!(
            "{own} never clears: whenever `{text}` holds, so does {who} before it; put it first, or correct one of the \
             conditions"
        );
        let by_any = |other: &TransitionId| self.model.transitions[*other].any.is_some();
        let message = if shadowing.iter().any(by_any) && transition.any.is_none() {
            format!(
                "{own} never clears: whenever `{text}` holds, so does {who}, which comes before it; let it wait for something else, \
                 or leave its step out: `any except …`"
            )
        } else {
            message
        };
        let message = if transition.otherwise.is_some() { never_else(self.model, transition) } else { message };
        let mut notes = vec![(transition.condition.mark, message)];
        for other in shadowing {
            let first = &self.model.transitions[*other];
            let (first_text, rest) = (self.model.transition_text(first), shadowing.len() - 1);
            let instead = match rest {
                0 => "it is cleared instead".to_owned(),
                1 => "it or the other one before is cleared instead".to_owned(),
                _ => format!("it or one of the {rest} others before is cleared instead"),
            };
            let message =
                format!("{first_text} stands before {own} and has priority; whenever `{text}` holds, {instead}");
            notes.push((first.condition.mark, message));
        }
        sink.rule(&rules::SHADOWED_BRANCH, &self.model.levels_of_transition(transition), notes);
    }

    /// Rule 4 of IEC 60848: branches whose conditions hold together all clear.
    fn overlapping(&self, id: TransitionId, before: &[TransitionId], found: &mut Vec<Overlap>, sink: &mut Sink) {
        let (own, known) = (self.condition(id), found.len());
        for other in before.iter().filter(|other| !self.model.exclude_each_other(**other, id)) {
            if self.is_duplicate(*other, id) {
                // What overlaps with that one has been found.
                found.truncate(known);
                return drawing::duplicate_transition(self.model, *other, id, sink);
            }
            let excluded = self.logic.exclusive(self.condition(*other), own);
            if excluded || self.lead_to_the_same(id, *other) || !self.enabled_together(id, *other) {
                continue;
            }
            let (first, second) = (&self.model.transitions[*other], &self.model.transitions[id]);
            let steps: Set<StepId> = first.sources.iter().chain(&second.sources).copied().collect();
            let active = |step: &StepId| self.logic.condition(&Tree::Read(Read::Active(*step)));
            let active: Vec<Condition> = steps.iter().map(active).list();
            let goals = [(self.condition(*other), true), (own, true)];
            let given: Vec<&Condition> = active.iter().list();
            if let Answer::Witness(inputs) = self.logic.certainly_together(&goals, &given) {
                found.push(Overlap { first: *other, second: id, inputs });
            }
        }
    }

    fn report_overlapping(&self, found: &[Overlap], sink: &mut Sink) {
        let model = self.model;
        let mut rivals = Rivals::new(&rules::OVERLAPPING_BRANCHES, model.dialect);
        let mut inputs: Map<(usize, usize), &str> = Map::new();
        for Overlap { first, second, inputs: when } in found {
            let mut scopes: Vec<&[LevelAttr]> = vec![&model.transitions[*first].levels];
            scopes.extend(model.levels_of_transition(&model.transitions[*second]));
            rivals.add(first.index(), second.index(), &scopes);
            inputs.insert((first.index(), second.index()), when);
        }
        let transitions: Vec<&Transition> = model.transitions.values().list();
        rivals.report(sink, |one, others| {
            let together = |other: &usize| {
                let when = inputs.get(&(one.min(*other), one.max(*other))).copied().unwrap_or_default();
                let when = if when.is_empty() { "always".to_owned() } else { format!("with `{when}`") };
                (model.transition_text(transitions[*other]), when)
            };
            let message = match others {
                [other] => {
                    let (text, when) = together(other);
                    let own = model.transition_text(transitions[one]);
                    format!("{own} and {text} can clear together, {when}; let their conditions exclude each other")
                }
                _ => {
                    let texts = others.iter().map(|other| {
                        let (text, when) = together(other);
                        format!("{text} ({when})")
                    });
                    format!(
                        "{} can clear together with each of {}; let their conditions exclude each other",
                        model.transition_text(transitions[one]),
                        rivals::listed(&texts.list()),
                    )
                }
            };
            (transitions[one].condition.mark, message)
        });
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

/// Why an `else` is never taken.
pub(super) fn never_else(model: &Model, transition: &Transition) -> String {
    format!(
        "{} never clears: one of the other branches always does; delete it, or correct one of their conditions",
        model.transition_text(transition)
    )
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
