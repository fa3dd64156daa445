//! Edges and delays of what the chart itself changes.
//!
//! In a `grafcet` an edge compares two scans, as a scan is an evolution. A delay is looked at where a cycle of the chart begins: in the scans that begin with
//! what the scan before has left as it was. In an `sfc` transitions compare what there was before the evolutions of two scans, and actions what there
//! was after them.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::analysis::combinational::in_order;
use grafcet_compiler::model::{Expr, Id, Name, Place, Read, StepId};

use super::Flags;
use crate::Refused;
use crate::st::expr::{Moment, reads_inputs_alone};
use crate::st::memory::{Look, in_a_row, is_of_inputs};
use crate::st::syntax::{Statement, Variable};
use crate::st::text::{Text, all, strength};

/// Something that is looked at, and how.
pub(super) type Asked = (Read, Vec<Statement>);

impl Flags<'_> {
    /// Whether there may be a delay that is not looked at in each scan.
    pub(super) fn samples_once(&self) -> bool {
        self.model.is_grafcet() && self.model.delays.ids().any(|id| !is_of_inputs(self.model, id))
    }

    /// What actions ask for after the evolution, and what is asked for before it.
    pub(super) fn memory(&mut self) -> Result<(Vec<Statement>, Vec<Asked>), Refused> {
        let grafcet = self.model.is_grafcet();
        let steps = self.steps.clone();
        let active = |step: StepId| Some(Text::word(&*steps[step.index()]));
        // In a `grafcet` the first scan activates the initial situation, and the first evolution sees no edge.
        let again = if grafcet { self.scope.names.own("Looked") } else { self.started.clone() };
        self.settled = self.samples_once().then(|| self.scope.names.own("Settled"));
        let settled = self.settled.clone();
        let mut look =
            Look { active: &active, again: &again, settled: settled.as_deref(), moment: Moment::Moved(None) };
        let acting = if grafcet { Vec::new() } else { in_a_row(self.frame.own_memory(&mut self.scope, &look)?) };
        look.moment = Moment::Called;
        let own = self.frame.own_memory(&mut self.scope, &look)?;
        let edges = self.scope.edges.keys().any(|id| !reads_inputs_alone(&self.model.edges[*id].of.tree));
        self.looked = Some(again).filter(|_| grafcet && edges);
        Ok((acting, own))
    }

    /// What follows the situation, and edges and delays: each after what it asks for, and under headings where they can be told apart.
    pub(super) fn looked_at(&self, following: Vec<Asked>, own: Vec<Asked>) -> Vec<(&'static str, Vec<Statement>)> {
        let asks = |some: &[Asked], others: &[Asked]| {
            let known: Vec<Read> = others.iter().map(|(read, _)| *read).collect();
            some.iter().any(|(read, _)| self.asks(*read).iter().any(|asked| known.contains(asked)))
        };
        let (memory, follows) = ("Edges and delays of what the chart itself changes", "What follows the situation");
        match (asks(&following, &own), asks(&own, &following)) {
            (false, _) => vec![(follows, in_a_row(following)), (memory, in_a_row(own))],
            (true, false) => vec![(memory, in_a_row(own)), (follows, in_a_row(following))],
            (true, true) => {
                let all: BTreeMap<Read, Vec<Statement>> = following.into_iter().chain(own).collect();
                let (mut seen, mut order) = (BTreeSet::new(), Vec::new());
                for read in all.keys() {
                    self.after_asked(*read, &mut seen, &mut order);
                }
                let sorted = order.iter().filter_map(|read| all.get(read)).flatten().cloned().collect();
                vec![("What follows the situation, and edges and delays that belong to it", sorted)]
            }
        }
    }

    /// First what it asks for.
    fn after_asked(&self, read: Read, seen: &mut BTreeSet<Read>, order: &mut Vec<Read>) {
        if seen.insert(read) {
            for asked in self.asks(read) {
                self.after_asked(asked, seen, order);
            }
            order.push(read);
        }
    }

    /// What is asked for by what is looked at; an edge is called a rising one.
    fn asks(&self, read: Read) -> Vec<Read> {
        let model = self.model;
        let expressions: Vec<&Expr> = match read {
            Read::Rising(id) => vec![&model.edges[id].of],
            Read::Delay(id) => vec![&model.delays[id].of],
            Read::Name(Name::Var(var)) => {
                let controls = super::control::controls(model, Place::Var(var));
                controls.into_iter().filter_map(|one| one.condition.as_ref()).collect()
            }
            _ => Vec::new(),
        };
        let asked = expressions.into_iter().flat_map(|of| &of.reads);
        asked.map(|read| if let Read::Falling(id) = read { Read::Rising(*id) } else { *read }).collect()
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
