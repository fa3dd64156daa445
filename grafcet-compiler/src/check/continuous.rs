//! `grafcet`: what continuous actions assert has no value during the search for stability (A22).

use std::collections::BTreeSet;

use crate::analysis::combinational;
use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{Expr, Model, Name, OutputId, Place, Read, VarId};
use crate::plan::{is_stored, writes};

pub(super) fn check(model: &Model, sink: &mut Sink) {
    reads_continuous(model, sink);
    combinational_circles(model, sink);
}

/// A continuous output is read.
fn reads_continuous(model: &Model, sink: &mut Sink) {
    let stored: BTreeSet<OutputId> = model
        .associations
        .values()
        .filter(|association| is_stored(association))
        .map(|association| &association.effect)
        .chain(model.transitions.values().flat_map(|t| &t.clearing))
        .flat_map(writes)
        .filter_map(|place| match place {
            Place::Output(id) => Some(id),
            Place::Var(_) => None,
        })
        .collect();
    for expr in expressions(model) {
        for read in &expr.reads {
            let Read::Name(Name::Output(id)) = read else { continue };
            if stored.contains(id) {
                continue;
            }
            let name = &model.outputs[*id].name;
            let message = format!(
                "`{name}` is the output of a continuous action and has no value while the chart evolves; \
                 read the step instead (`Step.X`), or declare `var {name}: bool;` and assert that"
            );
            let mark = place_of(name, expr).unwrap_or_else(|| Mark::of(&expr.tokens));
            sink.rule(&rules::READS_CONTINUOUS, &[], vec![(mark, message)]);
        }
    }
}

/// All expressions whose tokens the user wrote.
fn expressions(model: &Model) -> impl Iterator<Item = &Expr> {
    let transitions = model.transitions.values().flat_map(|t| {
        std::iter::once(&t.condition).chain(t.clearing.iter().flat_map(crate::model::Effect::expressions))
    });
    let associations =
        model.associations.values().flat_map(|a| a.condition.iter().chain(&a.event).chain(a.effect.expressions()));
    let edges = model.edges.values().map(|edge| &edge.of);
    transitions.chain(associations).chain(edges).chain(model.delays.values().map(|delay| &delay.of))
}

/// The token of the name in the expression.
fn place_of(name: &syn::Ident, expr: &Expr) -> Option<Mark> {
    fn find(name: &syn::Ident, tokens: proc_macro2::TokenStream) -> Option<Mark> {
        tokens.into_iter().find_map(|tree| match tree {
            proc_macro2::TokenTree::Ident(ident) if ident == *name => Some(Mark::from(&ident)),
            proc_macro2::TokenTree::Group(group) => find(name, group.stream()),
            _ => None,
        })
    }
    find(name, quote::ToTokens::to_token_stream(&expr.tokens))
}

/// Combinational variables that follow from each other in a circle.
fn combinational_circles(model: &Model, sink: &mut Sink) {
    let order = combinational::in_order(model);
    let mut known: BTreeSet<VarId> = BTreeSet::new();
    for var in &order {
        let waits: Vec<VarId> = combinational::reads(model, *var).into_iter().filter(|v| order.contains(v)).collect();
        if waits.iter().all(|other| known.contains(other)) {
            known.insert(*var);
            continue;
        }
        let Some(association) = combinational::asserted(model, *var).next() else { continue };
        let message = format!(
            "`{}` follows from itself: {} in its condition depends on it in turn; break the circle with a stored \
             variable (`S`, `R`)",
            model.vars[*var].name,
            waits.iter().map(|other| format!("`{}`", model.vars[*other].name)).collect::<Vec<_>>().join(", ")
        );
        sink.rule(&rules::COMBINATIONAL_CIRCLE, &[], vec![(association.mark, message)]);
    }
}
