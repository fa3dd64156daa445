//! What a program remembers of conditions: edges and delays.

use std::collections::{BTreeMap, BTreeSet};

use grafcet_compiler::model::{DelayId, EdgeId, Expr, Id, Model, Name, Read, StepId, TimeRef, Tree};

use super::expr::{At, Kind, Moment, Remembers, Scope, plain, reads_inputs_alone, refuse};
use super::frame::Frame;
use super::real;
use super::syntax::{Statement, Variable};
use super::text::{Text, all, not, strength};
use super::time::LONGEST;
use crate::Refused;

/// A moment of the scan at which conditions are looked at.
pub(crate) struct Look<'a> {
    /// Whether a step is active then.
    pub(crate) active: &'a dyn Fn(StepId) -> Option<Text>,
    /// That there has been such a look before.
    pub(crate) again: &'a str,
    /// Where delays are looked at only if it is true.
    pub(crate) settled: Option<&'a str>,
    /// Before the evolution, or after it.
    pub(crate) moment: Moment,
}

/// Whether a delay is one of inputs and parameters, which no action writes.
pub(crate) fn is_of_inputs(model: &Model, id: DelayId) -> bool {
    let delay = &model.delays[id];
    let varies = [delay.on, delay.off].iter().any(|time| matches!(time, TimeRef::Var(_)));
    reads_inputs_alone(&delay.of.tree) && !varies
}

impl Frame {
    /// Edges of inputs, with whether there has been a scan before.
    pub(crate) fn edges(&mut self, scope: &mut Scope<'_>, started: &str) -> Result<Vec<Statement>, Refused> {
        let mut statements = Vec::new();
        for (id, names) in scope.edges.clone() {
            let of = &scope.model.edges[id].of;
            if reads_inputs_alone(&of.tree) {
                let value = input(scope, of)?;
                statements.extend(self.edge(of, &names, value, started));
            }
        }
        Ok(statements)
    }

    fn edge(&mut self, of: &Expr, [rises, falls, was]: &[String; 3], value: Text, again: &str) -> [Statement; 3] {
        for (name, note) in [(rises, "rises"), (falls, "falls")] {
            self.variables.push(Variable::new(name, "BOOL").note(format!("{} {note}", of.text)));
        }
        self.variables.push(Variable::new(was, "BOOL").note("in the scan before"));
        let rise = all(vec![Text::word(again), value.clone(), not(Text::word(was))]);
        let fall = all(vec![Text::word(again), not(value.clone()), Text::word(was)]);
        [Statement::assign(rises, rise.text), Statement::assign(falls, fall.text), Statement::assign(was, value.text)]
    }

    /// Delays of inputs.
    pub(crate) fn delays(&mut self, scope: &mut Scope<'_>) -> Result<Vec<Statement>, Refused> {
        let mut statements = Vec::new();
        for (id, name) in scope.delays.clone() {
            if is_of_inputs(scope.model, id) {
                let value = input(scope, &scope.model.delays[id].of)?;
                statements.extend(self.delay(scope, id, &name, &value)?);
            }
        }
        Ok(statements)
    }

    fn delay(
        &mut self,
        scope: &mut Scope<'_>,
        id: DelayId,
        name: &str,
        value: &Text,
    ) -> Result<Vec<Statement>, Refused> {
        let delay = &scope.model.delays[id];
        let mut statements = Vec::new();
        self.remember(Variable::new(name, "BOOL").init("FALSE").note(format!("{}, delayed", delay.of.text)));
        let on = scope.names.own(&format!("{name}_on"));
        self.timer(&on, "since it is true");
        statements.push(Statement::Call(format!("{on}(IN := {}, PT := {LONGEST})", value.text)));
        let limit = scope.time(delay.on, delay.of.mark)?;
        let reached = all(vec![value.clone(), Text::order(format!("{on}.ET >= {limit}"))]);
        if delay.off == TimeRef::Ticks(0) {
            statements.push(Statement::assign(name, reached.text));
            return Ok(statements);
        }
        let off = scope.names.own(&format!("{name}_off"));
        self.timer(&off, "since it is false");
        let no = not(value.clone());
        statements.push(Statement::Call(format!("{off}(IN := {}, PT := {LONGEST})", no.text)));
        let limit = scope.time(delay.off, delay.of.mark)?;
        let over = all(vec![no, Text::order(format!("{off}.ET >= {limit}"))]);
        let branches = vec![
            (reached.text, vec![Statement::assign(name, "TRUE")]),
            (over.text, vec![Statement::assign(name, "FALSE")]),
        ];
        statements.push(Statement::If(branches, Vec::new()));
        Ok(statements)
    }

