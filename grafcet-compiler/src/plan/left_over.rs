//! How a chart that uses time knows whether its last cycle left something to the next one that needs neither an input nor time:
//! what `next_deadline` calls "at once".

use super::{Drive, Evolution, Memory, Shape};
use crate::analysis::edges_only_help;
use crate::model::Model;

/// What is remembered of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LeftOver {
    /// Nothing: no cycle leaves anything, or the chart has no times.
    Nothing,
    /// The state the last cycle began with: it has moved where that is another one.
    StateBefore,
    /// A flag, which is taken away wherever something happens.
    Flag,
}

/// What the plan already says of the chart.
pub(super) struct Known<'p> {
    pub(super) memory: &'p Memory,
    pub(super) shape: &'p Shape,
    pub(super) evolution: &'p Evolution,
    pub(super) drives: &'p [Drive],
    pub(super) may_be_unstable: bool,
}

impl LeftOver {
    pub(super) fn of(model: &Model, plan: &Known<'_>) -> Self {
        if !plan.memory.time {
            return Self::Nothing;
        }
        if model.forceable {
            // A forced cycle clears nothing, whatever the conditions say.
            return Self::Flag;
        }
        if !model.is_grafcet() {
            // One store in each cycle, and nothing on the ways on which a step is left.
            return if plan.shape.is_sequence() { Self::StateBefore } else { Self::Flag };
        }
        // A search goes on until nothing more happens.
        let read = plan.drives.iter().any(|drive| drive.read) || !plan.memory.last.is_empty();
        let acts = !model.delays.is_empty() || !model.actions.is_empty() || read;
        if plan.may_be_unstable || acts || edges_stir(model, plan) { Self::Flag } else { Self::Nothing }
    }
}

/// Whether the next cycle may do something because an edge is gone. What the last evolution of a search has seen is otherwise what the
/// next cycle begins with. An evolution that clears something is stable all the same where what it leaves is entered at once.
fn edges_stir(model: &Model, plan: &Known<'_>) -> bool {
    let edges = &plan.memory.edges;
    let still = edges.iter().all(|(id, ..)| plan.memory.still_edges.contains(id));
    let moves = plan.evolution.entered_last.is_empty();
    !(edges.is_empty() || still && moves && edges_only_help(model))
}
