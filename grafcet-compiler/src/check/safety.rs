//! `unsafe_step`: a step that is activated while it is active.
//!
//! Where two ways have parted that should not have, every step after can be activated twice. One message is given for each
//! parting: the one with the shortest way. What source transitions start may meet itself: there a step is entered whenever the
//! event occurs.

use crate::analysis::explore::{Activation, Exploration, Meeting, Parting};
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::PushAll;
use crate::model::{Model, StepId, TransitionId};
use crate::sorted::Set;

/// Returns the transitions by which two ways part that an error tells of.
pub(super) fn check(model: &Model, exploration: &Exploration, sink: &mut Sink) -> Set<TransitionId> {
    let mut partings = Set::new();
    for (step, meeting, activation) in exploration.meetings(model) {
        let errors = sink.errors();
        report(model, step, &meeting, activation, sink);
        if let (true, Parting::At(parting)) = (sink.errors() > errors, meeting.parting) {
            partings.insert(parting);
        }
    }
    partings
}

fn report(model: &Model, step: StepId, meeting: &Meeting, activation: &Activation, sink: &mut Sink) {
    let name = &model.steps[step].name;
    let way = activation.path.table(model);
    let by = &model.transitions[activation.by];
    let starts = meeting.initial_starts(model);
    let mend = match (&starts[..], meeting.divergence(model)) {
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
