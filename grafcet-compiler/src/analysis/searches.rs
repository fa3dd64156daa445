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

pub(super) fn are_ended(model: &Model, stability: &Stability) -> bool {
    let Some(counted) = stability.counted() else { return false };
    // Where each transition clears at most once, the chart gives the search long enough.
    let is_long = |bound: u32| stability.is_at_once() && (bound as usize) >= model.transitions.len();
    model.max_evolutions.is_none_or(is_long) && (counted == 0 || counted + others(model) <= u64::from(bound(model)))
}

/// How many evolutions a search takes beside counted circles: each partial grafcet goes through its steps, after what only the first
/// evolution sees or only the step that is active at the beginning has waited for.
fn others(model: &Model) -> u64 {
    (model.steps.len() + model.partials.len() + 2) as u64
}

/// A30: what the chart states, or twice the number of steps plus two.
fn bound(model: &Model) -> u32 {
    let steps = u32::try_from(model.steps.len()).unwrap_or(u32::MAX);
    model.max_evolutions.unwrap_or_else(|| steps.saturating_mul(2).saturating_add(2))
}
