//! Which transitions a transition may enable in the same cycle, and which exclude each other in it.

use std::collections::BTreeMap;

use super::{Candidates, is_constant_read};
use crate::analysis::edges::is_edge_of_inputs;
use crate::analysis::{Condition, Logic};
use crate::list::List;
use crate::model::{Binary, Blink, Blinker, ForceOrder, Id, Model, Read, StepId, TimeRef, TransitionId, Tree, Unary};
use crate::sorted::{Map, Set};

/// In larger circles no choice is looked for, nor a count: it would take a comparison of all pairs.
pub(super) const LARGE: usize = 80;

pub(super) struct Successors<'m> {
    model: &'m Model,
    logic: Logic<'m>,
    /// By transition, the steps it activates, also by what a step forces or encloses.
    activates: Vec<Set<StepId>>,
    /// By step, the transitions that activate it.
    entering: Vec<Vec<TransitionId>>,
    /// By transition, the number of its condition among the different ones.
    condition_of: Vec<usize>,
    /// The same of its condition as it is when its source step has been entered in the same cycle.
    entered_of: Vec<usize>,
    conditions: Vec<Condition>,
    /// Whether two conditions can hold together, as far as that was asked.
    together: BTreeMap<(usize, usize), bool>,
    /// Whether two transitions exclude each other, as far as that was asked.
    excluding: BTreeMap<(TransitionId, TransitionId), bool>,
}

impl<'m> Successors<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        let logic = Logic::new(model);
        let mut entering = vec![Vec::new(); model.steps.len()];
        let mut activates = Vec::new();
        for (id, transition) in model.transitions.iter() {
            let steps = activated(model, &transition.targets);
            for step in &steps {
                entering[step.index()].push(id);
            }
            activates.push(steps);
        }
        let mut different: Map<Tree, usize> = Map::new();
        let mut conditions = Vec::new();
        let mut number = |tree: Tree| {
            let number = different.get(&tree).copied().unwrap_or(conditions.len());
            if number == conditions.len() {
                conditions.push(logic.condition(&tree));
                different.insert(tree, number);
            }
            number
        };
        let (mut condition_of, mut entered_of) = (Vec::new(), Vec::new());
        for transition in model.transitions.values() {
            let tree = &transition.condition.tree;
            condition_of.push(number(constant_part(tree, true)));
            let entered = just_entered(model, tree, &transition.sources);
            entered_of.push(number(constant_part(&entered, true)));
        }
        let (together, excluding) = (BTreeMap::new(), BTreeMap::new());
        Self { model, logic, activates, entering, condition_of, entered_of, conditions, together, excluding }
    }

    pub(super) fn transitions(&self) -> usize {
        self.model.transitions.len()
    }

    /// The steps that a transition activates, also by what they force or enclose.
    pub(super) fn activates(&self, id: TransitionId) -> &Set<StepId> {
        &self.activates[id.index()]
    }

    /// Whether two transitions never clear together, whatever changes within a search.
    pub(super) fn exclude(&mut self, a: TransitionId, b: TransitionId) -> bool {
        let (model, logic) = (self.model, &self.logic);
        let condition = |id: TransitionId| logic.condition(&model.transitions[id].condition.tree);
        let asked = || model.exclude_each_other(a, b) || logic.exclusive(&condition(a), &condition(b));
        *self.excluding.entry((a.min(b), a.max(b))).or_insert_with(asked)
    }

    /// The transitions that one may enable.
    pub(super) fn after(&mut self, id: TransitionId) -> Vec<TransitionId> {
        let next: Vec<_> =
            self.activates[id.index()].iter().flat(|step| self.model.leaving[step.index()].clone()).list();
        next.into_iter().filter(|other| self.can_clear_together(id, *other)).list()
    }

    /// Whether nothing that leaves the steps a transition activates can clear in the same cycle.
    pub(super) fn is_followed_by_none(&mut self, id: TransitionId) -> bool {
        let leaving: Vec<_> =
            self.activates[id.index()].iter().flat(|step| self.model.leaving[step.index()].clone()).list();
        leaving
            .into_iter()
            .all(|next| !self.hold_together(self.condition_of[id.index()], self.entered_of[next.index()]))
    }

    /// Whether transitions among `candidates` enter each of its source steps.
    pub(super) fn is_entered(&mut self, id: TransitionId, candidates: &Candidates) -> bool {
        let sources = &self.model.transitions[id].sources;
        sources.iter().all(|step| {
            let entering = self.entering[step.index()].clone();
            entering.into_iter().any(|other| candidates.contains(&other) && self.can_clear_together(other, id))
        })
    }

    /// The transition that most others exclude, and these.
    pub(super) fn choice(&mut self, circle: &Candidates) -> Option<(TransitionId, Candidates)> {
        if circle.len() > LARGE {
            return None;
        }
        let mut best: Option<(TransitionId, Candidates)> = None;
        for one in circle {
            let others: Candidates =
                circle.iter().copied().filter(|other| !self.can_clear_together(*one, *other)).collect();
            if others.len() > best.as_ref().map_or(0, |(_, others)| others.len()) {
                best = Some((*one, others));
            }
        }
        best
    }

    fn can_clear_together(&mut self, a: TransitionId, b: TransitionId) -> bool {
        self.hold_together(self.condition_of[a.index()], self.condition_of[b.index()])
    }

    fn hold_together(&mut self, a: usize, b: usize) -> bool {
        let (logic, conditions) = (&self.logic, &self.conditions);
        *self.together.entry((a.min(b), a.max(b))).or_insert_with(|| !logic.exclusive(&conditions[a], &conditions[b]))
    }
}

