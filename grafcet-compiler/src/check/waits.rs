//! `stuck_join`, `deadlock`: situations in which something waits forever.
//!
//! A situation is reported once: what waits for a convergence that cannot come, or after a transition that never clears, is
//! no deadlock beside that. Where all wait for each other, since one took what another needs, it is a deadlock.

use crate::analysis::explore::{Deadlock, Exploration, Stay, StuckJoin, smallest};
use crate::analysis::{Concurrency, Explained};
use crate::diagnostic::{Mark, Sink, rules};
use crate::list::{List, PushAll};
use crate::model::{Id, LevelAttr, Model, StepId, TransitionId};
use crate::sorted::{Set, sort};

/// Returns where the chart stays for ever, of which an error tells.
pub(super) fn check(
    model: &Model,
    structure: &Concurrency,
    exploration: &Exploration,
    dead: &Set<TransitionId>,
    told: &mut Explained,
    sink: &mut Sink,
) -> Vec<Stay> {
    let mut stays = Vec::new();
    let contended = exploration.contended(model);
    for deadlock in smallest(&contended) {
        let errors = sink.errors();
        contention(model, exploration, deadlock, sink);
        stays.push_all((sink.errors() > errors).then(|| Stay { active: deadlock.steps.clone(), within: None }));
    }
    let (mut reported, mut denied) = (Set::new(), Set::new());
    let mut waiting: Set<StepId> = contended.iter().flat(|deadlock| &deadlock.steps).copied().collect();
    // Of convergences that never clear nothing has been said before.
    let joins: Set<TransitionId> = exploration.stuck_joins().iter().map(|stuck| stuck.join).collect();
    let others_dead = |join: TransitionId| dead.iter().any(|id| *id != join && !joins.contains(id));
    for stuck in exploration.stuck_joins() {
        let in_contention = contended.iter().any(|deadlock| deadlock.steps.contains(&stuck.waiting));
        // One whose sources never meet as the chart is drawn does not follow from anything else.
        let may_follow = stuck.culprit.is_none() && structure.can_clear(stuck.join);
        if in_contention {
            told.transitions.insert(stuck.join);
        }
        if in_contention || may_follow && others_dead(stuck.join) {
            continue;
        }
        told.transitions.insert(stuck.join);
        waiting.insert(stuck.waiting);
        if reported.insert(stuck.join) {
            let errors = sink.errors();
            stuck_join(model, stuck, sink);
            if sink.errors() > errors {
                denied.insert(stuck.join);
            }
        }
        if denied.contains(&stuck.join) {
            stays.push(Stay { active: vec![stuck.waiting], within: Some(stuck.path.end().to_vec()) });
        }
    }
    let explained = |step: &StepId| {
        waiting.contains(step) || model.leaving[step.index()].iter().any(|transition| dead.contains(transition))
    };
    let ends: Vec<&Deadlock> =
        exploration.deadlocks().iter().filter(|deadlock| !deadlock.steps.iter().any(explained)).list();
    for deadlock in smallest(&ends) {
        let errors = sink.errors();
        report(model, deadlock, sink);
        stays.push_all((sink.errors() > errors).then(|| Stay { active: deadlock.steps.clone(), within: None }));
    }
    stays
}

/// A deadlock in which steps wait for what others have taken.
fn contention(model: &Model, exploration: &Exploration, deadlock: &Deadlock, sink: &mut Sink) {
    let here = model.steps_text(&deadlock.steps);
    let note = |step: &StepId| {
        let joins = exploration.stuck_joins().iter().filter(|stuck| stuck.waiting == *step);
        let missing = joins.flat(|stuck| &model.transitions[stuck.join].sources);
        let mut missing: Vec<StepId> = missing.filter(|source| !deadlock.steps.contains(source)).copied().list();
        sort(&mut missing);
        missing.dedup();
        let name = &model.steps[*step].name;
        let message = format!(
            "from `{here}`, reached so, the chart never goes on: `{name}` waits for `{}`, which was taken and is never given back; \
             take what several branches need in the same order, and give it back in the end, `… -[x]-> (…, …)`",
            model.steps_text(&missing)
        );
        (Mark::from(name), message)
    };
    deadlocked(model, deadlock, deadlock.steps.iter().map(note).list(), sink);
}

fn stuck_join(model: &Model, stuck: &StuckJoin, sink: &mut Sink) {
    let join = &model.transitions[stuck.join];
    let (name, way) = (&model.steps[stuck.waiting].name, stuck.path.table(model));
    let sources = model.steps_text(&join.sources);
    let mut notes = Vec::new();
    match stuck.culprit {
        Some(culprit) => {
            let by = &model.transitions[culprit];
            let (from, to) = (model.steps_text(&by.sources), model.steps_text(&by.targets));
            notes.push((
                join.mark,
                format!(
                    "`{name}` waits forever for this convergence of `{sources}`, because the branch it waits for can be left \
                     from `{from}` to `{to}`; let both branches be left together, `(…, …) -[x]-> …`, or lead the other one \
                     here, too\n{way}"
                ),
            ));
            notes.push((by.mark, format!("with this transition a branch leaves for which `{name}` then waits forever")));
        }
        None => notes.push((
            join.mark,
            format!(
                "`{name}` waits forever: `{sources}` are never all active, for their branches are alternatives; start them \
                 together, `… -[x]-> (…, …)`, or let each of them go on by a transition of its own\n{way}"
            ),
        )),
    }
    notes.push((Mark::from(name), format!("`{name}` can wait forever")));
    sink.rule(&rules::STUCK_JOIN, &levels(model, stuck), notes);
}

/// Where the level of `stuck_join` may stand.
pub(super) fn levels<'m>(model: &'m Model, stuck: &StuckJoin) -> [&'m [LevelAttr]; 4] {
    let join = &model.transitions[stuck.join];
    [&join.levels, &model.steps[stuck.waiting].levels, &model.partials[join.partial].levels, &model.levels]
}

fn report(model: &Model, deadlock: &Deadlock, sink: &mut Sink) {
    let here = model.steps_text(&deadlock.steps);
    let note = |step: &StepId| {
        let name = &model.steps[*step].name;
        let message = if model.leaving[step.index()].is_empty() {
            format!(
                "in `{here}`, reached so, the chart ends: no transition leads on from `{name}`; draw one, or write \
                 `final step {name}` if that is meant"
            )
        } else {
            format!(
                "from `{here}`, reached so, the chart never goes on: no transition that leaves `{name}` can clear any more; draw \
                 another way on, or write `final step {name}` if it may end here"
            )
        };
        (Mark::from(name), message)
    };
    deadlocked(model, deadlock, deadlock.steps.iter().map(note).list(), sink);
}

fn deadlocked(model: &Model, deadlock: &Deadlock, mut notes: Vec<(Mark, String)>, sink: &mut Sink) {
    // The way there stands once.
    if let Some((_, first)) = notes.first_mut() {
        first.push('\n');
        first.push_str(&deadlock.path.table(model));
    }
    let mut scopes: Vec<&[LevelAttr]> = deadlock.steps.iter().map(|step| &model.steps[*step].levels[..]).list();
    scopes.push_all([&model.partials[deadlock.partial].levels[..], &model.levels]);
    sink.rule(&rules::DEADLOCK, &scopes, notes);
}
