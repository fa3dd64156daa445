//! Edges that can but let a transition clear.

use crate::list::List;
use crate::model::{Association, Binary, Effect, Model, Read, Tree, Unary};

/// Whether all that reads an edge is a condition of a transition that an edge can make true and not false. A search that is
/// stable while there are edges is stable without them.
#[must_use]
pub fn edges_only_help(model: &Model) -> bool {
    let is_edge = |read: &Read| matches!(read, Read::Rising(_) | Read::Falling(_));
    let acting = model.associations.values().flat(Association::reads).flatten();
    let clearing = model.transitions.values().flat(|transition| &transition.clearing).flat(Effect::reads).flatten();
    let sampled = model.edges.values().map(|edge| &edge.of).and(model.delays.values().map(|delay| &delay.of));
    !acting.and(clearing).and(sampled.flat(|of| &of.reads)).any(is_edge)
        && model.transitions.values().all(|transition| helps(&transition.condition.tree, true))
}

/// Whether the edges of a tree are only asked for (`wanted`), or only for not being there.
fn helps(tree: &Tree, wanted: bool) -> bool {
    match tree {
        Tree::Read(Read::Rising(_) | Read::Falling(_)) => wanted,
        Tree::Unary(Unary::Not, inner) => helps(inner, !wanted),
        Tree::Binary(Binary::And | Binary::Or, a, b) => helps(a, wanted) && helps(b, wanted),
        Tree::Unary(_, inner) => is_free(inner),
        Tree::Binary(_, a, b) => is_free(a) && is_free(b),
        Tree::Opaque { reads, .. } => !reads.iter().any(|read| matches!(read, Read::Rising(_) | Read::Falling(_))),
        Tree::Bool(_) | Tree::Int(_) | Tree::Read(_) | Tree::Elapsed(..) | Tree::MacroElapsed(..) => true,
    }
}

/// Whether a tree reads no edge.
fn is_free(tree: &Tree) -> bool {
    helps(tree, true) && helps(tree, false)
}
