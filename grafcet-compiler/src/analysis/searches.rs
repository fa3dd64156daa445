//! What is known of the searches for stability of a `grafcet` (A30): where they end, and after how many evolutions they are given up.

use super::{Ends, Facts, Stability, explore};
use crate::model::Model;

/// How many units of work it is worth to find out that the searches of a chart end, where its circles do not tell.
const WORK: u64 = 100_000;

/// Whether and where searches end.
#[derive(Default)]
pub struct Searches {
    /// A search may have no end, as far as the situation decides about that.
    pub may_go_on: bool,
    /// Where a search ends without another look.
    pub ends: Ends,
    /// After so many evolutions that changed something a search is given up.
    pub bound: u32,
    /// A search that has made as many evolutions as the bound says has come back to a situation, and goes on for ever.
    pub comes_back: bool,
}

impl Searches {
    pub(super) fn of(model: &Model, facts: &Facts<'_>) -> Self {
        let bound = bound(model);
        if !model.is_grafcet() {
            return Self { bound, ..Self::default() };
        }
        let open = !facts.all_end(model);
        Self {
            // Who forces a chart can bring situations and values together that no exploration has seen.
            may_go_on: open && (model.forceable || !explore::settles(model, facts, WORK)),
            comes_back: Stability::goes_on_after(model, &facts.concurrency, bound),
            ends: facts.stability(model).ends().clone(),
            bound,
        }
    }
}

/// Whether the circles of a chart tell that each search ends, and before its bound: somebody who knows nothing of that would stop it there.
pub(super) fn are_ended(model: &Model, stability: &Stability) -> bool {
    let bound = u64::from(bound(model));
    // Where each transition clears at most once, no search has more evolutions than there are transitions.
    let at_once = stability.is_at_once() && bound >= model.transitions.len() as u64;
    stability.is_certain() && (at_once || stability.longest().is_some_and(|longest| longest <= bound))
}

/// A30: what the chart states, or twice the number of steps plus two.
fn bound(model: &Model) -> u32 {
    let steps = u32::try_from(model.steps.len()).unwrap_or(u32::MAX);
    model.max_evolutions.unwrap_or_else(|| steps.saturating_mul(2).saturating_add(2))
}
