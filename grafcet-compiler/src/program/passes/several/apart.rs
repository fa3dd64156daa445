//! The actions apart from the evolution: what is done in a state is looked up once the evolution is over, not at the end of each way to it.
//!
//! ```text
//! match state.A                            match state.A
//!   Fill:                                    Fill:
//!     if full:                                 if full: state.A = Heat
//!       state.A = Heat                       …
//!       heater = true            ->        fence
//!     else: valve = true                   match state.A
//!   …                                        Fill: valve = true
//!                                            Heat: heater = true
//! ```
//!
//! What asks how a step was entered or left stays on the way, as what is done once. Where many actions are more than that (stored ones, and calls), all of them stand apart, and the ways
//! tell them what they have entered and left ([`Actions::AllApart`]).
//!
//! That is shorter where many ways lead to the same states, and takes a second match on each region that acts. Both cycles go through the passes that come
//! after, and this one stays if it is shorter by a tenth (`passes::optimise`).

use super::{Env, Several, evolve};
use crate::list::List;
use crate::program::build::no;
use crate::program::passes::edits::rename;
use crate::program::passes::uses::{Effects, reads_from};
use crate::program::{Expr, Fence, PlaceId, Program, Role, Statement, Value};
use crate::sorted::Set;

use super::super::engine::Fact;
use super::super::parts::gathers;

/// Where the actions of a cycle stand.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Actions {
    /// At the ends of the ways.
    OnTheirWays,
    /// After the evolution, but for those that ask how it went.
    Apart,
    /// All of them.
    AllApart,
}

/// The same program with its actions apart.
pub(in super::super) fn pass<'m>(program: &Program<'m>, actions: Actions) -> Option<Program<'m>> {
    let mut other = program.clone();
    evolve(&mut other, actions).then_some(other)
}

impl<'m> Several<'_, 'm> {
    /// What evolves, with all that asks how it has, and the actions.
    #[allow(clippy::type_complexity, reason = "two lists")]
    pub(super) fn apart(
        &self,
        list: &[Statement<'m>],
        env: &Env,
        (actions, was_first): (Actions, PlaceId),
    ) -> Option<(Vec<Statement<'m>>, Vec<Statement<'m>>)> {
        let (body, _) = self.folded(list, env);
        let body = self.swept(body, env);
        let end = body.iter().rposition(|one| self.decides(std::slice::from_ref(one)))?;
        let effects = body.iter().map(Effects::of).list();
        let mut evolves = vec![false; body.len()];
        let mut told: Set<PlaceId> = Set::new();
        for (at, effects) in effects.iter().enumerate() {
            // Whether the next cycle would do the same is asked once, of outputs, too.
            let is_settled =
                matches!(&body[at], Statement::Set(place, _) if self.places[place.0].role == Role::Settled);
            let gathered = gathers(&body[at]);
            let is_asked = |place: &&PlaceId| told.contains(*place) && gathered != Some(**place);
            let asks = actions == Actions::Apart && !is_settled && effects.reads.iter().any(|place| is_asked(&place));
            if at <= end || asks {
                evolves[at] = true;
                let is_told = |place: &&PlaceId| !self.places[place.0].is_field && !self.states.contains(place);
                told.extend(effects.writes.iter().filter(is_told).copied());
            }
        }
        // What may not be passed by a later one evolves, too.
        let mut later = Effects::default();
        for (at, effects) in effects.iter().enumerate().skip(end + 1).rev() {
            evolves[at] |= !effects.may_swap(&later);
            if evolves[at] {
                later.join(effects);
            }
        }
        let (mut evolving, mut acting) = (Vec::new(), Vec::new());
        for (one, evolves) in body.into_iter().zip(evolves) {
            if evolves { evolving.push(one) } else { acting.push(one) }
        }
        // By then the first cycle is none any more.
        if acting.iter().any(|one| reads_from(one, self.first)) {
            rename(&mut acting, self.first, was_first);
            evolving.insert(0, Statement::Set(was_first, Expr::Place(self.first)));
        }
        evolving.push(Statement::Set(self.first, no()));
        (!acting.is_empty()).then_some((evolving, acting))
    }

    /// The actions in all situations.
    pub(super) fn acting(&self, evolving: &[Statement<'m>], actions: &[Statement<'m>]) -> Vec<Statement<'m>> {
        if actions.is_empty() {
            return Vec::new();
        }
        let mut env = Env::of(self.places);
        for place in &*Effects::of_all(evolving).writes {
            env.facts[place.0] = Fact::Nothing;
        }
        env.facts[self.first.0] = Fact::Is(Value::Bool(false));
        self.any_situation(&mut env);
        let mut done = vec![Statement::Fence(Fence::Memory)];
        done.extend(self.spec(actions, &env));
        done
    }
}
