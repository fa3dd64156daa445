//! `unstable`, `possible_instability`: circles that turn without end in one cycle (A30).

use crate::analysis::circles::{Circle, Circles};
use crate::analysis::{Concurrency, Logic};
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::List;
use crate::model::{LevelAttr, Model, PartialId, StepId, TransitionId, Tree};
use crate::sorted::Set;

/// `never` is what the plant excludes; `settles` tells that no search is without end then.
pub(super) fn check(model: &Model, concurrency: &Concurrency, never: &[&Tree], settles: bool, sink: &mut Sink) {
    if settles {
        return;
    }
    let logic = Logic::within(model, concurrency, never);
    let certain = Circles::new(model, concurrency, &logic).certain();
    for circle in &certain {
        let message = format!(
            "the circle {} never comes to rest: once one of its transitions clears, it turns again and again in the same \
             cycle; let one of them wait for something else, e.g. for an edge: `rising(…)`",
            text(model, circle)
        );
        sink.rule(&rules::UNSTABLE, &[], notes(model, circle, &message));
    }
    // Nothing is looked for that no attribute wants to see.
    if !model.has_level_of(&rules::POSSIBLE_INSTABILITY) {
        return;
    }
    // The many questions about single transitions are not at the expense of these.
    let logic = Logic::within(model, concurrency, never);
    for circle in Circles::new(model, concurrency, &logic).possible(&certain) {
        let when = if circle.inputs.is_empty() { String::new() } else { format!(" with `{}`", circle.inputs) };
        let message = format!(
            "the circle {} turns without end in one cycle{when}; if the plant excludes that, say so: `assume never …;`, \
             else let one of its transitions wait for an edge",
            text(model, &circle)
        );
        let levels = |id: &TransitionId| &model.transitions[*id].levels[..];
        let mut scopes: Vec<&[LevelAttr]> = circle.transitions.iter().map(levels).list();
        scopes.extend(circle.transitions.first().map(|id| &model.partials[model.transitions[*id].partial].levels[..]));
        scopes.push(&model.levels);
        sink.rule(&rules::POSSIBLE_INSTABILITY, &scopes, notes(model, &circle, &message));
    }
}

fn notes(model: &Model, circle: &Circle, message: &str) -> Vec<(Mark, String)> {
    let mut seen = Set::new();
    let once = |id: &&TransitionId| model.transitions[**id].any.is_none_or(|any| seen.insert(any));
    let transitions: Vec<&TransitionId> = circle.transitions.iter().filter(once).list();
    transitions.into_iter().map(|id| (model.transitions[*id].mark, message.to_owned())).list()
}

/// `` `A → B → A` ``, one for each partial grafcet: `` `A → B → A` with `X → Y → X` ``.
fn text(model: &Model, circle: &Circle) -> String {
    let side = |steps: &[StepId]| match steps {
        [step] => model.steps[*step].name.to_string(),
        _ => {
            let names: Vec<_> = steps.iter().map(|step| model.steps[*step].name.to_string()).list();
            format!("({})", names.join(", "))
        }
    };
    let partials: Set<PartialId> = circle.transitions.iter().map(|id| model.transitions[*id].partial).collect();
    let path = |partial: &PartialId| {
        let all = circle.transitions.iter().map(|id| &model.transitions[*id]);
        let own: Vec<_> = all.filter(|transition| transition.partial == *partial).list();
        let mut parts: Vec<String> = own.iter().map(|transition| side(&transition.sources)).list();
        parts.extend(own.last().map(|last| side(&last.targets)));
        format!("`{}`", parts.join(" → "))
    };
    partials.iter().map(path).list().join(" with ")
}
