//! The rules: each pass looks at the model and the facts about it, and reports.

mod drawing;
mod not_yet;
mod targets;

pub use not_yet::not_yet;

use crate::diagnostic::Sink;
use crate::model::Model;

/// The rules that need no more than the drawing itself; they hold on a chart with unresolved parts too.
pub fn drawing(model: &Model, sink: &mut Sink) {
    drawing::check(model, sink);
    targets::check(model, sink);
}
