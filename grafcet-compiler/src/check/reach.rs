//! `unreachable_step`, `dead_transition`: what the chart never comes to.
//!
//! One cause gives one message. A step that would be reached if a transition that never clears did is not reported beside
//! that transition, and neither are the transitions that leave a step which is never active. Of an AND-convergence whose
//! sources are never together, and where something waits for it, `stuck_join` says what is wrong.

use super::silent::Told;
use super::waits;
use crate::analysis::Concurrency;
use crate::analysis::explore::{Exploration, Stay, StuckJoin, situation};
use crate::analysis::hierarchy::initial_situation;
use crate::diagnostic::{Mark, Rule, Severity, Sink, rules};
use crate::list::List;
use crate::model::{Blinker, Dialect, ForceOrder, Id, Model, Step, StepId, Transition, TransitionId};
use crate::sorted::Set;

/// Reports, and returns the transitions that never clear although their sources can be active.
/// `said` are those of which it has been said that they never clear; `concurrency` is that of independent partial grafcets.
pub(super) fn check(
    model: &Model,
    concurrency: &Concurrency,
    exploration: &Exploration,
    said: &Set<TransitionId>,
    told: &mut Told,
    sink: &mut Sink,
) -> Set<TransitionId> {
    told.transitions.extend(said);
    let drawn = drawn(model);
    for (id, step) in model.steps.iter().filter(|(id, _)| !exploration.reachable(*id) && !drawn[id.index()]) {
        let scopes = model.levels_of(step);
        let message = unreachable(model, id);
        told.steps.insert(id);
        sink.rule(&rules::UNREACHABLE_STEP, &scopes, vec![(Mark::from(&step.name), message)]);
    }
    let dead = idle(model, exploration);
    for (id, step) in model.steps.iter().filter(|(id, _)| !exploration.reachable(*id) && drawn[id.index()]) {
        let open = |arc: TransitionId| {
            let sources = &model.transitions[arc].sources;
            !dead.contains(&arc) && !said.contains(&arc) && sources.iter().all(|source| exploration.reachable(*source))
        };
        let beaten = model.transitions.iter().find(|(arc, transition)| transition.targets.contains(&id) && open(*arc));
        let forced = step.initial && model.partials[step.partial].enclosed_by.is_none();
        let message = match beaten {
            Some((_, arc)) => never_wins(model, step, arc),
            None if forced => {
                format!("step `{}` is never active: an order forces its partial grafcet from the start", step.name)
            }
            None => continue,
        };
        told.steps.insert(id);
        sink.rule(&rules::UNREACHABLE_STEP, &model.levels_of(step), vec![(Mark::from(&step.name), message)]);
    }
    // Of a convergence for which something waits `stuck_join` says what is wrong, if the chart wants to see that.
    let waits = |stuck: &&StuckJoin| stuck.culprit.is_some() || says_enough(model, exploration, stuck);
    let waiting: Set<TransitionId> = exploration.stuck_joins().iter().filter(waits).map(|stuck| stuck.join).collect();
    let alternatives: Set<TransitionId> = exploration.stuck_joins().iter().map(|stuck| stuck.join).collect();
    // One whose sources never meet as the chart is drawn does not follow from anything else.
    let others_dead = |join: &TransitionId| {
        alternatives.contains(join)
            && concurrency.can_clear(*join)
            && dead.iter().any(|id| id != join && !alternatives.contains(id))
    };
    let mut follow = follow_ups(model, exploration, &dead);
    if !said.is_empty() && dead.iter().any(|id| exploration.is_barred(*id)) {
        let otherwise = concurrency.across_partials_but_for(model, said);
        follow.extend(dead.iter().filter(|id| exploration.is_barred(**id) && otherwise.can_clear(**id)));
    }
    let mut anys = Set::new();
    for id in &dead {
        if model.transitions[*id].any.is_some_and(|any| !anys.insert(any)) {
            told.transitions.insert(*id);
            continue;
        }
        if waiting.contains(id) || others_dead(id) || said.contains(id) || follow.contains(id) {
            continue;
        }
        told.transitions.insert(*id);
        dead_transition(model, exploration, *id, sink);
    }
    dead
}

