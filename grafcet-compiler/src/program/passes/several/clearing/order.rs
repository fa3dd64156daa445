//! In which order transitions are looked at, and what stands for each.

use std::cell::RefCell;

use super::super::Several;
use super::sorted::denied;
use super::{Asking, Clearing, Told, parts};
use crate::list::List;
use crate::model::StepId;
use crate::program::build::{all, yes};
use crate::program::passes::edits::replaced;
use crate::program::passes::fold::{Known, excludes};
use crate::program::passes::share::merged;
use crate::program::{Expr, PlaceId, Statement, Value};
use crate::sorted::Set;

/// Transitions that ask for the same region, or one that asks for none.
pub(super) struct Group {
    region: Option<usize>,
    members: Vec<usize>,
}

/// What there is between a group and another one.
#[derive(Clone, Copy, Default)]
struct Between {
    /// It has to stand in front of the other one.
    is_before: bool,
    /// How often the other one asks for what this one may have written.
    disturbs: usize,
}

/// The transitions of a part, by the regions they ask for.
#[derive(Clone, Copy)]
pub(super) struct Groups<'c, 's, 'p, 'm> {
    pub(super) several: &'s Several<'p, 'm>,
    pub(super) clearings: &'c [Clearing<'m>],
    pub(super) asking: Asking,
}

impl Groups<'_, '_, '_, '_> {
    /// In an order in which each state is written last by whom it was, and few conditions ask for the state before.
    pub(super) fn ordered(self) -> Option<Vec<Group>> {
        let in_front = self.in_front();
        let mut groups = self.by_region();
        for group in &mut groups {
            group.members = sorted(&group.members, &in_front)?;
        }
        let between = self.between(&groups, &in_front);
        let (mut waits, mut disturbs) = (vec![0; groups.len()], vec![0; groups.len()]);
        for (of, all) in between.iter().enumerate() {
            for (other, between) in all.iter().enumerate().filter(|(other, _)| *other != of) {
                waits[other] += usize::from(between.is_before);
                disturbs[of] += between.disturbs;
            }
        }
        let (mut left, mut ordered) = ((0..groups.len()).list(), Vec::with_capacity(groups.len()));
        while !left.is_empty() {
            let free = left.iter().enumerate().filter(|(_, of)| waits[**of] == 0);
            let (at, _) = free.min_by_key(|(_, of)| disturbs[**of])?;
            let next = left.remove(at);
            for other in &left {
                waits[*other] -= usize::from(between[next][*other].is_before);
                disturbs[*other] -= between[*other][next].disturbs;
            }
            ordered.push(Group { region: groups[next].region, members: std::mem::take(&mut groups[next].members) });
        }
        Some(ordered)
    }

    /// By transition: those that have to stand in front of it, as it says last what becomes of a region.
    fn in_front(self) -> Vec<Set<usize>> {
        let mut writers = vec![Vec::new(); self.several.states.len()];
        for (at, clearing) in self.clearings.iter().enumerate() {
            for (region, ..) in &clearing.writes {
                writers[*region].push(at);
            }
        }
        let mut in_front = vec![Set::new(); self.clearings.len()];
        for (first, second) in
            writers.iter().flat_map(|of| of.iter().flat_map(|one| of.iter().map(|other| (*one, *other))))
        {
            if self.clearings[first].yields_to(&self.clearings[second], self.several) {
                in_front[second].insert(first);
            }
        }
        in_front
    }

    /// By group, and by another one: what there is between them.
    fn between(self, groups: &[Group], in_front: &[Set<usize>]) -> Vec<Vec<Between>> {
        let mut group_of = vec![0; self.clearings.len()];
        for (at, group) in groups.iter().enumerate() {
            for member in &group.members {
                group_of[*member] = at;
            }
        }
        let mut tests = vec![Vec::new(); self.several.states.len()];
        for (at, clearing) in self.clearings.iter().enumerate() {
            for (region, steps) in &clearing.tests {
                tests[*region].push((at, steps));
            }
        }
        let mut between = vec![vec![Between::default(); groups.len()]; groups.len()];
        for (at, clearing) in self.clearings.iter().enumerate() {
            for first in &*in_front[at] {
                between[group_of[*first]][group_of[at]].is_before = true;
            }
            for (region, ..) in &clearing.writes {
                for (other, steps) in &tests[*region] {
                    between[group_of[at]][group_of[*other]].disturbs += usize::from(!clearing.keeps(*region, steps));
                }
            }
        }
        between
    }

    /// Each transition with those that ask for the same region, that of its own for which the most do.
    fn by_region(self) -> Vec<Group> {
        let mut count = vec![0_usize; self.several.states.len()];
        for (region, _) in self.clearings.iter().flat_map(|clearing| &clearing.tests) {
            count[*region] += 1;
        }
        let mut groups: Vec<Group> = Vec::new();
        for (at, clearing) in self.clearings.iter().enumerate() {
            let mut region = None;
            for (other, _) in &clearing.tests {
                if region.is_none_or(|best: usize| count[*other] > count[best]) {
                    region = Some(*other);
                }
            }
            match groups.iter_mut().find(|group| region.is_some() && group.region == region) {
                Some(group) => group.members.push(at),
                None => groups.push(Group { region, members: vec![at] }),
            }
        }
        groups
    }
}

