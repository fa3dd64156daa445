//! The cycle of an `sfc`, IEC 61131-3: one evolution, then the actions.

use super::{Cycles, Lower};
use crate::list::{List, PushAll};
use crate::model::{Id, Name, Read};
use crate::program::build::{all, any, differ, no, not, part, when, yes};
use crate::program::{Expr, Mark, PlaceId, Statement};

impl<'m> Lower<'_, 'm> {
    /// "Exactly one evolution, then the actions. In the first cycle no evolution: the initial step is entered."
    pub(super) fn scan_cycle(&mut self) -> Cycles<'m> {
        let mut cycle = Vec::new();
        let (kept, values) = self.keep_values();
        part(&mut cycle, "time passes", self.pass_time());
        part(&mut cycle, "the situation before", self.copy_situation());
        part(&mut cycle, "delays and edges", self.sample_once());
        let mut forced = self.model.forceable.then(|| cycle.clone());
        let first = self.enter_initial();
        let mut evolution = self.decide();
        evolution.push_all(self.note_changes());
        evolution.push_all(self.write_situation());
        let evolve = vec![Statement::If(Expr::Place(self.first), first, evolution)];
        part(&mut cycle, "first cycle, or evolution (points 1 to 3)", evolve);
        let evolved = cycle.len();
        part(&mut cycle, "what observers are told", self.tell());
        part(&mut cycle, "times reached and begun (A34)", [self.keep_times(), self.begin_times()].concat());
        part(&mut cycle, "the values before the actions (point 6)", values);
        part(&mut cycle, "edges for actions (point 8)", self.sample_for_actions());
        self.act(&mut cycle);
        self.remember_passed();
        let acted = cycle.len();
        part(&mut cycle, "times that are over", self.bound_times());
        part(&mut cycle, "whether the next cycle would do the same", self.settle(&kept));
        let settled = cycle.len();
        let mut end = self.use_up_edges();
        end.push_all(self.use_up_action_edges());
        end.push(Statement::Set(self.first, no()));
        part(&mut cycle, "end", end);
        if let Some(forced) = &mut forced {
            part(forced, "the evolution by hand (A38)", self.force_scan());
            forced.extend_from_slice(&cycle[evolved..acted]);
            part(forced, "times that are over", self.bound_times_by_hand());
            part(forced, "the next cycle is due at once", self.unsettle());
            forced.extend_from_slice(&cycle[settled..]);
        }
        Cycles { own: cycle, forced }
    }

    pub(super) fn copy_situation(&self) -> Vec<Statement<'m>> {
        let pairs = self.was.iter().zip(&self.state);
        pairs.map(|(was, state)| Statement::Set(*was, Expr::Place(*state))).list()
    }

    /// Point 1: the initial situation is entered, no transition is evaluated (A27).
    fn enter_initial(&self) -> Vec<Statement<'m>> {
        self.initial.iter().map(|step| Statement::Set(self.entered[step.index()], yes())).list()
    }

    /// Which steps are left and which are entered. A4s: one that is left and entered is both; one that was active and is not left is
    /// not entered anew.
    fn note_changes(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for step in self.model.steps.ids() {
            let leaving = self.leaving(step);
            if !leaving.is_empty() {
                body.push(Statement::Set(self.left[step.index()], any(leaving)));
            }
        }
        for step in self.model.steps.ids() {
            let entering = self.entering(step);
            if !entering.is_empty() {
                let stays = all(vec![self.was(step), not(Expr::Place(self.left[step.index()]))]);
                body.push(Statement::Set(self.entered[step.index()], all(vec![any(entering), not(stays)])));
            }
        }
        body
    }

    /// `X' = (X − ∪ sources(F)) ∪ ∪ targets(F)`
    fn write_situation(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for step in self.model.steps.ids() {
            if !self.leaving(step).is_empty() {
                when(&mut body, Expr::Place(self.left[step.index()]), vec![self.put(step, false)]);
            }
        }
        for step in self.model.steps.ids() {
            if !self.entering(step).is_empty() {
                when(&mut body, Expr::Place(self.entered[step.index()]), vec![self.put(step, true)]);
            }
        }
        body
    }

    fn tell(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        let mut tell = |place: PlaceId, mark: Mark| {
            body.push(Statement::If(Expr::Place(place), vec![Statement::Mark(mark)], Vec::new()));
        };
        for id in self.model.transitions.ids() {
            tell(self.clears[id.index()], Mark::Cleared(id));
        }
        for step in self.model.steps.ids() {
            tell(self.left[step.index()], Mark::Deactivated(step));
        }
        for step in self.model.steps.ids() {
            tell(self.entered[step.index()], Mark::Activated(step));
        }
        when(&mut body, self.any_clears(), vec![Statement::Mark(Mark::Evolved)]);
        body
    }

    fn any_clears(&self) -> Expr<'m> {
        any(self.clears.iter().map(|place| Expr::Place(*place)).list())
    }

    /// Outputs that actions read, as the previous cycle returned them (point 6). Of a chart with time also the variables and all other outputs
    /// that something reads: where one changes, the next cycle sees it.
    fn keep_values(&mut self) -> (Vec<(PlaceId, PlaceId)>, Vec<Statement<'m>>) {
        let mut kept = Vec::new();
        for (last, output) in self.last_outputs.iter().zip(&self.outputs) {
            if let Some(last) = last {
                kept.push((*output, *last));
            }
        }
        if self.settled.is_some() {
            for place in self.read_places() {
                if !kept.iter().any(|(other, _)| *other == place) {
                    let name = format!("was.{}", self.name(place));
                    kept.push((place, self.like(name, place)));
                }
            }
        }
        let copies = kept.iter().map(|(place, copy)| Statement::Set(*copy, Expr::Place(*place))).list();
        (kept, copies)
    }

    /// The variables, and the outputs that some expression reads.
    fn read_places(&self) -> Vec<PlaceId> {
        let mut places = self.vars.clone();
        for read in self.model.expressions().concat() {
            if let Read::Name(Name::Output(id)) = read {
                places.push(self.outputs[id.index()]);
            }
        }
        places
    }

    /// Nothing cleared, no edge is gone, no value that is read has changed, and no Rust ran that may remember something of its own.
    fn settle(&self, kept: &[(PlaceId, PlaceId)]) -> Vec<Statement<'m>> {
        let Some(settled) = self.settled else { return Vec::new() };
        let mut moves = vec![Expr::Place(self.first), self.any_clears(), self.has_edges()];
        for (place, copy) in kept {
            moves.push(differ(*place, *copy));
        }
        moves.push_all(self.turned.into_iter().and(self.opaque_ran).map(Expr::Place));
        vec![Statement::Set(settled, not(any(moves)))]
    }
}
