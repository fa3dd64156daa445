//! What ends of ways would do in several ways, each of them long, is done in one that knows what all of them know.
//!
//! ```text
//! match state.Mode                                       match state.Mode
//!   Auto: match state.Loader                               Auto: goes = true
//!     Idle: if part: state.Loader = Pick                   Ending: goes = true
//!     Pick: …                                              …
//!   Ending: match state.Loader                 ->        if goes: match state.Loader
//!     Pick: …                                              Idle: if part && was.state.Mode is Auto: state.Loader = Pick
//!   …                                                      Pick: …
//! ```

use super::super::engine::Fact;
use super::super::parts::Part;
use super::super::several::weight;
use super::super::uses::{Effects, same_block};
use super::after::Unit;
use super::turn::Turn;
use crate::list::List;
use crate::program::{PlaceId, Statement};
use crate::sorted::Map;

/// One of so many statements less there has to be.
const MUCH: usize = 4;

impl<'m> Turn<'_, '_, 'm> {
    /// What ends would do with a part in several long ways is done in one that knows what all of them know, if that is much shorter.
    pub(super) fn alike(&self, ends: &mut [Vec<Unit<'m>>]) {
        let mut by_part: Map<usize, Vec<(usize, usize)>> = Map::new();
        for (end, units) in ends.iter().enumerate() {
            for (unit, one) in units.iter().enumerate().filter(|(_, one)| one.known.is_some()) {
                by_part.or_default(one.at).push((end, unit));
            }
        }
        for (at, found) in &by_part {
            if let Some(statements) = self.for_all(*at, &found.iter().map(|(end, unit)| &ends[*end][*unit]).list()) {
                for (end, unit) in found {
                    ends[*end][*unit].statements.clone_from(&statements);
                }
            }
        }
    }

    fn for_all(&self, at: usize, units: &[&Unit<'m>]) -> Option<Vec<Statement<'m>>> {
        let mut ways: Vec<&Unit<'m>> = Vec::new();
        for unit in units {
            if !ways.iter().any(|other| same_block(&other.statements, &unit.statements)) {
                ways.push(*unit);
            }
        }
        let mut all = ways.first()?.known.clone()?;
        let mut less = Vec::new();
        for unit in units {
            less.extend(all.join(unit.known.as_ref()?));
        }
        if ways.len() < 2 {
            return None;
        }
        // A region that has moved tells nothing of those that have not: which states it has one of is used up before these are looked at.
        let (list, _) = self.several.folded(&self.parts[at].statements, &all);
        for place in less {
            all.facts[place.0] = Fact::Nothing;
        }
        let part = Part { statements: list, regions: self.parts[at].regions.clone() };
        let statements = self.part_of(&part, &self.written[at], &all)?;
        let length: usize = ways.iter().map(|unit| weight(&unit.statements)).sum();
        // A local that a way does not ask for may be left from the evolution before.
        let asked = Effects::of_all(&statements).reads;
        let asks = |unit: &&Unit<'m>, place: PlaceId| Effects::of_all(&unit.statements).reads.contains(&place);
        let is_known = |place: &PlaceId| self.is_kept(*place) || ways.iter().all(|unit| asks(unit, *place));
        (MUCH * weight(&statements) < length * (MUCH - 1) && asked.iter().all(is_known)).then_some(statements)
    }
}
