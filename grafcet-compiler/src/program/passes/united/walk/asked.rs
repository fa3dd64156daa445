//! What asks for the states of several regions, asked of the one place that tells them.

use super::super::super::super::build::{any, compare, not, yes};
use super::super::super::super::{Comparison, Expr, PlaceId, Value};
use super::super::super::edits::replaced;
use super::super::super::fold::Known;
use super::super::super::uses::each_read;
use super::super::Joint;
use super::{JointWalk, Point};
use crate::model::StepId;
use crate::sorted::Set;

impl<'m> JointWalk<'_, 'm> {
    /// An expression that asks the one place, where the states are some of these.
    pub(in super::super) fn expr(&self, expr: &Expr<'m>, now: &Set<Point>) -> Expr<'m> {
        let mut asks = false;
        each_read(expr, &mut |place| asks |= self.side(place).or(self.group.copy(place)).is_some());
        let Some(first) = now.first().filter(|_| asks) else { return expr.clone() };
        let new = replaced(expr, &|part| {
            if self.told(part, &first.joint).is_some() {
                return Some(self.asked(&|joint| self.told(part, joint) == Some(true), now));
            }
            match part {
                Expr::Is(place, steps) => self.group.copy(*place).map(|side| self.copied(*place, side, steps)),
                Expr::Place(place) | Expr::Table(place, _) | Expr::Next(place) => {
                    if self.side(*place).or(self.group.copy(*place)).is_some() {
                        self.fail();
                    }
                    None
                }
                _ => None,
            }
        });
        Known { places: &self.program.places, value: &|_| None, copy: &|_| None, among: &|_| None, now: &|_| false }
            .fold(&new)
    }

    /// Whether a copy of the state of one region, taken before, is one of these.
    fn copied(&self, place: PlaceId, side: usize, steps: &[StepId]) -> Expr<'m> {
        let mut states = Vec::new();
        for (joint, name) in self.names.into_iter().flatten() {
            if let (Value::Step(Some(step)), Value::Step(Some(name))) = (joint[side], name) {
                if steps.contains(&step) {
                    states.push(*name);
                }
            }
        }
        Expr::Is(place, states)
    }

    /// Whether the state is one of those.
    fn asked(&self, which: &dyn Fn(&Joint) -> bool, now: &Set<Point>) -> Expr<'m> {
        let (mut inside, mut outside) = (Set::new(), Set::new());
        for point in now {
            let names = if which(&point.joint) { &mut inside } else { &mut outside };
            names.insert(self.name(&point.joint));
        }
        if outside.is_empty() {
            return yes();
        }
        if outside.len() < inside.len() { not(self.is(&outside)) } else { self.is(&inside) }
    }

    fn is(&self, names: &Set<Value>) -> Expr<'m> {
        let place = self.group.places[0];
        let (mut steps, mut parts) = (Vec::new(), Vec::new());
        for name in names {
            match name {
                Value::Step(Some(step)) => steps.push(*step),
                other => parts.push(compare(Comparison::Equal, Expr::Place(place), Expr::Value(*other))),
            }
        }
        if !steps.is_empty() {
            parts.push(Expr::Is(place, steps));
        }
        any(parts)
    }
}