    /// Edges (as rising ones) and delays of what the chart itself changes, each after those that it asks for.
    pub(crate) fn own_memory(
        &mut self,
        scope: &mut Scope<'_>,
        look: &Look<'_>,
    ) -> Result<Vec<(Read, Vec<Statement>)>, Refused> {
        let mut own =
            Own { frame: self, scope, look, edges: BTreeSet::new(), delays: BTreeSet::new(), done: Vec::new() };
        // What is looked at may ask for others.
        loop {
            let before = own.edges.len() + own.delays.len();
            for id in own.known().keys().copied().collect::<Vec<_>>() {
                own.edge(id)?;
            }
            if !own.acts() {
                for id in own.scope.delays.keys().copied().collect::<Vec<_>>() {
                    own.delay(id)?;
                }
            }
            if own.edges.len() + own.delays.len() == before {
                return Ok(own.done);
            }
        }
    }
}

impl Scope<'_> {
    /// Rising or falling.
    pub(super) fn edge_of(&mut self, id: EdgeId, which: usize, at: &At<'_>) -> Result<Text, Refused> {
        let names = self.edge(id, at)?;
        if self.steps.is_none() {
            return Ok(Text::word(names[which].clone()));
        }
        let model = self.model;
        let now = self.tree(&model.edges[id].of.tree, &Kind::Bool, at)?;
        let was = Text::word(names[2].clone());
        Ok(all(if which == 0 { vec![now, not(was)] } else { vec![not(now), was] }))
    }

    pub(super) fn edge(&mut self, id: EdgeId, at: &At<'_>) -> Result<[String; 3], Refused> {
        let model = self.model;
        let of = &model.edges[id].of;
        let own = !reads_inputs_alone(&of.tree);
        if own && !self.can_remember(&of.tree) {
            let why = "an edge of what the chart itself changes";
            return Err(self.not_remembered(why, at));
        }
        let acts = own && !model.is_grafcet() && matches!(self.moment, Moment::Moved(_) | Moment::Leaving);
        let known = if acts { &self.acting } else { &self.edges };
        if let Some(known) = known.get(&id) {
            return Ok(known.clone());
        }
        let base = match &of.tree {
            Tree::Read(Read::Name(name)) => self.name(*name).to_owned(),
            Tree::Read(Read::Active(step)) => plain(&model.steps[*step].name),
            _ => format!("edge_{}", id.index() + 1),
        };
        let names = ["rises", "falls", "was"].map(|what| self.names.own(&format!("{base}_{what}")));
        let known = if acts { &mut self.acting } else { &mut self.edges };
        known.insert(id, names.clone());
        Ok(names)
    }

    pub(super) fn delay(&mut self, id: DelayId, at: &At<'_>) -> Result<Text, Refused> {
        let of = &self.model.delays[id].of;
        if !reads_inputs_alone(&of.tree) && !self.can_remember(&of.tree) {
            return Err(self.not_remembered("the delay of what the chart itself changes", at));
        }
        if self.steps.is_some() {
            return Err(refuse(at, "a delay", "in SFC of IEC 61131-3 let a step wait for its time"));
        }
        if !self.delays.contains_key(&id) {
            let name = self.names.own(&format!("delay_{}", id.index() + 1));
            self.delays.insert(id, name);
        }
        Ok(Text::word(self.delays[&id].clone()))
    }

    fn not_remembered(&self, what: &str, at: &At<'_>) -> Refused {
        if self.steps.is_some() {
            return refuse(at, what, "only edges of inputs are: ask for the step or the value itself");
        }
        let message = format!(
            "{what} has no translation into the CASE form of structured text, but in transitions where it is one of inputs and steps: use the form of flip-flops"
        );
        Refused::at(at.mark, message)
    }

    /// Whether what an edge or a delay is of is seen at its moment.
    fn can_remember(&self, tree: &Tree) -> bool {
        match self.remembers {
            Remembers::Inputs => false,
            Remembers::Steps => {
                let mut alone = !real::is_rust(tree);
                tree.each_read(&mut |read| {
                    alone &= match read {
                        Read::Name(Name::Input(_) | Name::Param(_))
                        | Read::Ticks(_)
                        | Read::Active(_)
                        | Read::MacroActive(_) => true,
                        Read::Rising(id) | Read::Falling(id) => self.can_remember(&self.model.edges[id].of.tree),
                        Read::Delay(id) => self.can_remember(&self.model.delays[id].of.tree),
                        _ => false,
                    }
                });
                alone
            }
            Remembers::All => true,
        }
    }
}

