//! `unreachable_step`, `dead_transition`: what the chart never comes to.
//!
//! One cause gives one message. A step that would be reached if a transition that never clears did is not reported beside
//! that transition, and neither are the transitions that leave a step which is never active. Of an AND-convergence whose
//! sources are never together, and where something waits for it, `stuck_join` says what is wrong.

use super::waits;
use crate::analysis::explore::{Exploration, Stay, StuckJoin};
use crate::analysis::{Concurrency, Dead, Explained};
use crate::diagnostic::{Mark, Rule, Severity, Sink, rules};
use crate::list::List;
use crate::model::{Blinker, Dialect, Id, Model, Step, StepId, Transition, TransitionId};
use crate::sorted::Set;

/// `said` are the transitions of which it has been said that they never clear; `structure` is that of independent partial grafcets.
pub(super) fn check(
    model: &Model,
    (structure, exploration): (&Concurrency, &Exploration),
    dead: &Dead<'_>,
    said: &Set<TransitionId>,
    told: &mut Explained,
    sink: &mut Sink,
) {
    told.transitions.extend(said);
    for id in &dead.lost {
        let step = &model.steps[*id];
        let forced = step.initial && model.partials[step.partial].enclosed_by.is_none();
        let message = match dead.beaten(*id, said) {
            _ if !dead.is_drawn(*id) => unreachable(model, *id),
            Some(arc) => never_wins(model, step, arc),
            None if forced => {
                format!("step `{}` is never active: an order forces its partial grafcet from the start", step.name)
            }
            None => continue,
        };
        told.steps.insert(*id);
        sink.rule(&rules::UNREACHABLE_STEP, &model.levels_of(step), vec![(Mark::from(&step.name), message)]);
    }
    // Of a convergence for which something waits `stuck_join` says what is wrong, if the chart wants to see that.
    let waits = |stuck: &&StuckJoin| stuck.culprit.is_some() || says_enough(model, exploration, stuck);
    let waiting: Set<TransitionId> = exploration.stuck_joins().iter().filter(waits).map(|stuck| stuck.join).collect();
    let alternatives: Set<TransitionId> = exploration.stuck_joins().iter().map(|stuck| stuck.join).collect();
    // One whose sources never meet as the chart is drawn does not follow from anything else.
    let others_dead = |join: &TransitionId| {
        alternatives.contains(join)
            && structure.can_clear(*join)
            && dead.idle.iter().any(|id| id != join && !alternatives.contains(id))
    };
    let follow = dead.follow_ups(said);
    let mut anys = Set::new();
    for id in &dead.idle {
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
    loudness >= dead && !exploration.in_contention(model, stuck)
}

/// Reports a transition that never clears.
pub(super) fn dead_transition(model: &Model, exploration: &Exploration, id: TransitionId, sink: &mut Sink) {
    let transition = &model.transitions[id];
    let message =
        if exploration.is_enabled(id) { never_holds(model, transition) } else { never_enabled(model, transition) };
    let scopes = model.levels_of_transition(transition);
    sink.rule(&rules::DEAD_TRANSITION, &scopes, vec![(transition.mark, message)]);
}

fn unreachable(model: &Model, id: StepId) -> String {
    let name = &model.steps[id].name;
    let mut arcs = model.entering[id.index()].iter().map(|arc| &model.transitions[*arc]);
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
    format!("`{}`", model.steps_text(steps))
}
