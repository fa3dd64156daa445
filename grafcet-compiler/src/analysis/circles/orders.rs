//! Whether a search is left alone by what commands its partial grafcet: an order that appears, or an enclosing step that
//! is left, in a later evolution of the same cycle ends a circle that would turn without end.

use super::Circles;
use super::run::Node;
use super::view::View;
use crate::list::List;
use crate::model::{Id, Name, PartialId, Read, StepId, TransitionId};
use crate::sorted::Set;

impl Circles<'_> {
    /// Whether nothing that commands the circle's partial grafcets evolves in a cycle that something else began.
    pub(super) fn is_undisturbed(&self, circle: &[TransitionId]) -> bool {
        let mut known: Set<PartialId> = Set::new();
        let mut open: Vec<PartialId> = circle.iter().map(|id| self.model.transitions[*id].partial).list();
        while let Some(partial) = open.pop() {
            if !known.insert(partial) {
                continue;
            }
            let mut commanding = Vec::new();
            if let Some(outer) = self.model.partials[partial].enclosed_by {
                open.push(self.model.steps[outer].partial);
                commanding.extend(&self.model.leaving[outer.index()]);
            }
            for force in self.model.orders_on(partial) {
                let master = &self.model.steps[force.step];
                if master.linked || self.is_forced(force.step) {
                    return false;
                }
                open.push(master.partial);
                commanding.extend(&self.model.entering[force.step.index()]);
            }
            if commanding.into_iter().any(|id| self.can_follow(id)) {
                return false;
            }
        }
        true
    }

    /// Whether the transition can clear after the first evolution of a cycle. It cannot if it waits for inputs alone:
    /// where it is enabled when the cycle begins, it clears at once, and what enables it leaves its condition false.
    fn can_follow(&self, id: TransitionId) -> bool {
        let view = Node::default();
        let condition = View::new(self, &view).condition(id);
        if self.logic.never(&condition) {
            return false;
        }
        let transition = &self.model.transitions[id];
        let stands_still = |read: &Read| match read {
            Read::Name(Name::Input(_) | Name::Param(_)) => true,
            // Where its own step was just entered, no time has passed.
            Read::Elapsed(_, step) => transition.sources.contains(step),
            Read::Rising(edge) | Read::Falling(edge) => {
                let reads = &self.model.edges[*edge].of.reads;
                reads.iter().all(|read| matches!(read, Read::Name(Name::Input(_))))
            }
            _ => false,
        };
        let enables = |step: &StepId| {
            let entering = self.model.entering[step.index()].iter();
            self.model.steps[*step].linked
                || self.is_forced(*step)
                || entering
                    .into_iter()
                    .any(|other| !self.logic.impossible(&[(&self.conditions[other.index()], true), (&condition, true)]))
        };
        transition.sources.is_empty()
            || !transition.condition.reads.iter().all(stands_still)
            || transition.sources.iter().any(enables)
    }
}