/// The statements alone.
pub(crate) fn in_a_row(memory: Vec<(Read, Vec<Statement>)>) -> Vec<Statement> {
    memory.into_iter().flat_map(|(_, statements)| statements).collect()
}

struct Own<'a, 'm> {
    frame: &'a mut Frame,
    scope: &'a mut Scope<'m>,
    look: &'a Look<'a>,
    edges: BTreeSet<EdgeId>,
    delays: BTreeSet<DelayId>,
    /// Each with what is asked for it.
    done: Vec<(Read, Vec<Statement>)>,
}

impl Own<'_, '_> {
    /// In an `sfc` actions have edges of their own; delays are looked at before the evolution.
    fn acts(&self) -> bool {
        !self.scope.model.is_grafcet() && matches!(self.look.moment, Moment::Moved(_))
    }

    fn known(&self) -> &BTreeMap<EdgeId, [String; 3]> {
        if self.acts() { &self.scope.acting } else { &self.scope.edges }
    }

    fn edge(&mut self, id: EdgeId) -> Result<(), Refused> {
        let model = self.scope.model;
        let of = &model.edges[id].of;
        if reads_inputs_alone(&of.tree) || !self.edges.insert(id) {
            return Ok(());
        }
        let (mut value, mut done) = (self.value(of)?, Vec::new());
        let names = self.known()[&id].clone();
        if value.strength != strength::WORD {
            let now = self.scope.names.own(&names[0].replacen("_rises", "_now", 1));
            self.frame.variables.push(Variable::new(&*now, "BOOL").note(&*of.text));
            done.push(Statement::assign(&*now, value.text));
            value = Text::word(now);
        }
        done.extend(self.frame.edge(of, &names, value, self.look.again));
        self.done.push((Read::Rising(id), done));
        Ok(())
    }

    fn delay(&mut self, id: DelayId) -> Result<(), Refused> {
        let model = self.scope.model;
        if is_of_inputs(model, id) || !self.delays.insert(id) {
            return Ok(());
        }
        let value = self.value(&model.delays[id].of)?;
        let name = self.scope.delays[&id].clone();
        let statements = self.frame.delay(self.scope, id, &name, &value)?;
        let statements = match self.look.settled {
            Some(settled) => vec![Statement::when(settled, statements)],
            None => statements,
        };
        self.done.push((Read::Delay(id), statements));
        Ok(())
    }

    /// What a condition is at this moment, after what it asks for.
    fn value(&mut self, of: &Expr) -> Result<Text, Refused> {
        let at = At { active: self.look.active, before: &BTreeMap::new(), times: true, mark: of.mark };
        self.scope.moment = self.look.moment;
        let value = self.scope.expr(of, &Kind::Bool, &at);
        self.scope.moment = Moment::Called;
        for read in &of.reads {
            match read {
                Read::Rising(edge) | Read::Falling(edge) => self.edge(*edge)?,
                Read::Delay(delay) if !self.acts() => self.delay(*delay)?,
                _ => {}
            }
        }
        value
    }
}

/// An expression over inputs alone.
fn input(scope: &mut Scope<'_>, of: &Expr) -> Result<Text, Refused> {
    let at = At { active: &|_| None, before: &BTreeMap::new(), times: false, mark: of.mark };
    scope.expr(of, &Kind::Bool, &at)
}
