//! What both forms have in common: what is declared, initial values, edges, delays and timers.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Expr, Model, Name, Place, TimeRef, Variants};

use super::expr::{At, Kind, Scope, kind_of};
use super::syntax::{Program, Statement, Variable};
use super::text::{Text, all, not};
use super::time::LONGEST;
use super::{real, variants};
use crate::Refused;

/// What a program remembers beside its names.
#[derive(Default)]
pub(crate) struct Frame {
    pub(crate) variables: Vec<Variable>,
    /// What happens at `Init`.
    pub(crate) init: Vec<Statement>,
}

impl Frame {
    /// A variable with its value at the beginning and after `Init`.
    pub(crate) fn remember(&mut self, variable: Variable) {
        if let Some(init) = &variable.init {
            self.init.push(Statement::assign(&*variable.name, &**init));
        }
        self.variables.push(variable);
    }

    /// A timer that begins anew at `Init`.
    pub(crate) fn timer(&mut self, name: &str, note: &str) {
        self.variables.push(Variable::new(name, "TON").note(note));
        self.init.push(Statement::Call(format!("{name}(IN := FALSE, PT := {LONGEST})")));
    }

    /// Edges, with whether there has been a scan before.
    pub(crate) fn edges(&mut self, scope: &mut Scope<'_>, started: &str) -> Result<Vec<Statement>, Refused> {
        let mut statements = Vec::new();
        for (id, [rises, falls, was]) in scope.edges.clone() {
            let of = &scope.model.edges[id].of;
            let value = input(scope, of)?;
            for (name, note) in [(&rises, "rises"), (&falls, "falls")] {
                self.variables.push(Variable::new(name, "BOOL").note(format!("{} {note}", of.text)));
            }
            self.variables.push(Variable::new(&was, "BOOL").note("in the scan before"));
            let rise = all(vec![Text::word(started), input(scope, of)?, not(Text::word(&was))]);
            let fall = all(vec![Text::word(started), not(input(scope, of)?), Text::word(&was)]);
            statements.push(Statement::assign(rises, rise.text));
            statements.push(Statement::assign(falls, fall.text));
            statements.push(Statement::assign(was, value.text));
        }
        Ok(statements)
    }

    /// Delays of inputs.
    pub(crate) fn delays(&mut self, scope: &mut Scope<'_>) -> Result<Vec<Statement>, Refused> {
        let mut statements = Vec::new();
        for (id, name) in scope.delays.clone() {
            let delay = &scope.model.delays[id];
            let value = input(scope, &delay.of)?;
            self.remember(Variable::new(&name, "BOOL").init("FALSE").note(format!("{}, delayed", delay.of.text)));
            let on = scope.names.own(&format!("{name}_on"));
            self.timer(&on, "since it is true");
            statements.push(Statement::Call(format!("{on}(IN := {}, PT := {LONGEST})", value.text)));
            let limit = scope.time(delay.on, delay.of.mark)?;
            let reached = all(vec![value, Text::order(format!("{on}.ET >= {limit}"))]);
            if delay.off == TimeRef::Ticks(0) {
                statements.push(Statement::assign(name, reached.text));
                continue;
            }
            let off = scope.names.own(&format!("{name}_off"));
            self.timer(&off, "since it is false");
            let no = not(input(scope, &delay.of)?);
            statements.push(Statement::Call(format!("{off}(IN := {}, PT := {LONGEST})", no.text)));
            let limit = scope.time(delay.off, delay.of.mark)?;
            let over = all(vec![no, Text::order(format!("{off}.ET >= {limit}"))]);
            let branches = vec![
                (reached.text, vec![Statement::assign(&*name, "TRUE")]),
                (over.text, vec![Statement::assign(&*name, "FALSE")]),
            ];
            statements.push(Statement::If(branches, Vec::new()));
        }
        Ok(statements)
    }
}

/// An expression over inputs alone.
fn input(scope: &mut Scope<'_>, of: &Expr) -> Result<Text, Refused> {
    let at = At { active: &|_| None, before: &BTreeMap::new(), times: false, mark: of.mark };
    scope.expr(of, &Kind::Bool, &at)
}

/// The value at the beginning.
pub(crate) fn initial(scope: &mut Scope<'_>, name: Name) -> Result<String, Refused> {
    let model = scope.model;
    let init = match name {
        Name::Output(id) => model.outputs[id].init.as_ref(),
        Name::Var(id) => model.vars[id].init.as_ref(),
        Name::Param(id) => model.params[id].init.as_ref(),
        Name::Input(_) => None,
    };
    let wanted = kind_of(model, name).unwrap_or(Kind::Number);
    if let Some(listed) = model.variants_of(name) {
        return variant(listed, init, model.value_name(name));
    }
    match init {
        Some(init) if real::is_rust(&init.tree) => {
            let message = format!(
                "`{}` is a constant of the program, whose value the chart does not tell: write the value",
                init.text
            );
            Err(Refused::at(init.mark, message))
        }
        Some(init) => {
            let at = At { active: &|_| None, before: &BTreeMap::new(), times: false, mark: init.mark };
            Ok(scope.expr(init, &wanted, &at)?.text)
        }
        None => Ok(match wanted {
            Kind::Bool => "FALSE".to_owned(),
            Kind::Time => "T#0s".to_owned(),
            Kind::Real(_) => "0.0".to_owned(),
            Kind::Int(_) | Kind::Number => "0".to_owned(),
        }),
    }
}

/// Inputs, parameters, outputs and variables of the chart; what is written returns to its initial value at `Init`.
pub(crate) fn declare(
    scope: &mut Scope<'_>,
    program: &mut Program,
    frame: &mut Frame,
    written: impl Fn(Place) -> bool,
) -> Result<(), Refused> {
    let model: &Model = scope.model;
    let variable = |scope: &Scope<'_>, name: Name| {
        let ty = kind_of(model, name).map_or("DINT", |kind| kind.name());
        Variable::new(scope.name(name), ty).note(variants::listed(model, name))
    };
    for id in model.inputs.ids() {
        program.inputs.push(variable(scope, Name::Input(id)));
    }
    for id in model.params.ids() {
        let init = initial(scope, Name::Param(id))?;
        program.inputs.push(variable(scope, Name::Param(id)).init(init).note(parameter(model, Name::Param(id))));
    }
    let outputs = model.outputs.ids().map(Place::Output);
    for place in outputs.chain(model.vars.ids().map(Place::Var)) {
        let init = initial(scope, place.into())?;
        if written(place) {
            frame.init.push(Statement::assign(scope.place(place), &*init));
        }
        let declared = variable(scope, place.into()).init(init);
        match place {
            Place::Output(_) => program.outputs.push(declared),
            Place::Var(_) => program.variables.push(declared),
        }
    }
    Ok(())
}

/// What stands beside a parameter.
fn parameter(model: &Model, name: Name) -> String {
    match variants::listed(model, name) {
        listed if listed.is_empty() => "parameter".to_owned(),
        listed => format!("parameter: {listed}"),
    }
}

/// The number of a variant; what is not told is what Rust takes, and not always the first one.
fn variant(listed: &Variants, init: Option<&Expr>, name: &proc_macro2::Ident) -> Result<String, Refused> {
    let Some(init) = init else {
        return Err(Refused::at(
            name.into(),
            format!("what `{name}` is at the beginning the chart does not tell: write a variant, as `= Mode::Off`"),
        ));
    };
    match variants::listed_value(listed, &init.tree) {
        Some(place) => Ok(place.to_string()),
        None => Err(Refused::at(init.mark, format!("`{}` is no variant that `{name}` lists", init.text))),
    }
}
