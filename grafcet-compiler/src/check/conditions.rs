//! `never_true`, `always_true`, `level_source_transition`, `event_without_edge`: what is wrong with a condition by itself.

use super::branches::never_else;
use crate::analysis::explore::situation;
use crate::analysis::{Answer, Condition, Logic};
use crate::diagnostic::{Rule, Severity, Sink, rules};
use crate::list::List;
use crate::model::{Binary, Expr, LevelAttr, Model, Read, StepId, Transition, TransitionId, Tree};
use crate::sorted::Set;

/// The transitions of which something was said.
#[derive(Default)]
pub(super) struct Said {
    /// Their condition never holds.
    pub(super) never: Set<TransitionId>,
    /// It always holds.
    pub(super) always: Set<TransitionId>,
}

pub(super) fn check(model: &Model, logic: &Logic<'_>, conditions: &[Condition], sink: &mut Sink) -> Said {
    let mut said = Said::default();
    let plain = Logic::new(model);
    for ((id, transition), condition) in model.transitions.iter().zip(conditions) {
        let scopes = model.levels_of_transition(transition);
        if let Some(first) = transition.any.map(|any| model.anys[any].first).filter(|first| *first != id) {
            // It has been said of the one that stands for all.
            let add = |said: &mut Set<TransitionId>| said.contains(&first) && said.insert(id);
            add(&mut said.never);
            add(&mut said.always);
            continue;
        }
        let Some(rule) = constant(logic, condition, &transition.condition.tree) else {
            level_source(model, logic, transition, condition, sink);
            if holds_while_enabled(&plain, transition) && enabled_anyway(model, transition, &scopes, sink) {
                said.always.insert(id);
            }
            continue;
        };
        if rule.name == rules::NEVER_TRUE.name {
            said.never.insert(id);
        } else if transition.otherwise.is_some() {
            // The other branches never clear, as was said of each.
            continue;
        } else if rule.severity_in(model.dialect, &scopes) != Severity::Allow {
            said.always.insert(id);
        }
        if rule.name == rules::NEVER_TRUE.name && !logic.never(&logic.condition(transition.own_condition())) {
            behind_any(model, transition, &scopes, sink);
            continue;
        }
        let what = format!("{} never clears", model.transition_text(transition));
        let expr = &transition.condition;
        if transition.otherwise.is_some() {
            sink.rule(rule, &scopes, vec![(expr.mark, never_else(model, transition))]);
            continue;
        }
        report(rule, (expr, apart(model, logic, &expr.tree)), &what, &scopes, sink);
    }
    for association in model.associations.values() {
        for expr in association.condition.iter().chain(&association.event) {
            if let Some(rule) = constant(logic, &logic.of_action(&expr.tree), &expr.tree) {
                let step = &model.steps[association.step];
                let apart = apart(model, logic, &expr.tree);
                report(rule, (expr, apart), "this action never acts", &model.levels_of(step), sink);
            }
        }
        if let (true, Some(event)) = (model.is_grafcet(), &association.event) {
            level_event(logic, event, sink);
        }
    }
    said
}

