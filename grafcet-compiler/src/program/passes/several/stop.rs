//! A condition of the inputs that decides about several regions, as that of an `any` which leaves parallel branches: it is asked first.

use super::super::belonging::Deciding;
use super::super::parts::Looked;
use super::super::uses::{each_read, is_pure, may_panic, same};
use super::{Env, Several, weight};
use crate::program::{Expr, PlaceId, Statement, Type};

/// Up to so many statements what an edge asks is tried, too: beyond that it made charts longer, and took most of the macro's time.
const SHORT: usize = 400;

/// What a condition asks that looks at no region, and what it asks of them beside that.
struct Stop<'m> {
    asked: Vec<Expr<'m>>,
    left: Vec<Expr<'m>>,
}

impl<'m> Several<'_, 'm> {
    /// What such a condition decides, first.
    pub(super) fn by_stop(&self, looked: &Looked<'m>, env: &Env) -> Option<Vec<Statement<'m>>> {
        if self.effort.get() == 0 {
            return None;
        }
        let deciding = Deciding::of(self.places, looked);
        let is_short = weight(&looked.list) <= SHORT;
        let decides = |place: PlaceId| {
            let info = &self.places[place.0];
            // What an edge compares with in the next cycle is stored whatever it is.
            let is_kept = |one: &Statement<'m>| matches!(one, Statement::Set(_, Expr::Place(of)) if *of == place);
            !info.is_field
                && matches!(info.ty, Type::Bool)
                && deciding.about(place).len() > 1
                && (is_short || !looked.list.iter().any(is_kept))
        };
        let (at, place, Stop { asked, left }) = looked.list.iter().enumerate().find_map(|(at, one)| match one {
            Statement::Set(place, value) if decides(*place) => {
                let stop = self.stop(value)?;
                let asks = stop.left.is_empty() || self.tries_stops.get() && Self::is_for_many(&stop, looked);
                asks.then_some((at, *place, stop))
            }
            _ => None,
        })?;
        let mut list = looked.list.clone();
        list[at] = Statement::Set(place, Expr::All(asked));
        let left = (!left.is_empty()).then_some(Expr::All(left));
        self.asked_before(list, (at, left.as_ref()), &[], env)
    }

    fn stop(&self, condition: &Expr<'m>) -> Option<Stop<'m>> {
        let (mut asked, mut left) = (Vec::new(), Vec::new());
        for part in super::clearing::parts(condition) {
            let mut looks = false;
            each_read(part, &mut |read| looks |= self.is_state(read) || !self.places[read.0].is_field);
            if !is_pure(part) {
                return None;
            }
            // What stands in front of it may be there so that it does not panic.
            let stays = looks || !left.is_empty() && may_panic(part);
            if stays { left.push(part.clone()) } else { asked.push(part.clone()) }
        }
        (!asked.is_empty()).then_some(Stop { asked, left })
    }

    /// Whether it is for many steps: what else it asks holds in many, or most conditions ask for the same, or that it does not hold. A divergence or a convergence is for
    /// one.
    fn is_for_many(Stop { asked, left }: &Stop<'m>, looked: &Looked<'m>) -> bool {
        let is_wide = |part: &Expr<'m>| match part {
            Expr::Is(_, steps) => steps.len() > 1,
            Expr::Not(inner) => matches!(**inner, Expr::Is(..)),
            Expr::Any(_) => true,
            _ => false,
        };
        let is_asked = |part: &Expr<'m>| match part {
            Expr::Not(inner) => same(inner, &asked[0]),
            part => same(part, &asked[0]),
        };
        let (mut conditions, mut alike) = (0, 0);
        for one in &looked.list {
            if let Statement::Set(_, value @ Expr::All(parts)) = one {
                conditions += usize::from(is_pure(value));
                alike += usize::from(parts.iter().any(is_asked));
            }
        }
        left.iter().all(is_wide) || 2 * alike > conditions
    }

    /// It holds the state of a region, or what that was before.
    fn is_state(&self, place: PlaceId) -> bool {
        self.states.contains(&place) || self.was.contains(&Some(place))
    }
}
