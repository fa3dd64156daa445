//! The cycle that leads into a situation by hand (A38): "no transition condition is evaluated, and nothing clears; steps that are active and
//! not named are deactivated, steps that are named and not active are activated, each with all that belongs to that".

use super::Lower;
use super::grafcet::Round;
use crate::list::{List, PushAll};
use crate::model::{Id, StepId};
use crate::program::build::{all, any, no, not, part, yes};
use crate::program::{Expr, PlaceId, Statement};

impl<'m> Lower<'_, 'm> {
    /// The evolution of an `sfc`. "Forced before the first cycle, the chart enters these steps, and the initial ones were never active."
    pub(super) fn force_scan(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for step in self.model.steps.ids() {
            let (was, asked) = (self.was(step), self.asks_for(step));
            let (left, entered) = (self.left[step.index()], self.entered[step.index()]);
            let first = || Expr::Place(self.first);
            body.push(Statement::Set(left, all(vec![not(first()), was.clone(), not(asked.clone())])));
            body.push(Statement::Set(entered, all(vec![asked, any(vec![first(), not(was)])])));
        }
        body.push_all(self.take_asked());
        body
    }

    /// "In a `grafcet` there is one evolution and no search for stability": the parts of the cycle from its evolution to the stable situation.
    pub(super) fn force_search(&self, round: &Round<'m>, stable: Option<PlaceId>) -> Vec<Statement<'m>> {
        let mut evolution = round.look.clone();
        evolution.push_all(self.take_asked());
        evolution.push_all(round.stored.clone());
        evolution.push_all(round.commit.clone());
        let mut cycle = Vec::new();
        part(&mut cycle, "the evolution by hand (A38)", evolution);
        // "An edge of a step is seen by the next cycle."
        part(&mut cycle, "what there is to see of the situation that it has led to", round.look.clone());
        part(&mut cycle, "stable", stable.map(|stable| Statement::Set(stable, yes())).into_iter().list());
        cycle
    }

    /// "`next_deadline` names this very reading."
    pub(super) fn unsettle(&self) -> Vec<Statement<'m>> {
        self.settled.map(|settled| Statement::Set(settled, no())).into_iter().list()
    }

    /// A step that each other cycle leaves in time stays active for as long as it is asked for.
    pub(super) fn bound_times_by_hand(&self) -> Vec<Statement<'m>> {
        let mut body = self.note_passed();
        for bound in &self.longest {
            body.push_all(self.bound_time(bound));
        }
        body.push_all(self.move_periods());
        body
    }

    fn asks_for(&self, step: StepId) -> Expr<'m> {
        self.in_step(&self.asked, step)
    }

    fn take_asked(&self) -> Vec<Statement<'m>> {
        let pairs = self.state.iter().zip(&self.asked);
        pairs.map(|(state, asked)| Statement::Set(*state, Expr::Place(*asked))).list()
    }
}
