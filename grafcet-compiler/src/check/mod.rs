//! The rules: each pass looks at the model and the facts about it, and reports.

mod continuous;
mod drawing;
mod modes;
mod not_yet;
mod race;
mod structure;
mod targets;
mod unstable;

pub use not_yet::not_yet;

use crate::analysis::Concurrency;
use crate::diagnostic::Sink;
use crate::model::Model;

/// The rules that need no more than the drawing itself; they hold on a chart with unresolved parts too.
pub fn drawing(model: &Model, sink: &mut Sink) {
    drawing::check(model, sink);
    targets::check(model, sink);
}

/// The rules that look at the chart as a whole; only for charts whose drawing is in order.
pub fn whole(model: &Model, sink: &mut Sink) {
    modes::check(model, sink);
    structure::check(model, sink);
    if model.is_grafcet() {
        let concurrency = Concurrency::of(model);
        continuous::check(model, sink);
        structure::two_masters(model, &concurrency, sink);
        race::check(model, &concurrency, sink);
        unstable::check(model, sink);
    }
}
