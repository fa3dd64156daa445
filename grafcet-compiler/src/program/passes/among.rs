//! What conditions tell of the states of regions: which of several it is, or which it is not.

use super::super::{Expr, PlaceId, Value};
use super::engine::{Among, Engine, Fact};

impl<'m> Engine<'_, 'm> {
    /// What a condition tells that holds, or does not, of the states of regions, too.
    pub(super) fn tell(&mut self, condition: &Expr<'m>, holds: bool) {
        self.learn(condition, holds);
        self.tell_states(condition, holds);
    }

    fn tell_states(&mut self, condition: &Expr<'m>, holds: bool) {
        match (condition, holds) {
            (Expr::Is(place, steps), _) => {
                let Fact::Among(list) = self.env[place.0] else { return };
                let mut left = self.lists[list].clone();
                left.retain(|state| state.is_some_and(|step| steps.contains(&step)) == holds);
                self.narrow(*place, left);
            }
            (Expr::Not(inner), _) => self.tell_states(inner, !holds),
            (Expr::All(parts), true) | (Expr::Any(parts), false) => {
                for part in parts {
                    self.tell_states(part, holds);
                }
            }
            _ => {}
        }
    }

    /// A state is one of these, as it turns out: what is a copy of it stays one.
    pub(super) fn narrow(&mut self, place: PlaceId, states: Among) {
        let fact = if let [state] = states[..] {
            Fact::Is(Value::Step(state))
        } else {
            self.lists.push(states);
            Fact::Among(self.lists.len() - 1)
        };
        self.trail.push((place, std::mem::replace(&mut self.env[place.0], fact)));
    }
}