/// Where a transition that never clears would lead on, of which an error tells.
pub(super) fn dead_ends(model: &Model, dead: &Set<TransitionId>, sink: &Sink) -> Vec<Stay> {
    if !sink.has_dead_ends() {
        return Vec::new();
    }
    let is_error = |id: &&TransitionId| {
        let scopes = model.levels_of_transition(&model.transitions[**id]);
        let of = |rule: &Rule| rule.severity_in(model.dialect, &scopes) == Severity::Deny;
        of(&rules::DEAD_TRANSITION) && of(&rules::NEVER_TRUE) && of(&rules::SHADOWED_BRANCH)
    };
    let stay = |id: &TransitionId| Stay { active: model.transitions[*id].sources.clone(), within: None };
    dead.iter().filter(is_error).map(stay).list()
}

/// Whether what `stuck_join` says of a convergence that never clears makes `dead_transition` superfluous: it is as loud.
fn says_enough(model: &Model, exploration: &Exploration, stuck: &StuckJoin) -> bool {
    let join = &model.transitions[stuck.join];
    let dead = rules::DEAD_TRANSITION.severity_in(model.dialect, &model.levels_of_transition(join));
    let loudness = rules::STUCK_JOIN.severity_in(model.dialect, &waits::levels(model, stuck));
    loudness >= dead && !waits::in_contention(model, exploration, stuck)
}

/// Reports a transition that never clears.
pub(super) fn dead_transition(model: &Model, exploration: &Exploration, id: TransitionId, sink: &mut Sink) {
    let transition = &model.transitions[id];
    let message =
        if exploration.is_enabled(id) { never_holds(model, transition) } else { never_enabled(model, transition) };
    let scopes = model.levels_of_transition(transition);
    sink.rule(&rules::DEAD_TRANSITION, &scopes, vec![(transition.mark, message)]);
}

/// The steps that the condition of a transition reads.
pub(super) fn read_steps(model: &Model, id: TransitionId) -> impl Iterator<Item = StepId> + '_ {
    let reads = model.transitions[id].condition.reads.iter();
    reads.flat_map(|read| match read.about() {
        Some(Blinker::Step(step)) => vec![step],
        Some(Blinker::Macro(id)) => model.macros[id].steps.clone(),
        None => Vec::new(),
    })
}

/// The dead transitions that only wait for steps which other dead ones lead to.
fn follow_ups(model: &Model, exploration: &Exploration, dead: &Set<TransitionId>) -> Set<TransitionId> {
    let waits_for = |id: &TransitionId| -> Vec<StepId> {
        read_steps(model, *id).filter(|step| !exploration.reachable(*step)).list()
    };
    let mut open: Vec<(TransitionId, Vec<StepId>)> = dead.iter().map(|id| (*id, waits_for(id))).list();
    let mut waiting = vec![false; model.transitions.len()];
    for (id, _) in open.iter().filter(|(_, waits)| !waits.is_empty()) {
        waiting[id.index()] = true;
    }
    let mut behind = vec![false; model.steps.len()];
    let mut follow = Set::new();
    let causes = open.iter().filter(|(_, waits)| waits.is_empty());
    let mut work: Vec<StepId> = causes.flat_map(|(id, _)| model.transitions[*id].targets.iter().copied()).list();
    // Of steps to which no arrow leads it has been said.
    let drawn = drawn(model);
    work.extend(model.steps.ids().filter(|step| !drawn[step.index()]));
    while !work.is_empty() {
        while let Some(step) = work.pop() {
            if !std::mem::replace(&mut behind[step.index()], true) {
                // What waits itself leads on only where it follows.
                let onward = model.leaving[step.index()].iter().filter(|id| !waiting[id.index()]);
                work.extend(onward.flat_map(|id| &model.transitions[*id].targets));
            }
        }
        open.retain(|(id, waits)| {
            let follows = waits.iter().any(|step| behind[step.index()]);
            if follows {
                follow.insert(*id);
                waiting[id.index()] = false;
                work.extend(&model.transitions[*id].targets);
            }
            !follows
        });
    }
    follow
}

