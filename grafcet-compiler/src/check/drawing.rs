//! The rules of drawing: initial steps, doubled transitions, steps on their own.

use super::rivals;
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::List;
use crate::model::{Dialect, ForceOrder, Id, Model, PartialId, StepId, TransitionId};
use crate::sorted::sort;

pub(super) fn check(model: &Model, sink: &mut Sink) {
    initial_steps(model, sink);
    duplicate_transitions(model, sink);
    isolated_steps(model, sink);
}

/// Every chart starts somewhere; a sequential function chart in exactly one step (IEC 61131-3).
fn initial_steps(model: &Model, sink: &mut Sink) {
    for (id, partial) in model.partials.iter() {
        let initial: Vec<StepId> = partial.steps.iter().copied().filter(|step| model.steps[*step].initial).list();
        if initial.is_empty() {
            if !model.incomplete && !is_started_elsewhere(model, id) {
                no_initial_step(model, id, sink);
            }
        } else if model.dialect == Dialect::Sfc && initial.len() > 1 {
            let note = |step: &StepId| {
                let name = &model.steps[*step].name;
                let others = initial.iter().filter(|other| *other != step);
                let others: Vec<String> = others.map(|other| format!("`{}`", model.steps[*other].name)).list();
                let others = rivals::listed(&others);
                let message = format!(
                    "`{name}` is an initial step beside {others}, an `sfc` has exactly one; \
                     start parallel branches with `-[true]-> (…)` after it",
                );
                (Mark::from(name), message)
            };
            let own = initial.iter().map(|step| &model.steps[*step].levels[..]);
            let scopes: Vec<_> = own.and([&model.levels[..]]).list();
            sink.rule(&rules::SEVERAL_INITIAL_STEPS, &scopes, initial.iter().map(note).list());
        }
    }
}

fn no_initial_step(model: &Model, id: PartialId, sink: &mut Sink) {
    let partial = &model.partials[id];
    let (place, what) = match &partial.name {
        Some(name) => (name, format!("partial grafcet `{name}`")),
        None => (&model.name, format!("chart `{}`", model.name)),
    };
    let mend = match partial.steps.first() {
        Some(step) => format!("write `initial step {}`", model.steps[*step].name),
        None => "write `initial step Start;`".to_owned(),
    };
    let message = format!("{what} has no initial step, so nothing in it ever becomes active; {mend}");
    sink.rule(&rules::NO_INITIAL_STEP, &[], vec![(place.into(), message)]);
}

/// An enclosing step, a forcing order or a source transition starts the partial grafcet; one that only holds others
/// needs no start.
fn is_started_elsewhere(model: &Model, id: PartialId) -> bool {
    let partial = &model.partials[id];
    let holds_others = partial.name.is_none() && partial.steps.is_empty() && model.partials.len() > 1;
    // `{INIT}` without initial steps is an error of its own.
    let starts = |order: &ForceOrder| match order {
        ForceOrder::Steps(steps) => !steps.is_empty(),
        ForceOrder::Init => true,
        ForceOrder::Hold => false,
    };
    let forced = model.orders_on(id).any(|force| starts(&force.order));
    let source = partial.transitions.iter().any(|t| model.transitions[*t].sources.is_empty());
    holds_others || partial.enclosed_by.is_some() || forced || source && model.dialect == Dialect::Grafcet
}

/// The same arc with the same condition, drawn twice.
fn duplicate_transitions(model: &Model, sink: &mut Sink) {
    let mut seen = crate::sorted::Map::new();
    for (id, transition) in model.drawn_transitions() {
        let (mut sources, mut targets) = (transition.sources.clone(), transition.targets.clone());
        sort(&mut sources);
        sort(&mut targets);
        let key = (sources, targets, &transition.condition.tree);
        if let Some(first) = seen.insert(key, id) {
            duplicate_transition(model, first, id, sink);
        }
    }
}

/// Both places of a transition that is drawn twice.
pub(super) fn duplicate_transition(model: &Model, first: TransitionId, second: TransitionId, sink: &mut Sink) {
    let transition = &model.transitions[second];
    let (from, to) = model.ends_text(transition);
    let drawn = |mark: Mark, when: &str| {
        (
            mark,
            format!("this transition from `{from}` to `{to}` is drawn {when}, with the same condition; draw it once"),
        )
    };
    let notes =
        vec![drawn(model.transitions[first].mark, "again further down"), drawn(transition.mark, "a second time")];
    sink.rule(&rules::DUPLICATE_TRANSITION, &[], notes);
}

/// A step no transition touches, although its partial grafcet has transitions.
fn isolated_steps(model: &Model, sink: &mut Sink) {
    let named_by_force =
        |id: StepId| model.forces.values().any(|f| matches!(&f.order, ForceOrder::Steps(steps) if steps.contains(&id)));
    for (id, step) in model.steps.iter() {
        let evolves = model.partials[step.partial].steps.iter().any(|other| model.steps[*other].drawn);
        // A stop of all steps leaves it, too.
        let starts = step.initial && !model.leaving[id.index()].is_empty();
        if step.drawn || starts || !evolves || step.linked || named_by_force(id) {
            continue;
        }
        let name = &step.name;
        let message =
            format!("no transition touches step `{name}`; draw one to it, `… -[x]-> {name}`, or delete the step");
        sink.rule(&rules::ISOLATED_STEP, &[], vec![(name.into(), message)]);
    }
}
