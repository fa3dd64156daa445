//! `unstable`, `possible_instability`: circles that turn without end in one cycle (A30).

use crate::analysis::Facts;
use crate::analysis::circles::Circle;
use crate::analysis::explore::Exploration;
use crate::analysis::refuted::Asked;
use crate::analysis::turning::{self, Leg};
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{LevelAttr, Model, PartialId, StepId, TransitionId};
use crate::sorted::Set;

pub(super) fn check(
    model: &Model,
    facts: &Facts<'_>,
    exploration: &Exploration,
    asked: Asked<'_, '_>,
    sink: &mut Sink,
) {
    let Some(certain) = turning::certain(model, facts, exploration, asked) else { return };
    for circle in &turning::by_legs(model, certain.clone(), &[]) {
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
    for circle in turning::possible(model, facts, &certain) {
        let when = if circle.inputs.is_empty() { String::new() } else { format!(" with `{}`", circle.inputs) };
        let message = format!(
            "the circle {} turns without end in one cycle{when}; if the plant excludes that, say so: `assume never …;`, \
             else let one of its transitions wait for an edge",
            text(model, &circle)
        );
        let levels = |id: &TransitionId| &model.transitions[*id].levels[..];
        let mut scopes: Vec<&[LevelAttr]> = circle.transitions.iter().map(levels).list();
        scopes
            .push_all(circle.transitions.first().map(|id| &model.partials[model.transitions[*id].partial].levels[..]));
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

/// Of how many partial grafcets a message names the circles.
const SHOWN: usize = 4;

/// `` `A → B → A` ``, one for each partial grafcet: `` `A → B → A` with `X → Y → X` ``.
fn text(model: &Model, circle: &Circle) -> String {
    let partials: Set<PartialId> = circle.transitions.iter().map(|id| model.transitions[*id].partial).collect();
    let legs = turning::legs(model, circle);
    let path = |partial: &PartialId| {
        let is_own = |step: &StepId| model.steps[*step].partial == *partial;
        let own = legs.iter().filter(|(from, to)| from.iter().and(*to).any(is_own));
        let own: Vec<&Leg<'_>> = own.list();
        let mut parts: Vec<String> = own.iter().map(|(sources, _)| model.steps_text(sources)).list();
        parts.push_all(own.last().map(|(_, targets)| model.steps_text(targets)));
        format!("`{}`", parts.join(" → "))
    };
    let paths = partials.iter().map(path).list();
    // Who mends the first ones sees the others.
    match paths.get(..SHOWN) {
        Some(first) if paths.len() > SHOWN + 1 => {
            format!("{} and those of {} more partial grafcets", first.join(" with "), paths.len() - SHOWN)
        }
        _ => paths.join(" with "),
    }
}
