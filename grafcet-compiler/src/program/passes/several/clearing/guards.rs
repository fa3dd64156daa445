//! What the truths stand for by which states are written, and for which others ask.

use super::super::super::parts::gathers;
use super::super::super::uses::{Effects, is_pure, mentions};
use super::super::Several;
use crate::model::StepId;
use crate::program::{Expr, PlaceId, Statement, Type, Value};

/// A truth by which states are written: what it stands for.
pub(super) struct Guard {
    pub(super) truth: PlaceId,
    /// Where it is set, by one statement or more.
    pub(super) at: Vec<usize>,
    /// Others of which one holds then, if it stands for no condition of its own.
    pub(super) by: Option<Vec<PlaceId>>,
    /// Where a step is active that it makes active, it may hold or not.
    pub(super) but: Option<StepId>,
}

/// A list, by place which of its statements write it, and what is false in front of it.
pub(super) struct Truths<'t, 'm> {
    pub(super) list: &'t [Statement<'m>],
    pub(super) set_by: &'t [Vec<usize>],
    pub(super) is_off: &'t dyn Fn(PlaceId) -> bool,
}

impl Truths<'_, '_> {
    /// The others by which a truth holds that is put together by several statements, if somebody asks for it after them alone; and whether it holds by nothing else, as it was
    /// false before.
    pub(super) fn added(&self, truth: PlaceId) -> Option<(Vec<PlaceId>, bool)> {
        let writers = &self.set_by[truth.0];
        let (mut all, mut alone) = (Vec::new(), (self.is_off)(truth));
        for at in writers {
            let Statement::Set(_, value) = &self.list[*at] else { return None };
            match value {
                Expr::Any(parts) if gathers(&self.list[*at]).is_some() => {
                    for part in &parts[1..] {
                        all.extend(one_of(part)?);
                    }
                }
                // All that has been put into it before is gone.
                Expr::Value(Value::Bool(false)) if all.is_empty() => alone = true,
                value if all.is_empty() && !mentions(value, truth) => {
                    all.extend(one_of(value)?);
                    alone = true;
                }
                _ => return None,
            }
        }
        let asks = |at: &usize| !writers.contains(at) && Effects::of(&self.list[*at]).reads.contains(&truth);
        (!all.is_empty() && !(0..*writers.last()?).any(|at| asks(&at))).then_some((all, alone))
    }
}

/// The truths of which one holds where this holds, and the other way round.
pub(super) fn one_of(condition: &Expr<'_>) -> Option<Vec<PlaceId>> {
    let mut all = Vec::new();
    match condition {
        Expr::Place(place) => all.push(*place),
        Expr::Any(parts) => {
            for part in parts {
                let Expr::Place(place) = part else { return None };
                all.push(*place);
            }
        }
        _ => return None,
    }
    Some(all)
}

impl<'m> Several<'_, 'm> {
    /// What a truth stands for, of what is so before anything has cleared.
    pub(super) fn guard(&self, truth: PlaceId, truths: &Truths<'_, 'm>) -> Option<Guard> {
        let Truths { list, set_by, .. } = *truths;
        let info = &self.places[truth.0];
        let is_set = |truth: &PlaceId| {
            !self.places[truth.0].is_field && set_by[truth.0].iter().any(|at| matches!(list[*at], Statement::Set(..)))
        };
        if set_by[truth.0].is_empty() && !info.is_field && matches!(info.ty, Type::Bool) {
            return Some(Guard { truth, at: Vec::new(), by: None, but: None });
        }
        // To what has been put into it in front of these statements others may have added what is not looked at here.
        let [at] = set_by[truth.0][..] else {
            let (by, alone) = truths.added(truth)?;
            let is_known = alone && by.iter().all(is_set) && !info.is_field;
            return is_known.then(|| Guard { truth, at: set_by[truth.0].clone(), by: Some(by), but: None });
        };
        let Statement::Set(_, value) = &list[at] else { return None };
        if mentions(value, truth) || info.is_field || !matches!(info.ty, Type::Bool) || !is_pure(value) {
            return None;
        }
        let is_written = |state: PlaceId| set_by[state.0].first().is_some_and(|first| *first < at);
        if self.states.iter().any(|state| is_written(*state) && mentions(value, *state)) {
            return None;
        }
        if let Some(by) = one_of(value).filter(|by| by.iter().all(is_set)) {
            return Some(Guard { truth, at: vec![at], by: Some(by), but: None });
        }
        // What enters a step may ask whether it stays active.
        let entering = match value {
            Expr::All(parts) => match &parts[..] {
                [first, Expr::Not(stays)] => one_of(first).zip(self.stays(stays)),
                _ => None,
            },
            _ => None,
        };
        let entering = entering.filter(|(by, _)| by.iter().all(is_set));
        let (by, but) = entering.unzip();
        Some(Guard { truth, at: vec![at], by, but })
    }

    /// The step of which a condition says that it is active, and not left.
    fn stays(&self, condition: &Expr<'m>) -> Option<StepId> {
        let is = match condition {
            Expr::All(parts) => match &parts[..] {
                [is, Expr::Not(left)] => one_of(left).and(Some(is)),
                _ => None,
            },
            one => Some(one),
        };
        match is {
            Some(Expr::Is(place, steps)) if steps.len() == 1 => self.region_of(*place).and(steps.first().copied()),
            _ => None,
        }
    }
}
