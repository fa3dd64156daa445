//! Boolean variables of a `grafcet` that continuous actions assert: they hold no value of their own (A22).

use crate::list::{List, PushAll};
use crate::model::{Association, Binary, Effect, Model, Name, Place, Read, Tree, Unary, VarId};
use crate::sorted::Set;

/// The combinational variables, each after those it reads; those on a circle, which is refused, come last.
#[must_use]
pub fn in_order(model: &Model) -> Vec<VarId> {
    if !model.is_grafcet() {
        return Vec::new();
    }
    let mut waiting: Vec<VarId> = model.vars.ids().filter(|var| asserted(model, *var).next().is_some()).list();
    let mut order = Vec::new();
    loop {
        let ready = |var: &VarId| reads(model, *var).iter().all(|other| !waiting.contains(other));
        let Some(next) = waiting.iter().position(ready) else { break };
        order.push(waiting.remove(next));
    }
    order.push_all(waiting);
    order
}

/// The continuous actions that assert a variable.
pub fn asserted(model: &Model, var: VarId) -> impl Iterator<Item = &Association> {
    model.associations.values().filter(move |association| {
        association.qualifier.is_continuous()
            && matches!(association.effect, Effect::Control(Place::Var(place)) if place == var)
    })
}

/// The variables that the conditions of a combinational variable read, through edges and delays too.
#[must_use]
pub fn reads(model: &Model, var: VarId) -> Set<VarId> {
    let mut found = Set::new();
    for condition in asserted(model, var).filter_map(|association| association.condition.as_ref()) {
        for read in &condition.reads {
            if let Read::Name(Name::Var(other)) = read {
                found.insert(*other);
            }
        }
    }
    found
}

/// More than this is not written out.
const PARTS: usize = 2000;

/// How deep definitions may lie in each other; a circle of them is refused elsewhere.
const DEPTH: usize = 8;

/// The tree with such variables replaced by what they are in the same evolution: one of their steps is active, and its
/// condition holds. None where that gets too long.
#[must_use]
pub fn written_out(model: &Model, tree: &Tree) -> Option<Tree> {
    let mut left = PARTS;
    written(model, tree, DEPTH, &mut left)
}

fn written(model: &Model, tree: &Tree, depth: usize, left: &mut usize) -> Option<Tree> {
    *left = left.checked_sub(1)?;
    Some(match tree {
        Tree::Read(Read::Name(Name::Var(var))) if is_combinational(model, *var) => {
            let depth = depth.checked_sub(1)?;
            let initially = model.vars[*var].init.as_ref().map(|init| &init.tree);
            let mut any = initially.cloned().unwrap_or(Tree::Bool(false));
            for association in asserted(model, *var) {
                let mut asserts = Tree::Read(Read::Active(association.step));
                if let Some(time) = association.time {
                    let elapsed = Tree::Elapsed(time, association.step);
                    let limit = association.qualifier.limits();
                    asserts = both(asserts, if limit { Tree::Unary(Unary::Not, Box::new(elapsed)) } else { elapsed });
                }
                if let Some(condition) = &association.condition {
                    asserts = both(asserts, written(model, &condition.tree, depth, left)?);
                }
                *left = left.checked_sub(1)?;
                any = if any == Tree::Bool(false) {
                    asserts
                } else {
                    Tree::Binary(Binary::Or, Box::new(any), Box::new(asserts))
                };
            }
            any
        }
        Tree::Unary(operator, inner) => Tree::Unary(*operator, Box::new(written(model, inner, depth, left)?)),
        Tree::Binary(operator, a, b) => {
            let (a, b) = (written(model, a, depth, left)?, written(model, b, depth, left)?);
            Tree::Binary(*operator, Box::new(a), Box::new(b))
        }
        other => other.clone(),
    })
}

/// Whether continuous actions alone act on the variable.
fn is_combinational(model: &Model, var: VarId) -> bool {
    let acts = model.associations.values().filter(|association| association.effect.writes().contains(&Place::Var(var)));
    let count = asserted(model, var).count();
    count > 0 && acts.count() == count
}

fn both(a: Tree, b: Tree) -> Tree {
    Tree::Binary(Binary::And, Box::new(a), Box::new(b))
}
