//! One search for stability, under all valuations at once.

use std::rc::Rc;

use super::view::View;
use super::{Circles, Goals, borrowed};
use crate::analysis::Condition;
use crate::list::List;
use crate::model::{Binary, Effect, Id, Name, Place, Read, Statement, StepId, TransitionId, Tree, Unary};
use crate::sorted::Set;

/// How many situations one search follows.
const SITUATIONS: usize = 500;

/// How many transitions may be open at once: all their combinations are tried.
const OPEN: usize = 5;

/// How many steps are followed beside each other.
const STEPS: usize = 64;

/// A situation on the way, as far as it is followed.
#[derive(Default)]
pub(super) struct Node {
    /// Steps that are active.
    pub(super) active: Set<StepId>,
    /// Those of them that were entered in this cycle.
    pub(super) just_entered: Set<StepId>,
    /// Steps that were active in the evolution before.
    pub(super) before: Set<StepId>,
    /// What has been decided on the way.
    pub(super) goals: Goals,
    pub(super) parent: Option<usize>,
    /// What has cleared last.
    pub(super) cleared: Vec<TransitionId>,
}

/// How a search ends.
pub(super) enum Outcome {
    /// Some valuation ends it with these steps active.
    Rests(Set<StepId>),
    /// These transitions clear again and again, where the conditions have these values.
    Endless(Vec<TransitionId>, Goals),
    Undecided,
}

/// The searches from one situation, one outcome after the other.
pub(super) struct Run<'r, 'm> {
    circles: &'r Circles<'m>,
    nodes: Vec<Node>,
    open: Vec<usize>,
}

/// What can clear in a situation.
struct Enabled {
    surely: Vec<TransitionId>,
    maybe: Vec<(TransitionId, Rc<Condition>)>,
}

impl<'r, 'm> Run<'r, 'm> {
    pub(super) fn new(circles: &'r Circles<'m>, start: Option<Node>) -> Self {
        let nodes: Vec<Node> = start.into_iter().list();
        Self { circles, open: (0..nodes.len()).list(), nodes }
    }

    /// How many situations were looked at so far.
    pub(super) fn looked_at(&self) -> usize {
        self.nodes.len()
    }

    /// The next outcome; `None` when all are known.
    pub(super) fn next(&mut self) -> Option<Outcome> {
        while let Some(at) = self.open.pop() {
            if self.nodes.len() > SITUATIONS || self.nodes[at].active.len() > STEPS {
                self.open.clear();
                return Some(Outcome::Undecided);
            }
            if let Some(circle) = self.circle(at) {
                return Some(Outcome::Endless(circle, self.nodes[at].goals.clone()));
            }
            let enabled = self.enabled(at);
            if enabled.maybe.len() > OPEN {
                return Some(Outcome::Undecided);
            }
            let rests = self.follow(at, &enabled);
            if rests {
                return Some(Outcome::Rests(self.nodes[at].active.clone()));
            }
        }
        None
    }

    /// The transitions since the same situation on the way here.
    fn circle(&self, at: usize) -> Option<Vec<TransitionId>> {
        let node = &self.nodes[at];
        let just_entered = |node: &Node| node.just_entered.intersection(&node.active).copied().collect::<Set<_>>();
        let mut circle: Vec<TransitionId> = node.cleared.iter().rev().copied().list();
        let mut parent = node.parent;
        while let Some(other) = parent.map(|parent| &self.nodes[parent]) {
            if other.active == node.active && other.before == node.before && just_entered(other) == just_entered(node) {
                circle.reverse();
                return Some(super::without_followers(self.circles.model, circle));
            }
            circle.extend(other.cleared.iter().rev());
            parent = other.parent;
        }
        None
    }

