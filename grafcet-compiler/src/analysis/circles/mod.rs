//! Circles of transitions that clear again and again in one cycle of a `grafcet` (A30).
//!
//! Within a cycle inputs, params and delays stand still, input edges are gone after the first evolution (A2), and the
//! time of a step that was just entered is zero. So from each transition that can clear in a stable situation the
//! search for stability is followed, under all valuations at once: what its condition says decides conditions further
//! on, and what it leaves open is tried both ways. Anything that may change within the cycle in ways that are not
//! followed (stored variables, steps of which nothing is known) counts as open in each evolution anew.

mod orders;
mod rest;
mod run;
mod view;

use std::cell::{Cell, OnceCell};
use std::rc::Rc;

use self::run::{Node, Outcome, Run};
use self::view::View;
use super::{Answer, Concurrency, Condition, Logic, combinational};
use crate::list::{List, PushAll};
use crate::model::{Id, Model, Name, Read, StepId, Transition, TransitionId, Tree};
use crate::sorted::{Map, Set};

/// A circle and the values under which it turns.
#[derive(Clone, Debug)]
pub struct Circle {
    /// In the direction of evolution.
    pub transitions: Vec<TransitionId>,
    /// As [`Answer::Witness`].
    pub inputs: String,
}

/// The transitions of a circle, in the direction of evolution.
type Ring = Vec<TransitionId>;

/// The values that conditions shall have.
type Goals = Vec<(Rc<Condition>, bool)>;

/// Finds circles.
pub struct Circles<'m> {
    model: &'m Model,
    concurrency: &'m Concurrency,
    logic: &'m Logic<'m>,
    initial: &'m Set<StepId>,
    /// By transition, its condition, with what combinational variables stand for.
    trees: Vec<Tree>,
    /// By transition, its condition in the first evolution of a cycle.
    conditions: Vec<Rc<Condition>>,
    /// By transition, whether that always holds.
    always: Vec<bool>,
    /// By step, whether transitions that can clear lead there.
    reachable: Vec<bool>,
    /// What actions may change within a cycle.
    written: Set<Name>,
    /// Steps of which several can be active, apart from branches that are not exclusive. Found out where a circle is.
    parallel: OnceCell<Concurrency>,
    /// How many values nothing was known of.
    unknown: Cell<u64>,
}

impl<'m> Circles<'m> {
    /// For a `grafcet`; `logic` has to know the concurrency of the chart, which begins in the `initial` situation.
    #[must_use]
    pub fn new(model: &'m Model, concurrency: &'m Concurrency, logic: &'m Logic<'m>, initial: &'m Set<StepId>) -> Self {
        let tree = |transition: &Transition| {
            let tree = &transition.condition.tree;
            combinational::written_out(model, tree).unwrap_or_else(|| tree.clone())
        };
        let trees: Vec<Tree> = model.transitions.values().map(tree).list();
        let conditions: Vec<_> = trees.iter().map(|tree| Rc::new(logic.condition(tree))).list();
        let always = conditions.iter().map(|condition| logic.always(condition)).list();
        let reachable = rest::reachable(model, |id: TransitionId| !logic.never(&conditions[id.index()]));
        let (written, unknown) = (view::written(model), Cell::new(0));
        let parallel = OnceCell::new();
        Self { model, concurrency, logic, initial, trees, conditions, always, reachable, written, parallel, unknown }
    }

    /// Circles that turn under every valuation by which they can be entered: once one of their transitions clears in a
    /// stable situation, the search has no end.
    #[must_use]
    pub fn certain(&self) -> Vec<Circle> {
        let mut endless: Map<TransitionId, Vec<Ring>> = Map::new();
        for id in self.model.transitions.ids() {
            if self.surely_rests(id) || endless.contains_key(&id) {
                continue;
            }
            let Some(rings) = self.endless(self.entry(id)).filter(|_| self.can_enter(id, None)) else { continue };
            // Whoever enters a circle of equal conditions elsewhere finds the same one.
            if let [ring] = &rings[..] {
                for other in ring.iter().filter(|other| self.enters_alike(id, **other, ring)) {
                    endless.or_insert_with(*other, || rings.clone());
                }
            }
            endless.insert(id, rings);
        }
        let at_start = self.endless_at_start();
        if endless.is_empty() && at_start.is_empty() {
            return Vec::new();
        }
        // Only now is it worth the work to find out which situations are ever stable.
        let resting = self.resting();
        let enters = |id: &TransitionId| self.can_enter(*id, resting.as_ref());
        let turns = |id: &TransitionId| endless.contains_key(id) || !enters(id);
        let entered = endless.iter().filter(|(id, _)| enters(id)).flat(|(_, rings)| rings.clone());
        let mut found: Vec<Ring> = at_start.into_iter().and(entered).list();
        let mut known = Set::new();
        // What enters the circle in a stable situation, has to lead to no end, too. A search that goes on without a
        // transition, by stored values alone, is no circle of the chart.
        let is_circle = |ring: &Ring| {
            !ring.is_empty() && ring.iter().all(turns) && !self.has_several_marks(ring) && self.is_undisturbed(ring)
        };
        found.retain(|ring| known.insert(set(ring)) && is_circle(ring));
        found.into_iter().map(|transitions| Circle { transitions, inputs: String::new() }).list()
    }

