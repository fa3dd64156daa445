//! `grafcet`: the stored actions of one evolution (A5-A7, A12, A33, A36).

use std::collections::{BTreeMap, BTreeSet};

use super::value::{Error, Value};
use super::view::{Situation, View};
use super::{Call, Phase, arguments};
use grafcet_compiler::model::{Association, AssociationId, Effect, Place, Qualifier, TransitionId};

/// What the stored actions of one evolution do together.
#[derive(Default)]
pub(super) struct Outcome {
    /// The values to commit (A6).
    pub(super) writes: BTreeMap<Place, Value>,
    /// The calls that run with the evolution (A33).
    pub(super) calls: Vec<Call>,
    /// The associations that ran.
    pub(super) ran: Vec<AssociationId>,
}

/// Runs the stored actions of an evolution from the situation of `view` to `after`.
///
/// All conditions, events, arguments and right-hand sides see `view`, the snapshot from before the evolution (A5), so that
/// the steps being left are still active in it and their times are those they had reached (A34). Source order is that of
/// the associations, then that of the transitions with clearing actions.
pub(super) fn actions(view: &View<'_>, after: &Situation, cleared: &BTreeSet<TransitionId>) -> Result<Outcome, Error> {
    let mut outcome = Outcome::default();
    for (id, association) in view.model.associations.iter() {
        let condition = || association.condition.as_ref().map_or(Ok(true), |c| view.holds(&c.tree));
        if occurs(association, view, after)? && condition()? {
            outcome.ran.push(id);
            stored(association, view, &mut outcome)?;
        }
    }
    let mut anys = BTreeSet::new();
    for transition in cleared {
        // What an `any` does is done once, whatever it leaves.
        let any = view.model.transitions[*transition].any;
        if any.is_some_and(|any| !anys.insert(any)) {
            continue;
        }
        for effect in &view.model.transitions[*transition].clearing {
            perform(effect, view, &mut outcome)?;
        }
    }
    Ok(outcome)
}

/// Whether the event of a stored action occurs in this evolution. A12: forcing raises the same events.
fn occurs(association: &Association, view: &View<'_>, after: &Situation) -> Result<bool, Error> {
    use Qualifier::{D, Ds, L, N, On, P, P0, P1, R, S, Sd, Sl};
    let (was, is) = (view.situation.contains(&association.step), after.contains(&association.step));
    match association.qualifier {
        S | R | P1 => Ok(!was && is),
        P0 => Ok(was && !is),
        // A36: an action on event runs if its step was active before the evolution.
        On => match &association.event {
            Some(event) => Ok(was && view.holds(&event.tree)?),
            None => Ok(false),
        },
        N | L | D | P | Sd | Ds | Sl => Ok(false),
    }
}

fn stored(association: &Association, view: &View<'_>, outcome: &mut Outcome) -> Result<(), Error> {
    match (association.qualifier, &association.effect) {
        (Qualifier::S, Effect::Control(place)) => drop(outcome.writes.insert(*place, Value::Bool(true))),
        (Qualifier::R, Effect::Control(place)) => drop(outcome.writes.insert(*place, Value::Bool(false))),
        (_, effect) => perform(effect, view, outcome)?,
    }
    Ok(())
}

/// Where several actions of one evolution write one place (`write_race`, A7, allowed), the last in the source wins.
fn perform(effect: &Effect, view: &View<'_>, outcome: &mut Outcome) -> Result<(), Error> {
    match effect {
        Effect::Control(_) => {}
        Effect::Assign(place, value) => {
            outcome.writes.insert(*place, view.value_for(*place, &value.tree)?);
        }
        Effect::Call(action, args) => {
            let args = arguments(*action, args, view)?;
            outcome.calls.push(Call { action: *action, phase: Phase::First, args });
        }
        // A33: a block sees its own writes and otherwise the values from before the evolution.
        Effect::Block(code) => outcome.writes.extend(view.code(code)?),
    }
    Ok(())
}
