//! `shadowed_branch`, `overlapping_branches`: transitions that compete for a step.

use super::drawing;
use super::rivals::{self, Rivals};
use crate::analysis::{Overlap, Rivalry, Shadowed};
use crate::diagnostic::{Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{Id, LevelAttr, Model, Transition, TransitionId};
use crate::sorted::{Map, Set};

/// Of the transitions `always` it was said that their condition always holds: that they shadow others need not be said.
pub(super) fn check(model: &Model, found: &Rivalry, always: &Set<TransitionId>, sink: &mut Sink) {
    for Shadowed { id, by, is_duplicate } in &found.shadowed {
        match by[..] {
            _ if by.iter().any(|other| always.contains(other)) => {}
            [one] if *is_duplicate => drawing::duplicate_transition(model, one, *id, sink),
            _ => report_shadowed(model, *id, by, sink),
        }
    }
    for (first, second) in &found.duplicates {
        drawing::duplicate_transition(model, *first, *second, sink);
    }
    report_overlapping(model, &found.overlaps, sink);
}

fn report_shadowed(model: &Model, id: TransitionId, shadowing: &[TransitionId], sink: &mut Sink) {
    let transition = &model.transitions[id];
    let (own, text) = (model.transition_text(transition), &transition.condition.text);
    let who = match shadowing {
        [one] => {
            let first = &model.transitions[*one];
            format!("`{}` of {}", first.condition.text, model.transition_text(first))
        }
        _ => format!("one of the {} conditions", shadowing.len()),
    };
    let message = format!(
        "{own} never clears: whenever `{text}` holds, so does {who} before it; put it first, or correct one of the \
         conditions"
    );
    let by_any = |other: &TransitionId| model.transitions[*other].any.is_some();
    let message = if shadowing.iter().any(by_any) && transition.any.is_none() {
        format!(
            "{own} never clears: whenever `{text}` holds, so does {who}, which comes before it; let it wait for something else, \
             or leave its step out: `any except …`"
        )
    } else {
        message
    };
    let message = if transition.otherwise.is_some() { never_else(model, transition) } else { message };
    let mut notes = vec![(transition.condition.mark, message)];
    for other in shadowing {
        let first = &model.transitions[*other];
        let (first_text, rest) = (model.transition_text(first), shadowing.len() - 1);
        let instead = match rest {
            0 => "it is cleared instead".to_owned(),
            1 => "it or the other one before is cleared instead".to_owned(),
            _ => format!("it or one of the {rest} others before is cleared instead"),
        };
        let message = format!("{first_text} stands before {own} and has priority; whenever `{text}` holds, {instead}");
        notes.push((first.condition.mark, message));
    }
    sink.rule(&rules::SHADOWED_BRANCH, &model.levels_of_transition(transition), notes);
}

fn report_overlapping(model: &Model, found: &[Overlap], sink: &mut Sink) {
    let mut rivals = Rivals::new(&rules::OVERLAPPING_BRANCHES, model.dialect);
    let mut inputs: Map<(usize, usize), &str> = Map::new();
    for Overlap { first, second, inputs: when } in found {
        let mut scopes: Vec<&[LevelAttr]> = vec![&model.transitions[*first].levels];
        scopes.push_all(model.levels_of_transition(&model.transitions[*second]));
        rivals.add(first.index(), second.index(), &scopes);
        inputs.insert((first.index(), second.index()), when);
    }
    let transitions: Vec<&Transition> = model.transitions.values().list();
    rivals.report(sink, |one, others| {
        let together = |other: &usize| {
            let when = inputs.get(&(one.min(*other), one.max(*other))).copied().unwrap_or_default();
            let when = if when.is_empty() { "always".to_owned() } else { format!("with `{when}`") };
            (model.transition_text(transitions[*other]), when)
        };
        let message = match others {
            [other] => {
                let (text, when) = together(other);
                let own = model.transition_text(transitions[one]);
                format!("{own} and {text} can clear together, {when}; let their conditions exclude each other")
            }
            _ => {
                let texts = others.iter().map(|other| {
                    let (text, when) = together(other);
                    format!("{text} ({when})")
                });
                format!(
                    "{} can clear together with each of {}; let their conditions exclude each other",
                    model.transition_text(transitions[one]),
                    rivals::listed(&texts.list()),
                )
            }
        };
        (transitions[one].condition.mark, message)
    });
}

/// Why an `else` is never taken.
pub(super) fn never_else(model: &Model, transition: &Transition) -> String {
    format!(
        "{} never clears: one of the other branches always does; delete it, or correct one of their conditions",
        model.transition_text(transition)
    )
}
