//! Regions that have no more states together than they have steps share one place.
//!
//! ```text
//! match state.Ready                     match state.Ready
//!   Ready:                                Stopped: …
//!     if stop:                            else:
//!       state.Ready = Stopped               if stop:
//!       state.Manual = none       ->          state.Ready = Stopped
//!     else:                                 else:
//!       match state.Manual                    match state.Ready
//!         Manual: …                             Manual: …
//!         Auto: …                               Auto: …
//!   Stopped: …
//! ```
//!
//! An emergency stop leaves no mode, and production is within one of the modes: who writes that by hand has one state for all. Each state is named after a
//! step that is active in it.
//!
//! Needs: which states meet is known; each way that writes these states leads to one state, or takes all of them back to what they were when they were copied; they are asked for as steps alone.

mod walk;

use super::super::united::United;
use super::super::{Initial, Meeting, PlaceId, Program, Role, Statement, Type, Value};
use super::dead::drop_places;
use super::edits::remove;
use super::uses::Effects;
use crate::model::{Id, StepId};
use crate::sorted::{Map, Set, sort_by_key, sort_unstable};

use walk::JointWalk;

/// The states of some regions, in their order.
type Joint = Vec<Value>;

pub(super) fn pass(program: &mut Program<'_>) {
    // Where each step has a bit, there is nothing to share.
    if program.meetings.is_empty() || program.model.flags {
        return;
    }
    let mut groups: Vec<(Vec<usize>, Option<Names>)> = Vec::new();
    groups.extend((0..program.regions.len()).map(|region| (vec![region], None)));
    for second in 1..program.regions.len() {
        for first in 0..second {
            let group = |region| groups.iter().position(|(regions, _)| regions.contains(&region));
            let (Some(one), Some(other)) = (group(first), group(second)) else { continue };
            let mut both = groups[one].0.clone();
            both.extend(&groups[other].0);
            sort_unstable(&mut both);
            let names = (one != other).then(|| Group::of(program, both.clone())?.names(program)).flatten();
            if names.is_some() {
                groups[one] = (both, names);
                groups.remove(other);
            }
        }
    }
    for (regions, names) in groups {
        let Some(names) = names else { continue };
        let Some(group) = Group::of(program, regions) else { continue };
        if let Some(walked) = JointWalk::through(&group, program, Some(&names)) {
            group.unite(program, walked.cycle, &names);
        }
    }
    drop_places(program);
}

/// Regions that may be united.
struct Group {
    regions: Vec<usize>,
    /// Where they have their states.
    places: Vec<PlaceId>,
    /// Where a state is kept as it was, for a while, and of which of them.
    copies: Vec<(PlaceId, usize)>,
    /// What they begin with, as it is stored.
    begin: Joint,
    /// What they are before and after each evolution.
    rest: Vec<Joint>,
}

/// The state of one place for the states of several.
type Names = Map<Joint, Value>;

impl Group {
    /// If they have few states together.
    fn of(program: &Program<'_>, regions: Vec<usize>) -> Option<Self> {
        let (mut places, mut begin) = (Vec::new(), Vec::new());
        for region in &regions {
            let place = program.place(Role::State(*region))?;
            let Initial::Value(value) = program.places[place.0].initial else { return None };
            places.push(place);
            begin.push(value);
        }
        let steps = regions.iter().map(|region| program.regions[*region].len()).sum();
        let mut rest = Vec::new();
        together(program, &regions, &mut Vec::new(), &mut rest, steps)?;
        let mut copies = Vec::new();
        for (at, place) in program.places.iter().enumerate() {
            let Type::State(region) = place.ty else { continue };
            let copy = regions.iter().position(|one| *one == region).filter(|_| !places.contains(&PlaceId(at)));
            if place.is_field && copy.is_some() {
                return None;
            }
            copies.extend(copy.map(|side| (PlaceId(at), side)));
        }
        Some(Self { regions, places, copies, begin, rest })
    }

    /// Of which region a place keeps the state.
    fn copy(&self, place: PlaceId) -> Option<usize> {
        self.copies.iter().find(|(copy, _)| *copy == place).map(|(_, side)| *side)
    }

    fn is_start(joint: &Joint) -> bool {
        joint.iter().any(|state| matches!(state, Value::Start(_)))
    }

    /// A state by name for each that one place for all has to tell, if the cycle can do with it.
    fn names(&self, program: &Program<'_>) -> Option<Names> {
        let mut met = JointWalk::through(self, program, None)?.met;
        let start: Vec<Joint> = met.iter().filter(|joint| Self::is_start(joint)).cloned().collect();
        let seen = shown(&self.begin);
        met.retain(|joint| !Self::is_start(joint));
        met.insert(seen.clone());
        let mut names = named(&met)?;
        match &start[..] {
            [] => {}
            [start] => {
                let Some(Value::Step(step)) = names.get(&seen).copied() else { return None };
                names.insert(start.clone(), Value::Start(step));
            }
            _ => return None,
        }
        Some(names)
    }

