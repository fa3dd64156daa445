//! Until when nothing changes.

use super::{Expr, PlaceId};
use crate::model::StepId;

/// Until when nothing changes.
#[derive(Clone)]
pub struct Deadline<'m> {
    /// The next cycle is due at once.
    pub at_once: Expr<'m>,
    /// The reading of the last cycle, where that is so.
    pub reading: Expr<'m>,
    /// What may come. The soonest counts.
    pub waits: Vec<Wait<'m>>,
    /// Steps that have a time, and what tells after a cycle that it is over, where they are active.
    pub late: Vec<(StepId, Expr<'m>)>,
}

/// Something may change after a time.
#[derive(Clone)]
pub struct Wait<'m> {
    /// Where this holds.
    pub condition: Expr<'m>,
    /// The reading of the clock from which the time counts.
    pub from: PlaceId,
    pub time: Expr<'m>,
}

impl<'m> Deadline<'m> {
    /// What it asks, but for what tells that a step is late.
    pub(crate) fn asks(&self) -> impl Iterator<Item = &Expr<'m>> {
        [&self.at_once, &self.reading]
            .into_iter()
            .chain(self.waits.iter().flat_map(|wait| [&wait.condition, &wait.time]))
    }

    /// The same, to be changed.
    pub(crate) fn asks_mut(&mut self) -> impl Iterator<Item = &mut Expr<'m>> {
        let waits = self.waits.iter_mut().flat_map(|wait| [&mut wait.condition, &mut wait.time]);
        [&mut self.at_once, &mut self.reading].into_iter().chain(waits)
    }

    /// Whether all times count from one reading.
    pub(crate) fn has_one_clock(&self) -> bool {
        self.waits.windows(2).all(|two| two[0].from == two[1].from)
    }
}
