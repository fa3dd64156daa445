//! `grafcet`: what continuous actions assert has no value during the search for stability (A22).

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;

use crate::analysis::combinational;
use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{Effect, Model, Name, OutputId, Place, Read, VarId};
use crate::plan::{is_stored, writes};
use crate::sorted::Set;

pub(super) fn check(model: &Model, sink: &mut Sink) {
    reads_continuous(model, sink);
    combinational_circles(model, sink);
}

/// A continuous output is read.
fn reads_continuous(model: &Model, sink: &mut Sink) {
    let stored: Set<OutputId> = model
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
    for (reads, tokens) in expressions(model) {
        for read in reads {
            let Read::Name(Name::Output(id)) = read else { continue };
            if stored.contains(id) {
                continue;
            }
            let name = &model.outputs[*id].name;
            let message = format!(
                "`{name}` is the output of a continuous action and has no value while the chart evolves; \
                 read the step instead (`Step.X`), or declare `var {name}: bool;` and assert that"
            );
            let mark = place_of(name, tokens.clone()).unwrap_or_else(|| Mark::of(&tokens));
            sink.rule(&rules::READS_CONTINUOUS, &[], vec![(mark, message)]);
        }
    }
}

/// What the user's expressions and blocks read, with their tokens.
fn expressions(model: &Model) -> impl Iterator<Item = (&[Read], TokenStream)> {
    let conditions = model.transitions.values().map(|t| &t.condition);
    let of_associations = model.associations.values().flat_map(|a| a.condition.iter().chain(&a.event));
    let memories = model.edges.values().map(|edge| &edge.of).chain(model.delays.values().map(|delay| &delay.of));
    let effects = model.associations.values().map(|a| &a.effect);
    let effects = effects.chain(model.transitions.values().flat_map(|t| &t.clearing));
    let (values, blocks) = (effects.clone().flat_map(Effect::expressions), effects);
    let exprs = conditions.chain(of_associations).chain(memories).chain(values);
    let blocks = blocks.filter_map(|effect| match effect {
        Effect::Block(code) => Some((&code.reads[..], code.tokens.to_token_stream())),
        _ => None,
    });
    exprs.map(|expr| (&expr.reads[..], expr.tokens.to_token_stream())).chain(blocks)
}

/// The token of the name in the expression.
fn place_of(name: &syn::Ident, tokens: TokenStream) -> Option<Mark> {
    tokens.into_iter().find_map(|tree| match tree {
        TokenTree::Ident(ident) if ident == *name => Some(Mark::from(&ident)),
        TokenTree::Group(group) => place_of(name, group.stream()),
        _ => None,
    })
}

/// Combinational variables that follow from each other in a circle.
fn combinational_circles(model: &Model, sink: &mut Sink) {
    let order = combinational::in_order(model);
    let mut known: Set<VarId> = Set::new();
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
