//! What expressions ask of edges, and what changes with an edge that is gone in the next cycle.

use super::{Answer, Condition, Logic, is_constant_read};
use crate::list::List;
use crate::model::{Association, Binary, EdgeId, Effect, Expr, Id, Model, Read, StepId, Tree, Unary};
use crate::qualifier::Qualifier;
use crate::sorted::Set;

/// The edge that is read.
fn edge_of(read: &Read) -> Option<EdgeId> {
    match read {
        Read::Rising(edge) | Read::Falling(edge) => Some(*edge),
        _ => None,
    }
}

/// Whether an expression has an edge.
pub(crate) fn has_edge(expr: &Expr) -> bool {
    expr.reads.iter().any(|read| edge_of(read).is_some())
}

/// Whether the condition certainly can hold while none of its edges does.
pub(crate) fn holds_without_edge(logic: &Logic<'_>, expr: &Expr, condition: &Condition) -> bool {
    let edges = expr.reads.iter().filter(|read| edge_of(read).is_some());
    let edges: Vec<Condition> = edges.map(|read| logic.condition(&Tree::Read(*read))).list();
    let mut goals: Vec<_> = edges.iter().map(|edge| (edge, false)).list();
    goals.push((condition, true));
    matches!(logic.certainly_together(&goals, &[]), Answer::Witness(_))
}

/// Whether an edge is read of what has one value throughout a cycle, which only the first evolution sees (A2).
pub(super) fn is_edge_of_inputs(model: &Model, read: &Read) -> bool {
    is_edge_of(model, read, &|of| is_constant_read(of))
}

/// Whether an edge is read of what reads only these.
pub(super) fn is_edge_of(model: &Model, read: &Read, of: &dyn Fn(&Read) -> bool) -> bool {
    edge_of(read).is_some_and(|edge| model.edges[edge].of.reads.iter().all(of))
}

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
    for association in model.associations.values().filter(|one| !is_over_with_edges(one)) {
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

/// Whether an action happens with an edge alone: what it has done stays, and without edges it does nothing.
fn is_over_with_edges(association: &Association) -> bool {
    let is_edge = |tree: &Tree| matches!(tree, Tree::Read(read) if edge_of(read).is_some());
    association.qualifier == Qualifier::On
        && association.event.as_ref().is_some_and(|event| asks(&event.tree, &is_edge))
}

/// Whether the condition holds only where one of these does.
pub(super) fn asks(tree: &Tree, once: &dyn Fn(&Tree) -> bool) -> bool {
    match tree {
        Tree::Binary(Binary::And, a, b) => asks(a, once) || asks(b, once),
        Tree::Binary(Binary::Or, a, b) => asks(a, once) && asks(b, once),
        other => once(other),
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
