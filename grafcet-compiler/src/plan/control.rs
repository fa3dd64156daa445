//! `sfc`: which targets the action control of IEC 61131-3 works on, and how much of it each of them needs (A31).
//!
//! Most actions need none of it: a boolean output under N, S, R and P is collected in the arms of its steps, and an
//! assignment or block under N, P1 or P0 runs in them. So is an output under L or D, where the time of its step says what
//! a timer would. What is left over gets a [`Target`]: its flags are collected first, then its Q is computed, then it
//! runs in its place.

use std::vec;

use crate::analysis::Concurrency;
use crate::list::List;
use crate::model::{Association, AssociationId, Dialect, Effect, Id, Model, Place, Qualifier, TimeRef};
use crate::sorted::{Map, Set};

/// A target whose associations are combined by the action control.
pub struct Target {
    pub what: What,
    /// In source order.
    pub associations: Vec<AssociationId>,
    /// The value of Q in the cycle before is remembered: something runs when it rises or falls.
    pub remembers_q: bool,
    /// Several associations that drive Q give arguments, so the one that acted last is remembered.
    pub remembers_association: bool,
    /// Associations whose condition in the cycle before is remembered: only what has held Q up ends it by leaving (A29).
    pub remembers_held: Vec<AssociationId>,
}

/// What a target is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum What {
    /// A boolean output or variable: it is Q.
    Boolean(Place),
    /// An action or an assignment or block of its own: it runs.
    Runs,
}

impl Target {
    /// Its associations under a qualifier.
    pub fn under<'t>(&'t self, model: &'t Model, qualifier: Qualifier) -> impl Iterator<Item = AssociationId> + 't {
        self.associations.iter().copied().filter(move |id| model.associations[*id].qualifier == qualifier)
    }

    /// Whether any association has the qualifier.
    #[must_use]
    pub fn has(&self, model: &Model, qualifier: Qualifier) -> bool {
        self.under(model, qualifier).next().is_some()
    }

    /// The qualifiers it has whose end can come from leaving a step.
    #[must_use]
    pub fn leavable(&self, model: &Model) -> Vec<Qualifier> {
        Qualifier::ALL.into_iter().filter(|qualifier| qualifier.is_continuous() && self.has(model, *qualifier)).list()
    }

    /// Which of them held in the cycle before does not follow from Q alone, so it is remembered.
    #[must_use]
    pub fn remembers_terms(&self, model: &Model) -> bool {
        let others = |id: &AssociationId| {
            let qualifier = model.associations[*id].qualifier;
            qualifier.drives_q() && !qualifier.is_continuous()
        };
        let leavable = self.leavable(model).len();
        leavable > 1 || leavable == 1 && self.associations.iter().any(others)
    }

    /// Whether several associations under the qualifier give arguments of their own: which of them acts is asked.
    #[must_use]
    pub fn chooses_under(&self, model: &Model, qualifier: Qualifier) -> bool {
        self.remembers_association && self.under(model, qualifier).count() > 1
    }

    /// Whether associations under a timed qualifier state different times, so that the last one is remembered.
    #[must_use]
    pub fn remembers_time(&self, model: &Model, qualifier: Qualifier) -> bool {
        let mut times = self.under(model, qualifier).map(|id| model.associations[id].time);
        let first = times.next();
        times.any(|time| Some(time) != first)
    }
}

/// The targets of a chart and who belongs to them.
pub struct Control {
    pub targets: Vec<Target>,
    /// Per association, its target; `None` where its step's arm does it all.
    pub of_association: Vec<Option<usize>>,
}

impl Control {
    /// The time of an association under L or D that is compared with the time of its step (A32; in an `sfc` where that is
    /// what its timer would say).
    #[must_use]
    pub fn step_limit(&self, model: &Model, id: AssociationId) -> Option<TimeRef> {
        model.associations[id].time.filter(|_| self.of_association[id.index()].is_none())
    }

