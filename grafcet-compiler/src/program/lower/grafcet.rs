//! The cycle of a `grafcet`, IEC 60848: the search for stability.

use super::{Cycles, Lower};
use crate::list::{List, PushAll};
use crate::model::{Effect, Expr as Written, Id, Name, OutputId, Place, Read};
use crate::program::build::{all, any, compare, differ, no, not, number, part, when, yes};
use crate::program::{Comparison, Expr, Initial, Mark, PlaceId, Role, Statement, Type, Value};

use super::stored::Stored;

/// Whether an expression looks at inputs alone: the next search finds them as this one.
fn is_of_inputs(expr: &Written) -> bool {
    expr.reads.iter().all(|read| matches!(read, Read::Name(Name::Input(_)) | Read::Delay(_)))
}

/// What every evolution does, however it is found: in the order of its three parts.
pub(super) struct Round<'m> {
    /// The situation and the values before it.
    pub(super) look: Vec<Statement<'m>>,
    /// The stored actions.
    pub(super) stored: Vec<Statement<'m>>,
    /// It takes place, and observers are told.
    pub(super) commit: Vec<Statement<'m>>,
}

impl<'m> Lower<'_, 'm> {
    /// "Evolutions until the situation is stable; stored actions run with their evolution, continuous ones are evaluated once, on the
    /// stable situation."
    pub(super) fn search_cycle(&mut self) -> Cycles<'m> {
        let on = Initial::Value(Value::Bool(true));
        let stable = (!self.search_ends).then(|| self.field("stable".to_owned(), Role::Stable, Type::Bool, on));
        let mut stored = self.stored_places();
        let mut cycle = Vec::new();
        let (kept, values) = self.keep_read_outputs();
        part(&mut cycle, "time passes", self.pass_time());
        let mut sampled = self.sample_once();
        if !sampled.is_empty() {
            sampled.splice(0..0, self.copy_situation());
        }
        part(&mut cycle, "delays, on the situation the cycle starts from (A36)", sampled);
        part(&mut cycle, "the outputs before", values);
        let activate = self.activate(&mut stored);
        if !activate.is_empty() {
            let first = vec![Statement::If(Expr::Place(self.first), activate, Vec::new())];
            part(&mut cycle, "activation of the initial situation (A37)", first);
        }
        let round = self.round(&mut stored);
        let mut forced = self.model.forceable.then(|| cycle.clone());
        let rounds = self.bound.saturating_add(1);
        let body = self.evolution(stable, &stored, &round);
        part(&mut cycle, "search for stability (A24, A25, A30)", vec![Statement::Loop { rounds, body }]);
        let found = cycle.len();
        self.continuous(&mut cycle);
        self.remember_passed();
        let acted = cycle.len();
        part(&mut cycle, "times that are over", self.bound_times());
        part(&mut cycle, "whether the next cycle would do the same", self.settle_search(stable, &kept));
        let mut end = Vec::new();
        // An evolution that the bound stopped has not taken place: its edges are still to be seen.
        when(&mut end, stable.map_or_else(yes, Expr::Place), self.use_up_edges());
        end.push(Statement::Set(self.first, no()));
        part(&mut cycle, "end", end);
        if let Some(forced) = &mut forced {
            forced.append(&mut self.force_search(&round, stable));
            forced.extend_from_slice(&cycle[found..acted]);
            part(forced, "times that are over", self.bound_times_by_hand());
            part(forced, "the next cycle is due at once", self.unsettle());
            part(forced, "end", vec![Statement::Set(self.first, no())]);
        }
        Cycles { own: cycle, forced }
    }

    /// What every evolution does, however it is found.
    fn round(&mut self, stored: &mut Stored<'m>) -> Round<'m> {
        let none_yet = compare(Comparison::Equal, Expr::Place(self.evolutions), number(0));
        let first_evolution = all(vec![Expr::Place(self.first), none_yet]);
        let mut look = Vec::new();
        part(&mut look, "the situation before", self.copy_situation());
        part(&mut look, "edges and combinational variables (A2, A22)", self.sample_evolution(&first_evolution));
        let (writes, mut commit) = self.stored_actions(stored);
        commit.push_all(stored.next.iter().map(|(place, next)| Statement::Set(*place, Expr::Place(*next))));
        commit.push_all(self.begin_times());
        commit.push_all(self.use_up_edges());
        // Without a bound it is enough to know whether there has been one.
        let count = if self.search_ends { number(1) } else { Expr::Next(self.evolutions) };
        commit.push(Statement::Set(self.evolutions, count));
        let mut acts = Vec::new();
        part(&mut acts, "stored actions, on the values before (A5)", writes);
        let mut all_at_once = Vec::new();
        part(&mut all_at_once, "it takes place, all at once (A6)", commit);
        part(&mut all_at_once, "what observers are told", self.tell_evolution());
        Round { look, stored: acts, commit: all_at_once }
    }

    /// One round of the search.
    fn evolution(&self, stable: Option<PlaceId>, stored: &Stored<'m>, round: &Round<'m>) -> Vec<Statement<'m>> {
        let mut body = round.look.clone();
        part(&mut body, "what nothing above keeps from clearing (A13, A17)", self.decide_free());
        part(&mut body, "what clears", self.decide());
        part(&mut body, "from above downwards (A11, A15, A19)", self.descend());
        body.extend_from_slice(&round.stored);
        let mut changes: Vec<Expr<'m>> =
            self.was.iter().zip(&self.state).map(|(was, state)| differ(*was, *state)).list();
        changes.push_all(stored.next.iter().map(|(place, next)| differ(*place, *next)));
        changes.push_all(stored.due.iter().map(|due| Expr::Place(*due)));
        let mut is_stable: Vec<Statement<'m>> = stable.map(|stable| Statement::Set(stable, yes())).into_iter().list();
        is_stable.push(Statement::Break);
        part(&mut body, "stable (A25)", vec![Statement::If(not(any(changes)), is_stable, Vec::new())]);
        let bound = stable.map(|stable| self.bound(stable, round)).into_iter().list();
        if self.is_stopped_after() {
            body.extend_from_slice(&round.commit);
            part(&mut body, "the bound (A30)", bound);
        } else {
            part(&mut body, "the bound (A30)", bound);
            body.extend_from_slice(&round.commit);
        }
        body
    }

    /// Whether the bound is looked at after the last evolution, as what has made so many goes on for ever; of one region `search` finds that.
    fn is_stopped_after(&self) -> bool {
        self.comes_back && self.state.len() > 1
    }

    /// The bound stops the search.
    fn bound(&self, stable: PlaceId, round: &Round<'m>) -> Statement<'m> {
        let mut stop = vec![Statement::Set(stable, no())];
        stop.push_all(if self.is_stopped_after() { round.look.clone() } else { self.take_back() });
        stop.push(Statement::Break);
        let at_bound = compare(Comparison::Equal, Expr::Place(self.evolutions), number(self.bound as usize));
        Statement::If(at_bound, stop, Vec::new())
    }

    /// The situation that the search had reached before stays.
    fn take_back(&self) -> Vec<Statement<'m>> {
        let pairs = self.was.iter().zip(&self.state);
        pairs.map(|(was, state)| Statement::Set(*state, Expr::Place(*was))).list()
    }

    fn tell_evolution(&self) -> Vec<Statement<'m>> {
        let mut body = Vec::new();
        for id in self.model.transitions.ids() {
            when(&mut body, Expr::Place(self.clears[id.index()]), vec![Statement::Mark(Mark::Cleared(id))]);
        }
        for step in self.model.steps.ids() {
            let left = all(vec![self.was(step), not(self.is(step))]);
            when(&mut body, left, vec![Statement::Mark(Mark::Deactivated(step))]);
        }
        for step in self.model.steps.ids() {
            let entered = all(vec![not(self.was(step)), self.is(step)]);
            when(&mut body, entered, vec![Statement::Mark(Mark::Activated(step))]);
        }
        body.push(Statement::Mark(Mark::Evolved));
        body
    }

    /// Whether a search that begins again would find what this one has found: it was stable, no edge is gone, delays have seen the
    /// situation it has led to, and no output that is read has another value now.
    fn settle_search(&self, stable: Option<PlaceId>, kept: &[(PlaceId, PlaceId)]) -> Vec<Statement<'m>> {
        let Some(settled) = self.settled else { return Vec::new() };
        let mut moves = vec![not(stable.map_or_else(yes, Expr::Place)), self.has_edges()];
        // Otherwise the first search has gone on until nothing more happens, as any other. An edge that it does not see (A26) the next one does not see, either.
        let delays = self.model.delays.values().all(|delay| is_of_inputs(&delay.of));
        if !(delays && self.model.actions.is_empty()) {
            moves.insert(0, Expr::Place(self.first));
        }
        if !delays {
            moves.push(compare(Comparison::Differs, Expr::Place(self.evolutions), number(0)));
        }
        moves.push_all(kept.iter().map(|(place, copy)| differ(*place, *copy)));
        moves.push_all(self.opaque_ran.map(Expr::Place));
        vec![Statement::Set(settled, not(any(moves)))]
    }

    /// The outputs that something reads, of a chart that uses time. What the search itself stores, it has seen.
    fn keep_read_outputs(&mut self) -> (Vec<(PlaceId, PlaceId)>, Vec<Statement<'m>>) {
        let (mut kept, mut body) = (Vec::new(), Vec::new());
        if self.settled.is_none() {
            return (kept, body);
        }
        for read in self.model.expressions().concat() {
            let Read::Name(Name::Output(id)) = read else { continue };
            let place = self.outputs[id.index()];
            if self.is_evaluated(id) && !kept.iter().any(|(other, _)| *other == place) {
                let name = format!("was.{}", self.name(place));
                let copy = self.like(name, place);
                kept.push((place, copy));
                body.push(Statement::Set(copy, Expr::Place(place)));
            }
        }
        (kept, body)
    }

    /// Whether an output gets its value on the stable situation.
    fn is_evaluated(&self, output: OutputId) -> bool {
        self.model.associations.iter().any(|(id, association)| {
            let place = match association.effect {
                Effect::Control(place) | Effect::Assign(place, _) => Some(place),
                _ => None,
            };
            place == Some(Place::Output(output)) && self.is_continuous(id)
        })
    }
}
