//! What a chart is from outside: which steps share a state, and the program that its cycle is printed from. No tokens yet.

use crate::analysis::Facts;
use crate::list::List;
use crate::model::{Model, StepId, VarId};
use crate::program::{self, Program, Refused, Regions};
use crate::sorted::Set;

/// The plan for one chart.
pub(crate) struct Plan<'m> {
    /// Which steps share a state.
    pub(crate) regions: Regions,
    /// The situation is one step: the chart has no parallel branches and never stands without an active step.
    pub(crate) one_step: bool,
    /// The active steps of the initial situation.
    pub(crate) initial: Set<StepId>,
    /// The variables that outlive a cycle: a combinational one follows from the situation.
    pub(crate) vars: Vec<VarId>,
    /// What its cycle is printed from.
    pub(crate) program: Result<Program<'m>, Refused>,
}

impl<'m> Plan<'m> {
    /// Plans a chart that has passed all checks. One that is `recorded` keeps the reading of the clock.
    #[must_use]
    pub(crate) fn of(model: &'m Model, facts: &Facts<'_>, recorded: bool) -> Self {
        let regions = Regions::of(model, &facts.concurrency, &facts.initial);
        let program = program::optimised(model, facts, &regions, recorded);
        let combinational = facts.combinational(model);
        Self {
            one_step: regions.is_single(),
            regions,
            initial: facts.initial.clone(),
            vars: model.vars.ids().filter(|id| !combinational.contains(id)).list(),
            program,
        }
    }
}