    fn unite<'m>(&self, program: &mut Program<'m>, cycle: Vec<Statement<'m>>, names: &Names) {
        program.cycle = cycle;
        let read = Effects::of_all(&program.cycle).reads;
        let unread: Vec<PlaceId> =
            self.copies.iter().map(|(copy, _)| *copy).filter(|copy| !read.contains(copy)).collect();
        remove(&mut program.cycle, &|one| matches!(one, Statement::Set(place, _) if unread.contains(place)));
        super::without_empty(&mut program.cycle);
        if let Some(mut deadline) = program.deadline.take() {
            let walk = JointWalk::of(self, program, Some(names));
            let all = walk.anything();
            for expr in deadline.asks_mut() {
                *expr = walk.expr(expr, &all);
            }
            for (_, over) in &mut deadline.late {
                *over = walk.expr(over, &all);
            }
            program.deadline = Some(deadline);
        }
        let mut states = Vec::new();
        for (joint, name) in names {
            if let Value::Step(Some(step)) = name {
                states.push((*step, active(joint)));
            }
        }
        sort_by_key(&mut states, |(name, _)| *name);
        for place in &self.places[1..] {
            let unused = &mut program.places[place.0];
            (unused.role, unused.is_field, unused.initial) = (Role::Local, false, Initial::Value(Value::Step(None)));
        }
        if let Some(name) = names.get(&self.begin) {
            program.places[self.places[0].0].initial = Initial::Value(*name);
        }
        for (copy, _) in &self.copies {
            let copy = &mut program.places[copy.0];
            copy.ty = Type::State(self.regions[0]);
            copy.initial = Initial::Value(Value::Step(states.first().map(|(name, _)| *name)));
        }
        program.united.push(United { regions: self.regions.clone(), states });
    }
}

/// Of several copies that tell the same, those that nobody reads any more are not made.
/// The states that regions may have at the same time, if there are no more than so many and one in which none of them has a step.
fn together(
    program: &Program<'_>,
    regions: &[usize],
    here: &mut Vec<Option<StepId>>,
    all: &mut Vec<Joint>,
    most: usize,
) -> Option<()> {
    let Some(region) = regions.get(here.len()) else {
        all.push(here.iter().map(|state| Value::Step(*state)).collect());
        return (all.len() <= most + 1).then_some(());
    };
    let mut states: Vec<Option<StepId>> = program.regions[*region].iter().map(|step| Some(*step)).collect();
    if !program.full[*region] {
        states.push(None);
    }
    for state in states {
        let meets = |(at, other): (usize, &Option<StepId>)| {
            let beside = match (state, other) {
                (Some(step), Some(other)) => program.beside.contains(step.index(), other.index()),
                _ => true,
            };
            let allowed = |meeting: &Meeting| meeting.allows((regions[at], *other), (*region, state));
            beside && program.meetings.iter().all(allowed)
        };
        if here.iter().enumerate().all(meets) {
            here.push(state);
            together(program, regions, here, all, most)?;
            here.pop();
        }
    }
    Some(())
}

/// What is seen from outside before the first cycle.
fn shown(joint: &Joint) -> Joint {
    let mut seen = joint.clone();
    for state in &mut seen {
        if let Value::Start(step) = state {
            *state = Value::Step(*step);
        }
    }
    seen
}

fn active(joint: &Joint) -> Vec<StepId> {
    let mut steps = Vec::new();
    for state in joint {
        if let Value::Step(Some(step)) = state {
            steps.push(*step);
        }
    }
    steps
}

/// Each after a step that is active in it alone, or after which no other one is named: none, where there are not enough.
fn named(met: &Set<Joint>) -> Option<Names> {
    let all: Vec<&Joint> = met.iter().collect();
    let mut owners: Map<StepId, usize> = Map::default();
    let is_alone = |step: &StepId| met.iter().filter(|joint| active(joint).contains(step)).count() == 1;
    for (at, joint) in all.iter().enumerate() {
        if let Some(step) = active(joint).into_iter().rev().find(is_alone) {
            owners.insert(step, at);
        }
    }
    for (at, joint) in all.iter().enumerate() {
        let has_name = owners.values().any(|owner| *owner == at);
        if !has_name && !active(joint).is_empty() && !find(&all, at, &mut owners, &mut Set::new()) {
            return None;
        }
    }
    let mut names = Names::default();
    for joint in &all {
        names.insert((*joint).clone(), Value::Step(None));
    }
    for (step, at) in &owners {
        names.insert(all[*at].clone(), Value::Step(Some(*step)));
    }
    Some(names)
}

/// A step for one of them, the innermost first; who has it already may find another one.
fn find(all: &[&Joint], at: usize, owners: &mut Map<StepId, usize>, tried: &mut Set<StepId>) -> bool {
    for step in active(all[at]).into_iter().rev() {
        if tried.insert(step) && owners.get(&step).copied().is_none_or(|other| find(all, other, owners, tried)) {
            owners.insert(step, at);
            return true;
        }
    }
    false
}