    /// Further circles and values under which they turn, beside those in `known`.
    #[must_use]
    pub fn possible(&self, known: &[Circle]) -> Vec<Circle> {
        let mut seen: Set<Set<TransitionId>> = known.iter().map(|circle| set(&circle.transitions)).collect();
        let mut found: Vec<Circle> = Vec::new();
        for id in self.model.transitions.ids() {
            if found.iter().and(known).any(|circle| circle.transitions.contains(&id)) || !self.can_enter(id, None) {
                continue;
            }
            let mut run = Run::new(self, self.entry(id));
            while let Some(outcome) = run.next() {
                let Outcome::Endless(transitions, goals) = outcome else { continue };
                // Without a transition it is no circle of the chart, as in `certain`.
                if transitions.is_empty() || !seen.insert(set(&transitions)) {
                    continue;
                }
                let given = self.cleared(id).split_off(1);
                let given: Vec<&Condition> = given.iter().map(|(condition, _)| &**condition).list();
                if let Answer::Witness(inputs) = self.logic.together(&borrowed(&goals), &given) {
                    found.push(Circle { transitions, inputs });
                }
            }
        }
        found
    }

    /// Whether the circle turns for one transition as it does for the other: equal conditions that stand still.
    fn enters_alike(&self, a: TransitionId, b: TransitionId, circle: &[TransitionId]) -> bool {
        let (first, second) = (&self.model.transitions[a], &self.model.transitions[b]);
        let plain = |id: &TransitionId| {
            let transition = &self.model.transitions[*id];
            let still = |read: &Read| matches!(read, Read::Name(name) if !self.written.contains(name));
            transition.sources.len() == 1
                && transition.targets.len() == 1
                && transition.condition.reads.iter().all(still)
        };
        circle.contains(&a) && first.condition.tree == second.condition.tree && circle.iter().all(plain)
    }

    /// The circles in which the searches of the very first cycle end: whatever the inputs are, or where they let a
    /// transition clear at once, as a button that is held down at power-up does.
    fn endless_at_start(&self) -> Vec<Ring> {
        if let Some(rings) = self.endless(Some(self.start())) {
            return rings;
        }
        let start = self.start();
        let enabled = |id: &TransitionId| {
            let sources = &self.model.transitions[*id].sources;
            !sources.is_empty() && !self.surely_rests(*id) && sources.iter().all(|step| start.active.contains(step))
        };
        let mut found = Vec::new();
        for id in self.model.transitions.ids().filter(enabled) {
            let condition = Rc::new(View::new(self, &start).condition(id));
            if !self.logic.never(&condition) {
                // What happens beside is no part of the circle.
                let active: Set<StepId> = self.model.transitions[id].sources.iter().copied().collect();
                let (just_entered, before) = (active.clone(), active.clone());
                let held = Node {
                    active,
                    just_entered,
                    before,
                    goals: vec![(condition, true)],
                    parent: None,
                    cleared: Vec::new(),
                };
                found.push_all(self.endless(Some(held)).into_iter().flatten());
            }
        }
        found
    }

    /// The circles in which the searches from here end, if none of them comes to rest.
    fn endless(&self, start: Option<Node>) -> Option<Vec<Ring>> {
        let mut run = Run::new(self, start);
        let mut rings: Vec<Ring> = Vec::new();
        while let Some(outcome) = run.next() {
            let Outcome::Endless(ring, _) = outcome else { return None };
            if !rings.contains(&ring) {
                rings.push(ring);
            }
        }
        (!rings.is_empty()).then_some(rings)
    }

    /// Whether steps of the circle may be active that are not followed: two marks that change places change nothing.
    fn has_several_marks(&self, circle: &[TransitionId]) -> bool {
        let transitions = || circle.iter().map(|id| &self.model.transitions[*id]);
        // Steps that the circle itself activates together are no marks beside each other.
        let branches = transitions().any(|transition| transition.targets.len() > 1);
        let steps: Set<StepId> = transitions().flat(|transition| transition.sources.iter().copied()).collect();
        let parallel = || self.parallel.get_or_init(|| Concurrency::of_exclusive_branches(self.model));
        let beside = |a: &StepId| {
            let same = |b: &StepId| self.model.steps[*a].partial == self.model.steps[*b].partial;
            steps.iter().any(|b| same(b) && parallel().together(*a, *b))
        };
        !branches && steps.iter().any(beside)
    }

