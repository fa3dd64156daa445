//! How a chart that uses time knows whether its last cycle left something to the next one that needs neither an input nor time:
//! what `next_deadline` calls "at once".

use super::{Drive, Evolution, Memory};
use crate::analysis::edges_only_help;
use crate::model::Model;

/// What the plan already says of the chart.
pub(super) struct Known<'p> {
    pub(super) memory: &'p Memory,
    pub(super) evolution: &'p Evolution,
    pub(super) drives: &'p [Drive],
    pub(super) may_be_unstable: bool,
}

/// Whether a flag remembers it, which is taken away wherever something happens; otherwise no cycle leaves anything, or the chart has no times.
pub(super) fn has_flag(model: &Model, plan: &Known<'_>) -> bool {
    // A forced cycle clears nothing, whatever the conditions say. An `sfc` evolves once a cycle.
    if !plan.memory.time || model.forceable || !model.is_grafcet() {
        return plan.memory.time;
    }
    // A search goes on until nothing more happens.
    let read = plan.drives.iter().any(|drive| drive.read) || !plan.memory.last.is_empty();
    let acts = !model.delays.is_empty() || !model.actions.is_empty() || read;
    plan.may_be_unstable || acts || edges_stir(model, plan)
}

/// Whether the next cycle may do something because an edge is gone. What the last evolution of a search has seen is otherwise what the
/// next cycle begins with. An evolution that clears something is stable all the same where what it leaves is entered at once.
fn edges_stir(model: &Model, plan: &Known<'_>) -> bool {
    let edges = &plan.memory.edges;
    let still = edges.iter().all(|(id, ..)| plan.memory.still_edges.contains(id));
    let moves = plan.evolution.entered_last.is_empty();
    !(edges.is_empty() || still && moves && edges_only_help(model))
}