    pub(super) fn of(model: &Model, concurrency: &Concurrency) -> Self {
        let mut control = Self { targets: Vec::new(), of_association: vec![None; model.associations.len()] };
        if model.dialect != Dialect::Sfc {
            return control;
        }
        let mut numbers: Map<Key, usize> = Map::new();
        let simple = simple_outputs(model);
        for id in source_order(model) {
            let association = &model.associations[id];
            let key = key(id, &association.effect);
            if is_local(&simple, association) {
                continue;
            }
            let target = *numbers.or_insert_with(key, || {
                let what = match association.effect {
                    Effect::Control(place) => What::Boolean(place),
                    _ => What::Runs,
                };
                let associations = Vec::new();
                control.targets.push(Target {
                    what,
                    associations,
                    remembers_q: false,
                    remembers_association: false,
                    remembers_held: Vec::new(),
                });
                control.targets.len() - 1
            });
            control.targets[target].associations.push(id);
            control.of_association[id.index()] = Some(target);
        }
        for target in &mut control.targets {
            target.remembers_q = target.what == What::Runs && has_q(model, target);
            target.remembers_association = remembers_association(model, target);
            target.remembers_held = remembers_held(model, concurrency, target);
        }
        control
    }
}

/// All associations, by step and then as they stand in it.
///
/// A list: what is done with it need not be compiled for the steps and for their associations each time.
#[must_use]
pub fn source_order(model: &Model) -> vec::IntoIter<AssociationId> {
    let mut all = Vec::new();
    for step in model.steps.values() {
        all.extend_from_slice(&step.associations);
    }
    all.into_iter()
}

/// What makes two associations one target.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Place(Place),
    Action(usize),
    Own(AssociationId),
}

fn key(id: AssociationId, effect: &Effect) -> Key {
    match effect {
        Effect::Control(place) => Key::Place(*place),
        Effect::Call(action, _) => Key::Action(action.index()),
        Effect::Assign(..) | Effect::Block(_) => Key::Own(id),
    }
}

/// By output, whether it is controlled by no other qualifiers than N, S, R and P, and by L and D once each.
fn simple_outputs(model: &Model) -> Vec<bool> {
    let mut simple = vec![true; model.outputs.len()];
    let mut timed: Set<(usize, Qualifier)> = Set::new();
    for association in model.associations.values() {
        if let Effect::Control(Place::Output(output)) = association.effect {
            simple[output.index()] &= match association.qualifier {
                Qualifier::N | Qualifier::S | Qualifier::R | Qualifier::P => true,
                // The timer of a single step without a condition runs as long as the step is active. Several steps have
                // one timer, which goes on from step to step.
                qualifier @ (Qualifier::L | Qualifier::D) => {
                    association.condition.is_none() && timed.insert((output.index(), qualifier))
                }
                _ => false,
            };
        }
    }
    simple
}

/// Whether the arms of the step do it all.
fn is_local(simple: &[bool], association: &Association) -> bool {
    match &association.effect {
        Effect::Control(Place::Output(output)) => simple[output.index()],
        Effect::Assign(Place::Output(_), _) if association.qualifier == Qualifier::N => true,
        Effect::Assign(..) | Effect::Block(_) => {
            association.qualifier.runs_once()
                || association.qualifier == Qualifier::N && association.condition.is_none()
        }
        _ => false,
    }
}

/// Whether anything but single runs (P1, P0) and resets belongs to the target.
fn has_q(model: &Model, target: &Target) -> bool {
    target.associations.iter().any(|id| model.associations[*id].qualifier.drives_q())
}

fn remembers_association(model: &Model, target: &Target) -> bool {
    let with_arguments = |id: &&AssociationId| {
        let association = &model.associations[**id];
        association.qualifier.drives_q()
            && matches!(&association.effect, Effect::Call(_, arguments) if !arguments.is_empty())
    };
    target.associations.iter().filter(with_arguments).count() > 1
}

/// Beside another step of the same qualifier, a step that is left need not be the one whose condition held.
fn remembers_held(model: &Model, concurrency: &Concurrency, target: &Target) -> Vec<AssociationId> {
    if !target.remembers_q {
        return Vec::new();
    }
    let leavable = |id: &AssociationId| {
        let association = &model.associations[*id];
        let beside = |other: AssociationId| concurrency.together(association.step, model.associations[other].step);
        association.qualifier.is_continuous()
            && association.condition.is_some()
            && target.under(model, association.qualifier).any(beside)
    };
    target.associations.iter().copied().filter(leavable).list()
}