    fn enabled(&self, at: usize) -> Enabled {
        let (circles, node) = (self.circles, &self.nodes[at]);
        let view = View::new(circles, node);
        let leaving: Set<TransitionId> =
            node.active.iter().flat(|step| circles.model.leaving[step.index()].iter().copied()).collect();
        let mut enabled = Enabled { surely: Vec::new(), maybe: Vec::new() };
        for id in leaving {
            if !circles.model.transitions[id].sources.iter().all(|step| node.active.contains(step)) {
                continue;
            }
            let condition = view.condition(id);
            let mut goals = borrowed(&node.goals);
            goals.push((&condition, true));
            if circles.logic.impossible(&goals) {
                continue;
            }
            goals.pop();
            goals.push((&condition, false));
            if circles.logic.impossible(&goals) {
                enabled.surely.push(id);
            } else {
                enabled.maybe.push((id, Rc::new(condition)));
                // Nobody tries so many combinations.
                if enabled.maybe.len() > OPEN {
                    break;
                }
            }
        }
        enabled
    }

    /// Goes on with everything that can clear together; whether the search can end here instead.
    fn follow(&mut self, at: usize, enabled: &Enabled) -> bool {
        let mut rests = false;
        for chosen in 0..1_usize << enabled.maybe.len() {
            let is_chosen = |index: usize| chosen >> index & 1 == 1;
            let choice = enabled.maybe.iter().enumerate().map(|(i, (_, c))| (Rc::clone(c), is_chosen(i)));
            let goals: Goals = self.nodes[at].goals.iter().cloned().and(choice).list();
            // One open condition alone can have both values.
            if enabled.maybe.len() > 1 && self.circles.logic.impossible(&borrowed(&goals)) {
                continue;
            }
            let maybe = enabled.maybe.iter().enumerate().filter(|(i, _)| is_chosen(*i)).map(|(_, (id, _))| *id);
            let cleared: Vec<TransitionId> = enabled.surely.iter().copied().and(maybe).list();
            match self.clear(at, cleared, goals) {
                Some(next) => {
                    self.nodes.push(next);
                    self.open.push(self.nodes.len() - 1);
                }
                None => rests = true,
            }
        }
        rests
    }

    /// The situation after an evolution; `None` if nothing changes (A25).
    fn clear(&self, at: usize, cleared: Vec<TransitionId>, goals: Goals) -> Option<Node> {
        let (transitions, node) = (&self.circles.model.transitions, &self.nodes[at]);
        let steps = |pick: fn(&crate::model::Transition) -> &Vec<StepId>| {
            cleared.iter().flat(|id| pick(&transitions[*id]).iter().copied()).collect::<Set<StepId>>()
        };
        let (sources, targets) = (steps(|t| &t.sources), steps(|t| &t.targets));
        let mut active: Set<StepId> = node.active.difference(&sources).copied().collect();
        active.extend(&targets);
        if active == node.active && !cleared.iter().any(|id| transitions[*id].clearing.iter().any(is_restless)) {
            return None;
        }
        // A4g: a step that is left and entered at once stays active.
        let mut just_entered: Set<StepId> = node.just_entered.intersection(&active).copied().collect();
        just_entered.extend(targets.difference(&node.active));
        Some(Node { active, just_entered, before: node.active.clone(), goals, parent: Some(at), cleared })
    }
}

/// Whether an action on clearing changes something, or calls, each time anew (A25).
pub(super) fn is_restless(effect: &Effect) -> bool {
    match effect {
        Effect::Call(..) => true,
        Effect::Assign(place, value) => counts(*place, &value.tree),
        Effect::Block(code) => code
            .statements
            .iter()
            .flatten()
            .any(|statement| matches!(statement, Statement::Assign(place, value) if counts(*place, value))),
        Effect::Control(_) => false,
    }
}

/// `n + 1`, `!n`: another value than that of `n`.
fn counts(place: Place, value: &Tree) -> bool {
    let own = |tree: &Tree| matches!(tree, Tree::Read(Read::Name(name)) if *name == Name::from(place));
    match value {
        Tree::Unary(Unary::Not, inner) => own(inner),
        Tree::Binary(Binary::Add | Binary::Sub, a, b) => own(a) && matches!(**b, Tree::Int(step) if step != 0),
        _ => false,
    }
}
