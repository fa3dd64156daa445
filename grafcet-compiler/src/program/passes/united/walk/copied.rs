//! States that are copied and, where a bound stops a search, taken back: of several regions with one statement.

use super::super::super::super::{Expr, PlaceId, Statement};
use super::{JointWalk, Point};
use crate::sorted::Set;

/// A copy of the state of a region, and what the states of all were then.
pub(super) struct Copied {
    to: PlaceId,
    /// How often states had been written.
    writes: usize,
    /// How many blocks stood around it.
    pub(super) depth: usize,
    of: Set<Point>,
}

/// States that are taken back, as one statement in place of several.
pub(super) struct Back<'m> {
    pub(super) statement: Statement<'m>,
    pub(super) statements: usize,
    pub(super) now: Set<Point>,
}

impl<'m> JointWalk<'_, 'm> {
    pub(super) fn copy(&mut self, to: PlaceId, now: &Set<Point>) {
        self.forget(to);
        self.copied.push(Copied { to, writes: self.writes, depth: self.depth, of: now.clone() });
    }

    /// Something else is written there.
    pub(super) fn forget(&mut self, copy: PlaceId) {
        self.copied.retain(|copied| copied.to != copy);
    }

    /// Statements that make the states of all regions again what they were when all of them were copied.
    pub(super) fn taken_back(&self, statements: &[Statement<'m>]) -> Option<Back<'m>> {
        let mut sides = Set::new();
        let mut same: Option<&Copied> = None;
        for (at, statement) in statements.iter().enumerate() {
            let Statement::Set(place, Expr::Place(from)) = statement else { return None };
            let side = self.side(*place)?;
            let copied = self.copied.iter().find(|copied| copied.to == *from)?;
            if self.group.copy(*from) != Some(side) || same.is_some_and(|other| other.writes != copied.writes) {
                return None;
            }
            sides.insert(side);
            same = Some(copied);
            if sides.len() == self.group.places.len() {
                let statement = Statement::Set(self.group.places[0], Expr::Place(*from));
                return Some(Back { statement, statements: at + 1, now: copied.of.clone() });
            }
        }
        None
    }
}
