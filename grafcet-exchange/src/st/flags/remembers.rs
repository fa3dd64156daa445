//! Edges and delays of what the chart itself changes.
//!
//! In a `grafcet` an edge compares two scans, as a scan is an evolution. A delay is looked at where a cycle of the chart begins: in the scans that begin with
//! what the scan before has left as it was. In an `sfc` transitions compare what there was before the evolutions of two scans, and actions what there
//! was behind them.

use grafcet_compiler::analysis::combinational::in_order;
use grafcet_compiler::model::{Id, Name, Place, Read, StepId, VarId};

use super::Flags;
use crate::Refused;
use crate::st::expr::{Moment, reads_inputs_alone};
use crate::st::memory::{Look, is_of_inputs};
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, strength};

/// The heading of edges and delays beside those of inputs.
pub(super) const OWN_MEMORY: &str = "Edges and delays of what the chart itself changes";

impl Flags<'_> {
    /// Whether there may be a delay that is not looked at in each scan.
    pub(super) fn samples_once(&self) -> bool {
        self.model.is_grafcet() && self.model.delays.ids().any(|id| !is_of_inputs(self.model, id))
    }

    /// What actions ask for behind the evolution, and what is asked for before it.
    pub(super) fn memory(&mut self) -> Result<[Vec<Statement>; 2], Refused> {
        let grafcet = self.model.is_grafcet();
        let steps = self.steps.clone();
        let active = |step: StepId| Some(Text::word(&*steps[step.index()]));
        // In a `grafcet` the first scan activates the initial situation, and the first evolution sees no edge.
        let again = if grafcet { self.scope.names.own("Looked") } else { self.started.clone() };
        self.settled = self.samples_once().then(|| self.scope.names.own("Settled"));
        let settled = self.settled.clone();
        let mut look =
            Look { active: &active, again: &again, settled: settled.as_deref(), moment: Moment::Moved(None) };
        let acting = if grafcet { Vec::new() } else { self.frame.own_memory(&mut self.scope, &look)? };
        look.moment = Moment::Called;
        let own = self.frame.own_memory(&mut self.scope, &look)?;
        let edges = self.scope.edges.keys().any(|id| !reads_inputs_alone(&self.model.edges[*id].of.tree));
        self.looked = Some(again).filter(|_| grafcet && edges);
        Ok([acting, own])
    }

    /// What follows the situation is asked for by edges and delays, or asks for them.
    pub(super) fn around_following(&self, own: Vec<Statement>) -> Result<[Vec<Statement>; 2], Refused> {
        let model = self.model;
        let following = in_order(model);
        let is_own = |read: &Read| match read {
            Read::Rising(id) | Read::Falling(id) => !reads_inputs_alone(&model.edges[*id].of.tree),
            Read::Delay(id) => !is_of_inputs(model, *id),
            _ => false,
        };
        let follows = |read: &Read| matches!(read, Read::Name(Name::Var(var)) if following.contains(var));
        let asks = |var: &VarId| {
            let controls = super::control::controls(model, Place::Var(*var));
            controls.iter().any(|one| one.condition.iter().flat_map(|condition| &condition.reads).any(is_own))
        };
        let Some(var) = following.iter().find(|var| asks(var)) else { return Ok([Vec::new(), own]) };
        let edges = self.scope.edges.keys().map(|id| &model.edges[*id].of);
        let delays = self.scope.delays.keys().map(|id| &model.delays[*id].of);
        if edges.chain(delays).any(|of| of.reads.iter().any(follows)) {
            let name = model.place_name(Place::Var(*var));
            let message = format!(
                "`{name}` follows edges or delays of what the chart itself changes, and others are of what follows the situation: structured text of this form cannot order them; ask for the steps themselves"
            );
            return Err(Refused::at(name.into(), message));
        }
        Ok([own, Vec::new()])
    }

    /// The end of a scan: there has been one, and what it has left as it was.
    pub(super) fn ended(&mut self) -> Vec<Statement> {
        let mut ended = Vec::new();
        if let Some(settled) = self.settled.clone() {
            let note = "the scan before has left everything as it was";
            self.frame.remember(Variable::new(&*settled, "BOOL").init("TRUE").note(note));
            let mut same: Vec<Text> = Vec::new();
            for id in self.model.steps.ids() {
                let was = self.was(id).text;
                same.push(equal(&self.flag(id).text, &was));
            }
            let following: Vec<Place> = in_order(self.model).into_iter().map(Place::Var).collect();
            let stored = self.before.iter().filter(|(place, _)| !following.contains(place));
            same.extend(stored.map(|(place, before)| equal(self.scope.place(*place), before)));
            ended.push(Statement::assign(settled, all(same).text));
        }
        if let Some(looked) = self.looked.clone() {
            self.frame.remember(Variable::new(&*looked, "BOOL").init("FALSE").note("edges have been looked at before"));
            ended.push(Statement::assign(looked, &*self.started));
        }
        ended.push(Statement::assign(&*self.started, "TRUE"));
        ended
    }
}

fn equal(a: &str, b: &str) -> Text {
    Text { text: format!("{a} = {b}"), strength: strength::EQUAL }
}