/// Whenever the condition holds, something clears that comes first.
fn behind_any(model: &Model, transition: &Transition, scopes: &[&[LevelAttr]], sink: &mut Sink) {
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

/// Whether a condition holds because it asks for the steps in front of the transition. That another step is not active
/// then, as in `!Other.X`, may be said to be safe.
fn holds_while_enabled(logic: &Logic<'_>, transition: &Transition) -> bool {
    let own = |read: &Read| matches!(read, Read::Active(step) if transition.sources.contains(step));
    if transition.otherwise.is_some() || transition.any.is_some() || !transition.condition.reads.iter().any(own) {
        return false;
    }
    let condition = &logic.condition(&transition.condition.tree);
    let active = |step: &StepId| logic.condition(&Tree::Read(Read::Active(*step)));
    let active: Vec<Condition> = transition.sources.iter().map(active).list();
    let mut goals: Vec<_> = active.iter().map(|source| (source, true)).list();
    if logic.impossible(&goals) {
        return false;
    }
    goals.push((condition, false));
    logic.impossible(&goals)
}

/// Reports a condition that waits for nothing; whether somebody sees it.
fn enabled_anyway(model: &Model, transition: &Transition, scopes: &[&[LevelAttr]], sink: &mut Sink) -> bool {
    let expr = &transition.condition;
    let message = format!(
        "`{}` always holds while `{}` is active, so nothing waits for it; correct the condition, or write `true`",
        expr.text,
        situation(model, &transition.sources)
    );
    sink.rule(&rules::ALWAYS_TRUE, scopes, vec![(expr.mark, message)]);
    rules::ALWAYS_TRUE.severity_in(model.dialect, scopes) != Severity::Allow
}

/// The rule that a condition breaks which always has the same value.
fn constant(logic: &Logic<'_>, condition: &Condition, tree: &Tree) -> Option<&'static Rule> {
    // A name alone can have any value.
    if matches!(tree, Tree::Bool(true) | Tree::Read(Read::Name(_))) {
        return None;
    }
    if logic.never(condition) {
        return Some(&rules::NEVER_TRUE);
    }
    logic.always(condition).then_some(&rules::ALWAYS_TRUE)
}

/// Two steps that a condition wants to be active together, and that never are.
fn apart(model: &Model, logic: &Logic<'_>, tree: &Tree) -> Option<String> {
    let mut steps: Vec<StepId> = Vec::new();
    let mut open = vec![tree];
    while let Some(tree) = open.pop() {
        match tree {
            Tree::Binary(Binary::And | Binary::BitAnd, a, b) => open.extend([&**b, &**a]),
            Tree::Read(Read::Active(step)) => steps.push(*step),
            _ => {}
        }
    }
    let active = |step: &StepId| logic.condition(&Tree::Read(Read::Active(*step)));
    let active: Vec<Condition> = steps.iter().map(active).list();
    let pairs = (0..steps.len()).flat_map(|a| (a + 1..steps.len()).map(move |b| (a, b)));
    let mut apart = pairs.filter(|(a, b)| logic.impossible(&[(&active[*a], true), (&active[*b], true)]));
    let (a, b) = apart.next()?;
    let name = |step: StepId| &model.steps[step].name;
    Some(format!(" (`{}` and `{}` are never active together)", name(steps[a]), name(steps[b])))
}

fn report(
    rule: &'static Rule,
    (expr, apart): (&Expr, Option<String>),
    what: &str,
    scopes: &[&[LevelAttr]],
    sink: &mut Sink,
) {
    let text = &expr.text;
    let message = if rule.name == rules::NEVER_TRUE.name {
        let why = apart.unwrap_or_default();
        format!("`{text}` never holds{why}, so {what}; correct the condition, or delete what depends on it")
    } else {
        format!("`{text}` always holds, so nothing waits for it; correct the condition, or write `true`")
    };
    sink.rule(rule, scopes, vec![(expr.mark, message)]);
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

fn edges(expr: &Expr) -> impl Iterator<Item = Read> + '_ {
    expr.reads.iter().copied().filter(|read| matches!(read, Read::Rising(_) | Read::Falling(_)))
}

pub(super) fn has_edge(expr: &Expr) -> bool {
    edges(expr).next().is_some()
}

/// Whether the condition certainly can hold while none of its edges does.
fn holds_without_edge(logic: &Logic<'_>, expr: &Expr, condition: &Condition) -> bool {
    let edges: Vec<Condition> = edges(expr).map(|read| logic.condition(&Tree::Read(read))).list();
    let mut goals: Vec<_> = edges.iter().map(|edge| (edge, false)).list();
    goals.push((condition, true));
    matches!(logic.certainly_together(&goals, &[]), Answer::Witness(_))
}