/// These steps, the linked ones of those that enclose others, and the ones they force.
fn activated(model: &Model, steps: &[StepId]) -> Set<StepId> {
    let mut all = Set::new();
    let mut waiting = steps.to_vec();
    while let Some(step) = waiting.pop() {
        if !all.insert(step) {
            continue;
        }
        for partial in model.partials.values().filter(|partial| partial.enclosed_by == Some(step)) {
            waiting.extend(partial.steps.iter().filter(|inner| model.steps[**inner].linked));
        }
        for force in model.orders_of(step) {
            match &force.order {
                ForceOrder::Steps(situation) => waiting.extend(situation),
                ForceOrder::Init => {
                    let steps = &model.partials[force.target].steps;
                    waiting.extend(steps.iter().filter(|step| model.steps[**step].initial));
                }
                ForceOrder::Hold => {}
            }
        }
    }
    all
}

/// A condition where one of these steps has been entered in the same cycle: its time is zero, and edges of what stays constant
/// are gone (A2).
fn just_entered(model: &Model, tree: &Tree, steps: &[StepId]) -> Tree {
    let inner = |tree: &Tree| Box::new(just_entered(model, tree, steps));
    match tree {
        Tree::Elapsed(TimeRef::Ticks(1..), step) if steps.contains(step) => Tree::Bool(false),
        Tree::Read(Read::Blink(Blink { of: Blinker::Step(step), .. })) if steps.contains(step) => Tree::Bool(true),
        Tree::Read(read) if is_edge_of_inputs(model, read) => Tree::Bool(false),
        Tree::Binary(Binary::Ge | Binary::Gt, a, b) => match (&**a, &**b) {
            (Tree::Read(Read::Since(step)), Tree::Read(Read::Ticks(1..))) if steps.contains(step) => Tree::Bool(false),
            _ => tree.clone(),
        },
        Tree::Unary(Unary::Not, of) => Tree::Unary(Unary::Not, inner(of)),
        Tree::Binary(operator @ (Binary::And | Binary::Or), a, b) => Tree::Binary(*operator, inner(a), inner(b)),
        _ => tree.clone(),
    }
}

/// What a condition demands of the values that stay constant during a cycle: everything else is taken as favourable.
fn constant_part(tree: &Tree, favourable: bool) -> Tree {
    match tree {
        Tree::Bool(_) | Tree::Int(_) => tree.clone(),
        Tree::Unary(Unary::Not, inner) => Tree::Unary(Unary::Not, Box::new(constant_part(inner, !favourable))),
        Tree::Binary(operator @ (Binary::And | Binary::Or), a, b) => {
            Tree::Binary(*operator, Box::new(constant_part(a, favourable)), Box::new(constant_part(b, favourable)))
        }
        other if is_constant(other) => other.clone(),
        _ => Tree::Bool(favourable),
    }
}

fn is_constant(tree: &Tree) -> bool {
    match tree {
        Tree::Bool(_) | Tree::Int(_) => true,
        Tree::Read(read) => is_constant_read(read),
        Tree::Unary(_, inner) => is_constant(inner),
        Tree::Binary(_, a, b) => is_constant(a) && is_constant(b),
        Tree::Opaque { reads, call, .. } => call.is_none() && reads.iter().all(is_constant_read),
        Tree::Elapsed(..) | Tree::MacroElapsed(..) => false,
    }
}
