//! What one evolution of a chart does with the values from before it, a program does one after the other: where the order could be seen, there
//! is no translation.

use std::collections::BTreeMap;

use grafcet_compiler::diagnostic::Mark;
use grafcet_compiler::model::{Association, Id, Model, Place, StepId};

use crate::Refused;
use crate::st::action::{Role, Written, places, reads, role};

/// Something that runs.
struct Run {
    /// What it has to read as it was before.
    before: Vec<Place>,
    writes: Vec<Place>,
    mark: Mark,
}

pub(super) fn refused(model: &Model, written: &BTreeMap<Place, Written>, refused: &mut Vec<Refused>) {
    for list in lists(model) {
        for (index, run) in list.iter().enumerate() {
            let earlier = list[..index].iter().flat_map(|earlier| &earlier.writes);
            let Some(place) = earlier.into_iter().find(|place| run.before.contains(place)) else { continue };
            let name = model.place_name(*place);
            let message = format!(
                "it reads `{name}` as it was before another action of the same moment writes it, which the CASE form cannot: read another variable, or use the form of flip-flops"
            );
            if refused.iter().all(|known| known.message != message) {
                refused.push(Refused::at(run.mark, message));
            }
        }
    }
    for association in model.associations.values() {
        let Ok(role) = role(model, association) else { continue };
        let mut read = Vec::new();
        if !matches!(role, Role::Continuous(_)) {
            read.extend(reads(&association.effect));
        }
        let conditions = association.condition.iter().chain(&association.event);
        read.extend(conditions.flat_map(|condition| places(&condition.tree)));
        let continuous = |place: &Place| written.get(place).is_some_and(|how| how.continuous);
        if let Some(place) = read.into_iter().find(continuous) {
            let name = model.place_name(place);
            refused.push(Refused::at(association.mark, format!("it reads `{name}`, which the CASE form switches off with the transition already: use the form of flip-flops")));
        }
        of_bodies(model, association, role, refused);
    }
    events(model, refused);
}

/// Where the evolution comes first, what is continuous comes last in its scan. In an `sfc` it reads what was there before the actions of that scan.
pub(super) fn evolving(model: &Model, refused: &mut Vec<Refused>) {
    if model.is_grafcet() {
        return;
    }
    let runs = |step: StepId, wanted: &dyn Fn(Role) -> bool| -> Vec<Place> {
        let all = model.steps[step].associations.iter().map(|id| &model.associations[*id]);
        let fitting = all.filter(|association| role(model, association).is_ok_and(wanted));
        fitting.flat_map(|association| association.effect.writes().to_vec()).collect()
    };
    for association in model.associations.values() {
        let Ok(Role::Continuous(_)) = role(model, association) else { continue };
        let mut read = reads(&association.effect);
        read.extend(association.condition.iter().flat_map(|condition| places(&condition.tree)));
        let mut written = runs(association.step, &|role| !matches!(role, Role::Continuous(_)));
        for id in &model.entering[association.step.index()] {
            let transition = &model.transitions[*id];
            written.extend(transition.clearing.iter().flat_map(|effect| effect.writes().to_vec()));
            for from in &transition.sources {
                written.extend(runs(*from, &|role| matches!(role, Role::Event | Role::Deactivation | Role::Body)));
            }
        }
        if let Some(place) = read.into_iter().find(|place| written.contains(place)) {
            let name = model.place_name(place);
            refused.push(Refused::at(association.mark, format!("it reads `{name}` as it was before another action of the same scan writes it, which a CASE that evolves first cannot: let it act first, or use the form of flip-flops")));
        }
    }
}

/// A value that follows what runs in each scan.
fn of_bodies(model: &Model, association: &Association, role: Role, refused: &mut Vec<Refused>) {
    if !matches!(role, Role::Continuous(_)) {
        return;
    }
    let read = reads(&association.effect);
    let beside = model.steps[association.step].associations.iter().map(|id| &model.associations[*id]);
    let bodies = beside.filter(|other| crate::st::action::role(model, other).ok() == Some(Role::Body));
    if let Some(place) = bodies.flat_map(|body| body.effect.writes()).find(|place| read.contains(place)) {
        let name = model.place_name(*place);
        refused.push(Refused::at(association.mark, format!("it shows `{name}` while that changes in each scan, which the CASE form shows one scan later: use the form of flip-flops")));
    }
}

/// A condition that reads what an action on an event writes in the same evolution.
fn events(model: &Model, refused: &mut Vec<Refused>) {
    for association in model.associations.values() {
        if role(model, association).ok() != Some(Role::Event) {
            continue;
        }
        let leaving = model.leaving[association.step.index()].iter().map(|id| &model.transitions[*id]);
        for transition in leaving {
            let read = places(&transition.condition.tree);
            if let Some(place) = association.effect.writes().iter().find(|place| read.contains(place)) {
                let name = model.place_name(*place);
                refused.push(Refused::at(transition.mark, format!("it reads `{name}` as it was before the action on an event, which the CASE form cannot: use the form of flip-flops")));
            }
        }
    }
}

/// What runs at one moment: with each transition, and in each step.
fn lists(model: &Model) -> Vec<Vec<Run>> {
    let of = |step: StepId, wanted: &dyn Fn(Role) -> bool| {
        let ids = &model.steps[step].associations;
        let all = ids.iter().map(|id| &model.associations[*id]);
        let fitting = all.filter(|association| role(model, association).is_ok_and(wanted));
        fitting.map(|association| run(model, association)).collect::<Vec<Run>>()
    };
    let enters = |step: StepId| {
        let mut list = of(step, &|role| role == Role::Activation);
        list.extend(of(step, &|role| matches!(role, Role::Set(_))));
        list.extend(of(step, &|role| matches!(role, Role::Reset(_))));
        list.extend(of(step, &|role| matches!(role, Role::Body)));
        list
    };
    let mut lists: Vec<Vec<Run>> = model.steps.ids().map(enters).collect();
    for transition in model.transitions.values() {
        let (Some(from), Some(to)) = (transition.sources.first(), transition.targets.first()) else { continue };
        let mut list = of(*from, &|role| role == Role::Event);
        list.extend(of(*from, &|role| matches!(role, Role::Deactivation | Role::Body)));
        for effect in &transition.clearing {
            list.push(Run { before: reads(effect), writes: effect.writes().to_vec(), mark: transition.mark });
        }
        list.extend(enters(*to));
        lists.push(list);
    }
    lists
}

fn run(model: &Model, association: &Association) -> Run {
    // In an `sfc` a variable that one action writes the next one sees; an output it does not.
    let old = |place: &Place| model.is_grafcet() || matches!(place, Place::Output(_));
    let mut before: Vec<Place> = reads(&association.effect).into_iter().filter(old).collect();
    let conditions = association.condition.iter().chain(&association.event);
    before.extend(conditions.flat_map(|condition| places(&condition.tree)));
    Run { before, writes: association.effect.writes().to_vec(), mark: association.mark }
}
