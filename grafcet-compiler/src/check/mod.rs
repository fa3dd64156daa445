//! The rules: each pass looks at the model and the facts about it, and reports.

mod assumptions;
mod branches;
mod conditions;
mod contention;
mod continuous;
mod drawing;
mod events;
mod initial;
mod meeting;
mod modes;
mod properties;
mod race;
mod reach;
mod safety;
mod set_reset;
mod structure;
mod targets;
mod unstable;
mod usage;
mod waits;

pub use initial::initial_values;

use crate::analysis::explore::Limits;
use crate::analysis::{Concurrency, Logic};
use crate::diagnostic::Sink;
use crate::model::{Model, Tree};

/// The rules that need no more than the drawing itself; most hold on a chart with unresolved parts too.
pub fn drawing(model: &Model, sink: &mut Sink) {
    drawing::check(model, sink);
    targets::check(model, sink);
    modes::check(model, sink);
    if !model.incomplete {
        assumptions::check(model, sink);
    }
    if model.is_grafcet() && !model.incomplete {
        structure::check(model, sink);
        continuous::check(model, sink);
        events::check(model, sink);
    }
}

/// The rules that look at how the chart evolves; only for charts whose drawing is in order.
pub fn evolution(model: &Model, sink: &mut Sink) {
    let assumed: Vec<&Tree> = model.assumptions.iter().map(|assumption| &assumption.never.tree).collect();
    let never = &assumed[..];
    let concurrency = Concurrency::assuming(model, never);
    let logic = Logic::within(model, &concurrency, never);
    let limits = model.budget.map_or_else(Limits::default, Limits::situations);
    let exploration = properties::check(model, &logic, limits, never, sink);
    let conditions: Vec<_> = model.transitions.values().map(|t| logic.condition(&t.condition.tree)).collect();
    let mut said = conditions::check(model, &logic, &conditions, sink);
    said.extend(branches::check(model, &concurrency, &logic, &conditions, &said, sink));
    let mut dead = reach::check(model, &exploration, &said, sink);
    dead.extend(&said);
    safety::check(model, &exploration, sink);
    waits::check(model, &exploration, &dead, sink);
    race::check(model, &concurrency, never, sink);
    contention::check(model, &concurrency, never, sink);
    set_reset::check(model, &concurrency, sink);
    usage::check(model, sink);
    if model.is_grafcet() {
        structure::two_masters(model, &concurrency, sink);
        unstable::check(model, &concurrency, never, sink);
    }
}
