//! What changes with an edge that is gone in the next cycle.

use crate::list::List;
use crate::model::{Binary, EdgeId, Effect, Id, Model, Read, StepId, Tree, Unary};
use crate::sorted::Set;

/// What may change because an edge is gone that was there in the last cycle.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub(crate) struct Gone {
    /// Whatever is active.
    pub(crate) always: bool,
    /// Where one of these steps is active, which ask for it in conditions and events of what they do.
    pub(crate) steps: Set<StepId>,
}

/// What an edge changes by its end: among what transitions ask for, and in what steps do.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub(crate) struct EdgeEnd {
    /// Nothing, where it can but make conditions of transitions true and not false: what is stable while there is such an edge is stable without it.
    pub(crate) evolving: Gone,
    /// Also what steps do after their time, as what is stored does.
    pub(crate) acting: Gone,
}

/// By edge. `helps` says whether what edges do, as long as they only let transitions clear, is over when a cycle has ended.
pub(crate) fn edge_ends(model: &Model, helps: bool) -> Vec<EdgeEnd> {
    let mut all = vec![EdgeEnd::default(); model.edges.len()];
    let mut found = Vec::new();
    for transition in model.transitions.values() {
        if helps {
            hinders(&transition.condition.tree, true, &mut found);
        } else {
            found.extend(transition.condition.reads.iter().filter_map(edge_of));
        }
        found.extend(transition.clearing.iter().flat(Effect::reads).flatten().filter_map(edge_of));
    }
    for edge in found.drain(..) {
        all[edge.index()].evolving.always = true;
    }
    for association in model.associations.values() {
        for read in association.condition.iter().and(&association.event).flat(|expr| &expr.reads) {
            if let Some(edge) = edge_of(read) {
                all[edge.index()].acting.steps.insert(association.step);
            }
        }
        // What is stored may be done when its step is not active any more.
        found.extend(association.effect.reads().into_iter().flatten().filter_map(edge_of));
    }
    for edge in found.drain(..) {
        all[edge.index()].acting.always = true;
    }
    let sampled = model.edges.values().map(|edge| &edge.of).and(model.delays.values().map(|delay| &delay.of));
    found.extend(sampled.flat(|of| &of.reads).filter_map(edge_of));
    for edge in found {
        let EdgeEnd { evolving, acting } = &mut all[edge.index()];
        (evolving.always, acting.always) = (true, true);
    }
    all
}

fn edge_of(read: &Read) -> Option<EdgeId> {
    match read {
        Read::Rising(edge) | Read::Falling(edge) => Some(*edge),
        _ => None,
    }
}

/// The edges of a tree that are not only asked for (`wanted`), or only for not being there.
fn hinders(tree: &Tree, wanted: bool, found: &mut Vec<EdgeId>) {
    match tree {
        Tree::Read(_) if wanted => {}
        Tree::Unary(Unary::Not, inner) => hinders(inner, !wanted, found),
        Tree::Binary(Binary::And | Binary::Or, a, b) => {
            hinders(a, wanted, found);
            hinders(b, wanted, found);
        }
        other => other.each_read(&mut |read| found.extend(edge_of(&read))),
    }
}
