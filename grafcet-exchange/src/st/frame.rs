//! What both forms have in common: what is declared, initial values, and timers.

use std::collections::BTreeMap;

use grafcet_compiler::model::{Expr, Model, Name, Place, Variants};

use super::expr::{At, Kind, Scope, kind_of};
use super::syntax::{Program, Statement, Variable};
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
