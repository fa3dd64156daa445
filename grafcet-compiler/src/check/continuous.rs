//! `grafcet`: what continuous actions assert has no value during the search for stability (A22).

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;

use super::targets;
use crate::analysis::combinational;
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{Effect, Expr, Model, Name, Place, Read, Ty, VarId};
use crate::sorted::Set;

pub(super) fn check(model: &Model, sink: &mut Sink) {
    reads_continuous(model, sink);
    combinational_circles(model, sink);
}

/// A continuous output is read.
fn reads_continuous(model: &Model, sink: &mut Sink) {
    let at_an_instant = model.associations.values().filter(|a| a.is_stored()).map(|a| &a.effect);
    let effects = at_an_instant.and(model.transitions.values().flat(|t| &t.clearing));
    let mut stored: Set<Place> = Set::new();
    effects.for_each(|effect| stored.extend(effect.writes()));
    for (reads, tokens) in expressions(model) {
        for read in reads {
            let Read::Name(Name::Output(id)) = read else { continue };
            if stored.contains(&Place::Output(*id)) {
                continue;
            }
            let (name, ty) = (&model.outputs[*id].name, &model.outputs[*id].ty);
            let mend = match ty {
                Ty::Bool(_) => format!("declare `var {name}: bool;` and assert that"),
                // Only what is on or off follows from the situation in the search, too.
                _ => format!("declare `var {name}: {};` and store its values: `P1 {name} = …`", targets::text_of(ty)),
            };
            let message = format!(
                "`{name}` is the output of a continuous action and has no value while the chart evolves; \
                 read the step instead (`Step.X`), or {mend}"
            );
            let mark = place_of(name, tokens.clone()).unwrap_or_else(|| Mark::of(&tokens));
            sink.rule(&rules::READS_CONTINUOUS, &[], vec![(mark, message)]);
        }
    }
}

/// What the user's expressions and blocks read, with their tokens.
fn expressions(model: &Model) -> Vec<(&[Read], TokenStream)> {
    let effects = model.effects();
    let mut exprs: Vec<&Expr> = model.transitions.values().map(|t| &t.condition).list();
    for association in model.associations.values() {
        exprs.push_all(association.condition.iter().and(&association.event));
    }
    exprs.push_all(model.edges.values().map(|edge| &edge.of));
    exprs.push_all(model.delays.values().map(|delay| &delay.of));
    for effect in &effects {
        exprs.push_all(effect.expressions());
    }
    let mut all: Vec<(&[Read], TokenStream)> = Vec::new();
    for expr in exprs {
        all.push((&expr.reads, expr.tokens.to_token_stream()));
    }
    for effect in effects {
        if let Effect::Block(code) = effect {
            all.push((&code.reads, code.tokens.to_token_stream()));
        }
    }
    all
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
        let waits: Vec<VarId> = combinational::reads(model, *var).into_iter().filter(|v| order.contains(v)).list();
        if waits.iter().all(|other| known.contains(other)) {
            known.insert(*var);
            continue;
        }
        let Some(association) = combinational::asserted(model, *var).next() else { continue };
        let message = format!(
            "`{}` follows from itself: {} in its condition depends on it in turn; break the circle with a stored \
             variable (`S`, `R`)",
            model.vars[*var].name,
            waits.iter().map(|other| format!("`{}`", model.vars[*other].name)).list().join(", ")
        );
        sink.rule(&rules::COMBINATIONAL_CIRCLE, &[], vec![(association.mark, message)]);
    }
}
