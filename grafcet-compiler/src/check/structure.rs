//! `grafcet`: forcing orders, enclosures and macro-steps (A14, A16, A18, A21).

use crate::analysis::{Concurrency, hierarchy};
use crate::diagnostic::{Mark, Sink, rules};
use crate::model::{Force, ForceOrder, Model, PartialId};

pub(super) fn check(model: &Model, sink: &mut Sink) {
    circles(model, sink);
    forced_enclosures(model, sink);
    missing_links(model, sink);
    idle_initial_steps(model, sink);
    missing_initial_steps(model, sink);
}

/// A14: a partial grafcet that forces or encloses itself, directly or through others.
fn circles(model: &Model, sink: &mut Sink) {
    for force in model.forces.values() {
        let home = model.steps[force.step].partial;
        if hierarchy::acts_on(model, force.target, home) {
            let target = name(model, force.target);
            let message = if force.target == home {
                format!("this order of a step of {target} forces {target} itself; a partial grafcet commands others")
            } else {
                format!(
                    "this order forces {target}, which acts on {} in turn; a partial grafcet cannot command its own \
                     commander",
                    name(model, home)
                )
            };
            sink.rule(&rules::FORCING_CIRCLE, &[], vec![(force.mark, message)]);
        }
    }
}

/// A16: what sits in an enclosure is commanded by its enclosing step alone.
fn forced_enclosures(model: &Model, sink: &mut Sink) {
    for force in model.forces.values() {
        if let Some(outer) = model.partials[force.target].enclosed_by {
            let message = format!(
                "{} sits in the enclosing step `{}`, which alone commands it; force the partial grafcet of `{1}` instead",
                name(model, force.target),
                model.steps[outer].name
            );
            sink.rule(&rules::FORCED_ENCLOSURE, &[], vec![(force.mark, message)]);
        }
    }
}

/// A18: an enclosing step has to activate something.
fn missing_links(model: &Model, sink: &mut Sink) {
    for partial in model.partials.values() {
        let (Some(name), Some(outer)) = (&partial.name, partial.enclosed_by) else { continue };
        if partial.steps.iter().any(|step| model.steps[*step].linked) {
            continue;
        }
        let outer = &model.steps[outer].name;
        let message = format!(
            "nothing in `{name}` becomes active when `{outer}` does; mark the steps to be activated: `linked step …`"
        );
        sink.rule(&rules::ENCLOSURE_WITHOUT_LINK, &[], vec![(Mark::from(name), message)]);
    }
}

/// A18: an initial step in an enclosure belongs to the initial situation only with its enclosing step.
fn idle_initial_steps(model: &Model, sink: &mut Sink) {
    // Of an enclosure without any link more is said.
    let has_link = |partial: PartialId| model.partials[partial].steps.iter().any(|step| model.steps[*step].linked);
    for (id, step) in model.steps.iter().filter(|(_, step)| step.initial && has_link(step.partial)) {
        let Some(around) = hierarchy::idle_around(model, id) else { continue };
        let (name, around) = (&step.name, &model.steps[around].name);
        let then = if step.linked {
            format!("is activated with `{around}` by its link alone")
        } else {
            "begins nothing".to_owned()
        };
        let message = format!(
            "`{name}` is marked `initial`, but the step `{around}` around it is not, so `{name}` {then}; delete \
             `initial`, or mark `{around}` `initial`, too"
        );
        sink.rule(&rules::INITIAL_WITHOUT_EFFECT, &model.levels_of(step), vec![(Mark::from(name), message)]);
    }
}

/// A21: `{INIT}` needs initial steps.
fn missing_initial_steps(model: &Model, sink: &mut Sink) {
    for force in model.forces.values().filter(|force| force.order == ForceOrder::Init) {
        if !model.partials[force.target].steps.iter().any(|step| model.steps[*step].initial) {
            let message = format!(
                "{} has no initial step, so `{{INIT}}` means nothing; mark one `initial step`, or list the steps",
                name(model, force.target)
            );
            sink.rule(&rules::INIT_WITHOUT_INITIAL, &[], vec![(force.mark, message)]);
        }
    }
}

/// A14: two orders that may force one partial grafcet at the same time.
pub(super) fn two_masters(model: &Model, concurrency: &Concurrency, sink: &mut Sink) {
    for (first, second) in hierarchy::rival_orders(model, concurrency) {
        let (first, second) = (&model.forces[first], &model.forces[second]);
        let note = |force: &Force, other: &Force| {
            let (step, target) = (&model.steps[force.step].name, name(model, force.target));
            let message = if force.step == other.step {
                format!("`{step}` forces {target} in two ways at once; keep one of the orders")
            } else {
                let other = &model.steps[other.step].name;
                format!("`{step}` can force {target} while `{other}` does; let only one of them be active at a time")
            };
            (force.mark, message)
        };
        sink.rule(&rules::TWO_MASTERS, &[], vec![note(first, second), note(second, first)]);
    }
}

fn name(model: &Model, partial: PartialId) -> String {
    match &model.partials[partial].name {
        Some(name) => format!("`{name}`"),
        None => "the chart itself".to_owned(),
    }
}