/// Members of one group in an order that is possible.
fn sorted(members: &[usize], in_front: &[Set<usize>]) -> Option<Vec<usize>> {
    let mut left = members.to_vec();
    let mut sorted = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let is_free = |at: &usize| !left.iter().any(|other| other != at && in_front[*at].contains(other));
        let next = left.iter().position(is_free)?;
        sorted.push(left.remove(next));
    }
    Some(sorted)
}

/// Writes one group after the other.
pub(super) struct Writer<'c, 's, 'p, 'm> {
    pub(super) groups: Groups<'c, 's, 'p, 'm>,
    pub(super) told: &'c [Told],
    /// The regions of which a copy may be made of the state before, and those of which one is wanted.
    pub(super) free: &'c Set<usize>,
    pub(super) copies: Set<usize>,
    /// The transitions that have been written.
    pub(super) done: Vec<usize>,
}

impl<'m> Writer<'_, '_, '_, 'm> {
    pub(super) fn group(&mut self, group: &Group) -> Option<Vec<Statement<'m>>> {
        let Some(region) = group.region else {
            let statements = self.those(&group.members, None);
            self.done.extend(&group.members);
            return statements;
        };
        let several = self.groups.several;
        let mut arms = Vec::new();
        let mut asked = Vec::new();
        for step in several.possible(region) {
            let Some(known) = step else { continue };
            let has = |at: &usize| self.groups.clearings[*at].test(region).is_some_and(|steps| steps.contains(&known));
            let members: Vec<usize> = group.members.iter().copied().filter(has).collect();
            if !members.is_empty() {
                asked.push(known);
                arms.push((vec![Value::Step(step)], self.those(&members, Some((region, known)))?));
            }
        }
        let place = self.dispatch(region, &group.members, &asked)?;
        self.done.extend(&group.members);
        let ([(_, body)], [step]) = (&mut arms[..], &asked[..]) else {
            return Some(vec![Statement::Match(place, merged(arms), Vec::new())]);
        };
        let (is_there, mut body) = (Expr::Is(place, vec![*step]), std::mem::take(body));
        Some(vec![match body.pop() {
            Some(Statement::If(condition, then, otherwise)) if body.is_empty() && otherwise.is_empty() => {
                Statement::If(all(vec![is_there, condition]), then, otherwise)
            }
            last => {
                body.extend(last);
                Statement::If(is_there, body, Vec::new())
            }
        }])
    }

    /// Some transitions of one group, where a region is in a state: one after the other.
    fn those(&mut self, members: &[usize], known: Option<(usize, StepId)>) -> Option<Vec<Statement<'m>>> {
        let (mut statements, mut chain) = (Vec::new(), Vec::new());
        let before = self.done.len();
        for at in members {
            let clearing = &self.groups.clearings[*at];
            if clearing.is_kept {
                chain.clear();
                statements.push(Statement::If(Expr::Place(clearing.truth), self.body(*at), Vec::new()));
                self.done.push(*at);
                continue;
            }
            let is_known = |part: &Expr<'m>| match (part, known) {
                (Expr::Is(place, steps), Some((region, step))) => {
                    self.groups.several.region_of(*place) == Some(region) && steps.contains(&step)
                }
                _ => false,
            };
            let (mut asks, mut denies) = (Vec::with_capacity(clearing.asks.len()), Set::new());
            for part in clearing.asks.iter().filter(|part| !is_known(part)) {
                match denied(part, self.groups.clearings, self.groups.asking) {
                    Some(other) if members.contains(&other) => _ = denies.insert(other),
                    Some(other) if self.groups.clearings[other].needs_other_steps(clearing, self.groups.several) => {}
                    Some(other) if known.is_some_and(|known| self.groups.clearings[other].is_elsewhere(known)) => {}
                    Some(_) => return None,
                    None => asks.push(part),
                }
            }
            let mut parts = Vec::with_capacity(asks.len());
            for part in asks {
                parts.push(self.asked(&self.in_state(part, known))?);
            }
            let body = self.body(*at);
            match all(parts) {
                // Nothing else clears where this is denied.
                Expr::Value(Value::Bool(true)) if denies.is_empty() => {
                    chain.clear();
                    statements.extend(body);
                }
                Expr::Value(Value::Bool(false)) => {}
                condition => either(&mut statements, (&mut chain, &denies), (*at, condition, body))?,
            }
            self.done.push(*at);
        }
        self.done.truncate(before);
        Some(statements)
    }

    /// A condition where the state of a region before is known.
    fn in_state(&self, part: &Expr<'m>, known: Option<(usize, StepId)>) -> Expr<'m> {
        let Some((region, step)) = known else { return part.clone() };
        let several = self.groups.several;
        let value = |place: PlaceId| (several.region_of(place) == Some(region)).then_some(Value::Step(Some(step)));
        Known { places: several.places, value: &value, copy: &|_| None, among: &|_| None, now: &|_| false }.fold(part)
    }

    /// What a transition does that clears.
    fn body(&self, at: usize) -> Vec<Statement<'m>> {
        let clearing = &self.groups.clearings[at];
        let (mut body, mut set) = (Vec::new(), Set::new());
        for Told { truth, by, .. } in self.told {
            if by.as_ref().is_none_or(|by| by.contains(&at)) && set.insert(*truth) {
                body.push(Statement::Set(*truth, yes()));
            }
        }
        for (region, _, step) in &clearing.writes {
            let stays = clearing.test(*region).is_some_and(|own| step.is_some_and(|step| own == [step]));
            let may_leave = |other: &Clearing<'_>| {
                other.write(*region).is_some_and(|(_, to)| to != *step)
                    && !other.excludes(clearing, self.groups.several)
            };
            if stays && !self.groups.clearings.iter().any(may_leave) {
                continue;
            }
            body.push(Statement::Set(self.groups.several.states[*region], Expr::Value(Value::Step(*step))));
        }
        body
    }

    /// The place by which a group knows in which of these states its region was.
    fn dispatch(&mut self, region: usize, members: &[usize], steps: &[StepId]) -> Option<PlaceId> {
        let several = self.groups.several;
        let mut place = several.states[region];
        for part in members.iter().flat_map(|at| &self.groups.clearings[*at].asks) {
            match part {
                Expr::Is(asked, _) if several.was[region] == Some(*asked) => place = *asked,
                _ => {}
            }
        }
        let is_kept = place != several.states[region] || steps.iter().all(|step| self.is_kept(region, &[*step]));
        if is_kept { Some(place) } else { self.copy(region) }
    }

    /// A condition as it was before anything has cleared.
    fn asked(&mut self, part: &Expr<'m>) -> Option<Expr<'m>> {
        let several = self.groups.several;
        let disturbed = RefCell::new(Set::new());
        let before = |place: &PlaceId, is_kept: &dyn Fn(usize) -> bool| {
            let region = several.states.iter().position(|state| state == place)?;
            if is_kept(region) {
                return None;
            }
            disturbed.borrow_mut().insert(region);
            several.was[region]
        };
        let is_unwritten =
            |region: usize| self.done.iter().all(|at| self.groups.clearings[*at].write(region).is_none());
        let leaf = |expr: &Expr<'m>| match expr {
            Expr::Is(place, steps) => {
                Some(Expr::Is(before(place, &|region| self.is_kept(region, steps))?, steps.clone()))
            }
            Expr::Place(place) => Some(Expr::Place(before(place, &is_unwritten)?)),
            _ => None,
        };
        let asked = replaced(part, &leaf);
        for region in &*disturbed.into_inner() {
            self.copy(*region)?;
        }
        Some(asked)
    }

    /// Whether it is still as true as before that a region is in one of these states.
    fn is_kept(&self, region: usize, steps: &[StepId]) -> bool {
        self.done.iter().all(|at| self.groups.clearings[*at].keeps(region, steps))
    }

    fn copy(&mut self, region: usize) -> Option<PlaceId> {
        self.copies.insert(region);
        self.groups.several.was[region].filter(|_| self.free.contains(&region))
    }
}