/// The transitions that never clear although their sources can be active.
pub(super) fn idle(model: &Model, exploration: &Exploration) -> Set<TransitionId> {
    let is_idle = |(id, transition): &(TransitionId, &Transition)| {
        !exploration.can_clear(*id) && transition.sources.iter().all(|source| exploration.reachable(*source))
    };
    // An `any` is idle where all of its transitions are.
    let mut clears = vec![false; model.anys.len()];
    for (id, transition) in model.transitions.iter() {
        if let Some(any) = transition.any {
            clears[any.index()] |= exploration.can_clear(id);
        }
    }
    let alone = |(_, transition): &(TransitionId, &Transition)| transition.any.is_none_or(|any| !clears[any.index()]);
    model.transitions.iter().filter(is_idle).filter(alone).map(|(id, _)| id).collect()
}

/// The steps to which arrows lead from where the chart starts, whatever the conditions.
fn drawn(model: &Model) -> Vec<bool> {
    let mut drawn = vec![false; model.steps.len()];
    let mut work: Vec<StepId> = initial_situation(model).into_iter().list();
    work.extend(model.steps.iter().filter(|(_, step)| step.linked).map(|(id, _)| id));
    for force in model.forces.values() {
        match &force.order {
            ForceOrder::Hold => {}
            ForceOrder::Steps(steps) => work.extend(steps),
            ForceOrder::Init => {
                let steps = model.partials[force.target].steps.iter();
                work.extend(steps.filter(|step| model.steps[**step].initial));
            }
        }
    }
    let mut missing: Vec<usize> = model.transitions.values().map(|transition| transition.sources.len()).list();
    for transition in model.transitions.values() {
        if transition.sources.is_empty() {
            work.extend(&transition.targets);
        }
    }
    while let Some(step) = work.pop() {
        if std::mem::replace(&mut drawn[step.index()], true) {
            continue;
        }
        for id in &model.leaving[step.index()] {
            missing[id.index()] -= 1;
            if missing[id.index()] == 0 {
                work.extend(&model.transitions[*id].targets);
            }
        }
    }
    drawn
}

fn unreachable(model: &Model, id: StepId) -> String {
    let name = &model.steps[id].name;
    let mut arcs = model.transitions.values().filter(|transition| transition.targets.contains(&id));
    match arcs.find(|transition| transition.sources != [id]) {
        None => format!(
            "step `{name}` is never active: no transition leads to it; draw one, `… -[x]-> {name}`, or delete the step"
        ),
        Some(arc) => format!(
            "step `{name}` is never active: nothing that leads to it, such as {}, is ever reached from where the chart starts; \
             draw the missing transition, or delete what is left over",
            named(model, &arc.sources)
        ),
    }
}

fn never_wins(model: &Model, step: &Step, arc: &Transition) -> String {
    let first = match model.dialect {
        Dialect::Sfc => "another one that comes first is cleared instead",
        Dialect::Grafcet => "an order or the end of its enclosing step comes first",
    };
    format!(
        "step `{}` is never active: whenever the transition from {} to it could clear, {first}; give it a condition under which \
         the others do not hold",
        step.name,
        named(model, &arc.sources)
    )
}

fn never_enabled(model: &Model, transition: &Transition) -> String {
    let sources = named(model, &transition.sources);
    if transition.sources.len() > 1 {
        format!(
            "this transition never clears: its sources {sources} are never all active together; parallel branches that meet \
             here must start together, `… -[x]-> (…, …)`"
        )
    } else {
        format!("this transition never clears: whenever {sources} is active, an order or an enclosing step holds it")
    }
}

fn never_holds(model: &Model, transition: &Transition) -> String {
    let (sources, text) = (named(model, &transition.sources), &transition.condition.text);
    let mut steps = transition.condition.reads.iter().filter_map(|read| match read.about()? {
        Blinker::Step(step) => Some(model.steps[step].name.to_string()),
        Blinker::Macro(id) => Some(model.macros[id].name.to_string()),
    });
    let why = match steps.next() {
        Some(step) => format!("; is `{step}` the step that is meant?"),
        None => "; what else it reads never has these values then".to_owned(),
    };
    if transition.sources.is_empty() {
        return format!("this transition never clears: `{text}` never holds{why}");
    }
    if transition.any.is_some() {
        return format!(
            "this transition never clears: `{text}` never holds while a step is active that it leaves{why}"
        );
    }
    format!("this transition never clears: `{text}` never holds while {sources} is active{why}")
}

/// `` `A` ``, `` `(A, B)` ``
fn named(model: &Model, steps: &[StepId]) -> String {
    format!("`{}`", situation(model, steps))
}
