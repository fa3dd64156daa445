//! What the interpreter needs to be true of a model before it starts.

use std::collections::BTreeSet;

use super::continuous::{associations_of, is_continuous};
use super::value::Error;
use grafcet_compiler::model::{Association, Effect, Expr, Model, Name, Place, Qualifier, Read, VarId};

/// Every qualifier has a target that it can have in the dialect (A32, A33).
pub(super) fn targets(model: &Model) -> Result<(), Error> {
    let possible = if model.is_grafcet() { possible_in_grafcet } else { possible_in_sfc };
    match model.associations.values().find(|a| !possible(a)) {
        Some(association) => {
            let step = &model.steps[association.step].name;
            Err(Error::WrongTarget(format!("{:?} in step {step}", association.qualifier)))
        }
        None => Ok(()),
    }
}

fn possible_in_sfc(association: &Association) -> bool {
    use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
    match association.qualifier {
        On => false,
        P1 | P0 => !matches!(association.effect, Effect::Control(_)),
        N | S | R | L | D | P | Sd | Ds | Sl => true,
    }
}

fn possible_in_grafcet(association: &Association) -> bool {
    match (association.qualifier, &association.effect) {
        (Qualifier::S | Qualifier::R, effect) => matches!(effect, Effect::Control(_)),
        (Qualifier::P1 | Qualifier::P0 | Qualifier::On, effect) => !matches!(effect, Effect::Control(_)),
        (_, Effect::Control(_) | Effect::Assign(Place::Output(_), _) | Effect::Call(..)) => is_continuous(association),
        _ => false,
    }
}

/// A22: no combinational variable is defined by itself.
pub(super) fn combinational_circles(model: &Model) -> Result<(), Error> {
    model.vars.ids().try_for_each(|var| defined(var, model, &mut BTreeSet::new()))
}

/// `path` holds the variables whose definition is being looked at.
fn defined(var: VarId, model: &Model, path: &mut BTreeSet<VarId>) -> Result<(), Error> {
    if !path.insert(var) {
        return Err(Error::Circle(model.vars[var].name.to_string()));
    }
    for id in associations_of(model, Place::Var(var)) {
        if let Some(condition) = &model.associations[id].condition {
            read(condition, model, path)?;
        }
    }
    path.remove(&var);
    Ok(())
}

fn read(expr: &Expr, model: &Model, path: &mut BTreeSet<VarId>) -> Result<(), Error> {
    for read_here in &expr.reads {
        match read_here {
            Read::Name(Name::Var(var)) => defined(*var, model, path)?,
            Read::Rising(edge) | Read::Falling(edge) => read(&model.edges[*edge].of, model, path)?,
            _ => {}
        }
    }
    Ok(())
}
