//! `never_true`, `always_true`, `level_source_transition`, `event_without_edge`: what is wrong with a condition by itself.

use super::branches::never_else;
use crate::analysis::{Condition, Constant, Constants, Logic, constant, has_edge, holds_without_edge, never_together};
use crate::diagnostic::{Severity, Sink, rules};
use crate::list::List;
use crate::model::{Expr, LevelAttr, Model, Transition, TransitionId, Tree};
use crate::sorted::Set;

/// Returns the transitions of which was said that they always hold: `found` are those that do.
pub(super) fn check(
    model: &Model,
    logic: &Logic<'_>,
    conditions: &[Condition],
    found: &Constants,
    sink: &mut Sink,
) -> Set<TransitionId> {
    let mut always = Set::new();
    for ((id, transition), condition) in model.transitions.iter().zip(conditions) {
        let scopes = model.levels_of_transition(transition);
        if let Some(first) = transition.any.map(|any| model.anys[any].first).filter(|first| *first != id) {
            // It has been said of the one that stands for all.
            if always.contains(&first) {
                always.insert(id);
            }
            continue;
        }
        if found.never.contains(&id) {
            never(model, logic, transition, &scopes, sink);
        } else if found.always.contains(&id) && transition.otherwise.is_none() {
            if rules::ALWAYS_TRUE.severity_in(model.dialect, &scopes) != Severity::Allow {
                always.insert(id);
            }
            always_true(&transition.condition, &scopes, sink);
        } else if !found.always.contains(&id) {
            // The other branches beside an `else` that always holds never clear, as was said of each.
            level_source(model, logic, transition, condition, sink);
            if found.while_enabled.contains(&id) && enabled_anyway(model, transition, &scopes, sink) {
                always.insert(id);
            }
        }
    }
    for association in model.associations.values() {
        for expr in association.condition.iter().and(&association.event) {
            let scopes = model.levels_of(&model.steps[association.step]);
            match constant(logic, &logic.of_action(&expr.tree), &expr.tree) {
                Some(Constant::Never) => never_true(model, logic, expr, "this action never acts", &scopes, sink),
                Some(Constant::Always) => always_true(expr, &scopes, sink),
                None => {}
            }
        }
        if let (true, Some(event)) = (model.is_grafcet(), &association.event) {
            level_event(logic, event, sink);
        }
    }
    always
}

/// A transition whose condition never holds.
fn never(model: &Model, logic: &Logic<'_>, transition: &Transition, scopes: &[&[LevelAttr]], sink: &mut Sink) {
    if !logic.never(&logic.condition(transition.own_condition())) {
        after_any(model, transition, scopes, sink);
    } else if transition.otherwise.is_some() {
        sink.rule(&rules::NEVER_TRUE, scopes, vec![(transition.condition.mark, never_else(model, transition))]);
    } else {
        let what = format!("{} never clears", model.transition_text(transition));
        never_true(model, logic, &transition.condition, &what, scopes, sink);
    }
}

/// Whenever the condition holds, something clears that comes first.
fn after_any(model: &Model, transition: &Transition, scopes: &[&[LevelAttr]], sink: &mut Sink) {
    let (own, text) = (model.transition_text(transition), &transition.condition.text);
    let message = format!(
        "{own} never clears: whenever `{text}` holds, `any` comes before it; let it wait for something else, or leave its step out: \
         `any except …`"
    );
    let mut notes = vec![(transition.condition.mark, message)];
    for any in &transition.guards {
        let first = &model.transitions[model.anys[*any].first];
        let message = format!("{} comes before all others, {own} among them", model.transition_text(first));
        notes.push((first.condition.mark, message));
    }
    sink.rule(&rules::SHADOWED_BRANCH, scopes, notes);
}

/// Reports a condition that waits for nothing; whether somebody sees it.
fn enabled_anyway(model: &Model, transition: &Transition, scopes: &[&[LevelAttr]], sink: &mut Sink) -> bool {
    let expr = &transition.condition;
    let message = format!(
        "`{}` always holds while `{}` is active, so nothing waits for it; correct the condition, or write `true`",
        expr.text,
        model.steps_text(&transition.sources)
    );
    sink.rule(&rules::ALWAYS_TRUE, scopes, vec![(expr.mark, message)]);
    rules::ALWAYS_TRUE.severity_in(model.dialect, scopes) != Severity::Allow
}

fn never_true(model: &Model, logic: &Logic<'_>, expr: &Expr, what: &str, scopes: &[&[LevelAttr]], sink: &mut Sink) {
    let why = never_together(logic, &expr.tree).map_or_else(String::new, |(a, b)| {
        let (a, b) = (&model.steps[a].name, &model.steps[b].name);
        format!(" (`{a}` and `{b}` are never active together)")
    });
    let text = &expr.text;
    let message = format!("`{text}` never holds{why}, so {what}; correct the condition, or delete what depends on it");
    sink.rule(&rules::NEVER_TRUE, scopes, vec![(expr.mark, message)]);
}

fn always_true(expr: &Expr, scopes: &[&[LevelAttr]], sink: &mut Sink) {
    let text = &expr.text;
    let message = format!("`{text}` always holds, so nothing waits for it; correct the condition, or write `true`");
    sink.rule(&rules::ALWAYS_TRUE, scopes, vec![(expr.mark, message)]);
}

/// IEC 60848: a source transition is always enabled, so its condition is an event.
fn level_source(model: &Model, logic: &Logic<'_>, transition: &Transition, condition: &Condition, sink: &mut Sink) {
    if !model.is_grafcet() || !transition.sources.is_empty() {
        return;
    }
    let expr = &transition.condition;
    // Without any edge it is a level whatever it reads.
    if !has_edge(expr) || holds_without_edge(logic, expr, condition) {
        let mend = match &expr.tree {
            Tree::Read(_) => format!("`rising({})`", expr.text),
            _ => "`rising(…)`".to_owned(),
        };
        let message = format!(
            "a source transition is always enabled, so it clears in every evolution in which the level `{}` holds; write \
             the event that is meant: {mend}",
            expr.text
        );
        let scopes = model.levels_of_transition(transition);
        sink.rule(&rules::LEVEL_SOURCE_TRANSITION, &scopes, vec![(expr.mark, message)]);
    }
}

/// IEC 60848: an event is an edge; one without any is found with the drawing.
fn level_event(logic: &Logic<'_>, event: &Expr, sink: &mut Sink) {
    if has_edge(event) && holds_without_edge(logic, event, &logic.of_action(&event.tree)) {
        let message = format!(
            "an event happens at an instant, and `{}` also holds without an edge; write one into each alternative: \
             `rising(…) && …`",
            event.text
        );
        sink.rule(&rules::EVENT_WITHOUT_EDGE, &[], vec![(event.mark, message)]);
    }
}
