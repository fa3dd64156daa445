//! Where a cycle in one state depends on what is not known, and the next state does not: both ways are followed, and after them is known
//! what they agree on.

use super::super::build::not;
use super::super::{Arm, Expr, PlaceId, Statement, Type};
use super::engine::{Engine, Fact};
use super::uses::is_pure;

impl<'m> Engine<'_, 'm> {
    pub(super) fn unknown(
        &mut self,
        condition: Expr<'m>,
        then: &[Statement<'m>],
        otherwise: &[Statement<'m>],
        out: &mut Vec<Statement<'m>>,
    ) {
        let mark = self.trail.len();
        let mut bodies = [Vec::new(), Vec::new()];
        let mut ends = [Vec::new(), Vec::new()];
        let ways = [(then, true), (otherwise, false)];
        for (way, (body, holds)) in ways.into_iter().enumerate() {
            let learned = self.learned.len();
            self.learn(&condition, holds);
            self.learned.truncate(learned);
            self.block(body, &mut bodies[way]);
            ends[way] = self.ends(mark);
        }
        self.meet(&ends, out);
        let [then, otherwise] = bodies;
        match (then.is_empty(), otherwise.is_empty()) {
            (true, true) if is_pure(&condition) => {}
            (true, false) => {
                out.push(Statement::If(not(condition), otherwise, then));
            }
            _ => out.push(Statement::If(condition, then, otherwise)),
        }
    }

    pub(super) fn unknown_arm(
        &mut self,
        place: PlaceId,
        arms: &[Arm<'m>],
        otherwise: &[Statement<'m>],
        out: &mut Vec<Statement<'m>>,
    ) {
        let mark = self.trail.len();
        let (mut left, mut ends) = (Vec::new(), Vec::new());
        for (values, body) in arms {
            let mut arm = Vec::new();
            if let ([value], false) = (&values[..], matches!(self.places[place.0].ty, Type::User(_))) {
                self.note(place, Fact::Is(*value));
            }
            self.block(body, &mut arm);
            ends.push(self.ends(mark));
            if !(arm.is_empty() && otherwise.is_empty()) {
                left.push((values.clone(), arm));
            }
        }
        let mut rest = Vec::new();
        self.block(otherwise, &mut rest);
        ends.push(self.ends(mark));
        self.meet(&ends, out);
        if !(left.is_empty() && rest.is_empty()) {
            out.push(Statement::Match(place, left, rest));
        }
    }

    /// What has changed since, which is taken back.
    fn ends(&mut self, mark: usize) -> Vec<(PlaceId, Fact)> {
        let mut ends: Vec<(PlaceId, Fact)> = Vec::new();
        for (place, _) in &self.trail[mark..] {
            if !ends.iter().any(|(other, _)| other == place) {
                ends.push((*place, self.env[place.0]));
            }
        }
        self.back(mark);
        ends
    }

    /// What all ways agree on.
    fn meet(&mut self, ends: &[Vec<(PlaceId, Fact)>], out: &mut Vec<Statement<'m>>) {
        for (place, _) in ends.iter().flatten() {
            self.hold(*place, out);
        }
        for (place, fact) in ends.iter().flatten() {
            let before = self.env[place.0];
            let agree = |end: &Vec<(PlaceId, Fact)>| {
                let found = end.iter().find(|(other, _)| other == place).map_or(before, |(_, fact)| *fact);
                found == *fact
            };
            let met = if ends.iter().all(agree) { *fact } else { Fact::Nothing };
            self.note(*place, met);
        }
    }
}
