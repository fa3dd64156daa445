//! `unsafe_step`: a step that is activated while it is active.
//!
//! Where two ways have parted that should not have, every step after can be activated twice. One message is given for each
//! parting: the one with the shortest way. What source transitions start may meet itself: there a step is entered whenever the
//! event occurs.

use crate::analysis::explore::{Activation, Exploration, Meeting, Parting};
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{Id, Model, StepId, TransitionId};
use crate::sorted::{Map, Set};

/// Returns the transitions by which two ways part that an error tells of.
pub(super) fn check(model: &Model, exploration: &Exploration, sink: &mut Sink) -> Set<TransitionId> {
    let mut first: Map<Parting, (StepId, Meeting, &Activation)> = Map::new();
    for step in model.steps.ids() {
        let Some(activation) = exploration.unsafe_step(step) else { continue };
        let meeting = activation.meeting(model, step);
        let parting = meeting.parting;
        if parting == Parting::Source {
            continue;
        }
        let known = first.get(&parting).map(|(.., known)| known.path.cycles.len());
        if known.is_none_or(|known| activation.path.cycles.len() < known) {
            first.insert(parting, (step, meeting, activation));
        }
    }
    let mut partings = Set::new();
    for (parting, (step, meeting, activation)) in first {
        let errors = sink.errors();
        report(model, step, &meeting, activation, sink);
        if let (true, Parting::At(parting)) = (sink.errors() > errors, parting) {
            partings.insert(parting);
        }
    }
    partings
}

fn report(model: &Model, step: StepId, meeting: &Meeting, activation: &Activation, sink: &mut Sink) {
    let name = &model.steps[step].name;
    let way = activation.path.table(model);
    let by = &model.transitions[activation.by];
    let starts = starts(model, meeting);
    let mend = match (&starts[..], divergence(model, meeting)) {
        ([first, other, ..], _) => {
            let (first, other) = (&model.steps[*first].name, &model.steps[*other].name);
            format!(
                "the chart starts in `{first}` and in `{other}`, and both ways lead to the same step; is `{other}` an \
                 initial step too many?"
            )
        }
        (_, Some(step)) => {
            let step = &model.steps[step].name;
            format!("several transitions after `{step}` can clear at once; let their conditions exclude each other")
        }
        (_, None) => {
            "let parallel branches meet in one convergence, `(…, …) -[x]-> …`, before a step after them is entered"
                .to_owned()
        }
    };
    let mut notes = vec![
        (by.mark, format!("this transition can activate `{name}` while it is active; {mend}\n{way}")),
        (Mark::from(name), format!("`{name}` can be activated while it is active")),
    ];
    if let Some(back) = meeting.back.filter(|back| *back != activation.by) {
        let message =
            format!("this transition leaves a parallel branch and goes back to where `{name}` is activated again");
        notes.push((model.transitions[back].mark, message));
    }
    if let Parting::At(parting) = meeting.parting {
        if parting != activation.by {
            let message = format!("the two ways that meet in `{name}` both come from here");
            notes.push((model.transitions[parting].mark, message));
        }
    }
    let others = starts.iter().skip(1).map(|other| &model.steps[*other].name);
    notes.push_all(others.map(|name| (Mark::from(name), format!("the chart starts in `{name}`, too"))));
    let scopes = [&by.levels[..], &model.steps[step].levels, &model.partials[by.partial].levels, &model.levels];
    sink.rule_in(model.dialect, &rules::UNSAFE_STEP, &scopes, notes);
}

/// The initial steps from which the ways come, where the start of the chart has parted them.
fn starts(model: &Model, meeting: &Meeting) -> Vec<StepId> {
    if meeting.parting != Parting::Start {
        return Vec::new();
    }
    meeting.starts.iter().filter(|start| model.steps[**start].initial).copied().list()
}

/// The step from which several transitions have cleared at once, where that has parted the ways.
fn divergence(model: &Model, meeting: &Meeting) -> Option<StepId> {
    let from = match meeting.parting {
        Parting::At(parting) => &model.transitions[parting].targets,
        Parting::Start => &meeting.starts,
        Parting::Source => return None,
    };
    let [step] = from[..] else { return None };
    (model.leaving[step.index()].len() > 1).then_some(step)
}