/// One more transition: where those of the `chain` before it, each asked where the one in front of it does not clear, say the opposite, or are denied, it is asked if they do
/// not clear. None if it denies others than those.
fn either<'m>(
    statements: &mut Vec<Statement<'m>>,
    (chain, denies): (&mut Vec<usize>, &Set<usize>),
    (at, condition, body): (usize, Expr<'m>, Vec<Statement<'m>>),
) -> Option<()> {
    let (mut block, mut depth) = (statements, 0);
    while let Some(first) = chain.get(depth) {
        let Some(Statement::If(other, _, _)) = block.last() else { return None };
        if !denies.contains(first) && !disjoint(other, &condition) {
            break;
        }
        let Some(Statement::If(_, _, otherwise)) = block.last_mut() else { return None };
        (block, depth) = (otherwise, depth + 1);
    }
    if !denies.iter().all(|other| chain[..depth].contains(other)) {
        return None;
    }
    chain.truncate(depth);
    chain.push(at);
    match condition {
        Expr::Value(_) => {
            chain.clear();
            block.extend(body);
        }
        condition => block.push(Statement::If(condition, body, Vec::new())),
    }
    Some(())
}

/// Whether two conditions never hold together, by what each of them lists.
fn disjoint(a: &Expr<'_>, b: &Expr<'_>) -> bool {
    let (of_a, of_b) = (parts(a), parts(b));
    let is_denied = |other: &Expr<'_>| excludes(a, other) || of_a.iter().any(|one| excludes(one, other));
    of_b.iter().any(is_denied) || of_a.iter().any(|one| excludes(one, b))
}
