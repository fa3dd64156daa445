//! What outputs are at the end of a cycle, as conditions over steps and inputs, where that follows from them alone.

use crate::list::List;
use crate::model::{Association, Binary, Effect, Expr, Model, Name, OutputId, Place, Qualifier, Read, Tree, Ty};

/// The tree with such outputs replaced. The result holds at the end of a cycle where the tree does.
#[must_use]
pub fn resolved(model: &Model, tree: &Tree) -> Tree {
    match tree {
        Tree::Read(Read::Name(Name::Output(id))) => value(model, *id).unwrap_or_else(|| tree.clone()),
        Tree::Unary(operator, inner) => Tree::Unary(*operator, Box::new(resolved(model, inner))),
        Tree::Binary(operator, a, b) => {
            Tree::Binary(*operator, Box::new(resolved(model, a)), Box::new(resolved(model, b)))
        }
        other => other.clone(),
    }
}

/// The value of a boolean output that is true while one of some steps is active and its condition holds, and false
/// otherwise (A10, A35).
fn value(model: &Model, id: OutputId) -> Option<Tree> {
    let output = &model.outputs[id];
    if !matches!(output.ty, Ty::Bool(_)) || output.init.as_ref().is_some_and(|init| init.tree != Tree::Bool(false)) {
        return None;
    }
    let mut asserting = Vec::new();
    for association in model.associations.values() {
        match &association.effect {
            Effect::Control(Place::Output(of)) if *of == id => asserting.push(asserts(model, association)?),
            Effect::Assign(Place::Output(of), _) if *of == id => return None,
            Effect::Block(code) if code.writes.contains(&Place::Output(id)) => return None,
            _ => {}
        }
    }
    let clearing = model.transitions.values().flat(|transition| &transition.clearing);
    let writes = |effect: &Effect| match effect {
        Effect::Control(place) | Effect::Assign(place, _) => *place == Place::Output(id),
        Effect::Block(code) => code.writes.contains(&Place::Output(id)),
        Effect::Call(..) => false,
    };
    (!clearing.into_iter().any(writes)).then(|| any(asserting))
}

/// When a continuous action asserts its output.
fn asserts(model: &Model, association: &Association) -> Option<Tree> {
    // The conditions of an `sfc` may see what the cycle has not returned yet.
    let seen = |expr: &Expr| {
        let plain = |read: &Read| {
            matches!(
                read,
                Read::Name(Name::Input(_) | Name::Param(_)) | Read::Active(_) | Read::MacroActive(_) | Read::Ticks(_)
            )
        };
        expr.reads.iter().all(plain)
    };
    if association.qualifier != Qualifier::N || !association.condition.as_ref().is_none_or(seen) {
        return None;
    }
    let active = Tree::Read(Read::Active(association.step));
    Some(match &association.condition {
        Some(condition) => Tree::Binary(Binary::And, Box::new(active), Box::new(resolved(model, &condition.tree))),
        None => active,
    })
}

/// One of these holds. Halves, so that a long list makes no deep tree.
fn any(mut all: Vec<Tree>) -> Tree {
    if all.len() < 2 {
        return all.pop().unwrap_or(Tree::Bool(false));
    }
    let rest = all.split_off(all.len() / 2);
    Tree::Binary(Binary::Or, Box::new(any(all)), Box::new(any(rest)))
}