    /// The first evolution of a cycle, in which the transition clears; `None` if it cannot.
    fn entry(&self, id: TransitionId) -> Option<Node> {
        let transition = &self.model.transitions[id];
        let goals = self.cleared(id);
        if self.logic.impossible(&borrowed(&goals)) {
            return None;
        }
        let mut active: Set<StepId> = transition.targets.iter().copied().collect();
        let just_entered = active.iter().copied().filter(|step| !transition.sources.contains(step)).collect();
        let mut before: Set<StepId> = transition.sources.iter().copied().collect();
        let beside = self.active_beside(id, &goals);
        active.extend(&beside);
        before.extend(&beside);
        Some(Node { active, just_entered, before, goals, parent: None, cleared: vec![id] })
    }

    /// The first situation of the whole chart; there is no edge in it (A26).
    fn start(&self) -> Node {
        let commanded = |step: &StepId| {
            let partial = &self.model.partials[self.model.steps[*step].partial];
            partial.enclosed_by.is_some() || !partial.forced_by.is_empty()
        };
        let active: Set<StepId> = self.initial.iter().copied().filter(|step| !commanded(step)).collect();
        let (just_entered, before) = (active.clone(), active.clone());
        Node { active, just_entered, before, goals: Vec::new(), parent: None, cleared: Vec::new() }
    }

    /// What holds where a transition clears: its condition, with its steps active.
    fn cleared(&self, id: TransitionId) -> Goals {
        let sources = self.model.transitions[id].sources.iter();
        let active = sources.map(|step| (Rc::new(self.logic.condition(&Tree::Read(Read::Active(*step)))), true));
        std::iter::once((Rc::clone(&self.conditions[id.index()]), true)).and(active).list()
    }

    /// Steps that are active beside, because the condition says so, and stay it in that evolution.
    fn active_beside(&self, id: TransitionId, goals: &Goals) -> Vec<StepId> {
        let transition = &self.model.transitions[id];
        let active = |read: &Read| match read {
            Read::Active(step) | Read::Elapsed(_, step) if !transition.sources.contains(step) => Some(*step),
            _ => None,
        };
        let stays = |step: &StepId| {
            let variable = self.logic.condition(&Tree::Read(Read::Active(*step)));
            let excluded = |more: Goals| self.logic.impossible(&borrowed(&goals.iter().cloned().and(more).list()));
            excluded(vec![(Rc::new(variable), false)])
                && self.model.leaving[step.index()].iter().all(|other| excluded(self.cleared(*other)))
        };
        transition.condition.reads.iter().filter_map(active).filter(stays).list()
    }

    /// Seen at once: nothing that follows has to do with the condition, so nothing follows from it.
    fn surely_rests(&self, id: TransitionId) -> bool {
        let plain = |id: TransitionId| {
            let reads = &self.model.transitions[id].condition.reads;
            let inputs = |read: &Read| matches!(read, Read::Name(Name::Input(_)));
            (!reads.is_empty() && reads.iter().all(inputs)).then_some(reads)
        };
        let transition = &self.model.transitions[id];
        let Some(own) = plain(id) else { return false };
        !self.logic.has_assumptions()
            && transition.targets.iter().flat(|step| &self.model.leaving[step.index()]).all(|next| {
                let is_of_others = plain(*next).is_some_and(|reads| reads.iter().all(|read| !own.contains(read)));
                is_of_others && !self.always[next.index()]
            })
    }
}

/// Without what only clears along: transitions that lead nowhere in the circle, or come from nowhere in it.
pub(super) fn without_followers(model: &Model, mut circle: Vec<TransitionId>) -> Vec<TransitionId> {
    let transition = |id: &TransitionId| &model.transitions[*id];
    let lasts = |id: &TransitionId| transition(id).clearing.iter().any(run::is_restless);
    let is_loop = |id: &TransitionId| transition(id).sources == transition(id).targets;
    circle.retain(|id| !is_loop(id) || lasts(id));
    loop {
        let (mut left, mut entered) = (vec![false; model.steps.len()], vec![false; model.steps.len()]);
        for id in &circle {
            for step in &transition(id).sources {
                left[step.index()] = true;
            }
            for step in &transition(id).targets {
                entered[step.index()] = true;
            }
        }
        let turns = |id: &TransitionId| {
            transition(id).targets.iter().any(|step| left[step.index()])
                && transition(id).sources.iter().any(|step| entered[step.index()])
        };
        let kept: Vec<TransitionId> = circle.iter().copied().filter(turns).list();
        if kept.len() == circle.len() {
            // What stands first in the source stands first.
            let first = circle.iter().enumerate().min_by_key(|(_, id)| **id).map_or(0, |(first, _)| first);
            circle.rotate_left(first);
            return circle;
        }
        circle = kept;
    }
}

fn set(circle: &[TransitionId]) -> Set<TransitionId> {
    circle.iter().copied().collect()
}

fn borrowed(goals: &Goals) -> Vec<(&Condition, bool)> {
    goals.iter().map(|(condition, wanted)| (&**condition, *wanted)).list()
}
