//! What depends on the order in which actions run in one scan: the standard leaves it open, so no chart is exported that needs one.

use std::collections::BTreeSet;

use grafcet_compiler::analysis::Facts;
use grafcet_compiler::model::{Association, Effect, Id, Model, Place, Qualifier, StepId, TimeRef};

use crate::Refused;
use crate::st::action::{places, reads};

/// An association as what may run, beside others, in a scan.
struct Runs<'m> {
    association: &'m Association,
    writes: Vec<Place>,
    reads: BTreeSet<Place>,
}

impl<'m> Runs<'m> {
    fn of(association: &'m Association) -> Self {
        let mut read: BTreeSet<Place> = reads(&association.effect).into_iter().collect();
        read.extend(association.condition.iter().flat_map(|condition| places(&condition.tree)));
        if let Some(TimeRef::Var(id)) = association.time {
            read.insert(Place::Var(id));
        }
        Self { association, writes: association.effect.writes().to_vec(), reads: read }
    }

    /// When its step is entered, or later.
    fn begins(&self) -> bool {
        self.association.qualifier != Qualifier::P0
    }

    /// When its step is left, or a timer acts that has nothing to do with that.
    fn ends(&self) -> bool {
        self.association.qualifier != Qualifier::P1
    }

    /// At a time that no step tells.
    fn at_any_time(&self) -> bool {
        self.association.qualifier.has_time()
    }

    /// The place that one action stands for, however many steps it belongs to.
    fn controlled(&self) -> Option<Place> {
        match &self.association.effect {
            Effect::Control(place) => Some(*place),
            Effect::Assign(place @ Place::Output(_), _) if self.association.qualifier == Qualifier::N => Some(*place),
            _ => None,
        }
    }

    /// A place that one of both writes and the other one reads or writes.
    fn depends(&self, other: &Self) -> Option<Place> {
        let touches = |runs: &Self, place: &Place| runs.writes.contains(place) || runs.reads.contains(place);
        let mine = self.writes.iter().find(|place| touches(other, place));
        mine.or_else(|| other.writes.iter().find(|place| touches(self, place))).copied()
    }
}

/// Pairs of actions of which the one that comes first decides about a value.
pub(super) fn refused(model: &Model) -> Vec<Refused> {
    let facts = Facts::of(model);
    let all: Vec<Runs<'_>> = model.associations.values().map(Runs::of).collect();
    let mut refused = Vec::new();
    for (index, later) in all.iter().enumerate() {
        for earlier in &all[..index] {
            if later.controlled().is_some() && later.controlled() == earlier.controlled() {
                continue;
            }
            let Some(place) = earlier.depends(later) else { continue };
            if meet(model, &facts, earlier, later) {
                let name = model.place_name(place);
                let first = &model.steps[earlier.association.step].name;
                let second = &model.steps[later.association.step].name;
                let of = if first == second {
                    format!("two actions of `{first}`")
                } else {
                    format!("an action of `{first}` and this one of `{second}`")
                };
                let message = format!(
                    "`{name}` depends on which of {of} runs first in a scan, which IEC 61131-3 leaves open: write both as one block, or let a step stand between them"
                );
                refused.push(Refused::at(later.association.mark, message));
            }
        }
    }
    refused
}

/// Whether both may act in one scan.
fn meet(model: &Model, facts: &Facts<'_>, a: &Runs<'_>, b: &Runs<'_>) -> bool {
    let (one, other) = (a.association.step, b.association.step);
    if a.at_any_time() || b.at_any_time() || one != other && facts.concurrency.together(one, other) {
        return true;
    }
    if one == other {
        let both = [a.association.qualifier, b.association.qualifier];
        let begins_and_ends = both.contains(&Qualifier::P1) && both.contains(&Qualifier::P0);
        return !begins_and_ends || leads(model, one, one);
    }
    a.ends() && b.begins() && leads(model, one, other) || b.ends() && a.begins() && leads(model, other, one)
}

fn leads(model: &Model, from: StepId, to: StepId) -> bool {
    model.leaving[from.index()].iter().any(|id| model.transitions[*id].targets.contains(&to))
}
