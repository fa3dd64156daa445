//! Conditions of integers and booleans that never hold together, as far as that is seen in how they are written.

use super::Resolver;
use crate::model::{Binary, Model, Name, PartialId, Read, StepId, Transition, Tree, Ty, Unary};
use crate::sorted::Map;

/// Whether two branches of one step may clear together in a `grafcet` and leave more than one step active.
pub(super) fn may_part(resolver: &Resolver<'_>, partial: PartialId) -> bool {
    let model = &resolver.model;
    let mut leaving: Map<StepId, Vec<&Transition>> = Map::new();
    for id in &model.partials[partial].transitions {
        let transition = &model.transitions[*id];
        if transition.any.is_none() {
            for source in &transition.sources {
                leaving.or_default(*source).push(transition);
            }
        }
    }
    leaving.values().any(|branches| {
        let together = |(number, one): (usize, &&Transition)| {
            // An `else` is none of the others of the same sources.
            let others = branches.iter().skip(number + 1).filter(|other| other.targets != one.targets);
            let mut others = others.filter(|other| {
                let decided = one.otherwise.is_some() || other.otherwise.is_some();
                !(decided && one.sources == other.sources)
            });
            others.any(|other| !exclude(model, &one.condition.tree, &other.condition.tree))
        };
        branches.iter().enumerate().any(together)
    })
}

/// Whether both can never hold: something that one asks for is the contrary of what the other asks for.
fn exclude(model: &Model, a: &Tree, b: &Tree) -> bool {
    let (mut of_a, mut of_b) = (Vec::new(), Vec::new());
    terms(a, &mut of_a);
    terms(b, &mut of_b);
    of_a.iter().any(|a| of_b.iter().any(|b| contrary(model, a, b)))
}

/// What stands between `&&`.
fn terms<'t>(tree: &'t Tree, found: &mut Vec<&'t Tree>) {
    if let Tree::Binary(Binary::And, a, b) = tree {
        terms(a, found);
        terms(b, found);
    } else {
        found.push(tree);
    }
}

fn contrary(model: &Model, a: &Tree, b: &Tree) -> bool {
    if a.may_differ() || b.may_differ() {
        return false;
    }
    let negates = |a: &Tree, b: &Tree| matches!(a, Tree::Unary(Unary::Not, inner) if **inner == *b);
    if negates(a, b) || negates(b, a) {
        return true;
    }
    match (a, b) {
        (Tree::Bool(false), _) | (_, Tree::Bool(false)) => true,
        // `!(x || y)` beside `x`.
        (Tree::Unary(Unary::Not, none), other) | (other, Tree::Unary(Unary::Not, none)) => one_of(none, other),
        _ => bounds(model, a)
            .zip(bounds(model, b))
            .is_some_and(|((name, low, high), (other, least, most))| name == other && (high < least || most < low)),
    }
}

fn one_of(tree: &Tree, wanted: &Tree) -> bool {
    match tree {
        Tree::Binary(Binary::Or, a, b) => one_of(a, wanted) || one_of(b, wanted),
        _ => tree == wanted,
    }
}

/// `level < 3`, of an integer or an enum with listed variants: the least and the greatest value for which it holds.
fn bounds(model: &Model, tree: &Tree) -> Option<(Name, i128, i128)> {
    let Tree::Binary(operator, a, b) = tree else { return None };
    let (name, operator, value) = match (&**a, &**b) {
        (Tree::Read(Read::Name(name)), Tree::Int(value)) => (*name, *operator, *value),
        (Tree::Int(value), Tree::Read(Read::Name(name))) => (*name, operator.mirrored(), *value),
        _ => return None,
    };
    // A type of the user's compares as it likes.
    if !matches!(model.ty(name), Ty::Int { .. }) && model.variants_of(name).is_none() {
        return None;
    }
    let (low, high) = match operator {
        Binary::Eq => (value, value),
        Binary::Lt => (i128::MIN, value.checked_sub(1)?),
        Binary::Le => (i128::MIN, value),
        Binary::Gt => (value.checked_add(1)?, i128::MAX),
        Binary::Ge => (value, i128::MAX),
        _ => return None,
    };
    Some((name, low, high))
}
