//! Somebody asks later on what has cleared: each transition says so where it clears, so that none has to be asked beforehand.
//!
//! ```text
//! entered.B = clears.A→B && !(state.S is B && !clears.B→C)      any = false
//! entered.C = clears.B→C                                        match state.S
//! any = any || entered.B                                          A:
//! any = any || entered.C                                  ->        if x:
//! …                                                                   any = true
//! if any: since.S = reading                                           state.S = B
//!                                                                 …
//!                                                               if any: since.S = reading
//! ```

use super::super::super::uses::each_asked;
use super::super::Several;
use super::guards::Truths;
use super::sorted::Kind;
use super::{Clearing, Told};
use crate::model::StepId;
use crate::program::{PlaceId, Statement, Type};
use crate::sorted::{Map, Set};

/// A list, what its statements have to do with the evolution, and what is known of its truths.
pub(super) struct Telling<'t, 'p, 'm> {
    pub(super) several: &'t Several<'p, 'm>,
    pub(super) clearings: &'t [Clearing<'m>],
    pub(super) truths: &'t Truths<'t, 'm>,
    /// What is read after the list.
    pub(super) is_read_after: &'t dyn Fn(PlaceId) -> bool,
    /// What conditions of transitions ask for is what it was before anything clears.
    pub(super) asked_before: Set<PlaceId>,
    /// By truth that has been looked at: by which transitions it becomes true.
    pub(super) by: Map<PlaceId, Option<By>>,
}

/// Transitions by which a truth becomes true.
#[derive(Clone)]
pub(super) struct By {
    these: Set<usize>,
    /// It was false before, so one of them clears where it holds.
    alone: bool,
}

impl<'m> Telling<'_, '_, 'm> {
    /// The truths that transitions tell, of those for which what has nothing to do with the evolution asks.
    pub(super) fn told(&mut self, kinds: &mut [Kind]) -> Vec<Told> {
        let list = self.truths.list;
        let (mut told, mut asked): (Vec<Told>, Set<PlaceId>) = (Vec::new(), Set::new());
        let mut set = Vec::with_capacity(list.len());
        for (statement, kind) in list.iter().zip(&*kinds) {
            let by = if matches!(kind, Kind::Other | Kind::Asks) { self.set_by_transitions(statement) } else { None };
            if by.is_none() && *kind == Kind::Other {
                each_asked(std::slice::from_ref(statement), &mut |place| _ = asked.insert(place));
            }
            set.push(by);
        }
        for (kind, by) in kinds.iter_mut().zip(set) {
            let Some((truth, By { these, alone })) = by else { continue };
            *kind = Kind::Asks;
            let is_asked = asked.contains(&truth) || (self.is_read_after)(truth);
            if is_asked && !self.asked_before.contains(&truth) && told.iter().all(|one| one.truth != truth) {
                told.push(Told { truth, by: Some(these), begins: alone });
            }
        }
        told
    }

    /// The truth that a statement sets, and by which transitions it becomes true, if by nothing else.
    fn set_by_transitions(&mut self, statement: &Statement<'m>) -> Option<(PlaceId, By)> {
        let Statement::Set(truth, _) = statement else { return None };
        self.find(*truth);
        Some((*truth, self.by.get(truth)?.clone()?))
    }

    /// The transitions of which one clears where a truth holds, and the other way round.
    fn known(&self, truth: PlaceId) -> Option<&Set<usize>> {
        self.by.get(&truth)?.as_ref().filter(|by| by.alone).map(|by| &by.these)
    }

    fn find(&mut self, truth: PlaceId) {
        if self.by.contains_key(&truth) {
            return;
        }
        // What asks for itself is not told.
        self.by.insert(truth, None);
        let found = self.found(truth);
        self.by.insert(truth, found);
    }

    fn found(&mut self, truth: PlaceId) -> Option<By> {
        if let Some(own) = self.clearings.iter().position(|one| one.truth == truth) {
            return Some(By { these: Set::from([own]), alone: true });
        }
        let Some(guard) = self.several.guard(truth, self.truths) else { return self.added(truth) };
        let these = self.all(&guard.by?)?;
        let is_left = |step: StepId| these.iter().all(|at| !self.may_be_active(&self.clearings[*at], step));
        guard.but.is_none_or(is_left).then_some(By { these, alone: true })
    }

    /// The transitions by which one of these truths holds.
    fn all(&mut self, truths: &[PlaceId]) -> Option<Set<usize>> {
        let mut all = Set::new();
        for truth in truths {
            self.find(*truth);
            all.extend(self.known(*truth)?.iter().copied());
        }
        Some(all)
    }

    /// The same of a truth that somebody asks for after all has been put into it.
    fn added(&mut self, truth: PlaceId) -> Option<By> {
        let info = &self.several.places[truth.0];
        if !matches!(info.ty, Type::Bool) || self.asked_before.contains(&truth) {
            return None;
        }
        let (by, alone) = self.truths.added(truth)?;
        Some(By { these: self.all(&by)?, alone })
    }

    /// Whether a step may be active where a transition clears.
    fn may_be_active(&self, clearing: &Clearing<'m>, step: StepId) -> bool {
        if let Some(steps) = self.several.region_with(step).and_then(|region| clearing.test(region)) {
            return steps.contains(&step);
        }
        let mut tests = clearing.tests.iter();
        tests.all(|(_, steps)| steps.iter().any(|one| self.several.may_meet(Some(*one), Some(step))))
    }
}
